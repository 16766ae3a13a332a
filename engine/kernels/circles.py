"""When circles meet: discs, the bounding circles of two bodies, or one and the line of a wall."""

import math

from engine.tables import NEVER, Tables

STILL = 1e-9
"""Speed below which two touching bodies do not approach (m/s): rounding, no threshold to bounce."""

ROUNDING = 1e-14
"""The same for fast bodies, as a share of their speeds: what rounding leaves after an impact."""

CLEAR = 1e-4
"""Gap that straight flights keep as long as they are foreseen to be clear, as a share of the
smaller body's reach: far more than any rounding, and more than what comes to rest."""


def wall_of(t: Tables, pair: int) -> int:
    """Row of the piece of a pair that is straight and never moves, or -1 if there is none."""
    a = t.pairs.piece_a[pair]
    if t.pieces.corners[a] == 2 and t.bodies.moves[t.pairs.a[pair]] == 0:
        return a
    b = t.pairs.piece_b[pair]
    if t.pieces.corners[b] == 2 and t.bodies.moves[t.pairs.b[pair]] == 0:
        return b
    return -1


def both_discs(t: Tables, pair: int) -> bool:
    """Whether both pieces of a pair are discs about the centres of their bodies."""
    a = t.pairs.piece_a[pair]
    b = t.pairs.piece_b[pair]
    return t.pieces.swing[a] == 0.0 and t.pieces.swing[b] == 0.0


def room_at_wall(t: Tables, wall: int, body: int, start: float, way: float) -> float:
    """Distance that a body keeps from a wall's line, if it moves no further than `way` (m)."""
    bodies = t.bodies
    first = t.pieces.first[wall]
    passed = start - bodies.clock[body]
    half = passed * passed / 2.0
    x = bodies.x[body] + bodies.vx[body] * passed + bodies.path_x[body] * half
    y = bodies.y[body] + bodies.vy[body] * passed + bodies.path_y[body] * half
    above = t.corners.world_normal_x[first] * (
        x - t.corners.world_x[first]
    ) + t.corners.world_normal_y[first] * (y - t.corners.world_y[first])
    reach = bodies.reach[body] + t.pieces.radius[wall]
    return abs(above) - reach - way


def discs_meet(
    t: Tables,
    pair: int,
    start: float,
    end: float,
    x: float,
    y: float,
    vx: float,
    vy: float,
    reach: float,
) -> None:
    """Solve |d + v t| = r for two round bodies that move with constant relative velocity."""
    closing = x * vx + y * vy
    if closing >= 0.0:
        return
    distance = math.sqrt(x * x + y * y)
    room = distance * distance - reach * reach
    square = vx * vx + vy * vy
    if room <= 0.0:  # they touch, or overlap by rounding
        if -closing > stillness(t, pair) * distance:
            meet(t, pair, start, -closing / distance if distance > 0.0 else math.sqrt(square))
        return
    root = closing * closing - square * room
    if root <= 0.0:
        return
    root = math.sqrt(root)
    time = start + room / (root - closing)
    if time <= end and root > stillness(t, pair) * reach:
        meet(t, pair, time, root / reach)


def stillness(t: Tables, pair: int) -> float:
    """Speed (m/s) below which the bodies of a pair, if they touch, do not approach."""
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    fast = abs(bodies.vx[a]) + abs(bodies.vy[a]) + abs(bodies.vx[b]) + abs(bodies.vy[b])
    fast += abs(bodies.spin[a]) * bodies.reach[a] + abs(bodies.spin[b]) * bodies.reach[b]
    return STILL + ROUNDING * fast


def meet(t: Tables, pair: int, time: float, speed: float) -> None:
    """Note a meeting."""
    t.pairs.meeting[pair] = time
    t.pairs.speed[pair] = speed


def stays_clear(t: Tables, pair: int, lasts: float) -> bool:
    """Whether a pair does not meet until the end of the part and, then, for `lasts` seconds."""
    if lasts <= 0.0:
        return False
    t.pairs.clear[pair] = lasts
    t.pairs.apart[pair] = CLEAR * t.pairs.size[pair]
    return True


def circles_meet(
    t: Tables, pair: int, x: float, y: float, vx: float, vy: float, reach: float
) -> float:
    """Time (s) until the bounding circles of two bodies, flying straight, are nearly as close as
    their radii allow; 0 if they are, `NEVER` if they never will be.
    """
    near = reach + CLEAR * t.pairs.size[pair]
    room = x * x + y * y - near * near
    if room <= 0.0:
        return 0.0
    closing = x * vx + y * vy
    root = closing * closing - (vx * vx + vy * vy) * room
    if closing >= 0.0 or root <= 0.0:
        return NEVER
    return room / (math.sqrt(root) - closing)


def circle_meets_wall(t: Tables, pair: int, wall: int, start: float) -> float:
    """The same for a body and the line of a wall."""
    bodies = t.bodies
    body = t.pairs.a[pair] + t.pairs.b[pair] - t.pieces.body[wall]
    room = room_at_wall(t, wall, body, start, CLEAR * t.pairs.size[pair])
    if room <= 0.0:
        return 0.0
    first = t.pieces.first[wall]
    normal_x = t.corners.world_normal_x[first]
    normal_y = t.corners.world_normal_y[first]
    away_x = bodies.x[body] - t.corners.world_x[first]
    away_y = bodies.y[body] - t.corners.world_y[first]
    closing = normal_x * bodies.vx[body] + normal_y * bodies.vy[body]
    if normal_x * away_x + normal_y * away_y > 0.0:
        closing = -closing
    return room / closing if closing > 0.0 else NEVER
