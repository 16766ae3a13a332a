"""The order in which joints are eliminated, and the tables that follow from it.

Trees of hinges go their own way (`linkage.trees`). Other joints that share a movable body meet in
an entry of the system matrix. They are numbered from one end of each group to the other, reversed
(Cuthill and McKee, "Reducing the bandwidth of sparse symmetric matrices", 1969): a chain has the
profile of a band of two joints.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np

from engine.linkage.geometry import LINE, POINT, SLIDE, STRING
from engine.linkage.trees import WORLD, Brace, Tree, fill_trees, tree_of
from engine.tables import (
    Arms,
    Braces,
    Couplings,
    Equations,
    Nodes,
    Profile,
    Structures,
    Tables,
    allocate,
    views,
)

SHAPES = (LINE, LINE, LINE, POINT, POINT, SLIDE, STRING)
"""Of each kind in `joints.KINDS`: distance, rope, spring, pin, weld, slider, pulley."""

FEW = 6
"""Hinges that a cart has at most"""

LIGHT = 10.0
"""and by how many times its wheels are lighter than its heaviest body at least, if they are solved
like other joints: so is what they bear (`linkage.loaded`). What spins fast in free flight would
lose energy by that, and dolls that lie would cost ten times as much."""


def put_in_order(t: Tables, joints: int, row_of: dict[int, int]) -> Tables:
    """Make the tables of the braces anew.

    Args:
        t: the tables.
        joints: rows in use of `Joints`.
        row_of: row of each body by its id.
    """
    acting = [_brace(t, joint, row_of) for joint in range(joints) if t.joints.broken[joint] == 0]
    inverse_mass = t.bodies.inverse_mass
    joined: dict[int, list[int]] = {}
    for number, brace in enumerate(acting):
        for body in {brace.a, brace.b} - {WORLD}:
            if inverse_mass[body] > 0.0:
                joined.setdefault(body, []).append(number)
    np.asarray(t.bodies.joined)[:] = 0
    for body in joined:
        t.bodies.joined[body] = 1
    trees: list[Tree] = []
    rest: list[list[Brace]] = []
    for island in _islands(acting, joined):
        tree = tree_of(len(trees), island, joined, acting)
        if tree is None or is_cart(t, tree):
            rest.append(island)
        else:
            trees.append(tree)
    fixed = {body for island in rest for brace in island for body in (brace.a, brace.b)} - {WORLD}
    node_of = {WORLD: 0} | {body: node + 1 for node, body in enumerate(sorted(fixed))}
    movable = set(joined)
    return _filled(fill_trees(t, trees, movable, row_of), rest, node_of, movable)


def is_cart(t: Tables, tree: Tree) -> bool:
    """Whether a small tree that hangs on nothing has light bodies, all of them wheels."""
    bodies = t.bodies
    if len(tree.limbs) > FEW or tree.root == WORLD or bodies.inverse_mass[tree.root] == 0.0:
        return False
    members = [tree.root, *(limb.child for limb in tree.limbs)]
    heaviest = max(bodies.mass[row] for row in members)
    light = [row for row in members if LIGHT * bodies.mass[row] < heaviest]
    return bool(light) and all(is_round(t, row) for row in light)


def is_round(t: Tables, row: int) -> bool:
    """Whether a body is a disc."""
    piece = t.bodies.first_piece[row]
    return bool(t.bodies.pieces[row] == 1 and t.pieces.corners[piece] == 1)


def _brace(t: Tables, joint: int, row_of: dict[int, int]) -> Brace:
    shape = SHAPES[t.joints.kind[joint]]
    bounded = t.joints.low[joint] > -np.inf or t.joints.high[joint] < np.inf
    rows = 3 if bounded or t.joints.motor[joint] else 2
    a, b = (row_of[id] if id else -1 for id in (t.joints.a[joint], t.joints.b[joint]))
    return Brace(joint, shape, 1 if shape in (LINE, STRING) else rows, a, b)


def _islands(braces: list[Brace], joined: dict[int, list[int]]) -> Iterator[list[Brace]]:
    """The groups of connected braces, each in the order of elimination."""
    seen: set[int] = set()
    for number in range(len(braces)):
        if number not in seen:
            far_end = _walk(number, braces, joined)[-1]
            group = _walk(far_end, braces, joined)
            seen.update(group)
            yield [braces[other] for other in reversed(group)]


def _walk(start: int, braces: list[Brace], joined: dict[int, list[int]]) -> list[int]:
    """The braces connected with one of them, the nearest first."""
    found, seen, passed = [start], {start}, set()
    for number in found:
        for body in (braces[number].a, braces[number].b):
            if body in joined and body not in passed:
                passed.add(body)
                new = [other for other in joined[body] if other not in seen]
                found += new
                seen.update(new)
    return found


def _filled(
    t: Tables, islands: list[list[Brace]], node_of: dict[int, int], movable: set[int]
) -> Tables:
    """Fill the tables for braces in the order of elimination, island by island."""
    order = [brace for island in islands for brace in island]
    starts = np.concatenate(([0], np.cumsum([brace.rows for brace in order], dtype=np.int64)))
    equations, entries = _profile(order, starts, movable)
    couplings = _couplings(order, starts, np.asarray(equations.base), movable)
    rows = int(starts[-1])
    arms, nodes = allocate(Arms, max(2, 2 * rows)), allocate(Nodes, len(node_of))
    for k, brace in enumerate(order):
        for row in range(starts[k], starts[k + 1]):
            arms.node[2 * row], arms.node[2 * row + 1] = node_of[brace.a], node_of[brace.b]
    for body, node in node_of.items():
        nodes.body[node] = max(body, 0)
    nodes.cos[0] = 1.0
    structures = allocate(Structures, len(islands) + 1)
    ends = np.cumsum([0] + [sum(brace.rows for brace in island) for island in islands])
    for k, island in enumerate(islands):
        structures.first[k + 1], structures.end[k + 1] = int(ends[k]), int(ends[k + 1])
        for body in {body for brace in island for body in (brace.a, brace.b)} & movable:
            nodes.structure[node_of[body]] = k + 1
            structures.heaviest[k + 1] = max(structures.heaviest[k + 1], t.bodies.mass[body])
    braces = allocate(Braces, max(8, len(order)))
    for k, brace in enumerate(order):
        braces.joint[k], braces.shape[k] = brace.joint, brace.shape
        braces.node_a[k], braces.node_b[k] = node_of[brace.a], node_of[brace.b]
        braces.first[k], braces.rows[k] = int(starts[k]), brace.rows
    sizes = (len(order), len(node_of), rows, len(couplings), entries)
    coordinates = sum(brace.shape in (LINE, STRING) or brace.rows == 3 for brace in order)
    np.asarray(braces.sizes)[:8] = (*sizes, 0, coordinates, 0)
    table = allocate(Couplings, max(1, len(couplings)))
    for k, (at, left, right) in enumerate(couplings):
        table.at[k], table.left[k], table.right[k] = at, left, right
    return t._replace(
        braces=views(braces),
        nodes=views(nodes),
        structures=views(structures),
        equations=views(equations),
        arms=views(arms),
        couplings=views(table),
        profile=views(allocate(Profile, max(1, entries))),
    )


def _profile(order: list[Brace], starts: Any, movable: set[int]) -> tuple[Equations, int]:
    """First column and place of each row; and the number of entries in all."""
    equations = allocate(Equations, max(1, int(starts[-1])))
    first_of: dict[int, int] = {}
    entries = 0
    for k, brace in enumerate(order):
        bodies = [body for body in (brace.a, brace.b) if body in movable]
        first = min([int(starts[k])] + [first_of[body] for body in bodies if body in first_of])
        for row in range(starts[k], starts[k + 1]):
            equations.first[row], equations.base[row] = first, entries - first
            entries += row - first + 1
        for body in bodies:
            first_of.setdefault(body, int(starts[k]))
    return equations, entries


def _couplings(
    order: list[Brace], starts: Any, base: Any, movable: set[int]
) -> list[tuple[int, int, int]]:
    """Which products of Jacobians add to which entry, in the order of the rows."""
    found: list[tuple[int, int, int]] = []
    on: dict[int, list[tuple[int, int]]] = {}
    for k, brace in enumerate(order):
        for side, body in enumerate((brace.a, brace.b)):
            if body in movable:
                on.setdefault(body, []).append((k, side))
                for row in range(starts[k], starts[k + 1]):
                    for other, other_side in on[body]:
                        for column in range(starts[other], min(starts[other + 1], row + 1)):
                            at = int(base[row]) + column
                            found.append((at, 2 * row + side, 2 * column + other_side))
    return found
