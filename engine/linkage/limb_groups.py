"""Groups of joined bodies that touch each other: each is swept until it is calm, or a few times.

Trees of hinges that touch each other form a group; bodies that no tree holds form one of their own,
with all trees that they touch. What does not move at all carries no impulse from one to another, so
each group ends its sweeps when it is calm, not when all are; and all of it fits into the cache.
"""

from engine.kernels.sweeps import QUIET, STIRRED, WILD, sweep
from engine.linkage.limb_sweeps import sweep_all, sweep_tree
from engine.tables import Tables

PRESSING = 2
"""Sweeps of a group of joined bodies at most, while overlaps are corrected: more of them only take
hinges and contacts to and fro, and what they leave of hinges is solved exactly."""

EASING = 4
"""The same to relax,"""

EVENLY = 1e-3
"""or until one changes no velocity by more, in reaches a second (1/s)."""

NONE = -1
"""No group: what nothing moves."""


def only_trees_touch(t: Tables) -> bool:
    """Whether contacts act on trees of hinges, and no other joints act."""
    return t.bones.sizes[7] > 0 and t.braces.sizes[0] == 0


def sweep_groups(
    t: Tables,
    resting: int,
    most: int,
    few: int,
    calm: float,
    evenly: float,
    early: int,
    forth: bool,
) -> bool:
    """Sweep hinges and contacts, group by group, until each is calm; return whether all became so.

    Args:
        t: the tables.
        resting: number of pairs that rest.
        most: number of sweeps at most,
        few: and for groups in which all bodies are joined.
        calm: a sweep that changes no velocity by more (reaches a second) is the last,
        evenly: and for groups in which all bodies are joined.
        early: number of sweeps after which bodies that are not joined are left as they are, if
            they are still wild.
        forth: whether the first sweep goes forwards; they go to and fro in turn.
    """
    sort_pairs(t, resting)
    listed = t.pairs.resting
    free = t.bones.sizes[3]
    end = 0
    all_calm = True
    for group in range(free + 1):
        first = end
        end += t.trees.pairs[group]
        if t.trees.group[group] != group:
            continue
        for k in range(first, end):
            listed[k - first] = t.pairs.grouped[k]
        joined = t.trees.group[free] != group
        least = evenly if joined else calm
        found = STIRRED
        for i in range(1, (few if joined else most) + 1):
            backwards = (i % 2 == 0) == forth
            found = sweep_group(t, group, end - first, least, backwards)
            if found == QUIET or (found == WILD and group == free and i == early):
                break
        all_calm = all_calm and found == QUIET
    for k in range(resting):
        listed[k] = t.pairs.grouped[k]
    return all_calm


def calm_groups(t: Tables, resting: int, most: int, calm: float) -> bool:
    """Sweep hinges and contacts, each group until that changes no velocity by more than `calm`
    (reaches a second), `most` times at most; return whether all became calm.
    """
    if only_trees_touch(t):
        return sweep_groups(t, resting, most, most, calm, calm, most + 1, False)
    for i in range(most):  # noqa: SIM110, a loop that can be compiled
        if sweep_all(t, resting, calm, i % 2 == 0) == QUIET:
            return True
    return False


def sweep_group(t: Tables, group: int, pairs: int, calm: float, backwards: bool) -> int:
    """Solve each hinge of a group once, then each of its pairs, which are listed first.

    Returns how velocities changed, as `sweep` does.
    """
    found = QUIET
    tree = group
    while tree >= 0:
        if tree < t.bones.sizes[3] and t.trees.evenly[tree] == 1:
            moved = sweep_tree(t, tree, calm, backwards)
            if moved > found:
                found = moved
        tree = t.trees.next[tree]
    if pairs > 0:
        moved = sweep(t, pairs, calm, backwards)
        if moved > found:
            found = moved
    return found


def sort_pairs(t: Tables, resting: int) -> None:
    """Find the groups, and list the pairs that rest in their order, each group in the order of the
    old list.
    """
    trees = t.trees
    pairs = t.pairs
    last = t.bones.sizes[3]
    for group in range(last + 1):
        trees.group[group] = group
        trees.next[group] = NONE
        trees.pairs[group] = 0
    for k in range(resting):
        pair = pairs.resting[k]
        a = group_at(t, pairs.a[pair])
        b = group_at(t, pairs.b[pair])
        if a >= 0 and b >= 0 and a != b:
            if a < b:
                trees.group[b] = a
            else:
                trees.group[a] = b
    for tree in range(last, -1, -1):
        group = group_of(t, tree)
        trees.group[tree] = group
        if group != tree:
            trees.next[tree] = trees.next[group]
            trees.next[group] = tree
    for k in range(resting):
        trees.pairs[group_of_pair(t, pairs.resting[k])] += 1
    place = 0
    for group in range(last + 1):
        trees.place[group] = place
        place += trees.pairs[group]
    for k in range(resting):
        group = group_of_pair(t, pairs.resting[k])
        pairs.grouped[trees.place[group]] = pairs.resting[k]
        trees.place[group] += 1


def group_at(t: Tables, row: int) -> int:
    """The group of a body; `NONE` of one that nothing moves."""
    bone = t.bodies.bone[row] - 1
    if bone >= 0:
        return group_of(t, t.bones.tree[bone])
    return group_of(t, t.bones.sizes[3]) if t.bodies.inverse_mass[row] > 0.0 else NONE


def group_of_pair(t: Tables, pair: int) -> int:
    """The group of a pair."""
    a = group_at(t, t.pairs.a[pair])
    b = group_at(t, t.pairs.b[pair])
    if a >= 0:
        return a
    return b if b >= 0 else t.trees.group[t.bones.sizes[3]]


def group_of(t: Tables, tree: int) -> int:
    """The tree that stands for the group of another."""
    group = t.trees.group
    while group[tree] != tree:
        group[tree] = group[group[tree]]
        tree = group[tree]
    return tree
