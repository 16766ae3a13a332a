"""Sensors: they notice what overlaps them, and act on nothing.

What counts is where bodies stand when a tick is over. What came and went within the tick is noticed
as well: each path that bodies take, from where something bent it to where something bends it again,
is looked along before they leave it.
"""

import math

from engine.kernels.meeting import rim_speed
from engine.kernels.searching import (
    LAST_LOOKS,
    MOST_LOOKS,
    dip,
    gap_at,
    inner_of_both,
    steps_over,
    stride,
)
from engine.kernels.touches import number_of_tick, touch
from engine.linkage.tally import is_joined
from engine.tables import NEVER, SENSING, Tables


def sense_all(t: Tables, pair_count: int, time: float) -> None:
    """Notice which sensors and bodies met on paths that they leave at `time` of the part (s)."""
    for pair in range(pair_count):
        if t.pairs.state[pair] == SENSING:
            sense(t, pair, time)


def sense_before(t: Tables, pair: int, time: float) -> None:
    """The same of the pairs of two bodies that are about to collide, and of what joints move."""
    if t.progress.sensing[0] == 0:
        return
    if is_joined(t, pair):
        sense_all(t, t.counts.pairs[0], time)
    else:
        sense_path(t, t.pairs.a[pair], time)
        sense_path(t, t.pairs.b[pair], time)


def sense_path(t: Tables, row: int, time: float) -> None:
    """The same of the pairs of one body."""
    first = t.bodies.first_link[row]
    for link in range(first, first + t.bodies.links[row]):
        if t.pairs.state[t.links.pair[link]] == SENSING:
            sense(t, t.links.pair[link], time)


def sense(t: Tables, pair: int, end: float) -> None:
    """Notice whether the surfaces of a sensor and a body come to overlap on the paths that they are
    on until the `end` (s).

    Who overlapped when the last tick was over has to leave for that, and come again. `Pairs.apart`
    says how far they have to move for either.
    """
    pairs = t.pairs
    clock = t.bodies.clock
    a = pairs.a[pair]
    b = pairs.b[pair]
    start = clock[a] if clock[a] > clock[b] else clock[b]
    if start >= end:
        return
    bound = fastest(t, pair, start, end)
    way = bound * (end - start)
    left = pairs.apart[pair] - way
    pairs.apart[pair] = left if left > 0.0 else 0.0
    touched = pairs.touched[pair]
    now = number_of_tick(t)
    if left > 0.0 or touched == now:
        return
    gap = gap_at(t, pair, start)
    if gap <= 0.0 and touched < now - 1:
        touch(t, pair)
        return
    depth = gap if gap > 0.0 else -gap
    if depth > way:
        pairs.apart[pair] = depth - way
    elif comes(t, pair, start, gap, end, bound):
        touch(t, pair)


def comes(t: Tables, pair: int, time: float, gap: float, end: float, bound: float) -> bool:
    """Whether surfaces that move no faster than `bound` (m/s) come to overlap between a `time`, at
    which they are a `gap` (m) apart, and the `end` (s).

    They are searched for as impacts are, see `searching`; those that overlap have to part first.
    """
    piece = 0.25 * inner_of_both(t, pair) / bound
    earlier = time
    wider = gap
    looks = 0
    while time < end:
        looks += 1
        if looks == MOST_LOOKS:
            piece = (end - time) / LAST_LOOKS
        later = stride(time, gap if gap > 0.0 else -gap, end, bound, piece)
        after = gap_at(t, pair, later)
        if gap > 0.0:
            if after <= 0.0:
                return True
            if (
                wider > 0.0
                and steps_over(earlier, wider, time, gap, later, after, bound, 0.0)
                and dip(t, pair, earlier, later, bound, 0.0) < NEVER
            ):
                return True
        earlier = time
        wider = gap
        time = later
        gap = after
    return False


def fastest(t: Tables, pair: int, start: float, end: float) -> float:
    """Bound of the speed (m/s) at which any points of a pair may approach from the `start` to the
    `end` (s).
    """
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    from_a = start - bodies.clock[a]
    from_b = start - bodies.clock[b]
    vx = bodies.vx[b] + bodies.path_x[b] * from_b - bodies.vx[a] - bodies.path_x[a] * from_a
    vy = bodies.vy[b] + bodies.path_y[b] * from_b - bodies.vy[a] - bodies.path_y[a] * from_a
    more_x = (bodies.path_x[b] - bodies.path_x[a]) * (end - start)
    more_y = (bodies.path_y[b] - bodies.path_y[a]) * (end - start)
    bound = math.sqrt(vx * vx + vy * vy) + math.sqrt(more_x * more_x + more_y * more_y)
    bound += rim_speed(t, a, t.pairs.piece_a[pair], end - bodies.clock[a])
    return bound + rim_speed(t, b, t.pairs.piece_b[pair], end - bodies.clock[b])


def sense_at_end(t: Tables, pair_count: int) -> None:
    """Note which sensors overlap with bodies where these stand when the tick is over."""
    before = number_of_tick(t) - 1
    for pair in range(pair_count):
        if t.pairs.state[pair] != SENSING:
            continue
        clear = t.pairs.apart[pair] > 0.0 and t.pairs.touched[pair] < before
        if not clear and gap_at(t, pair, 0.0) <= 0.0:
            touch(t, pair)
