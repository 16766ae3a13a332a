"""Which pairs rest on each other, and when they stop to.

A pair rests if it touches and would be back, if it left with its present speed, before a substep
is over: what forces do within a substep explains its motion. Nothing else decides between rest and
impact; there is no speed below which bodies do not bounce.
"""

from engine.contacts import kick, place_middle, prepare
from engine.impacts import acceleration, stays, strike
from engine.meeting import STILL, approach_at, notice_passing, wall_of
from engine.pose import velocity_at
from engine.tables import FREE, RESTING, Tables

TOUCHING = 1e-5
"""Gap at which a still pair comes to rest, as a share of the smaller body's reach."""

KEEPING = 5e-3
"""Gap beyond which a resting pair has parted, in the same unit."""

OVERLAP = 1e-3
"""Overlap that has to be pushed apart whatever the motion, in the same unit."""


def settle(t: Tables, count: int, pair_count: int, shortest: float) -> int:
    """List the pairs that rest at the start of a part; count for each body those it is held by.

    Args:
        t: the tables; clocks stand at zero.
        count: number of bodies.
        pair_count: number of pairs.
        shortest: flight that counts as none (s).
    """
    pairs = t.pairs
    resting = 0
    for pair in range(pair_count):
        notice_passing(t, pair)
        if pairs.state[pair] == FREE:
            pairs.points[pair] = 0
        if pairs.state[pair] == FREE and nearly_touch(t, pair) and comes_to_rest(t, pair, shortest):
            pairs.state[pair] = RESTING
            pairs.carried[pair] = 0.0
        if pairs.state[pair] == RESTING:
            pairs.resting[resting] = pair
            resting += 1
    count_holds(t, count, resting)
    return resting


def count_holds(t: Tables, count: int, resting: int) -> None:
    """Count for each body the resting contacts that hold it."""
    for row in range(count):
        t.bodies.held[row] = 0
    for k in range(resting):
        pair = t.pairs.resting[k]
        t.bodies.held[t.pairs.a[pair]] += 1
        t.bodies.held[t.pairs.b[pair]] += 1


def nearly_touch(t: Tables, pair: int) -> bool:
    """Whether the bounding circles of a pair, or circle and wall line, nearly touch."""
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    slack = TOUCHING * t.pairs.size[pair]
    wall = wall_of(t, pair)
    if wall < 0:
        x = bodies.x[b] - bodies.x[a]
        y = bodies.y[b] - bodies.y[a]
        reach = bodies.reach[a] + bodies.reach[b] + slack
        return x * x + y * y <= reach * reach
    body = a + b - t.pieces.body[wall]
    first = t.pieces.first[wall]
    above = t.corners.world_normal_x[first] * (
        bodies.x[body] - t.corners.world_x[first]
    ) + t.corners.world_normal_y[first] * (bodies.y[body] - t.corners.world_y[first])
    reach = bodies.reach[body] + t.pieces.radius[wall] + slack
    return -reach <= above <= reach


def comes_to_rest(t: Tables, pair: int, shortest: float) -> bool:
    """Whether a free pair that nearly touches rests from now on."""
    size = t.pairs.size[pair]
    speed = approach_at(t, pair, 0.0)
    gap = t.touch.gap[0]
    if gap > TOUCHING * size:
        return False
    if gap < -OVERLAP * size and -size < speed <= STILL:
        return True
    return stays(t, pair, speed if speed > 0.0 else -speed, shortest, True)


def hold(t: Tables, count: int, resting: int, now: float, part: float, shortest: float) -> int:
    """Solve the resting contacts for a part of the tick (s); return how many pairs still rest.

    Contacts that close faster than forces explain are struck first: a box that rocks on a corner
    slaps the floor with the other.
    """
    for again in (False, True):
        place_middle(t, count, part / 2.0)
        struck = False
        kept = 0
        for k in range(resting):
            pair = t.pairs.resting[k]
            if t.pairs.state[pair] == RESTING:
                prepare(t, pair, part / 2.0)
                explained = settling_speed(t, pair, part)
                if has_parted(t, pair, explained):
                    t.pairs.state[pair] = FREE
                    t.pairs.points[pair] = 0
                    continue
                room = t.impacts.written[0] < len(t.impacts.a)
                if room and not again and slaps(t, pair, part, explained):
                    strike(t, pair, now, 0.0, shortest, part, False)
                    struck = True
                t.pairs.resting[kept] = pair
                kept += 1
        resting = kept
        if not struck:
            break
    count_holds(t, count, resting)
    for row in range(count):
        if t.bodies.held[row] == 0:
            t.bodies.path_x[row] = t.bodies.ax[row]
            t.bodies.path_y[row] = t.bodies.ay[row]
            t.bodies.path_spin[row] = t.bodies.aspin[row]
    if resting > 0:
        kick(t, resting, count, part)
    return resting


def explained_speed(t: Tables, pair: int, part: float) -> float:
    """The most that forces, directly or through other bodies, change a contact in a part (m/s)."""
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    nx = t.pairs.normal_x[pair]
    ny = t.pairs.normal_y[pair]
    of_a = bodies.ax[a] * nx + bodies.ay[a] * ny
    of_b = bodies.ax[b] * nx + bodies.ay[b] * ny
    fall = (of_a if of_a > 0.0 else -of_a) + (of_b if of_b > 0.0 else -of_b)
    return 2.0 * (fall * part + t.pairs.carried[pair]) + STILL


def settling_speed(t: Tables, pair: int, part: float) -> float:
    """The same where other contacts may turn forces into any direction (m/s)."""
    fall = acceleration(t.bodies, t.pairs.a[pair]) + acceleration(t.bodies, t.pairs.b[pair])
    return 2.0 * (fall * part + t.pairs.carried[pair]) + STILL


def has_parted(t: Tables, pair: int, explained: float) -> bool:
    """Whether a resting pair, just measured, has let go."""
    size = t.pairs.size[pair]
    lowest = 1e300
    fastest = -1e300
    for i in range(t.pairs.points[pair]):
        if t.touch.gap[i] < lowest:
            lowest = t.touch.gap[i]
        speed = closing(t, pair, i)
        if speed > fastest:
            fastest = speed
    return lowest > KEEPING * size or (lowest > -OVERLAP * size and fastest < -explained)


def slaps(t: Tables, pair: int, part: float, explained: float) -> bool:
    """Whether a point of a resting pair that carries nothing will be hit faster than explained.

    Points that carry have the velocity that the last part left them: what is wrong with it is the
    error of the solver, which the next sweep mends.
    """
    for i in range(t.pairs.points[pair]):
        if t.contacts.normal_impulse[2 * pair + i] > 0.0:
            continue
        speed = closing(t, pair, i)
        if speed > explained and t.touch.gap[i] <= speed * part / 2.0:
            return True
    return False


def closing(t: Tables, pair: int, point: int) -> float:
    """Speed (m/s) at the start of the part with which the bodies approach at a point of `Touch`."""
    x = t.touch.x[point]
    y = t.touch.y[point]
    ax, ay = velocity_at(t.bodies, t.pairs.a[pair], 0.0, x, y)
    bx, by = velocity_at(t.bodies, t.pairs.b[pair], 0.0, x, y)
    return (ax - bx) * t.pairs.normal_x[pair] + (ay - by) * t.pairs.normal_y[pair]
