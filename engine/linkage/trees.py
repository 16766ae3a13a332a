"""Which joints are hinges of trees of bodies, and the tables that follow from it.

Bodies that are hinged to each other without a ring, and to immovable ones at one place at most,
form a tree: its root is the immovable one, or the body with most hinges. Each other body is the
child of one hinge. Hinges are listed by how far they are from the root, the furthest first, and
those at one place of trees of one shape together: trees are eliminated from there to the root
(`linkage.limbs`), many of them side by side, at a cost in proportion to the number of hinges
whatever their shape.
"""

import math
from typing import Any, NamedTuple

import numpy as np

from engine.linkage.geometry import POINT
from engine.linkage.limbs import find_runs
from engine.tables import Bones, Limbs, Tables, Trees, allocate, views

WORLD = -1
"""Stands for the row of a body."""


class Brace(NamedTuple):
    """A joint that acts."""

    joint: int
    shape: int
    rows: int
    a: int
    """Row of the body, `WORLD` for the world."""
    b: int

    def other(self, body: int) -> int:
        """The body that it joins with this one."""
        return self.b if body == self.a else self.a


class Limb(NamedTuple):
    """A hinge of a tree."""

    depth: int
    tree: int
    joint: int
    child: int
    """Row of the body."""
    parent: int


class Tree(NamedTuple):
    """A tree of hinges."""

    root: int
    """Row of the body from which it hangs; `WORLD` for the world."""
    limbs: list[Limb]


def tree_of(
    number: int, island: list[Brace], joined: dict[int, list[int]], braces: list[Brace]
) -> Tree | None:
    """The tree that connected joints form, None if they do not.

    Args:
        number: which tree it is, counted from 0.
        island: all joints that hang together.
        joined: numbers of the joints of each movable body.
        braces: all joints.
    """
    if any(brace.shape != POINT or brace.rows != 2 for brace in island):
        return None
    bodies = {body for brace in island for body in (brace.a, brace.b)}
    movable = sorted(bodies & joined.keys())
    anchors = [brace for brace in island if brace.a not in joined or brace.b not in joined]
    if len(anchors) > 1 or len(island) - len(anchors) != len(movable) - 1:
        return None
    if anchors:
        root = anchors[0].a if anchors[0].a not in joined else anchors[0].b
        limbs = [Limb(1, number, anchors[0].joint, anchors[0].other(root), root)]
    else:
        root = max(movable, key=lambda body: (len(joined[body]), -body))
        limbs = _children(root, Limb(0, number, -1, root, WORLD), joined, braces)
    for limb in limbs:
        limbs += _children(limb.child, limb, joined, braces)
    return Tree(root, limbs)


def _children(
    body: int, above: Limb, joined: dict[int, list[int]], braces: list[Brace]
) -> list[Limb]:
    """The hinges by which others hang on a body."""
    return [
        Limb(above.depth + 1, above.tree, braces[i].joint, braces[i].other(body), body)
        for i in joined[body]
        if braces[i].joint != above.joint
    ]


def fill_trees(t: Tables, trees: list[Tree], movable: set[int], row_of: dict[int, int]) -> Tables:
    """Fill the tables of all trees; say of each body which bone it is."""
    order = _in_order(trees)
    roots = {tree.root: number for number, tree in enumerate(trees) if tree.root in movable}
    held = [number for number, tree in enumerate(trees) if tree.root not in movable]
    tree_of_bone = [*(limb.tree for limb in order), *roots.values(), *held]
    bodies = [*(limb.child for limb in order), *roots, *(trees[number].root for number in held)]
    bone_of = {(tree_of_bone[bone], body): bone for bone, body in enumerate(bodies)}
    bones, limbs = allocate(Bones, max(13, len(bodies))), allocate(Limbs, max(1, len(order)))
    sizes = (len(order), len(bodies) - len(held), len(bodies), len(trees))
    np.asarray(bones.sizes)[:4] = sizes
    np.asarray(bones.sizes)[8:12] = (sizes[0], sizes[1], sizes[3], sizes[2])
    np.asarray(bones.acting)[:] = np.arange(len(bones.acting))
    np.asarray(t.bodies.bone)[:] = 0
    for bone, body in enumerate(bodies):
        bones.body[bone] = body
        bones.tree[bone] = tree_of_bone[bone]
        if bone < sizes[1]:
            t.bodies.bone[body] = bone + 1
    for k, limb in enumerate(order):
        _fill_limb(t, limbs, k, limb, bone_of[limb.tree, limb.parent], row_of)
    table, place = allocate(Trees, len(trees) + 1), 0
    np.asarray(table.acting)[:] = np.arange(len(trees) + 1)
    for number, tree in enumerate(trees):
        table.first[number], table.limbs[number] = place, len(tree.limbs)
        table.root[number] = bone_of[number, tree.root] if tree.root in roots else -1
        turns: Any = t.bodies.inverse_inertia
        moved = {limb.child for limb in tree.limbs} | (movable & {tree.root})
        table.particles[number] = int(any(turns[body] == 0.0 for body in moved))
        if tree.root not in movable:
            _hang(limbs, tree, {limb.child: bone_of[number, limb.child] for limb in tree.limbs})
        for bone in sorted(bone_of[number, limb.child] for limb in tree.limbs):
            limbs.member[place] = bone
            place += 1
    t = t._replace(limbs=views(limbs), bones=views(bones), trees=views(table))
    find_runs(t)
    return t


def _in_order(trees: list[Tree]) -> list[Limb]:
    """All limbs, the furthest from the root first; those that come first at a depth of their tree,
    then those that come second, and so on.
    """
    placed = []
    for tree in trees:
        at: dict[int, int] = {}
        for limb in sorted(tree.limbs, key=lambda limb: limb[2:]):
            place = at[limb.depth] = at.get(limb.depth, -1) + 1
            placed.append((-limb.depth, place, limb.tree, limb))
    return [limb for *_, limb in sorted(placed)]


def _fill_limb(
    t: Tables, limbs: Limbs, k: int, limb: Limb, parent: int, row_of: dict[int, int]
) -> None:
    """Fill a row of `Limbs`."""
    joints: Any = t.joints
    a, b = ("a", "b") if row_of.get(joints.a[limb.joint], WORLD) == limb.child else ("b", "a")
    limbs.joint[k], limbs.parent[k], limbs.tree[k] = limb.joint, parent, limb.tree
    limbs.sign[k] = 1.0 if a == "b" else -1.0
    limbs.scale[k] = 1.0 / joints.size[limb.joint] ** 2
    for axis in "xy":
        own, others = (getattr(joints, f"{side}_{axis}")[limb.joint] for side in (a, b))
        getattr(limbs, f"child_{axis}")[k], getattr(limbs, f"parent_{axis}")[k] = own, others


def _hang(limbs: Limbs, tree: Tree, bone_of: dict[int, int]) -> None:
    """Note which pendulum a tree on a held root is like, stretched out: one of sum r^2/sum r."""
    far = {tree.root: 0.0}
    for limb in tree.limbs:
        k = bone_of[limb.child]
        to_hinge = math.hypot(limbs.parent_x[k], limbs.parent_y[k]) if limb.depth > 1 else 0.0
        from_hinge = math.hypot(limbs.child_x[k], limbs.child_y[k])
        far[limb.child] = far[limb.parent] + to_hinge + from_hinge
    total = sum(far.values())
    if total > 0.0:
        limbs.hangs[bone_of[tree.limbs[0].child]] = sum(r * r for r in far.values()) / total
