"""What the coordinate of a joint does: it is fixed, elastic, free, at a limit, or driven.

The coordinate is the angle of a pin, the travel of a slider, the length of a line or a string. A
limit only pushes back, and a motor only as strongly as it can: which of them act is found by
solving, taking back what pulls or overstrains, and solving again (an active set).
"""

from engine.linkage.geometry import LINE, STRING
from engine.tables import Tables
from engine.tables.linkage import AT_HIGH, AT_LOW, DRIVEN, ELASTIC, FIXED, FREE_WAY, STRAINED

TIGHT = 1e-9
"""Constraints hold to this share of the smaller body's reach (angles: rad)."""

CLOSING = 2.0
"""Joints that gape, as they were torn apart by hand or found no solution, close no faster, in
reaches of the smaller body a second (1/s; angles: rad/s): that would throw the bodies. Coordinates,
which winches and servos change, are no gaps."""


def coordinate_row(t: Tables, brace: int) -> int:
    """The row of a joint's coordinate; -1 if it is free and has none."""
    shape = t.braces.shape[brace]
    if shape in (LINE, STRING):
        return t.braces.first[brace]
    return t.braces.first[brace] + 2 if t.braces.rows[brace] == 3 else -1


def scale_of(t: Tables, row: int, joint: int) -> float:
    """Unit of the tolerances of a row: the joint's size (m), or 1 rad."""
    return 1.0 if is_angle(t, row) else t.joints.size[joint]


def is_angle(t: Tables, row: int) -> bool:
    """Whether a row constrains an angle."""
    return t.arms.x[2 * row + 1] == 0.0 and t.arms.y[2 * row + 1] == 0.0


def first_mode(t: Tables, joint: int) -> int:
    """What the coordinate does at the start of a part, judging by the part before."""
    joints = t.joints
    if joints.stiffness[joint] > 0.0 or joints.damping[joint] > 0.0:
        return ELASTIC
    if joints.low[joint] == joints.high[joint]:
        return FIXED
    mode = joints.mode[joint]
    driven = joints.motor[joint] == 1
    if mode == AT_HIGH and not (driven and joints.speed[joint] < 0.0):
        return AT_HIGH
    if mode == AT_LOW and not (driven and joints.speed[joint] > 0.0):
        return AT_LOW
    if driven:
        return STRAINED if mode == STRAINED else DRIVEN
    return FREE_WAY


def next_mode(t: Tables, joint: int, row: int, part: float, slack: float) -> int:
    """What the coordinate does, as far as it got by the impulses so far."""
    joints = t.joints
    mode = joints.mode[joint]
    if mode != FREE_WAY and mode != DRIVEN and mode != STRAINED:
        return mode
    value = t.equations.value[row]
    if value > joints.high[joint] + slack:
        return AT_HIGH
    if value < joints.low[joint] - slack:
        return AT_LOW
    if mode == STRAINED:
        ahead = value - t.equations.start[row] - joints.speed[joint] * part
        impulse = t.equations.impulse[row]
        if (impulse > 0.0 and ahead > slack) or (impulse < 0.0 and ahead < -slack):
            return DRIVEN
    return mode


def miss_of_mode(t: Tables, joint: int, row: int, part: float, most: float) -> float:
    """By how much the coordinate misses its goal at the end of the part (m or rad).

    What was beyond its limit when the part began comes closer by `most` in the part.
    """
    joints = t.joints
    mode = joints.mode[joint]
    value = t.equations.value[row]
    start = t.equations.start[row]
    if mode == DRIVEN:
        return value - start - joints.speed[joint] * part
    if mode == AT_HIGH:
        high = joints.high[joint]
        return value - high - (left_over(start - high, most) if start > high else 0.0)
    low = joints.low[joint]
    beyond = start < low or mode == FIXED
    return value - low - (left_over(start - low, most) if beyond else 0.0)


def left_over(gap: float, most: float) -> float:
    """What is left at the end of a part of what gaped when it began, if it may close by `most`."""
    if gap > most:
        return gap - most
    return gap + most if gap < -most else 0.0


def bounds(t: Tables, joint: int, effort: float) -> tuple[float, float]:
    """Least and greatest impulse of the coordinate; `effort` is the most that its motor gives."""
    mode = t.joints.mode[joint]
    motor = effort if t.joints.motor[joint] == 1 else 0.0
    if mode == AT_HIGH:
        return -1e300, motor
    if mode == AT_LOW:
        return -motor, 1e300
    if mode in (DRIVEN, STRAINED):
        return -motor, motor
    return -1e300, 1e300


def overstrained(t: Tables, joint: int) -> int:
    """What the coordinate does once its impulse reached a bound."""
    return STRAINED if t.joints.motor[joint] == 1 else FREE_WAY
