"""Which part of a picture differs from the one before it."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

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
    nothing differs there is none. The pictures are C-contiguous and of one size, of even width.
    """
    rows, half = before.shape[0], before.shape[1] // 2
    tops = range(0, rows, height)
    differs = np.zeros((len(tops), height, half), np.bool_)
    np.not_equal(_paired(before), _paired(now), out=differs.reshape(-1, half)[:rows])
    columns: NDArray[np.bool_] = np.logical_or.reduce(differs, axis=1)
    columns[1:] |= differs[:-1, -1]
    columns[:-1] |= differs[1:, 0]
    first, last = columns.argmax(axis=1), columns[:, ::-1].argmax(axis=1)
    return [
        Box(top, 2 * int(first[band]), min(top + height, rows), 2 * (half - int(last[band])))
        for band, top in enumerate(tops)
        if columns[band, first[band]]
    ]


def _paired(pixels: Pixels) -> NDArray[Any]:
    """The same picture, two pixels in one number if possible: half as many to compare."""
    return pixels if pixels.shape[1] % 2 else pixels.view(np.uint64)
