"""What joints constrain: values of their rows and Jacobians, for bodies in given poses.

The rows of the four shapes, with the anchors p_a and p_b, d = p_b - p_a:

- POINT: d_x, d_y, and the angle of b less that of a;
- SLIDE: d along the normal of an axis that turns with a, the angle, and d along the axis;
- LINE: the length of d;
- STRING: |p_a - o_a| + ratio |p_b - o_b|, for two points o over which a string runs.

Every impulse acts on both bodies at one common point or along one line, so that angular momentum
is kept to rounding even where the constraint is not met exactly, unless it is torn (`TORN`).
"""

import math

from engine.kernels.elementary import cos_sin
from engine.tables import Tables

POINT, SLIDE, LINE, STRING = 0, 1, 2, 3

WORLD = 0
"""Row of the world in `Nodes`."""

TORN = 0.5
"""A POINT that gapes by more, in reaches of the smaller body, as hands tear it, pulls at both
anchors instead of halfway between them, where levers are so long that it would throw the bodies."""


def place_nodes(t: Tables, ahead: float) -> None:
    """Place the nodes where their bodies are after `ahead` seconds at their velocities."""
    nodes = t.nodes
    bodies = t.bodies
    for node in range(1, t.braces.sizes[1]):
        row = nodes.body[node]
        x = bodies.x[row] + ahead * (nodes.vx[node] + nodes.lent_x[node])
        y = bodies.y[row] + ahead * (nodes.vy[node] + nodes.lent_y[node])
        angle = bodies.angle[row] + ahead * (nodes.spin[node] + nodes.lent_spin[node])
        place_node(t, node, x, y, angle)


def place_node(t: Tables, node: int, x: float, y: float, angle: float) -> None:
    """Put a node into a pose (m, rad)."""
    nodes = t.nodes
    nodes.x[node] = x
    nodes.y[node] = y
    nodes.angle[node] = angle
    nodes.cos[node], nodes.sin[node] = cos_sin(angle)


def weigh_node(t: Tables, node: int) -> None:
    """Read what the body of a node resists with."""
    row = t.nodes.body[node]
    t.nodes.inverse_mass[node] = t.bodies.inverse_mass[row]
    t.nodes.inverse_inertia[node] = t.bodies.inverse_inertia[row]


def measure(t: Tables) -> None:
    """Set the values of all rows for the placed nodes."""
    for brace in range(t.braces.sizes[0]):
        shape = t.braces.shape[brace]
        if shape == POINT:
            measure_point(t, brace)
        elif shape == SLIDE:
            measure_slide(t, brace)
        elif shape == LINE:
            measure_line(t, brace)
        else:
            measure_string(t, brace)


def aim(t: Tables) -> None:
    """Set the Jacobians of all rows for the placed nodes."""
    for brace in range(t.braces.sizes[0]):
        shape = t.braces.shape[brace]
        if shape == POINT:
            aim_point(t, brace)
        elif shape == SLIDE:
            aim_slide(t, brace)
        elif shape == LINE:
            aim_line(t, brace)
        else:
            aim_string(t, brace)


def turned(t: Tables, node: int, x: float, y: float) -> tuple[float, float]:
    """A vector in the frame of a node, in the directions of the world."""
    cos = t.nodes.cos[node]
    sin = t.nodes.sin[node]
    return cos * x - sin * y, sin * x + cos * y


def arm_of_a(t: Tables, brace: int) -> tuple[float, float]:
    """From the centre of a to its anchor (m, world)."""
    joint = t.braces.joint[brace]
    return turned(t, t.braces.node_a[brace], t.joints.a_x[joint], t.joints.a_y[joint])


def arm_of_b(t: Tables, brace: int) -> tuple[float, float]:
    """From the centre of b to its anchor (m, world)."""
    joint = t.braces.joint[brace]
    return turned(t, t.braces.node_b[brace], t.joints.b_x[joint], t.joints.b_y[joint])


def set_pair(
    t: Tables, row: int, x: float, y: float, turn_a: float, turn_b: float, share_a: float
) -> None:
    """Set the Jacobians of a row whose force on b is along (x, y), and on a `share_a` of it."""
    set_arm(t, 2 * row, share_a * x, share_a * y, turn_a)
    set_arm(t, 2 * row + 1, x, y, turn_b)


def set_arm(t: Tables, arm: int, x: float, y: float, turn: float) -> None:
    """Set the Jacobian of a row for one body."""
    arms = t.arms
    node = arms.node[arm]
    inverse_mass = t.nodes.inverse_mass[node]
    arms.x[arm] = x
    arms.y[arm] = y
    arms.turn[arm] = turn
    arms.by_mass_x[arm] = x * inverse_mass
    arms.by_mass_y[arm] = y * inverse_mass
    arms.by_inertia[arm] = turn * t.nodes.inverse_inertia[node]


def measure_point(t: Tables, brace: int) -> None:
    """Values of a POINT."""
    nodes = t.nodes
    row = t.braces.first[brace]
    a = t.braces.node_a[brace]
    b = t.braces.node_b[brace]
    a_x, a_y = arm_of_a(t, brace)
    b_x, b_y = arm_of_b(t, brace)
    t.equations.value[row] = (nodes.x[b] + b_x) - (nodes.x[a] + a_x)
    t.equations.value[row + 1] = (nodes.y[b] + b_y) - (nodes.y[a] + a_y)
    if t.braces.rows[brace] == 3:
        rest = t.joints.rest_angle[t.braces.joint[brace]]
        t.equations.value[row + 2] = nodes.angle[b] - nodes.angle[a] - rest


def aim_point(t: Tables, brace: int) -> None:
    """Jacobians of a POINT; both impulses act halfway between the anchors."""
    nodes = t.nodes
    row = t.braces.first[brace]
    a = t.braces.node_a[brace]
    b = t.braces.node_b[brace]
    a_x, a_y = arm_of_a(t, brace)
    b_x, b_y = arm_of_b(t, brace)
    gap_x = (nodes.x[b] + b_x) - (nodes.x[a] + a_x)
    gap_y = (nodes.y[b] + b_y) - (nodes.y[a] + a_y)
    most = TORN * t.joints.size[t.braces.joint[brace]]
    share = 0.5 if gap_x * gap_x + gap_y * gap_y <= most * most else 0.0
    half_x = gap_x * share
    half_y = gap_y * share
    a_x += half_x
    a_y += half_y
    b_x -= half_x
    b_y -= half_y
    set_pair(t, row, 1.0, 0.0, a_y, -b_y, -1.0)
    set_pair(t, row + 1, 0.0, 1.0, -a_x, b_x, -1.0)
    if t.braces.rows[brace] == 3:
        set_pair(t, row + 2, 0.0, 0.0, -1.0, 1.0, -1.0)


def axis_of(t: Tables, brace: int) -> tuple[float, float]:
    """The axis of a SLIDE (world)."""
    joint = t.braces.joint[brace]
    return turned(t, t.braces.node_a[brace], t.joints.axis_x[joint], t.joints.axis_y[joint])


def measure_slide(t: Tables, brace: int) -> None:
    """Values of a SLIDE."""
    nodes = t.nodes
    row = t.braces.first[brace]
    a = t.braces.node_a[brace]
    b = t.braces.node_b[brace]
    a_x, a_y = arm_of_a(t, brace)
    b_x, b_y = arm_of_b(t, brace)
    x = (nodes.x[b] + b_x) - (nodes.x[a] + a_x)
    y = (nodes.y[b] + b_y) - (nodes.y[a] + a_y)
    along_x, along_y = axis_of(t, brace)
    rest = t.joints.rest_angle[t.braces.joint[brace]]
    t.equations.value[row] = y * along_x - x * along_y
    t.equations.value[row + 1] = nodes.angle[b] - nodes.angle[a] - rest
    if t.braces.rows[brace] == 3:
        t.equations.value[row + 2] = x * along_x + y * along_y


def aim_slide(t: Tables, brace: int) -> None:
    """Jacobians of a SLIDE; its forces act at the anchor of b."""
    nodes = t.nodes
    row = t.braces.first[brace]
    a = t.braces.node_a[brace]
    b = t.braces.node_b[brace]
    b_x, b_y = arm_of_b(t, brace)
    a_x = nodes.x[b] + b_x - nodes.x[a]
    a_y = nodes.y[b] + b_y - nodes.y[a]
    x, y = axis_of(t, brace)
    set_pair(t, row, -y, x, -(a_x * x + a_y * y), b_x * x + b_y * y, -1.0)
    set_pair(t, row + 1, 0.0, 0.0, -1.0, 1.0, -1.0)
    if t.braces.rows[brace] == 3:
        set_pair(t, row + 2, x, y, -(a_x * y - a_y * x), b_x * y - b_y * x, -1.0)


def measure_line(t: Tables, brace: int) -> None:
    """Value of a LINE; negative if b went past a since the Jacobian was set."""
    nodes = t.nodes
    row = t.braces.first[brace]
    a = t.braces.node_a[brace]
    b = t.braces.node_b[brace]
    a_x, a_y = arm_of_a(t, brace)
    b_x, b_y = arm_of_b(t, brace)
    x = (nodes.x[b] + b_x) - (nodes.x[a] + a_x)
    y = (nodes.y[b] + b_y) - (nodes.y[a] + a_y)
    length = math.sqrt(x * x + y * y)
    if x * t.arms.x[2 * row + 1] + y * t.arms.y[2 * row + 1] < 0.0:
        length = -length
    t.equations.value[row] = length


def aim_line(t: Tables, brace: int) -> None:
    """Jacobian of a LINE; where its ends coincide it keeps the direction that it had."""
    nodes = t.nodes
    row = t.braces.first[brace]
    a = t.braces.node_a[brace]
    b = t.braces.node_b[brace]
    a_x, a_y = arm_of_a(t, brace)
    b_x, b_y = arm_of_b(t, brace)
    x = (nodes.x[b] + b_x) - (nodes.x[a] + a_x)
    y = (nodes.y[b] + b_y) - (nodes.y[a] + a_y)
    length = math.sqrt(x * x + y * y)
    if length > 0.0:
        x /= length
        y /= length
    else:
        x = 1.0
        y = 0.0
    set_pair(t, row, x, y, -(a_x * y - a_y * x), b_x * y - b_y * x, -1.0)


def measure_string(t: Tables, brace: int) -> None:
    """Value of a STRING."""
    nodes = t.nodes
    joints = t.joints
    joint = t.braces.joint[brace]
    a_x, a_y = arm_of_a(t, brace)
    b_x, b_y = arm_of_b(t, brace)
    a_x += nodes.x[t.braces.node_a[brace]] - joints.over_a_x[joint]
    a_y += nodes.y[t.braces.node_a[brace]] - joints.over_a_y[joint]
    b_x += nodes.x[t.braces.node_b[brace]] - joints.over_b_x[joint]
    b_y += nodes.y[t.braces.node_b[brace]] - joints.over_b_y[joint]
    length = math.sqrt(a_x * a_x + a_y * a_y)
    length += joints.ratio[joint] * math.sqrt(b_x * b_x + b_y * b_y)
    t.equations.value[t.braces.first[brace]] = length


def aim_string(t: Tables, brace: int) -> None:
    """Jacobian of a STRING."""
    nodes = t.nodes
    joints = t.joints
    joint = t.braces.joint[brace]
    row = t.braces.first[brace]
    a_x, a_y = arm_of_a(t, brace)
    b_x, b_y = arm_of_b(t, brace)
    x = nodes.x[t.braces.node_a[brace]] + a_x - joints.over_a_x[joint]
    y = nodes.y[t.braces.node_a[brace]] + a_y - joints.over_a_y[joint]
    length = math.sqrt(x * x + y * y)
    if length > 0.0:
        x /= length
        y /= length
    set_arm(t, 2 * row, x, y, a_x * y - a_y * x)
    x = nodes.x[t.braces.node_b[brace]] + b_x - joints.over_b_x[joint]
    y = nodes.y[t.braces.node_b[brace]] + b_y - joints.over_b_y[joint]
    length = math.sqrt(x * x + y * y)
    if length > 0.0:
        x *= joints.ratio[joint] / length
        y *= joints.ratio[joint] / length
    set_arm(t, 2 * row + 1, x, y, b_x * y - b_y * x)
