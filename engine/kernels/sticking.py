"""Which bodies stick to the ground: they cannot move at all while contacts bear what they bear.

A contact that neither opens nor slides lets its points move alike (Coulomb's law): each is a pin.
Two bodies that share two pins are one rigid cluster; a cluster with two pins to the ground is
fixed, and so are two of them with one each that are pinned to each other, unless the three pins
stand in a line (the triangle of all trusses). Sweeps would find the velocity zero as well, but
slowly: a tall heap leans as a whole for minutes before they have noticed.
"""

from engine.kernels.rubbing import slip_of
from engine.kernels.touches import impulses_of
from engine.tables import Tables

APART = 0.01
"""Least distance of two pins that fix a body, in its reaches: discs roll on a single one."""

HELD = 1.0 - 1e-9
"""Share of the most that friction can do below which a contact sticks: what slides has it all, but
for rounding."""

CREEPING = 1e-4
"""What slides slower with all its friction sticks all the same, in reaches of the smaller body a
second (1/s): sweeps leave it a little speed,"""

DRIVEN = 5e-4
"""unless forces exceed what friction does by more, as a share of that."""

LOOSE, PINNED, FIXED = 0, 1, 2
"""A cluster that no pin, one pin or two join to the ground."""


def find_fixed(t: Tables, count: int, resting: int) -> None:
    """Note for each body whether contacts fix it to what never moves.

    Bodies are kicked by what loads leave of forces, and nothing immovable that they touch moves.
    """
    bodies = t.bodies
    for row in range(count):
        rests = bodies.vx[row] == 0.0 and bodies.vy[row] == 0.0 and bodies.spin[row] == 0.0
        bodies.stuck[row] = FIXED if bodies.inverse_mass[row] == 0.0 and rests else LOOSE
        bodies.cluster[row] = row
    for k in range(resting):
        pair = t.pairs.resting[k]
        a = t.pairs.a[pair]
        b = t.pairs.b[pair]
        movable = bodies.inverse_mass[a] > 0.0 and bodies.inverse_mass[b] > 0.0
        if movable and pins(t, pair) == 2:
            bodies.cluster[cluster_of(t, b)] = cluster_of(t, a)
    grows = True
    backwards = False
    while grows:
        grows = False
        for k in range(resting):
            if pin_down(t, t.pairs.resting[resting - 1 - k if backwards else k]):
                grows = True
        for at in range(t.bones.sizes[8]):
            if pin_limb(t, t.bones.acting[at]):
                grows = True
        backwards = not backwards
    for row in range(count):
        bodies.stuck[row] = bodies.stuck[cluster_of(t, row)]


def cluster_of(t: Tables, row: int) -> int:
    """The body that stands for the cluster of another."""
    cluster = t.bodies.cluster
    while cluster[row] != row:
        cluster[row] = cluster[cluster[row]]
        row = cluster[row]
    return row


def connect(t: Tables, count: int, resting: int) -> None:
    """Find for each body one that stands for its island, by contacts and hinges."""
    bodies = t.bodies
    bones = t.bones
    for row in range(count):
        bodies.cluster[row] = row
    for k in range(resting):
        a = t.pairs.a[t.pairs.resting[k]]
        b = t.pairs.b[t.pairs.resting[k]]
        if bodies.inverse_mass[a] > 0.0 and bodies.inverse_mass[b] > 0.0:
            bodies.cluster[cluster_of(t, b)] = cluster_of(t, a)
    for k in range(bones.sizes[0]):
        parent = t.limbs.parent[k]
        if parent < bones.sizes[1]:
            body = bones.body[parent]
            bodies.cluster[cluster_of(t, bones.body[k])] = cluster_of(t, body)


def island_of(t: Tables, pair: int) -> int:
    """The body that stands for the cluster, or the island, of a pair."""
    a = t.pairs.a[pair]
    return cluster_of(t, a if t.bodies.inverse_mass[a] > 0.0 else t.pairs.b[pair])


def pins(t: Tables, pair: int) -> int:
    """Number of points that a contact holds together under its load.

    What bears a body in a dent may need all its friction for that.
    """
    push = 0.0
    rub = 0.0
    loaded = 0
    for point in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        push += t.contacts.normal_load[point]
        rub += t.contacts.tangent_load[point]
        if t.contacts.normal_load[point] > 0.0:
            loaded += 1
    if abs(rub) < HELD * t.pairs.static_friction[pair] * push:
        return loaded
    return loaded if hardly_slides(t, pair) else 0


def hardly_slides(t: Tables, pair: int) -> bool:
    """Whether a contact slides so slowly that it counts as none, and does not come to slide."""
    bodies = t.bodies
    if abs(slip_of(t, pair)) > CREEPING * t.pairs.size[pair]:
        return False
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    more = (bodies.kick_y[b] - bodies.kick_y[a]) * t.pairs.normal_x[pair]
    more -= (bodies.kick_x[b] - bodies.kick_x[a]) * t.pairs.normal_y[pair]
    more += bodies.kick_spin[b] * t.contacts.tangent_arm_b[2 * pair]
    more -= bodies.kick_spin[a] * t.contacts.tangent_arm_a[2 * pair]
    _, rub = impulses_of(t, pair)
    return abs(more) * t.contacts.tangent_mass[2 * pair] < DRIVEN * abs(rub)


def pin_down(t: Tables, pair: int) -> bool:
    """Pin clusters to the ground by the pins of a pair; return whether something is pinned anew."""
    stuck = t.bodies.stuck
    a = cluster_of(t, t.pairs.a[pair])
    b = cluster_of(t, t.pairs.b[pair])
    if a == b or stuck[a] + stuck[b] < PINNED + PINNED or stuck[a] + stuck[b] == FIXED + FIXED:
        return False
    if pins(t, pair) == 0:
        return False
    grows = False
    for point in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        if t.contacts.normal_load[point] > 0.0:
            x, y = place_of(t, pair, point)
            grows = pin_together(t, a, b, x, y) or grows
    return grows


def pin_limb(t: Tables, k: int) -> bool:
    """The same by a hinge, which never lets go."""
    stuck = t.bodies.stuck
    parent = t.limbs.parent[k]
    x = t.bones.x[k] + t.limbs.arm_x[k]
    y = t.bones.y[k] + t.limbs.arm_y[k]
    a = cluster_of(t, t.bones.body[k])
    if t.bones.body[parent] < 0:
        return stuck[a] != FIXED and pin(t, a, x, y)
    b = cluster_of(t, t.bones.body[parent])
    if a == b or stuck[a] + stuck[b] < PINNED + PINNED or stuck[a] + stuck[b] == FIXED + FIXED:
        return False
    return pin_together(t, a, b, x, y)


def pin_together(t: Tables, a: int, b: int, x: float, y: float) -> bool:
    """Pin two clusters to each other at (x, y) (m), both of which are pinned to the ground or one
    of which is fixed; return whether one is pinned anew.
    """
    stuck = t.bodies.stuck
    if stuck[a] == FIXED:
        return pin(t, b, x, y)
    if stuck[b] == FIXED:
        return pin(t, a, x, y)
    if is_triangle(t, a, b, x, y):
        stuck[a] = FIXED
        stuck[b] = FIXED
        return True
    return False


def place_of(t: Tables, pair: int, point: int) -> tuple[float, float]:
    """Where a point of contact is (m)."""
    a = t.pairs.a[pair]
    nx = t.pairs.normal_x[pair]
    ny = t.pairs.normal_y[pair]
    across = t.contacts.normal_arm_a[point]
    along = t.contacts.tangent_arm_a[point]
    x = t.bodies.middle_x[a] + along * nx + across * ny
    return x, t.bodies.middle_y[a] + along * ny - across * nx


def pin(t: Tables, row: int, x: float, y: float) -> bool:
    """Pin a cluster to the ground at (x, y) (m); return whether it was not pinned there before."""
    bodies = t.bodies
    if bodies.stuck[row] == LOOSE:
        bodies.stuck[row] = PINNED
        bodies.pin_x[row] = x
        bodies.pin_y[row] = y
        return True
    x -= bodies.pin_x[row]
    y -= bodies.pin_y[row]
    least = APART * bodies.reach[row]
    if bodies.stuck[row] == PINNED and x * x + y * y > least * least:
        bodies.stuck[row] = FIXED
        return True
    return False


def is_triangle(t: Tables, a: int, b: int, x: float, y: float) -> bool:
    """Whether a pin at (x, y) (m) between two clusters forms a triangle with those of each."""
    bodies = t.bodies
    ax = bodies.pin_x[a] - x
    ay = bodies.pin_y[a] - y
    bx = bodies.pin_x[b] - x
    by = bodies.pin_y[b] - y
    least = APART * bodies.reach[a] * bodies.reach[b]
    return abs(ax * by - ay * bx) > least
