"""Bodies that overlap deeply are moved apart, and get no velocity by it.

The springs of resting contacts push small overlaps apart by velocities that they lend for a part of
a tick, and sweeps without the spring take them back (see `contacts`). Where many bodies stand in
one place, no sweeps would suffice. So what overlaps deeply is moved at the end of the tick, by
impulses that change positions alone (nonlinear Gauss-Seidel: Erin Catto, "Modeling and solving
constraints", 2009).

Equal and opposite, they keep the centre of mass. Angular momentum r x v of two that slide over each
other grows as they part; they slide the slower for it, like a skater who stretches out the arms.
"""

import math

from engine.kernels.books import work_of
from engine.kernels.following import DEEP, find_points, follow, has_drifted
from engine.kernels.meeting import swing_of
from engine.kernels.moments import turn_of
from engine.kernels.spring import sag
from engine.kernels.touches import collect
from engine.linkage.tally import is_joined
from engine.tables import RESTING, Tables

PACE = 2.0
"""Fastest correction of a deep overlap, in reaches of the smaller body a second (1/s)."""

NEARLY = 1.25
"""What a spring yields may be exceeded by so much when moving ends, or loads that press a contact
just a little deeper would have it moved for ever."""

MOST_SWEEPS = 12
"""Sweeps at most."""

CALM = 1e-5
"""A sweep that moves no contact by more is the last, in reaches of the smaller body."""


def is_parting(t: Tables, pair: int) -> bool:
    """Whether a resting contact is left to `move_apart`: if it overlaps deeply, or by more than its
    spring yields where one of its bodies was moved a tick ago. What joints hold would be torn.
    """
    if is_joined(t, pair):
        return False
    most = DEEP * t.pairs.size[pair]
    if t.bodies.parting[t.pairs.a[pair]] == 1 or t.bodies.parting[t.pairs.b[pair]] == 1:
        most = NEARLY * sag(t, pair)
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        if t.contacts.gap[row] < -most:
            return True
    return False


def move_apart(t: Tables, count: int, pair_count: int, dt: float) -> None:
    """Move bodies that overlap deeply at the end of a tick (s)."""
    bodies = t.bodies
    for row in range(count):
        bodies.middle_x[row] = bodies.x[row]
        bodies.middle_y[row] = bodies.y[row]
        bodies.middle_angle[row] = bodies.angle[row]
        bodies.kick_x[row] = bodies.kick_y[row] = bodies.kick_spin[row] = 0.0
        bodies.shoved[row] = 0
    listed = 0
    for pair in range(pair_count):
        if t.pairs.state[pair] == RESTING and not is_joined(t, pair):
            if t.pairs.points[pair] > 0:
                follow(t, pair, 0.0)
            if has_drifted(t, pair):
                collect(t, pair, 1.0)  # its impulses may change their direction, or get lost
                find_points(t, pair, 0.0)
                collect(t, pair, -1.0)
            aim(t, pair, dt)
            t.pairs.queue[listed] = pair  # nothing is queued any more
            listed += 1
    for _ in range(MOST_SWEEPS):
        if not shove(t, listed):
            break
    for k in range(listed):
        shift(t, t.pairs.queue[k])
    for row in range(count):
        turn_in_place(t, row)
    for pair in range(pair_count):
        left = t.pairs.apart[pair] - bodies.way[t.pairs.a[pair]] - bodies.way[t.pairs.b[pair]]
        t.pairs.apart[pair] = left if left > 0.0 else 0.0


def aim(t: Tables, pair: int, dt: float) -> None:
    """Set by how much the points of a contact are to close in this tick (m), negative: to open."""
    contacts = t.contacts
    size = t.pairs.size[pair]
    most = PACE * size * dt
    left = sag(t, pair)
    parting = is_parting(t, pair)
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        gap = contacts.gap[row]
        contacts.booked_normal[row] = 0.0
        contacts.target[row] = gap if gap > 0.0 else 0.0
        way = -left - gap
        if parting and way > 0.0:
            contacts.target[row] = -way if way < most else -most


def shove(t: Tables, listed: int) -> bool:
    """Solve each pair once for ways instead of velocities; return whether one moved. Most need
    not open, and nothing has moved their bodies.
    """
    bodies = t.bodies
    contacts = t.contacts
    moved = False
    for k in range(listed):
        pair = t.pairs.queue[k]
        a = t.pairs.a[pair]
        b = t.pairs.b[pair]
        if bodies.shoved[a] + bodies.shoved[b] == 0 and not opens(t, pair):
            continue
        bodies.shoved[a] = 1 if bodies.inverse_mass[a] > 0.0 else 0
        bodies.shoved[b] = 1 if bodies.inverse_mass[b] > 0.0 else 0
        nx = t.pairs.normal_x[pair]
        ny = t.pairs.normal_y[pair]
        for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
            arm_a = contacts.normal_arm_a[row]
            arm_b = contacts.normal_arm_b[row]
            way = (bodies.kick_x[b] - bodies.kick_x[a]) * nx
            way += (bodies.kick_y[b] - bodies.kick_y[a]) * ny
            way += bodies.kick_spin[b] * arm_b - bodies.kick_spin[a] * arm_a
            before = contacts.booked_normal[row]
            after = before - contacts.normal_mass[row] * (way + contacts.target[row])
            if after < 0.0:
                after = 0.0
            change = after - before
            contacts.booked_normal[row] = after
            bodies.kick_x[a] -= bodies.inverse_mass[a] * change * nx
            bodies.kick_y[a] -= bodies.inverse_mass[a] * change * ny
            bodies.kick_spin[a] -= bodies.inverse_inertia[a] * change * arm_a
            bodies.kick_x[b] += bodies.inverse_mass[b] * change * nx
            bodies.kick_y[b] += bodies.inverse_mass[b] * change * ny
            bodies.kick_spin[b] += bodies.inverse_inertia[b] * change * arm_b
            if abs(change) > CALM * t.pairs.size[pair] * contacts.normal_mass[row]:
                moved = True
    return moved


def opens(t: Tables, pair: int) -> bool:
    """Whether a point of a contact is to open."""
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        if t.contacts.target[row] < 0.0:
            return True
    return False


def shift(t: Tables, pair: int) -> None:
    """Move the centres of a pair as its contact wants, and keep its angular momentum."""
    bodies = t.bodies
    push = 0.0
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        push += t.contacts.booked_normal[row]
    if push == 0.0:
        return
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    x = push * t.pairs.normal_x[pair]
    y = push * t.pairs.normal_y[pair]
    move(t, a, -x, -y)
    move(t, b, x, y)
    if bodies.inverse_mass[a] > 0.0 and bodies.inverse_mass[b] > 0.0:
        gained = x * (bodies.vy[b] - bodies.vy[a]) - y * (bodies.vx[b] - bodies.vx[a])
        if gained != 0.0:
            give_back(t, pair, gained)


def give_back(t: Tables, pair: int, gained: float) -> None:
    """Take from two bodies the angular momentum (N m s) that they gained by where they are now.

    Their motion about their common centre is a rotation as if they were one, which alone carries
    angular momentum, and a rest. The one is changed; the other shrinks if the energy would grow.
    """
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    mass = 1.0 / (bodies.inverse_mass[a] + bodies.inverse_mass[b])
    inertia_a = turning_inertia(t, a, t.pairs.piece_a[pair])
    inertia_b = turning_inertia(t, b, t.pairs.piece_b[pair])
    spin_a = bodies.spin[a]
    spin_b = bodies.spin[b]
    x = bodies.x[b] - bodies.x[a]
    y = bodies.y[b] - bodies.y[a]
    vx = bodies.vx[b] - bodies.vx[a]
    vy = bodies.vy[b] - bodies.vy[a]
    inertia = mass * (x * x + y * y) + inertia_a + inertia_b
    if inertia == 0.0:
        return
    momentum = mass * (x * vy - y * vx) + inertia_a * spin_a + inertia_b * spin_b
    energy = mass * (vx * vx + vy * vy)
    energy = (energy + inertia_a * spin_a * spin_a + inertia_b * spin_b * spin_b) / 2.0
    now = momentum / inertia
    new = (momentum - gained) / inertia
    rest = energy - inertia * now * now / 2.0
    most = energy - inertia * new * new / 2.0
    share = 1.0
    if most < rest:
        share = math.sqrt(most / rest) if most > 0.0 else 0.0
    jx = mass * (share * (vx + now * y) - new * y - vx)
    jy = mass * (share * (vy - now * x) + new * x - vy)
    give(t, a, inertia_a, -jx, -jy, new + share * (spin_a - now) - spin_a)
    give(t, b, inertia_b, jx, jy, new + share * (spin_b - now) - spin_b)
    t.pairs.given_x[pair] += jx
    t.pairs.given_y[pair] += jy


def turning_inertia(t: Tables, row: int, piece: int) -> float:
    """Moment of inertia of a body that contacts can turn: of no disc about its centre (kg m^2)."""
    turns = t.bodies.inverse_inertia[row] > 0.0 and t.pieces.swing[piece] > 0.0
    return t.bodies.inertia[row] if turns else 0.0


def give(t: Tables, row: int, inertia: float, jx: float, jy: float, spin: float) -> None:
    """Give a body an impulse (N s), and spin (rad/s) if it has inertia, on account of contacts."""
    bodies = t.bodies
    x = jx * bodies.inverse_mass[row]
    y = jy * bodies.inverse_mass[row]
    if inertia == 0.0:
        spin = 0.0
    t.books.contact_heat[0] -= work_of(bodies, row, x, y, spin)
    t.books.correction_turn[0] += turn_of(bodies, row, x, y, spin)
    bodies.vx[row] += x
    bodies.vy[row] += y
    bodies.spin[row] += spin


def turn_in_place(t: Tables, row: int) -> None:
    """Turn a body as its contacts want; note whether it was moved, and how far at most (m)."""
    bodies = t.bodies
    turn = bodies.kick_spin[row]
    moved = bodies.kick_x[row] != 0.0 or bodies.kick_y[row] != 0.0 or turn != 0.0
    bodies.parting[row] = 1 if moved else 0
    bodies.angle[row] += turn
    bodies.way[row] = abs(bodies.x[row] - bodies.middle_x[row]) + abs(
        bodies.y[row] - bodies.middle_y[row]
    )
    if turn != 0.0:
        bodies.way[row] += abs(turn) * swing_of(t, row)
    t.books.contact_heat[0] += bodies.torque[row] * turn


def move(t: Tables, row: int, x: float, y: float) -> None:
    """Move a body by an impulse of ways (kg m) against the forces on it, which contacts pay for."""
    bodies = t.bodies
    if bodies.inverse_mass[row] > 0.0:
        t.books.correction_turn[0] += x * bodies.vy[row] - y * bodies.vx[row]
    x *= bodies.inverse_mass[row]
    y *= bodies.inverse_mass[row]
    bodies.x[row] += x
    bodies.y[row] += y
    t.books.contact_heat[0] += bodies.force_x[row] * x + bodies.force_y[row] * y
