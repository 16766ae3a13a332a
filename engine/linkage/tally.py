"""What joints exerted in a tick, and which of them it broke."""

import math

from engine.tables import Tables

BREAKING, BROKEN = 1, 2
"""States of a joint that gave way: in this tick; before."""


MOST_TURN = 0.25
"""By which a joined body turns in a part at most (rad): faster ones get shorter parts."""

SHORTEST = 1.0 / 32.0
"""Share of a substep that a part has at least."""


def part_for_joints(t: Tables, substep: float) -> float:
    """Length of a part (s) in which no joined body turns far: a substep if none is fast."""
    fastest = 0.0
    for node in range(1, t.braces.sizes[1]):
        spin = t.bodies.spin[t.nodes.body[node]]
        if spin > fastest:
            fastest = spin
        elif -spin > fastest:
            fastest = -spin
    if fastest * substep <= MOST_TURN:
        return substep
    share = MOST_TURN / (fastest * substep)
    return substep * (share if share > SHORTEST else SHORTEST)


def clear_sums(t: Tables) -> None:
    """Begin a tick: nothing has been exerted yet."""
    joints = t.joints
    t.braces.sizes[5] = 0
    for brace in range(t.braces.sizes[0]):
        joint = t.braces.joint[brace]
        joints.sum_x[joint] = 0.0
        joints.sum_y[joint] = 0.0
        joints.sum_turn[joint] = 0.0


def mean_forces(t: Tables, dt: float) -> None:
    """End a tick of `dt` seconds: turn impulses into mean forces; break what they overload."""
    joints = t.joints
    for brace in range(t.braces.sizes[0]):
        joint = t.braces.joint[brace]
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
