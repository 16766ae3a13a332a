"""What a body looks like, in its own coordinates (m), with the centre of mass at the origin."""

import math
from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

from engine import validate
from engine.vector import Vector

ORIGIN = Vector(0.0, 0.0)
"""Centre of mass of every body, in its own frame (m)."""


@dataclass(frozen=True)
class Piece:
    """A convex part of a shape, as the tables keep it: the hull of some corners, rounded."""

    corners: tuple[Vector, ...]
    """One for a disc, two for a line, three and more, counter-clockwise, for a polygon (m)."""
    center: Vector = ORIGIN
    """A point inside, about which it is bounded (m)."""
    radius: float = 0.0
    """By which it is rounded (m)."""
    one_sided: bool = False
    """Whether a line stops only what comes from its left."""
    before: int = 0
    """Which piece of the shape joins the first corner of this link of a chain, from 1; 0: none."""
    after: int = 0
    """The same for the second corner."""


@dataclass(frozen=True)
class _Round:
    """What discs have in common, whether they turn or not."""

    radius: float
    """(m)"""

    def __post_init__(self) -> None:
        """Refuse a radius that is no positive number."""
        object.__setattr__(self, "radius", validate.positive(self.radius, "radius"))

    @property
    def area(self) -> float:
        """(m^2)"""
        return math.pi * self.radius * self.radius

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """The disc."""
        return (Piece((ORIGIN,), radius=self.radius),)


@dataclass(frozen=True)
class Circle(_Round):
    """A disc of uniform density, of some `radius` (m); it spins."""

    def inertia(self, mass: float) -> float:
        """Mass moment of inertia about the centre (kg m^2): m r^2 / 2."""
        return mass * self.radius * self.radius / 2.0


@dataclass(frozen=True)
class Particle(_Round):
    """A small round body of some `radius` (m) that never rotates: its inertia is infinite."""

    def inertia(self, mass: float) -> float:
        """Infinite, whatever the mass: no torque turns it."""
        del mass
        return math.inf


@dataclass(frozen=True)
class Polygon:
    """A convex polygon of uniform density.

    The vertices may come in any order; they are kept counter-clockwise, without duplicates and
    without those in the middle of a straight side, and moved so that the centroid is the origin.

    Raises:
        ValueError: for fewer than three vertices, no area, or vertices that are not all corners of
            their convex hull.
    """

    vertices: tuple[Vector, ...]
    """Counter-clockwise, about the centroid (m)."""
    area: float = field(init=False, compare=False)
    """(m^2)"""
    centroid: Vector = field(init=False, compare=False)
    """Where the centroid lay in the coordinates that were given (m)."""
    gyration: float = field(init=False, compare=False)
    """Mass moment of inertia about the centroid for 1 kg (m^2)."""

    def __init__(self, vertices: Iterable[Any]) -> None:
        """Take three or more corners as (x, y) pairs (m)."""
        if isinstance(vertices, str) or not isinstance(vertices, Iterable):
            raise TypeError(f"vertices must be pairs of numbers, not {vertices!r}")
        given = [validate.vector(v, f"vertices[{i}]") for i, v in enumerate(vertices)]
        corners = _hull(given)
        area, centroid = _area_and_centroid(corners)
        local = tuple(Vector(v.x - centroid.x, v.y - centroid.y) for v in corners)
        object.__setattr__(self, "vertices", local)
        object.__setattr__(self, "area", area)
        object.__setattr__(self, "centroid", centroid)
        object.__setattr__(self, "gyration", _gyration(local))

    @classmethod
    def regular(cls, sides: int, radius: float) -> "Polygon":
        """Make a regular polygon, its first corner on the +x axis, from its circumradius (m)."""
        count = validate.whole(sides, "sides", 3)
        size = validate.positive(radius, "radius")
        turn = 2.0 * math.pi / count
        return cls((size * math.cos(i * turn), size * math.sin(i * turn)) for i in range(count))

    @classmethod
    def box(cls, width: float, height: float) -> "Polygon":
        """Make an upright rectangle from its full width and height (m)."""
        x = validate.positive(width, "width") / 2.0
        y = validate.positive(height, "height") / 2.0
        return cls([(-x, -y), (x, -y), (x, y), (-x, y)])

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """The polygon."""
        return (Piece(self.vertices),)

    def inertia(self, mass: float) -> float:
        """Mass moment of inertia about the centroid (kg m^2)."""
        return mass * self.gyration


@dataclass(frozen=True)
class Wall:
    """An immovable straight wall without thickness, solid from both sides and at its ends.

    Its positive side is to the left of `start` -> `end`. A one-sided wall stops what comes from its
    positive side and lets through what comes from behind.
    """

    start: Vector
    """(m), in world coordinates."""
    end: Vector
    """(m), in world coordinates."""
    one_sided: bool = False

    def __init__(self, start: Any, end: Any, one_sided: bool = False) -> None:
        """Take two different points as (x, y) pairs (m, world coordinates)."""
        first, last = validate.vector(start, "start"), validate.vector(end, "end")
        if math.dist(first, last) <= 0.0:
            raise ValueError(f"a wall must have a length, but starts and ends at {tuple(first)}")
        object.__setattr__(self, "start", first)
        object.__setattr__(self, "end", last)
        object.__setattr__(self, "one_sided", bool(one_sided))

    @property
    def normal(self) -> Vector:
        """Unit vector to the positive side."""
        x, y = self.end.x - self.start.x, self.end.y - self.start.y
        length = math.sqrt(x * x + y * y)
        return Vector(-y / length, x / length)

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """The wall, in world coordinates."""
        return (Piece((self.start, self.end), self.middle, one_sided=self.one_sided),)

    @property
    def middle(self) -> Vector:
        """(m), in world coordinates."""
        return Vector((self.start.x + self.end.x) / 2.0, (self.start.y + self.end.y) / 2.0)


Shape = Circle | Particle | Polygon | Wall
"""Any of the four."""


def _turn(a: Vector, b: Vector, c: Vector) -> float:
    """Twice the area of the triangle, positive if a, b, c turn left (m^2)."""
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)


def _hull(given: list[Vector]) -> list[Vector]:
    """Convex hull, counter-clockwise from the first corner given (Andrew's monotone chain)."""
    points = sorted(set(given))
    if len(points) < 3:
        raise ValueError(f"a polygon needs at least 3 different vertices, not {len(points)}")
    width = max(p.x for p in points) - min(p.x for p in points)
    height = max(p.y for p in points) - min(p.y for p in points)
    flat = 1e-12 * (width * width + height * height)

    def chain(path: list[Vector]) -> list[Vector]:
        edge: list[Vector] = []
        for point in path:
            while len(edge) > 1 and _turn(edge[-2], edge[-1], point) <= flat:
                edge.pop()
            edge.append(point)
        return edge[:-1]

    hull = chain(points) + chain(points[::-1])
    if len(hull) < 3:
        raise ValueError("a polygon must have an area, but its vertices lie on one line")
    for point in points:
        turns = [_turn(hull[i - 1], hull[i], point) for i in range(len(hull))]
        if min(turns) > flat:
            raise ValueError(f"a polygon must be convex, but {tuple(point)} is no corner of it")
    first = next(hull.index(point) for point in given if point in hull)
    return hull[first:] + hull[:first]


def _area_and_centroid(corners: list[Vector]) -> tuple[float, Vector]:
    """Area (m^2) and centroid (m), by triangles about the first corner."""
    origin = corners[0]
    area = x = y = 0.0
    for b, c in pairwise(corners[1:]):
        triangle = _turn(origin, b, c) / 2.0
        area += triangle
        x += triangle * (b.x - origin.x + c.x - origin.x) / 3.0
        y += triangle * (b.y - origin.y + c.y - origin.y) / 3.0
    if not math.isfinite(area) or area <= 0.0:
        raise ValueError(f"a polygon must have an area that can be computed, not {area}")
    return area, Vector(origin.x + x / area, origin.y + y / area)


def _gyration(corners: tuple[Vector, ...]) -> float:
    """Second moment of area about the origin over the area (m^2), by triangles."""
    area = moment = 0.0
    for i in range(len(corners)):
        a, b = corners[i - 1], corners[i]
        cross = a.x * b.y - a.y * b.x
        area += cross / 2.0
        square = a.x * a.x + a.y * a.y + a.x * b.x + a.y * b.y + b.x * b.x + b.y * b.y
        moment += cross * square / 12.0
    return moment / area
