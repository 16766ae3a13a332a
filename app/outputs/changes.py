"""Which part of a picture differs from the one before it."""

from typing import NamedTuple

import numpy as np

from app.frames import Pixels


class Box(NamedTuple):
    """An upright rectangle of pixels: the first row and column inside, and those just outside."""

    top: int
    left: int
    bottom: int
    right: int

    @property
    def width(self) -> int:
        """In pixels."""
        return self.right - self.left

    @property
    def height(self) -> int:
        """In pixels."""
        return self.bottom - self.top

    @property
    def slices(self) -> tuple[slice, slice]:
        """To cut it out of an array of (rows, columns)."""
        return slice(self.top, self.bottom), slice(self.left, self.right)


def whole(pixels: Pixels) -> Box:
    """The box around all of a picture."""
    return Box(0, 0, pixels.shape[0], pixels.shape[1])


def changed(before: Pixels, now: Pixels) -> Box | None:
    """The smallest box that holds every pixel that differs, or None if none does."""
    rows = np.flatnonzero((before != now).any(axis=1))
    if rows.size == 0:
        return None
    top, bottom = int(rows[0]), int(rows[-1]) + 1
    columns = np.flatnonzero((before[top:bottom] != now[top:bottom]).any(axis=0))
    return Box(top, int(columns[0]), bottom, int(columns[-1]) + 1)
