"""What points that are struck together are given, and what is written down of it; see
`simultaneous`, which finds the impulses, and the table `Hits`.
"""

from engine.kernels.curves import note_blow
from engine.kernels.impulses import closing_speed, give, note_given, write_impact
from engine.kernels.rubbing import belt_speed
from engine.tables import Tables


def approach_at(t: Tables, row: int) -> float:
    """Speed of approach at a point (m/s)."""
    hits = t.hits
    return closing_speed(
        t, hits.pair[row], hits.x[row], hits.y[row], hits.normal_x[row], hits.normal_y[row]
    )


def sliding_at(t: Tables, row: int) -> float:
    """Speed of b past a at a point, along the normal turned left, belts included (m/s)."""
    hits = t.hits
    pair = hits.pair[row]
    nx = hits.normal_x[row]
    ny = hits.normal_y[row]
    slides = closing_speed(t, pair, hits.x[row], hits.y[row], ny, -nx)
    return slides + belt_speed(t, pair, nx, ny)


def push(t: Tables, row: int, impulse: float, along: float) -> None:
    """Give impulses along the normal and along the surface (N s) at a point."""
    hits = t.hits
    nx = hits.normal_x[row]
    ny = hits.normal_y[row]
    give(
        t,
        hits.pair[row],
        hits.x[row],
        hits.y[row],
        impulse * nx - along * ny,
        impulse * ny + along * nx,
    )


def book_pressing(t: Tables, rows: int) -> None:
    """Book what impulses along the normals took of the energy."""
    for row in range(rows):
        lost = t.hits.impulse[row] * (t.hits.came[row] + approach_at(t, row)) / 2.0
        t.books.restitution_heat[0] += lost
        note_blow(t, t.hits.pair[row], lost)


def book_rubbing(t: Tables, rows: int) -> None:
    """Book what friction took, and what belts gave."""
    hits = t.hits
    for row in range(rows):
        along = hits.along[row]
        belt = belt_speed(t, hits.pair[row], hits.normal_x[row], hits.normal_y[row])
        t.books.friction_heat[0] -= along * (hits.slid[row] + sliding_at(t, row)) / 2.0
        t.books.wall_work[0] -= along * belt


def report_points(t: Tables, k: int, time: float) -> bool:
    """Report what the pair in place `k` was given at a time of the tick (s), as one impact between
    its points; return whether it was given anything.
    """
    hits = t.hits
    if hits.rows[k] == 0:
        return False
    first = hits.first[k]
    pair = hits.gathered[k]
    t.touch.normal_x[0] = hits.normal_x[first]
    t.touch.normal_y[0] = hits.normal_y[first]
    total = along = x = y = speed = 0.0
    for row in range(first, first + hits.rows[k]):
        impulse = hits.given[row]
        if impulse > 0.0:
            note_given(t, pair, hits.x[row], hits.y[row], impulse, hits.rubbed[row])
            total += impulse
            along += hits.rubbed[row]
            x += impulse * hits.x[row]
            y += impulse * hits.y[row]
            speed += impulse * hits.met[row]
    if total <= 0.0:
        return False
    write_impact(t, pair, x / total, y / total, total, along, speed / total, time)
    return True
