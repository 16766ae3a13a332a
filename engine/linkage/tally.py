"""What joints exerted in a tick, and which of them it broke."""

import math

from engine.tables import Tables
from engine.tables.linkage import BREAKING


def joints_that_act(t: Tables) -> int:
    """How many joints there are that are not broken."""
    return t.braces.sizes[0] + t.bones.sizes[8]


def joints_act(t: Tables) -> bool:
    """Whether there are any."""
    return t.braces.sizes[0] > 0 or t.bones.sizes[8] > 0


def is_joined(t: Tables, pair: int) -> bool:
    """Whether joints hold one of the bodies of a pair."""
    joined = t.bodies.joined
    return joined[t.pairs.a[pair]] == 1 or joined[t.pairs.b[pair]] == 1


def joints_jolt(t: Tables) -> bool:
    """Whether any joint gives an impulse at the start of a part."""
    return t.braces.sizes[0] > 0 or t.bones.sizes[7] < t.bones.sizes[10]


def clear_sums(t: Tables) -> None:
    """Begin a tick: nothing has been exerted yet."""
    t.braces.sizes[5] = 0
    for brace in range(t.braces.sizes[0]):
        clear_sum(t, t.braces.joint[brace])
    for limb in range(t.bones.sizes[0]):
        clear_sum(t, t.limbs.joint[limb])


def clear_sum(t: Tables, joint: int) -> None:
    """Let a joint have exerted nothing yet."""
    t.joints.sum_x[joint] = 0.0
    t.joints.sum_y[joint] = 0.0
    t.joints.sum_turn[joint] = 0.0


def mean_forces(t: Tables, dt: float) -> None:
    """End a tick of `dt` seconds: turn impulses into mean forces; break what they overload."""
    for brace in range(t.braces.sizes[0]):
        mean_force(t, t.braces.joint[brace], dt)
    for limb in range(t.bones.sizes[0]):
        mean_force(t, t.limbs.joint[limb], dt)


def mean_force(t: Tables, joint: int, dt: float) -> None:
    """Do so for one joint."""
    joints = t.joints
    x = joints.sum_x[joint] / dt
    y = joints.sum_y[joint] / dt
    torque = joints.sum_turn[joint] / dt
    joints.force_x[joint] = x
    joints.force_y[joint] = y
    joints.torque[joint] = torque
    most = joints.break_torque[joint]
    force = math.sqrt(x * x + y * y)
    if force > joints.break_force[joint] or torque > most or -torque > most:
        joints.broken[joint] = BREAKING
        t.state.loose[0] = 1
        t.state.stale[0] = 1


def has_braces(t: Tables, row: int) -> bool:
    """Whether joints hold a body that are no hinges of a tree."""
    return t.bodies.joined[row] == 1 and t.bodies.bone[row] == 0


def node_of(t: Tables, row: int) -> int:
    """The node of a body; 0, which never moves, if it has none. Nodes stand in the order of their
    bodies.
    """
    first = 1
    end = t.braces.sizes[1]
    while first < end:
        middle = (first + end) // 2
        if t.nodes.body[middle] < row:
            first = middle + 1
        else:
            end = middle
    return first if first < t.braces.sizes[1] and t.nodes.body[first] == row else 0
