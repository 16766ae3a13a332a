"""What joints add to the velocity of a body at once: the one place where they change it."""

from engine.kernels.books import book_jolt
from engine.kernels.pose import advance
from engine.tables import Tables


def jolt(t: Tables, row: int, x: float, y: float, spin: float) -> None:
    """Book what joints add to the velocity (m/s) and spin (rad/s) of a body, and add it."""
    bodies = t.bodies
    book_jolt(t, row, x, y, spin)
    bodies.vx[row] += x
    bodies.vy[row] += y
    bodies.spin[row] += spin


def jolt_at(t: Tables, row: int, time: float, x: float, y: float, spin: float) -> None:
    """The same at `time` of the present part (s)."""
    advance(t, row, time)
    jolt(t, row, x, y, spin)


def jolt_start(t: Tables, row: int, x: float, y: float, spin: float) -> None:
    """The same at the start of a part, for which the velocity at its end has been found."""
    bodies = t.bodies
    jolt(t, row, x, y, spin)
    bodies.kick_x[row] += x
    bodies.kick_y[row] += y
    bodies.kick_spin[row] += spin
