"""How a new joint gets into the tables: where it holds its bodies, and what it keeps."""

import math
from typing import TYPE_CHECKING

from engine import validate
from engine.joints import KINDS, STRONGEST, UNLIMITED, Pin, Pulley, Rope, Slider, Spec, Spring, Weld
from engine.validate import shown
from engine.vector import Vector, distance, rotated

if TYPE_CHECKING:
    from engine.body import Body


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
        raise TypeError(f"bodies are joined by a Pin, Rope, Spring, ..., not {shown(spec)}")
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
        "size": min(body._world.bodies.reach[body._row()] for body in free),
        "rest_angle": (b.angle if b else 0.0) - (a.angle if a else 0.0),
        "break_force": _strength(break_force, "break_force"),
        "break_torque": _strength(break_torque, "break_torque"),
    }  # fmt: skip
    values["a_x"], values["a_y"] = a.to_local(start) if a else start
    values["b_x"], values["b_y"] = b.to_local(end) if b else end
    return values | _own(a, spec, start, end)


def _own(a: "Body | None", spec: Spec, start: Vector, end: Vector) -> dict[str, float]:
    """The columns of one kind of joint."""
    far = distance(start, end)
    if isinstance(spec, Pin | Slider):
        low, high = spec.limits or UNLIMITED
        most = spec.max_torque if isinstance(spec, Pin) else spec.max_force
        own: dict[str, float] = {"low": low, "high": high, "effort": min(most, STRONGEST)}
        if spec.motor_speed is not None:
            own |= {"motor": 1, "speed": spec.motor_speed}
        if isinstance(spec, Slider):
            angle = a.angle if a else 0.0
            axis = rotated(spec.axis, -angle)
            own |= {"axis_x": axis.x, "axis_y": axis.y}
        return own
    if isinstance(spec, Weld):
        return {"low": 0.0, "high": 0.0}
    if isinstance(spec, Pulley):
        length = distance(start, spec.over_a) + spec.ratio * distance(end, spec.over_b)
        length = length if spec.length is None else spec.length
        over = {"over_a_x": spec.over_a.x, "over_a_y": spec.over_a.y}
        over |= {"over_b_x": spec.over_b.x, "over_b_y": spec.over_b.y}
        return {"low": -math.inf, "high": length, "ratio": spec.ratio} | over
    length = far if spec.length is None else spec.length
    if length == 0.0 and not isinstance(spec, Spring):
        raise ValueError(
            f"a {type(spec).__name__} needs a length, as both ends are at {tuple(start)}"
        )
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
