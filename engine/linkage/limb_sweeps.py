"""Trees of hinges on which contacts act: hinges and contacts are swept as one system.

Contacts act evenly all through a part of a tick. So do the hinges of bodies that they hold, at
where the bodies are in the middle of the part: velocities obey them all the way, and no hinge
presses bodies together that contacts part again. Each sweep solves one hinge after the other as if
nothing else held its two bodies, then one contact after the other (sequential impulses: Erin Catto,
"Modeling and solving constraints", 2009), from the impulses of the part before. What sweeps leave
of the error of hinges is taken by an exact solution (`limb_motion`, `limb_velocities`).
"""

from engine.kernels.halting import book_shift_by_ground
from engine.kernels.moments import book_lost
from engine.kernels.sweeps import QUIET, STIRRED, WILD, WILDLY, sweep
from engine.linkage.jolts import jolt
from engine.linkage.limb_impulses import (
    deliver_starts,
    forget_jolts,
    give_all,
    lend_all,
    read_held,
)
from engine.linkage.limbs import gather_masses, note_torn, place_limb, set_pose, turn_all
from engine.linkage.moments import book_even_limb, give_outside, turn_of_both
from engine.linkage.pace import SHORTEST
from engine.tables import Tables


def find_even(t: Tables) -> int:
    """Note and count the trees of hinges on which contacts act: those with a body that is held by
    more than its joints.
    """
    bones = t.bones
    evenly = t.trees.evenly
    for tree in range(bones.sizes[3]):
        evenly[tree] = 0
    found = 0
    for at in range(bones.sizes[9]):
        bone = bones.acting[at]
        if t.bodies.held[bones.body[bone]] > 1 and evenly[bones.tree[bone]] == 0:
            evenly[bones.tree[bone]] = 1
            found += 1
    bones.sizes[7] = found
    return found


def place_even(t: Tables, part: float) -> None:
    """Place trees on which contacts act where their bodies are in the middle of a part (s)."""
    bones = t.bones
    bodies = t.bodies
    half = part / 2.0
    for at in range(bones.sizes[11]):
        bone = bones.acting[at]
        row = bones.body[bone]
        bones.lasts[bone] = part
        if t.trees.evenly[bones.tree[bone]] == 1:
            bones.lasts[bone] = half
            if row >= 0:
                x = bodies.x[row] + half * bodies.vx[row]
                y = bodies.y[row] + half * bodies.vy[row]
                set_pose(t, bone, x, y, bodies.angle[row] + half * bodies.spin[row])
    if bones.sizes[7] > 0:
        turn_all(t)
    for at in range(bones.sizes[8]):
        k = bones.acting[at]
        if t.trees.evenly[t.limbs.tree[k]] == 1:
            place_limb(t, k, t.limbs.parent[k])
            note_torn(t, k)


def expect_evenly(t: Tables, k: int, part: float) -> None:
    """Expect of a limb the force of the part before, all through the part (s), but no larger
    impulse if that was much shorter: what stopped a motion at once is no load that lasts.
    """
    joint = t.limbs.joint[k]
    before = t.joints.part[joint]
    share = t.limbs.sign[k] * (part if part * SHORTEST <= before else before)
    t.joints.part[joint] = part
    t.limbs.impulse_x[k] = share * t.joints.end_0[joint]
    t.limbs.impulse_y[k] = share * t.joints.end_1[joint]
    t.limbs.given_x[k] = 0.0
    t.limbs.given_y[k] = 0.0


def bear_evenly(t: Tables, part: float) -> None:
    """Let hinges bear the forces of a steady part (s) like in the part before, if there are any;
    all of them are of trees on which contacts act, and kicks are what forces and contacts do.
    """
    if t.bones.sizes[8] == 0:
        return
    t.bones.sizes[4] = 0
    gather_masses(t)
    for at in range(t.bones.sizes[9]):
        forget_jolts(t, t.bones.acting[at])
    place_even(t, part)
    for at in range(t.bones.sizes[8]):
        expect_evenly(t, t.bones.acting[at], part)
    lend_all(t)
    deliver_starts(t)
    give_all(t)
    aim_sweeps(t, False)


def aim_sweeps(t: Tables, closing: bool) -> None:
    """Ready the placed limbs of trees on which contacts act for sweeps: what opens is to stop, or,
    `closing`, to have closed at the end of the part.
    """
    bones = t.bones
    limbs = t.limbs
    read_held(t)
    for at in range(bones.sizes[8]):
        k = bones.acting[at]
        if t.trees.evenly[limbs.tree[k]] == 1:
            limbs.goal_x[k] = -limbs.gap_x[k] / bones.lasts[k] if closing else 0.0
            limbs.goal_y[k] = -limbs.gap_y[k] / bones.lasts[k] if closing else 0.0
            grip(t, k)


def grip(t: Tables, k: int) -> None:
    """Find what resists the motion of a placed hinge as if no other held its two bodies."""
    bones = t.bones
    limbs = t.limbs
    parent = limbs.parent[k]
    x = limbs.arm_x[k]
    y = limbs.arm_y[k]
    turn = bones.inverse_inertia[k]
    mass = bones.inverse_mass[k]
    xx = mass + turn * y * y
    yy = mass + turn * x * x
    xy = -turn * x * y
    x = limbs.lever_x[k]
    y = limbs.lever_y[k]
    turn = bones.inverse_inertia[parent]
    mass = bones.inverse_mass[parent]
    xx += mass + turn * y * y
    yy += mass + turn * x * x
    xy -= turn * x * y
    scale = xx * yy - xy * xy
    scale = 1.0 / scale if scale > 0.0 else 0.0
    limbs.grip_xx[k] = yy * scale
    limbs.grip_xy[k] = -xy * scale
    limbs.grip_yy[k] = xx * scale


def sweep_all(t: Tables, resting: int, calm: float, backwards: bool) -> int:
    """Solve each hinge of a tree on which contacts act once, then each resting pair.

    Returns how velocities changed, as `sweep` does, which also says what the arguments are.
    """
    moved = QUIET
    if t.bones.sizes[7] > 0:
        moved = sweep_limbs(t, calm, backwards)
    found = sweep(t, resting, calm, backwards)
    return moved if moved > found else found


def sweep_limbs(t: Tables, calm: float, backwards: bool) -> int:
    """Solve each hinge of a tree on which contacts act once; sweeps go to and fro in turn."""
    found = QUIET
    for at in range(t.bones.sizes[10]):
        tree = t.trees.acting[at]
        if t.trees.evenly[tree] == 1:
            moved = sweep_tree(t, tree, calm, backwards)
            if moved > found:
                found = moved
    return found


def sweep_tree(t: Tables, tree: int, calm: float, backwards: bool) -> int:
    """Solve each hinge of a tree once, from the tips to the root or `backwards`.

    Returns whether one moved faster than `calm` (sizes of joints a second): `QUIET`, `STIRRED` or
    `WILD`.
    """
    bones = t.bones
    limbs = t.limbs
    bodies = t.bodies
    kick_x = bodies.kick_x
    kick_y = bodies.kick_y
    kick_spin = bodies.kick_spin
    movable = bones.sizes[1]
    worst = 0.0
    count = t.trees.limbs[tree]
    at = t.trees.first[tree] + (count if backwards else -1)
    onwards = -1 if backwards else 1
    for _ in range(count):
        at += onwards
        k = limbs.member[at]
        parent = limbs.parent[k]
        child_row = bones.body[k]
        parent_row = bones.body[parent]
        arm_x = limbs.arm_x[k]
        arm_y = limbs.arm_y[k]
        lever_x = limbs.lever_x[k]
        lever_y = limbs.lever_y[k]
        spin = kick_spin[child_row]
        x = limbs.goal_x[k] - kick_x[child_row] + spin * arm_y
        y = limbs.goal_y[k] - kick_y[child_row] - spin * arm_x
        if parent < movable:
            spin = kick_spin[parent_row]
            x += kick_x[parent_row] - spin * lever_y
            y += kick_y[parent_row] + spin * lever_x
        else:
            spin = bones.spin[parent]
            x += bones.vx[parent] - spin * lever_y
            y += bones.vy[parent] + spin * lever_x
        size = (x * x + y * y) * limbs.scale[k]
        if size > worst:
            worst = size
        push_x = limbs.grip_xx[k] * x + limbs.grip_xy[k] * y
        push_y = limbs.grip_xy[k] * x + limbs.grip_yy[k] * y
        limbs.impulse_x[k] += push_x
        limbs.impulse_y[k] += push_y
        limbs.given_x[k] = limbs.impulse_x[k]
        limbs.given_y[k] = limbs.impulse_y[k]
        kick_x[child_row] += bones.inverse_mass[k] * push_x
        kick_y[child_row] += bones.inverse_mass[k] * push_y
        kick_spin[child_row] += bones.inverse_inertia[k] * (arm_x * push_y - arm_y * push_x)
        if parent < movable:
            kick_x[parent_row] -= bones.inverse_mass[parent] * push_x
            kick_y[parent_row] -= bones.inverse_mass[parent] * push_y
            turn = lever_x * push_y - lever_y * push_x
            kick_spin[parent_row] -= bones.inverse_inertia[parent] * turn
    if worst > WILDLY * WILDLY:
        return WILD
    return STIRRED if worst > calm * calm else QUIET


def keep_evenly(t: Tables, k: int) -> None:
    """Note what a limb exerts all through the part: its impulse, and how that turns both bones."""
    limbs = t.limbs
    joint = limbs.joint[k]
    x = limbs.impulse_x[k]
    y = limbs.impulse_y[k]
    limbs.turn[k] = limbs.arm_x[k] * y - limbs.arm_y[k] * x
    limbs.counter[k] = limbs.lever_x[k] * y - limbs.lever_y[k] * x
    limbs.both[k] = turn_of_both(t, k, x, y)
    t.joints.impulse_0[joint] = limbs.sign[k] * x
    t.joints.impulse_1[joint] = limbs.sign[k] * y
    t.joints.lag_0[joint] = t.joints.lag_1[joint] = 0.0
    t.joints.older_0[joint] = t.joints.older_1[joint] = 0.0


def keep_loads(t: Tables, part: float) -> None:
    """Note the loads of all hinges in a steady part (s): the next one starts from them."""
    joints = t.joints
    limbs = t.limbs
    for at in range(t.bones.sizes[8]):
        k = t.bones.acting[at]
        joint = limbs.joint[k]
        joints.end_0[joint] = limbs.sign[k] * limbs.impulse_x[k] / part
        joints.end_1[joint] = limbs.sign[k] * limbs.impulse_y[k] / part


def book_even(t: Tables, share: float, lasted: float) -> None:
    """Book, and add to the sums of the tick, a share of what hinges did all through the part, which
    lasted so long (s), given at mean velocities of bodies.
    """
    if t.bones.sizes[7] == 0:
        return
    bones = t.bones
    bodies = t.bodies
    limbs = t.limbs
    work = 0.0
    outside = give_outside(t)
    for at in range(bones.sizes[8]):
        k = bones.acting[at]
        if t.trees.evenly[limbs.tree[k]] == 1:
            joint = limbs.joint[k]
            t.joints.sum_x[joint] += share * t.joints.impulse_0[joint]
            t.joints.sum_y[joint] += share * t.joints.impulse_1[joint]
            x = limbs.sign[k] * t.joints.impulse_0[joint]
            y = limbs.sign[k] * t.joints.impulse_1[joint]
            row = bones.body[k]
            work += x * bodies.mean_x[row] + y * bodies.mean_y[row]
            work += limbs.turn[k] * bodies.mean_spin[row]
            parent = limbs.parent[k]
            row = bones.body[parent]
            if parent < bones.sizes[1]:
                work -= x * bodies.mean_x[row] + y * bodies.mean_y[row]
                work -= limbs.counter[k] * bodies.mean_spin[row]
            else:
                t.books.joint_x[0] += x * share
                t.books.joint_y[0] += y * share
            if outside or limbs.both[k] != 0.0:
                book_even_limb(t, k, x * share, y * share, share, lasted)
    t.books.joint_work[0] += work * share


def turn_limbs_by_shift(t: Tables, done: float) -> None:
    """Correct the torques of hinges whose bodies did not go their planned paths, like those of
    contacts; `done` is the share of their impulses that was given.
    """
    if t.bones.sizes[7] == 0:
        return
    bones = t.bones
    bodies = t.bodies
    limbs = t.limbs
    for at in range(bones.sizes[8]):
        k = bones.acting[at]
        if t.trees.evenly[limbs.tree[k]] == 1:
            row = bones.body[k]
            x = bodies.shift_x[row]
            y = bodies.shift_y[row]
            parent = limbs.parent[k]
            if parent < bones.sizes[1]:
                x -= bodies.shift_x[bones.body[parent]]
                y -= bodies.shift_y[bones.body[parent]]
            if x != 0.0 or y != 0.0:
                joint = limbs.joint[k]
                turn = x * t.joints.impulse_1[joint] - y * t.joints.impulse_0[joint]
                turn *= done * limbs.sign[k]
                if parent < bones.sizes[1]:
                    book_shift_by_ground(t, row, bones.body[parent], turn)
                    turn /= 2.0
                    jolt(t, bones.body[parent], 0.0, 0.0, -turn * bones.inverse_inertia[parent])
                    book_lost(t, bones.body[parent], -turn)
                jolt(t, row, 0.0, 0.0, -turn * bones.inverse_inertia[k])
                book_lost(t, row, -turn)
