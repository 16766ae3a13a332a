"""Newton's third law when two bodies meet: equal and opposite impulses.

Whether they part again, or rest on each other from then on, is decided here; where they touch is
found by `footprint`, what they give each other by `exchange`, or by `simultaneous` where one of
them meets others at the same instant.
"""

import math

from engine.kernels.circles import stillness
from engine.kernels.exchange import exchange
from engine.kernels.footprint import points_struck
from engine.kernels.impulses import approach
from engine.kernels.joined_impacts import amends_of_pair, approach_allowed, exchange_with_joints
from engine.kernels.pose import advance
from engine.kernels.sensing import sense_before
from engine.kernels.sleeping import wake
from engine.kernels.touches import note_impact
from engine.linkage.tally import is_joined
from engine.tables import FREE, RESTING, Bodies, Tables

BOUNCES = 2
"""So many flights on end of less than a substep are none, unless bodies are perfectly elastic: what
drums on its neighbours in a heap rests on them."""

AGAIN = 6.0
"""Bodies that met within so many substeps have just met."""


def strike(
    t: Tables,
    pair: int,
    now: float,
    time: float,
    shortest: float,
    near: float,
    plastic: bool,
) -> bool:
    """Let a pair collide at `time` of the present part (s); return whether it rests from then on.

    Args:
        t: the tables.
        pair: which pair.
        now: when the part began, since the tick began (s).
        time: of the impact, since the part began (s).
        shortest: a flight shorter than this (s) is none: the bodies stay together.
        near: points with no wider gap (m) are struck as well.
        plastic: whether to take restitution as zero, as the end of endless bouncing.
    """
    come_together(t, pair, time)
    points = points_struck(t, pair, time, near)
    one, other, speed = choose_points(t, pair, points, near)
    if one < 0:
        return t.pairs.state[pair] == RESTING
    joined = is_joined(t, pair)
    amiss = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    if joined:
        amiss = amends_of_pair(t, pair, time)
        speed = approach_allowed(t, pair, one, amiss)
    rests = comes_to_stay(t, pair, speed, now + time, shortest, plastic)
    bounce = 1.0 if rests else 1.0 + t.pairs.restitution[pair]
    if joined:
        exchange_with_joints(t, pair, one, other, bounce, now, time, amiss)
        if rests and t.pairs.state[pair] != RESTING:  # where joints jam, nothing was given
            note_impact(t, pair, t.touch.x[one], t.touch.y[one], 0.0, 0.0)
    else:
        exchange(t, pair, one, other, bounce, now + time)
    leave_struck(t, pair, rests, now + time, shortest)
    return rests


def come_together(t: Tables, pair: int, time: float) -> None:
    """Move both bodies to where they are struck at `time` of the part (s), and wake who sleeps."""
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    if t.bodies.asleep[a] != t.bodies.asleep[b]:
        wake(t, a if t.bodies.asleep[a] == 1 else b)
    sense_before(t, pair, time)
    come(t, a, time)
    come(t, b, time)


def comes_to_stay(
    t: Tables, pair: int, speed: float, time: float, shortest: float, plastic: bool
) -> bool:
    """Whether a pair that is struck with a speed (m/s) at a time of the tick (s) rests from then
    on; see `strike`.
    """
    restitution = t.pairs.restitution[pair]
    flown = time - t.pairs.struck[pair]
    if restitution < 1.0 and flown < shortest and t.pairs.bounces[pair] + 1 >= BOUNCES:
        return True
    return plastic or stays(t, pair, restitution * speed, shortest, flown < shortest * AGAIN)


def leave_struck(t: Tables, pair: int, rests: bool, time: float, shortest: float) -> None:
    """Note that a pair was struck at a time of the tick (s), and whether it rests from then on;
    count its flights on end that were none.
    """
    pairs = t.pairs
    flown = time - pairs.struck[pair]
    pairs.bounces[pair] = pairs.bounces[pair] + 1 if flown < shortest else 0
    pairs.struck[pair] = time
    pairs.apart[pair] = 0.0
    if rests and pairs.state[pair] != RESTING:
        pairs.points[pair] = 0
    pairs.state[pair] = RESTING if rests else FREE


def come(t: Tables, row: int, time: float) -> None:
    """Move a body to where it is struck at `time` of the part (s); note with what velocity."""
    bodies = t.bodies
    advance(t, row, time)
    bodies.came_x[row] = bodies.vx[row]
    bodies.came_y[row] = bodies.vy[row]
    bodies.came_spin[row] = bodies.spin[row]


def choose_points(t: Tables, pair: int, points: int, near: float) -> tuple[int, int, float]:
    """Which of the points in `Touch` take part (-1: none), and the fastest approach (m/s).

    One that touches takes part beside one that approaches: it may have to keep from being pressed
    in.
    """
    first = approach(t, pair, 0)
    still = stillness(t, pair)
    if points == 1:
        return (0, -1, first) if first > still else (-1, -1, first)
    second = approach(t, pair, 1)
    gap_0 = t.touch.gap[0]
    gap_1 = t.touch.gap[1]
    within = (gap_0 if gap_0 < gap_1 else gap_1) + 1e-8 * t.pairs.size[pair]
    if within < near:
        within = near
    near_0 = gap_0 <= within
    near_1 = gap_1 <= within
    if near_0 and near_1 and (first > still or second > still):
        if first >= second:
            return 0, 1, first
        return 1, 0, second
    if near_0 and first > still:
        return 0, -1, first
    if near_1 and second > still:
        return 1, -1, second
    return -1, -1, first


def stays(t: Tables, pair: int, leaving: float, shortest: float, again: bool) -> bool:
    """Whether bodies that leave each other with a speed (m/s) are back before `shortest` (s).

    What drives them back is their relative acceleration, or, for bodies held by others, any of
    the two accelerations; if they have just met (`again`), these in any direction.
    """
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    normal_x = t.touch.normal_x[0]
    normal_y = t.touch.normal_y[0]
    of_a = bodies.ax[a] * normal_x + bodies.ay[a] * normal_y
    of_b = bodies.ax[b] * normal_x + bodies.ay[b] * normal_y
    fall = of_a - of_b
    if bodies.held[a] != 0 or bodies.held[b] != 0:
        if again:
            fall = acceleration(bodies, a) + acceleration(bodies, b)
        else:
            fall = (of_a if of_a > 0.0 else -of_a) + (of_b if of_b > 0.0 else -of_b)
    return leaving <= stillness(t, pair) or 2.0 * leaving < fall * shortest


def acceleration(bodies: Bodies, row: int) -> float:
    """Size of the acceleration of a body by all but contacts (m/s^2)."""
    return math.sqrt(bodies.ax[row] * bodies.ax[row] + bodies.ay[row] * bodies.ay[row])


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
    return 2.0 * (fall * part + t.pairs.carried[pair]) + stillness(t, pair)


def settling_speed(t: Tables, pair: int, part: float) -> float:
    """The same where other contacts may turn forces into any direction (m/s)."""
    fall = acceleration(t.bodies, t.pairs.a[pair]) + acceleration(t.bodies, t.pairs.b[pair])
    return 2.0 * (fall * part + t.pairs.carried[pair]) + stillness(t, pair)
