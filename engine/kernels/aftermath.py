"""After an impact: when do the bodies that it moved meet others now?

All that joints moved with the two has to be looked at too, each pair once.
"""

from engine.kernels.agenda import TOGETHER, enqueue
from engine.kernels.circles import stillness
from engine.kernels.following import closes_faster, turning
from engine.kernels.gathering import is_ground
from engine.kernels.impacts import explained_speed
from engine.kernels.meeting import find_meeting, notice_passing, swing_of
from engine.kernels.pose import place_pair
from engine.kernels.searching import approach_of, fastest_within
from engine.kernels.touches import OVERLAP
from engine.linkage.answers import changed
from engine.linkage.limb_impacts import tree_at
from engine.linkage.tally import has_braces, is_joined
from engine.manifolds.any_pair import touching_points
from engine.tables import FREE, LATER, NEVER, RESTING, Tables

TILT = 0.003
"""If a pair that rests turns by more until its part is over (rad), its other corner is seen to."""

BLOWS = 8
"""After so many in a tick, within a substep of each other, what rests is left to the sweeps of the
next part, but where"""

SINKS = 0.003
"""it would sink further before that is over (in reaches of the smaller body); and after"""

MOST_BLOWS = 128
"""in any case: blows to and fro between what is wedged take ever so many to come to an end."""

LOOKS = 3
"""Steps of Newton's method: each doubles the number of digits."""


def look_at_struck(
    t: Tables, number: int, time: float, part: float, queued: int, strict: bool
) -> int:
    """Find anew, after the impact at `time` (s) of the pairs that were gathered, when what they
    moved meets others; return the queue's length.
    """
    seen = t.bodies.seen
    for k in range(number):
        a = t.pairs.a[t.hits.gathered[k]]
        b = t.pairs.b[t.hits.gathered[k]]
        if is_joined(t, t.hits.gathered[k]):
            queued = look_at_joined(t, a, b, time, part, queued, strict)
        for body in (a, b):
            if seen[body] == 0 and is_deflected(t, body):
                queued = look_again(t, body, swerve(t, body), time, part, queued, strict)
                seen[body] = 1
    for k in range(number):
        seen[t.pairs.a[t.hits.gathered[k]]] = 0
        seen[t.pairs.b[t.hits.gathered[k]]] = 0
    return queued


def is_deflected(t: Tables, row: int) -> bool:
    """Whether an impact may have changed the velocity of a body, and that is not one of a tree of
    hinges, all of which are looked at together.
    """
    return t.bodies.bone[row] == 0 and not is_ground(t, row)


def swerve(t: Tables, row: int) -> float:
    """Bound by how much the last impact changed the velocity of any point of a body (m/s)."""
    bodies = t.bodies
    change = abs(bodies.vx[row] - bodies.came_x[row]) + abs(bodies.vy[row] - bodies.came_y[row])
    return change + abs(bodies.spin[row] - bodies.came_spin[row]) * swing_of(t, row)


def look_again(
    t: Tables, row: int, swerves: float, time: float, part: float, queued: int, strict: bool
) -> int:
    """Find anew when the pairs of a body meet, after an impact at `time` (s) that changed the
    velocity of any point of it by what it `swerves` at most (m/s). Pairs that rest and were looked
    at with the other body are as they were.
    """
    pairs = t.pairs
    seen = t.bodies.seen
    closer = swerves * (part - time)
    first = t.bodies.first_link[row]
    for link in range(first, first + t.bodies.links[row]):
        pair = t.links.pair[link]
        if pairs.state[pair] == FREE:
            if stays_apart(t, pair, closer):
                continue
        elif seen[pairs.a[pair]] + seen[pairs.b[pair]] > 0:
            continue
        queued = look_at_pair(t, pair, time, part, queued, strict)
    return queued


def stays_apart(t: Tables, pair: int, closer: float) -> bool:
    """Whether a pair does not meet in this part though it may come closer than was foreseen (m)."""
    left = t.pairs.apart[pair] - closer
    if left <= 0.0 or t.progress.straight[0] == 1:
        return False
    t.pairs.apart[pair] = left
    return True


def look_at_pair(t: Tables, pair: int, time: float, part: float, queued: int, strict: bool) -> int:
    """Find anew, after an impact at `time` (s), when a pair meets."""
    pairs = t.pairs
    if pairs.state[pair] == FREE:
        notice_passing(t, pair)
        find_meeting(t, pair, time, part)
    elif pairs.state[pair] == RESTING and strict:
        pairs.meeting[pair] = NEVER
        slow = slow_enough(t, pair, part, part - time)
        if closes_faster(t, pair, time, slow):
            place_pair(t, pair, time)
            points = touching_points(t, pair)
            speed = fastest_within(t, pair, points, time, OVERLAP * pairs.size[pair])
            if speed > slow:
                pairs.meeting[pair] = time
                pairs.speed[pair] = speed
        if pairs.meeting[pair] == NEVER and turning(t, pair, part - time) > TILT:
            await_corner(t, pair, time, part)
    return enqueue(t, pair, queued)


def slow_enough(t: Tables, pair: int, part: float, left: float) -> float:
    """Speed (m/s) at which a resting pair may close without a blow until its part (s) is over in
    `left` seconds: one that forces explain, and after many blows one at which it sinks little.
    """
    explained = explained_speed(t, pair, part)
    bounces = t.pairs.bounces[pair]
    if bounces < BLOWS:
        return explained
    if bounces >= MOST_BLOWS or left <= 0.0:
        return 1e300
    sinking = SINKS * t.pairs.size[pair] / left
    return sinking if sinking > explained else explained


def await_corners(t: Tables, resting: int, part: float, queued: int) -> int:
    """Queue the resting pairs of which a point will land in the part (s); see `resting`."""
    pairs = t.pairs
    for k in range(resting):
        pair = pairs.resting[k]
        if pairs.meeting[pair] == LATER:
            await_corner(t, pair, 0.0, part)
            queued = enqueue(t, pair, queued)
    return queued


def await_corner(t: Tables, pair: int, time: float, part: float) -> None:
    """Find when, after `time` of the part (s), the other corner of a resting pair that turns comes
    down, by Newton's method; where it does not get there, that is left to the next part.

    As the faces of two bodies that move become parallel, their corners may change places; one that
    the ground keeps out is seen to with the blow of the other (see `gathering`).
    """
    t.pairs.meeting[pair] = NEVER
    when = time
    speed = 0.0
    gap = 0.0
    corner = 0
    still = stillness(t, pair)
    moves = not is_ground(t, t.pairs.a[pair]) and not is_ground(t, t.pairs.b[pair])
    for look in range(LOOKS):
        place_pair(t, pair, when)
        if touching_points(t, pair) < 2:
            return
        if look == 0 and approach_of(t, pair, 1, when) > approach_of(t, pair, 0, when):
            corner = 1
        speed = approach_of(t, pair, corner, when)
        if speed <= still and look > 0 and moves:
            corner = 1 - corner
            speed = approach_of(t, pair, corner, when)
        if speed <= still:
            return
        gap = t.touch.gap[corner]
        when += gap / speed
        if when <= time + TOGETHER:
            return
        if when > part:
            when = part
    if when < part and abs(gap) <= OVERLAP * t.pairs.size[pair]:
        t.pairs.meeting[pair] = when
        t.pairs.speed[pair] = speed


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
            queued = look_again(t, t.nodes.body[node], NEVER, time, part, queued, strict)
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
    moved = swerve_of_bone(t, bone, a, b)
    if moved == 0.0 and row not in (a, b):
        return queued
    first = bodies.first_link[row]
    for link in range(first, first + bodies.links[row]):
        pair = t.links.pair[link]
        other = bodies.bone[t.pairs.a[pair] + t.pairs.b[pair] - row] - 1
        closer = moved
        if other >= 0 and t.bones.tree[other] == t.bones.tree[bone]:
            by_other = swerve_of_bone(t, other, a, b)
            if other < bone and (by_other > 0.0 or t.bones.body[other] in (a, b)):
                continue
            closer += by_other
        if t.pairs.state[pair] != FREE or not stays_apart(t, pair, closer * (part - time)):
            queued = look_at_pair(t, pair, time, part, queued, strict)
    return queued


def swerve_of_bone(t: Tables, bone: int, a: int, b: int) -> float:
    """Bound by how much an impact of a and b changed the velocity of any point of a bone (m/s)."""
    row = t.bones.body[bone]
    return swerve(t, row) if row in (a, b) else t.bones.sway[bone]
