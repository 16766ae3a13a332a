"""Animated PNG: exact colours, exact times, only the changed box of each frame, streamed."""

import struct
import zlib
from pathlib import Path

from app.frames import Film, Frame, Moment, Pixels
from app.outputs.changes import Box, changed, whole
from app.outputs.png import SIGNATURE, chunk, header, scanlines
from app.outputs.titles import png_texts

LEVEL = 6
"""Of deflate: only changed boxes are compressed, so more effort is affordable than for folders."""

LONGEST = 0xFFFF
"""Frames' durations that one picture may last: a delay is a fraction of two 16-bit numbers."""


class Apng:
    """Writes `.apng` (PNG specification, third edition, section 11.3.5: acTL, fcTL, fdAT)."""

    def __init__(self, part: Path, film: Film) -> None:
        self._file = part.open("wb")
        self._fps = film.fps
        self._shown: Pixels | None = None
        self._pictures = 0
        self._sequence = 0
        self._waiting: tuple[Box, bytes, int] | None = None
        """The last picture: its box, its data, the index of the frame it came with."""
        self._end = 0
        self._file.write(SIGNATURE + header(film.width, film.height))
        self._count_at = self._file.tell()
        self._file.write(_count(0) + png_texts(film))

    def frame(self, frame: Frame) -> None:
        """Compress what changed; an equal picture only lasts longer."""
        self._end = frame.index + 1
        box = whole(frame.pixels) if self._shown is None else changed(self._shown, frame.pixels)
        if box is None:
            return
        self._write_waiting(frame.index)
        self._shown = frame.pixels
        data = zlib.compress(scanlines(frame.pixels[box.slices]).data, LEVEL)
        self._waiting = (box, data, frame.index)

    def moment(self, moment: Moment) -> None:
        """Pictures have no use for it."""

    def finish(self) -> None:
        """Write the last picture, and at the front how many there are."""
        self._write_waiting(self._end)
        self._file.write(chunk(b"IEND", b""))
        self._file.seek(self._count_at)
        self._file.write(_count(self._pictures))
        self._file.close()

    def abandon(self) -> None:
        """Close."""
        self._file.close()

    def _write_waiting(self, until: int) -> None:
        """Write the last picture, now that it is known how long it is shown."""
        if self._waiting is None:
            return
        box, data, start = self._waiting
        lasts = until - start
        self._write(box, data, min(lasts, LONGEST))
        while (lasts := lasts - LONGEST) > 0:
            self._write(box, data, min(lasts, LONGEST))

    def _write(self, box: Box, data: bytes, lasts: int) -> None:
        place = (box.width, box.height, box.left, box.top)
        control = struct.pack(">IIIIIHHBB", self._sequence, *place, lasts, self._fps, 0, 0)
        self._sequence += 1
        self._file.write(chunk(b"fcTL", control))
        if self._pictures == 0:
            self._file.write(chunk(b"IDAT", data))
        else:
            self._file.write(chunk(b"fdAT", struct.pack(">I", self._sequence) + data))
            self._sequence += 1
        self._pictures += 1


def _count(pictures: int) -> bytes:
    return chunk(b"acTL", struct.pack(">II", pictures, 0))  # 0 plays: for ever
