"""The books of angular momentum, of what joints do; see `kernels.moments`.

What a joint gives to two bodies at a common point, or along one line, is nothing together. It is
not, where one of them is immovable, for strings over fixed points, and where hands have torn a
hinge so far that it pulls at both anchors.
"""

from engine.kernels.halting import is_ground
from engine.kernels.moments import book_lost, place_in_part
from engine.kernels.pose import place_at
from engine.kernels.rousing import PRESENT
from engine.linkage.geometry import POINT, STRING, TORN
from engine.tables import Tables

OPEN = TORN / 2.0
"""Two points at which a hinge pulls are no common one if they are further apart, in its sizes."""


def book_tree(t: Tables, tree: int) -> None:
    """Book the impulses of a tree whose limbs are placed where their bodies have them at once.

    None gives both of its bodies anything, but the one that holds the tree, which comes last, as
    long as no hinge is torn and all bodies turn.
    """
    member = t.limbs.member
    first = t.trees.first[tree]
    last = first + t.trees.limbs[tree] - 1
    if t.trees.particles[tree] == 1 or t.progress.torn[0] == 1:
        for at in range(first, last):
            book_limb(t, member[at])
        book_limb(t, member[last])
    elif t.trees.root[tree] < 0:
        book_limb(t, member[last])


def book_limb(t: Tables, k: int) -> None:
    """Book the impulse of a limb that is placed where its bodies have it at once."""
    bones = t.bones
    limbs = t.limbs
    x = limbs.impulse_x[k]
    y = limbs.impulse_y[k]
    book_turn_of_limb(t, k, turn_of_both(t, k, x, y))
    if bones.inverse_inertia[k] == 0.0:
        book_lost(t, bones.body[k], limbs.arm_x[k] * y - limbs.arm_y[k] * x)
    parent = limbs.parent[k]
    if parent < bones.sizes[1] and bones.inverse_inertia[parent] == 0.0:
        book_lost(t, bones.body[parent], limbs.lever_y[k] * x - limbs.lever_x[k] * y)


def give_outside(t: Tables) -> bool:
    """Whether limbs that act may give what they do not give to the other body: to the ground, to
    which those of what waits may stick, or to particles, which lose it.
    """
    bones = t.bones
    losing = 0
    for at in range(bones.sizes[10]):
        losing += t.trees.particles[t.trees.acting[at]]
    return losing > 0 or t.bodies.waits[bones.body[bones.acting[0]]] != PRESENT


def book_even_limb(t: Tables, k: int, x: float, y: float, share: float, lasted: float) -> None:
    """Book the impulse (N s) of a limb all through a part that lasted so long (s), a share of what
    was planned.
    """
    bones = t.bones
    limbs = t.limbs
    child = bones.body[k]
    parent = limbs.parent[k]
    hangs = parent < bones.sizes[1]
    row = bones.body[parent] if hangs else child
    fixed = is_ground(t, child)
    both = limbs.both[k] * share
    turn = limbs.turn[k] * share
    counter = limbs.counter[k] * share
    if not fixed:
        book_lost(t, child, turn)
    if not hangs or fixed == is_ground(t, row):
        if not hangs or not fixed:
            book_turn_of_limb(t, k, both)
    elif fixed:
        at_x, at_y = place_in_part(t.bodies, row, lasted)
        t.books.wall_turn[0] -= at_x * y - at_y * x + counter
    else:
        at_x, at_y = place_in_part(t.bodies, child, lasted)
        t.books.wall_turn[0] += at_x * y - at_y * x + turn
    if not hangs and fixed:
        t.books.wall_turn[0] -= both
    if hangs and not is_ground(t, row):
        book_lost(t, row, -counter)


def book_turn_of_limb(t: Tables, k: int, turn: float) -> None:
    """Book what a limb gives to its bodies together (N m s)."""
    if t.limbs.parent[k] < t.bones.sizes[1]:
        t.books.correction_turn[0] += turn
    else:
        t.books.joint_turn[0] += turn


def turn_of_both(t: Tables, k: int, x: float, y: float) -> float:
    """Angular impulse about the origin by an impulse (N s) of a placed limb on its bodies that can
    move, together (N m s).
    """
    bones = t.bones
    limbs = t.limbs
    parent = limbs.parent[k]
    hangs = parent < bones.sizes[1]
    if hangs and t.progress.torn[0] == 0:
        return 0.0
    at_x = bones.x[k] + limbs.arm_x[k]
    at_y = bones.y[k] + limbs.arm_y[k]
    if hangs:
        at_x -= bones.x[parent] + limbs.lever_x[k]
        at_y -= bones.y[parent] + limbs.lever_y[k]
        if (at_x * at_x + at_y * at_y) * limbs.scale[k] <= OPEN * OPEN:
            return 0.0
    return at_x * y - at_y * x


def book_braces(t: Tables, time: float, all_of_it: bool) -> None:
    """Book the impulses of joints that are no hinges of trees, given at `time` of the part (s), for
    which Jacobians were set: all of it, or what the last steps added to it.
    """
    nodes = t.nodes
    arms = t.arms
    for brace in range(t.braces.sizes[0]):
        first = t.braces.first[brace]
        sum_a = 0.0
        sum_b = 0.0
        for row in range(first, first + t.braces.rows[brace]):
            impulse = t.equations.impulse[row] if all_of_it else t.equations.total[row]
            sum_a += turn_by_arm(t, 2 * row, impulse, time)
            sum_b += turn_by_arm(t, 2 * row + 1, impulse, time)
            for arm in range(2 * row, 2 * row + 2):
                node = arms.node[arm]
                if nodes.inverse_inertia[node] == 0.0 and nodes.inverse_mass[node] > 0.0:
                    book_lost(t, nodes.body[node], arms.turn[arm] * impulse)
        if is_outside(t, brace):
            t.books.joint_turn[0] += sum_a + sum_b
        elif t.braces.shape[brace] == POINT and is_torn(t, brace, time):
            t.books.correction_turn[0] += sum_a + sum_b


def turn_by_arm(t: Tables, arm: int, impulse: float, time: float) -> float:
    """Angular impulse about the origin by the impulse of a row on one body, if that can move."""
    arms = t.arms
    node = arms.node[arm]
    if t.nodes.inverse_mass[node] == 0.0:
        return 0.0
    row = t.nodes.body[node]
    x, y = place_at(t.bodies, row, time)
    turn = x * arms.y[arm] - y * arms.x[arm]
    return (turn + arms.turn[arm]) * impulse


def is_outside(t: Tables, brace: int) -> bool:
    """Whether a joint exchanges impulses with what no impulse moves."""
    inverse_mass = t.nodes.inverse_mass
    held = inverse_mass[t.braces.node_a[brace]] * inverse_mass[t.braces.node_b[brace]] == 0.0
    return held or t.braces.shape[brace] == STRING


def is_torn(t: Tables, brace: int, time: float) -> bool:
    """Whether a POINT pulls at two places."""
    turn = t.arms.turn
    row = 2 * t.braces.first[brace]
    a_x, a_y = place_at(t.bodies, t.nodes.body[t.braces.node_a[brace]], time)
    b_x, b_y = place_at(t.bodies, t.nodes.body[t.braces.node_b[brace]], time)
    x = b_x + turn[row + 3] - a_x + turn[row + 2]
    y = b_y - turn[row + 1] - a_y - turn[row]
    most = OPEN * t.joints.size[t.braces.joint[brace]]
    return x * x + y * y > most * most
