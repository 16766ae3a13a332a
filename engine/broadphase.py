"""Which bodies may touch: boxes with a margin, sorted along x and swept.

A list of pairs holds as long as no body can leave its box within the tick. It is sorted by rows,
and pairs in it that do not touch have no effect: results do not depend on how pairs were found.
"""

from engine.tables import Bodies, Ints, Tables
from engine.travel import farthest, has_escaped

SLACK = 0.2
"""Margin as a share of the reach."""

TICKS_AHEAD = 3.0
"""Margin as a share of the way of one tick."""


def holds(t: Tables, count: int, dt: float) -> bool:
    """Whether every body stays in its box during a tick of `dt` seconds."""
    for row in range(count):  # noqa: SIM110, a loop that can be compiled
        if has_escaped(t, row, dt):
            return False
    return True


def fit_boxes(t: Tables, count: int, dt: float) -> None:
    """Draw a box with a margin around the way of every body in `dt` seconds."""
    bodies = t.bodies
    for row in range(count):
        if bodies.inverse_mass[row] > 0.0:
            way_x, way_y = farthest(t, row, dt)
            slack = SLACK * bodies.reach[row]
            way_x += slack + TICKS_AHEAD * (way_x - bodies.reach[row])
            way_y += slack + TICKS_AHEAD * (way_y - bodies.reach[row])
            bodies.low_x[row] = bodies.x[row] - way_x
            bodies.high_x[row] = bodies.x[row] + way_x
            bodies.low_y[row] = bodies.y[row] - way_y
            bodies.high_y[row] = bodies.y[row] + way_y
        else:
            fit_wall(t, row)


def fit_wall(t: Tables, row: int) -> None:
    """Draw a box around a wall."""
    bodies = t.bodies
    start = bodies.first[row]
    last = start + 1
    x_0 = t.corners.world_x[start]
    x_1 = t.corners.world_x[last]
    y_0 = t.corners.world_y[start]
    y_1 = t.corners.world_y[last]
    bodies.low_x[row] = x_0 if x_0 < x_1 else x_1
    bodies.high_x[row] = x_1 if x_0 < x_1 else x_0
    bodies.low_y[row] = y_0 if y_0 < y_1 else y_1
    bodies.high_y[row] = y_1 if y_0 < y_1 else y_0


def sort(bodies: Bodies, count: int) -> None:
    """Sort `order` by the left ends of the boxes (insertion: it is nearly sorted)."""
    order = bodies.order
    low = bodies.low_x
    for i in range(1, count):
        row = order[i]
        key = low[row]
        j = i - 1
        while j >= 0 and low[order[j]] > key:
            order[j + 1] = order[j]
            j -= 1
        order[j + 1] = row


def sweep(bodies: Bodies, count: int, a: Ints, b: Ints) -> int:
    """Write all pairs whose boxes overlap; return their number, be there room for them or not."""
    found = 0
    room = len(a)
    order = bodies.order
    for i in range(count):
        row = order[i]
        right = bodies.high_x[row]
        low = bodies.low_y[row]
        high = bodies.high_y[row]
        wall = bodies.inverse_mass[row] == 0.0
        for j in range(i + 1, count):
            other = order[j]
            if bodies.low_x[other] > right:
                break
            if bodies.low_y[other] > high or bodies.high_y[other] < low:
                continue
            if wall and bodies.inverse_mass[other] == 0.0:
                continue
            if found < room:
                a[found] = row if row < other else other
                b[found] = other if row < other else row
            found += 1
    return found
