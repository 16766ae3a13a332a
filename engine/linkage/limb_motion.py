"""Trees of hinged bodies through a part of a tick: RATTLE (see `positions`), tree by tree."""

import math

from engine.linkage.limb_gaps import bend, measure_limbs
from engine.linkage.limb_guesses import expect_impulse
from engine.linkage.limb_impulses import (
    deliver_starts,
    forget_jolts,
    give_all,
    lend_all,
    read_means,
)
from engine.linkage.limb_sweeps import (
    aim_sweeps,
    expect_evenly,
    find_even,
    place_even,
)
from engine.linkage.limbs import (
    gather_masses,
    resolve,
    resolve_tree,
    solve_all,
    solve_tree,
    stand,
    stands,
)
from engine.linkage.modes import CLOSING
from engine.linkage.throwing import has_lost_pivot, is_livelier, note_energies, weigh_trees
from engine.tables import Tables

MOST_STEPS = 40
"""Steps of Newton's method that a part has at most,"""

FEW_STEPS = 8
"""and if it can be made shorter: what takes more is not to be trusted."""

TIGHT = 3e-9
"""Hinges hold to this share of the smaller body's reach."""

AT_ONCE = 1e-12
"""A guess is taken as it is if hinges gape by no more, in the same unit: guesses that are not
corrected lead to worse ones."""

CHORDS = 2
"""So many steps are taken with the matrix of the first; then each has its own."""

FAR = 2e-2
"""If hinges would gape by more at first, in reaches of the smaller body, the second step has a
matrix of its own, too: with that of the first it would hardly come closer."""

SURPRISED = 1e-3
"""If no hinge would gape by more at first, in the same unit, the solution is near what was expected
and throws nothing."""

SURE = 0.1
"""Share of the tolerance that a step is expected to miss by if it is not looked at again."""

LOOSE = 1e-3
"""A tree whose hinges would gape by more after all steps is lost, in reaches of the small body,"""

FIRM = 1e-6
"""and so it is, if the part can be made shorter, if they would by more than that,"""

UNTRIED = 1e300
"""What a tree missed by before its first step."""

FARTHEST = 1e100
"""No miss is larger."""

MOST_TURN = 0.35
"""or if a body would turn by more (rad): that may be another solution, bent the other way."""

MANY = 3
"""If one tree in so many needs a step, all take it, side by side."""

STRIDE = 0.25
"""Longest step, in the same unit."""

DONE, FORWARD, BACK = 0, 1, 2
"""What the next step of a tree does: none is needed; towards the goal; half the last one back."""


def brace_limbs(t: Tables, part: float) -> None:
    """Prepare the limbs for a part (s); let the impulses that are likely act.

    Where contacts act too, those are the impulses of the part before, spread over all of it: what
    contacts do is not smooth.
    """
    if t.bones.sizes[8] == 0:
        return
    if not stands(t):
        gather_masses(t)
        stand(t)
    t.bones.sizes[4] = 0
    t.bones.sizes[6] = 0
    for at in range(t.bones.sizes[9]):
        forget_jolts(t, t.bones.acting[at])
    find_even(t)
    place_even(t, part)
    for at in range(t.bones.sizes[8]):
        k = t.bones.acting[at]
        close_slowly(t, k, part)
        if t.trees.evenly[t.limbs.tree[k]] == 1:
            expect_evenly(t, k, part)
        else:
            expect_impulse(t, k, part)
    lend_all(t)
    if t.bones.sizes[7] > 0:  # contacts have to know; else bodies get it with what is still missing
        note_energies(t, part)
        deliver_starts(t)
        give_all(t)
        aim_sweeps(t, True)


def close_slowly(t: Tables, k: int, part: float) -> None:
    """Let a placed limb that was torn apart close in the part (s) no faster than all joints do."""
    limbs = t.limbs
    x = limbs.gap_x[k]
    y = limbs.gap_y[k]
    most = CLOSING * part
    square = (x * x + y * y) * limbs.scale[k]
    if square > most * most:
        share = most / math.sqrt(square)
        limbs.gap_x[k] = x * share
        limbs.gap_y[k] = y * share


def bind_limbs(t: Tables, part: float) -> float:
    """Make the hinges hold at the end of the part; return how fast they failed it before.

    That speed is in reaches of the smaller body a second (1/s).
    """
    if t.bones.sizes[8] == 0:
        return 0.0
    read_means(t)
    failed = 0.0
    final = t.progress.final[0] == 1
    found = False
    for step in range(MOST_STEPS if final else FEW_STEPS):
        bend(t)
        renewing = t.bones.sizes[6] == 0 or step >= CHORDS or failed > FAR * FAR
        measure_limbs(t, renewing)
        if step == 0:
            if expect_nothing_far(t):
                bend(t)
                measure_limbs(t, renewing)
            failed = note_first(t)
        going, alike, sure = choose_steps(t, renewing, AT_ONCE if step == 0 else TIGHT)
        found = going == 0
        if found:
            break
        if renewing:
            t.bones.sizes[6] = 1
        if alike:
            if renewing:
                resolve(t)
            solve_all(t)
            take_all(t)
        else:
            for at in range(t.bones.sizes[10]):
                tree = t.trees.acting[at]
                if renewing and t.trees.does[tree] == FORWARD:
                    resolve_tree(t, tree)
                step_tree(t, tree)
        found = sure
        if found:
            break
    far = failed > SURPRISED * SURPRISED
    if far:
        weigh_trees(t, part)
    t.bones.sizes[5] = withdraw_lost(t, final, found, far)
    lend_all(t)
    deliver_starts(t)
    return math.sqrt(failed) / part


def expect_nothing_far(t: Tables) -> bool:
    """Take back what was expected of trees that it leads further than the longest step; return
    whether there are any.

    What begins far from free flight may find another solution, bent the other way, with energy from
    nowhere.
    """
    limbs = t.limbs
    trees = t.trees
    far = False
    for i in range(t.bones.sizes[10]):
        tree = trees.acting[i]
        if trees.worst[tree] > STRIDE * STRIDE and trees.evenly[tree] == 0:
            first = trees.first[tree]
            for at in range(first, first + trees.limbs[tree]):
                k = limbs.member[at]
                if limbs.impulse_x[k] != 0.0 or limbs.impulse_y[k] != 0.0:
                    limbs.impulse_x[k] = 0.0
                    limbs.impulse_y[k] = 0.0
                    far = True
    if far:
        lend_all(t)
        if t.bones.sizes[7] > 0:
            deliver_starts(t)
            give_all(t)
            read_means(t)
    return far


def withdraw_lost(t: Tables, final: bool, found: bool, far: bool) -> int:
    """Let limbs of trees for which no good solution was found exert nothing; return how many there
    are.

    Their bodies fly on, which gains no energy; those that contacts hold, as sweeps left them.
    Unless that is `final`, they are tried again. `found`, hinges of all trees hold; some began
    `far` from that.
    """
    limbs = t.limbs
    bones = t.bones
    trees = t.trees
    lost = 0
    loose = FARTHEST if found else LOOSE if final else FIRM
    for at in range(0 if final else bones.sizes[9]):
        bone = bones.acting[at]
        if abs(bones.spin[bone] + bones.lent_spin[bone]) * bones.lasts[bone] > MOST_TURN:
            trees.does[bones.tree[bone]] = FORWARD
            trees.worst[bones.tree[bone]] = 2.0 * FARTHEST * FARTHEST
    for i in range(t.bones.sizes[10]):
        tree = trees.acting[i]
        failed = trees.does[tree] != DONE and not trees.worst[tree] <= loose * loose
        if far and trees.before[tree] < UNTRIED:
            failed = failed or has_lost_pivot(t, tree) or is_livelier(t, tree)
        if failed:
            lost += 1
            first = trees.first[tree]
            for at in range(first, first + trees.limbs[tree]):
                k = limbs.member[at]
                limbs.impulse_x[k] = limbs.given_x[k] if trees.evenly[tree] == 1 else 0.0
                limbs.impulse_y[k] = limbs.given_y[k] if trees.evenly[tree] == 1 else 0.0
    return lost


def note_first(t: Tables) -> float:
    """Begin to count steps; return the worst miss of all trees, squared."""
    trees = t.trees
    failed = 0.0
    for at in range(t.bones.sizes[10]):
        tree = trees.acting[at]
        trees.before[tree] = UNTRIED
        if trees.worst[tree] > failed:
            failed = trees.worst[tree]
    return failed


def choose_steps(t: Tables, renewing: bool, tight: float) -> tuple[int, bool, bool]:
    """Say what each tree does next, unless it misses by no more than `tight`; return how many go
    on, whether all are to do a whole step, and whether that is sure to be the last: what a step
    misses is nearly the product of this miss and the one for which the matrix was made.
    """
    trees = t.trees
    going = 0
    alike = True
    sure = True
    for at in range(t.bones.sizes[10]):
        tree = trees.acting[at]
        worst = trees.worst[tree]
        trees.share[tree] = 1.0
        if renewing:
            trees.made_for[tree] = worst
        if worst <= tight * tight:
            trees.does[tree] = DONE
            continue
        going += 1
        if worst > trees.before[tree]:
            trees.does[tree] = BACK
            alike = False
            sure = False
            continue
        made_for = trees.made_for[tree] if trees.made_for[tree] > worst else worst
        sure = sure and worst * made_for <= SURE * SURE * TIGHT * TIGHT
        trees.before[tree] = worst
        trees.does[tree] = FORWARD
        if worst > STRIDE * STRIDE:
            trees.share[tree] = STRIDE / math.sqrt(worst)
            alike = False
    return going, alike and MANY * going >= t.bones.sizes[10], sure


def take_all(t: Tables) -> None:
    """Take the steps that were found."""
    bones = t.bones
    limbs = t.limbs
    for bone in range(bones.sizes[1]):  # side by side; what does not act is not read
        bones.lent_x[bone] += bones.step_x[bone]
        bones.lent_y[bone] += bones.step_y[bone]
        bones.lent_spin[bone] += bones.step_spin[bone]
    for at in range(bones.sizes[8]):
        k = bones.acting[at]
        limbs.impulse_x[k] += limbs.answer_x[k]
        limbs.impulse_y[k] += limbs.answer_y[k]


def step_tree(t: Tables, tree: int) -> None:
    """Take the next step of one tree."""
    limbs = t.limbs
    trees = t.trees
    if trees.does[tree] == DONE:
        return
    first = trees.first[tree]
    share = trees.share[tree]
    if trees.does[tree] == FORWARD:
        for at in range(first, first + trees.limbs[tree]):
            k = limbs.member[at]
            limbs.rate_x[k] *= share
            limbs.rate_y[k] *= share
        solve_tree(t, tree)
    for at in range(first, first + trees.limbs[tree]):
        k = limbs.member[at]
        step_bone(t, k, trees.does[tree] == BACK)
        step_limb(t, k, trees.does[tree] == BACK)
    if trees.root[tree] >= 0:
        step_bone(t, trees.root[tree], trees.does[tree] == BACK)


def step_bone(t: Tables, bone: int, back: bool) -> None:
    """Take the step of a bone, or half the last one back."""
    bones = t.bones
    if back:
        bones.step_x[bone] *= -0.5
        bones.step_y[bone] *= -0.5
        bones.step_spin[bone] *= -0.5
    bones.lent_x[bone] += bones.step_x[bone]
    bones.lent_y[bone] += bones.step_y[bone]
    bones.lent_spin[bone] += bones.step_spin[bone]
    if back:
        bones.step_x[bone] = -bones.step_x[bone]
        bones.step_y[bone] = -bones.step_y[bone]
        bones.step_spin[bone] = -bones.step_spin[bone]


def step_limb(t: Tables, k: int, back: bool) -> None:
    """The same for the impulse of a limb."""
    limbs = t.limbs
    if back:
        limbs.answer_x[k] /= 2.0
        limbs.answer_y[k] /= 2.0
        limbs.impulse_x[k] -= limbs.answer_x[k]
        limbs.impulse_y[k] -= limbs.answer_y[k]
    else:
        limbs.impulse_x[k] += limbs.answer_x[k]
        limbs.impulse_y[k] += limbs.answer_y[k]
