"""A simple polygon divided into convex ones.

Ears are cut off one after the other (G. H. Meisters, "Polygons have ears", 1975), then diagonals
that are not needed are taken out again (S. Hertel and K. Mehlhorn, "Fast triangulation of simple
polygons", 1983): what remains is at most four times as many parts as there need be.
"""

from collections.abc import Sequence
from itertools import pairwise

from engine.shapes.hull import flatness
from engine.shapes.moments import cross
from engine.vector import Vector


def simple_corners(given: list[Vector]) -> list[Vector]:
    """The corners in sequence, counter-clockwise, without any that are none.

    Raises:
        ValueError: for fewer than three corners, and sides that cross or touch each other.
    """
    if len(set(given)) < 3:
        raise ValueError(f"a polygon needs at least 3 different vertices, not {len(set(given))}")
    flat = flatness(given)
    corners = [p for i, p in enumerate(given) if p != given[i - 1]]
    i = 0
    while i < len(corners) and len(corners) > 2:
        before, corner, after = corners[i - 1], corners[i], corners[(i + 1) % len(corners)]
        if abs(cross(before, corner, after)) <= flat and _along(before, corner, after) >= 0.0:
            del corners[i]
            i = max(0, i - 1)
        else:
            i += 1
    if len(corners) < 3:
        raise ValueError("a polygon must have an area, but its vertices lie on one line")
    _refuse_crossings(corners)
    twice = sum(cross(corners[0], b, c) for b, c in pairwise(corners[1:]))
    return corners if twice > 0.0 else [corners[0], *corners[:0:-1]]


def convex_parts(corners: Sequence[Vector]) -> list[list[Vector]]:
    """Convex polygons that together are the simple polygon; all counter-clockwise."""
    parts = _triangles(corners)
    flat = flatness(list(corners))
    sides = {side: k for k, part in enumerate(parts) for side in _sides(part)}
    for a, b in list(sides):
        one, other = sides.get((a, b)), sides.get((b, a))
        if one is None or other is None:
            continue
        merged = _merged(parts[one], parts[other], a, b)
        if all(_is_convex(corners, merged, v, flat) for v in (a, b)):
            parts[one], parts[other] = merged, []
            for side in _sides(merged):
                sides[side] = one
            del sides[a, b], sides[b, a]
    return [[corners[v] for v in part] for part in parts if part]


def _triangles(corners: Sequence[Vector]) -> list[list[int]]:
    """Cut off ears until a triangle is left; the numbers are those of corners."""
    left = list(range(len(corners)))
    found = []
    at = 0
    missed = 0
    while len(left) > 3:
        before, ear, after = left[at - 1], left[at], left[(at + 1) % len(left)]
        if _is_ear(corners, left, before, ear, after):
            found.append([before, ear, after])
            del left[at]
            missed = 0
            at = at % len(left)
        else:
            missed += 1
            at = (at + 1) % len(left)
        if missed > len(left):
            raise ValueError("a polygon must be wide enough to be divided, but this one is not")
    return [*found, left]


def _is_ear(corners: Sequence[Vector], left: list[int], before: int, ear: int, after: int) -> bool:
    """Whether the triangle lies inside of what is left, with no corner in it."""
    a, b, c = corners[before], corners[ear], corners[after]
    if cross(a, b, c) <= 0.0:
        return False
    for v in left:
        if v in (before, ear, after):
            continue
        p = corners[v]
        if cross(a, b, p) >= 0.0 and cross(b, c, p) >= 0.0 and cross(c, a, p) >= 0.0:
            return False
    return True


def _sides(part: list[int]) -> list[tuple[int, int]]:
    return [(part[i - 1], part[i]) for i in range(len(part))]


def _merged(one: list[int], other: list[int], a: int, b: int) -> list[int]:
    """Two parts without the side that they share: it goes from a to b in the first of them."""
    i, j = one.index(b), other.index(a)
    from_b = one[i:] + one[:i]
    from_a = other[j:] + other[:j]
    return from_b + from_a[1:-1]


def _is_convex(corners: Sequence[Vector], part: list[int], v: int, flat: float) -> bool:
    """Whether a part turns left at one of its corners."""
    i = part.index(v)
    return cross(corners[part[i - 1]], corners[v], corners[part[(i + 1) % len(part)]]) > flat


def _along(a: Vector, b: Vector, c: Vector) -> float:
    return (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y)


def _refuse_crossings(corners: list[Vector]) -> None:
    """Refuse sides that meet anywhere but at the corner that they share."""
    number = len(corners)
    sides = [(corners[i], corners[(i + 1) % number]) for i in range(number)]
    order = sorted(range(number), key=lambda i: (min(sides[i][0].x, sides[i][1].x), i))
    for rank, i in enumerate(order):
        right = max(sides[i][0].x, sides[i][1].x)
        for j in order[rank + 1 :]:
            if min(sides[j][0].x, sides[j][1].x) > right:
                break
            if (i - j) % number in (1, number - 1):
                first, second = (i, j) if (j - i) % number == 1 else (j, i)
                if _folds_back(*sides[first], sides[second][1]):
                    raise ValueError(f"a polygon must not fold back at {tuple(sides[second][0])}")
            elif _meet(*sides[i], *sides[j]):
                raise ValueError(
                    f"the sides of a polygon must not cross or touch, but those from "
                    f"{tuple(sides[i][0])} and {tuple(sides[j][0])} do"
                )


def _folds_back(a: Vector, b: Vector, c: Vector) -> bool:
    return cross(a, b, c) == 0.0 and _along(a, b, c) < 0.0


def _meet(a: Vector, b: Vector, c: Vector, d: Vector) -> bool:
    """Whether the segments a-b and c-d have a point in common."""
    of_c, of_d = cross(a, b, c), cross(a, b, d)
    of_a, of_b = cross(c, d, a), cross(c, d, b)
    if of_c * of_d < 0.0 and of_a * of_b < 0.0:
        return True
    ends = ((of_c, a, b, c), (of_d, a, b, d), (of_a, c, d, a), (of_b, c, d, b))
    return any(turn == 0.0 and _between(start, end, point) for turn, start, end, point in ends)


def _between(a: Vector, b: Vector, point: Vector) -> bool:
    """Whether a point on the line through a and b lies between them."""
    return min(a.x, b.x) <= point.x <= max(a.x, b.x) and min(a.y, b.y) <= point.y <= max(a.y, b.y)
