"""Any shape against any shape."""

from engine.manifolds.hull_hull import hull_hull, hull_hull_gap
from engine.manifolds.link import hull_link, is_link, round_link
from engine.manifolds.round_hull import closest, round_hull
from engine.manifolds.round_round import round_round, round_round_gap
from engine.manifolds.seam import hull_seam, round_seam
from engine.tables import Tables


def touching_points(t: Tables, pair: int) -> int:
    """Write to `Touch` where the two placed pieces of a pair are closest; return the points.

    There may be none: a link of a chain, or a piece of a body, has nothing to say where another
    one touches.
    """
    a = t.pairs.piece_a[pair]
    b = t.pairs.piece_b[pair]
    if t.pieces.corners[a] == 1:
        if t.pieces.corners[b] == 1:
            return round_round(t.pieces, t.corners, t.touch, a, b)
        if is_link(t.pieces, b):
            return round_link(t, a, b, True)
        if t.pieces.seams[b] == 1:
            return round_seam(t, a, b, True)
        return round_hull(t.pieces, t.corners, t.touch, a, b, True)
    if t.pieces.corners[b] == 1:
        if is_link(t.pieces, a):
            return round_link(t, b, a, False)
        if t.pieces.seams[a] == 1:
            return round_seam(t, b, a, False)
        return round_hull(t.pieces, t.corners, t.touch, b, a, False)
    size = t.pairs.size[pair]
    if is_link(t.pieces, a):
        return hull_link(t, a, b, a, size)
    if is_link(t.pieces, b):
        return hull_link(t, a, b, b, size)
    if t.pieces.seams[a] == 1 or t.pieces.seams[b] == 1:
        return hull_seam(t, a, b, size)
    return hull_hull(t.pieces, t.corners, t.touch, a, b, 1e-6 * size)


def gap_between(t: Tables, pair: int) -> float:
    """Distance of the surfaces of the two placed pieces of a pair (m), negative if they overlap.

    Sharp hulls whose corners face each other are further apart than this says; `Touch` may be
    written over.
    """
    a = t.pairs.piece_a[pair]
    b = t.pairs.piece_b[pair]
    if t.pieces.corners[a] == 1:
        if t.pieces.corners[b] == 1:
            return round_round_gap(t.pieces, t.corners, a, b)
        distance, _, _ = closest(t.pieces, t.corners, a, b)
        return distance - t.pieces.radius[a] - t.pieces.radius[b]
    if t.pieces.corners[b] == 1:
        distance, _, _ = closest(t.pieces, t.corners, b, a)
        return distance - t.pieces.radius[b] - t.pieces.radius[a]
    return hull_hull_gap(t.pieces, t.corners, t.touch, a, b)
