"""After an impact: when do the bodies that it moved meet others now?

All that joints moved with the two has to be looked at too, each pair once.
"""

from engine.kernels.agenda import enqueue
from engine.kernels.following import closes_faster
from engine.kernels.meeting import approach_at, find_meeting, notice_passing
from engine.kernels.resting import OVERLAP, explained_speed
from engine.linkage.answers import changed, has_braces
from engine.linkage.limb_impacts import bone_changed, tree_at
from engine.tables import FREE, NEVER, RESTING, Tables


def look_again(t: Tables, row: int, time: float, part: float, queued: int, strict: bool) -> int:
    """Find anew, after an impact at `time` (s), when the pairs of a body meet."""
    first = t.bodies.first_link[row]
    for link in range(first, first + t.bodies.links[row]):
        queued = look_at_pair(t, t.links.pair[link], time, part, queued, strict)
    return queued


def look_at_pair(t: Tables, pair: int, time: float, part: float, queued: int, strict: bool) -> int:
    """Find anew, after an impact at `time` (s), when a pair meets."""
    pairs = t.pairs
    if pairs.state[pair] == FREE:
        notice_passing(t, pair)
        find_meeting(t, pair, time, part)
    elif pairs.state[pair] == RESTING and strict:
        pairs.meeting[pair] = NEVER
        explained = explained_speed(t, pair, part)
        if closes_faster(t, pair, time, explained):
            speed = approach_at(t, pair, time)
            near = t.touch.gap[0] <= OVERLAP * pairs.size[pair]
            if near and speed > explained:
                pairs.meeting[pair] = time
                pairs.speed[pair] = speed
    return enqueue(t, pair, queued)


def look_at_joined(
    t: Tables, a: int, b: int, time: float, part: float, queued: int, strict: bool
) -> int:
    """Find anew, after an impact of a and b at `time` (s), when what joints moved meets others."""
    tree_a = tree_at(t, a)
    tree_b = tree_at(t, b)
    if tree_a >= 0:
        queued = look_at_tree(t, tree_a, a, b, time, part, queued, strict)
    if tree_b >= 0 and tree_b != tree_a:
        queued = look_at_tree(t, tree_b, a, b, time, part, queued, strict)
    if not has_braces(t, a) and not has_braces(t, b):
        return queued
    for node in range(1, t.braces.sizes[1]):
        if changed(t, node):
            queued = look_again(t, t.nodes.body[node], time, part, queued, strict)
    return queued


def look_at_tree(
    t: Tables, tree: int, a: int, b: int, time: float, part: float, queued: int, strict: bool
) -> int:
    """Find anew, after an impact of a and b at `time` (s), when a tree of hinges meets others."""
    first = t.trees.first[tree]
    for at in range(first, first + t.trees.limbs[tree]):
        queued = look_at_bone(t, t.limbs.member[at], a, b, time, part, queued, strict)
    root = t.trees.root[tree]
    if root >= 0:
        queued = look_at_bone(t, root, a, b, time, part, queued, strict)
    return queued


def look_at_bone(
    t: Tables, bone: int, a: int, b: int, time: float, part: float, queued: int, strict: bool
) -> int:
    """The same for one of its bodies, if it was struck or moved by its hinges; what it meets of the
    same tree has been looked at with the first of the two.
    """
    bodies = t.bodies
    row = t.bones.body[bone]
    if not is_moved(t, bone, a, b):
        return queued
    first = bodies.first_link[row]
    for link in range(first, first + bodies.links[row]):
        pair = t.links.pair[link]
        other = bodies.bone[t.pairs.a[pair] + t.pairs.b[pair] - row] - 1
        known = 0 <= other < bone and t.bones.tree[other] == t.bones.tree[bone]
        if not known or not is_moved(t, other, a, b):
            queued = look_at_pair(t, pair, time, part, queued, strict)
    return queued


def is_moved(t: Tables, bone: int, a: int, b: int) -> bool:
    """Whether an impact of a and b changed the velocity of a bone."""
    row = t.bones.body[bone]
    return row in (a, b) or bone_changed(t, bone)
