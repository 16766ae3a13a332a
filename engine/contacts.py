"""Bodies that rest on each other: soft contacts in substeps, warm-started.

The method is that of Box2D v3 (Erin Catto, "Solver2D", 2024): sequential impulses against a contact
that behaves like a stiff, strongly damped spring while positions are corrected, then a pass without
the spring that takes back the velocity which the correction lent. Impulses start from those of the
part before. Each is exchanged at one common point while the bodies stand in the middle of the part
of the tick (or, when relaxing, at its end), so that angular momentum is kept to rounding.
"""

from engine.manifolds.any_pair import touching_points
from engine.pose import place
from engine.spring import softness, softness_left
from engine.tables import RESTING, Contacts, Tables

CALM = 0.02
"""A sweep that changes no contact's velocity by more is the last, in reaches of the smaller body a
second (1/s): at rest one sweep is enough."""

MOST_SWEEPS = 8
"""Sweeps that a part has at most."""

PUSH = 2.0
"""Fastest correction of an overlap, in reaches of the smaller body a second (1/s)."""


def prepare(t: Tables, pair: int, half: float) -> None:
    """Find the points of a resting pair for its placed bodies; keep the impulses of known points.

    Args:
        t: the tables.
        pair: which pair.
        half: half the part of the tick (s): what is left for the bodies to move after the kick.
    """
    contacts = t.contacts
    first = 2 * pair
    before = t.pairs.points[pair]
    old_0 = contacts.feature[first]
    old_1 = contacts.feature[first + 1]
    normal_0 = contacts.normal_impulse[first]
    normal_1 = contacts.normal_impulse[first + 1]
    tangent_0 = contacts.tangent_impulse[first]
    tangent_1 = contacts.tangent_impulse[first + 1]
    points = touching_points(t, pair)
    t.pairs.points[pair] = points
    t.pairs.normal_x[pair] = t.touch.normal_x[0]
    t.pairs.normal_y[pair] = t.touch.normal_y[0]
    share = 2.0 * half / t.pairs.part[pair] if t.pairs.part[pair] > 0.0 else 0.0
    if share > 1.0:  # what stopped a motion in a short part is no load that lasts
        share = 1.0
    t.pairs.give[pair] = softness_left(t, pair, 2.0 * half)
    t.pairs.part[pair] = 2.0 * half
    for i in range(points):
        feature = t.touch.feature[i]
        row = first + i
        contacts.feature[row] = feature
        contacts.gap[row] = t.touch.gap[i]
        normal = 0.0
        tangent = 0.0
        if before > 0 and old_0 == feature:
            normal = normal_0
            tangent = tangent_0
        elif before > 1 and old_1 == feature:
            normal = normal_1
            tangent = tangent_1
        contacts.normal_impulse[row] = normal * share
        contacts.tangent_impulse[row] = tangent * share
        measure(t, pair, row, t.touch.x[i], t.touch.y[i])


def measure(t: Tables, pair: int, row: int, x: float, y: float) -> None:
    """Set lever arms and effective masses of the contact at (x, y) of the placed bodies."""
    bodies = t.bodies
    contacts = t.contacts
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    nx = t.pairs.normal_x[pair]
    ny = t.pairs.normal_y[pair]
    a_x = x - bodies.here_x[a]
    a_y = y - bodies.here_y[a]
    b_x = x - bodies.here_x[b]
    b_y = y - bodies.here_y[b]
    contacts.a_x[row] = a_x
    contacts.a_y[row] = a_y
    contacts.b_x[row] = b_x
    contacts.b_y[row] = b_y
    mass = bodies.inverse_mass[a] + bodies.inverse_mass[b]
    turn_a = bodies.inverse_inertia[a]
    turn_b = bodies.inverse_inertia[b]
    arm_a = a_x * ny - a_y * nx
    arm_b = b_x * ny - b_y * nx
    contacts.normal_mass[row] = 1.0 / (mass + arm_a * arm_a * turn_a + arm_b * arm_b * turn_b)
    arm_a = a_x * nx + a_y * ny
    arm_b = b_x * nx + b_y * ny
    contacts.tangent_mass[row] = 1.0 / (mass + arm_a * arm_a * turn_a + arm_b * arm_b * turn_b)


def kick(t: Tables, resting: int, count: int, part: float) -> None:
    """Find what velocities the bodies have at the end of the part (s); bend their paths to it."""
    bodies = t.bodies
    for row in range(count):
        if bodies.held[row] > 0:
            bodies.kick_x[row] = bodies.vx[row] + bodies.ax[row] * part
            bodies.kick_y[row] = bodies.vy[row] + bodies.ay[row] * part
            bodies.kick_spin[row] = bodies.spin[row] + bodies.aspin[row] * part
    for k in range(resting):
        warm_start(t, t.pairs.resting[k])
    sweep_until_calm(t, resting, part, False)
    for k in range(resting):
        remember(t, t.pairs.resting[k])
    for row in range(count):
        if bodies.held[row] > 0:
            bodies.path_x[row] = (bodies.kick_x[row] - bodies.vx[row]) / part
            bodies.path_y[row] = (bodies.kick_y[row] - bodies.vy[row]) / part
            bodies.path_spin[row] = (bodies.kick_spin[row] - bodies.spin[row]) / part


def relax(t: Tables, resting: int, count: int, part: float, done: float) -> None:
    """Take back, at the end of a part (s), the velocity that correcting overlaps has lent.

    `done` is the share of the part after which it was cut short, 1 if it was not.
    """
    bodies = t.bodies
    for row in range(count):
        if bodies.held[row] > 0:
            bodies.kick_x[row] = bodies.vx[row]
            bodies.kick_y[row] = bodies.vy[row]
            bodies.kick_spin[row] = bodies.spin[row]
    for k in range(resting):
        turn_by_shift(t, t.pairs.resting[k], done)
    for k in range(resting):
        if t.pairs.state[t.pairs.resting[k]] == RESTING:
            move_arms(t, t.pairs.resting[k])
    sweep_until_calm(t, resting, part, True)
    for row in range(count):
        if bodies.held[row] > 0:
            bodies.vx[row] = bodies.kick_x[row]
            bodies.vy[row] = bodies.kick_y[row]
            bodies.spin[row] = bodies.kick_spin[row]


def share_of_a(t: Tables, pair: int) -> float:
    """Which part of their relative motion the contact makes on the side of a: a round body and one
    on an immovable one carry the contact with them.
    """
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    if bodies.inverse_mass[a] == 0.0 or t.pieces.corners[t.pairs.piece_b[pair]] == 1:
        return 1.0
    if bodies.inverse_mass[b] == 0.0 or t.pieces.corners[t.pairs.piece_a[pair]] == 1:
        return 0.0
    return 0.5


def shift_paths(t: Tables, count: int, first: int, now: float, part: float, reached: float) -> None:
    """Find how far the mean positions of held bodies are from the middle of their planned paths.

    Args:
        t: the tables; bodies stand at the end of the part.
        count: number of bodies.
        first: first row in `Impacts` of this part.
        now: when the part began, since the tick began (s).
        part: its planned length (s).
        reached: after which it ended (s).
    """
    bodies = t.bodies
    impacts = t.impacts
    early = (reached - part) / 2.0
    for row in range(count):
        if bodies.held[row] > 0:
            bodies.shift_x[row] = (bodies.kick_x[row] - bodies.path_x[row] * part) * early
            bodies.shift_y[row] = (bodies.kick_y[row] - bodies.path_y[row] * part) * early
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


def turn_by_shift(t: Tables, pair: int, done: float) -> None:
    """Correct the torque of a contact whose bodies did not go their planned paths.

    Its impulse acts all through the part; the lever arms were those of the planned paths. What an
    impact adds to the mean positions adds to the arms, or angular momentum would not be kept.
    """
    bodies = t.bodies
    contacts = t.contacts
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    x = bodies.shift_x[b] - bodies.shift_x[a]
    y = bodies.shift_y[b] - bodies.shift_y[a]
    if x == 0.0 and y == 0.0:
        return
    of_a = share_of_a(t, pair)
    nx = t.pairs.normal_x[pair]
    ny = t.pairs.normal_y[pair]
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        jx = contacts.normal_impulse[row] * nx - contacts.tangent_impulse[row] * ny
        jy = contacts.normal_impulse[row] * ny + contacts.tangent_impulse[row] * nx
        turn = (x * jy - y * jx) * done
        bodies.kick_spin[a] -= of_a * turn * bodies.inverse_inertia[a]
        bodies.kick_spin[b] -= (1.0 - of_a) * turn * bodies.inverse_inertia[b]


def move_arms(t: Tables, pair: int) -> None:
    """Follow the bodies from the middle of the part to its end: gaps and one common point."""
    bodies = t.bodies
    contacts = t.contacts
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    x = (bodies.x[b] - bodies.middle_x[b]) - (bodies.x[a] - bodies.middle_x[a])
    y = (bodies.y[b] - bodies.middle_y[b]) - (bodies.y[a] - bodies.middle_y[a])
    closer = x * t.pairs.normal_x[pair] + y * t.pairs.normal_y[pair]
    of_a = share_of_a(t, pair)
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        contacts.gap[row] += closer
        contacts.a_x[row] += of_a * x
        contacts.a_y[row] += of_a * y
        contacts.b_x[row] -= (1.0 - of_a) * x
        contacts.b_y[row] -= (1.0 - of_a) * y


def sweep_until_calm(t: Tables, resting: int, part: float, relaxing: bool) -> None:
    """Solve all resting pairs one after the other, again while that changes much."""
    for _ in range(MOST_SWEEPS):
        wild = False
        for k in range(resting):
            pair = t.pairs.resting[k]
            if t.pairs.state[pair] == RESTING:
                change = solve(t, pair, part, relaxing)
                wild = wild or change > CALM * t.pairs.size[pair]
        if not wild:
            return


def warm_start(t: Tables, pair: int) -> None:
    """Apply the impulses of the part before."""
    contacts = t.contacts
    nx = t.pairs.normal_x[pair]
    ny = t.pairs.normal_y[pair]
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        normal = contacts.normal_impulse[row]
        tangent = contacts.tangent_impulse[row]
        if normal != 0.0 or tangent != 0.0:
            jx = normal * nx - tangent * ny
            jy = normal * ny + tangent * nx
            exchange_impulse(t, pair, row, jx, jy)


def exchange_impulse(t: Tables, pair: int, row: int, jx: float, jy: float) -> None:
    """Give the impulse (N s) at a contact to b and its opposite to a."""
    bodies = t.bodies
    contacts = t.contacts
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    bodies.kick_x[a] -= bodies.inverse_mass[a] * jx
    bodies.kick_y[a] -= bodies.inverse_mass[a] * jy
    turn = contacts.a_x[row] * jy - contacts.a_y[row] * jx
    bodies.kick_spin[a] -= bodies.inverse_inertia[a] * turn
    bodies.kick_x[b] += bodies.inverse_mass[b] * jx
    bodies.kick_y[b] += bodies.inverse_mass[b] * jy
    turn = contacts.b_x[row] * jy - contacts.b_y[row] * jx
    bodies.kick_spin[b] += bodies.inverse_inertia[b] * turn


def solve(t: Tables, pair: int, part: float, relaxing: bool) -> float:
    """Solve the points of a pair once, along the normal, then against the sliding.

    Returns the greatest change of a normal velocity (m/s).
    """
    bodies = t.bodies
    contacts = t.contacts
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    nx = t.pairs.normal_x[pair]
    ny = t.pairs.normal_y[pair]
    friction = t.pairs.friction[pair]
    mass_a = bodies.inverse_mass[a]
    mass_b = bodies.inverse_mass[b]
    turn_a = bodies.inverse_inertia[a]
    turn_b = bodies.inverse_inertia[b]
    vx_a = bodies.kick_x[a]
    vy_a = bodies.kick_y[a]
    spin_a = bodies.kick_spin[a]
    vx_b = bodies.kick_x[b]
    vy_b = bodies.kick_y[b]
    spin_b = bodies.kick_spin[b]
    fixed = mass_a == 0.0 or mass_b == 0.0
    greatest = 0.0
    rate, yielding = softness(part, fixed)
    soft = yielding * t.pairs.give[pair]
    stiff = 1.0 - soft
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        a_x = contacts.a_x[row]
        a_y = contacts.a_y[row]
        b_x = contacts.b_x[row]
        b_y = contacts.b_y[row]
        vx = vx_b - spin_b * b_y - vx_a + spin_a * a_y
        vy = vy_b + spin_b * b_x - vy_a - spin_a * a_x
        gap = contacts.gap[row]
        before = contacts.normal_impulse[row]
        if gap > 0.0:  # may close until the end of the part, but no faster
            change = -contacts.normal_mass[row] * (vx * nx + vy * ny + 2.0 * gap / part)
        elif relaxing:
            change = -contacts.normal_mass[row] * (vx * nx + vy * ny)
        else:
            bias = rate * gap
            if bias < -PUSH * t.pairs.size[pair]:
                bias = -PUSH * t.pairs.size[pair]
            change = -contacts.normal_mass[row] * stiff * (vx * nx + vy * ny + bias)
            change -= soft * before
        after = before + change
        if after < 0.0:
            after = 0.0
        change = after - before
        if change > greatest * contacts.normal_mass[row]:
            greatest = change / contacts.normal_mass[row]
        elif -change > greatest * contacts.normal_mass[row]:
            greatest = -change / contacts.normal_mass[row]
        contacts.normal_impulse[row] = after
        jx = change * nx
        jy = change * ny
        vx_a -= mass_a * jx
        vy_a -= mass_a * jy
        spin_a -= turn_a * (a_x * jy - a_y * jx)
        vx_b += mass_b * jx
        vy_b += mass_b * jy
        spin_b += turn_b * (b_x * jy - b_y * jx)
    if friction > 0.0:
        for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
            a_x = contacts.a_x[row]
            a_y = contacts.a_y[row]
            b_x = contacts.b_x[row]
            b_y = contacts.b_y[row]
            vx = vx_b - spin_b * b_y - vx_a + spin_a * a_y
            vy = vy_b + spin_b * b_x - vy_a - spin_a * a_x
            before = contacts.tangent_impulse[row]
            after = before - contacts.tangent_mass[row] * (vy * nx - vx * ny)
            most = friction * contacts.normal_impulse[row]
            if after > most:
                after = most
            elif after < -most:
                after = -most
            change = after - before
            contacts.tangent_impulse[row] = after
            jx = -change * ny
            jy = change * nx
            vx_a -= mass_a * jx
            vy_a -= mass_a * jy
            spin_a -= turn_a * (a_x * jy - a_y * jx)
            vx_b += mass_b * jx
            vy_b += mass_b * jy
            spin_b += turn_b * (b_x * jy - b_y * jx)
    bodies.kick_x[a] = vx_a
    bodies.kick_y[a] = vy_a
    bodies.kick_spin[a] = spin_a
    bodies.kick_x[b] = vx_b
    bodies.kick_y[b] = vy_b
    bodies.kick_spin[b] = spin_b
    return greatest


def remember(t: Tables, pair: int) -> None:
    """Note the change of normal velocity that the contact brought about (m/s)."""
    contacts: Contacts = t.contacts
    carried = 0.0
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        change = contacts.normal_impulse[row] / contacts.normal_mass[row]
        if change > carried:
            carried = change
    t.pairs.carried[pair] = carried


def place_middle(t: Tables, count: int, half: float) -> None:
    """Place the bodies that rest where they are in the middle of the part, and note it."""
    bodies = t.bodies
    for row in range(count):
        if bodies.held[row] > 0:
            bodies.path_x[row] = 0.0
            bodies.path_y[row] = 0.0
            bodies.path_spin[row] = 0.0
            place(bodies, t.corners, row, half)
            bodies.middle_x[row] = bodies.here_x[row]
            bodies.middle_y[row] = bodies.here_y[row]
