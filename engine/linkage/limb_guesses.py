"""What the hinges of trees will exert at the start of a part of a tick, and what they did.

That is nearly what they exerted, at the same instant, at the end of the part before, and differs
from it as it did in the two parts before; what is still owed follows from how forces grow (see
`owing`). Guessed that way, one or two steps of Newton's method are enough where motion is smooth.
"""

from engine.linkage.limb_impulses import add_up_limb
from engine.linkage.limb_sweeps import keep_evenly
from engine.linkage.moments import book_tree
from engine.tables import Tables

JUMP = 0.3
"""A force of which a larger share differs between the end of a part and the start of the next does
so because of contacts, and will again; smaller differences change as they did before."""


def expect_impulse(t: Tables, k: int, part: float) -> None:
    """Set what a limb will exert at the start of the part (s), judging by the parts before.

    If that was done at the end of the last one, the two differ as they did before: what changed of
    the difference changes again. What is still owed comes to it: the force goes on to grow.
    """
    limbs = t.limbs
    joints = t.joints
    joint = limbs.joint[k]
    owed = owed_by(t, k)
    limbs.given_x[k] = 0.0
    limbs.given_y[k] = 0.0
    half = limbs.sign[k] * (part + owed) / 2.0
    if owed > 0.0:
        before = joints.part[joint]
        limbs.impulse_x[k] = half * (joints.mean_0[joint] + before * joints.rise_0[joint])
        limbs.impulse_y[k] = half * (joints.mean_1[joint] + before * joints.rise_1[joint])
        return
    share = joints.since[joint] / joints.spacing[joint] if joints.spacing[joint] > 0.0 else 0.0
    lag_x = joints.lag_0[joint] + (joints.lag_0[joint] - joints.older_0[joint]) * share
    lag_y = joints.lag_1[joint] + (joints.lag_1[joint] - joints.older_1[joint]) * share
    limbs.impulse_x[k] = half * (joints.end_0[joint] + part * lag_x)
    limbs.impulse_y[k] = half * (joints.end_1[joint] + part * lag_y)


def owed_by(t: Tables, k: int) -> float:
    """Length of the part (s) at whose end the tree of a limb owes what it exerts; else 0."""
    return t.progress.owed[0] if t.trees.owes[t.limbs.tree[k]] == 1 else 0.0


def keep_limb_impulses(t: Tables, part: float) -> None:
    """Note what the limbs exert at the start of the part (s), or all through it."""
    joints = t.joints
    limbs = t.limbs
    for at in range(t.bones.sizes[8]):
        k = t.bones.acting[at]
        joint = limbs.joint[k]
        if t.trees.evenly[limbs.tree[k]] == 1:
            keep_evenly(t, k)
            continue
        add_up_limb(t, k)
        x = limbs.sign[k] * limbs.impulse_x[k]
        y = limbs.sign[k] * limbs.impulse_y[k]
        joints.impulse_0[joint] = x
        joints.impulse_1[joint] = y
        owed = owed_by(t, k)
        per = 2.0 / (part + owed)
        x *= per
        y *= per
        if owed > 0.0:
            joints.end_0[joint] = x
            joints.end_1[joint] = y
        else:
            keep_lag(t, joint, x - joints.end_0[joint], y - joints.end_1[joint], part, x, y)
            x = (x + joints.end_0[joint]) / 2.0
            y = (y + joints.end_1[joint]) / 2.0
        before = joints.part[joint]
        often = 1.0 / before if before > 0.0 else 0.0
        joints.rise_0[joint] = (x - joints.mean_0[joint]) * often
        joints.rise_1[joint] = (y - joints.mean_1[joint]) * often
        joints.mean_0[joint] = x
        joints.mean_1[joint] = y
        joints.part[joint] = part
        joints.since[joint] += part
    for at in range(t.bones.sizes[10]):
        if t.trees.evenly[t.trees.acting[at]] == 0:
            book_tree(t, t.trees.acting[at])


def keep_lag(
    t: Tables, joint: int, more_x: float, more_y: float, part: float, x: float, y: float
) -> None:
    """Note by how much more (N) a hinge exerts at the start of a part (s), of a force (N)."""
    joints = t.joints
    lag_x = more_x / part
    lag_y = more_y / part
    jump = JUMP * JUMP * (x * x + y * y) / (part * part)
    smooth = lag_x * lag_x + lag_y * lag_y <= jump
    joints.older_0[joint] = joints.lag_0[joint] if smooth else lag_x
    joints.older_1[joint] = joints.lag_1[joint] if smooth else lag_y
    joints.lag_0[joint] = lag_x
    joints.lag_1[joint] = lag_y
    joints.spacing[joint] = joints.since[joint]
    joints.since[joint] = 0.0
