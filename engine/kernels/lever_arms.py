"""Lever arms of resting contacts, corrected once it is known where their bodies went.

An impulse acts all through its part; the lever arms were those of the middle of the planned paths.
What an impact, or an early end, adds to the mean positions adds to the arms, or angular momentum
would not be kept.
"""

from engine.kernels.books import book_turn
from engine.kernels.following import share_of_b
from engine.kernels.halting import book_shift_by_ground
from engine.linkage.limb_sweeps import turn_limbs_by_shift
from engine.linkage.positions import follow_joints, follow_late
from engine.linkage.tally import joints_jolt
from engine.tables import Tables


def correct_arms(
    t: Tables, resting: int, count: int, first: int, now: float, part: float, reached: float
) -> None:
    """Correct the torques of contacts whose bodies did not go their planned paths.

    Args:
        t: the tables; bodies stand at the end of the part.
        resting: number of pairs that rested when it began.
        count: number of bodies.
        first: first row in `Impacts` of this part.
        now: when the part began, since the tick began (s).
        part: its planned length (s).
        reached: after which it ended (s).
    """
    if reached == part and t.impacts.written[0] == first and not joints_jolt(t):
        return
    shift_paths(t, count, first, now, part, reached)
    for k in range(resting):
        turn_by_shift(t, t.pairs.resting[k], reached / part)
    turn_limbs_by_shift(t, reached / part)


def shift_paths(t: Tables, count: int, first: int, now: float, part: float, reached: float) -> None:
    """Find how far the mean positions of held bodies are from the middle of their planned paths."""
    bodies = t.bodies
    impacts = t.impacts
    early = (reached - part) / 2.0
    for row in range(count):
        bodies.shift_x[row] = 0.0
        bodies.shift_y[row] = 0.0
        if bodies.held[row] > 0:
            bodies.shift_x[row] = (bodies.kick_x[row] - bodies.path_x[row] * part) * early
            bodies.shift_y[row] = (bodies.kick_y[row] - bodies.path_y[row] * part) * early
    follow_joints(t, part, reached)
    for i in range(first, impacts.written[0]):
        left = reached - (impacts.time[i] - now)
        if left > 0.0:
            weight = left * left / (2.0 * reached)
            a = impacts.a[i]
            b = impacts.b[i]
            bodies.shift_x[a] -= impacts.impulse_x[i] * bodies.inverse_mass[a] * weight
            bodies.shift_y[a] -= impacts.impulse_y[i] * bodies.inverse_mass[a] * weight
            bodies.shift_x[b] += impacts.impulse_x[i] * bodies.inverse_mass[b] * weight
            bodies.shift_y[b] += impacts.impulse_y[i] * bodies.inverse_mass[b] * weight
    follow_late(t, reached)


def turn_by_shift(t: Tables, pair: int, done: float) -> None:
    """Correct the torque of one contact; `done` is the share of its impulse that was given."""
    bodies = t.bodies
    contacts = t.contacts
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    x = bodies.shift_x[b] - bodies.shift_x[a]
    y = bodies.shift_y[b] - bodies.shift_y[a]
    if x == 0.0 and y == 0.0:
        return
    of_a = share_of_b(t, pair)
    nx = t.pairs.normal_x[pair]
    ny = t.pairs.normal_y[pair]
    for row in range(2 * pair, 2 * pair + t.pairs.acting[pair]):
        jx = contacts.normal_impulse[row] * nx - contacts.tangent_impulse[row] * ny
        jy = contacts.normal_impulse[row] * ny + contacts.tangent_impulse[row] * nx
        turn = (x * jy - y * jx) * done
        book_shift_by_ground(t, a, b, turn)
        if bodies.inverse_mass[b] == 0.0:  # it is round: the contact stays where it is
            t.books.wall_turn[0] -= of_a * turn
        book_turn(t, a, -of_a * turn)
        book_turn(t, b, (of_a - 1.0) * turn)
        bodies.spin[a] -= of_a * turn * bodies.inverse_inertia[a]
        bodies.spin[b] -= (1.0 - of_a) * turn * bodies.inverse_inertia[b]
