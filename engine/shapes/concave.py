"""Polygons that need not be convex: several convex pieces that are one body.

How they are divided and sewn together is imported where it is called: most worlds need neither.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from engine import validate
from engine.shapes.moments import area_and_centroid, gyration
from engine.shapes.piece import Piece
from engine.vector import Vector

MOST_VERTICES = 1000
"""Vertices of a polygon that need not be convex."""


@dataclass(frozen=True)
class Concave:
    """A simple polygon of uniform density that need not be convex; no side crosses another.

    The vertices are its corners in sequence, either way round. They are kept counter-clockwise,
    without duplicates and without those in the middle of a straight side, and moved so that the
    centroid is the origin. For collisions it is divided into convex parts.

    Raises:
        ValueError: for fewer than three vertices, more than 1000, no area, or sides that cross or
            touch each other.
    """

    vertices: tuple[Vector, ...]
    """The outline, counter-clockwise, about the centroid (m)."""
    parts: tuple[tuple[Vector, ...], ...] = field(init=False, compare=False, repr=False)
    """The convex polygons of which it is made, each counter-clockwise (m)."""
    area: float = field(init=False, compare=False, repr=False)
    """(m^2)"""
    centroid: Vector = field(init=False, compare=False, repr=False)
    """Where the centroid lay in the coordinates that were given (m)."""
    gyration: float = field(init=False, compare=False, repr=False)
    """Mass moment of inertia about the centroid for 1 kg (m^2)."""

    def __init__(self, vertices: Iterable[Any]) -> None:
        """Take three or more corners in sequence as (x, y) pairs (m)."""
        from engine.shapes.division import convex_parts, simple_corners

        corners = simple_corners(validate.vectors(vertices, "vertices", MOST_VERTICES))
        area, centroid = area_and_centroid(corners)
        local = tuple(Vector(v.x - centroid.x, v.y - centroid.y) for v in corners)
        object.__setattr__(self, "vertices", local)
        object.__setattr__(self, "parts", tuple(tuple(p) for p in convex_parts(local)))
        object.__setattr__(self, "area", area)
        object.__setattr__(self, "centroid", centroid)
        object.__setattr__(self, "gyration", gyration(local))

    def __str__(self) -> str:
        """Say how many vertices it has; `repr` lists them."""
        return f"Concave of {len(self.vertices)} vertices"

    @cached_property
    def pieces(self) -> tuple[Piece, ...]:
        """The convex parts."""
        from engine.shapes.seams import sewn

        return sewn([Piece(part, area_and_centroid(part)[1]) for part in self.parts])

    def inertia(self, mass: float) -> float:
        """Mass moment of inertia about the centroid (kg m^2)."""
        return mass * self.gyration
