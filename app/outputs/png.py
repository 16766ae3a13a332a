"""PNG: single pictures, and folders of frames of which only the changed bands are compressed."""

import struct
import zlib
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from app.frames import Film, Frame, Moment, Pixels

SIGNATURE = b"\x89PNG\r\n\x1a\n"

BAND = 32
"""Rows compressed together. Bands do not refer to each other, so an unchanged one is used again."""

LEVEL = 1
"""Of deflate: level 6 takes more than twice as long and saves a tenth of a lesson's frame."""

_ADLER_BASE = 65521  # the largest prime below 2**16 (RFC 1950)
_LAST_BLOCK = b"\x03\x00"  # empty; ends a deflate stream made of flushed pieces


def chunk(kind: bytes, data: bytes) -> bytes:
    """A PNG chunk: length, kind, data, and the checksum of the latter two."""
    check = zlib.crc32(data, zlib.crc32(kind))
    return b"".join((struct.pack(">I", len(data)), kind, data, struct.pack(">I", check)))


def header(width: int, height: int) -> bytes:
    """The IHDR chunk of a picture with eight bits each for red, green and blue."""
    return chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))


def scanlines(pixels: Pixels) -> NDArray[np.uint8]:
    """The rows of a picture as PNG wants them, before compression: shape (height, 1 + 3 width).

    All but the first are differences to the row above (filter 2, "Up"): on drawn pictures that
    compresses about as well as choosing a filter for each row, and costs next to nothing.
    """
    height, width = pixels.shape
    picture = np.ascontiguousarray(pixels)
    rgb = Image.frombuffer("RGB", (width, height), picture, "raw", "BGRX", 0, 1).tobytes()
    rows = np.frombuffer(rgb, np.uint8).reshape(height, 3 * width)
    lines = np.empty((height, 1 + 3 * width), np.uint8)
    lines[0, 0] = 0
    lines[0, 1:] = rows[0]
    lines[1:, 0] = 2
    np.subtract(rows[1:], rows[:-1], out=lines[1:, 1:])
    return lines


def png_bytes(pixels: Pixels) -> bytes:
    """One picture as a PNG file (24-bit RGB)."""
    return Pictures().encode(pixels)


class Pictures:
    """Makes PNG files of pictures that follow each other; each is complete by itself."""

    def __init__(self) -> None:
        self._last: Pixels | None = None
        self._bands: list[tuple[bytes, int, int]] = []
        """Of the last picture, from the top: deflated, its Adler checksum, its length before."""

    def encode(self, pixels: Pixels) -> bytes:
        """The picture as a PNG file. Its bytes do not depend on what was encoded before it."""
        height, width = pixels.shape
        starts = range(0, height, BAND)
        if self._last is None or self._last.shape != pixels.shape:
            self._bands = [_deflated(pixels[top : top + BAND]) for top in starts]
        else:
            rows = (pixels != self._last).any(axis=1)
            for number in np.flatnonzero(np.logical_or.reduceat(rows, starts)):
                self._bands[number] = _deflated(pixels[starts[number] :][:BAND])
        self._last = pixels
        data = b"".join((b"\x78\x01", *(band[0] for band in self._bands), _LAST_BLOCK))
        stream = data + struct.pack(">I", _adler(self._bands))
        body = (SIGNATURE, header(width, height), chunk(b"IDAT", stream), chunk(b"IEND", b""))
        return b"".join(body)


def _deflated(band: Pixels) -> tuple[bytes, int, int]:
    lines = scanlines(band)
    deflate = zlib.compressobj(LEVEL, zlib.DEFLATED, -zlib.MAX_WBITS)
    data = deflate.compress(lines.data) + deflate.flush(zlib.Z_SYNC_FLUSH)
    return data, zlib.adler32(lines.data), lines.size


def _adler(bands: list[tuple[bytes, int, int]]) -> int:
    """The Adler-32 checksum of the bands one after another (RFC 1950, section 9)."""
    low, high = 1, 0
    for _, check, length in bands:
        high += (check >> 16) + length * (low - 1)
        low += (check & 0xFFFF) - 1
    return (high % _ADLER_BASE) << 16 | low % _ADLER_BASE


class Frames:
    """Writes a folder of `frame-00001.png`, `frame-00002.png`, ..."""

    def __init__(self, part: Path, film: Film) -> None:
        self._folder = part
        self._pictures = Pictures()
        self._count = 0

    def frame(self, frame: Frame) -> None:
        """Write the next file."""
        self._count += 1
        name = f"frame-{self._count:05d}.png"
        (self._folder / name).write_bytes(self._pictures.encode(frame.pixels))

    def moment(self, moment: Moment) -> None:
        """Pictures have no use for it."""

    def finish(self) -> None:
        """Every file is whole already."""

    def abandon(self) -> None:
        """Nothing is open."""
