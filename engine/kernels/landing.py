"""What lands on two places at once: a table on its legs, a box on the joint of two planks.

The same two bodies may meet in several pieces at one instant, and all that never yields, walls and
planks and pillars, is one body in this: the ground. If the normals are the same, the two outermost
points decide how a body moves on. They are solved together, like two points of one pair (see
`exchange`): each leaves with e times its approach, so that what lands flat does not begin to turn.
"""

from engine.kernels.exchange import exchange, press, rub, share_of_two
from engine.kernels.impulses import approach, change_of, report, slip
from engine.kernels.pose import place_pair
from engine.kernels.rubbing import belt_speed
from engine.kernels.touches import OVERLAP, touch
from engine.linkage.tally import is_joined
from engine.manifolds.any_pair import touching_points
from engine.tables import FREE, RESTING, Tables

ALIKE = 1.0 - 1e-6
"""Cosine from which on two normals are the same."""

TOUCHING = 1e-8
"""Gap at which what meets at the same instant touches, in reaches of the smaller body."""


def exchange_at_once(
    t: Tables, pair: int, one: int, other: int, rests: bool, now: float, time: float
) -> None:
    """Give the bodies of a pair their impulses, wherever else they touch at once.

    Args:
        t: the tables.
        pair: which pair.
        one: row in `Touch` of the point that is struck.
        other: the same of the other one that takes part, or -1.
        rests: whether they stay together.
        now: when the part began, since the tick began (s).
        time: of the impact, since the part began (s).
    """
    first, second = find_places(t, pair, one, other, time)
    bounce = 1.0 if rests else 1.0 + t.pairs.restitution[pair]
    if first == pair and second == pair:
        exchange(t, pair, one, other, bounce, now + time)
        return
    if t.pairs.a[first] == t.pairs.a[second] and t.pairs.b[first] == t.pairs.b[second]:
        faster = 0 if approach(t, pair, 0) >= approach(t, pair, 1) else 1
        exchange(t, pair, faster, 1 - faster, bounce, now + time)
    else:
        exchange_at_two(t, pair, first, second, rests, now + time)
    settle_mate(t, first, pair, rests, now + time)
    settle_mate(t, second, pair, rests, now + time)


def find_places(t: Tables, pair: int, one: int, other: int, time: float) -> tuple[int, int]:
    """Find the two outermost points at which the bodies of a pair touch that is struck at `time` of
    the part (s); return of which pairs they are.

    Args:
        t: the tables.
        pair: which pair.
        one: row in `Touch` of the point that is struck.
        other: the same of the other one that takes part, or -1.
        time: of the impact, since the part began (s).

    If both are of the pair itself, `Touch` says what it said; else its rows are these points.
    """
    body = yielding(t, pair)
    partner = t.pairs.a[pair] + t.pairs.b[pair] - body
    if (
        t.bodies.inverse_mass[partner] > 0.0
        and t.bodies.pieces[body] + t.bodies.pieces[partner] == 2
    ):
        return pair, pair
    at = t.touch
    side = 1.0 if t.pairs.b[pair] == body else -1.0
    nx = side * at.normal_x[0]
    ny = side * at.normal_y[0]
    last = one if other < 0 else other
    if at.y[one] * nx - at.x[one] * ny > at.y[last] * nx - at.x[last] * ny:
        last = one
        one = other
    low_x = at.x[one]
    low_y = at.y[one]
    high_x = at.x[last]
    high_y = at.y[last]
    low = low_y * nx - low_x * ny
    high = high_y * nx - high_x * ny
    first = pair
    second = pair
    looked = False
    start = t.bodies.first_link[body]
    for link in range(start, start + t.bodies.links[body]):
        mate = t.links.pair[link]
        if mate == pair or not meets_too(t, mate, pair, body, time):
            continue
        looked = True
        for i in range(points_of_mate(t, mate, body, nx, ny, time)):
            along = at.y[i] * nx - at.x[i] * ny
            if at.gap[i] > reach_of_mate(t, mate):
                continue
            if along < low - TOUCHING * t.pairs.size[mate]:
                first = mate
                low = along
                low_x = at.x[i]
                low_y = at.y[i]
            elif along > high + TOUCHING * t.pairs.size[mate]:
                second = mate
                high = along
                high_x = at.x[i]
                high_y = at.y[i]
    if looked:
        place_pair(t, pair, time)
        touching_points(t, pair)
    if first != pair or second != pair:
        at.x[0] = low_x
        at.y[0] = low_y
        at.x[1] = high_x
        at.y[1] = high_y
    return first, second


def yielding(t: Tables, pair: int) -> int:
    """Which body of a pair yields to impulses; b if both do."""
    b = t.pairs.b[pair]
    return t.pairs.a[pair] if t.bodies.inverse_mass[b] == 0.0 else b


def meets_too(t: Tables, mate: int, pair: int, body: int, time: float) -> bool:
    """Whether another pair of a body may touch as well where one is struck at `time` of the part
    (s), and is of the same bodies, or both are with the ground.
    """
    pairs = t.pairs
    if pairs.state[mate] == FREE:
        if pairs.queued[mate] == 0 or pairs.meeting[mate] > time:
            return False
    elif pairs.state[mate] != RESTING:
        return False
    partner = pairs.a[pair] + pairs.b[pair] - body
    other = pairs.a[mate] + pairs.b[mate] - body
    if t.bodies.inverse_mass[partner] > 0.0:
        return partner == other
    return t.bodies.inverse_mass[other] == 0.0 and not is_joined(t, mate)


def points_of_mate(t: Tables, mate: int, body: int, nx: float, ny: float, time: float) -> int:
    """Write to `Touch` where the pieces of a pair touch at `time` of the part (s), if their normal
    is (nx, ny), towards the body; return how many points.
    """
    place_pair(t, mate, time)
    points = touching_points(t, mate)
    along = t.touch.normal_x[0] * nx + t.touch.normal_y[0] * ny
    if t.pairs.b[mate] != body:
        along = -along
    return points if along >= ALIKE else 0


def reach_of_mate(t: Tables, mate: int) -> float:
    """Gap up to which a point of another pair touches (m)."""
    near = OVERLAP if t.pairs.state[mate] == RESTING else TOUCHING
    return near * t.pairs.size[mate]


def exchange_at_two(
    t: Tables, pair: int, first: int, second: int, rests: bool, time: float
) -> None:
    """Give a body its impulses at the two points in `Touch`, of two pairs; report both.

    Args:
        t: the tables; the normal in `Touch` is that of `pair`.
        pair: which pair is struck.
        first: that of the first point, of the same body and the ground.
        second: that of the second point, with another part of the ground.
        rests: whether they stay together.
        time: of the impact, since the tick began (s).
    """
    at = t.touch
    body = yielding(t, pair)
    side = 1.0 if t.pairs.b[pair] == body else -1.0
    nx = side * at.normal_x[0]
    ny = side * at.normal_y[0]
    v1, slid_1 = face(t, first, body, 0, nx, ny)
    v2, slid_2 = face(t, second, body, 1, nx, ny)
    change_1 = change_of(v1, 1.0 if rests else 1.0 + t.pairs.restitution[first])
    change_2 = change_of(v2, 1.0 if rests else 1.0 + t.pairs.restitution[second])
    if v1 >= v2:
        share, total = share_of_two(t, first, 0, 1, change_1, change_2)
    else:
        share, total = share_of_two(t, second, 1, 0, change_2, change_1)
        share = 1.0 - share
    push_1 = (1.0 - share) * total
    push_2 = share * total
    speed_1, _ = face(t, first, body, 0, nx, ny)
    press(t, first, at.x[0], at.y[0], push_1, speed_1)
    speed_2, _ = face(t, second, body, 1, nx, ny)
    press(t, second, at.x[1], at.y[1], push_2, speed_2)
    if push_1 > 0.0:
        face(t, first, body, 0, nx, ny)
        along = rub(t, first, at.x[0], at.y[0], push_1, slid_1)
        report(t, first, at.x[0], at.y[0], push_1, along, v1, time)
    if push_2 > 0.0:
        face(t, second, body, 1, nx, ny)
        along = rub(t, second, at.x[1], at.y[1], push_2, slid_2)
        report(t, second, at.x[1], at.y[1], push_2, along, v2, time)


def face(t: Tables, pair: int, body: int, point: int, nx: float, ny: float) -> tuple[float, float]:
    """Write to `Touch` the normal of a pair, which is (nx, ny) towards the body; return how fast
    its bodies approach at a point of it, and slide (m/s).
    """
    side = 1.0 if t.pairs.b[pair] == body else -1.0
    t.touch.normal_x[0] = side * nx
    t.touch.normal_y[0] = side * ny
    belt = belt_speed(t, pair, side * nx, side * ny)
    sliding = slip(t, pair, t.touch.x[point], t.touch.y[point]) + belt
    return approach(t, pair, point), sliding


def settle_mate(t: Tables, mate: int, pair: int, rests: bool, time: float) -> None:
    """Let a pair that was struck beside another, at `time` since the tick began (s), rest or fly as
    that one does.
    """
    pairs = t.pairs
    if mate == pair or pairs.state[mate] == RESTING:
        return
    pairs.bounces[mate] = pairs.bounces[pair]
    pairs.struck[mate] = time
    pairs.apart[mate] = 0.0
    if rests:
        touch(t, mate)
        pairs.points[mate] = 0
        pairs.state[mate] = RESTING
