"""Which part of a picture differs from the one before it."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.frames import Pixels

GAP = 48
"""Columns that are as well taken along as left out: a box of their own would cost more."""


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
    found = differences(before, now)
    return found[0] if found else None


def differences(before: Pixels, now: Pixels) -> tuple[Box, NDArray[np.bool_]] | None:
    """The smallest box that holds every pixel that differs, and which in it do; None if none does.

    Both pictures are C-contiguous and of one size.
    """
    rows = np.flatnonzero((_paired(before) != _paired(now)).any(axis=1))
    if rows.size == 0:
        return None
    top, bottom = int(rows[0]), int(rows[-1]) + 1
    differs = before[top:bottom] != now[top:bottom]
    columns = np.flatnonzero(differs.any(axis=0))
    left, right = int(columns[0]), int(columns[-1]) + 1
    return Box(top, left, bottom, right), differs[:, left:right]


def bands(before: Pixels, now: Pixels, height: int) -> list[Box]:
    """What differs in each band of `height` rows, or in a row next to it: boxes from the top.

    A box is as high as its band, the last of which may be lower, and its sides are even. Where
    nothing differs for more than `GAP` columns one box ends and another begins. The pictures are
    C-contiguous and of one size, of even width.
    """
    rows, half, gap = before.shape[0], before.shape[1] // 2, GAP // 2
    tops = range(0, rows, height)
    differs = np.zeros((len(tops), height, half), np.bool_)
    np.not_equal(_paired(before), _paired(now), out=differs.reshape(-1, half)[:rows])
    # Behind each band a gap, so that no box reaches from one into the next.
    row = half + gap
    columns = np.zeros((len(tops), row), np.bool_)
    inside = columns[:, :half]
    np.logical_or.reduce(differs, axis=1, out=inside)
    inside[1:] |= differs[:-1, -1]
    inside[:-1] |= differs[1:, 0]
    found = np.flatnonzero(columns)
    (ends,) = np.nonzero(np.diff(found, append=columns.size + row) > gap)
    boxes, begin = [], 0
    for end in ends.tolist():
        band, first = divmod(int(found[begin]), row)
        last = int(found[end]) - band * row
        top = tops[band]
        boxes.append(Box(top, 2 * first, min(top + height, rows), 2 * (last + 1)))
        begin = end + 1
    return boxes


def _paired(pixels: Pixels) -> NDArray[Any]:
    """The same picture, two pixels in one number if possible: half as many to compare."""
    return pixels if pixels.shape[1] % 2 else pixels.view(np.uint64)
