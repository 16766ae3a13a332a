"""Bodies that overlap deeply come apart without being thrown apart.

The springs of resting contacts push overlaps apart by velocities that they lend for a part of a
tick, and contacts that only push take them back (see `contacts`). Where many bodies overlap in one
place, most contacts carry nothing and have nothing to take back. So between bodies that overlap
deeply an impulse may also pull: it stops what leaves no faster than a push makes it. That is a
plastic impact, which can only take energy.
"""

from engine.kernels.following import DEEP
from engine.tables import Tables

PUSH = 2.0
"""Fastest correction of an overlap, in reaches of the smaller body a second (1/s)."""

MOST_SWEEPS = 12
"""Sweeps at most."""

CALM = 0.002
"""A sweep that changes no velocity by more is the last, in reaches a second (1/s)."""


def overlaps_deeply(t: Tables, pair: int) -> bool:
    """Whether a point of a resting contact lies deep within."""
    deep = -DEEP * t.pairs.size[pair]
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        if t.contacts.gap[row] < deep:
            return True
    return False


def part_gently(t: Tables, resting: int, part: float) -> None:
    """Take back the velocities that parting deep overlaps has lent in a part (s).

    Bodies have the velocities of the end of the part, and kicks that are about to replace them.
    """
    deep = 0
    for k in range(resting):
        pair = t.pairs.resting[k]
        if overlaps_deeply(t, pair):
            aim(t, pair, part)
            t.pairs.queue[deep] = pair  # nothing is queued any more
            deep += 1
    for _ in range(MOST_SWEEPS):
        if deep == 0 or not pull(t, deep):
            return


def aim(t: Tables, pair: int, part: float) -> None:
    """Set with which speed the points of a contact may leave each other (m/s): with none, unless
    they did so faster than by a push when the part (s) began.
    """
    bodies = t.bodies
    contacts = t.contacts
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    nx = t.pairs.normal_x[pair]
    ny = t.pairs.normal_y[pair]
    vx = bodies.vx[b] - bodies.path_x[b] * part - bodies.vx[a] + bodies.path_x[a] * part
    vy = bodies.vy[b] - bodies.path_y[b] * part - bodies.vy[a] + bodies.path_y[a] * part
    spin_a = bodies.spin[a] - bodies.path_spin[a] * part
    spin_b = bodies.spin[b] - bodies.path_spin[b] * part
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        leaves = vx * nx + vy * ny
        leaves += spin_b * contacts.normal_arm_b[row] - spin_a * contacts.normal_arm_a[row]
        contacts.target[row] = -leaves if leaves > PUSH * t.pairs.size[pair] else 0.0


def pull(t: Tables, deep: int) -> bool:
    """Solve each deep pair once; return whether a velocity changed by more than `CALM`."""
    bodies = t.bodies
    contacts = t.contacts
    wild = False
    for k in range(deep):
        pair = t.pairs.queue[k]
        a = t.pairs.a[pair]
        b = t.pairs.b[pair]
        nx = t.pairs.normal_x[pair]
        ny = t.pairs.normal_y[pair]
        for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
            arm_a = contacts.normal_arm_a[row]
            arm_b = contacts.normal_arm_b[row]
            speed = (bodies.kick_x[b] - bodies.kick_x[a]) * nx
            speed += (bodies.kick_y[b] - bodies.kick_y[a]) * ny
            speed += bodies.kick_spin[b] * arm_b - bodies.kick_spin[a] * arm_a
            change = -contacts.normal_mass[row] * (speed + contacts.target[row])
            if change < 0.0:
                contacts.normal_impulse[row] += change
                bodies.kick_x[a] -= bodies.inverse_mass[a] * change * nx
                bodies.kick_y[a] -= bodies.inverse_mass[a] * change * ny
                bodies.kick_spin[a] -= bodies.inverse_inertia[a] * change * arm_a
                bodies.kick_x[b] += bodies.inverse_mass[b] * change * nx
                bodies.kick_y[b] += bodies.inverse_mass[b] * change * ny
                bodies.kick_spin[b] += bodies.inverse_inertia[b] * change * arm_b
                if -change > CALM * t.pairs.size[pair] * contacts.normal_mass[row]:
                    wild = True
    return wild
