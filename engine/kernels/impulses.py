"""What an impulse at a point does to two bodies that meet there, and what is written down of it."""

from engine.kernels.books import book_impact
from engine.kernels.touches import note_impact
from engine.tables import Tables

ALIKE = 1e-12
"""Two points are alike if the determinant of their equations is no larger a share of k11 k22."""

WEDGED = 1e-9
"""The same for two of which what stops one drives the other by as much."""


def approach(t: Tables, pair: int, point: int) -> float:
    """Speed along the normal with which the two bodies approach at a point of `Touch` (m/s)."""
    touch = t.touch
    return closing_speed(
        t, pair, touch.x[point], touch.y[point], touch.normal_x[0], touch.normal_y[0]
    )


def closing_speed(t: Tables, pair: int, x: float, y: float, nx: float, ny: float) -> float:
    """Speed with which the two bodies approach at (x, y) along a normal from a to b (m/s)."""
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    vx = bodies.vx[a] - bodies.spin[a] * (y - bodies.here_y[a]) - bodies.vx[b]
    vx += bodies.spin[b] * (y - bodies.here_y[b])
    vy = bodies.vy[a] + bodies.spin[a] * (x - bodies.here_x[a]) - bodies.vy[b]
    vy -= bodies.spin[b] * (x - bodies.here_x[b])
    return vx * nx + vy * ny


def response(t: Tables, pair: int, x: float, y: float, along_x: float, along_y: float) -> float:
    """Change of relative velocity by a unit impulse at (x, y) along a unit vector (1/kg)."""
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    arm_a = (x - bodies.here_x[a]) * along_y - (y - bodies.here_y[a]) * along_x
    arm_b = (x - bodies.here_x[b]) * along_y - (y - bodies.here_y[b]) * along_x
    return (
        bodies.inverse_mass[a]
        + bodies.inverse_mass[b]
        + arm_a * arm_a * bodies.inverse_inertia[a]
        + arm_b * arm_b * bodies.inverse_inertia[b]
    )


def slip(t: Tables, pair: int, x: float, y: float) -> float:
    """Speed of b past a at (x, y), along the normal in `Touch` turned left (m/s)."""
    return closing_speed(t, pair, x, y, t.touch.normal_y[0], -t.touch.normal_x[0])


def change_of(speed: float, bounce: float) -> float:
    """By how much an impact changes a speed of approach (m/s): what leaves is stopped at most."""
    return bounce * speed if speed > 0.0 else speed


def split(
    k11: float, k12: float, k22: float, v1: float, v2: float, wedged: float
) -> tuple[float, float]:
    """Share of the second of two points and impulse of both, neither pulling, for which

    k11 p1 + k12 p2 = v1 and k12 p1 + k22 p2 = v2 (1/kg, m/s).

    Where what stops one drives the other by as much, but for a share `wedged`, the first does it.
    """
    determinant = k11 * k22 - k12 * k12
    if k12 > 0.0:
        if determinant <= ALIKE * k11 * k22:
            return 0.5, v1 / k12
    elif determinant <= wedged * k11 * k22:  # no push on both does more
        return 0.0, v1 / k11
    p1 = (k22 * v1 - k12 * v2) / determinant
    p2 = (k11 * v2 - k12 * v1) / determinant
    if p2 <= 0.0:
        return 0.0, v1 / k11
    if p1 <= 0.0:
        return 1.0, v2 / k22
    return p2 / (p1 + p2), p1 + p2


def give(t: Tables, pair: int, x: float, y: float, jx: float, jy: float) -> None:
    """Give the impulse (N s) at (x, y) to b and its opposite to a."""
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    bodies.vx[a] -= bodies.inverse_mass[a] * jx
    bodies.vy[a] -= bodies.inverse_mass[a] * jy
    turn = (x - bodies.here_x[a]) * jy - (y - bodies.here_y[a]) * jx
    bodies.spin[a] -= bodies.inverse_inertia[a] * turn
    bodies.vx[b] += bodies.inverse_mass[b] * jx
    bodies.vy[b] += bodies.inverse_mass[b] * jy
    turn = (x - bodies.here_x[b]) * jy - (y - bodies.here_y[b]) * jx
    bodies.spin[b] += bodies.inverse_inertia[b] * turn


def report(
    t: Tables, pair: int, x: float, y: float, total: float, along: float, speed: float, time: float
) -> None:
    """Note, book and write down an impact that gave b impulses along the normal in `Touch` and
    along the surface, at (x, y) (N s).
    """
    note_given(t, pair, x, y, total, along)
    write_impact(t, pair, x, y, total, along, speed, time)


def note_given(t: Tables, pair: int, x: float, y: float, total: float, along: float) -> None:
    """Note and book such impulses."""
    nx = t.touch.normal_x[0]
    ny = t.touch.normal_y[0]
    jx = total * nx - along * ny
    jy = total * ny + along * nx
    note_impact(t, pair, x, y, jx, jy)
    book_impact(t, pair, x, y, jx, jy)


def write_impact(
    t: Tables, pair: int, x: float, y: float, total: float, along: float, speed: float, time: float
) -> None:
    """Write such an impact to the table, whose first row counts them; see `tick`."""
    nx = t.touch.normal_x[0]
    ny = t.touch.normal_y[0]
    impacts = t.impacts
    row = impacts.written[0]
    impacts.written[0] = row + 1
    impacts.a[row] = t.pairs.a[pair]
    impacts.b[row] = t.pairs.b[pair]
    impacts.x[row] = x
    impacts.y[row] = y
    impacts.normal_x[row] = nx
    impacts.normal_y[row] = ny
    impacts.impulse_x[row] = total * nx - along * ny
    impacts.impulse_y[row] = total * ny + along * nx
    impacts.speed[row] = speed
    impacts.restitution[row] = t.pairs.restitution[pair]
    impacts.time[row] = time
