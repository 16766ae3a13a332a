"""Any shape against any shape."""

from engine.manifolds.hull_hull import hull_hull, hull_hull_gap
from engine.manifolds.round_hull import closest, round_hull
from engine.manifolds.round_round import round_round, round_round_gap
from engine.tables import Tables


def touching_points(t: Tables, pair: int) -> int:
    """Write to `Touch` where the two placed pieces of a pair are closest; return the points."""
    a = t.pairs.piece_a[pair]
    b = t.pairs.piece_b[pair]
    if t.pieces.corners[a] == 1:
        if t.pieces.corners[b] == 1:
            return round_round(t.pieces, t.corners, t.touch, a, b)
        return round_hull(t.pieces, t.corners, t.touch, a, b, True)
    if t.pieces.corners[b] == 1:
        return round_hull(t.pieces, t.corners, t.touch, b, a, False)
    return hull_hull(t.pieces, t.corners, t.touch, a, b, 1e-6 * t.pairs.size[pair])


def gap_between(t: Tables, pair: int) -> float:
    """Distance of the surfaces of the two placed pieces of a pair (m), negative if they overlap."""
    a = t.pairs.piece_a[pair]
    b = t.pairs.piece_b[pair]
    if t.pieces.corners[a] == 1:
        if t.pieces.corners[b] == 1:
            return round_round_gap(t.pieces, t.corners, a, b)
        distance, _, _ = closest(t.pieces, t.corners, a, b)
        return distance - t.pieces.radius[a]
    if t.pieces.corners[b] == 1:
        distance, _, _ = closest(t.pieces, t.corners, b, a)
        return distance - t.pieces.radius[b]
    return hull_hull_gap(t.pieces, t.corners, a, b)
