"""The handle by which people hold a joint. It has no state of its own: the world's tables do."""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from engine import validate
from engine.inputs import noted
from engine.joints import (
    KINDS,
    STRONGEST,
    UNLIMITED,
    Distance,
    Pin,
    Pulley,
    Rope,
    Slider,
    Spec,
    Spring,
    Weld,
    check_limits,
    check_spring,
)
from engine.vector import Vector, rotated

if TYPE_CHECKING:
    from engine.body import Body
    from engine.world import World

OnBreak = Callable[["Joint"], None]


class Joint:
    """A joint of a world, made by `World.join`. It has no state of its own: the tables do.

    `on_break(joint)` is called after the step in which it broke.
    """

    __slots__ = ("_a", "_b", "_id", "_on_break", "_world")

    def __init__(self, world: "World", id: int, a: "Body | None", b: "Body | None") -> None:
        """Made by `World.join`; None is the world itself."""
        self._world = world
        self._id = id
        self._a = a
        self._b = b
        self._on_break: OnBreak | None = None

    def __repr__(self) -> str:
        """Say what it joins and what it is."""
        names = [body.name if body else "the world" for body in (self.a, self.b)]
        kind = self.kind.__name__ if self in self._world.joints else "removed"
        return f"<Joint {self.id}, {' to '.join(names)}: {kind}>"

    def __reduce__(self) -> Any:
        """Copy and pickle it with its world, as the joint of this id."""
        return type(self._world).joint, (self._world, self._id)

    @property
    def id(self) -> int:
        """By which the world knows it; none is used twice."""
        return self._id

    @property
    def a(self) -> "Body | None":
        """One body; None: the world."""
        return self._a

    @property
    def b(self) -> "Body | None":
        """The other, whose force `force` is; None: the world."""
        return self._b

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
            axis = rotated((self._get("axis_x"), self._get("axis_y")), angle)
            return float(x * axis.x + y * axis.y)
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
    def max_torque(self) -> float:
        """Of the motor of a pin (N m), may be infinite."""
        return self._effort(Pin, "max_torque")

    @max_torque.setter
    @noted
    def max_torque(self, value: Any) -> None:
        self._drive(Pin, "max_torque", value)

    @property
    def max_force(self) -> float:
        """Of the motor of a slider (N), may be infinite."""
        return self._effort(Slider, "max_force")

    @max_force.setter
    @noted
    def max_force(self, value: Any) -> None:
        self._drive(Slider, "max_force", value)

    @property
    def stiffness(self) -> float:
        """Of a spring (N/m)."""
        self._only((Spring,), "stiffness")
        return float(self._get("stiffness"))

    @stiffness.setter
    @noted
    def stiffness(self, value: Any) -> None:
        self._only((Spring,), "stiffness")
        new = validate.not_negative(value, "stiffness")
        check_spring(new, self.damping)
        self._set("stiffness", new)
        self._world.store.loosen()

    @property
    def damping(self) -> float:
        """Of a spring (N s/m)."""
        self._only((Spring,), "damping")
        return float(self._get("damping"))

    @damping.setter
    @noted
    def damping(self, value: Any) -> None:
        self._only((Spring,), "damping")
        new = validate.not_negative(value, "damping")
        check_spring(self.stiffness, new)
        self._set("damping", new)
        self._world.store.loosen()

    @noted
    def remove(self) -> None:
        """Take it out of the world; it is then refused."""
        self._world.store.remove_joint(self)

    def _effort(self, kind: type, name: str) -> float:
        self._only((kind,), name)
        most = float(self._get("effort"))
        return math.inf if most == STRONGEST else most

    def _drive(self, kind: type, name: str, value: Any) -> None:
        self._only((kind,), name)
        self._set("effort", min(validate.positive_or_endless(value, name), STRONGEST))
        self._world.store.loosen()

    def _only(self, kinds: tuple[type, ...], what: str) -> None:
        if self.kind not in kinds:
            raise ValueError(f"a {self.kind.__name__} has no {what}")

    def _get(self, column: str) -> Any:
        return getattr(self._world.tables.joints, column)[self._world.store.row_of_joint(self)]

    def _set(self, column: str, value: float) -> None:
        getattr(self._world.tables.joints, column)[self._world.store.row_of_joint(self)] = value
