"""Trees of hinged bodies at the end of each part: the impulses for which velocities obey hinges."""

from engine.linkage.limb_impulses import (
    add_up_limb,
    deliver_ends,
    deliver_starts,
    lend_all,
    read_ends,
    read_present,
)
from engine.linkage.limb_motion import step_limb
from engine.linkage.limb_sweeps import aim_sweeps
from engine.linkage.limbs import find_worst, resolve, resolve_tree, solve_all, solve_tree, stand
from engine.linkage.moments import book_tree
from engine.tables import Tables

STILL = 1e-12
"""Hinges that open no faster are at rest, in reaches of the smaller body a second (1/s)."""


def prepare_limbs(t: Tables) -> None:
    """Prepare the limbs for the end of a part, where their bodies are now."""
    if t.bones.sizes[8] == 0:
        return
    stand(t)
    t.bones.sizes[4] = 1
    limbs = t.limbs
    for at in range(t.bones.sizes[8]):
        k = t.bones.acting[at]
        limbs.impulse_x[k] = 0.0
        limbs.impulse_y[k] = 0.0
        limbs.given_x[k] = 0.0
        limbs.given_y[k] = 0.0
    if t.bones.sizes[7] > 0:
        aim_sweeps(t, False)


def ease_limbs(t: Tables, at_once: bool) -> None:
    """Make velocities at the end of the part obey the hinges: those that bodies have, `at_once`, or
    those that contacts, too, are about to give them.
    """
    if t.bones.sizes[8] == 0:
        return
    if at_once:
        read_present(t)
    else:
        read_ends(t)
    find_hinge_rates(t)
    going = 0
    for at in range(t.bones.sizes[10]):
        going += is_going(t, t.trees.acting[at])
    if going == 0:
        return
    if going == t.bones.sizes[10]:
        resolve(t)
        solve_all(t)
        for at in range(t.bones.sizes[8]):
            k = t.bones.acting[at]
            t.limbs.impulse_x[k] += t.limbs.answer_x[k]
            t.limbs.impulse_y[k] += t.limbs.answer_y[k]
    else:
        for at in range(t.bones.sizes[10]):
            tree = t.trees.acting[at]
            if is_going(t, tree):
                ease_tree(t, tree)
    lend_all(t)
    if at_once:
        deliver_starts(t)
    else:
        deliver_ends(t)


def is_going(t: Tables, tree: int) -> bool:
    """Whether velocities of a tree, whose misses are known, are to obey its hinges and do not."""
    return t.trees.owes[tree] == 0 and t.trees.worst[tree] > STILL * STILL


def ease_tree(t: Tables, tree: int) -> None:
    """Find the impulses of one tree."""
    resolve_tree(t, tree)
    solve_tree(t, tree)
    first = t.trees.first[tree]
    for at in range(first, first + t.trees.limbs[tree]):
        step_limb(t, t.limbs.member[at], False)


def find_hinge_rates(t: Tables) -> None:
    """Want all hinges to open no more; note of each tree the fastest, in sizes of joints a second,
    squared.
    """
    bones = t.bones
    limbs = t.limbs
    for run in range(bones.sizes[12]):
        lead = bones.run_lead[run]
        for k in range(bones.run_first[run], bones.run_end[run]):
            find_hinge_rate(t, k, k + lead)
            x = limbs.rate_x[k]
            y = limbs.rate_y[k]
            limbs.miss[k] = (x * x + y * y) * limbs.scale[k]
    find_worst(t)


def find_hinge_rate(t: Tables, k: int, parent: int) -> None:
    """Want a hinge to open no more."""
    bones = t.bones
    limbs = t.limbs
    limbs.rate_x[k] = (bones.vx[parent] - bones.spin[parent] * limbs.lever_y[k]) - (
        bones.vx[k] - bones.spin[k] * limbs.arm_y[k]
    )
    limbs.rate_y[k] = (bones.vy[parent] + bones.spin[parent] * limbs.lever_x[k]) - (
        bones.vy[k] + bones.spin[k] * limbs.arm_x[k]
    )


def keep_limb_ends(t: Tables, part: float, done: float, steady: bool) -> None:
    """Note what the limbs exert at the end of a part (s), of which the share `done` has passed.

    In a steady part, impulses that stop what still moves are no loads that last.
    """
    joints = t.joints
    limbs = t.limbs
    for at in range(t.bones.sizes[8]):
        k = t.bones.acting[at]
        joint = limbs.joint[k]
        if t.trees.owes[limbs.tree[k]] == 1:
            continue
        add_up_limb(t, k)
        x = limbs.sign[k] * limbs.impulse_x[k]
        y = limbs.sign[k] * limbs.impulse_y[k]
        if t.trees.evenly[limbs.tree[k]] == 1:
            last = 0.0 if steady or done < 1.0 else 1.0
            joints.end_0[joint] = (joints.impulse_0[joint] + last * x) / part
            joints.end_1[joint] = (joints.impulse_1[joint] + last * y) / part
            continue
        if done < 1.0:
            x = joints.impulse_0[joint]
            y = joints.impulse_1[joint]
        joints.end_0[joint] = 2.0 * x / part
        joints.end_1[joint] = 2.0 * y / part
    for at in range(t.bones.sizes[10]):
        if t.trees.owes[t.trees.acting[at]] == 0:
            book_tree(t, t.trees.acting[at])
