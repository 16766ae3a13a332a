"""The convex parts of which all shapes are made."""

import math
from functools import cached_property
from typing import NamedTuple

from engine.vector import Vector, distance, rotated

ORIGIN = Vector(0.0, 0.0)
"""Centre of mass of every body, in its own frame (m)."""

ALIKE = 256
"""Of so many shapes the pieces are kept, as most bodies of a world are alike; they never change."""

CHORDS = 64
"""Straight lines that stand for a full circle in an outline."""


class Seam(NamedTuple):
    """What other pieces of the body leave of a corner of a piece and of the side from it on."""

    kind: int
    """Of the corner: `PLAIN`, `OWN`, `OTHERS` or `HIDDEN` of `Corners`."""
    low: Vector
    """Unit normals of the outline of all pieces, before and after the corner."""
    high: Vector
    start: float
    """From where to where along the side it is covered (m); if not at all, `start` > `end`."""
    end: float


class Measures(NamedTuple):
    """What follows from the corners of a piece."""

    normals: tuple[tuple[float, float], ...]
    """Of the side from each corner on: a unit vector outwards."""
    inner: float
    """Radius of a circle within, about the centre of the piece (m)."""
    outer: float
    """How far it reaches from the origin (m)."""


class _Hull(NamedTuple):
    """What a piece is made from."""

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
    seams: tuple[Seam, ...] = ()
    """One a corner, if other pieces of the body join this one."""


class Piece(_Hull):
    """A convex part of a shape, as the tables keep it: the hull of some corners, rounded."""

    def moved(self, offset: Vector, angle: float) -> "Piece":
        """The piece turned about the origin (rad), then shifted (m), without its seams."""
        return self._replace(
            seams=(),
            corners=tuple(turned(corner, offset, angle) for corner in self.corners),
            center=turned(self.center, offset, angle),
        )

    @property
    def reach(self) -> float:
        """Radius of a circle about the centre that holds it (m)."""
        return self.radius + max(distance(corner, self.center) for corner in self.corners)

    @cached_property
    def measures(self) -> Measures:
        """Kept, as bodies of one shape share it."""
        points, middle, inner = self.corners, self.center, math.inf
        normals = []
        for i, start in enumerate(points):
            end = points[(i + 1) % len(points)]
            x, y = end.x - start.x, end.y - start.y
            length = math.sqrt(x * x + y * y) or 1.0
            normals.append((y / length, -x / length))
            inner = min(inner, ((start.x - middle.x) * y - (start.y - middle.y) * x) / length)
        inner = self.radius + (inner if len(points) > 2 else 0.0)
        outer = self.radius + max(distance(point, ORIGIN) for point in points)
        return Measures(tuple(normals), inner, outer)

    @property
    def outline(self) -> tuple[Vector, ...]:
        """Its edge, counter-clockwise (m): arcs are chords with their ends on the arc."""
        if self.radius == 0.0:
            return self.corners
        edge: list[Vector] = []
        number = len(self.corners)
        for i, corner in enumerate(self.corners):
            start, turn = 0.0, 2.0 * math.pi
            if number > 1:
                start = _heading(self.corners[i - 1], corner) - math.pi / 2.0
                end = _heading(corner, self.corners[(i + 1) % number]) - math.pi / 2.0
                turn = (end - start) % (2.0 * math.pi)
            chords = max(1, math.ceil(CHORDS * turn / (2.0 * math.pi) - 1e-9))
            for k in range(chords + (number > 1)):
                out = Vector.polar(self.radius, start + turn * k / chords)
                edge.append(Vector(corner.x + out.x, corner.y + out.y))
        return tuple(edge)


def turned(point: Vector, offset: Vector, angle: float) -> Vector:
    """The point turned about the origin (rad), then shifted (m)."""
    here = rotated(point, angle)
    return Vector(offset.x + here.x, offset.y + here.y)


def _heading(start: Vector, end: Vector) -> float:
    return Vector(end.x - start.x, end.y - start.y).angle
