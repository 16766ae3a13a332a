"""Pieces of one body that join, against anything: no hits on the edges between them.

What slides or rolls over a seam must not notice it. So a piece answers only for what is its own
(see `shapes.seams`): its sides where no other piece covers them, and corners in directions that
belong to them. Directions are judged as those of a chain (see `link`): what belongs to a neighbour
is left to it, what belongs to nobody, a ghost, never becomes a normal.
"""

from engine.manifolds.hull_hull import clip, clip_other, hull_hull
from engine.manifolds.link import ALONG, FLUSH, GHOST, LEANING, TIE
from engine.manifolds.link import OTHERS as ANOTHERS
from engine.manifolds.link import OWN as ITS_OWN
from engine.manifolds.round_hull import round_hull
from engine.tables import Tables
from engine.tables.bodies import HIDDEN, OTHERS, OWN, PLAIN

DEEP = 0.1
"""Where its own sides see another hull deeper than this within, in reaches of the smaller body, a
piece takes its inner edges for sides: to part what overlaps, the shortest way is the safest."""

ALONGSIDE = 3
"""Whose a direction from a corner is, besides what `link` knows: it means the piece's own side."""


def of_corner(t: Tables, row: int, x: float, y: float) -> int:
    """Whose the unit direction (x, y) from a placed corner is."""
    corners = t.corners
    kind = corners.kind[row]
    if kind == PLAIN:
        return ITS_OWN
    if kind == HIDDEN:
        return GHOST
    cos = corners.normal_x[row] * corners.world_normal_x[row]
    cos += corners.normal_y[row] * corners.world_normal_y[row]
    sin = corners.normal_x[row] * corners.world_normal_y[row]
    sin -= corners.normal_y[row] * corners.world_normal_x[row]
    out_x = cos * x + sin * y
    out_y = cos * y - sin * x
    low_x = corners.low_x[row]
    low_y = corners.low_y[row]
    high_x = corners.high_x[row]
    high_y = corners.high_y[row]
    beyond = high_x * out_y - high_y * out_x
    short = low_y * out_x - low_x * out_y
    if short > beyond:
        beyond = short
    if beyond <= ALONG and kind == OWN:
        return ITS_OWN
    bare = kind == OWN or corners.cover_start[row] > corners.cover_end[row]
    own_x = low_x
    own_y = low_y
    if kind == OTHERS:
        own_x = corners.normal_x[row]
        own_y = corners.normal_y[row]
    if bare and abs(own_x * out_y - own_y * out_x) <= FLUSH and own_x * out_x + own_y * out_y > 0.0:
        return ALONGSIDE
    return ANOTHERS if beyond < LEANING else GHOST


def of_side(t: Tables, row: int, x: float, y: float) -> int:
    """Whose the normal of a placed side is, for what is at (x, y)."""
    corners = t.corners
    if corners.cover_start[row] > corners.cover_end[row]:
        return ITS_OWN
    along = (y - corners.world_y[row]) * corners.world_normal_x[row]
    along -= (x - corners.world_x[row]) * corners.world_normal_y[row]
    covered = corners.cover_start[row] < along < corners.cover_end[row]
    return GHOST if covered else ITS_OWN


def of_feature(
    t: Tables, piece: int, row: int, x: float, y: float, at_x: float, at_y: float
) -> int:
    """Whose a unit normal (x, y) of a piece is at a corner of it: that of a side, or of the corner.

    What it touches is at (at_x, at_y).
    """
    first = t.pieces.first[piece]
    before = row - 1 if row > first else first + t.pieces.corners[piece] - 1
    if is_normal(t, row, x, y):
        return of_side(t, row, at_x, at_y)
    if is_normal(t, before, x, y):
        return of_side(t, before, at_x, at_y)
    return of_corner(t, row, x, y)


def is_normal(t: Tables, side: int, x: float, y: float) -> bool:
    """Whether a unit vector is the normal of a placed side."""
    normal_x = t.corners.world_normal_x[side]
    normal_y = t.corners.world_normal_y[side]
    return abs(normal_x * y - normal_y * x) <= ALONG and normal_x * x + normal_y * y > 0.0


def round_seam(t: Tables, disc: int, piece: int, disc_is_a: bool) -> int:
    """Write the point where a placed disc touches what is a piece's own; return 0 or 1."""
    corners = t.corners
    first = t.pieces.first[piece]
    end = first + t.pieces.corners[piece]
    x = corners.world_x[t.pieces.first[disc]]
    y = corners.world_y[t.pieces.first[disc]]
    side = first
    height = -1e300
    own = first
    highest = -1e300
    for i in range(first, end):
        above = corners.world_normal_x[i] * (x - corners.world_x[i])
        above += corners.world_normal_y[i] * (y - corners.world_y[i])
        if above > height:
            height = above
            side = i
        if above > highest and of_side(t, i, x, y) == ITS_OWN:
            highest = above
            own = i
    if height < 0.0:
        return buried_disc(t, disc, own, highest, disc_is_a) if highest > -1e299 else 0
    points = round_hull(t.pieces, corners, t.touch, disc, piece, disc_is_a)
    following = side + 1 if side + 1 < end else first
    normal_x = corners.world_normal_x[side]
    normal_y = corners.world_normal_y[side]
    out = -1.0 if disc_is_a else 1.0
    out_x = out * t.touch.normal_x[0]
    out_y = out * t.touch.normal_y[0]
    along = (y - corners.world_y[side]) * normal_x - (x - corners.world_x[side]) * normal_y
    past = (y - corners.world_y[following]) * normal_x
    past -= (x - corners.world_x[following]) * normal_y
    if along < 0.0:
        owner = of_corner(t, side, out_x, out_y)
    elif past > 0.0:
        owner = of_corner(t, following, out_x, out_y)
    else:
        owner = of_side(t, side, x, y)
    return points if owner == ITS_OWN else 0


def buried_disc(t: Tables, disc: int, side: int, height: float, disc_is_a: bool) -> int:
    """Write the point of a disc whose centre is in a piece, `height` (m) over a side; return 1."""
    touch = t.touch
    normal_x = t.corners.world_normal_x[side]
    normal_y = t.corners.world_normal_y[side]
    center = t.pieces.first[disc]
    gap = height - t.pieces.radius[disc]
    out = t.pieces.radius[disc] + gap / 2.0
    touch.x[0] = t.corners.world_x[center] - out * normal_x
    touch.y[0] = t.corners.world_y[center] - out * normal_y
    touch.gap[0] = gap
    touch.feature[0] = 0
    sign = -1.0 if disc_is_a else 1.0
    touch.normal_x[0] = sign * normal_x
    touch.normal_y[0] = sign * normal_y
    return 1


def hull_seam(t: Tables, a: int, b: int, size: float) -> int:
    """Write where two placed hulls touch, of which at least one has seams; return how many points.

    `size` is the scale of all tolerances (m).
    """
    tie = TIE * size
    pieces = t.pieces
    of_a, side_a, others_a, ghost_a = furthest_own(t, a, b)
    of_b, side_b, others_b, ghost_b = furthest_own(t, b, a)
    others = others_a if others_a > others_b else others_b
    ghost = ghost_a if ghost_a > ghost_b else ghost_b
    own = of_b if of_b > of_a + tie else of_a
    apart = own if own > others else others
    if ghost > apart:
        apart = ghost
    if apart > 0.0 and pieces.radius[a] + pieces.radius[b] > 0.0:
        points, owner = rounded_seam(t, a, b, tie)
        if owner != ALONGSIDE:
            return points
        if pieces.seams[a] == 1:
            return clip(pieces, t.corners, t.touch, a, b, side_a)
        return clip_other(pieces, t.corners, t.touch, a, b, side_b)
    if others > own + tie:
        return 0
    if own < -DEEP * size and ghost > own:
        return hull_hull(pieces, t.corners, t.touch, a, b, tie)
    reference = b if of_b > of_a + tie else a
    if ghost > 0.0 and pieces.seams[reference] == 0:
        return 0
    if reference == a:
        return clip(pieces, t.corners, t.touch, a, b, side_a)
    return clip_other(pieces, t.corners, t.touch, a, b, side_b)


def furthest_own(t: Tables, hull: int, other: int) -> tuple[float, int, float, float]:
    """Separations (m) by sides of a hull: best of its own, with its row; of others; of ghosts."""
    corners = t.corners
    pieces = t.pieces
    first = pieces.first[hull]
    start = pieces.first[other]
    own = -1e300
    others = -1e300
    ghost = -1e300
    side = first
    still = t.bodies.inverse_mass[pieces.body[hull]] == 0.0
    for i in range(first, first + pieces.corners[hull]):
        x = corners.world_normal_x[i]
        y = corners.world_normal_y[i]
        lowest = 1e300
        corner = start
        for j in range(start, start + pieces.corners[other]):
            height = x * corners.world_x[j] + y * corners.world_y[j]
            if height < lowest:
                lowest = height
                corner = j
        apart = lowest - x * corners.world_x[i] - y * corners.world_y[i]
        owner = ITS_OWN
        if pieces.seams[hull] == 1:
            owner = of_side(t, i, corners.world_x[corner], corners.world_y[corner])
        if owner == ITS_OWN and pieces.seams[other] == 1:
            owner = of_corner(t, corner, -x, -y)
            if owner == ALONGSIDE:  # its own side says the same, unless that meets a seam as well
                owner = ITS_OWN if pieces.seams[hull] == 1 or still else GHOST
        if owner == ITS_OWN and apart > own:
            own = apart
            side = i
        elif owner == ANOTHERS and apart > others:
            others = apart
        elif owner == GHOST and apart > ghost:
            ghost = apart
    return own, side, others, ghost


def rounded_seam(t: Tables, a: int, b: int, tie: float) -> tuple[int, int]:
    """The same for rounded hulls whose cores are apart: closest points; and whose."""
    touch = t.touch
    points = hull_hull(t.pieces, t.corners, touch, a, b, tie)
    if points == 0:
        return 0, ITS_OWN
    lowest = 1 if points == 2 and touch.gap[1] < touch.gap[0] else 0
    of_a = touch.feature[lowest] // 4096
    of_b = touch.feature[lowest] - of_a * 4096
    x = touch.normal_x[0]
    y = touch.normal_y[0]
    at_x = touch.x[lowest]
    at_y = touch.y[lowest]
    owner = ITS_OWN
    if t.pieces.seams[a] == 1:
        owner = of_feature(t, a, t.pieces.first[a] + of_a, x, y, at_x, at_y)
    if owner == ITS_OWN and t.pieces.seams[b] == 1:
        owner = of_feature(t, b, t.pieces.first[b] + of_b, -x, -y, at_x, at_y)
    return (points if owner == ITS_OWN else 0), owner
