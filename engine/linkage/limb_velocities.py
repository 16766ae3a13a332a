"""Trees of hinged bodies at the end of each part: the impulses for which velocities obey hinges."""

import math

from engine.linkage.limb_impulses import add_up_limb, deliver_ends, lend_all, read_ends
from engine.linkage.limb_motion import step_limb
from engine.linkage.limbs import resolve, solve_all, solve_tree, stand
from engine.tables import Tables

STILL = 1e-12
"""Hinges that open no faster are at rest, in reaches of the smaller body a second (1/s)."""


def prepare_limbs(t: Tables, part: float) -> None:
    """Prepare the limbs for the end of a part, where their bodies are now.

    Where contacts are to agree with them, let act what they exerted at the end of the part before;
    else the solution alone is exact.
    """
    if t.bones.sizes[0] == 0:
        return
    stand(t)
    resolve(t)
    t.bones.sizes[4] = 1
    limbs = t.limbs
    half = part / 2.0
    for k in range(t.bones.sizes[0]):
        joint = limbs.joint[k]
        limbs.impulse_x[k] = limbs.sign[k] * half * t.joints.end_0[joint]
        limbs.impulse_y[k] = limbs.sign[k] * half * t.joints.end_1[joint]
        limbs.given_x[k] = 0.0
        limbs.given_y[k] = 0.0
    if part > 0.0:
        lend_all(t)
        deliver_ends(t)


def ease_limbs(t: Tables) -> float:
    """Make velocities obey the hinges; return how fast they did not before (1/s)."""
    if t.bones.sizes[0] == 0:
        return 0.0
    read_ends(t)
    failed = find_hinge_rates(t)
    going = 0
    for tree in range(t.bones.sizes[3]):
        if t.trees.worst[tree] > STILL * STILL:
            going += 1
    if going == 0:
        return math.sqrt(failed)
    if going == t.bones.sizes[3]:
        solve_all(t)
        for k in range(t.bones.sizes[0]):
            t.limbs.impulse_x[k] += t.limbs.answer_x[k]
            t.limbs.impulse_y[k] += t.limbs.answer_y[k]
    else:
        for tree in range(t.bones.sizes[3]):
            if t.trees.worst[tree] > STILL * STILL:
                ease_tree(t, tree)
    lend_all(t)
    deliver_ends(t)
    return math.sqrt(failed)


def ease_tree(t: Tables, tree: int) -> None:
    """Find the impulses of one tree."""
    solve_tree(t, tree)
    first = t.trees.first[tree]
    for at in range(first, first + t.trees.limbs[tree]):
        step_limb(t, t.limbs.member[at], False)


def find_hinge_rates(t: Tables) -> float:
    """Want all hinges to open no more; return the fastest, in sizes of joints a second, squared."""
    limbs = t.limbs
    worst = t.trees.worst
    for tree in range(t.bones.sizes[3]):
        worst[tree] = 0.0
    for k in range(t.bones.sizes[0]):
        find_hinge_rate(t, k)
        tree = limbs.tree[k]
        x = limbs.rate_x[k]
        y = limbs.rate_y[k]
        size = (x * x + y * y) * limbs.scale[k]
        if size > worst[tree]:
            worst[tree] = size
    fastest = 0.0
    for tree in range(t.bones.sizes[3]):
        if worst[tree] > fastest:
            fastest = worst[tree]
    return fastest


def find_hinge_rate(t: Tables, k: int) -> None:
    """Want a hinge to open no more."""
    bones = t.bones
    limbs = t.limbs
    parent = limbs.parent[k]
    limbs.rate_x[k] = (bones.vx[parent] - bones.spin[parent] * limbs.lever_y[k]) - (
        bones.vx[k] - bones.spin[k] * limbs.arm_y[k]
    )
    limbs.rate_y[k] = (bones.vy[parent] + bones.spin[parent] * limbs.lever_x[k]) - (
        bones.vy[k] + bones.spin[k] * limbs.arm_x[k]
    )


def keep_limb_ends(t: Tables, part: float, done: float) -> None:
    """Note what the limbs exert at the end of a part (s), of which the share `done` has passed."""
    joints = t.joints
    limbs = t.limbs
    for k in range(t.bones.sizes[0]):
        joint = limbs.joint[k]
        add_up_limb(t, k)
        x = limbs.sign[k] * limbs.impulse_x[k]
        y = limbs.sign[k] * limbs.impulse_y[k]
        if done < 1.0:
            x = joints.impulse_0[joint]
            y = joints.impulse_1[joint]
        joints.end_0[joint] = 2.0 * x / part
        joints.end_1[joint] = 2.0 * y / part
