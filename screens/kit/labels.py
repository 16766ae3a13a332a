"""Where a label may stand: near its anchor, inside the canvas, and over nothing that matters.

Needs no pygame. All is in dp.
"""

import math
from array import array
from typing import Any

import numpy as np
from numpy.typing import NDArray

from screens.kit.geometry import Point, Rect, Size

RINGS = (0.0, 8.0, 18.0, 32.0, 50.0, 74.0, 102.0, 134.0)
"""How far labels may move away from their anchor, nearest first."""
TURNS = tuple(math.pi * turn / 12 for turn in (6, 4, 8, 2, 10, 0, 12, 14, 22, 16, 20, 18))
"""Directions that are tried on each ring: upwards first, straight down last (rad)."""
AWAY: NDArray[Any] = np.array(
    [(ring, math.cos(turn), -math.sin(turn)) for ring in RINGS for turn in TURNS]
)
"""Ring (dp) and direction (x, y) of all places that are tried, in order; shape (n, 3)."""
MARGIN = 2.0
"""What is left free around a label."""
PIECE, MOST_PIECES = 8.0, 64
"""Length of a piece of a slanted line, and how many there are at most."""


class Labels:
    """The free room of a canvas. What is drawn blocks its place, so does each label placed."""

    def __init__(self, bounds: Rect) -> None:
        """Start with nothing but the limits of the canvas."""
        self.bounds = bounds
        self._taken = array("d")
        """Left, top, right and bottom of one rectangle after the other."""
        self._circles: list[tuple[Point, float]] = []
        self._lines: list[tuple[Point, Point, float]] = []

    def block(self, rect: Rect) -> None:
        """Keep labels off a rectangle."""
        self._taken.extend((rect.x, rect.y, rect.right, rect.bottom))

    def block_circle(self, center: Point, radius: float) -> None:
        """Keep labels off a disc: of the square around it all but the corners."""
        self._circles.append((center, radius))

    def block_line(self, a: Point, b: Point, width: float) -> None:
        """Keep labels off a thick line, as a row of rectangles along it."""
        self._lines.append((a, b, width))

    def _blocked(self) -> NDArray[Any]:
        """Left, top, right and bottom of all that is blocked, shape (n, 4).

        Circles and lines are turned into rectangles here: often no label asks for them.
        """
        if self._circles:
            self._taken.frombytes(_of_circles(self._circles).tobytes())
        if self._lines:
            self._taken.frombytes(_of_lines(self._lines).tobytes())
        self._circles, self._lines = [], []
        return np.frombuffer(self._taken).reshape(-1, 4)

    def is_free(self, rect: Rect) -> bool:
        """Whether a label may stand there."""
        corner = np.array([[rect.x, rect.y]])
        return bool(self._free(corner, Size(rect.width, rect.height), self._blocked())[0])

    def place(
        self, size: Size, anchor: Point, gap: float = 6, ahead: Point | None = None
    ) -> Rect | None:
        """Find a free place for a label of `size` near `anchor`, `gap` dp from it, and block it.

        The first choice lies in the direction `ahead` of the anchor: with an arrow that moves a
        label moves as smoothly. None: there is no free place.
        """
        found = self._ahead(size, anchor, gap, ahead) if ahead is not None else None
        if found is None:
            found = self._nearest(size, anchor, gap)
        if found is not None:
            self.block(found)
        return found

    def _ahead(self, size: Size, anchor: Point, gap: float, ahead: Point) -> Rect | None:
        """The place before an arrow's head, if it is free."""
        length = math.sqrt(ahead.x * ahead.x + ahead.y * ahead.y)
        if length == 0.0:
            return None
        x = anchor.x + ahead.x / length * (gap + size.width / 2) - size.width / 2
        y = anchor.y + ahead.y / length * (gap + size.height / 2) - size.height / 2
        place = Rect(x, y, size.width, size.height)
        return place if self.is_free(place) else None

    def _nearest(self, size: Size, anchor: Point, gap: float) -> Rect | None:
        """The first free place: the nearest ring first, then all the others."""
        spots = self._pushed_inside(_spots(size, anchor, gap), size)
        left, top = spots.min(axis=0) - MARGIN
        right, bottom = spots.max(axis=0) + MARGIN + size
        taken = self._blocked()
        near = taken[
            (taken[:, 0] < right)
            & (taken[:, 1] < bottom)
            & (taken[:, 2] > left)
            & (taken[:, 3] > top)
        ]
        for some in (spots[: len(TURNS)], spots[len(TURNS) :]):
            free = np.flatnonzero(self._free(some, size, near))
            if free.size:
                x, y = some[free[0]]
                return Rect(float(x), float(y), size.width, size.height)
        return None

    def _pushed_inside(self, corners: NDArray[Any], size: Size) -> NDArray[Any]:
        """The same places, but none across a side of the canvas, if the label fits into it."""
        bounds = self.bounds
        low = np.array([bounds.x, bounds.y])
        high = np.array([bounds.right - size.width, bounds.bottom - size.height])
        inside: NDArray[Any] = np.maximum(np.minimum(corners, high), low)
        return inside

    def _free(self, corners: NDArray[Any], size: Size, taken: NDArray[Any]) -> NDArray[Any]:
        """Which of the labels with these top left corners, shape (n, 2), cover nothing."""
        left, top = corners[:, :1], corners[:, 1:]
        right, bottom = left + size.width, top + size.height
        bounds = self.bounds
        free: NDArray[Any] = (
            (left >= bounds.x)
            & (top >= bounds.y)
            & (right <= bounds.right)
            & (bottom <= bounds.bottom)
        )[:, 0]
        hit = left - MARGIN < taken[:, 2]
        hit &= right + MARGIN > taken[:, 0]
        hit &= top - MARGIN < taken[:, 3]
        hit &= bottom + MARGIN > taken[:, 1]
        free &= ~hit.any(axis=1)
        return free


def _spots(size: Size, anchor: Point, gap: float) -> NDArray[Any]:
    """Top left corners to try, shape (n, 2): the label touches an ellipse around the anchor."""
    half = np.array([size.width / 2, size.height / 2])
    corner = np.array([anchor.x, anchor.y]) - half
    spots: NDArray[Any] = corner + AWAY[:, 1:] * (AWAY[:, :1] + gap + half)
    return spots


def _of_circles(circles: list[tuple[Point, float]]) -> NDArray[Any]:
    """Rectangles that fill discs (left, top, right, bottom), three for each."""
    x, y, radius = np.array([(x, y, radius) for (x, y), radius in circles]).T
    rects = [
        np.stack((x - wide, y - high, x + wide, y + high), axis=1)
        for wide, high in (
            (0.5 * radius, radius),
            (0.9 * radius, 0.9 * radius),
            (radius, 0.5 * radius),
        )
    ]
    return np.concatenate(rects)


def _of_lines(lines: list[tuple[Point, Point, float]]) -> NDArray[Any]:
    """Rectangles along thick lines (left, top, right, bottom): more of them if they slant."""
    ends = np.array([(*a, *b, width) for a, b, width in lines])
    ends = ends[np.isfinite(ends).all(axis=1)]
    way = np.abs(ends[:, 2:4] - ends[:, :2])
    steps = np.minimum(np.maximum(np.ceil(way.max(axis=1, initial=0.0) / PIECE), 1), MOST_PIECES)
    slants = way.min(axis=1, initial=math.inf) > ends[:, 4]
    pieces = np.where(slants, steps, 1).astype(np.intp)
    first = np.cumsum(pieces) - pieces
    number = (np.arange(pieces.sum()) - first.repeat(pieces))[:, None]
    ends, count = ends.repeat(pieces, axis=0), pieces.repeat(pieces)[:, None]
    start, way, half = ends[:, :2], ends[:, 2:4] - ends[:, :2], ends[:, 4:] / 2
    one, other = start + way * number / count, start + way * (number + 1) / count
    return np.concatenate((np.minimum(one, other) - half, np.maximum(one, other) + half), axis=1)
