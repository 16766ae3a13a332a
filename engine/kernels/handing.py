"""What slides or rolls along a chain is handed on from link to link, with all that it bears.

A contact acts for a whole part of a tick, as one that holds in the middle of the part. Which link
of a chain, or piece of a body, that is of, may be another one than that on which the part begins:
it takes over what the one before bore, or the body would fly until it meets it.
"""

from engine.kernels.following import find_points, measure
from engine.kernels.impacts import settling_speed
from engine.kernels.pose import place_pair
from engine.kernels.searching import fastest_within, is_part, lowest_gap
from engine.kernels.touches import impulses_at, leave
from engine.manifolds.any_pair import touching_points
from engine.tables import FREE, NEVER, RESTING, Tables

WITHIN = 5e-3
"""Gap that may open before a body is handed on, in reaches of the smaller one: it leaves a link
straight ahead, and the next may turn away."""


def leave_to_bearing(t: Tables, resting: int, part: float) -> int:
    """Let go what was only struck on the way, where another piece of the same two bodies bears and
    will be left before the middle of the part (s): that hands on its load. Return how many pairs
    still rest.
    """
    pairs = t.pairs
    kept = 0
    for k in range(resting):
        pair = pairs.resting[k]
        if pairs.points[pair] == 0 and is_part(t, pair) and bears_no_more(t, pair, part / 2.0):
            leave(t, pair)
            pairs.state[pair] = FREE
            pairs.apart[pair] = 0.0
            t.lanes.sizes[2] = 0
        else:
            pairs.resting[kept] = pair
            kept += 1
    return kept


def bears_no_more(t: Tables, pair: int, time: float) -> bool:
    """Whether a piece next to that of a pair bears, and does not at a time of the part (s)."""
    pairs = t.pairs
    a = pairs.a[pair]
    b = pairs.b[pair]
    body = a if t.bodies.links[a] < t.bodies.links[b] else b
    first = t.bodies.first_link[body]
    for link in range(first, first + t.bodies.links[body]):
        other = t.links.pair[link]
        if pairs.a[other] != a or pairs.b[other] != b or not is_part(t, other):
            continue
        if pairs.state[other] == RESTING and pairs.points[other] > 0:
            place_pair(t, other, time)
            if touching_points(t, other) == 0:
                return True
    return False


def hand_on(t: Tables, pair: int, points: int, part: float) -> int:
    """Hand what a resting pair bore with so many points, and does not in the middle of the part
    (s), to the piece next to it that the body touches then; return the pair that rests now.

    If there is none, it is the same, which goes on to bear where it does as the part begins: what
    it comes to later is struck. One that bears already needs nothing.
    """
    pairs = t.pairs
    other = find_heir(t, pair, part / 2.0)
    if other >= 0 and pairs.state[other] == RESTING:
        return pair
    if other < 0 or speed_of(t, other, part / 2.0) > settling_speed(t, pair, part):
        find_points(t, pair, 0.0)
        return pair
    opened = t.contacts.target[2 * pair] if points > 0 else NEVER
    leave(t, pair)
    pairs.state[pair] = FREE
    pairs.apart[pair] = 0.0
    pairs.state[other] = RESTING
    pairs.part[other] = pairs.part[pair]
    pairs.carried[other] = pairs.carried[pair]
    pairs.rolling_torque[other] = pairs.rolling_torque[pair]
    pairs.steady[other] = 0
    pairs.points[other] = 0
    pairs.acting[other] = 0
    find_points(t, other, part / 2.0)
    push, rub = impulses_at(t, pair, points)
    for row in range(2 * other, 2 * other + pairs.points[other]):
        t.contacts.normal_impulse[row] = push / pairs.points[other]
        t.contacts.tangent_impulse[row] = rub / pairs.points[other]
        t.contacts.target[row] = opened
    t.lanes.sizes[2] = 0
    return other


def find_heir(t: Tables, pair: int, time: float) -> int:
    """The pair of another piece of the same two bodies that touch there at a time of the part (s),
    or nearly so; -1 if there is none.
    """
    pairs = t.pairs
    a = pairs.a[pair]
    b = pairs.b[pair]
    body = a if t.bodies.links[a] < t.bodies.links[b] else b
    first = t.bodies.first_link[body]
    least = WITHIN * pairs.size[pair]
    heir = -1
    for link in range(first, first + t.bodies.links[body]):
        other = t.links.pair[link]
        state = pairs.state[other]
        if other == pair or pairs.a[other] != a or pairs.b[other] != b:
            continue
        if state in (FREE, RESTING):
            place_pair(t, other, time)
            points = touching_points(t, other)
            if points > 0 and lowest_gap(t, points) < least:
                least = lowest_gap(t, points)
                heir = other
    return heir


def speed_of(t: Tables, pair: int, time: float) -> float:
    """Fastest approach (m/s) at a time of the part (s) of a pair that touches."""
    place_pair(t, pair, time)
    points = touching_points(t, pair)
    return fastest_within(t, pair, points, time, lowest_gap(t, points) + 1e-8 * t.pairs.size[pair])


def find_last_points(t: Tables, pair: int) -> None:
    """Find where the bodies of a resting pair touch as a part ends, to relax there; if that is on
    another piece, along the normal of that.
    """
    pairs = t.pairs
    if not is_part(t, pair):
        find_points(t, pair, 0.0)
        return
    place_pair(t, pair, 0.0)
    if touching_points(t, pair) > 0:
        find_points(t, pair, 0.0)
        return
    other = find_heir(t, pair, 0.0)
    before = pairs.points[pair]
    if other < 0 or before == 0:
        return
    push, rub = impulses_at(t, pair, before)
    place_pair(t, other, 0.0)
    points = touching_points(t, other)
    pairs.points[pair] = points
    pairs.normal_x[pair] = t.touch.normal_x[0]
    pairs.normal_y[pair] = t.touch.normal_y[0]
    for i in range(points):
        row = 2 * pair + i
        t.contacts.gap[row] = t.touch.gap[i]
        t.contacts.normal_impulse[row] = push / points
        t.contacts.tangent_impulse[row] = rub / points
        measure(t, pair, row, t.touch.x[i], t.touch.y[i])
