"""Forces that depend on where a body is and how fast it moves: force fields and drag.

Each integrator samples them where its textbook says: both Euler methods at the start of the tick,
velocity Verlet at the start and at the end, the classic Runge-Kutta method at four places. What a
Python function gave for the start and the end of the tick is taken to change evenly between them.
"""

import math

from engine.settings import EXPLICIT_EULER, RK4, SEMI_IMPLICIT_EULER, Laws
from engine.tables import Bodies, Fields
from engine.tables.bodies import GIVEN, POINT_GRAVITY


def immerse(
    bodies: Bodies,
    row: int,
    fields: Fields,
    everyone: int,
    first: int,
    last: int,
    laws: Laws,
    dt: float,
) -> None:
    """Add gravity, drag and fields to what pushes a body, by the world's integrator; set its lead.

    Args:
        bodies: the table; mean accelerations hold what pushes do.
        row: which body.
        fields: the rows up to `everyone` act on all bodies, those from `first` to `last` on this.
        everyone: see `fields`.
        first: see `fields`.
        last: see `fields`.
        laws: of the world.
        dt: length of the tick (s).
    """
    half = dt / 2.0
    scale = bodies.gravity_scale[row]
    ax = bodies.ax[row] + scale * laws.gravity_x
    ay = bodies.ay[row] + scale * laws.gravity_y
    x = bodies.x[row]
    y = bodies.y[row]
    vx = bodies.vx[row]
    vy = bodies.vy[row]
    mass = bodies.inverse_mass[row]
    linear = laws.linear_drag * mass
    quadratic = laws.quadratic_drag * mass
    turn(bodies, row, fields, first, last, laws.integrator, dt)
    felt_x, felt_y = feel(fields, everyone, first, last, x, y, vx, vy, mass, 0.0)
    k1x, k1y = slowed(ax + felt_x, ay + felt_y, vx, vy, linear, quadratic, dt)
    lead = lead_of_euler(laws.integrator, dt)
    if lead != 0.0:
        bodies.ax[row] = k1x
        bodies.ay[row] = k1y
        bodies.lead_x[row] = k1x * lead
        bodies.lead_y[row] = k1y * lead
        bodies.lead_spin[row] = bodies.aspin[row] * lead
    elif laws.integrator == RK4:
        ux = vx + k1x * half
        uy = vy + k1y * half
        k2x, k2y = feel(
            fields, everyone, first, last, x + vx * half, y + vy * half, ux, uy, mass, 0.5
        )
        felt_x += 2.0 * k2x
        felt_y += 2.0 * k2y
        k2x, k2y = slowed(ax + k2x, ay + k2y, ux, uy, linear, quadratic, dt)
        wx = vx + k2x * half
        wy = vy + k2y * half
        k3x, k3y = feel(
            fields, everyone, first, last, x + ux * half, y + uy * half, wx, wy, mass, 0.5
        )
        felt_x += 2.0 * k3x
        felt_y += 2.0 * k3y
        k3x, k3y = slowed(ax + k3x, ay + k3y, wx, wy, linear, quadratic, dt)
        ux = vx + k3x * dt
        uy = vy + k3y * dt
        k4x, k4y = feel(fields, everyone, first, last, x + wx * dt, y + wy * dt, ux, uy, mass, 1.0)
        felt_x = (felt_x + k4x) / 6.0
        felt_y = (felt_y + k4y) / 6.0
        k4x, k4y = slowed(ax + k4x, ay + k4y, ux, uy, linear, quadratic, dt)
        mean_x = (k1x + 2.0 * (k2x + k3x) + k4x) / 6.0
        mean_y = (k1y + 2.0 * (k2y + k3y) + k4y) / 6.0
        bodies.ax[row] = mean_x
        bodies.ay[row] = mean_y
        bodies.lead_x[row] += (k1x + k2x + k3x) * dt / 6.0 - mean_x * half
        bodies.lead_y[row] += (k1y + k2y + k3y) * dt / 6.0 - mean_y * half
    else:
        ux = vx + k1x * dt
        uy = vy + k1y * dt
        x += (vx + k1x * half) * dt
        y += (vy + k1y * half) * dt
        k2x, k2y = feel(fields, everyone, first, last, x, y, ux, uy, mass, 1.0)
        felt_x = (felt_x + k2x) / 2.0
        felt_y = (felt_y + k2y) / 2.0
        k2x, k2y = slowed(ax + k2x, ay + k2y, ux, uy, linear, quadratic, dt)
        bodies.ax[row] = (k1x + k2x) / 2.0
        bodies.ay[row] = (k1y + k2y) / 2.0
        bodies.lead_x[row] += (k1x - k2x) / 2.0 * half
        bodies.lead_y[row] += (k1y - k2y) / 2.0 * half
    bodies.field_x[row] = felt_x * bodies.mass[row]
    bodies.field_y[row] = felt_y * bodies.mass[row]


def lead_of_euler(integrator: int, dt: float) -> float:
    """Lead per acceleration (s) of the two Euler methods; 0 for the others."""
    if integrator == SEMI_IMPLICIT_EULER:
        return dt / 2.0
    return -dt / 2.0 if integrator == EXPLICIT_EULER else 0.0


def feel(
    fields: Fields,
    everyone: int,
    first: int,
    last: int,
    x: float,
    y: float,
    vx: float,
    vy: float,
    inverse_mass: float,
    late: float,
) -> tuple[float, float]:
    """Acceleration by all fields at a place and a velocity, `late` (0..1) in the tick."""
    ax = 0.0
    ay = 0.0
    for i in range(everyone + last - first):
        field = i if i < everyone else first + i - everyone
        kind = fields.kind[field]
        if kind == GIVEN:
            early = 1.0 - late
            ax += (early * fields.x[field] + late * fields.later_x[field]) * inverse_mass
            ay += (early * fields.y[field] + late * fields.later_y[field]) * inverse_mass
        else:
            away_x = x - fields.x[field]
            away_y = y - fields.y[field]
            if kind == POINT_GRAVITY:
                soft = fields.softening[field]
                square = away_x * away_x + away_y * away_y + soft * soft
                cube = square * math.sqrt(square)
                pull = fields.strength[field] / cube if cube > 0.0 else 0.0
                ax -= pull * away_x
                ay -= pull * away_y
            else:
                stiff = fields.strength[field] * inverse_mass
                damped = fields.damping[field] * inverse_mass
                ax -= stiff * away_x + damped * vx
                ay -= stiff * away_y + damped * vy
    return ax, ay


def turn(
    bodies: Bodies, row: int, fields: Fields, first: int, last: int, integrator: int, dt: float
) -> None:
    """Add the torques that Python functions gave, and their lead."""
    share = dt / 12.0 if integrator == RK4 else dt / 4.0
    inverse = bodies.inverse_inertia[row]
    for field in range(first, last):
        if fields.kind[field] == GIVEN:
            start = fields.torque[field]
            end = fields.later_torque[field]
            mean = (start + end) / 2.0
            bodies.torque[row] += mean
            bodies.aspin[row] += mean * inverse
            bodies.lead_spin[row] += (start - end) * inverse * share


def slowed(
    ax: float, ay: float, vx: float, vy: float, linear: float, quadratic: float, dt: float
) -> tuple[float, float]:
    """Acceleration at a velocity: the given one less drag, k/m v or k/m |v| v.

    Drag that would turn the body back within the tick (s) is that of the velocity it then leaves,
    (a - r v) / (1 + r dt), as the implicit Euler method has it: it stops what it should, and
    what falls reaches its terminal speed.
    """
    if linear > 0.0:
        rate = linear
    elif quadratic > 0.0:
        rate = quadratic * math.sqrt(vx * vx + vy * vy)
    else:
        return ax, ay
    share = 1.0 if rate * dt <= 1.0 else 1.0 / (1.0 + rate * dt)
    return (ax - rate * vx) * share, (ay - rate * vy) * share
