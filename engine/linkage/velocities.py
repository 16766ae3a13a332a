"""Joints at the end of each part: the impulses for which velocities obey the constraints."""

from engine.linkage.geometry import aim, measure, place_nodes
from engine.linkage.impulses import (
    add_up,
    bounds_left,
    lend,
    noted_impulse,
    rate_of,
    solve_for,
    take,
)
from engine.linkage.limb_velocities import keep_limb_ends, prepare_limbs
from engine.linkage.modes import TIGHT, coordinate_row, is_driven_away, note_end, scale_of
from engine.linkage.moments import book_braces
from engine.linkage.skyline import assemble, factorise, solve
from engine.linkage.stalling import stall
from engine.tables import Tables
from engine.tables.linkage import DRIVEN, ELASTIC, STRAINED

RESTLESS = 1e300
"""What `ease` returns if a motor changed its mind (1/s): contacts do not know of it yet."""

UTMOST = 1.0 - 1e-9
"""Share of its greatest effort from which on a motor is strained."""

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
    measure(t)
    begin_instant(t)
    found = t.braces.sizes[7] == 0
    for brace in range(t.braces.sizes[0]):
        joint = t.braces.joint[brace]
        joints.part[joint] = part * done
        row = coordinate_row(t, brace)
        if row < 0:
            continue
        note_end(t, joint, row, found)
        given = noted_impulse(t, joint, row - t.braces.first[brace])
        left = 0.0
        if joints.mode[joint] == ELASTIC:
            left = given * (2.0 * done - 1.0)
        elif joints.mode[joint] == STRAINED:
            if 2.0 * abs(given) < UTMOST * joints.effort[joint] * part:
                joints.mode[joint] = DRIVEN  # it was strained by an impact, in which none acts
            else:
                least, most = bounds_left(t, brace, row, 1.0, True)
                left = most if given > 0.0 else least
        if left != 0.0:
            t.equations.impulse[row] = left
            lend(t, row, left)
    renew(t)
    t.braces.sizes[5] = 1
    deliver_ends(t)


def ease(t: Tables, calm: bool) -> float:
    """Make velocities obey the constraints, those of trees of hinges apart; return how fast they
    did not before (1/s).

    Motors are driven anew only where contacts are `calm`: those that have not yet stopped what a
    strained motor pushes against them would let it have its speed with less.
    """
    if t.braces.sizes[0] == 0:
        return 0.0
    gather_ends(t)
    failed = 0.0
    for step in range(MOST_CHANGES):
        worst = find_rates(t, True)
        if step == 0:
            failed = worst
        solve(t)
        if not take(t, 1.0, True, step < MOST_CHANGES - 1):
            if not calm or not drive_anew(t):
                break
            failed = RESTLESS
        renew(t)
    deliver_ends(t)
    return failed


def drive_anew(t: Tables) -> bool:
    """Let strained motors keep their speed that hold back what is too slow, or push what is too
    fast, and let others stall; return whether there are any.

    What the motor of another joint wanted before it was strained had the former do so.
    """
    joints = t.joints
    changed = False
    part = 0.0
    for brace in range(t.braces.sizes[0]):
        joint = t.braces.joint[brace]
        row = coordinate_row(t, brace)
        if row < 0:
            continue
        if joints.mode[joint] == DRIVEN:
            part = joints.part[joint]
        elif joints.mode[joint] == STRAINED:
            ahead = rate_of(t, 2 * row) + rate_of(t, 2 * row + 1) - joints.speed[joint]
            effort = t.equations.impulse[row] + noted_impulse(t, joint, row - t.braces.first[brace])
            slack = TIGHT * scale_of(t, row, joint)
            if abs(ahead) * joints.part[joint] > slack and is_driven_away(effort, ahead):
                joints.mode[joint] = DRIVEN
                changed = True
    if changed or part == 0.0:
        return changed
    find_rates(t, True)
    return stall(t, part, 1.0, True)


def keep_ends(t: Tables, part: float, done: float, steady: bool) -> None:
    """Note what the joints exert at the end of a part (s), of which the share `done` has passed."""
    keep_limb_ends(t, part, done, steady)
    add_up(t)
    book_braces(t, 0.0, True)


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
