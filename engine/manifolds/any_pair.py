"""Any shape against any shape."""

from engine.manifolds.hull_hull import hull_hull, hull_hull_gap
from engine.manifolds.round_hull import closest, round_hull
from engine.manifolds.round_round import round_round, round_round_gap
from engine.tables import Tables


def touching_points(t: Tables, pair: int) -> int:
    """Write to `Touch` where the two placed bodies of a pair are closest; return the points."""
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    if t.bodies.corners[a] == 1:
        if t.bodies.corners[b] == 1:
            return round_round(t.bodies, t.touch, a, b)
        return round_hull(t.bodies, t.corners, t.touch, a, b, True)
    if t.bodies.corners[b] == 1:
        return round_hull(t.bodies, t.corners, t.touch, b, a, False)
    return hull_hull(t.bodies, t.corners, t.touch, a, b, 1e-6 * t.pairs.size[pair])


def gap_between(t: Tables, pair: int) -> float:
    """Distance of the surfaces of the two placed bodies of a pair (m), negative if they overlap."""
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    if t.bodies.corners[a] == 1:
        if t.bodies.corners[b] == 1:
            return round_round_gap(t.bodies, a, b)
        distance, _, _ = closest(t.bodies, t.corners, a, b)
        return distance - t.bodies.radius[a]
    if t.bodies.corners[b] == 1:
        distance, _, _ = closest(t.bodies, t.corners, b, a)
        return distance - t.bodies.radius[b]
    return hull_hull_gap(t.bodies, t.corners, a, b)
