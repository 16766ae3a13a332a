"""Geometry of convex hulls rounded by a radius, as queries need it: distance, ray, sum.

A hull is a list of corners, counter-clockwise: one for a disc, two for a line, three and more for a
polygon. A shape that moves past another meets it where its centre meets the Minkowski sum of the
one and the mirrored other, so that casting a shape is casting a ray (Ericson, "Real-Time Collision
Detection", 2005, section 5.5.7).
"""

import math

from engine.vector import Vector

Hull = list[Vector]

GRAZE = 1e-12
"""Share of a side by which it is longer for rays: none slips through between two sides."""

FLAT = 1e-9
"""A side that leans by less than this (rad) faces what touches it as a whole."""

ROUNDING = 1e-15
"""Error of corners that were placed in the world, as a share of where they are."""


def nearest_on_hull(hull: Hull, p: Vector) -> tuple[float, Vector]:
    """Signed distance (m) of a point from a sharp hull, negative inside, and the normal there.

    The normal is the unit vector from the nearest point of the surface outwards.
    """
    depth = -math.inf
    out = Vector(1.0, 0.0)
    for start, normal, _ in sides(hull):
        height = (p.x - start.x) * normal.x + (p.y - start.y) * normal.y
        if height > depth:
            depth, out = height, normal
    if len(hull) > 2 and depth <= 0.0:
        return depth, out
    nearest = math.inf
    for i, start in enumerate(hull):
        at = nearest_on_line(start, hull[(i + 1) % len(hull)], p)
        distance = length(p.x - at.x, p.y - at.y)
        if distance < nearest:
            nearest = distance
            if distance > 0.0:
                out = Vector((p.x - at.x) / distance, (p.y - at.y) / distance)
    return nearest, out


def sides(hull: Hull) -> list[tuple[Vector, Vector, float]]:
    """Start, outward unit normal and length of each side; a line has two, a disc none."""
    found = []
    for i, start in enumerate(hull):
        end = hull[(i + 1) % len(hull)]
        x, y = end.x - start.x, end.y - start.y
        long = length(x, y)
        if long > 0.0:
            found.append((start, Vector(y / long, 0.0 - x / long), long))  # no -0.0
    return found


def nearest_on_line(a: Vector, b: Vector, p: Vector) -> Vector:
    """The point nearest to p of the line from a to b."""
    x, y = b.x - a.x, b.y - a.y
    square = x * x + y * y
    share = ((p.x - a.x) * x + (p.y - a.y) * y) / square if square > 0.0 else 0.0
    if share <= 0.0:
        return a
    if share >= 1.0:
        return b
    return Vector(a.x + share * x, a.y + share * y)


def ray_to_hull(hull: Hull, radius: float, start: Vector, way: Vector) -> tuple[float, Vector]:
    """Share of its way after which a ray enters a rounded hull, and the normal there.

    Infinite if it does not, and for a line without radius along which it goes; zero, with the
    normal at the nearest surface, if it starts inside.
    """
    distance, normal = nearest_on_hull(hull, start)
    if distance <= radius:
        return 0.0, normal
    first, out = math.inf, normal
    for corner, normal, long in sides(hull):
        into = -(way.x * normal.x + way.y * normal.y)
        x, y = start.x - corner.x, start.y - corner.y
        height = x * normal.x + y * normal.y - radius
        if into > 0.0 and 0.0 <= height < first * into:
            share = height / into
            along = (y + share * way.y) * normal.x - (x + share * way.x) * normal.y
            if -GRAZE * long <= along <= (1.0 + GRAZE) * long and share <= 1.0:
                first, out = share, normal
    for corner in hull if radius > 0.0 else []:
        share = ray_to_circle(corner, radius, start, way)
        if share < first:
            x, y = start.x + share * way.x - corner.x, start.y + share * way.y - corner.y
            far = length(x, y)
            first, out = share, Vector(x / far, y / far) if far > 0.0 else out
    return first, out


def ray_to_circle(center: Vector, radius: float, start: Vector, way: Vector) -> float:
    """Share of its way after which a ray from outside enters a circle; infinite if never."""
    x, y = start.x - center.x, start.y - center.y
    closing = -(x * way.x + y * way.y)
    square = way.x * way.x + way.y * way.y
    room = x * x + y * y - radius * radius
    aside = x * way.y - y * way.x
    root = square * radius * radius - aside * aside
    if closing <= 0.0 or root < 0.0:
        return math.inf
    share = room / (closing + math.sqrt(root))
    return share if share <= 1.0 else math.inf


def difference(hull: Hull, other: Hull) -> Hull:
    """Minkowski sum of a hull and another mirrored at the origin: hull - other."""
    return convex_hull([Vector(p.x - q.x, p.y - q.y) for p in hull for q in other])


def convex_hull(points: Hull) -> Hull:
    """Convex hull, counter-clockwise (Andrew's monotone chain, 1979)."""
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return ordered

    def chain(path: Hull) -> Hull:
        edge: Hull = []
        for point in path:
            while len(edge) > 1 and turn(edge[-2], edge[-1], point) <= 0.0:
                edge.pop()
            edge.append(point)
        return edge[:-1]

    return chain(ordered) + chain(ordered[::-1])


def touching_point(hull: Hull, radius: float, other: Hull, normal: Vector) -> Vector:
    """Where a rounded hull is touched by another that lies on its side of the unit normal.

    Between two flat sides: the middle of where they overlap. On the surface of the first.
    """
    base = hull[0]  # so that how far from the origin they are does not matter
    rounding = ROUNDING * (abs(base.x) + abs(base.y))
    own, its = seen_from(base, hull), seen_from(base, other)
    height, low, high = farthest_side(own, normal, rounding)
    _, other_low, other_high = farthest_side(its, Vector(-normal.x, -normal.y), rounding)
    low, high = max(low, -other_high), min(high, -other_low)
    along, out = (low + high) / 2.0, height + radius
    return Vector(
        base.x + out * normal.x - along * normal.y, base.y + out * normal.y + along * normal.x
    )


def seen_from(base: Vector, hull: Hull) -> Hull:
    """Corners of a hull as they lie from a point (m)."""
    return [Vector(p.x - base.x, p.y - base.y) for p in hull]


def farthest_side(hull: Hull, normal: Vector, rounding: float) -> tuple[float, float, float]:
    """How far a hull, whose corners have errors of `rounding` (m), reaches along a unit vector,
    and from where to where across it (m).
    """
    heights = [p.x * normal.x + p.y * normal.y for p in hull]
    highest = max(heights)
    size = max(abs(p.x - hull[0].x) + abs(p.y - hull[0].y) for p in hull)
    level = highest - FLAT * size - rounding
    across = [
        p.y * normal.x - p.x * normal.y
        for p, height in zip(hull, heights, strict=True)
        if height >= level
    ]
    return highest, min(across), max(across)


def turn(a: Vector, b: Vector, c: Vector) -> float:
    """Twice the area of the triangle, positive if a, b, c turn left (m^2)."""
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)


def length(x: float, y: float) -> float:
    """Of a vector; by a root alone, so that it is the same on every machine."""
    return math.sqrt(x * x + y * y)
