"""Newton's first law: where a body is at a time, if nothing else happens to it."""

from engine.kernels.elementary import cos_sin
from engine.tables import Bodies, Corners, Tables


def place_at(bodies: Bodies, row: int, time: float) -> tuple[float, float]:
    """Where a body is at `time` of the present part (s)."""
    passed = time - bodies.clock[row]
    half = passed * passed / 2.0
    x = bodies.x[row] + bodies.vx[row] * passed + bodies.path_x[row] * half
    return x, bodies.y[row] + bodies.vy[row] * passed + bodies.path_y[row] * half


def place(bodies: Bodies, corners: Corners, row: int, time: float) -> None:
    """Put the corners of a body where they are at `time` of the present part of the tick (s)."""
    if bodies.moves[row] == 0:
        return
    passed = time - bodies.clock[row]
    half = passed * passed / 2.0
    x = bodies.x[row] + bodies.vx[row] * passed + bodies.path_x[row] * half
    y = bodies.y[row] + bodies.vy[row] * passed + bodies.path_y[row] * half
    angle = bodies.angle[row] + bodies.spin[row] * passed + bodies.path_spin[row] * half
    put(bodies, corners, row, x, y, angle)


def place_pair(t: Tables, pair: int, time: float) -> None:
    """Put the two pieces of a pair where they are at `time` of the present part of the tick (s)."""
    place_piece(t, t.pairs.a[pair], t.pairs.piece_a[pair], time)
    place_piece(t, t.pairs.b[pair], t.pairs.piece_b[pair], time)


def place_piece(t: Tables, row: int, piece: int, time: float) -> None:
    """The same for one piece of a body."""
    bodies = t.bodies
    if bodies.pieces[row] == 1 or bodies.moves[row] == 0:
        place(bodies, t.corners, row, time)
        return
    passed = time - bodies.clock[row]
    half = passed * passed / 2.0
    x = bodies.x[row] + bodies.vx[row] * passed + bodies.path_x[row] * half
    y = bodies.y[row] + bodies.vy[row] * passed + bodies.path_y[row] * half
    angle = bodies.angle[row] + bodies.spin[row] * passed + bodies.path_spin[row] * half
    bodies.here_x[row] = x
    bodies.here_y[row] = y
    bodies.stands[row] = 0
    first = t.pieces.first[piece]
    turn(t.corners, first, first + t.pieces.corners[piece], x, y, angle)


def place_once(t: Tables, row: int, piece: int, time: float) -> None:
    """The same, if the body was not yet placed there; see `Bodies.placed`."""
    if t.bodies.placed[row] == 0 or t.bodies.pieces[row] > 1:
        t.bodies.placed[row] = 1
        place_piece(t, row, piece, time)


def put(bodies: Bodies, corners: Corners, row: int, x: float, y: float, angle: float) -> None:
    """Put the corners of a body where they are if it stands at (x, y), turned by `angle`; there is
    nothing to do if they are there.
    """
    first = bodies.first[row]
    count = bodies.corners[row]
    if count == 1:  # a disc, about the centre
        bodies.here_x[row] = x
        bodies.here_y[row] = y
        corners.world_x[first] = x
        corners.world_y[first] = y
        return
    if (
        bodies.stands[row] == 1
        and bodies.here_x[row] == x
        and bodies.here_y[row] == y
        and bodies.here_angle[row] == angle
    ):
        return
    bodies.here_x[row] = x
    bodies.here_y[row] = y
    bodies.here_angle[row] = angle
    bodies.stands[row] = 1
    turn(corners, first, first + count, x, y, angle)


def turn(corners: Corners, first: int, end: int, x: float, y: float, angle: float) -> None:
    """Put some corners where they are if their body stands at (x, y), turned by `angle`."""
    cos, sin = cos_sin(angle)
    for i in range(first, end):
        local_x = corners.x[i]
        local_y = corners.y[i]
        corners.world_x[i] = x + cos * local_x - sin * local_y
        corners.world_y[i] = y + sin * local_x + cos * local_y
        local_x = corners.normal_x[i]
        local_y = corners.normal_y[i]
        corners.world_normal_x[i] = cos * local_x - sin * local_y
        corners.world_normal_y[i] = sin * local_x + cos * local_y


def advance(t: Tables, row: int, time: float) -> None:
    """Move a body along its path to `time` of the present part of the tick (s)."""
    bodies = t.bodies
    passed = time - bodies.clock[row]
    bodies.clock[row] = time
    if passed == 0.0 or bodies.moves[row] == 0:
        return
    half = passed * passed / 2.0
    if t.progress.straight[0] == 0:
        third = half * passed / 3.0
        x = bodies.x[row] - bodies.start_x[row]
        y = bodies.y[row] - bodies.start_y[row]
        bodies.absement_x[row] += x * passed + bodies.vx[row] * half + bodies.path_x[row] * third
        bodies.absement_y[row] += y * passed + bodies.vy[row] * half + bodies.path_y[row] * third
    bodies.x[row] += bodies.vx[row] * passed + bodies.path_x[row] * half
    bodies.y[row] += bodies.vy[row] * passed + bodies.path_y[row] * half
    bodies.angle[row] += bodies.spin[row] * passed + bodies.path_spin[row] * half
    bodies.vx[row] += bodies.path_x[row] * passed
    bodies.vy[row] += bodies.path_y[row] * passed
    bodies.spin[row] += bodies.path_spin[row] * passed


def advance_all(bodies: Bodies, count: int, time: float, whole: bool) -> None:
    """Move all bodies along their paths to `time` of the part (s), which ends there; it may be the
    `whole` tick.
    """
    clock = bodies.clock
    moves = bodies.moves
    x = bodies.x
    y = bodies.y
    vx = bodies.vx
    vy = bodies.vy
    spin = bodies.spin
    at_once = time if whole else -1.0
    for row in range(count):
        passed = time - clock[row]
        clock[row] = 0.0
        if moves[row] == 0 or passed == 0.0:
            continue
        half = passed * passed / 2.0
        third = half * passed / 3.0
        ux = vx[row]
        uy = vy[row]
        ax = bodies.path_x[row]
        ay = bodies.path_y[row]
        turn = bodies.path_spin[row]
        absement_x = ux * half + ax * third
        absement_y = uy * half + ay * third
        if passed != at_once:
            absement_x += (x[row] - bodies.start_x[row]) * passed + bodies.absement_x[row]
            absement_y += (y[row] - bodies.start_y[row]) * passed + bodies.absement_y[row]
        bodies.absement_x[row] = absement_x
        bodies.absement_y[row] = absement_y
        x[row] += ux * passed + ax * half
        y[row] += uy * passed + ay * half
        bodies.angle[row] += spin[row] * passed + turn * half
        vx[row] = ux + ax * passed
        vy[row] = uy + ay * passed
        spin[row] += turn * passed


def drift_all(bodies: Bodies, count: int, time: float) -> None:
    """The same where all fly straight: what stays where it is has no velocity either."""
    clock = bodies.clock
    x = bodies.x
    y = bodies.y
    angle = bodies.angle
    vx = bodies.vx
    vy = bodies.vy
    spin = bodies.spin
    for row in range(count):
        passed = time - clock[row]
        clock[row] = 0.0
        x[row] += vx[row] * passed
        y[row] += vy[row] * passed
        angle[row] += spin[row] * passed


def velocity_at(bodies: Bodies, row: int, time: float, x: float, y: float) -> tuple[float, float]:
    """Velocity at `time` (s) of the point (x, y) of a placed body (m/s)."""
    passed = time - bodies.clock[row]
    spin = bodies.spin[row] + bodies.path_spin[row] * passed
    vx = bodies.vx[row] + bodies.path_x[row] * passed - spin * (y - bodies.here_y[row])
    vy = bodies.vy[row] + bodies.path_y[row] * passed + spin * (x - bodies.here_x[row])
    return vx, vy
