"""How a new body, or a saved one, gets into the tables."""

import math
from typing import Any

from engine import validate
from engine.shapes import Particle, Polygon, Shape, Wall
from engine.tables import Tables, grow, views
from engine.vector import Vector

HUGE = 1e100
"""Masses (kg) and moments of inertia (kg m^2) lie between this and its inverse."""


def initial_values(shape: Shape, given: dict[str, Any]) -> dict[str, float]:
    """Check what was given for a new body; return it as columns of `Bodies`.

    Args:
        shape: of the body.
        given: mass, inertia, position, angle, velocity, spin (each None if not given),
            restitution and friction.
    """
    kinematic = ("mass", "position", "angle", "velocity", "spin", "inertia")
    if isinstance(shape, Wall):
        for what in kinematic:
            if given[what] is not None:
                raise ValueError(f"a wall is immovable: it takes no {what} {given[what]}")
    elif isinstance(shape, Particle) and (given["inertia"] is not None or given["spin"]):
        raise ValueError("a particle never rotates: it takes no inertia and no spin")
    return {
        "restitution": validate.fraction(given["restitution"], "restitution"),
        "friction": validate.not_negative(given["friction"], "friction"),
        **_inertness(shape, given["mass"], given["inertia"]),
        **_motion(given["position"], given["angle"], given["velocity"], given["spin"]),
    }


def write_body(
    t: Tables, shape: Shape, id: int, row: int, corner: int, values: dict[str, float]
) -> tuple[Tables, int]:
    """Write a new body to `row`, its corners from row `corner` on; return tables and next corner.

    Tables that are full are replaced by larger ones.
    """
    points = corner_points(shape)
    if row == len(t.bodies.id):
        t = t._replace(bodies=views(grow(t.bodies, 2 * row)))
    while corner + len(points) > len(t.corners.x):
        t = t._replace(corners=views(grow(t.corners, 2 * len(t.corners.x))))
    b, c = t.bodies, t.corners
    for column in b:
        column[row] = 0
    b.id[row], b.first[row], b.corners[row], b.order[row] = id, corner, len(points), row
    for name, value in values.items():
        getattr(b, name)[row] = value
    b.radius[row] = getattr(shape, "radius", 0.0)
    b.reach[row] = b.radius[row] + max(math.dist(p, (0.0, 0.0)) for p in points)
    b.one_sided[row] = int(isinstance(shape, Wall) and shape.one_sided)
    inner = math.inf
    for i, start in enumerate(points):
        k, end = corner + i, points[(i + 1) % len(points)]
        x, y = end.x - start.x, end.y - start.y
        length = math.sqrt(x * x + y * y) or 1.0
        c.x[k], c.y[k] = c.world_x[k], c.world_y[k] = start
        c.normal_x[k], c.normal_y[k] = y / length, -x / length
        c.world_normal_x[k], c.world_normal_y[k] = c.normal_x[k], c.normal_y[k]
        inner = min(inner, (start.x * y - start.y * x) / length)
    b.inner[row] = inner if isinstance(shape, Polygon) else b.radius[row]
    return t, corner + len(points)


def corner_points(shape: Shape) -> tuple[Vector, ...]:
    """Corners of the hull that is rounded by the radius: one for round shapes (m)."""
    if isinstance(shape, Polygon):
        return shape.vertices
    if isinstance(shape, Wall):
        return (shape.start, shape.end)
    return (Vector(0.0, 0.0),)


def _inertness(shape: Shape, mass: float | None, inertia: float | None) -> dict[str, float]:
    """Mass, moment of inertia and their inverses, as columns of `Bodies`."""
    if isinstance(shape, Wall):
        still = {"mass": math.inf, "inertia": math.inf}
        return still | {"inverse_mass": 0.0, "inverse_inertia": 0.0}
    kg = 1.0 if mass is None else validate.positive(mass, "mass")
    turning = shape.inertia(kg) if inertia is None else validate.positive(inertia, "inertia")
    turns = turning <= HUGE or isinstance(shape, Particle)
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
