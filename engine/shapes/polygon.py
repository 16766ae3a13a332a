"""Convex polygons, with sharp or rounded corners."""

import math
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from typing import Any, cast

from engine import validate
from engine.shapes.concave import Concave
from engine.shapes.hull import MOST_VERTICES, corners_in_order
from engine.shapes.moments import area_and_centroid, gyration, rounded
from engine.shapes.piece import ALIKE, Piece
from engine.vector import Vector


@dataclass(frozen=True)
class Polygon:
    """A convex polygon of uniform density, its corners sharp or rounded.

    The vertices may come in any order; they are kept counter-clockwise, without duplicates and
    without those in the middle of a straight side, and moved so that the centroid is the origin.
    `rounding` makes the polygon grow in all directions: its sides move out by it, and each corner
    becomes an arc of that radius about the vertex.

    Raises:
        ValueError: for fewer than three vertices, more than 4096, no area, or vertices that are not
            all corners of their convex hull.
    """

    vertices: tuple[Vector, ...]
    """Counter-clockwise, about the centroid (m); of the polygon before it is rounded."""
    rounding: float = 0.0
    """(m)"""
    area: float = field(init=False, compare=False, repr=False)
    """(m^2)"""
    centroid: Vector = field(init=False, compare=False, repr=False)
    """Where the centroid lay in the coordinates that were given (m)."""
    gyration: float = field(init=False, compare=False, repr=False)
    """Mass moment of inertia about the centroid for 1 kg (m^2)."""

    def __init__(self, vertices: Iterable[Any], rounding: float = 0.0) -> None:
        """Take three or more corners as (x, y) pairs (m), and by how much they are rounded (m)."""
        corners = corners_in_order(validate.vectors(vertices, "vertices", MOST_VERTICES))
        radius = validate.not_negative(rounding, "rounding")
        if radius == 0.0:
            area, centroid = area_and_centroid(corners)
        else:
            area, centroid, own = rounded(corners, radius)
        local = tuple(Vector(v.x - centroid.x, v.y - centroid.y) for v in corners)
        object.__setattr__(self, "vertices", local)
        object.__setattr__(self, "rounding", radius)
        object.__setattr__(self, "area", area)
        object.__setattr__(self, "centroid", centroid)
        object.__setattr__(self, "gyration", gyration(local) if radius == 0.0 else own)

    def __str__(self) -> str:
        """Say how many vertices it has; `repr` lists them."""
        return f"Polygon of {len(self.vertices)} vertices"

    @classmethod
    def regular(cls, sides: int, radius: float, rounding: float = 0.0) -> "Polygon":
        """Make a regular polygon, its first corner on the +x axis, from its circumradius (m)."""
        count = validate.whole(sides, "sides", 3)
        if count > MOST_VERTICES:
            raise ValueError(f"sides must be at most {MOST_VERTICES}, not {count}")
        size = validate.positive(radius, "radius")
        return _regular(cast(Any, cls), count, size, validate.not_negative(rounding, "rounding"))

    @classmethod
    def box(cls, width: float, height: float, rounding: float = 0.0) -> "Polygon":
        """Make an upright rectangle from its full width and height (m), before it is rounded."""
        x = validate.positive(width, "width") / 2.0
        y = validate.positive(height, "height") / 2.0
        return _upright(cast(Any, cls), x, y, validate.not_negative(rounding, "rounding"))

    @staticmethod
    def concave(vertices: Iterable[Any]) -> Concave:
        """Make a polygon that need not be convex; its vertices stand in sequence: see `Concave`."""
        return Concave(vertices)

    @cached_property
    def pieces(self) -> tuple[Piece, ...]:
        """The polygon."""
        if self.rounding == 0.0:
            return (Piece(self.vertices),)
        _, center = area_and_centroid(self.vertices)
        return (Piece(self.vertices, center, self.rounding),)

    def inertia(self, mass: float) -> float:
        """Mass moment of inertia about the centroid (kg m^2)."""
        return mass * self.gyration


@dataclass(frozen=True)
class Box:
    """An upright rectangle of uniform density, from its full width and height (m).

    `rounding` makes it grow in all directions, as with `Polygon`.
    """

    width: float
    """(m)"""
    height: float
    """(m)"""
    rounding: float = 0.0
    """(m)"""

    def __post_init__(self) -> None:
        """Refuse what is no positive number."""
        object.__setattr__(self, "width", validate.positive(self.width, "width"))
        object.__setattr__(self, "height", validate.positive(self.height, "height"))
        object.__setattr__(self, "rounding", validate.not_negative(self.rounding, "rounding"))

    @property
    def vertices(self) -> tuple[Vector, ...]:
        """Counter-clockwise from the lower left one (m); of the rectangle before it is rounded."""
        return self.pieces[0].corners

    @property
    def area(self) -> float:
        """(m^2)"""
        if self.rounding == 0.0:
            return self.width * self.height
        return _rounded_rectangle(self.width / 2.0, self.height / 2.0, self.rounding)[0]

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """The rectangle."""
        return _rectangle(self.width / 2.0, self.height / 2.0, self.rounding)

    def inertia(self, mass: float) -> float:
        """Mass moment of inertia about the centre (kg m^2): m (w^2 + h^2) / 12 if it is sharp."""
        if self.rounding == 0.0:
            return mass * (self.width * self.width + self.height * self.height) / 12.0
        return mass * _rounded_rectangle(self.width / 2.0, self.height / 2.0, self.rounding)[2]


@lru_cache(ALIKE)
def _regular(kind: type[Polygon], sides: int, radius: float, rounding: float) -> Polygon:
    """A polygon with corners on a circle: the same for all that are alike."""
    turn = 2.0 * math.pi / sides
    return kind((Vector.polar(radius, i * turn) for i in range(sides)), rounding)


@lru_cache(ALIKE)
def _upright(kind: type[Polygon], x: float, y: float, rounding: float) -> Polygon:
    """An upright rectangle from half its width and height: the same for all that are alike."""
    return kind([(-x, -y), (x, -y), (x, y), (-x, y)], rounding)


@lru_cache(ALIKE)
def _rectangle(x: float, y: float, rounding: float) -> tuple[Piece, ...]:
    """The piece of a box."""
    return (Piece((Vector(-x, -y), Vector(x, -y), Vector(x, y), Vector(-x, y)), radius=rounding),)


@lru_cache(ALIKE)
def _rounded_rectangle(x: float, y: float, rounding: float) -> tuple[float, Vector, float]:
    """What `rounded` says of a box."""
    return rounded(_rectangle(x, y, rounding)[0].corners, rounding)
