"""Coverage masks of shapes, from their signed distance to the middle of each pixel.

A pixel whose middle lies `d` pixels outside an edge is covered to `clip(0.5 - d, 0, 1)`. All is in
pixels, y downwards; pixel (column, row) covers column..column + 1. Only additions, products, square
roots and comparisons of single elements are used, which are the same on every processor.
"""

import math
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from screens.kit import arrows
from screens.kit.geometry import Point

Grid = NDArray[Any]
"""Coordinates or distances of pixels (px); a row (1, width), a column (height, 1) or both."""
Coverage = NDArray[np.uint8]
"""How much of each pixel is covered, 0..255; shape (height, width)."""

HOLLOW_LINE = 0.4
"""Line width of a hollow head, in widths of the shaft."""
FAR = 4096.0
"""Beyond this many pixels single precision is no longer fine enough."""


class Box(NamedTuple):
    """Whole pixels: left and top belong to it, right and bottom do not."""

    left: int
    top: int
    right: int
    bottom: int

    @property
    def area(self) -> int:
        """How many pixels it has; 0 if it is turned inside out."""
        width, height = self.extent
        return width * height

    @property
    def extent(self) -> tuple[int, int]:
        """Width and height, never negative."""
        return max(0, self.right - self.left), max(0, self.bottom - self.top)

    def moved(self, columns: int, rows: int) -> "Box":
        """The same box elsewhere."""
        left, top, right, bottom = self
        return Box(left + columns, top + rows, right + columns, bottom + rows)

    def meet(self, other: "Box") -> "Box":
        """What both share."""
        left, top, right, bottom = self
        return Box(
            left if left > other.left else other.left,
            top if top > other.top else other.top,
            right if right < other.right else other.right,
            bottom if bottom < other.bottom else other.bottom,
        )


class Mask(NamedTuple):
    """How much of some pixels is covered, and where they lie."""

    coverage: Coverage
    left: int = 0
    """Of its first column, seen from where it is stamped (px)."""
    top: int = 0
    """Of its first row."""
    inks: NDArray[np.uint32] | None = None
    """The colour of each pixel (0x00RRGGBB), if they are not all of one."""

    @property
    def size(self) -> int:
        """How many bytes it takes."""
        return self.coverage.nbytes + (0 if self.inks is None else self.inks.nbytes)


class Shape(Protocol):
    """Something with an edge. Equal shapes give equal masks."""

    def bounds(self) -> tuple[float, float, float, float]:
        """Left, top, right and bottom of all that it covers."""

    def distance(self, x: Grid, y: Grid) -> Grid:
        """Signed distance from its edge, negative inside; `x` is a row and `y` a column."""


class Disc(NamedTuple):
    """A filled circle."""

    x: float
    y: float
    radius: float

    def bounds(self) -> tuple[float, float, float, float]:
        """See `Shape`."""
        x, y, radius = self
        return x - radius, y - radius, x + radius, y + radius

    def distance(self, x: Grid, y: Grid) -> Grid:
        """See `Shape`."""
        dx, dy = x - self.x, y - self.y
        distance: Grid = dx * dx + dy * dy
        np.sqrt(distance, out=distance)
        distance -= self.radius
        return distance


class Slab(NamedTuple):
    """An upright rectangle with rounded corners."""

    left: float
    top: float
    right: float
    bottom: float
    radius: float

    def bounds(self) -> tuple[float, float, float, float]:
        """See `Shape`."""
        return self[:4]

    def distance(self, x: Grid, y: Grid) -> Grid:
        """See `Shape`."""
        left, top, right, bottom, radius = self
        dx = np.abs(x - (left + right) / 2) - ((right - left) / 2 - radius)
        dy = np.abs(y - (top + bottom) / 2) - ((bottom - top) / 2 - radius)
        distance: Grid = np.maximum(dx, dy)
        np.minimum(distance, 0, out=distance)
        distance -= radius
        dx, dy = np.maximum(dx, 0), np.maximum(dy, 0)
        corner = dx * dx + dy * dy
        distance += np.sqrt(corner, out=corner)
        return distance


class Hull(NamedTuple):
    """A convex polygon."""

    corners: tuple[Point, ...]

    def bounds(self) -> tuple[float, float, float, float]:
        """See `Shape`."""
        xs, ys = [p.x for p in self.corners], [p.y for p in self.corners]
        return min(xs), min(ys), max(xs), max(ys)

    def distance(self, x: Grid, y: Grid) -> Grid:
        """See `Shape`; beyond a corner it is the distance from the nearer side's line."""
        corners = self.corners
        area = sum(
            corners[i - 1].x * corners[i].y - corners[i].x * corners[i - 1].y
            for i in range(len(corners))
        )
        turn = 1.0 if area > 0 else -1.0
        farthest: Grid = np.full((y.size, x.size), -np.inf, x.dtype)
        for i in range(len(corners)):
            a, b = corners[i - 1], corners[i]
            dx, dy = b.x - a.x, b.y - a.y
            length = math.sqrt(dx * dx + dy * dy)
            if length > 0:
                nx, ny = turn * dy / length, -turn * dx / length
                np.maximum(farthest, (x - a.x) * nx + (y - a.y) * ny, out=farthest)
        return farthest


class Bar(NamedTuple):
    """A thick line with round ends."""

    a: Point
    b: Point
    width: float

    def bounds(self) -> tuple[float, float, float, float]:
        """See `Shape`."""
        a, b, half = self.a, self.b, self.width / 2
        return (
            min(a.x, b.x) - half,
            min(a.y, b.y) - half,
            max(a.x, b.x) + half,
            max(a.y, b.y) + half,
        )

    def distance(self, x: Grid, y: Grid) -> Grid:
        """See `Shape`."""
        along, across, length = _along_and_across(self.a, self.b, x, y)
        along -= length / 2
        beyond = np.abs(along, out=along)
        beyond -= length / 2
        np.maximum(beyond, 0, out=beyond)
        distance = _length(across, beyond)
        distance -= self.width / 2
        return distance


class Stroke(NamedTuple):
    """A thick line with square ends, dashed if `on` and `off` are not 0."""

    a: Point
    b: Point
    width: float
    on: float = 0.0
    off: float = 0.0

    def bounds(self) -> tuple[float, float, float, float]:
        """See `Shape`."""
        return Bar(self.a, self.b, self.width).bounds()

    def distance(self, x: Grid, y: Grid) -> Grid:
        """See `Shape`."""
        along, across, length = _along_and_across(self.a, self.b, x, y)
        outside = np.maximum(np.abs(across) - self.width / 2, np.maximum(-along, along - length))
        if self.on > 0 and self.off > 0:
            period = self.on + self.off
            phase = along - np.floor(along / period) * period
            gap = np.minimum(np.abs(phase - self.on / 2) - self.on / 2, period - phase)
            outside = np.maximum(outside, gap)
        return outside


class ArrowShape(NamedTuple):
    """A shaft with a round tail, and a head that is solid or hollow."""

    tail: Point
    tip: Point
    width: float
    hollow: bool

    def _parts(self) -> arrows.Arrow:
        parts = arrows.shape(self.tail, self.tip, self.width)
        if parts is None:
            raise ValueError(f"an arrow needs a length, but starts and ends at {tuple(self.tail)}")
        return parts

    def bounds(self) -> tuple[float, float, float, float]:
        """See `Shape`."""
        parts = self._parts()
        (ax, ay), (bx, by), (x, y), half = *parts.wings, parts.tail, parts.width / 2
        tip_x, tip_y = parts.tip
        return (
            min(x - half, tip_x, ax, bx),
            min(y - half, tip_y, ay, by),
            max(x + half, tip_x, ax, bx),
            max(y + half, tip_y, ay, by),
        )

    def distance(self, x: Grid, y: Grid) -> Grid:
        """See `Shape`."""
        parts = self._parts()
        along, across, length = _along_and_across(parts.tail, parts.neck, x, y)
        tall, half = arrows.HEAD_LENGTH * parts.width, arrows.HEAD_WIDTH * parts.width / 2
        slope = math.sqrt(tall * tall + half * half)
        np.abs(across, out=across)
        head = along * (half / slope)
        head += across * (tall / slope)
        head -= (length + tall) * half / slope
        np.maximum(head, length - along, out=head)
        overlap = parts.width / 2
        if self.hollow:
            line = max(1.0, HOLLOW_LINE * parts.width)
            head += line / 2
            np.abs(head, out=head)
            head -= line / 2
            overlap = line / 2
        beyond = along - (length + overlap)
        np.minimum(along, 0, out=along)
        shaft = _length(across, along)
        shaft -= parts.width / 2
        np.maximum(shaft, beyond, out=shaft)
        distance: Grid = np.minimum(shaft, head, out=shaft)
        return distance


def _length(x: Grid, y: Grid) -> Grid:
    """The length of each vector (x, y); both are used up."""
    x *= x
    y *= y
    x += y
    length: Grid = np.sqrt(x, out=x)
    return length


def _along_and_across(a: Point, b: Point, x: Grid, y: Grid) -> tuple[Grid, Grid, float]:
    """Coordinates of pixels along a line and across it, and the line's length."""
    dx, dy = b.x - a.x, b.y - a.y
    length = math.sqrt(dx * dx + dy * dy)
    ux, uy = (dx / length, dy / length) if length > 0 else (1.0, 0.0)
    x, y = x - a.x, y - a.y
    return x * ux + y * uy, y * ux - x * uy, length


class Look(NamedTuple):
    """How strongly a shape's area and its rim (a line inside its edge) are painted."""

    area: float = 1.0
    """Opacity, 0..1."""
    rim: float = 0.0
    """Opacity, 0..1."""
    rim_width: float = 0.0
    """(px)"""
    inset: float = 0.0
    """How far the area ends inside the edge (px)."""


FILLED = Look()


def cover(shape: Shape, look: Look, box: Box) -> Coverage:
    """How much `shape` covers each pixel of `box`."""
    reach = max(-box.left, -box.top, box.right, box.bottom)
    kind = np.float32 if reach < FAR else np.float64
    x = np.arange(box.left + 0.5, box.right, dtype=kind)[None, :]
    y = np.arange(box.top + 0.5, box.bottom, dtype=kind)[:, None]
    if not isinstance(shape, Slab):
        return _cover(shape, look, x, y)
    left, top, right, bottom = shape.bounds()
    # Away from its ends all columns of a rectangle are equal, and so are all rows.
    near = shape.radius + look.rim_width + look.inset + 2
    columns, wide = _unlike(x[0], left + near, right - near)
    rows, high = _unlike(y[:, 0], top + near, bottom - near)
    return _cover(shape, look, x[:, columns], y[rows]).repeat(high, axis=0).repeat(wide, axis=1)


def _unlike(middles: Grid, low: float, high: float) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Of pixels in a row, the first of those from `low` to `high` and all others.

    And how many each stands for.
    """
    first, end = np.searchsorted(middles, (low, high))
    if end - first < 2:
        return np.arange(middles.size), np.ones(middles.size, np.intp)
    kept = np.concatenate((np.arange(first + 1), np.arange(end, middles.size)))
    counts = np.ones(kept.size, np.intp)
    counts[first] = end - first
    return kept, counts


def _cover(shape: Shape, look: Look, x: Grid, y: Grid) -> Coverage:
    """How much `shape` covers pixels whose middles are in these columns and rows."""
    distance = shape.distance(x, y)
    rim = None
    if look.rim > 0:
        half = look.rim_width / 2
        rim = distance + half
        np.abs(rim, out=rim)
        _soften(rim, half, look.rim)
    area = _soften(distance, -look.inset, look.area)
    if rim is not None:
        both = area * rim
        area += rim
        area -= both
    area *= 255
    area += 0.5
    coverage: Coverage = area.astype(np.uint8)
    return coverage


def _soften(distance: Grid, grow: float, opacity: float) -> Grid:
    """Turn distances into coverage, in place: of the shape grown by `grow` px."""
    np.subtract(0.5 + grow, distance, out=distance)
    np.maximum(distance, 0, out=distance)
    np.minimum(distance, 1, out=distance)
    if opacity != 1.0:
        distance *= opacity
    return distance


def bounding_box(shape: Shape) -> Box | None:
    """The pixels a shape may touch; None for one without finite bounds."""
    left, top, right, bottom = shape.bounds()
    if not (-math.inf < left <= right < math.inf and -math.inf < top <= bottom < math.inf):
        return None
    return Box(
        math.floor(left - 0.5),
        math.floor(top - 0.5),
        math.ceil(right + 0.5),
        math.ceil(bottom + 0.5),
    )
