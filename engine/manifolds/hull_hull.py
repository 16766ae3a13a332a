"""Polygon, capsule or wall against each other: separating axes (thesis, eq. 30-31), then clipping.

Two convex hulls are apart if and only if a side of one of them has all of the other in front of it.
The side that sees the other furthest out is the reference side; the side of the other that faces
it most is the incident one, and it is clipped by the ends of the reference side (Sutherland and
Hodgman): what remains of it lies in front of or behind the reference side by the contact's gap.

Hulls that are rounded touch when their cores, the hulls of the corners, are as far apart as both
radii together. Where cores that are apart do not face each other with a side, the two corners that
are closest do: the gap is then the true distance, so that round corners meet when they should.
"""

import math

from engine.tables import Corners, Pieces, Touch

NEAR = 1e-6
"""By so much more, in shares of the separation of the cores, a side that faces may be away: then
sides that are all but parallel have two points, and the gap errs by that."""


def furthest_side(
    pieces: Pieces, corners: Corners, a: int, b: int, least: float
) -> tuple[float, int]:
    """The side of hull `a` that sees hull `b` furthest out: its separation (m) and its row.

    Sides that cannot reach `least` are left early; if none does, the separation is below `least`.
    """
    first_a = pieces.first[a]
    first_b = pieces.first[b]
    end_b = first_b + pieces.corners[b]
    best = -1e300
    side = first_a
    for i in range(first_a, first_a + pieces.corners[a]):
        normal_x = corners.world_normal_x[i]
        normal_y = corners.world_normal_y[i]
        base = normal_x * corners.world_x[i] + normal_y * corners.world_y[i]
        bound = (best if best > least else least) + base
        lowest = 1e300
        for j in range(first_b, end_b):
            height = normal_x * corners.world_x[j] + normal_y * corners.world_y[j]
            if height < lowest:
                lowest = height
                if lowest <= bound:
                    break
        if lowest - base > best:
            best = lowest - base
            side = i
    return best, side


def hull_hull_gap(pieces: Pieces, corners: Corners, touch: Touch, a: int, b: int) -> float:
    """Separation of two placed hulls along the best axis (m): at most their distance.

    If one of them is rounded it is their distance; `Touch` is then written over.
    """
    of_a, side_a = furthest_side(pieces, corners, a, b, -1e300)
    of_b, side_b = furthest_side(pieces, corners, b, a, of_a)
    best = of_b if of_b > of_a else of_a
    rounding = pieces.radius[a] + pieces.radius[b]
    if rounding == 0.0 or best <= 0.0:
        return best - rounding
    if of_b > of_a:
        points = clip(pieces, corners, touch, b, a, side_b)
    else:
        points = clip(pieces, corners, touch, a, b, side_a)
    if faces(touch, points, best - rounding + NEAR * best):
        return best - rounding
    distance, _, _ = closest_corners(pieces, corners, a, b)
    return distance - rounding


def hull_hull(pieces: Pieces, corners: Corners, touch: Touch, a: int, b: int, tie: float) -> int:
    """Write the one or two points where two placed hulls are closest; return their number.

    A side of b is the reference only if it sees a further out than any of a sees b by `tie` (m).
    """
    of_a, side_a = furthest_side(pieces, corners, a, b, -1e300)
    of_b, side_b = furthest_side(pieces, corners, b, a, of_a + tie)
    if of_b > of_a + tie:
        points = clip_other(pieces, corners, touch, a, b, side_b)
        best = of_b
    else:
        points = clip(pieces, corners, touch, a, b, side_a)
        best = of_a
    rounding = pieces.radius[a] + pieces.radius[b]
    if rounding == 0.0 or best <= 0.0:
        return points
    if faces(touch, points, best - rounding + NEAR * best + 2.0 * tie):
        return points
    return join_corners(pieces, corners, touch, a, b)


def faces(touch: Touch, points: int, within: float) -> bool:
    """Whether what was clipped has a point with a gap `within` that of the separation (m)."""
    if points == 0:
        return False
    lowest = touch.gap[0]
    if points == 2 and touch.gap[1] < lowest:
        lowest = touch.gap[1]
    return lowest <= within


def closest_corners(pieces: Pieces, corners: Corners, a: int, b: int) -> tuple[float, int, int]:
    """Distance (m) of the closest corners of two placed hulls, and their rows."""
    first_a = pieces.first[a]
    first_b = pieces.first[b]
    corner_a = first_a
    corner_b = first_b
    least = 1e300
    for i in range(first_a, first_a + pieces.corners[a]):
        for j in range(first_b, first_b + pieces.corners[b]):
            x = corners.world_x[j] - corners.world_x[i]
            y = corners.world_y[j] - corners.world_y[i]
            square = x * x + y * y
            if square < least:
                least = square
                corner_a = i
                corner_b = j
    return math.sqrt(least), corner_a, corner_b


def join_corners(pieces: Pieces, corners: Corners, touch: Touch, a: int, b: int) -> int:
    """Write the point between the closest corners of two placed hulls that are apart; return 1."""
    distance, i, j = closest_corners(pieces, corners, a, b)
    normal_x = (corners.world_x[j] - corners.world_x[i]) / distance
    normal_y = (corners.world_y[j] - corners.world_y[i]) / distance
    gap = distance - pieces.radius[a] - pieces.radius[b]
    out = pieces.radius[a] + gap / 2.0
    touch.x[0] = corners.world_x[i] + out * normal_x
    touch.y[0] = corners.world_y[i] + out * normal_y
    touch.gap[0] = gap
    touch.normal_x[0] = normal_x
    touch.normal_y[0] = normal_y
    touch.feature[0] = (i - pieces.first[a]) * 4096 + (j - pieces.first[b])
    return 1


def clip_other(pieces: Pieces, corners: Corners, touch: Touch, a: int, b: int, side: int) -> int:
    """Clip by a side of b, and turn round what that writes: normals point from a to b, a feature is
    (corner of a, corner of b), whoever is the reference.
    """
    points = clip(pieces, corners, touch, b, a, side)
    touch.normal_x[0] = -touch.normal_x[0]
    touch.normal_y[0] = -touch.normal_y[0]
    for i in range(points):
        reference = touch.feature[i] // 4096
        touch.feature[i] = (touch.feature[i] - reference * 4096) * 4096 + reference
    return points


def clip(
    pieces: Pieces, corners: Corners, touch: Touch, reference: int, incident: int, side: int
) -> int:
    """Clip the incident side by the ends of the reference side; write what remains of it.

    Where nothing remains, a corner faces a corner: one point for sharp hulls, none for rounded
    ones, nor for the links of a chain.
    """
    first = pieces.first[reference]
    following = side + 1 if side + 1 < first + pieces.corners[reference] else first
    normal_x = corners.world_normal_x[side]
    normal_y = corners.world_normal_y[side]
    start_x = corners.world_x[side]
    start_y = corners.world_y[side]
    length = (corners.world_y[following] - start_y) * normal_x - (
        corners.world_x[following] - start_x
    ) * normal_y
    facing = facing_side(pieces, corners, incident, normal_x, normal_y)
    first_incident = pieces.first[incident]
    end = facing + 1 if facing + 1 < first_incident + pieces.corners[incident] else first_incident
    # Along the reference side from its start, and above it; the incident side runs backwards.
    from_x = corners.world_x[end] - start_x
    from_y = corners.world_y[end] - start_y
    to_x = corners.world_x[facing] - start_x
    to_y = corners.world_y[facing] - start_y
    along_0 = from_y * normal_x - from_x * normal_y
    along_1 = to_y * normal_x - to_x * normal_y
    above_0 = from_x * normal_x + from_y * normal_y
    above_1 = to_x * normal_x + to_y * normal_y
    outer = pieces.radius[reference] - pieces.radius[incident]
    rounding = pieces.radius[reference] + pieces.radius[incident]
    touch.normal_x[0] = normal_x
    touch.normal_y[0] = normal_y
    touch.feature[0] = (side - first) * 4096 + (end - first_incident)
    touch.feature[1] = (following - first) * 4096 + (facing - first_incident)
    if along_1 <= 0.0 or along_0 >= length or along_1 - along_0 <= 1e-12 * length:
        # Beside the reference side: a corner faces a corner.
        lower = above_0 <= above_1
        along = along_0 if lower else along_1
        above = above_0 if lower else above_1
        if not lower:
            touch.feature[0] = touch.feature[1]
        if along < 0.0 or along > length:
            joined = pieces.before[reference] + pieces.after[reference] + pieces.seams[reference]
            if joined > 0 or (rounding > 0.0 and above > 0.0):
                return 0
        write(touch, 0, start_x, start_y, normal_x, normal_y, along, above, outer, rounding)
        return 1
    slope = (above_1 - above_0) / (along_1 - along_0)
    if along_0 < 0.0:
        above_0 -= slope * along_0
        along_0 = 0.0
    if along_1 > length:
        above_1 -= slope * (along_1 - length)
        along_1 = length
    write(touch, 0, start_x, start_y, normal_x, normal_y, along_0, above_0, outer, rounding)
    write(touch, 1, start_x, start_y, normal_x, normal_y, along_1, above_1, outer, rounding)
    return 2


def facing_side(
    pieces: Pieces, corners: Corners, hull: int, normal_x: float, normal_y: float
) -> int:
    """Row of the side of a placed hull that faces a normal most."""
    first = pieces.first[hull]
    side = first
    least = 2.0
    for i in range(first, first + pieces.corners[hull]):
        cosine = corners.world_normal_x[i] * normal_x + corners.world_normal_y[i] * normal_y
        if cosine < least:
            least = cosine
            side = i
    return side


def write(
    touch: Touch,
    row: int,
    start_x: float,
    start_y: float,
    normal_x: float,
    normal_y: float,
    along: float,
    above: float,
    outer: float,
    rounding: float,
) -> None:
    """Write a point, halfway between the surface of the reference and what lies above it (m).

    Args:
        touch: where to.
        row: which point.
        start_x: where the reference side starts (m).
        start_y: the same.
        normal_x: its unit normal.
        normal_y: the same.
        along: how far from there along the side (m).
        above: how far from the side the other core is (m).
        outer: radius of the reference less that of the other (m).
        rounding: both radii together (m).
    """
    half = (above + outer) / 2.0
    touch.x[row] = start_x - along * normal_y + normal_x * half
    touch.y[row] = start_y + along * normal_x + normal_y * half
    touch.gap[row] = above - rounding
