"""A film's title and alternative text, as each format of animations holds them."""

import zlib
from xml.sax.saxutils import escape

from app.frames import Film
from app.outputs.png import chunk

_BLOCK = 255
"""Bytes of a GIF's data block at most."""

_XMP = (
    '<x:xmpmeta xmlns:x="adobe:ns:meta/">'
    '<rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">'
    '<rdf:Description rdf:about="" xmlns:dc="http://purl.org/dc/elements/1.1/">'
    "{0}</rdf:Description></rdf:RDF></x:xmpmeta>"
)
_DC = '<dc:{0}><rdf:Alt><rdf:li xml:lang="x-default">{1}</rdf:li></rdf:Alt></dc:{0}>'


def named(film: Film, title: str, alt: str) -> dict[str, str]:
    """Title and alternative text under the names that a format has for them, if they are given."""
    return {name: text for name, text in ((title, film.title), (alt, film.alt)) if text}


def gif_comment(film: Film) -> bytes:
    """Both as one comment extension (GIF89a, section 24), in UTF-8; nothing if there are none."""
    words = "\n".join(named(film, "title", "alt").values()).encode()
    if not words:
        return b""
    blocks = (words[at : at + _BLOCK] for at in range(0, len(words), _BLOCK))
    return b"\x21\xfe" + b"".join(bytes((len(block),)) + block for block in blocks) + b"\0"


def png_texts(film: Film) -> bytes:
    """Each as an iTXt chunk (PNG specification, section 11.3.3.4), with its standard keyword."""
    return b"".join(
        chunk(b"iTXt", keyword.encode("ascii") + b"\0\1\0\0\0" + zlib.compress(text.encode()))
        for keyword, text in named(film, "Title", "Description").items()
    )


def xmp(film: Film) -> bytes:
    """Both as an XMP packet (ISO 16684-1) in UTF-8; nothing if there are none."""
    properties = (
        _DC.format(name, escape(text)) for name, text in named(film, "title", "description").items()
    )
    body = "".join(properties)
    return _XMP.format(body).encode() if body else b""
