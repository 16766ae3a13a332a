"""What joins two bodies, or a body and a fixed point: the kinds of joints, and their handle."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from engine import validate
from engine.inputs import noted
from engine.vector import Vector

if TYPE_CHECKING:
    from engine.body import Body
    from engine.world import World

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
    """A massless rod: keeps the distance of two points.

    Anchors are points of the world (m) at the moment of joining, None the centre of a body; from
    then on they move with their bodies. Length (m), None: as they are.
    """


@dataclass(frozen=True)
class Rope(_Line):
    """A rope without mass: two points are never further apart than its length (m)."""


@dataclass(frozen=True)
class Spring:
    """A damped spring: pulls with stiffness (N/m) times extension, brakes with damping (N s/m)."""

    stiffness: float
    damping: float = 0.0
    anchor_a: Any = None
    anchor_b: Any = None
    length: float | None = None
    """At rest (m); None: as it is."""

    def __post_init__(self) -> None:
        """Refuse what is no point or no number."""
        _check_anchors(self)
        _check(self, "stiffness", validate.not_negative)
        _check(self, "damping", validate.not_negative)
        _check(self, "length", validate.not_negative)
        if self.stiffness == 0.0 and self.damping == 0.0:
            raise ValueError("a spring needs a stiffness or a damping, not 0.0 for both")


@dataclass(frozen=True)
class Pin:
    """A hinge: the bodies turn about a common point.

    Limits (rad) are of the angle of b less that of a, zero at the moment of joining. A motor turns
    b against a at `motor_speed` (rad/s) with at most `max_torque` (N m).
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
    """Makes two bodies one; without a point, the force acts halfway between their centres."""

    at: Any = None

    def __post_init__(self) -> None:
        """Refuse what is no point."""
        _check(self, "at", validate.vector)


@dataclass(frozen=True)
class Slider:
    """A rail: b slides along an axis of a and does not turn against it.

    Limits (m) are of the way along the axis, zero at the moment of joining. A motor drives b along
    the axis at `motor_speed` (m/s) with at most `max_force` (N).
    """

    axis: Any
    at: Any = None
    limits: Any = None
    motor_speed: float | None = None
    max_force: float = math.inf

    def __post_init__(self) -> None:
        """Refuse what is no axis, no point, no limits or no motor."""
        axis = validate.vector(self.axis, "axis")
        length = math.hypot(axis.x, axis.y)
        if not 0.0 < length < math.inf:
            raise ValueError(f"axis must have a direction, not {tuple(axis)}")
        object.__setattr__(self, "axis", Vector(axis.x / length, axis.y / length))
        _check(self, "at", validate.vector)
        _check_coordinate(self, "max_force")


@dataclass(frozen=True)
class Pulley:
    """A string over two fixed points of the world (m) that pulls on both bodies.

    It keeps |anchor_a - over_a| + ratio |anchor_b - over_b| from becoming longer than `length`; a
    block and tackle that halves the force on a has the ratio 2.
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
        _check(self, "ratio", validate.positive)
        _check(self, "length", validate.positive)


KINDS = (Distance, Rope, Spring, Pin, Weld, Slider, Pulley)

Spec = Distance | Rope | Spring | Pin | Weld | Slider | Pulley
"""What can be handed to `World.join`."""

OnBreak = Callable[["Joint"], None]


class Joint:
    """A joint of a world, made by `World.join`. It has no state of its own: the tables do.

    `on_break(joint)` is called after the step in which it broke.
    """

    __slots__ = ("_on_break", "_world", "a", "b", "id")

    def __init__(self, world: "World", id: int, a: "Body | None", b: "Body | None") -> None:
        """Made by `World.join`; None is the world itself."""
        self._world = world
        self.id = id
        self.a = a
        self.b = b
        self._on_break: OnBreak | None = None

    def __repr__(self) -> str:
        """Say what it is and what it joins."""
        names = [body.name if body else "the world" for body in (self.a, self.b)]
        return f"<Joint {self.id}, {' to '.join(names)}>"

    @property
    def on_break(self) -> OnBreak | None:
        """Called with this joint after the step in which it broke."""
        return self._on_break

    @on_break.setter
    def on_break(self, function: OnBreak | None) -> None:
        self._on_break = validate.function_or_none(function, "on_break")

    @property
    def kind(self) -> type[Spec]:
        """`Pin`, `Rope`, ..."""
        return KINDS[self._get("kind")]

    @property
    def force(self) -> Vector:
        """What it exerted on b in the last tick, as the mean (N); on a the opposite.

        A pulley exerts on a what its string does there, which is not the opposite.
        """
        return Vector(self._get("force_x"), self._get("force_y"))

    @property
    def torque(self) -> float:
        """What it exerted on b about the anchor in the last tick, as the mean (N m)."""
        torque: float = self._get("torque")
        return torque

    @property
    def broken(self) -> bool:
        """Whether it gave way under its load; it then acts no more."""
        return bool(self._get("broken"))

    @property
    def anchors(self) -> tuple[Vector, Vector]:
        """Where it holds a and b now (m, world)."""
        at_a = Vector(self._get("a_x"), self._get("a_y"))
        at_b = Vector(self._get("b_x"), self._get("b_y"))
        return (
            self.a.to_world(at_a) if self.a else at_a,
            self.b.to_world(at_b) if self.b else at_b,
        )

    @property
    def coordinate(self) -> float:
        """Angle of a pin or weld (rad), travel of a slider, length of any other (m)."""
        start, end = self.anchors
        x, y = end.x - start.x, end.y - start.y
        if self.kind in (Pin, Weld):
            turned = [body.angle if body else 0.0 for body in (self.a, self.b)]
            return turned[1] - turned[0] - float(self._get("rest_angle"))
        if self.kind is Slider:
            angle = self.a.angle if self.a else 0.0
            cos, sin = math.cos(angle), math.sin(angle)
            along, across = self._get("axis_x"), self._get("axis_y")
            return float(x * (cos * along - sin * across) + y * (sin * along + cos * across))
        if self.kind is Pulley:
            a_x, a_y = start.x - self._get("over_a_x"), start.y - self._get("over_a_y")
            b_x, b_y = end.x - self._get("over_b_x"), end.y - self._get("over_b_y")
            return math.sqrt(a_x * a_x + a_y * a_y) + float(self._get("ratio")) * math.sqrt(
                b_x * b_x + b_y * b_y
            )
        return math.sqrt(x * x + y * y)

    @property
    def length(self) -> float:
        """Of a rod, rope, spring at rest, or string (m); may be set, as by a winch."""
        self._only((Distance, Rope, Spring, Pulley), "length")
        return float(self._get("high"))

    @length.setter
    @noted
    def length(self, value: Any) -> None:
        self._only((Distance, Rope, Spring, Pulley), "length")
        check = validate.not_negative if self.kind is Spring else validate.positive
        new = check(value, "length")
        if self.kind in (Distance, Spring):
            self._set("low", new)
        self._set("high", new)

    @property
    def limits(self) -> tuple[float, float] | None:
        """Of the coordinate of a pin (rad) or slider (m); None: unlimited."""
        self._only((Pin, Slider), "limits")
        pair = (float(self._get("low")), float(self._get("high")))
        return None if pair == UNLIMITED else pair

    @limits.setter
    @noted
    def limits(self, value: Any) -> None:
        self._only((Pin, Slider), "limits")
        low, high = UNLIMITED if value is None else check_limits(value)
        self._set("low", low)
        self._set("high", high)
        self._world.store.loosen()

    @property
    def motor_speed(self) -> float | None:
        """Speed that the motor of a pin (rad/s) or slider (m/s) wants; None: it is off."""
        self._only((Pin, Slider), "motor")
        return float(self._get("speed")) if self._get("motor") else None

    @motor_speed.setter
    @noted
    def motor_speed(self, value: Any) -> None:
        self._only((Pin, Slider), "motor")
        self._set("speed", 0.0 if value is None else validate.finite(value, "motor_speed"))
        self._set("motor", int(value is not None))
        self._world.store.loosen()

    @property
    def stiffness(self) -> float:
        """Of a spring (N/m)."""
        self._only((Spring,), "stiffness")
        return float(self._get("stiffness"))

    @property
    def damping(self) -> float:
        """Of a spring (N s/m)."""
        self._only((Spring,), "damping")
        return float(self._get("damping"))

    @noted
    def remove(self) -> None:
        """Take it out of the world; it is then refused."""
        self._world.store.remove_joint(self)

    def _only(self, kinds: tuple[type, ...], what: str) -> None:
        if self.kind not in kinds:
            raise ValueError(f"a {self.kind.__name__} has no {what}")

    def _get(self, column: str) -> Any:
        return getattr(self._world.tables.joints, column)[self._world.store.row_of_joint(self)]

    def _set(self, column: str, value: float) -> None:
        getattr(self._world.tables.joints, column)[self._world.store.row_of_joint(self)] = value


def joint_columns(
    a: "Body | None",
    b: "Body | None",
    spec: Spec,
    break_force: float | None,
    break_torque: float | None,
) -> dict[str, float]:
    """What was given for a new joint, as columns of the table `Joints`.

    Raises:
        TypeError, ValueError: in one sentence that names the value.
    """
    if not isinstance(spec, KINDS):
        raise TypeError(f"bodies are joined by a Pin, Rope, Spring, ..., not {spec!r}")
    if a is b:
        raise ValueError(f"{a.name if a else 'the world'} cannot be joined with itself")
    if isinstance(spec, Pulley) and (a is None or b is None):
        raise ValueError("a Pulley joins two bodies: it has its own fixed points")
    free = [body for body in (a, b) if body is not None and math.isfinite(body.mass)]
    if not free:
        raise ValueError("one of the two that are joined must be movable")
    start, end = _anchors(a, b, spec)
    values: dict[str, float] = {
        "kind": KINDS.index(type(spec)), "a": a.id if a else 0, "b": b.id if b else 0,
        "ratio": 1.0, "effort": STRONGEST,
        "size": min(body._world.bodies.reach[body._world.row(body)] for body in free),
        "rest_angle": (b.angle if b else 0.0) - (a.angle if a else 0.0),
        "break_force": _strength(break_force, "break_force"),
        "break_torque": _strength(break_torque, "break_torque"),
    }  # fmt: skip
    values["a_x"], values["a_y"] = a.to_local(start) if a else start
    values["b_x"], values["b_y"] = b.to_local(end) if b else end
    return values | _own(a, spec, start, end)


def _own(a: "Body | None", spec: Spec, start: Vector, end: Vector) -> dict[str, float]:
    """The columns of one kind of joint."""
    far = math.dist(start, end)
    if isinstance(spec, Pin | Slider):
        low, high = spec.limits or UNLIMITED
        most = spec.max_torque if isinstance(spec, Pin) else spec.max_force
        own: dict[str, float] = {"low": low, "high": high, "effort": min(most, STRONGEST)}
        if spec.motor_speed is not None:
            own |= {"motor": 1, "speed": spec.motor_speed}
        if isinstance(spec, Slider):
            angle = a.angle if a else 0.0
            cos, sin = math.cos(angle), math.sin(angle)
            x, y = spec.axis
            own |= {"axis_x": cos * x + sin * y, "axis_y": cos * y - sin * x}
        return own
    if isinstance(spec, Weld):
        return {"low": 0.0, "high": 0.0}
    if isinstance(spec, Pulley):
        length = math.dist(start, spec.over_a) + spec.ratio * math.dist(end, spec.over_b)
        length = length if spec.length is None else spec.length
        over = {"over_a_x": spec.over_a.x, "over_a_y": spec.over_a.y}
        over |= {"over_b_x": spec.over_b.x, "over_b_y": spec.over_b.y}
        return {"low": -math.inf, "high": length, "ratio": spec.ratio} | over
    length = far if spec.length is None else spec.length
    if length == 0.0 and not isinstance(spec, Spring):
        raise ValueError(f"a {type(spec).__name__} needs a length, as both ends are at {start}")
    if isinstance(spec, Rope):
        return {"low": -math.inf, "high": length}
    own = {"low": length, "high": length}
    if isinstance(spec, Spring):
        own |= {"stiffness": spec.stiffness, "damping": spec.damping}
    return own


def _anchors(a: "Body | None", b: "Body | None", spec: Spec) -> tuple[Vector, Vector]:
    """Where the joint holds a and b (m, world)."""
    if isinstance(spec, Pin | Weld | Slider):
        if spec.at is not None:
            return spec.at, spec.at
        centres = [body.position for body in (a, b) if body is not None]
        if isinstance(spec, Slider):
            return centres[-1], centres[-1]
        x = sum(centre.x for centre in centres) / len(centres)
        y = sum(centre.y for centre in centres) / len(centres)
        return Vector(x, y), Vector(x, y)
    ends = []
    for body, at, name in ((a, spec.anchor_a, "anchor_a"), (b, spec.anchor_b, "anchor_b")):
        if at is None and body is None:
            raise ValueError(f"a {type(spec).__name__} with the world needs its {name}")
        ends.append(body.position if at is None and body is not None else at)
    return ends[0], ends[1]


def _strength(value: float | None, name: str) -> float:
    return math.inf if value is None else validate.positive(value, name)


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
    if getattr(spec, effort) != math.inf:
        _check(spec, effort, validate.positive)


def check_limits(value: Any) -> tuple[float, float]:
    """Return a pair (low, high); either may be infinite."""
    if isinstance(value, str) or not isinstance(value, tuple | list):
        raise TypeError(f"limits must be a pair (low, high), not {value!r}")
    if len(value) != 2:
        raise ValueError(f"limits must be a pair (low, high), not {len(value)} of them")
    low, high = (
        float(end) if end in UNLIMITED else validate.finite(end, f"limits[{i}]")
        for i, end in enumerate(value)
    )
    if low > high or low == math.inf or high == -math.inf:
        raise ValueError(f"limits must be a pair (low, high), not ({low}, {high})")
    return low, high
