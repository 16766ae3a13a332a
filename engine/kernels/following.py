"""Points of resting contacts, which follow their bodies until these have moved too far.

Where two bodies touch is found by geometry, and then kept: as long as they hardly move over each
other, gaps and lever arms follow from how the bodies moved, to first order, as in Box2D v3. Arms
are kept in the frame of the contact (n, t), in which r x n = -r . t and r x t = r . n. Whatever the
error of an arm, both bodies have the same point: the arm of b is that of a less the way from a to
b.
"""

from engine.kernels.pose import place_once, place_pair
from engine.kernels.rubbing import belt_speed
from engine.kernels.searching import is_part
from engine.linkage.tally import is_joined
from engine.manifolds.any_pair import touching_points
from engine.manifolds.pressed import hold_back, is_pressed_through
from engine.tables import NEVER, Tables

DRIFT = 2e-3
"""How far bodies may move over each other until their points are found anew, in reaches of the
smaller one; a turn counts `TURN` times."""

TURN = 4.0
"""So often does what turns the normal count: rotation, and any way of a round body."""


TUMBLING = 0.5
"""What turns on a contact by more than this within a part does not rest on it (rad): its corners
strike, and no point can be followed."""


DEEP = 0.02
"""Overlap from which on bodies are deep in each other, in reaches of the smaller one: far beyond
what loads make."""

ASKEW = 0.05
"""Share of their speeds by which bodies may close faster than a contact says that was measured
some time before in the same part."""

SWERVE = 0.02
"""The same for those of a contact whose normal turns, until they are found anew to relax."""

RACING = 0.1
"""Bodies that moved over each other by more within a part have other effective masses than when
their points were found, in the same unit as `DRIFT`: sweeps with the old ones would diverge."""

BURIED = 1e-3
"""Distance of the centres of two discs that counts as none, in reaches of the smaller one."""


def follow(t: Tables, pair: int, least: float) -> None:
    """Measure the contact for the middle poses of its bodies, if these moved by more than `least`
    (reaches of the smaller one).
    """
    bodies = t.bodies
    pairs = t.pairs
    contacts = t.contacts
    a = pairs.a[pair]
    b = pairs.b[pair]
    piece_a = pairs.piece_a[pair]
    piece_b = pairs.piece_b[pair]
    way_x = bodies.middle_x[b] - bodies.middle_x[a]
    way_y = bodies.middle_y[b] - bodies.middle_y[a]
    x = way_x - pairs.seen_x[pair]
    y = way_y - pairs.seen_y[pair]
    turn_a = 0.0
    turn_b = 0.0
    if t.pieces.swing[piece_a] > 0.0:
        turn_a = bodies.middle_angle[a] - pairs.seen_angle_a[pair]
    if t.pieces.swing[piece_b] > 0.0:
        turn_b = bodies.middle_angle[b] - pairs.seen_angle_b[pair]
    size = pairs.size[pair]
    moved = abs(x) + abs(y)
    turned = (abs(turn_a) + abs(turn_b)) * size
    if moved + turned <= least * size:
        return
    if t.pieces.corners[piece_a] == 1 or t.pieces.corners[piece_b] == 1:
        moved *= 1.0 + TURN * turns_by_moving(t, pair, size)
    pairs.drift[pair] += moved + TURN * turned
    pairs.seen_x[pair] = way_x
    pairs.seen_y[pair] = way_y
    pairs.seen_angle_a[pair] = bodies.middle_angle[a]
    pairs.seen_angle_b[pair] = bodies.middle_angle[b]
    nx = pairs.normal_x[pair]
    ny = pairs.normal_y[pair]
    closer = x * nx + y * ny
    slid = y * nx - x * ny
    way_n = way_x * nx + way_y * ny
    way_t = way_y * nx - way_x * ny
    with_b = share_of_b(t, pair)
    with_a = 1.0 - with_b
    for row in range(2 * pair, 2 * pair + pairs.points[pair]):
        normal_arm = contacts.normal_arm_a[row]
        tangent_arm = contacts.tangent_arm_a[row]
        a_n = turn_a * normal_arm
        a_t = turn_a * tangent_arm
        b_n = closer + turn_b * contacts.normal_arm_b[row]
        b_t = slid + turn_b * contacts.tangent_arm_b[row]
        contacts.gap[row] += b_n - a_n
        normal_arm -= with_a * a_t + with_b * b_t
        tangent_arm += with_a * a_n + with_b * b_n
        contacts.normal_arm_a[row] = normal_arm
        contacts.tangent_arm_a[row] = tangent_arm
        contacts.normal_arm_b[row] = normal_arm + way_t
        contacts.tangent_arm_b[row] = tangent_arm - way_n


def note_opening(t: Tables, pair: int) -> None:
    """Note in `Contacts.target` how fast the points of a pair open (m/s) as it was last measured:
    what they do as it is measured anew tells how its normal turns.
    """
    contacts = t.contacts
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    opening = (bodies.vx[b] - bodies.vx[a]) * t.pairs.normal_x[pair]
    opening += (bodies.vy[b] - bodies.vy[a]) * t.pairs.normal_y[pair]
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        contacts.target[row] = (
            opening
            + bodies.spin[b] * contacts.normal_arm_b[row]
            - bodies.spin[a] * contacts.normal_arm_a[row]
        )


def turns_by_moving(t: Tables, pair: int, size: float) -> float:
    """By how much a way of `size` (m) turns the normal of a pair with a round body, roughly (rad).

    Discs whose centres are closer than that turn it by more.
    """
    if not are_buried(t, pair):
        return 1.0
    x = t.pairs.seen_x[pair]
    y = t.pairs.seen_y[pair]
    return size / (abs(x) + abs(y) + BURIED * size)


def are_buried(t: Tables, pair: int) -> bool:
    """Whether both of a pair are discs about their centres, one deep in the other."""
    pairs = t.pairs
    a = pairs.piece_a[pair]
    b = pairs.piece_b[pair]
    if t.pieces.swing[a] > 0.0 or t.pieces.swing[b] > 0.0:
        return False
    x = pairs.seen_x[pair]
    y = pairs.seen_y[pair]
    apart = t.pieces.radius[a] + t.pieces.radius[b] - DEEP * pairs.size[pair]
    return x * x + y * y < apart * apart


def has_swerved(t: Tables, pair: int) -> bool:
    """Whether the normal of a pair has turned so far since its points were found that they have to
    be found anew to relax.
    """
    if are_buried(t, pair):
        return has_drifted(t, pair)
    swerved = t.pairs.drift[pair] > SWERVE * t.pairs.size[pair]
    return swerved and its_normal_turns(t, pair)


def its_normal_turns(t: Tables, pair: int) -> bool:
    """Whether the normal of a contact turns as its bodies go on: of two of which none is a wall,
    and one is round, made of pieces or turned by no force.
    """
    if is_joined(t, pair):
        return False
    if is_part(t, pair):
        return True
    pieces = t.pieces
    a = t.pairs.piece_a[pair]
    b = t.pairs.piece_b[pair]
    if pieces.corners[a] == 2 or pieces.corners[b] == 2:
        return False
    if pieces.corners[a] == 1 or pieces.corners[b] == 1:
        return True
    return is_turned(t, t.pairs.a[pair]) or is_turned(t, t.pairs.b[pair])


def is_turned(t: Tables, row: int) -> bool:
    """Whether a body turns that no force moves."""
    return t.bodies.inverse_mass[row] == 0.0 and t.bodies.spin[row] != 0.0


def has_drifted(t: Tables, pair: int) -> bool:
    """Whether the points of a pair have to be found anew."""
    return t.pairs.points[pair] == 0 or t.pairs.drift[pair] > DRIFT * t.pairs.size[pair]


def turning(t: Tables, pair: int, lasts: float) -> float:
    """By how much the bodies of a pair turn on each other within `lasts` seconds (rad), if at least
    one of them is no disc about its centre.
    """
    turn = 0.0
    if t.pieces.swing[t.pairs.piece_a[pair]] > 0.0:
        turn += abs(t.bodies.spin[t.pairs.a[pair]])
    if t.pieces.swing[t.pairs.piece_b[pair]] > 0.0:
        turn += abs(t.bodies.spin[t.pairs.b[pair]])
    return turn * lasts


def closes_faster(t: Tables, pair: int, time: float, speed: float) -> bool:
    """Whether a resting contact may close faster than a speed (m/s) at `time` of the part (s), as
    far as it was last measured; what its bodies have moved since is allowed for.
    """
    bodies = t.bodies
    contacts = t.contacts
    if t.pairs.points[pair] == 0:
        return True
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    from_a = time - bodies.clock[a]
    from_b = time - bodies.clock[b]
    x = bodies.vx[a] + bodies.path_x[a] * from_a - bodies.vx[b] - bodies.path_x[b] * from_b
    y = bodies.vy[a] + bodies.path_y[a] * from_a - bodies.vy[b] - bodies.path_y[b] * from_b
    spin_a = bodies.spin[a] + bodies.path_spin[a] * from_a
    spin_b = bodies.spin[b] + bodies.path_spin[b] * from_b
    turning = abs(spin_a) * bodies.reach[a] + abs(spin_b) * bodies.reach[b]
    closing = x * t.pairs.normal_x[pair] + y * t.pairs.normal_y[pair]
    most = speed - ASKEW * (abs(x) + abs(y) + turning)
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        arms = spin_a * contacts.normal_arm_a[row] - spin_b * contacts.normal_arm_b[row]
        if closing + arms > most:
            return True
    return False


def share_of_b(t: Tables, pair: int) -> float:
    """Which part of their relative motion the contact makes with b: a round body, and one on an
    immovable one, carry the contact with them.
    """
    pairs = t.pairs
    if t.bodies.inverse_mass[pairs.a[pair]] == 0.0 or t.pieces.corners[pairs.piece_b[pair]] == 1:
        return 1.0
    if t.bodies.inverse_mass[pairs.b[pair]] == 0.0 or t.pieces.corners[pairs.piece_a[pair]] == 1:
        return 0.0
    return 0.5


def weigh_if_racing(t: Tables, pair: int) -> None:
    """Set the effective masses of a pair anew, if it moved far since its points were found."""
    if t.pairs.drift[pair] > RACING * t.pairs.size[pair]:
        a = t.pairs.a[pair]
        b = t.pairs.b[pair]
        for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
            weigh(t, a, b, row)


def find_points(t: Tables, pair: int, time: float) -> None:
    """Find by geometry where the bodies touch at `time` of the present part (s), their middle pose.

    The impulses and loads of points that were known before are kept, and how fast these opened.
    """
    place_pair(t, pair, time)
    find_placed_points(t, pair)


def find_points_once(t: Tables, pair: int, time: float) -> None:
    """The same, where bodies are placed once for all their contacts; see `Bodies.placed`."""
    place_once(t, t.pairs.a[pair], t.pairs.piece_a[pair], time)
    place_once(t, t.pairs.b[pair], t.pairs.piece_b[pair], time)
    find_placed_points(t, pair)


def find_placed_points(t: Tables, pair: int) -> None:
    """The same for bodies that are placed."""
    bodies = t.bodies
    pairs = t.pairs
    contacts = t.contacts
    a = pairs.a[pair]
    b = pairs.b[pair]
    first = 2 * pair
    before = pairs.points[pair]
    old_0 = contacts.feature[first]
    old_1 = contacts.feature[first + 1]
    normal_0 = contacts.normal_impulse[first]
    normal_1 = contacts.normal_impulse[first + 1]
    tangent_0 = contacts.tangent_impulse[first]
    tangent_1 = contacts.tangent_impulse[first + 1]
    load_0 = contacts.normal_load[first]
    load_1 = contacts.normal_load[first + 1]
    grip_0 = contacts.tangent_load[first]
    grip_1 = contacts.tangent_load[first + 1]
    opened_0 = contacts.target[first]
    opened_1 = contacts.target[first + 1]
    points = touching_points(t, pair)
    if points > 0 and is_pressed_through(t, pair):
        points = hold_back(t, pair)
    pairs.points[pair] = points
    pairs.drift[pair] = 0.0
    pairs.normal_x[pair] = t.touch.normal_x[0]
    pairs.normal_y[pair] = t.touch.normal_y[0]
    pairs.belt_speed[pair] = belt_speed(t, pair, t.touch.normal_x[0], t.touch.normal_y[0])
    pairs.seen_x[pair] = bodies.middle_x[b] - bodies.middle_x[a]
    pairs.seen_y[pair] = bodies.middle_y[b] - bodies.middle_y[a]
    pairs.seen_angle_a[pair] = bodies.middle_angle[a]
    pairs.seen_angle_b[pair] = bodies.middle_angle[b]
    for i in range(points):
        row = first + i
        feature = t.touch.feature[i]
        contacts.feature[row] = feature
        contacts.normal_impulse[row] = 0.0
        contacts.tangent_impulse[row] = 0.0
        contacts.normal_load[row] = 0.0
        contacts.tangent_load[row] = 0.0
        contacts.target[row] = opened_0 if before == 1 and points == 1 else NEVER
        if before > 0 and old_0 == feature:
            contacts.normal_impulse[row] = normal_0
            contacts.tangent_impulse[row] = tangent_0
            contacts.normal_load[row] = load_0
            contacts.tangent_load[row] = grip_0
            contacts.target[row] = opened_0
        elif before > 1 and old_1 == feature:
            contacts.normal_impulse[row] = normal_1
            contacts.tangent_impulse[row] = tangent_1
            contacts.normal_load[row] = load_1
            contacts.tangent_load[row] = grip_1
            contacts.target[row] = opened_1
        contacts.gap[row] = t.touch.gap[i]
        measure(t, pair, row, t.touch.x[i], t.touch.y[i])


def measure(t: Tables, pair: int, row: int, x: float, y: float) -> None:
    """Set lever arms and effective masses of the contact at (x, y)."""
    bodies = t.bodies
    contacts = t.contacts
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    nx = t.pairs.normal_x[pair]
    ny = t.pairs.normal_y[pair]
    x -= bodies.middle_x[a]
    y -= bodies.middle_y[a]
    normal_a = x * ny - y * nx
    tangent_a = x * nx + y * ny
    x -= t.pairs.seen_x[pair]
    y -= t.pairs.seen_y[pair]
    normal_b = x * ny - y * nx
    tangent_b = x * nx + y * ny
    contacts.normal_arm_a[row] = normal_a
    contacts.tangent_arm_a[row] = tangent_a
    contacts.normal_arm_b[row] = normal_b
    contacts.tangent_arm_b[row] = tangent_b
    weigh(t, a, b, row)


def weigh(t: Tables, a: int, b: int, row: int) -> None:
    """Set the effective masses of a contact by its lever arms."""
    bodies = t.bodies
    contacts = t.contacts
    normal_a = contacts.normal_arm_a[row]
    tangent_a = contacts.tangent_arm_a[row]
    normal_b = contacts.normal_arm_b[row]
    tangent_b = contacts.tangent_arm_b[row]
    mass = bodies.inverse_mass[a] + bodies.inverse_mass[b]
    turn_a = bodies.inverse_inertia[a]
    turn_b = bodies.inverse_inertia[b]
    contacts.normal_mass[row] = 1.0 / (
        mass + normal_a * normal_a * turn_a + normal_b * normal_b * turn_b
    )
    contacts.tangent_mass[row] = 1.0 / (
        mass + tangent_a * tangent_a * turn_a + tangent_b * tangent_b * turn_b
    )
