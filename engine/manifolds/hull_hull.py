"""Polygon against polygon or wall: separating axes (thesis, eq. 30-31), then clipping.

Two convex hulls are apart if and only if a side of one of them has all of the other in front of it.
The side that sees the other furthest out is the reference side; the side of the other that faces
it most is the incident one, and it is clipped by the ends of the reference side (Sutherland and
Hodgman): what remains of it lies in front of or behind the reference side by the contact's gap.
"""

from engine.tables import Corners, Pieces, Touch


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


def hull_hull_gap(pieces: Pieces, corners: Corners, a: int, b: int) -> float:
    """Separation of two placed hulls along the best axis (m): at most their distance."""
    of_a, _ = furthest_side(pieces, corners, a, b, -1e300)
    of_b, _ = furthest_side(pieces, corners, b, a, of_a)
    return of_b if of_b > of_a else of_a


def hull_hull(pieces: Pieces, corners: Corners, touch: Touch, a: int, b: int, tie: float) -> int:
    """Write the one or two points where two placed hulls are closest; return their number.

    A side of b is the reference only if it sees a further out than any of a sees b by `tie` (m).
    """
    of_a, side_a = furthest_side(pieces, corners, a, b, -1e300)
    of_b, side_b = furthest_side(pieces, corners, b, a, of_a + tie)
    if of_b > of_a + tie:
        points = clip(pieces, corners, touch, b, a, side_b)
        touch.normal_x[0] = -touch.normal_x[0]
        touch.normal_y[0] = -touch.normal_y[0]
        for i in range(points):  # a feature is (corner of a, corner of b), whoever is reference
            reference = touch.feature[i] // 4096
            touch.feature[i] = (touch.feature[i] - reference * 4096) * 4096 + reference
        return points
    return clip(pieces, corners, touch, a, b, side_a)


def clip(
    pieces: Pieces, corners: Corners, touch: Touch, reference: int, incident: int, side: int
) -> int:
    """Clip the incident side by the ends of the reference side; write what remains of it."""
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
        write(touch, 0, start_x, start_y, normal_x, normal_y, along, above)
        return 1
    slope = (above_1 - above_0) / (along_1 - along_0)
    if along_0 < 0.0:
        above_0 -= slope * along_0
        along_0 = 0.0
    if along_1 > length:
        above_1 -= slope * (along_1 - length)
        along_1 = length
    write(touch, 0, start_x, start_y, normal_x, normal_y, along_0, above_0)
    write(touch, 1, start_x, start_y, normal_x, normal_y, along_1, above_1)
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
) -> None:
    """Write a point, halfway between the reference side and what lies above it (m)."""
    touch.x[row] = start_x - along * normal_y + normal_x * above / 2.0
    touch.y[row] = start_y + along * normal_x + normal_y * above / 2.0
    touch.gap[row] = above
