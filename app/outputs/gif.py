"""GIF: one palette, no dither, only what changed, and delays that add up to the true time."""

import io
import struct
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from app.frames import Film, Frame, Moment, Pixels
from app.outputs.changes import Box, differences, whole
from app.outputs.palette import SIZE, TRANSPARENT, Palette
from app.outputs.titles import gif_comment
from screens.kit import theme

FASTEST = 50
"""Pictures per second: browsers show a delay under two hundredths of a second as ten."""

LONGEST = 0xFFFF
"""Hundredths of a second that one picture may last."""

EXACT = (
    *(theme.SURFACE, theme.CANVAS, theme.NAVIGATION, theme.DIALOG, theme.TEXT, theme.WALL),
    *(theme.TEAL, theme.ORANGE, theme.YELLOW, theme.PURPLE),
)
"""Colours that a pupil tells things apart by: exact however late they appear."""

_KEEP = 1 << 2  # disposal: the next picture is drawn over this one
_FOR_EVER = b"\x21\xff\x0bNETSCAPE2.0\x03\x01\x00\x00\x00"
_END = b"\x3b"


class Gif:
    """Writes `.gif` (GIF89a). Equal pictures become one that lasts longer.

    Films of more than 50 frames a second show each second frame (each third above 100, ...): a
    regular half of the rate looks calmer than one frame missing now and then. Times are whole
    hundredths counted from the start, so they never drift: 30 fps is 3, 3, 4. Only a last picture
    that would be shorter than 2 hundredths is drawn out to 2.
    """

    def __init__(self, part: Path, film: Film) -> None:
        self._file = part.open("wb")
        self._fps = film.fps
        self._stride = -(-film.fps // FASTEST)
        self._palette = Palette(EXACT)
        self._seen: Pixels | None = None
        self._waiting: tuple[Box, bytes, int] | None = None
        """The last picture: its box, its compressed data, when it appears (hundredths)."""
        self._end = 0
        # 0xF7: a global table of 256 entries, 8 bits a channel. It is filled in at the end.
        self._file.write(b"GIF89a" + struct.pack("<HHBBB", film.width, film.height, 0xF7, 0, 0))
        self._table_at = self._file.tell()
        self._file.write(bytes(3 * SIZE) + _FOR_EVER + gif_comment(film))

    def frame(self, frame: Frame) -> None:
        """Compress what changed, if this frame is one of those shown."""
        self._end = frame.index + 1
        if frame.index % self._stride:
            return
        now, before = frame.pixels, self._seen
        if before is None:
            box, indices = whole(now), self._palette(now)
        else:
            found = differences(before, now)
            if found is None:
                return
            box, differs = found
            indices = np.full(differs.shape, TRANSPARENT, np.uint8)
            indices[differs] = self._palette(now[box.slices][differs])
        self._seen = now
        time = self._time(frame.index)
        self._write_waiting(time)
        self._waiting = (box, compressed(indices), time)

    def moment(self, moment: Moment) -> None:
        """Pictures have no use for it."""

    def finish(self) -> None:
        """Write the last picture, and the colours at the front."""
        self._write_waiting(self._time(self._end))
        self._file.write(_END)
        self._file.seek(self._table_at)
        self._file.write(self._palette.colours())
        self._file.close()

    def abandon(self) -> None:
        """Close."""
        self._file.close()

    def _time(self, index: int) -> int:
        return 100 * index // self._fps

    def _write_waiting(self, until: int) -> None:
        """Write the last picture, now that it is known how long it is shown."""
        if self._waiting is None:
            return
        box, data, start = self._waiting
        lasts = max(until - start, 2)
        self._write(box, data, min(lasts, LONGEST))
        nothing = compressed(np.full((1, 1), TRANSPARENT, np.uint8))
        while (lasts := lasts - LONGEST) > 0:
            self._write(Box(0, 0, 1, 1), nothing, max(min(lasts, LONGEST), 2))

    def _write(self, box: Box, data: bytes, lasts: int) -> None:
        control = struct.pack("<BBBBHBB", 0x21, 0xF9, 4, _KEEP | 1, lasts, TRANSPARENT, 0)
        place = struct.pack("<BHHHHB", 0x2C, box.left, box.top, box.width, box.height, 0)
        self._file.write(control + place + data)


def compressed(indices: NDArray[np.uint8]) -> bytes:
    """A picture of colour indices, compressed by Pillow (LZW): code size, blocks, terminator.

    Pillow writes a file of its own around it, in which each part says how long it is.
    """
    height, width = indices.shape
    image = Image.frombuffer("P", (width, height), indices, "raw", "P", 0, 1)
    image.putpalette(bytes(3 * SIZE))
    file = io.BytesIO()
    image.save(file, "GIF", optimize=False, interlace=False)
    data = file.getvalue()
    at = 13 + 3 * 2 ** ((data[10] & 7) + 1)
    while data[at] == 0x21:  # an extension: two bytes, then blocks up to an empty one
        at += 2
        while data[at]:
            at += 1 + data[at]
        at += 1
    local = data[at + 9]
    at += 10 + (3 * 2 ** ((local & 7) + 1) if local & 0x80 else 0)
    return data[at : data.rindex(_END)]
