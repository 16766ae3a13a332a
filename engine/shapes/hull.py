"""The convex hull of some points, and whether they are all corners of it.

A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
"""

from engine.shapes.moments import cross
from engine.vector import Vector

MOST_VERTICES = 4096
"""Vertices of a polygon."""

FLAT = 1e-12
"""Twice the area of a triangle that counts as none, as a share of the square of the diameter."""


def corners_in_order(given: list[Vector]) -> list[Vector]:
    """Corners of the convex hull, counter-clockwise from the first of them that was given.

    Raises:
        ValueError: for fewer than three points, points on one line, and points inside.
    """
    points = sorted(set(given))
    if len(points) < 3:
        raise ValueError(f"a polygon needs at least 3 different vertices, not {len(points)}")
    flat = flatness(points)
    lower, upper = _chain(points, flat), _chain(points[::-1], flat)
    hull = lower[:-1] + upper[:-1]
    if len(hull) < 3:
        raise ValueError("a polygon must have an area, but its vertices lie on one line")
    for point in _points_inside(points, lower, upper[::-1], flat):
        raise ValueError(
            f"a polygon must be convex, but {tuple(point)} is no corner of it: "
            "Polygon.concave takes others"
        )
    places = {corner: i for i, corner in enumerate(hull)}
    first = next(places[point] for point in given if point in places)
    return hull[first:] + hull[:first]


def flatness(points: list[Vector]) -> float:
    """Twice the area of a triangle that counts as none among these points (m^2)."""
    width = max(p.x for p in points) - min(p.x for p in points)
    height = max(p.y for p in points) - min(p.y for p in points)
    return FLAT * (width * width + height * height)


def _chain(path: list[Vector], flat: float) -> list[Vector]:
    """The corners along a path that turns left only, its ends included."""
    edge: list[Vector] = []
    for point in path:
        while len(edge) > 1 and cross(edge[-2], edge[-1], point) <= flat:
            edge.pop()
        edge.append(point)
    return edge


def _points_inside(
    points: list[Vector], lower: list[Vector], upper: list[Vector], flat: float
) -> list[Vector]:
    """The points, sorted, that lie on neither of two edges from the left end to the right one."""
    inside = []
    below = above = 0
    for point in points:
        while lower[below + 1].x < point.x:
            below += 1
        while upper[above + 1].x < point.x:
            above += 1
        on_lower = cross(lower[below], lower[below + 1], point) <= flat
        on_upper = cross(upper[above], upper[above + 1], point) >= -flat
        if points[0].x < point.x < points[-1].x and not on_lower and not on_upper:
            inside.append(point)
    return inside
