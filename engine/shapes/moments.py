"""Area, centroid and second moment of area of polygons, sharp and rounded.

The moments of a polygon are sums over the triangles that its sides make with the origin (Steger,
"On the calculation of arbitrary moments of polygons", 1996). A polygon that is rounded is itself, a
strip along each side and a sector at each corner.
"""

import math
from collections.abc import Sequence
from itertools import pairwise

from engine.vector import Vector


def area_and_centroid(corners: Sequence[Vector]) -> tuple[float, Vector]:
    """Area (m^2) and centroid (m) of a simple polygon, counter-clockwise.

    Raises:
        ValueError: if the area is none that can be computed.
    """
    origin = corners[0]
    area = x = y = 0.0
    for b, c in pairwise(corners[1:]):
        triangle = cross(origin, b, c) / 2.0
        area += triangle
        x += triangle * (b.x - origin.x + c.x - origin.x) / 3.0
        y += triangle * (b.y - origin.y + c.y - origin.y) / 3.0
    if not math.isfinite(area) or area <= 0.0:
        raise ValueError(f"a polygon must have an area that can be computed, not {area}")
    return area, Vector(origin.x + x / area, origin.y + y / area)


def gyration(corners: Sequence[Vector]) -> float:
    """Polar second moment of area about the origin over the area (m^2)."""
    area = moment = 0.0
    for i in range(len(corners)):
        a, b = corners[i - 1], corners[i]
        turn = a.x * b.y - a.y * b.x
        area += turn / 2.0
        square = a.x * a.x + a.y * a.y + a.x * b.x + a.y * b.y + b.x * b.x + b.y * b.y
        moment += turn * square / 12.0
    return moment / area


def rounded(corners: Sequence[Vector], radius: float) -> tuple[float, Vector, float]:
    """Area (m^2), centroid (m) and gyration about it (m^2) of a convex polygon grown by a radius.

    Args:
        corners: counter-clockwise.
        radius: (m)
    """
    inner, center = area_and_centroid(corners)
    local = [Vector(c.x - center.x, c.y - center.y) for c in corners]
    parts = [(inner, Vector(0.0, 0.0), gyration(local))]
    for i, corner in enumerate(local):
        before, after = local[i - 1], local[(i + 1) % len(local)]
        parts += [_strip(corner, after, radius), _sector(before, corner, after, radius)]
    area = math.fsum(part for part, _, _ in parts)
    x = math.fsum(part * at.x for part, at, _ in parts) / area
    y = math.fsum(part * at.y for part, at, _ in parts) / area
    about = math.fsum(
        part * (own + (at.x - x) * (at.x - x) + (at.y - y) * (at.y - y)) for part, at, own in parts
    )
    return area, Vector(center.x + x, center.y + y), about / area


Part = tuple[float, Vector, float]
"""Area (m^2), centroid (m) and gyration about it (m^2)."""


def _strip(start: Vector, end: Vector, width: float) -> Part:
    """The rectangle that stands outside of a side."""
    x, y = end.x - start.x, end.y - start.y
    length = math.sqrt(x * x + y * y)
    out = width / (2.0 * length)
    center = Vector((start.x + end.x) / 2.0 + y * out, (start.y + end.y) / 2.0 - x * out)
    return length * width, center, (length * length + width * width) / 12.0


def _sector(before: Vector, corner: Vector, after: Vector, radius: float) -> Part:
    """The sector between the strips of two sides: its centroid is 4 r sin(t/2)/(3 t) away."""
    in_x, in_y = corner.x - before.x, corner.y - before.y
    out_x, out_y = after.x - corner.x, after.y - corner.y
    turn = Vector(in_x * out_x + in_y * out_y, in_x * out_y - in_y * out_x).angle
    away = 4.0 * radius * Vector.polar(1.0, turn / 2.0).y / (3.0 * turn)
    way = Vector.polar(away, Vector(in_y, -in_x).angle + turn / 2.0)
    center = Vector(corner.x + way.x, corner.y + way.y)
    return radius * radius * turn / 2.0, center, radius * radius / 2.0 - away * away


def cross(a: Vector, b: Vector, c: Vector) -> float:
    """Twice the area of the triangle, positive if a, b, c turn left (m^2)."""
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
