"""Trees of hinged bodies at the instant in which something strikes one of them."""

from engine.linkage.jolts import jolt_at
from engine.linkage.limb_impulses import add_up_limb, lend_limb, lend_nothing
from engine.linkage.limb_velocities import find_hinge_rate
from engine.linkage.limbs import (
    bear,
    eliminate,
    gather_mass,
    load_alone,
    note_torn,
    place_bone,
    place_limb,
    solve_tree,
)
from engine.linkage.moments import book_tree
from engine.tables import Bodies, Tables


def tree_at(t: Tables, row: int) -> int:
    """Row in `Trees` of the tree that a body belongs to; -1: none."""
    bone = t.bodies.bone[row] - 1
    return t.bones.tree[bone] if bone >= 0 else -1


def place_tree(t: Tables, tree: int, time: float) -> None:
    """Resolve a tree for where its bodies are at `time` of the part (s)."""
    t.bones.sizes[4] = 0
    limbs = t.limbs
    first = t.trees.first[tree]
    end = first + t.trees.limbs[tree]
    place_in_flight(t, limbs.parent[limbs.member[end - 1]], time)
    for at in range(first, end):
        place_in_flight(t, limbs.member[at], time)
    for at in range(first, end):
        k = limbs.member[at]
        place_limb(t, k, limbs.parent[k])
        note_torn(t, k)
        eliminate(t, k, k + 1)
        bear(t, k, limbs.parent[k])


def heaviest_of_tree(t: Tables, tree: int) -> float:
    """Mass of the heaviest body of a tree (kg), of those that forces move."""
    bones = t.bones
    root = t.trees.root[tree]
    heaviest = bones.mass[root] if root >= 0 and bones.inverse_mass[root] > 0.0 else 0.0
    first = t.trees.first[tree]
    for at in range(first, first + t.trees.limbs[tree]):
        bone = t.limbs.member[at]
        if bones.inverse_mass[bone] > 0.0 and bones.mass[bone] > heaviest:
            heaviest = bones.mass[bone]
    return heaviest


def place_in_flight(t: Tables, bone: int, time: float) -> None:
    """Place a bone where its body is at `time` of the part (s); it bears nothing else."""
    row = t.bones.body[bone]
    if row < 0:
        place_bone(t, bone, 0.0, 0.0, 0.0)
    else:
        gather_mass(t, bone)
        x, y, angle = pose_in_flight(t.bodies, row, time)
        place_bone(t, bone, x, y, angle)
    load_alone(t, bone)
    t.bones.sway[bone] = 0.0


def pose_in_flight(bodies: Bodies, row: int, time: float) -> tuple[float, float, float]:
    """Where a body is (m, m, rad) at `time` of the part (s)."""
    passed = time - bodies.clock[row]
    half = passed * passed / 2.0
    x = bodies.x[row] + bodies.vx[row] * passed
    y = bodies.y[row] + bodies.vy[row] * passed
    angle = bodies.angle[row] + bodies.spin[row] * passed
    if bodies.inverse_mass[row] > 0.0:
        x += bodies.path_x[row] * half
        y += bodies.path_y[row] * half
        angle += bodies.path_spin[row] * half
    return x, y, angle


def jolt_tree(t: Tables, tree: int) -> None:
    """Let the hinges of a placed tree answer to the velocities of its bones; sum what they exert.

    What they change the velocities by is lent to the bones.
    """
    limbs = t.limbs
    first = t.trees.first[tree]
    end = first + t.trees.limbs[tree]
    for at in range(first, end):
        k = limbs.member[at]
        find_hinge_rate(t, k, limbs.parent[k])
    solve_tree(t, tree)
    lend_nothing(t, limbs.parent[limbs.member[end - 1]])
    for at in range(first, end):
        lend_nothing(t, limbs.member[at])
    for at in range(first, end):
        k = limbs.member[at]
        limbs.impulse_x[k] = limbs.answer_x[k]
        limbs.impulse_y[k] = limbs.answer_y[k]
        limbs.given_x[k] = 0.0
        limbs.given_y[k] = 0.0
        lend_limb(t, k)


def still_tree(t: Tables, tree: int) -> None:
    """Let no bone of a tree move."""
    limbs = t.limbs
    first = t.trees.first[tree]
    end = first + t.trees.limbs[tree]
    still_bone(t, limbs.parent[limbs.member[end - 1]])
    for at in range(first, end):
        still_bone(t, limbs.member[at])


def still_bone(t: Tables, bone: int) -> None:
    """Let a bone not move."""
    t.bones.vx[bone] = 0.0
    t.bones.vy[bone] = 0.0
    t.bones.spin[bone] = 0.0


def answer_of_tree(
    t: Tables, tree: int, a: int, b: int, change: tuple[float, float, float, float, float, float]
) -> tuple[float, float, float, float, float, float]:
    """How velocities of a and b change in all if impulses alone would change them so.

    Args:
        t: the tables.
        tree: which tree, placed.
        a: row of a body.
        b: another one.
        change: of the velocity and spin of a, then of b (m/s, rad/s).
    """
    still_tree(t, tree)
    bones = t.bones
    of_a = note_change(t, tree, a, change[0], change[1], change[2])
    of_b = note_change(t, tree, b, change[3], change[4], change[5])
    jolt_tree(t, tree)
    ax = ay = a_spin = bx = by = b_spin = 0.0
    if of_a >= 0:
        ax = bones.lent_x[of_a]
        ay = bones.lent_y[of_a]
        a_spin = bones.lent_spin[of_a]
    if of_b >= 0:
        bx = bones.lent_x[of_b]
        by = bones.lent_y[of_b]
        b_spin = bones.lent_spin[of_b]
    return (
        change[0] + ax,
        change[1] + ay,
        change[2] + a_spin,
        change[3] + bx,
        change[4] + by,
        change[5] + b_spin,
    )


def commit_tree(t: Tables, tree: int, time: float) -> None:
    """Let the bodies of a tree have, at `time` of the part (s), what its hinges last answered."""
    limbs = t.limbs
    first = t.trees.first[tree]
    book_tree(t, tree)
    for at in range(first, first + t.trees.limbs[tree]):
        k = limbs.member[at]
        add_up_limb(t, k)
        jolt_bone(t, k, time)
    if t.trees.root[tree] >= 0:
        jolt_bone(t, t.trees.root[tree], time)


def note_change(t: Tables, tree: int, row: int, vx: float, vy: float, spin: float) -> int:
    """Write the change of a body's velocity (m/s, rad/s) to its bone; return it, -1 if that is not
    of the tree.
    """
    bone = t.bodies.bone[row] - 1
    if bone < 0 or t.bones.tree[bone] != tree:
        return -1
    t.bones.vx[bone] = vx
    t.bones.vy[bone] = vy
    t.bones.spin[bone] = spin
    return bone


def jolt_bone(t: Tables, bone: int, time: float) -> None:
    """Give a body at `time` of the part (s) what joints lent to its bone."""
    bones = t.bones
    if bone_changed(t, bone):
        x = bones.lent_x[bone]
        y = bones.lent_y[bone]
        jolt_at(t, bones.body[bone], time, x, y, bones.lent_spin[bone])
        reach = t.bodies.reach[bones.body[bone]]
        bones.sway[bone] += abs(x) + abs(y) + abs(bones.lent_spin[bone]) * reach
        bones.late_x[bone] += x
        bones.late_y[bone] += y
        bones.late_once_x[bone] += x * time
        bones.late_once_y[bone] += y * time
        bones.late_twice_x[bone] += x * time * time
        bones.late_twice_y[bone] += y * time * time


def bone_changed(t: Tables, bone: int) -> bool:
    """Whether joints last changed the velocity of a bone."""
    bones = t.bones
    return bones.lent_x[bone] != 0.0 or bones.lent_y[bone] != 0.0 or bones.lent_spin[bone] != 0.0
