"""How a new body, or a saved one, gets into the tables."""

import math
from typing import Any

from engine import filters, materials, validate
from engine.kernels.pose import put
from engine.shapes import ORIGIN, Barrier, Particle, Piece, Shape
from engine.tables import Corners, Tables, start_row
from engine.validate import shown

HUGE = 1e100
"""Masses (kg) and moments of inertia (kg m^2) lie between this and its inverse."""

KINDS = ("dynamic", "kinematic", "static")
"""What moves a body: forces and impulses; nothing but its own velocity; nothing at all."""

ENDLESS = {"mass": math.inf, "inverse_mass": 0.0, "inertia": math.inf, "inverse_inertia": 0.0}
"""Columns of bodies that no force moves."""

WALL = "a wall is immovable: it takes no"


def initial_values(shape: Shape, given: dict[str, Any]) -> dict[str, float]:
    """Check what was given for a new body; return it as columns of `Bodies`.

    Args:
        shape: of the body.
        given: all that `World.add` takes but names and functions, by its names.
    """
    kind = "dynamic" if given["kind"] is None else given["kind"]
    if not isinstance(kind, str) or kind not in KINDS:
        raise ValueError(f"kind must be one of {', '.join(KINDS)}, not {shown(kind)}")
    if isinstance(shape, Barrier):
        _refuse(given, ("mass", "position", "angle", "velocity", "spin", "inertia"), WALL)
        if given["kind"] not in (None, "static"):
            raise ValueError(f"{WALL} kind {shown(kind)}")
        kind = "static"
    elif isinstance(shape, Particle):
        _refuse(given, ("inertia",), "a particle never rotates: it takes no")
    fixed = validate.truth(given["fixed_rotation"], "fixed_rotation")
    if fixed:
        _refuse(given, ("inertia",), "a body of fixed rotation takes no")
    if kind != "dynamic":
        _refuse(given, ("mass", "inertia"), f"a {kind} body has infinite mass: it takes no")
        if fixed:
            raise ValueError(f"forces turn no {kind} body: it takes no fixed_rotation")
    if kind == "static":
        _refuse(given, ("velocity", "spin"), "a static body does not move: it takes no")
    values = {
        "restitution": validate.fraction(given["restitution"], "restitution"),
        **_rubbing(given),
        "gravity_scale": validate.finite(given["gravity_scale"], "gravity_scale"),
        "sensor": int(validate.truth(given["sensor"], "sensor")),
        "category": filters.category_bits(given["category"]),
        "mask": filters.mask_bits(given["mask"]),
        "group": filters.group_number(given["group"]),
        "moves": int(kind != "static"),
        **_inertness(shape, kind, given["mass"], given["inertia"], fixed),
        **_motion(given["position"], given["angle"], given["velocity"], given["spin"]),
    }
    if values["spin"] != 0.0 and (fixed or isinstance(shape, Particle)):
        who = "a body of fixed rotation" if fixed else "a particle"
        raise ValueError(f"{who} never rotates: it takes no spin {values['spin']}")
    return values


def _rubbing(given: dict[str, Any]) -> dict[str, float]:
    """Friction, rolling resistance, surface speed and material, as columns of `Bodies`."""
    friction = validate.not_negative(given["friction"], "friction")
    rolling = validate.not_negative(given["rolling_resistance"], "rolling_resistance")
    return {
        "friction": friction,
        "static_friction": materials.resistance(given["static_friction"], friction),
        "rolling_resistance": rolling,
        "surface_speed": validate.finite(given["surface_speed"], "surface_speed"),
        "material": materials.number_or_none(given["material"]),
    }


def _refuse(given: dict[str, Any], names: tuple[str, ...], sentence: str) -> None:
    for name in names:
        if given[name] is not None:
            raise ValueError(f"{sentence} {name} {given[name]}")


def write_body(
    t: Tables,
    pieces: tuple[Piece, ...],
    id: int,
    row: int,
    piece: int,
    corner: int,
    values: dict[str, float],
) -> None:
    """Write a new body to `row`, its pieces from row `piece` on, their corners from `corner` on."""
    b = t.bodies
    start_row(b, row)
    b.id[row], b.first[row], b.first_piece[row], b.pieces[row] = id, corner, piece, len(pieces)
    for name, value in values.items():
        getattr(b, name)[row] = value
    for each in pieces:
        write_piece(t, each, row, piece, corner)
        piece, corner = piece + 1, corner + len(each.corners)
    b.reach[row] = max(each.measures.outer for each in pieces)
    b.corners[row] = corner - b.first[row]
    put(b, t.corners, row, b.x[row], b.y[row], b.angle[row])


def write_piece(t: Tables, shape: Piece, body: int, row: int, corner: int) -> None:
    """Write a convex piece of the body in row `body` to `row`, its corners from `corner` on."""
    p, points, measures = t.pieces, shape.corners, shape.measures
    p.body[row], p.first[row], p.corners[row] = body, corner, len(points)
    p.radius[row], p.one_sided[row] = shape.radius, int(shape.one_sided)
    p.before[row], p.after[row] = shape.before, shape.after
    p.seams[row] = int(bool(shape.seams))
    p.x[row], p.y[row] = shape.center
    p.reach[row] = measures.outer if shape.center == ORIGIN else shape.reach
    p.swing[row] = 0.0 if points == (ORIGIN,) else measures.outer
    p.inner[row] = measures.inner
    c = t.corners
    for k, (point, normal) in enumerate(zip(points, measures.normals, strict=True), start=corner):
        c.x[k], c.y[k] = point
        c.normal_x[k], c.normal_y[k] = normal
        c.kind[k] = 0
        c.low_x[k] = c.low_y[k] = c.high_x[k] = c.high_y[k] = 0.0
        c.cover_start[k], c.cover_end[k] = 0.0, -1.0
    write_seams(c, shape, corner)


def write_seams(c: Corners, shape: Piece, row: int) -> None:
    """Write what is a piece's own of its corners and sides, from `row` on."""
    for k, seam in enumerate(shape.seams, start=row):
        c.kind[k] = seam.kind
        c.low_x[k], c.low_y[k] = seam.low
        c.high_x[k], c.high_y[k] = seam.high
        c.cover_start[k], c.cover_end[k] = seam.start, seam.end


def _inertness(
    shape: Shape, kind: str, mass: float | None, inertia: float | None, fixed: bool
) -> dict[str, float]:
    """Mass, moment of inertia and their inverses, as columns of `Bodies`."""
    if kind != "dynamic" or isinstance(shape, Barrier):
        return ENDLESS
    kg = 1.0 if mass is None else _finite(mass, "mass", 'kind="kinematic" or "static"')
    if fixed:
        return inertness(shape, kg, math.inf)
    turning = shape.inertia(kg)
    if inertia is not None:
        turning = _finite(inertia, "inertia", "fixed_rotation=True")
    return inertness(shape, kg, turning, isinstance(shape, Particle))


def _finite(value: Any, name: str, instead: str) -> float:
    """Refuse what is not positive; who wants an infinite one is told what to give instead."""
    if validate.is_endless(value):
        raise ValueError(f"{name} must be finite, not inf: give {instead} instead")
    return validate.positive(value, name)


def inertness(shape: Shape, kg: float, turning: float, endless: bool = True) -> dict[str, float]:
    """Mass (kg), moment of inertia (kg m^2) and their inverses of a dynamic body, as columns.

    That of what never rotates is `endless`.

    Raises:
        ValueError: if they are beyond what can be computed.
    """
    turns = turning <= HUGE or (endless and turning == math.inf)
    if not (1.0 / HUGE <= kg <= HUGE and turning >= 1.0 / HUGE and turns):
        raise ValueError(
            f"{shape} with a mass of {kg} kg and a moment of inertia of {turning} kg m^2 is beyond "
            f"what can be computed, {1.0 / HUGE} to {HUGE}"
        )
    return {
        "mass": kg, "inverse_mass": 1.0 / kg, "inertia": turning, "inverse_inertia": 1.0 / turning,
    }  # fmt: skip


def _motion(position: Any, angle: Any, velocity: Any, spin: Any) -> dict[str, float]:
    """Pose and motion, as columns of `Bodies`."""
    nowhere = (0.0, 0.0)
    x, y = validate.vector(nowhere if position is None else position, "position")
    vx, vy = validate.vector(nowhere if velocity is None else velocity, "velocity")
    turned = validate.finite(0.0 if angle is None else angle, "angle")
    turning = validate.finite(0.0 if spin is None else spin, "spin")
    return {"x": x, "y": y, "vx": vx, "vy": vy, "angle": turned, "spin": turning}
