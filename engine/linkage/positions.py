"""Joints at the start of a part: the impulses for which the constraints hold at its end.

In each part joints exert two impulses on the bodies: one at its start, such that the constraints
hold where the bodies are at its end (here), one at its end, such that the velocities obey them too
(`velocities`). Between the two, bodies move as if they were free. This is RATTLE (Andersen, J.
Comput. Phys. 52, 1983): symmetric, symplectic, of second order; energy swings within bounds and
does not drift. The equations are solved by Newton's method with the matrix of the start of the part
(`skyline`), beginning with the impulses of the part before.
"""

from engine.linkage.geometry import aim, measure, place_nodes
from engine.linkage.impulses import add_up, lend, note_impulses, solve_for, take
from engine.linkage.jolts import jolt, jolt_start
from engine.linkage.limb_guesses import keep_limb_impulses
from engine.linkage.limb_motion import brace_limbs
from engine.linkage.modes import (
    CLOSES,
    FARTHEST,
    HOLDS,
    TIGHT,
    bounds,
    coordinate_row,
    first_mode,
    left_gaping,
    miss_of_mode,
    next_mode,
    note_start,
    scale_of,
)
from engine.linkage.skyline import assemble, factorise, solve
from engine.linkage.springs import miss, tune
from engine.linkage.throwing import throws
from engine.linkage.velocities import rate_of
from engine.tables import Tables
from engine.tables.linkage import ELASTIC, FREE_WAY

MOST_STEPS = 40
"""Steps of Newton's method that a part has at most."""

STRIDE = 0.25
"""Longest step, in reaches of the smaller body (rad)."""

FAILED = 1e-8
"""Steps that leave a larger miss, in the same unit, have found no solution."""

MOST_TURN = 1.5
"""A solution that turns a body by more in a part, beyond its own spin, is none (rad)."""

MOST_CHANGES = 12
"""How often limits and motors may change their minds in a part. A limit begins, and a strained
motor ends, only where everything else is solved; else they would chase each other."""


def brace(t: Tables, part: float) -> None:
    """Prepare the joints for a part (s); let the impulses of the part before act."""
    brace_limbs(t, part)
    if t.braces.sizes[0] == 0:
        return
    for node in range(t.braces.sizes[1]):
        t.nodes.sum_x[node] = 0.0
        t.nodes.sum_y[node] = 0.0
        t.nodes.sum_spin[node] = 0.0
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
    for row in range(t.braces.sizes[2]):
        lend(t, row, t.equations.impulse[row])
    if leads_astray(t, part):
        forget(t)
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
    if t.braces.sizes[7] > 0:
        failed = seek_straight(t, part)
        deliver(t)
        return failed
    failed, found = seek(t, part, STRIDE)
    if failed * part > STRIDE:
        choose_start(t, part, failed * part)
        _, found = seek(t, part, FARTHEST)
    if not found:
        take_back(t)
        renew(t, part)
        _, found = seek(t, part, FARTHEST)
    if not found:
        for way in (CLOSES, HOLDS):
            take_back(t)
            t.braces.sizes[7] = way
            renew(t, part)
            seek_straight(t, part)
            if not throws(t, part):
                break
    deliver(t)
    return failed


def seek_straight(t: Tables, part: float) -> float:
    """Look for the impulses for which the constraints hold to first order: as if their Jacobians
    were those of the start all through the part. Return how fast they failed that before (1/s).

    Mean velocities are projected on those that obey, which takes energy, but for what closes gaps:
    where joints contradict each other, none closes.
    """
    failed = 0.0
    for step in range(MOST_CHANGES):
        last = step == MOST_CHANGES - 1
        predict(t, part)
        worst = find_misses(t, part)
        if not last and choose_modes(t, part):
            renew(t, part)
            worst = find_misses(t, part)
        if step == 0:
            failed = worst / part
        solve(t)
        if not take(t, 0.5, False, not last):
            break
        renew(t, part)
    return failed


def predict(t: Tables, part: float) -> None:
    """Set the values of all rows at the end of a part (s) to first order."""
    for row in range(t.braces.sizes[2]):
        rate = rate_of(t, 2 * row) + rate_of(t, 2 * row + 1)
        t.equations.value[row] = t.equations.start[row] + rate * part


def choose_start(t: Tables, part: float, worst: float) -> None:
    """Begin with nothing, if that misses the goal by less than what acts, which misses by `worst`
    (reaches of the smaller body).
    """
    equations = t.equations
    for row in range(t.braces.sizes[2]):
        equations.change[row] = equations.impulse[row]
    take_back(t)
    place_nodes(t, part)
    measure(t)
    if find_misses(t, part) > worst:
        for row in range(t.braces.sizes[2]):
            equations.impulse[row] = equations.change[row]
            equations.total[row] += equations.change[row]
            lend(t, row, equations.change[row])


def seek(t: Tables, part: float, most: float) -> tuple[float, bool]:
    """Look for the impulses that do so, from those that act, if these miss by `most` reaches of the
    smaller body at most; return that speed, and whether they were found.

    A solution far from where the bodies would be without is none: a light link between heavy bodies
    would be turned over.
    """
    failed = 0.0
    worst = 0.0
    before = 0.0
    changes = 0
    fresh = True
    for step in range(MOST_STEPS):
        place_nodes(t, part)
        measure(t)
        worst = find_misses(t, part)
        if step == 0 or worst <= TIGHT:
            if changes < MOST_CHANGES and choose_modes(t, part):
                renew(t, part)
                worst = find_misses(t, part)
                changes += 1
                fresh = True
            elif worst <= TIGHT:
                break
        if step == 0:
            failed = worst / part
            if worst > most:
                return failed, False
        if worst > before and not fresh:
            step_back(t)
            continue
        before = worst
        if worst > STRIDE:
            shorten(t, STRIDE / worst)
        solve(t)
        fresh = take(t, 0.5, False, changes < MOST_CHANGES)
        if fresh:
            renew(t, part)
            changes += 1
    return failed, worst <= FAILED and not turns_over(t, part) and not throws(t, part)


def turns_over(t: Tables, part: float) -> bool:
    """Whether joints turn a body by more than `MOST_TURN` in a part (s)."""
    nodes = t.nodes
    for node in range(1, t.braces.sizes[1]):
        own = t.bodies.spin[nodes.body[node]] - nodes.sum_spin[node]
        if abs(nodes.spin[node] + nodes.lent_spin[node] - own) * part > MOST_TURN:
            return True
    return False


def take_back(t: Tables) -> None:
    """Take back all that was lent, as it led nowhere.

    So it is where links are pulled straight between two fixed points, and something pushes them
    aside: no impulse keeps them as long as they are.
    """
    equations = t.equations
    nodes = t.nodes
    for node in range(1, t.braces.sizes[1]):
        nodes.lent_x[node] = 0.0
        nodes.lent_y[node] = 0.0
        nodes.lent_spin[node] = 0.0
    for row in range(t.braces.sizes[2]):  # what the steps added has not been delivered
        equations.total[row] -= equations.impulse[row]
        equations.impulse[row] = 0.0
        lend(t, row, equations.total[row])


def shorten(t: Tables, share: float) -> None:
    """Ask for a share of the step only: far away, the matrix says little about the goal."""
    for row in range(t.braces.sizes[2]):
        t.equations.unknown[row] *= share


def step_back(t: Tables) -> None:
    """Take half of the last step back, as it led further away."""
    equations = t.equations
    for row in range(t.braces.sizes[2]):
        half = equations.change[row] / 2.0
        equations.change[row] = half
        equations.impulse[row] -= half
        equations.total[row] -= half
        lend(t, row, -half)


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


def keep_impulses(t: Tables, part: float) -> None:
    """Note what the joints exert at the start of the part (s), once that is settled."""
    keep_limb_impulses(t, part)
    note_impulses(t)
    add_up(t)


def gather_means(t: Tables) -> None:
    """Read the mean velocities over the part; what joints lend is nothing yet."""
    nodes = t.nodes
    bodies = t.bodies
    for node in range(1, t.braces.sizes[1]):
        row = nodes.body[node]
        nodes.inverse_mass[node] = bodies.inverse_mass[row]
        nodes.inverse_inertia[node] = bodies.inverse_inertia[row]
        if bodies.inverse_mass[row] > 0.0:
            nodes.vx[node] = (bodies.vx[row] + bodies.kick_x[row]) / 2.0
            nodes.vy[node] = (bodies.vy[row] + bodies.kick_y[row]) / 2.0
            nodes.spin[node] = (bodies.spin[row] + bodies.kick_spin[row]) / 2.0
        else:
            nodes.vx[node] = bodies.vx[row]
            nodes.vy[node] = bodies.vy[row]
            nodes.spin[node] = bodies.spin[row]
        nodes.lent_x[node] = 0.0
        nodes.lent_y[node] = 0.0
        nodes.lent_spin[node] = 0.0


def deliver(t: Tables) -> None:
    """Give what joints lent to the bodies, from the start of the part on."""
    nodes = t.nodes
    for node in range(1, t.braces.sizes[1]):
        x = nodes.lent_x[node]
        y = nodes.lent_y[node]
        jolt_start(t, nodes.body[node], x, y, nodes.lent_spin[node])
        nodes.sum_x[node] += x
        nodes.sum_y[node] += y
        nodes.sum_spin[node] += nodes.lent_spin[node]


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
            if joints.mode[joint] == FREE_WAY:
                equations.impulse[row] = 0.0
            elif equations.impulse[row] < least:
                equations.impulse[row] = least
            elif equations.impulse[row] > most:
                equations.impulse[row] = most


def renew(t: Tables, part: float) -> None:
    """Factorise the system for the present modes."""
    assemble(t)
    solve_for(t)
    for brace in range(t.braces.sizes[0]):
        row = coordinate_row(t, brace)
        if row >= 0:
            joint = t.braces.joint[brace]
            if t.joints.mode[joint] == ELASTIC:
                tune(t, row, joint, part)
    factorise(t)


def choose_modes(t: Tables, part: float) -> bool:
    """Choose modes by where the bodies would go; return whether one changed."""
    changed = False
    for brace in range(t.braces.sizes[0]):
        row = coordinate_row(t, brace)
        if row >= 0:
            joint = t.braces.joint[brace]
            mode = next_mode(t, joint, row, part, TIGHT * scale_of(t, row, joint))
            if mode != t.joints.mode[joint]:
                t.joints.mode[joint] = mode
                changed = True
    return changed


def find_misses(t: Tables, part: float) -> float:
    """Write right-hand sides; return by how much a row misses its goal at most, in its unit."""
    equations = t.equations
    worst = 0.0
    for brace in range(t.braces.sizes[0]):
        joint = t.braces.joint[brace]
        coordinate = coordinate_row(t, brace)
        first = t.braces.first[brace]
        for row in range(first, first + t.braces.rows[brace]):
            missed = equations.value[row]
            if row != coordinate:
                missed -= left_gaping(t, row, joint, part)
            elif t.joints.mode[joint] != ELASTIC:
                missed = miss_of_mode(t, joint, row, part)
            elif equations.solved[row] == 1:
                missed = miss(t, row, part)
            if equations.solved[row] == 0:
                missed = 0.0
            equations.unknown[row] = -missed / part
            if equations.inverse_pivot[row] > 0.0:
                size = (missed if missed > 0.0 else -missed) / scale_of(t, row, joint)
                if size > worst:
                    worst = size
    return worst
