"""Any shape against a link of a chain, without hits on the inner corners of the chain.

A body slides or rolls over the joint of two links as if it were not there, if each link answers
only for what is its own: what touches its side between its ends, and its second corner. A corner
belongs to a direction u, from the chain to the body, if u leads neither back along the link before
nor on along the link after (Voronoi region): u . d_before >= 0 >= u . d_after. A direction that
leads along a link is a ghost: the side of that link is what the body touches, not its end.
"""

from engine.manifolds.hull_hull import (
    clip,
    clip_other,
    faces,
    furthest_side,
    join_corners,
)
from engine.manifolds.round_hull import round_hull
from engine.tables import Pieces, Tables

OWN, OTHERS, GHOST = 0, 1, 2
"""Whose a direction from a corner of a link is: this link's; that of a neighbour; nobody's."""

TIE = 1e-6
"""A side of a hull is the reference only if it sees further out than those of a link by so much, as
a share of the reach of the smaller body."""

BURIED = 1e-3
"""Distance from a joint within which a hull overlaps one link and does not meet the other, in the
same unit."""

ALONG = 1e-9
"""Cosine to a link from which on a direction leads along it."""

LEANING = 0.2
"""Cosine to a neighbour up to which a direction that leads along it means what lies on its side,
unless it means what lies on the link's own:"""

FLUSH = 0.02
"""the cosine to the link from which on it does not."""


def is_link(pieces: Pieces, piece: int) -> bool:
    """Whether a piece is a link of a chain that has a link before or after it."""
    return pieces.before[piece] + pieces.after[piece] > 0


def whose(t: Tables, link: int, corner: int, x: float, y: float) -> int:
    """Whose the direction (x, y) from a corner of a placed link is; the corner is 0 or 1."""
    pieces = t.pieces
    neighbour = pieces.after[link] if corner == 1 else pieces.before[link]
    if neighbour == 0:
        return OWN
    first = pieces.first[t.bodies.first_piece[pieces.body[link]] + neighbour - 1]
    # The first side of a line has its normal to the right of the way from corner to corner.
    along = y * t.corners.world_normal_x[first] - x * t.corners.world_normal_y[first]
    if corner == 1:
        along = -along
    if along >= -ALONG:
        return OWN if corner == 1 else OTHERS
    own = t.pieces.first[link]
    leaves = abs(y * t.corners.world_normal_x[own] - x * t.corners.world_normal_y[own]) > FLUSH
    return OTHERS if along > -LEANING and leaves else GHOST


def nearest_neighbour(t: Tables, link: int, x: float, y: float) -> int:
    """The link that goes on from the end to which (x, y) is closer; the link itself at an end."""
    corners = t.corners
    first = t.pieces.first[link]
    from_x = x - corners.world_x[first]
    from_y = y - corners.world_y[first]
    to_x = x - corners.world_x[first + 1]
    to_y = y - corners.world_y[first + 1]
    neighbour = t.pieces.before[link]
    if to_x * to_x + to_y * to_y < from_x * from_x + from_y * from_y:
        neighbour = t.pieces.after[link]
    if neighbour == 0:
        return link
    return t.bodies.first_piece[t.pieces.body[link]] + neighbour - 1


def round_link(t: Tables, disc: int, link: int, disc_is_a: bool) -> int:
    """Write the point where a placed disc touches what is a link's own; return how many, 0 or 1."""
    corners = t.corners
    first = t.pieces.first[link]
    center = t.pieces.first[disc]
    along_x = -corners.world_normal_y[first]
    along_y = corners.world_normal_x[first]
    x = corners.world_x[center] - corners.world_x[first]
    y = corners.world_y[center] - corners.world_y[first]
    if x * along_x + y * along_y < 0.0 and t.pieces.before[link] > 0:
        return 0
    points = round_hull(t.pieces, corners, t.touch, disc, link, disc_is_a)
    x = corners.world_x[center] - corners.world_x[first + 1]
    y = corners.world_y[center] - corners.world_y[first + 1]
    if x * along_x + y * along_y > 0.0:
        out = -1.0 if disc_is_a else 1.0
        if whose(t, link, 1, out * t.touch.normal_x[0], out * t.touch.normal_y[0]) != OWN:
            return 0
    return points


def hull_link(t: Tables, a: int, b: int, link: int, size: float) -> int:
    """Write where two placed hulls touch, one of which is the link; return how many points.

    `size` is the scale of all tolerances (m).
    """
    tie = TIE * size
    pieces = t.pieces
    hull = a + b - link
    face, side = furthest_side(pieces, t.corners, link, hull, -1e300)
    own, own_side, others, ghost = furthest_sides(t, hull, link)
    best = face if face > own else own
    rounding = pieces.radius[a] + pieces.radius[b]
    apart = best
    if others > apart:
        apart = others
    if ghost > apart:
        apart = ghost
    if apart > 0.0 and rounding > 0.0:
        return rounded_link(t, a, b, link, tie)
    if others > best + tie:
        return 0
    if own > face + tie:
        return 0 if ghost > 0.0 else clip_as(t, a, b, hull, own_side)
    points = clip_as(t, a, b, link, side)
    return 0 if is_buried(t, link, hull, points, BURIED * size) else points


def is_buried(t: Tables, link: int, hull: int, points: int, near: float) -> bool:
    """Whether all points on the side of a link are behind a neighbour that the hull lies on.

    What rests on a link overlaps it a little; where the next one turns away behind it, as at the
    edge of a table, it must not be hit from within. Only points `near` the joint (m) can be.
    """
    corners = t.corners
    pieces = t.pieces
    for corner in range(2):
        neighbour = pieces.after[link] if corner == 1 else pieces.before[link]
        if neighbour == 0:
            continue
        row = pieces.first[link] + corner
        first = pieces.first[t.bodies.first_piece[pieces.body[link]] + neighbour - 1]
        x = corners.world_normal_x[first]
        y = corners.world_normal_y[first]
        base = x * corners.world_x[row] + y * corners.world_y[row]
        height = 0.0
        for i in range(pieces.first[hull], pieces.first[hull] + pieces.corners[hull]):
            height += x * corners.world_x[i] + y * corners.world_y[i] - base
        side = 1.0 if height > 0.0 else -1.0
        behind = 0
        within = False
        for i in range(points):
            way_x = t.touch.x[i] - corners.world_x[row]
            way_y = t.touch.y[i] - corners.world_y[row]
            above = side * (x * way_x + y * way_y)
            if above <= 1e-9 * near and way_x * way_x + way_y * way_y <= near * near:
                behind += 1
                within = within or above < -1e-9 * near
        if within and behind == points:
            return True
    return False


def furthest_sides(t: Tables, hull: int, link: int) -> tuple[float, int, float, float]:
    """Separations (m) by sides of a hull whose direction is the link's own, with the row of the
    side; by those of another link; and by ghosts.
    """
    corners = t.corners
    first = t.pieces.first[link]
    start = t.pieces.first[hull]
    own = -1e300
    others = -1e300
    ghost = -1e300
    side = start
    for i in range(start, start + t.pieces.corners[hull]):
        x = corners.world_normal_x[i]
        y = corners.world_normal_y[i]
        base = x * corners.world_x[i] + y * corners.world_y[i]
        of_first = x * corners.world_x[first] + y * corners.world_y[first] - base
        of_second = x * corners.world_x[first + 1] + y * corners.world_y[first + 1] - base
        corner = 0 if of_first < of_second else 1
        apart = of_first if of_first < of_second else of_second
        owner = whose(t, link, corner, -x, -y)
        if owner == OWN and apart > own:
            own = apart
            side = i
        elif owner == OTHERS and apart > others:
            others = apart
        elif owner == GHOST and apart > ghost:
            ghost = apart
    return own, side, others, ghost


def rounded_link(t: Tables, a: int, b: int, link: int, tie: float) -> int:
    """The same for a rounded hull whose core is apart from the link: closest points count."""
    pieces = t.pieces
    hull = a + b - link
    face, side = furthest_side(pieces, t.corners, link, hull, -1e300)
    other, other_side = furthest_side(pieces, t.corners, hull, link, face + tie)
    near = (face if face > other else other) - pieces.radius[a] - pieces.radius[b]
    near += 2.0 * tie
    if other > face + tie:
        points = clip_as(t, a, b, hull, other_side)
    else:
        points = clip_as(t, a, b, link, side)
        if faces(t.touch, points, near):
            return points
    if not faces(t.touch, points, near):
        points = join_corners(pieces, t.corners, t.touch, a, b)
    owner = owner_of_lowest(t, b, link, points)
    if owner == GHOST:
        return clip_as(t, a, b, link, side)
    return points if owner == OWN else 0


def owner_of_lowest(t: Tables, b: int, link: int, points: int) -> int:
    """Whose the direction is of the lowest point in `Touch`, at a corner of a link."""
    touch = t.touch
    lowest = 1 if points == 2 and touch.gap[1] < touch.gap[0] else 0
    corner = touch.feature[lowest] // 4096
    out = 1.0
    if link == b:
        corner = touch.feature[lowest] - corner * 4096
        out = -1.0
    return whose(t, link, corner, out * touch.normal_x[0], out * touch.normal_y[0])


def clip_as(t: Tables, a: int, b: int, reference: int, side: int) -> int:
    """Clip by a side of one of both; normals point from a to b."""
    if reference == a:
        return clip(t.pieces, t.corners, t.touch, a, b, side)
    return clip_other(t.pieces, t.corners, t.touch, a, b, side)
