"""How far bodies may get within a tick: out of their boxes, or out of the range of numbers."""

from engine.kernels.resting import KEEPING
from engine.tables import Bodies, Tables

MOST = 1e100
"""Numbers beyond this (SI units) are those of a world that diverged."""


def has_escaped(t: Tables, row: int, lasts: float) -> bool:
    """Whether a body may leave its box before the tick is over, in `lasts` seconds."""
    bodies = t.bodies
    if bodies.moves[row] == 0:
        return False
    if bodies.pieces[row] > 1 and turns_out(bodies, row, lasts):
        return True
    way_x, way_y = farthest(t, row, lasts)
    return (
        bodies.x[row] - way_x < bodies.low_x[row]
        or bodies.x[row] + way_x > bodies.high_x[row]
        or bodies.y[row] - way_y < bodies.low_y[row]
        or bodies.y[row] + way_y > bodies.high_y[row]
    )


def turns_out(bodies: Bodies, row: int, lasts: float) -> bool:
    """Whether a body of several pieces may turn further than their boxes hold for."""
    turn = farthest_turn(bodies, row, lasts)
    angle = bodies.angle[row]
    return angle - turn < bodies.low_angle[row] or angle + turn > bodies.high_angle[row]


def farthest_turn(bodies: Bodies, row: int, lasts: float) -> float:
    """How far a body may turn in any direction within `lasts` seconds (rad)."""
    return (abs(bodies.spin[row]) + abs(bodies.aspin[row]) * lasts) * lasts


def farthest(t: Tables, row: int, lasts: float) -> tuple[float, float]:
    """How far from its centre a body may be in any direction within `lasts` seconds (m)."""
    bodies = t.bodies
    reach = bodies.reach[row] * (1.0 + 2.0 * KEEPING)  # pairs that rest stay listed
    x = (abs(bodies.vx[row]) + abs(bodies.ax[row]) * lasts) * lasts
    y = (abs(bodies.vy[row]) + abs(bodies.ay[row]) * lasts) * lasts
    return reach + x, reach + y


def runaway(bodies: Bodies, count: int, dt: float) -> int:
    """Row of the first body whose pose, or where it goes in `dt`, no number can hold; -1: none."""
    for row in range(count):
        speed = abs(bodies.vx[row]) + abs(bodies.vy[row]) + abs(bodies.spin[row])
        speed += (abs(bodies.ax[row]) + abs(bodies.ay[row]) + abs(bodies.aspin[row])) * dt
        if not abs(bodies.x[row]) + abs(bodies.y[row]) + abs(bodies.angle[row]) + speed * dt < MOST:
            return row
    return -1


def runaways(bodies: Bodies, count: int, dt: float) -> int:
    """How many bodies have left the range of numbers, or are about to in `dt` by their velocity."""
    x = bodies.x
    y = bodies.y
    angle = bodies.angle
    vx = bodies.vx
    vy = bodies.vy
    spin = bodies.spin
    lost = 0
    for row in range(count):
        speed = abs(vx[row]) + abs(vy[row]) + abs(spin[row])
        lost += not abs(x[row]) + abs(y[row]) + abs(angle[row]) + speed * dt < MOST
    return lost
