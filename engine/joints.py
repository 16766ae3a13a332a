"""What joins two bodies, or a body and a fixed point: the kinds of joints.

Points are given in the world (m), as things stand at the moment of joining; from then on they move
with their bodies. Each kind raises TypeError or ValueError, in one sentence, for what it is not.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from engine import validate
from engine.validate import shown
from engine.vector import Vector

UNLIMITED = (-math.inf, math.inf)

STRONGEST = 1e300
"""Stands for a motor without limit (N or N m)."""


@dataclass(frozen=True)
class _Line:
    """What rods and ropes have in common: two points and a length."""

    anchor_a: Any = None
    anchor_b: Any = None
    length: float | None = None

    def __post_init__(self) -> None:
        """Refuse what is no point or no length."""
        _check_anchors(self)
        _check(self, "length", validate.positive)


@dataclass(frozen=True)
class Distance(_Line):
    """A massless rod: keeps two points at a distance.

    Args:
        anchor_a: point of a (m, world); None: its centre.
        anchor_b: the same of b.
        length: (m); None: as far as the two points are apart.
    """


@dataclass(frozen=True)
class Rope(_Line):
    """A rope without mass: two points are never further apart than its length.

    Args:
        anchor_a: point of a (m, world); None: its centre.
        anchor_b: the same of b.
        length: (m); None: as far as the two points are apart.
    """


@dataclass(frozen=True)
class Spring:
    """A damped spring: pulls with k times its extension, brakes with c times its rate.

    Args:
        stiffness: k (N/m).
        damping: c (N s/m).
        anchor_a: point of a (m, world); None: its centre.
        anchor_b: the same of b.
        length: at rest (m); None: as far as the two points are apart.
    """

    stiffness: float
    damping: float = 0.0
    anchor_a: Any = None
    anchor_b: Any = None
    length: float | None = None

    def __post_init__(self) -> None:
        """Refuse what is no point or no number."""
        _check_anchors(self)
        _check(self, "stiffness", validate.not_negative)
        _check(self, "damping", validate.not_negative)
        _check(self, "length", validate.not_negative)
        check_spring(self.stiffness, self.damping)


@dataclass(frozen=True)
class Pin:
    """A hinge: the bodies turn about a common point.

    Angles are those of b less those of a, zero at the moment of joining.

    Args:
        at: the common point (m, world).
        limits: least and greatest angle (rad); None: none.
        motor_speed: with which a motor turns b against a (rad/s); 0: a brake; None: no motor.
        max_torque: of the motor (N m).
    """

    at: Any
    limits: Any = None
    motor_speed: float | None = None
    max_torque: float = math.inf

    def __post_init__(self) -> None:
        """Refuse what is no point, no limits or no motor."""
        object.__setattr__(self, "at", validate.vector(self.at, "at"))
        _check_coordinate(self, "max_torque")


@dataclass(frozen=True)
class Weld:
    """Makes two bodies one.

    Args:
        at: where the force acts (m, world); None: halfway between their centres.
    """

    at: Any = None

    def __post_init__(self) -> None:
        """Refuse what is no point."""
        _check(self, "at", validate.vector)


@dataclass(frozen=True)
class Slider:
    """A rail: b slides along an axis of a and does not turn against it.

    Args:
        axis: direction of the rail (world); its length does not matter.
        at: the point of b that stays on the rail (m, world); None: the centre of b.
        limits: least and greatest way along the axis (m), zero at the moment of joining; None:
            none.
        motor_speed: with which a motor drives b along the axis (m/s); 0: a brake; None: no motor.
        max_force: of the motor (N).
    """

    axis: Any
    at: Any = None
    limits: Any = None
    motor_speed: float | None = None
    max_force: float = math.inf

    def __post_init__(self) -> None:
        """Refuse what is no axis, no point, no limits or no motor."""
        axis = validate.vector(self.axis, "axis")
        largest = max(abs(axis.x), abs(axis.y))
        if largest == 0.0:
            raise ValueError(f"axis must have a direction, not {tuple(axis)}")
        way = Vector(axis.x / largest, axis.y / largest)  # so that no square is out of range
        object.__setattr__(self, "axis", way.normalized())
        _check(self, "at", validate.vector)
        _check_coordinate(self, "max_force")


@dataclass(frozen=True)
class Pulley:
    """A string over two fixed points of the world that pulls on both bodies.

    It keeps |anchor_a - over_a| + ratio |anchor_b - over_b| from becoming longer than `length`.

    Args:
        over_a: fixed point over which a hangs (m, world).
        over_b: the same of b.
        anchor_a: point of a (m, world); None: its centre.
        anchor_b: the same of b.
        ratio: 2 for a block and tackle that halves the force on a.
        length: (m); None: as long as it is at the moment of joining.
    """

    over_a: Any
    over_b: Any
    anchor_a: Any = None
    anchor_b: Any = None
    ratio: float = 1.0
    length: float | None = None

    def __post_init__(self) -> None:
        """Refuse what is no point or no number."""
        object.__setattr__(self, "over_a", validate.vector(self.over_a, "over_a"))
        object.__setattr__(self, "over_b", validate.vector(self.over_b, "over_b"))
        _check_anchors(self)
        object.__setattr__(self, "ratio", validate.positive(self.ratio, "ratio"))
        _check(self, "length", validate.positive)


KINDS = (Distance, Rope, Spring, Pin, Weld, Slider, Pulley)

Spec = Distance | Rope | Spring | Pin | Weld | Slider | Pulley
"""What can be handed to `World.join`."""


def _check(spec: Any, name: str, check: Callable[[Any, str], Any]) -> None:
    """Check a field that may be None."""
    value = getattr(spec, name)
    if value is not None:
        object.__setattr__(spec, name, check(value, name))


def _check_anchors(spec: Any) -> None:
    _check(spec, "anchor_a", validate.vector)
    _check(spec, "anchor_b", validate.vector)


def _check_coordinate(spec: Any, effort: str) -> None:
    """Check limits and motor."""
    _check(spec, "limits", lambda value, _: check_limits(value))
    _check(spec, "motor_speed", validate.finite)
    object.__setattr__(spec, effort, validate.positive_or_endless(getattr(spec, effort), effort))


def check_spring(stiffness: float, damping: float) -> None:
    """Refuse a spring that does nothing."""
    if stiffness == 0.0 and damping == 0.0:
        raise ValueError("a spring needs a stiffness or a damping, not 0.0 for both")


def check_limits(value: Any) -> tuple[float, float]:
    """Return a pair (low, high); either may be infinite."""
    if not isinstance(value, tuple | list) and getattr(value, "ndim", 0) != 1:
        raise TypeError(f"limits must be a pair (low, high), not {shown(value)}")
    if len(value) != 2:
        raise ValueError(f"limits must be a pair (low, high), not {len(value)} of them")
    low, high = (
        float(end) if isinstance(end, float) and end in UNLIMITED else validate.finite(end, name)
        for end, name in zip(value, ("limits[0]", "limits[1]"), strict=True)
    )
    if low > high or low == math.inf or high == -math.inf:
        raise ValueError(f"limits must be a pair (low, high), not ({low}, {high})")
    return low, high
