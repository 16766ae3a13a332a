"""What two bodies give each other where they meet.

The impulse along the normal is the exact answer for a single impact (thesis, eq. 40, with e for
restitution): P = -(1 + e) v_n / (1/m_a + 1/m_b + (r_a x n)^2/I_a + (r_b x n)^2/I_b). Two points of
one pair that touch at the same instant (a side that lands flat) share it so that both leave with e
times their approach, or one of them does and the other is not pressed in. Friction follows as an
impulse against the sliding, at most mu times P, or as much as stops it where static friction holds;
as it comes second and never reverses the sliding, no impact gains energy.
"""

from engine.kernels.circles import stillness
from engine.kernels.curves import note_blow
from engine.kernels.impulses import (
    WEDGED,
    approach,
    change_of,
    give,
    note_given,
    response,
    slip,
    split,
    write_impact,
)
from engine.kernels.rubbing import belt_speed
from engine.tables import Tables

BLOWS = 64
"""So often at most is stopped at one instant what friction drives together again."""

OPENS = 2e-4
"""What opens at a smaller share of the speed at which another point approaches rests there, but for
the errors of resting contacts."""


def exchange(t: Tables, pair: int, one: int, other: int, bounce: float, time: float) -> None:
    """Give both bodies their impulses, along the normal, then against the sliding; report them.

    Friction may drive together again what does not bounce: that is stopped as often as it happens,
    all as one impact. What bounces meets anew.

    Args:
        t: the tables.
        pair: which pair.
        one: the point of `Touch` that approaches fastest.
        other: the other that takes part, or -1.
        bounce: 1 and the restitution.
        time: since the tick began (s).
    """
    still = stillness(t, pair)
    came = approach(t, pair, one)
    total = along = x = y = 0.0
    for _ in range(BLOWS):
        push, rub, at_x, at_y, speed = blow(t, pair, one, other, bounce)
        if total == 0.0:
            came = speed
        total += push
        along += rub
        x += push * at_x
        y += push * at_y
        if other >= 0 and approach(t, pair, other) > approach(t, pair, one):
            one, other = other, one
        if bounce > 1.0 or approach(t, pair, one) <= still:
            break
    write_impact(t, pair, x / total, y / total, total, along, came, time)


def blow(
    t: Tables, pair: int, one: int, other: int, bounce: float
) -> tuple[float, float, float, float, float]:
    """Give both bodies an impulse along the normal, then one against the sliding.

    Returns both (N s), where they act (m), and the speed of approach there (m/s).
    """
    x = t.touch.x[one]
    y = t.touch.y[one]
    speed = approach(t, pair, one)
    normal_x = t.touch.normal_x[0]
    normal_y = t.touch.normal_y[0]
    yields = response(t, pair, x, y, normal_x, normal_y)
    total = bounce * speed / yields
    if other >= 0:
        there = approach(t, pair, other)
        v2 = change_of(there, bounce)
        share, both = share_of_two(t, pair, one, other, bounce * speed, v2)
        at_x = x + share * (t.touch.x[other] - x)
        at_y = y + share * (t.touch.y[other] - y)
        mean = speed + share * (there - speed)
        between = response(t, pair, at_x, at_y, normal_x, normal_y)
        if not gives_energy(both, mean, between):
            x = at_x
            y = at_y
            total = both
            speed = mean
            yields = between
    before = slip(t, pair, x, y) + belt_speed(t, pair, normal_x, normal_y)
    press(t, pair, x, y, total, speed, yields)
    along = rub(t, pair, x, y, total, before)
    note_given(t, pair, x, y, total, along)
    return total, along, x, y, speed


def gives_energy(total: float, speed: float, yields: float) -> bool:
    """Whether an impulse (N s) gives energy, which is that of two points struck at once, between
    which bodies approach at `speed` (m/s) and a unit impulse changes that by `yields` (1/kg): one
    opens, and what bounces at the other drives it back. It is left alone then, and struck itself
    if it approaches afterwards.
    """
    return total * yields / 2.0 > (1.0 + OPENS) * speed


def press(
    t: Tables, pair: int, x: float, y: float, total: float, speed: float, yields: float
) -> None:
    """Give both bodies the impulse `total` (N s) along the normal at (x, y), where they approach at
    `speed` (m/s) and a unit impulse changes that by `yields` (1/kg).
    """
    normal_x = t.touch.normal_x[0]
    normal_y = t.touch.normal_y[0]
    lost = total * (speed - total * yields / 2.0)
    t.books.restitution_heat[0] += lost
    note_blow(t, pair, lost)
    give(t, pair, x, y, total * normal_x, total * normal_y)


def rub(t: Tables, pair: int, x: float, y: float, total: float, before: float) -> float:
    """Give both bodies the impulse of friction at (x, y), where the one along the normal was
    `total` (N s) and they slid at a speed `before` it (m/s); return it (N s).
    """
    normal_x = t.touch.normal_x[0]
    normal_y = t.touch.normal_y[0]
    belt = belt_speed(t, pair, normal_x, normal_y)
    sliding = slip(t, pair, x, y) + belt
    stiffness = response(t, pair, x, y, -normal_y, normal_x)
    along = -sliding / stiffness
    most = t.pairs.friction[pair] * total
    if (along > most or along < -most) and not sticks(t, pair, before, sliding, stiffness, total):
        along = most if along > 0.0 else -most
    t.books.friction_heat[0] -= along * (sliding + along * stiffness / 2.0)
    t.books.wall_work[0] -= along * belt
    give(t, pair, x, y, -along * normal_y, along * normal_x)
    return along


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


def share_of_two(
    t: Tables, pair: int, one: int, other: int, v1: float, v2: float
) -> tuple[float, float]:
    """Solve for both points at once, of which speeds of approach are to change by v1 and v2 (m/s):
    share of the second and impulse of both along the normal.

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
    return split(k11, k12, k22, v1, v2, WEDGED)
