"""Joints at the start of a part: the impulses for which the constraints hold at its end.

In each part joints exert two impulses on the bodies: one at its start, such that the constraints
hold where the bodies are at its end (here), one at its end, such that the velocities obey them too
(`velocities`). Between the two, bodies move as if they were free. This is RATTLE (Andersen, J.
Comput. Phys. 52, 1983): symmetric, symplectic, of second order; energy swings within bounds and
does not drift. The equations are solved by Newton's method (`seeking`), beginning with the impulses
of the part before.
"""

from engine.kernels.moments import place_in_part
from engine.linkage.closing import note_closings
from engine.linkage.geometry import aim, measure, place_nodes, weigh_node
from engine.linkage.impulses import add_up, lend, note_impulses
from engine.linkage.jolts import jolt, jolt_start
from engine.linkage.limb_guesses import keep_limb_impulses
from engine.linkage.limb_motion import brace_limbs
from engine.linkage.modes import (
    CLOSES,
    HOLDS,
    bounds,
    coordinate_row,
    first_mode,
    note_start,
    scale_of,
)
from engine.linkage.moments import book_braces
from engine.linkage.seeking import STRIDE, find_impulses, renew, seek_straight
from engine.tables import Tables
from engine.tables.linkage import FREE_WAY, STRAINED


def brace(t: Tables, part: float) -> None:
    """Prepare the joints for a part (s); let the impulses of the part before act."""
    brace_limbs(t, part)
    if t.braces.sizes[0] == 0:
        return
    for node in range(t.braces.sizes[1]):
        t.nodes.sum_x[node] = 0.0
        t.nodes.sum_y[node] = 0.0
        t.nodes.sum_spin[node] = 0.0
        t.nodes.late[node] = 0
    gather_means(t)
    place_nodes(t, 0.0)
    known = t.braces.sizes[5] == 1 and t.braces.sizes[6] == 0
    if not known:
        aim(t)
    measure(t)
    warm_start(t, part)
    if not known:
        renew(t, part)
    t.braces.sizes[5] = 0
    t.braces.sizes[7] = 0
    note_closings(t, part)
    for row in range(t.braces.sizes[2]):
        lend(t, row, t.equations.impulse[row])
    if leads_astray(t, part):
        forget(t)
    book_braces(t, 0.0, True)
    deliver(t)


def leads_astray(t: Tables, part: float) -> bool:
    """Whether what joints begin a part (s) with would by itself move a joint further than a stride.

    Impulses that were in balance, as equations nearly said the same, are so no more where bodies
    have turned: contacts would feel them before the joints have found others.
    """
    nodes = t.nodes
    arms = t.arms
    for brace in range(t.braces.sizes[0]):
        first = t.braces.first[brace]
        for row in range(first, first + t.braces.rows[brace]):
            way = 0.0
            for arm in range(2 * row, 2 * row + 2):
                node = arms.node[arm]
                way += arms.x[arm] * nodes.lent_x[node] + arms.y[arm] * nodes.lent_y[node]
                way += arms.turn[arm] * nodes.lent_spin[node]
            if abs(way) * part > STRIDE * scale_of(t, row, t.braces.joint[brace]):
                return True
    return False


def forget(t: Tables) -> None:
    """Begin with nothing."""
    nodes = t.nodes
    for row in range(t.braces.sizes[2]):
        t.equations.impulse[row] = 0.0
    for node in range(1, t.braces.sizes[1]):
        nodes.lent_x[node] = 0.0
        nodes.lent_y[node] = 0.0
        nodes.lent_spin[node] = 0.0


def bind(t: Tables, part: float) -> float:
    """Make the constraints, those of trees of hinges apart, hold at the end of the part; return how
    fast they failed it before.

    That speed is in reaches of the smaller body a second (1/s).
    """
    if t.braces.sizes[0] == 0:
        return 0.0
    gather_means(t)
    for row in range(t.braces.sizes[2]):
        t.equations.total[row] = 0.0
    if t.braces.sizes[7] == 0:
        failed = find_impulses(t, part)
        if t.braces.sizes[7] > 0:
            tell_once(t)
    else:
        failed = seek_straight(t, part)
    book_braces(t, 0.0, False)
    deliver(t)
    return failed


def hold_less(t: Tables) -> None:
    """Let joints only close gaps for the rest of a part or, if they do already, keep them."""
    if t.braces.sizes[7] == 0:
        tell_once(t)
        t.braces.sizes[7] = CLOSES
    else:
        t.braces.sizes[7] = HOLDS


def retract(t: Tables) -> None:
    """Take back what joints exerted at the start of a part that is not taken."""
    nodes = t.nodes
    for node in range(1, t.braces.sizes[1]):
        x = nodes.sum_x[node]
        y = nodes.sum_y[node]
        jolt(t, nodes.body[node], -x, -y, -nodes.sum_spin[node])
    for row in range(t.braces.sizes[2]):
        t.equations.impulse[row] = -t.equations.impulse[row]
    add_up(t)
    book_braces(t, 0.0, True)


def keep_impulses(t: Tables, part: float) -> None:
    """Note what the joints exert at the start of the part (s), once that is settled."""
    if t.braces.sizes[7] == 0:
        tell_once(t)
    keep_limb_impulses(t, part)
    note_impulses(t)
    add_up(t)


def gather_means(t: Tables) -> None:
    """Read the mean velocities over the part (see `deliver`); what joints lend is nothing yet."""
    nodes = t.nodes
    bodies = t.bodies
    told_twice = 1.0 if t.braces.sizes[7] == 0 else 0.0
    for node in range(1, t.braces.sizes[1]):
        row = nodes.body[node]
        weigh_node(t, node)
        if bodies.inverse_mass[row] > 0.0:
            x = bodies.vx[row] - told_twice * nodes.sum_x[node]
            y = bodies.vy[row] - told_twice * nodes.sum_y[node]
            turn = bodies.spin[row] - told_twice * nodes.sum_spin[node]
            nodes.vx[node] = (x + bodies.kick_x[row]) / 2.0
            nodes.vy[node] = (y + bodies.kick_y[row]) / 2.0
            nodes.spin[node] = (turn + bodies.kick_spin[row]) / 2.0
        else:
            nodes.vx[node] = bodies.vx[row]
            nodes.vy[node] = bodies.vy[row]
            nodes.spin[node] = bodies.spin[row]
        nodes.lent_x[node] = 0.0
        nodes.lent_y[node] = 0.0
        nodes.lent_spin[node] = 0.0


def deliver(t: Tables) -> None:
    """Give what joints lent to the bodies, from the start of the part on.

    They give it at once, and the other half at the end, contacts evenly in between: a body that a
    joint presses on another dips into that, and comes back, if contacts stop twice what the joint
    gave at the start. So they are told of it twice, unless no solution was found: what then closes
    gaps is given once. Where contacts stopped only what was left at the end of a part, bodies sank
    into each other.
    """
    nodes = t.nodes
    bodies = t.bodies
    twice = t.braces.sizes[7] == 0
    for node in range(1, t.braces.sizes[1]):
        row = nodes.body[node]
        x = nodes.lent_x[node]
        y = nodes.lent_y[node]
        turn = nodes.lent_spin[node]
        jolt_start(t, row, x, y, turn)
        if twice:
            bodies.kick_x[row] += x
            bodies.kick_y[row] += y
            bodies.kick_spin[row] += turn
        nodes.sum_x[node] += x
        nodes.sum_y[node] += y
        nodes.sum_spin[node] += turn


def tell_once(t: Tables) -> None:
    """Take back what contacts were told twice of what joints gave; see `deliver`."""
    bodies = t.bodies
    nodes = t.nodes
    for node in range(1, t.braces.sizes[1]):
        row = nodes.body[node]
        bodies.kick_x[row] -= nodes.sum_x[node]
        bodies.kick_y[row] -= nodes.sum_y[node]
        bodies.kick_spin[row] -= nodes.sum_spin[node]


def follow_joints(t: Tables, part: float, reached: float) -> None:
    """Add to `shift` by how much joints moved the middle of the planned paths of a part (s), which
    ended when `reached` seconds had passed.
    """
    nodes = t.nodes
    bodies = t.bodies
    for node in range(1, t.braces.sizes[1]):
        row = nodes.body[node]
        bodies.shift_x[row] += nodes.sum_x[node] * part / 2.0
        bodies.shift_y[row] += nodes.sum_y[node] * part / 2.0
    bones = t.bones
    for bone in range(bones.sizes[1]):
        row = bones.body[bone]
        bodies.shift_x[row] += bones.sum_x[bone] * part / 2.0
        bodies.shift_y[row] += bones.sum_y[bone] * part / 2.0
        if reached > 0.0:
            x = bones.late_x[bone] * reached - 2.0 * bones.late_once_x[bone]
            y = bones.late_y[bone] * reached - 2.0 * bones.late_once_y[bone]
            bodies.shift_x[row] += (x + bones.late_twice_x[bone] / reached) / 2.0
            bodies.shift_y[row] += (y + bones.late_twice_y[bone] / reached) / 2.0


def follow_late(t: Tables, reached: float) -> None:
    """Set `shift` of bodies that joints jolted within a part, at impacts, by the way that they went
    until it ended (s).
    """
    bodies = t.bodies
    for node in range(1, t.braces.sizes[1]):
        if t.nodes.late[node] == 1:
            row = t.nodes.body[node]
            x, y = place_in_part(bodies, row, reached)
            bodies.shift_x[row] = x - bodies.middle_x[row]
            bodies.shift_y[row] = y - bodies.middle_y[row]


def warm_start(t: Tables, part: float) -> None:
    """Set modes, and impulses as they were in the part before; note where coordinates start."""
    joints = t.joints
    equations = t.equations
    for brace in range(t.braces.sizes[0]):
        joint = t.braces.joint[brace]
        share = part / joints.part[joint] if joints.part[joint] > 0.0 else 0.0
        if share > 1.0:
            share = 1.0
        joints.part[joint] = part
        first = t.braces.first[brace]
        rows = t.braces.rows[brace]
        equations.impulse[first] = joints.impulse_0[joint] * share
        if rows > 1:
            equations.impulse[first + 1] = joints.impulse_1[joint] * share
        if rows > 2:
            equations.impulse[first + 2] = joints.impulse_2[joint] * share
        for row in range(first, first + rows):
            equations.start[row] = equations.value[row]
            equations.solved[row] = 1
            equations.soft[row] = 0.0
        row = coordinate_row(t, brace)
        if row >= 0:
            note_start(t, joint, row)
            joints.mode[joint] = first_mode(t, joint)
            least, most = bounds(t, joint, joints.effort[joint] * part / 2.0)
            strained = joints.mode[joint] == STRAINED
            if joints.mode[joint] == FREE_WAY:
                equations.impulse[row] = 0.0
            elif equations.impulse[row] < least or (strained and equations.impulse[row] < 0.0):
                equations.impulse[row] = least
            elif equations.impulse[row] > most or (strained and equations.impulse[row] > 0.0):
                equations.impulse[row] = most
