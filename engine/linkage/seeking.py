"""The impulses for which joints hold at the end of a part, by Newton's method.

It takes the matrix of the start of the part (`skyline`). Where it finds no solution, as links are
pulled straight, or one that would throw the bodies (`throwing`), joints hold to first order.
"""

from engine.linkage.geometry import measure, place_nodes
from engine.linkage.impulses import lend, rate_of, solve_for, take
from engine.linkage.modes import (
    CLOSES,
    FARTHEST,
    HOLDS,
    TIGHT,
    coordinate_row,
    left_gaping,
    miss_of_mode,
    next_mode,
    scale_of,
)
from engine.linkage.skyline import assemble, factorise, solve
from engine.linkage.springs import miss, tune
from engine.linkage.stalling import stall
from engine.linkage.throwing import throws
from engine.tables import Tables
from engine.tables.linkage import ELASTIC

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


def find_impulses(t: Tables, part: float) -> float:
    """Find the impulses at the start of a part (s) for which the constraints hold at its end;
    return how fast they failed it before (1/s). Where there are none, they hold to first order.
    """
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
    return failed


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
                if changes >= MOST_CHANGES or not stalls(t, part):
                    break
                changes += 1
                fresh = True
                continue
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


def stalls(t: Tables, part: float) -> bool:
    """Let a motor stall if one has to, and what holds against it hold to first order; return
    whether there was one.
    """
    if t.braces.sizes[6] == 0 or not stall(t, part, 0.5, False):
        return False
    renew(t, part)
    predict(t, part)
    find_misses(t, part)
    solve(t)
    return not take(t, 0.5, False, False)


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
        if take(t, 0.5, False, not last):
            renew(t, part)
            continue
        predict(t, part)
        find_misses(t, part)
        if last or not stalls(t, part):
            break
    return failed


def predict(t: Tables, part: float) -> None:
    """Set the values of all rows at the end of a part (s) to first order."""
    for row in range(t.braces.sizes[2]):
        rate = rate_of(t, 2 * row) + rate_of(t, 2 * row + 1)
        t.equations.value[row] = t.equations.start[row] + rate * part


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
                missed -= left_gaping(t, row)
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
