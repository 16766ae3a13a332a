"""Discs at any fraction of a pixel, all their layers in one sprite.

How a disc looks depends on nothing but the distance from its middle. So colours are worked out once
for each distance, and a sprite is made by looking up the squared distance of every pixel, which is
the sum of one number for its column and one for its row.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from screens.kit.cache import Cache
from screens.kit.layers import stacked
from screens.kit.theme import Color

LARGEST = 200.0
"""Radius of the largest disc that is drawn so (px): the table grows with it."""
FINE, FINEST = 128.0, 256.0
"""Entries of the table for each px^2 of squared distance, times the radius (px), and at most: an
entry is 1/256 of a pixel at the edge."""
PHASES = 32
"""To such parts of a pixel discs are placed."""
TABLES, AXES = 1 << 20, 1 << 18
"""Bytes that tables and axes may take."""
OVERHEAD = 300
"""Bytes that holding a table or an axis takes beyond its numbers."""


class Coat(NamedTuple):
    """What a disc is painted with: the ground lies below the area, the rim over it."""

    color: Color | None
    """Of the area; None: there is none."""
    alpha: float = 1.0
    """0..1"""
    rim: Color | None = None
    rim_alpha: float = 1.0
    rim_width: float = 0.0
    """Inwards from the edge (px)."""
    ground: Color | None = None
    """What shows through a pale area instead of what was drawn before."""


class Axis(NamedTuple):
    """The columns, or the rows, that a disc lies in."""

    first: int
    squares: NDArray[np.int64]
    """Squared distance of each from the disc's middle, in entries of a table, rounded down."""

    @property
    def end(self) -> int:
        """The first that lies behind it."""
        return self.first + self.squares.size


class Discs:
    """Makes sprites of discs; keeps the tables of those it made last."""

    def __init__(self) -> None:
        """Start with no table."""
        self._tables: Cache[NDArray[np.uint32]] = Cache(TABLES)
        self._axes: Cache[Axis] = Cache(AXES)

    def axis(self, middle: float, radius: float) -> Axis:
        """Where a disc lies along one axis (px); its middle is rounded to 1/32 px."""
        pixel = math.floor(middle)
        phase = round((middle - pixel) * PHASES)
        axis = self._axes.find((radius, phase))
        if axis is None:
            axis = _axis(phase / PHASES, radius)
            self._axes.keep((radius, phase), axis, axis.squares.nbytes + OVERHEAD)
        return Axis(pixel + axis.first, axis.squares)

    def sprite(self, columns: Axis, rows: Axis, radius: float, coat: Coat) -> NDArray[np.uint32]:
        """The pixels of a disc, each 0xAARRGGBB, its colour not multiplied by its opacity.

        The radius is in px, at most `LARGEST`.
        """
        table = self._tables.find((radius, coat))
        if table is None:
            table = _table(radius, coat)
            self._tables.keep((radius, coat), table, table.nbytes + OVERHEAD)
        # Whatever lies beyond the table gets its last entry, which is clear.
        return table.take(rows.squares[:, None] + columns.squares, mode="clip")


def _axis(middle: float, radius: float) -> Axis:
    first, end = math.floor(middle - radius - 0.5), math.ceil(middle + radius + 0.5)
    away = np.arange(first + 0.5, end) - middle
    return Axis(first, (away * away * _steps(radius)).astype(np.int64))


def _steps(radius: float) -> float:
    """Entries of a table for each px^2 of squared distance."""
    return min(FINE / radius, FINEST)


def _table(radius: float, coat: Coat) -> NDArray[np.uint32]:
    """The colour of a disc (0xAARRGGBB) by squared distance from its middle."""
    steps = _steps(radius)
    count = math.ceil(steps * (radius + 0.5) * (radius + 0.5)) + 1
    # Two numbers that were rounded down are one entry too small together, on average.
    distance = np.sqrt(np.arange(1, count + 1) / steps) - radius
    layers: list[tuple[Color, NDArray[np.float64]]] = []
    line = coat.rim_width / 2
    if coat.ground is not None:
        layers.append((coat.ground, _covered(distance, 1.0)))
    if coat.color is not None:
        inset = line if coat.rim not in (None, coat.color) else 0.0
        layers.append((coat.color, _covered(distance + inset, coat.alpha)))
    if coat.rim is not None:
        layers.append((coat.rim, _covered(np.abs(distance + line) - line, coat.rim_alpha)))
    table = stacked(layers) if layers else np.zeros(count, np.uint32)
    table[-1] = 0
    return table


def _covered(distance: NDArray[np.float64], alpha: float) -> NDArray[np.float64]:
    """How much of a pixel is covered (0..1) whose middle is so far outside an edge (px)."""
    return np.minimum(np.maximum(0.5 - distance, 0.0), 1.0) * min(max(alpha, 0.0), 1.0)
