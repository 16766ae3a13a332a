"""Joints at an instant: the impulses for which velocities obey the constraints.

That is the case at the end of each part (`ease`), and when something strikes a joined body: the
bodies joined to it answer at the same instant (`react`).
"""

from engine.kernels.books import book_jolt
from engine.kernels.pose import advance
from engine.linkage.geometry import aim, place_node, place_nodes
from engine.linkage.impulses import add_up, lend, noted_impulse, solve_for, take
from engine.linkage.limb_impacts import react_tree, tree_at
from engine.linkage.limb_motion import ease_limbs, keep_limb_ends, prepare_limbs
from engine.linkage.modes import DRIVEN, ELASTIC, STRAINED, coordinate_row
from engine.linkage.skyline import assemble, factorise, solve
from engine.tables import Tables

MOST_CHANGES = 30
"""How often limits and motors may change their minds in one instant."""


def prepare_ease(t: Tables, part: float, done: float) -> None:
    """Prepare the joints for the end of a part (s), of which the share `done` has passed."""
    prepare_limbs(t)
    if t.braces.sizes[0] == 0:
        return
    joints = t.joints
    gather_ends(t)
    place_nodes(t, 0.0)
    begin_instant(t)
    for brace in range(t.braces.sizes[0]):
        joint = t.braces.joint[brace]
        joints.part[joint] = part * done
        if joints.mode[joint] == ELASTIC:
            row = coordinate_row(t, brace)
            given = noted_impulse(t, joint, row - t.braces.first[brace])
            t.equations.impulse[row] = given * (2.0 * done - 1.0)
            lend(t, row, t.equations.impulse[row])
        elif joints.mode[joint] == STRAINED:
            joints.mode[joint] = DRIVEN
    renew(t)
    t.braces.sizes[5] = 1
    deliver_ends(t)


def ease(t: Tables) -> float:
    """Make velocities obey the constraints; return how fast they did not before (1/s)."""
    of_limbs = ease_limbs(t)
    if t.braces.sizes[0] == 0:
        return of_limbs
    gather_ends(t)
    failed = 0.0
    for step in range(MOST_CHANGES):
        worst = find_rates(t, True)
        if step == 0:
            failed = worst
        solve(t)
        if not take(t, 1.0, True, True):
            break
        renew(t)
    deliver_ends(t)
    return failed if failed > of_limbs else of_limbs


def keep_ends(t: Tables, part: float, done: float) -> None:
    """Note what the joints exert at the end of a part (s), of which the share `done` has passed."""
    keep_limb_ends(t, part, done)
    add_up(t)


def begin_instant(t: Tables) -> None:
    """Set the Jacobians of the placed nodes; nothing has been exerted yet."""
    aim(t)
    equations = t.equations
    for row in range(t.braces.sizes[2]):
        equations.impulse[row] = 0.0
        equations.soft[row] = 0.0
        equations.solved[row] = 1


def renew(t: Tables) -> None:
    """Factorise the system for the present modes; springs do not act at an instant."""
    assemble(t)
    solve_for(t)
    for brace in range(t.braces.sizes[0]):
        if t.joints.mode[t.braces.joint[brace]] == ELASTIC:
            t.equations.solved[coordinate_row(t, brace)] = 0
    factorise(t)


def gather_ends(t: Tables) -> None:
    """Read the velocities at the end of the part."""
    nodes = t.nodes
    bodies = t.bodies
    for node in range(1, t.braces.sizes[1]):
        row = nodes.body[node]
        if bodies.inverse_mass[row] > 0.0:
            nodes.vx[node] = bodies.kick_x[row]
            nodes.vy[node] = bodies.kick_y[row]
            nodes.spin[node] = bodies.kick_spin[row]
        else:
            nodes.vx[node] = bodies.vx[row]
            nodes.vy[node] = bodies.vy[row]
            nodes.spin[node] = bodies.spin[row]
        nodes.lent_x[node] = 0.0
        nodes.lent_y[node] = 0.0
        nodes.lent_spin[node] = 0.0


def deliver_ends(t: Tables) -> None:
    """Give what joints lent to the bodies, at the end of the part."""
    nodes = t.nodes
    bodies = t.bodies
    for node in range(1, t.braces.sizes[1]):
        row = nodes.body[node]
        bodies.kick_x[row] += nodes.lent_x[node]
        bodies.kick_y[row] += nodes.lent_y[node]
        bodies.kick_spin[row] += nodes.lent_spin[node]


def find_rates(t: Tables, driving: bool) -> float:
    """Write right-hand sides: the velocities of the rows, less those that motors want.

    Returns the greatest of them, in sizes of the joints a second (1/s).
    """
    equations = t.equations
    joints = t.joints
    worst = 0.0
    for brace in range(t.braces.sizes[0]):
        joint = t.braces.joint[brace]
        first = t.braces.first[brace]
        coordinate = coordinate_row(t, brace)
        for row in range(first, first + t.braces.rows[brace]):
            rate = 0.0
            if equations.solved[row] == 1:
                rate = rate_of(t, 2 * row) + rate_of(t, 2 * row + 1)
                if driving and row == coordinate and joints.mode[joint] == DRIVEN:
                    rate -= joints.speed[joint]
            equations.unknown[row] = -rate
            rate = (rate if rate > 0.0 else -rate) / joints.size[joint]
            if rate > worst:
                worst = rate
    return worst


def rate_of(t: Tables, arm: int) -> float:
    """What one body adds to the velocity of a row (m/s or rad/s)."""
    nodes = t.nodes
    arms = t.arms
    node = arms.node[arm]
    return (
        arms.x[arm] * (nodes.vx[node] + nodes.lent_x[node])
        + arms.y[arm] * (nodes.vy[node] + nodes.lent_y[node])
        + arms.turn[arm] * (nodes.spin[node] + nodes.lent_spin[node])
    )


def react(
    t: Tables, a: int, b: int, time: float, old: tuple[float, float, float, float, float, float]
) -> None:
    """Let the joints answer, at `time` of the part (s), to what changed the velocities of a and b.

    Args:
        t: the tables.
        a: row of a body, placed and advanced to the time.
        b: another one.
        time: since the part began (s).
        old: velocity and spin of a, then of b, before (m/s, rad/s).
    """
    tree_a = tree_at(t, a)
    tree_b = tree_at(t, b)
    if tree_a >= 0:
        react_tree(t, tree_a, a, b, time, old)
    if tree_b >= 0 and tree_b != tree_a:
        react_tree(t, tree_b, a, b, time, old)
    if (t.bodies.joined[a] == 1 and tree_a < 0) or (t.bodies.joined[b] == 1 and tree_b < 0):
        react_braces(t, a, b, time, old)


def react_braces(
    t: Tables, a: int, b: int, time: float, old: tuple[float, float, float, float, float, float]
) -> None:
    """Do so with the joints that are no hinges of trees."""
    t.braces.sizes[5] = 0
    place_in_flight(t, time)
    begin_instant(t)
    note_changes(t, a, old[0], old[1], old[2])
    note_changes(t, b, old[3], old[4], old[5])
    for _ in range(MOST_CHANGES):
        find_rates(t, False)
        renew(t)
        solve(t)
        if not take(t, 0.0, False, True):
            break
    add_up(t)
    nodes = t.nodes
    bodies = t.bodies
    for node in range(1, t.braces.sizes[1]):
        if changed(t, node):
            row = nodes.body[node]
            advance(bodies, row, time)
            book_jolt(t, row, nodes.lent_x[node], nodes.lent_y[node], nodes.lent_spin[node])
            bodies.vx[row] += nodes.lent_x[node]
            bodies.vy[row] += nodes.lent_y[node]
            bodies.spin[row] += nodes.lent_spin[node]


def changed(t: Tables, node: int) -> bool:
    """Whether joints last changed the velocity of a node."""
    nodes = t.nodes
    return nodes.lent_x[node] != 0.0 or nodes.lent_y[node] != 0.0 or nodes.lent_spin[node] != 0.0


def place_in_flight(t: Tables, time: float) -> None:
    """Place the nodes where their bodies are at `time` of the part (s); velocities are nothing."""
    nodes = t.nodes
    bodies = t.bodies
    for node in range(1, t.braces.sizes[1]):
        row = nodes.body[node]
        passed = time - bodies.clock[row]
        half = passed * passed / 2.0
        x = bodies.x[row] + bodies.vx[row] * passed
        y = bodies.y[row] + bodies.vy[row] * passed
        angle = bodies.angle[row] + bodies.spin[row] * passed
        if bodies.inverse_mass[row] > 0.0:
            x += bodies.path_x[row] * half
            y += bodies.path_y[row] * half
            angle += bodies.path_spin[row] * half
        place_node(t, node, x, y, angle)
        nodes.vx[node] = 0.0
        nodes.vy[node] = 0.0
        nodes.spin[node] = 0.0
        nodes.lent_x[node] = 0.0
        nodes.lent_y[node] = 0.0
        nodes.lent_spin[node] = 0.0


def note_changes(t: Tables, row: int, vx: float, vy: float, spin: float) -> None:
    """Write the change of a body's velocity (m/s, rad/s) to its node, if it has one."""
    nodes = t.nodes
    for node in range(1, t.braces.sizes[1]):
        if nodes.body[node] == row:
            nodes.vx[node] = t.bodies.vx[row] - vx
            nodes.vy[node] = t.bodies.vy[row] - vy
            nodes.spin[node] = t.bodies.spin[row] - spin
