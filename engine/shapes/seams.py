"""Where the pieces of one body join: what of their sides and corners nothing outside can touch.

A side may be covered by other pieces. A corner belongs to the outline of all pieces together, which
arrives there along one side and leaves along another; the directions between their two normals are
the only ones in which it can be touched (its region in the Gauss map of the outline), and the piece
along whose side the outline arrives answers for them.
"""

import math
from collections.abc import Sequence

from engine.hulls import nearest_on_hull, sides
from engine.shapes.piece import Piece, Seam
from engine.tables.bodies import HIDDEN, OTHERS, OWN, PLAIN
from engine.vector import Vector, distance

OUT = 1e-6
"""How far outside of a side it is asked whether others are there, in reaches of the piece."""

NEAR = 1e-7
"""Distance that counts as none, in the same unit."""

SNAP = 1e-3
"""Share of a side that is too short to matter."""

EVEN = 1e-7
"""Angle that counts as none (rad)."""

FAR = 1e30
"""Beyond every end of a side (m)."""

BARE = (0.0, -1.0)
"""What is covered of a side that is not."""

FULL = 2.0 * math.pi


def sewn(pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    """The pieces of one body, each with its seams."""
    return tuple(_with_seams(piece, _neighbours(piece, pieces)) for piece in pieces)


def _neighbours(piece: Piece, pieces: Sequence[Piece]) -> list[Piece]:
    """The other pieces that may touch a sharp polygon; none for other pieces."""
    if piece.radius > 0.0 or len(piece.corners) < 3:
        return []
    return [
        other
        for other in pieces
        if other is not piece
        and distance(piece.center, other.center) <= (piece.reach + other.reach) * (1.0 + NEAR)
    ]


def _with_seams(piece: Piece, others: list[Piece]) -> Piece:
    seams = []
    number = len(piece.corners)
    for i in range(number if others else 0):
        kind, low, high = _corner(piece, i, others)
        start, end = _covered(piece.corners[i], piece.corners[(i + 1) % number], piece, others)
        seams.append(Seam(kind, low, high, start, end))
    plain = all(seam.kind == PLAIN and seam.start > seam.end for seam in seams)
    return piece if plain else piece._replace(seams=tuple(seams))


def _covered(start: Vector, end: Vector, piece: Piece, others: list[Piece]) -> tuple[float, float]:
    """From where to where a side is covered by others (m, from its start); `BARE` if it is not."""
    length = distance(start, end)
    along = Vector((end.x - start.x) / length, (end.y - start.y) / length)
    out = OUT * piece.reach
    origin = Vector(start.x + out * along.y, start.y - out * along.x)
    spans = sorted(_within(other, origin, along, length) for other in others)
    best, low, high = BARE, 0.0, -1.0
    for first, last in spans:
        if last <= first:
            continue
        if first <= high + SNAP * length:
            high = max(high, last)
        else:
            low, high = first, last
        if high - low > best[1] - best[0]:
            best = (low, high)
    if best[1] - best[0] < SNAP * length:
        return BARE
    return (
        -FAR if best[0] <= SNAP * length else best[0],
        FAR if best[1] >= (1.0 - SNAP) * length else best[1],
    )


def _within(piece: Piece, origin: Vector, along: Vector, length: float) -> tuple[float, float]:
    """From where to where a line of this length lies within a piece (m); `BARE` if it does not."""
    if piece.radius > 0.0 or len(piece.corners) < 3:
        return _within_round(piece, origin, along, length)
    low, high = 0.0, length
    for corner, normal, _ in sides(list(piece.corners)):
        height = (origin.x - corner.x) * normal.x + (origin.y - corner.y) * normal.y
        rise = along.x * normal.x + along.y * normal.y
        if abs(rise) < EVEN:
            if height > 0.0:
                return BARE
        elif rise > 0.0:
            high = min(high, -height / rise)
        else:
            low = max(low, -height / rise)
    return (low, high) if low < high else BARE


def _within_round(
    piece: Piece, origin: Vector, along: Vector, length: float
) -> tuple[float, float]:
    """The same for a rounded piece: its distance is a convex function of the way."""

    def depth(way: float) -> float:
        point = Vector(origin.x + way * along.x, origin.y + way * along.y)
        return nearest_on_hull(list(piece.corners), point)[0] - piece.radius

    low, high = 0.0, length
    for _ in range(80):
        one, other = low + (high - low) / 3.0, high - (high - low) / 3.0
        low, high = (low, other) if depth(one) < depth(other) else (one, high)
    deepest = (low + high) / 2.0
    if depth(deepest) > 0.0:
        return BARE
    ends = []
    for end in (0.0, length):
        inside, outside = deepest, end
        for _ in range(60 if depth(end) > 0.0 else 0):
            middle = (inside + outside) / 2.0
            inside, outside = (middle, outside) if depth(middle) <= 0.0 else (inside, middle)
        ends.append(inside if depth(end) > 0.0 else end)
    return ends[0], ends[1]


def _corner(piece: Piece, i: int, others: list[Piece]) -> tuple[int, Vector, Vector]:
    """What a corner is, and the normals of the outline before and after it."""
    at, near = piece.corners[i], NEAR * piece.reach
    first, width = _sector(piece, at, near)
    spans = [(first, width)] + [_sector(other, at, near) for other in others]
    low, high = first, first + width
    grown = True
    while grown:
        grown = False
        for start, wide in spans:
            for shift in (-FULL, 0.0, FULL):
                one, other = start + shift, start + shift + wide
                if wide > 0.0 and one <= high + EVEN and other >= low - EVEN:
                    if one < low - EVEN or other > high + EVEN:
                        low, high, grown = min(low, one), max(high, other), True
                    if high - low >= FULL - EVEN:
                        return HIDDEN, Vector(0.0, 0.0), Vector(0.0, 0.0)
    arrives = abs(high - first - width) <= EVEN
    leaves = abs(low - first) <= EVEN
    kind = PLAIN if arrives and leaves else (OWN if arrives else OTHERS)
    before, after = high + math.pi / 2.0, low - math.pi / 2.0
    return (
        kind,
        Vector.polar(1.0, before),
        Vector.polar(1.0, after),
    )


def _sector(piece: Piece, at: Vector, near: float) -> tuple[float, float]:
    """Directions from a point into a piece: from which angle on, and how far (rad)."""
    corners = piece.corners
    depth, normal = nearest_on_hull(list(corners), at)
    depth -= piece.radius
    if depth > near:
        return 0.0, 0.0
    if depth < -near:
        return 0.0, FULL
    if piece.radius == 0.0:
        for i, corner in enumerate(corners):
            if distance(corner, at) <= near:
                after, before = corners[(i + 1) % len(corners)], corners[i - 1]
                start = Vector(after.x - corner.x, after.y - corner.y).angle
                end = Vector(before.x - corner.x, before.y - corner.y).angle
                return start, (end - start) % FULL
    return normal.angle + math.pi / 2.0, math.pi
