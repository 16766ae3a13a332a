"""Which solutions of joints would throw the bodies: those that make them livelier.

Joints that hold do no work. What they exert at the start of a part of a tick, and take back at its
end, changes kinetic energy in between by no more than bodies turn meanwhile: one that goes round
on a circle, by an angle a in a part, goes along the chord, for which it needs tan^2(a/2), nearly
a^2/4, of its energy more. But equations may have other solutions: links between two fixed points
that are all but straight, or a light link between heavy ones, can be thrown to the other side, and
back, within a part. What is thrown has its energy from nowhere.
"""

from engine.kernels.spring import PUSH
from engine.linkage.closing import energy_of_all, rates_of_closing
from engine.linkage.impulses import rate_of
from engine.linkage.modes import coordinate_row, drives
from engine.linkage.tally import has_braces
from engine.tables import Tables

LIVELIER = 0.02
"""Share of their kinetic energy that bodies gain at most, but for what turns, and gaps that close:
parts are so short that motion which is followed well needs less."""

ROUNDING = 1e-12
"""Share of the energy that each impulse would give by itself: impulses that balance each other on
what stands still do no work but by rounding."""


def throws(t: Tables, part: float) -> bool:
    """Whether joints that only hold, trees of hinges apart, do so in a part (s)."""
    nodes = t.nodes
    bodies = t.bodies
    most = 0.0
    note_driven(t)
    for node in range(1, t.braces.sizes[1]):
        row = nodes.body[node]
        if bodies.inverse_mass[row] > 0.0 or bodies.inverse_inertia[row] > 0.0:
            x = nodes.vx[node] - nodes.sum_x[node] + nodes.driven_x[node]
            y = nodes.vy[node] - nodes.sum_y[node] + nodes.driven_y[node]
            turn = nodes.spin[node] - nodes.sum_spin[node] + nodes.driven_spin[node]
            most += energy(t, row, x, y, turn) * gain(turn * part)
    work = 0.0
    for brace in range(t.braces.sizes[0]):
        joint = t.braces.joint[brace]
        coordinate = coordinate_row(t, brace)
        first = t.braces.first[brace]
        for row in range(first, first + t.braces.rows[brace]):
            impulse = t.equations.impulse[row]
            done = impulse * (way_of(t, 2 * row) + way_of(t, 2 * row + 1))
            if t.equations.mass[row] > 0.0:
                most += ROUNDING * impulse * impulse / t.equations.mass[row]
            if row == coordinate and drives(t, joint, row):
                most += LIVELIER * abs(done)
            else:
                work += done
    closing, turning = rates_of_closing(t, part)
    return work > most + energy_of_all(t, closing, turning)


def drive_each_other(t: Tables, count: int, part: float) -> bool:
    """Whether contacts and joints together throw what they hold in a part (s), beyond what closes
    gaps and pushes overlaps apart, and what springs and motors do.

    By itself neither gains energy; but what one of them stops, the other may have to undo.
    """
    bodies = t.bodies
    nodes = t.nodes
    closing, turning = rates_of_closing(t, part)
    excess = -energy_of_all(t, closing, turning)
    for row in range(count):
        if not has_braces(t, row) and bodies.held[row] > 0 and bodies.inverse_mass[row] > 0.0:
            excess += excess_of(t, row, part, (0.0, 0.0, 0.0), 0.0)
    told_twice = 1.0 if t.braces.sizes[7] == 0 else 0.0
    for node in range(1, t.braces.sizes[1]):
        row = nodes.body[node]
        if bodies.inverse_mass[row] > 0.0:
            sums = (nodes.sum_x[node], nodes.sum_y[node], nodes.sum_spin[node])
            excess += excess_of(t, row, part, sums, told_twice)
    for brace in range(t.braces.sizes[0]):
        row = coordinate_row(t, brace)
        if row >= 0 and drives(t, t.braces.joint[brace], row):
            rate = rate_of(t, 2 * row) + rate_of(t, 2 * row + 1)
            excess -= abs(2.0 * t.equations.impulse[row] * rate)
    return excess > 0.0


def excess_of(
    t: Tables, row: int, part: float, sums: tuple[float, float, float], told_twice: float
) -> float:
    """By how much twice the energy of a body in the middle of a part (s) exceeds what it would have
    there if it touched nothing and were joined to nothing (J), beyond what may be; `sums` is what
    joints gave it at the start (m/s, rad/s).
    """
    bodies = t.bodies
    half = part / 2.0
    x = bodies.vx[row] - sums[0]
    y = bodies.vy[row] - sums[1]
    turn = bodies.spin[row] - sums[2]
    mean_x = (bodies.vx[row] + bodies.kick_x[row] - told_twice * sums[0]) / 2.0
    mean_y = (bodies.vy[row] + bodies.kick_y[row] - told_twice * sums[1]) / 2.0
    mean_turn = (bodies.spin[row] + bodies.kick_spin[row] - told_twice * sums[2]) / 2.0
    allowed = gain(turn * part) if bodies.joined[row] == 1 else 0.0
    x += bodies.ax[row] * half
    y += bodies.ay[row] * half
    turn += bodies.aspin[row] * half
    lent = PUSH * bodies.reach[row]
    now = energy(t, row, mean_x, mean_y, mean_turn)
    return now - energy(t, row, x, y, turn) * (1.0 + allowed) - bodies.mass[row] * lent * lent


def note_driven(t: Tables) -> None:
    """Note what motors and springs, and what hands put beyond limits, add to the velocities: the
    others hold what moves with that, and take energy from it.
    """
    nodes = t.nodes
    arms = t.arms
    for node in range(t.braces.sizes[1]):
        nodes.driven_x[node] = nodes.driven_y[node] = nodes.driven_spin[node] = 0.0
    for brace in range(t.braces.sizes[0]):
        row = coordinate_row(t, brace)
        if row >= 0 and drives(t, t.braces.joint[brace], row):
            impulse = t.equations.impulse[row]
            for arm in range(2 * row, 2 * row + 2):
                node = arms.node[arm]
                nodes.driven_x[node] += arms.by_mass_x[arm] * impulse
                nodes.driven_y[node] += arms.by_mass_y[arm] * impulse
                nodes.driven_spin[node] += arms.by_inertia[arm] * impulse


def way_of(t: Tables, arm: int) -> float:
    """What one body adds to the mean velocity of a row, with motors and springs alone and with all
    joints (m/s).
    """
    nodes = t.nodes
    arms = t.arms
    node = arms.node[arm]
    x = 2.0 * nodes.vx[node] + nodes.lent_x[node] - nodes.sum_x[node] + nodes.driven_x[node]
    y = 2.0 * nodes.vy[node] + nodes.lent_y[node] - nodes.sum_y[node] + nodes.driven_y[node]
    turn = nodes.lent_spin[node] - nodes.sum_spin[node] + nodes.driven_spin[node]
    turn += 2.0 * nodes.spin[node]
    return arms.x[arm] * x + arms.y[arm] * y + arms.turn[arm] * turn


def energy(t: Tables, row: int, x: float, y: float, turn: float) -> float:
    """Twice the kinetic energy of a body with a velocity (m/s) and a spin (rad/s) (J)."""
    bodies = t.bodies
    moving = bodies.mass[row] * (x * x + y * y) if bodies.inverse_mass[row] > 0.0 else 0.0
    turning = bodies.inertia[row] * turn * turn if bodies.inverse_inertia[row] > 0.0 else 0.0
    return moving + turning


def energy_of_bone(t: Tables, bone: int, x: float, y: float, turn: float) -> float:
    """The same of a bone, whose mass and inertia lie beside each other."""
    return t.bones.mass[bone] * (x * x + y * y) + t.bones.inertia[bone] * turn * turn


def gain(angle: float) -> float:
    """The share of its energy that joints may add to a body that turns by an angle (rad)."""
    return LIVELIER + angle * angle / 4.0


def note_energies(t: Tables, part: float) -> None:
    """Note for each tree twice the energy that it has in the middle of a part (s) if its hinges
    exert nothing, and what they may add (J).
    """
    bones = t.bones
    bodies = t.bodies
    trees = t.trees
    for at in range(bones.sizes[10]):
        trees.lively[trees.acting[at]] = 0.0
    half = part / 2.0
    for at in range(bones.sizes[9]):
        bone = bones.acting[at]
        row = bones.body[bone]
        x = bodies.vx[row] + bodies.ax[row] * half
        y = bodies.vy[row] + bodies.ay[row] * half
        turn = bodies.spin[row] + bodies.aspin[row] * half
        own = energy_of_bone(t, bone, x, y, turn)
        trees.lively[bones.tree[bone]] += own * (1.0 + gain(turn * part))


def weigh_trees(t: Tables, part: float) -> None:
    """Find for each tree by how much hinges make its energy larger than that in the part (s)."""
    bones = t.bones
    trees = t.trees
    if bones.sizes[7] == 0:  # else bodies were given already what was likely
        note_energies(t, part)
    for at in range(bones.sizes[10]):
        trees.lash[trees.acting[at]] = -trees.lively[trees.acting[at]]
    for at in range(bones.sizes[9]):
        bone = bones.acting[at]
        x = bones.vx[bone] + bones.lent_x[bone]
        y = bones.vy[bone] + bones.lent_y[bone]
        turn = bones.spin[bone] + bones.lent_spin[bone]
        trees.lash[bones.tree[bone]] += energy_of_bone(t, bone, x, y, turn)


def is_livelier(t: Tables, tree: int) -> bool:
    """Whether the hinges of a tree throw it, beyond what closes gaps; contacts make trees livelier
    by themselves.
    """
    bones = t.bones
    limbs = t.limbs
    trees = t.trees
    if trees.evenly[tree] == 1 or trees.lash[tree] <= 0.0:
        return False
    mass = bones.mass[trees.root[tree]] if trees.root[tree] >= 0 else 0.0
    fastest = 0.0
    first = trees.first[tree]
    for at in range(first, first + trees.limbs[tree]):
        k = limbs.member[at]
        mass += bones.mass[k]
        square = limbs.gap_x[k] * limbs.gap_x[k] + limbs.gap_y[k] * limbs.gap_y[k]
        square /= bones.lasts[k] * bones.lasts[k]
        if square > fastest:
            fastest = square
    return trees.lash[tree] > mass * fastest


def has_lost_pivot(t: Tables, tree: int) -> bool:
    """Whether a pivot of a tree has changed its sign, so that it was solved as if a body could not
    turn: bodies turn further in the part than the solution.
    """
    first = t.trees.first[tree]
    for at in range(first, first + t.trees.limbs[tree]):
        k = t.limbs.member[at]
        if t.limbs.ease[k] == 0.0 and t.bones.inverse_inertia[k] > 0.0:
            return True
    return False
