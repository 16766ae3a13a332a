"""Newton's third law when bodies meet: equal and opposite impulses, one pair after another.

The impulse along the normal is the exact answer for a single impact (thesis, eq. 40, with e for
restitution): P = -(1 + e) v_n / (1/m_a + 1/m_b + (r_a x n)^2/I_a + (r_b x n)^2/I_b). Two points of
one pair that touch at the same instant (a side that lands flat) share it so that both leave with e
times their approach, or one of them does and the other is not pressed in. Friction follows as an
impulse against the sliding, at most mu times P, or as much as stops it where static friction holds;
as it comes second and never reverses the sliding, no impact gains energy.
"""

import math

from engine.kernels.circles import stillness
from engine.kernels.impulses import (
    WEDGED,
    approach,
    change_of,
    give,
    report,
    response,
    slip,
    split,
)
from engine.kernels.joined_impacts import exchange_with_joints
from engine.kernels.pose import advance, place_pair
from engine.kernels.rubbing import belt_speed
from engine.kernels.sensing import sense_before
from engine.kernels.sleeping import wake
from engine.kernels.touches import touch
from engine.linkage.tally import is_joined
from engine.manifolds.any_pair import touching_points
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
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    if bodies.asleep[a] != bodies.asleep[b]:
        wake(t, a if bodies.asleep[a] == 1 else b)
    sense_before(t, pair, time)
    come(t, a, time)
    come(t, b, time)
    place_pair(t, pair, time)
    points = touching_points(t, pair)
    one, other, speed = choose_points(t, pair, points, near)
    if one < 0:
        return t.pairs.state[pair] == RESTING
    restitution = t.pairs.restitution[pair]
    flown = now + time - t.pairs.struck[pair]
    t.pairs.bounces[pair] = t.pairs.bounces[pair] + 1 if flown < shortest else 0
    again = flown < shortest * AGAIN
    rests = plastic or stays(t, pair, restitution * speed, shortest, again)
    if restitution < 1.0 and t.pairs.bounces[pair] >= BOUNCES:
        rests = True
    bounce = 1.0 if rests else 1.0 + restitution
    if is_joined(t, pair):
        exchange_with_joints(t, pair, one, other, bounce, now, time)
    else:
        exchange(t, pair, one, other, bounce, now + time)
    t.pairs.struck[pair] = now + time
    t.pairs.apart[pair] = 0.0
    if rests and t.pairs.state[pair] != RESTING:
        touch(t, pair)  # where joints jam, nothing was given
        t.pairs.points[pair] = 0
    t.pairs.state[pair] = RESTING if rests else FREE
    return rests


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


def exchange(t: Tables, pair: int, one: int, other: int, bounce: float, time: float) -> None:
    """Give both bodies their impulses, along the normal, then against the sliding; report them."""
    x = t.touch.x[one]
    y = t.touch.y[one]
    speed = approach(t, pair, one)
    normal_x = t.touch.normal_x[0]
    normal_y = t.touch.normal_y[0]
    total = bounce * speed / response(t, pair, x, y, normal_x, normal_y)
    if other >= 0:
        share, total = share_of_two(t, pair, one, other, bounce)
        x += share * (t.touch.x[other] - x)
        y += share * (t.touch.y[other] - y)
        speed += share * (approach(t, pair, other) - speed)
    stiffness = response(t, pair, x, y, normal_x, normal_y)
    t.books.restitution_heat[0] += total * (speed - total * stiffness / 2.0)
    belt = belt_speed(t, pair, normal_x, normal_y)
    before = slip(t, pair, x, y) + belt
    give(t, pair, x, y, total * normal_x, total * normal_y)
    sliding = slip(t, pair, x, y) + belt
    stiffness = response(t, pair, x, y, -normal_y, normal_x)
    along = -sliding / stiffness
    most = t.pairs.friction[pair] * total
    if (along > most or along < -most) and not sticks(t, pair, before, sliding, stiffness, total):
        along = most if along > 0.0 else -most
    t.books.friction_heat[0] -= along * (sliding + along * stiffness / 2.0)
    t.books.wall_work[0] -= along * belt
    give(t, pair, x, y, -along * normal_y, along * normal_x)
    report(t, pair, x, y, total, along, speed, time)


def sticks(
    t: Tables, pair: int, before: float, after: float, stiffness: float, total: float
) -> bool:
    """Whether static friction holds a pair for which kinetic friction is too weak (Routh, "Dynamics
    of a System of Rigid Bodies", 1905, art. 187).

    As the normal impulse grows, the sliding changes by a fixed rate, which friction of either kind
    opposes. It must have come to an end by kinetic friction, or not have been there; then static
    friction holds if it is no weaker than the rate.

    Args:
        t: the tables.
        pair: which pair.
        before: sliding before the normal impulse (m/s).
        after: sliding after it, without friction (m/s).
        stiffness: change of the sliding by a unit impulse along it (1/kg).
        total: the normal impulse (N s).
    """
    grip = t.pairs.static_friction[pair]
    friction = t.pairs.friction[pair]
    driven = after - before
    if grip <= friction or abs(driven) > grip * stiffness * total:
        return False
    with_it = driven if before > 0.0 else -driven
    return abs(before) <= stillness(t, pair) or (
        abs(before) + with_it <= friction * stiffness * total
    )


def share_of_two(t: Tables, pair: int, one: int, other: int, bounce: float) -> tuple[float, float]:
    """Solve for both points at once: share of the second and impulse of both along the normal.

    The share is between 0 and 1. Where one of them would have to pull, the other does it alone.
    """
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    nx = t.touch.normal_x[0]
    ny = t.touch.normal_y[0]
    a_1 = (t.touch.x[one] - bodies.here_x[a]) * ny - (t.touch.y[one] - bodies.here_y[a]) * nx
    b_1 = (t.touch.x[one] - bodies.here_x[b]) * ny - (t.touch.y[one] - bodies.here_y[b]) * nx
    a_2 = (t.touch.x[other] - bodies.here_x[a]) * ny - (t.touch.y[other] - bodies.here_y[a]) * nx
    b_2 = (t.touch.x[other] - bodies.here_x[b]) * ny - (t.touch.y[other] - bodies.here_y[b]) * nx
    mass = bodies.inverse_mass[a] + bodies.inverse_mass[b]
    turn_a = bodies.inverse_inertia[a]
    turn_b = bodies.inverse_inertia[b]
    k11 = mass + a_1 * a_1 * turn_a + b_1 * b_1 * turn_b
    k22 = mass + a_2 * a_2 * turn_a + b_2 * b_2 * turn_b
    k12 = mass + a_1 * a_2 * turn_a + b_1 * b_2 * turn_b
    v1 = bounce * approach(t, pair, one)
    v2 = change_of(approach(t, pair, other), bounce)
    return split(k11, k12, k22, v1, v2, WEDGED)
