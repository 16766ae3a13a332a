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
reaches of the smaller body a second (1/s; angles: rad/s): that would throw the bodies. So do
coordinates that went astray; what winches, servos and hands change is done at once."""

SATISFIED = 1e-8
"""A coordinate is beyond its limit if it is by more, in sizes of the joint or rad."""

BY_HAND = 0.75
"""An angle that hands changed comes back by so much in a part (rad)."""

FARTHEST = 1e300
"""No length is larger."""

BOUNDLESS = 1e300
"""A motor that can do as much has no bounds (N or N m)."""


CLOSES, HOLDS = 1, 2
"""What joints do in a part for which no solution was found (0 if one was): they hold to first
order, and may close gaps or not."""


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
    left = left_beyond(t, joint, row)
    if value > joints.high[joint] + (left if left > 0.0 else 0.0) + slack:
        return AT_HIGH
    if value < joints.low[joint] + (left if left < 0.0 else 0.0) - slack:
        return AT_LOW
    if mode == STRAINED:
        ahead = miss_of_motor(t, joint, row, part)
        if abs(ahead) > slack and is_driven_away(t.equations.impulse[row], ahead):
            return DRIVEN
    return mode


def is_driven_away(impulse: float, ahead: float) -> bool:
    """Whether a strained motor drives what is `ahead` of its goal still further away from it, or
    does nothing.
    """
    return impulse >= 0.0 if ahead > 0.0 else impulse <= 0.0


def miss_of_motor(t: Tables, joint: int, row: int, part: float) -> float:
    """By how much the coordinate is ahead of where its motor wants it at the end of the part."""
    return t.equations.value[row] - t.equations.start[row] - t.joints.speed[joint] * part


def miss_of_mode(t: Tables, joint: int, row: int, part: float) -> float:
    """By how much the coordinate misses its goal at the end of the part (m or rad)."""
    joints = t.joints
    mode = joints.mode[joint]
    value = t.equations.value[row]
    if mode == DRIVEN:
        return miss_of_motor(t, joint, row, part)
    left = left_beyond(t, joint, row)
    if t.braces.sizes[7] > 0:  # what comes to its limit stops at once
        start = t.equations.start[row]
        return value - start + beyond(t, joint, start) - left
    if mode == AT_HIGH:
        return value - joints.high[joint] - (left if left > 0.0 else 0.0)
    return value - joints.low[joint] - (left if left < 0.0 or mode == FIXED else 0.0)


def beyond(t: Tables, joint: int, value: float) -> float:
    """How far beyond its limits a coordinate is (m or rad), negative below the low one."""
    if value > t.joints.high[joint]:
        return value - t.joints.high[joint]
    return value - t.joints.low[joint] if value < t.joints.low[joint] else 0.0


def by_hand(t: Tables, joint: int, row: int) -> float:
    """How far beyond its limits hands, winches and servos put a coordinate when the part began:
    what did not go astray.
    """
    return beyond(t, joint, t.equations.start[row]) - t.joints.astray[joint]


def left_beyond(t: Tables, joint: int, row: int) -> float:
    """How far beyond its limits a coordinate may still be at the end of a part."""
    if t.braces.sizes[7] == HOLDS:
        return beyond(t, joint, t.equations.start[row])
    return left_by_hand(t, joint, row) + left_over(t.joints.astray[joint], t.equations.closes[row])


def left_by_hand(t: Tables, joint: int, row: int) -> float:
    """What is left then of what hands did."""
    return left_over(by_hand(t, joint, row), BY_HAND if is_angle(t, row) else FARTHEST)


def left_gaping(t: Tables, row: int) -> float:
    """What is left at the end of a part of a gap of what is no coordinate (m or rad)."""
    gap = t.equations.start[row]
    return gap if t.braces.sizes[7] == HOLDS else left_over(gap, t.equations.closes[row])


def left_over(gap: float, most: float) -> float:
    """What is left at the end of a part of what gaped when it began, if it may close by `most`."""
    if gap > most:
        return gap - most
    return gap + most if gap < -most else 0.0


def note_start(t: Tables, joint: int, row: int) -> None:
    """Note how much of what is beyond the limits as a part begins went astray in the part before.

    Hands may have brought it back meanwhile.
    """
    past = beyond(t, joint, t.equations.start[row])
    t.joints.astray[joint] = within(t.joints.astray[joint], past)


def note_end(t: Tables, joint: int, row: int, found: bool) -> None:
    """Note by how much the coordinate went astray in a part, for which a solution was found or not:
    what is beyond the limits, unless hands put it there.
    """
    hand = left_by_hand(t, joint, row) if found else by_hand(t, joint, row)
    past = beyond(t, joint, t.equations.value[row])
    t.joints.astray[joint] = within(past - hand, past)


def within(part: float, whole: float) -> float:
    """What of a part lies between nothing and the whole."""
    if whole > 0.0:
        return 0.0 if part < 0.0 else part if part < whole else whole
    return 0.0 if part > 0.0 else part if part > whole else whole


def drives(t: Tables, joint: int, row: int) -> bool:
    """Whether a coordinate does work: as a spring or a motor, or as hands put it beyond a limit."""
    mode = t.joints.mode[joint]
    if mode != FIXED and mode != AT_HIGH and mode != AT_LOW:
        return True
    return abs(by_hand(t, joint, row)) > SATISFIED * scale_of(t, row, joint)


def is_put_back(t: Tables, joint: int, row: int) -> bool:
    """Whether a coordinate was beyond its limits as the part began."""
    past = beyond(t, joint, t.equations.start[row])
    return abs(past) > SATISFIED * scale_of(t, row, joint)


def bounds(t: Tables, joint: int, effort: float) -> tuple[float, float]:
    """Least and greatest impulse of the coordinate; `effort` is the most that its motor gives.

    At a limit, a motor that drives away from it does all that it can, if that is bounded.
    """
    mode = t.joints.mode[joint]
    motor = effort if t.joints.motor[joint] == 1 else 0.0
    away = t.joints.speed[joint] if t.joints.effort[joint] < BOUNDLESS else 0.0
    if mode == AT_HIGH:
        return -1e300, -motor if away < 0.0 else motor
    if mode == AT_LOW:
        return motor if away > 0.0 else -motor, 1e300
    if mode in (DRIVEN, STRAINED):
        return -motor, motor
    return -1e300, 1e300


def overstrained(t: Tables, joint: int) -> int:
    """What the coordinate does once its impulse reached a bound."""
    return STRAINED if t.joints.motor[joint] == 1 else FREE_WAY
