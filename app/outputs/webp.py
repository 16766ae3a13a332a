"""Animated WebP: lossless, only the changed box of each frame, streamed.

Pillow encodes single pictures; the container around them (RFC 9649) is written here, because
Pillow's own animations keep all frames in memory.
"""

import io
import struct
from pathlib import Path

import numpy as np
from PIL import Image

from app.frames import Film, Frame, Moment, Pixels
from app.outputs.changes import Box, changed, whole
from app.outputs.titles import xmp

METHOD = 1
"""Effort of the encoder: 0 makes files 2.6 times as large, 2 takes 1.6 times as long."""

_ANIMATION = 0x02
_HAS_XMP = 0x04
_REPLACE = 0x02  # do not blend, keep what was shown


class WebP:
    """Writes `.webp`; the times of frames are whole milliseconds that add up to the true time."""

    def __init__(self, part: Path, film: Film) -> None:
        self._file = part.open("wb")
        self._fps = film.fps
        self._shown: Pixels | None = None
        self._waiting: tuple[Box, bytes, int] | None = None
        """The last picture: its box, its data, when it appears (ms)."""
        self._end = 0
        self._xmp = xmp(film)
        flags = _ANIMATION | (_HAS_XMP if self._xmp else 0)
        canvas = struct.pack("<I", flags) + _u24(film.width - 1) + _u24(film.height - 1)
        self._file.write(b"RIFF\0\0\0\0WEBP" + _chunk(b"VP8X", canvas))
        self._file.write(_chunk(b"ANIM", struct.pack("<IH", 0xFF000000, 0)))  # 0: for ever

    def frame(self, frame: Frame) -> None:
        """Compress what changed; an equal picture only lasts longer."""
        self._end = frame.index + 1
        box = whole(frame.pixels) if self._shown is None else changed(self._shown, frame.pixels)
        if box is None:
            return
        time = self._time(frame.index)
        self._write_waiting(time)
        self._shown = frame.pixels
        box = box._replace(top=box.top & ~1, left=box.left & ~1)  # places are stored halved
        self._waiting = (box, _picture(frame.pixels[box.slices]), time)

    def moment(self, moment: Moment) -> None:
        """Pictures have no use for it."""

    def finish(self) -> None:
        """Write the last picture, and the size of the whole at the front."""
        self._write_waiting(self._time(self._end))
        if self._xmp:
            self._file.write(_chunk(b"XMP ", self._xmp))
        size = self._file.tell()
        self._file.seek(4)
        self._file.write(struct.pack("<I", size - 8))
        self._file.close()

    def abandon(self) -> None:
        """Close."""
        self._file.close()

    def _time(self, index: int) -> int:
        return 1000 * index // self._fps

    def _write_waiting(self, until: int) -> None:
        if self._waiting is None:
            return
        box, picture, start = self._waiting
        place = (box.left // 2, box.top // 2, box.width - 1, box.height - 1, until - start)
        head = b"".join(map(_u24, place)) + bytes((_REPLACE,))
        self._file.write(_chunk(b"ANMF", head + picture))


def _picture(pixels: Pixels) -> bytes:
    """The VP8L chunk of one lossless picture."""
    height, width = pixels.shape
    box = np.ascontiguousarray(pixels)
    image = Image.frombuffer("RGB", (width, height), box, "raw", "BGRX", 0, 1)
    file = io.BytesIO()
    image.save(file, "WEBP", lossless=True, quality=0, method=METHOD)
    data = file.getvalue()
    at = 12
    while data[at : at + 4] != b"VP8L":
        (size,) = struct.unpack_from("<I", data, at + 4)
        at += 8 + size + size % 2
    (size,) = struct.unpack_from("<I", data, at + 4)
    return data[at : at + 8 + size + size % 2]


def _chunk(kind: bytes, data: bytes) -> bytes:
    return kind + struct.pack("<I", len(data)) + data + b"\0" * (len(data) % 2)


def _u24(value: int) -> bytes:
    return value.to_bytes(3, "little")
