"""Which pairs meet inside a part of a tick, and when; most are seen not to at a glance.

For discs the instant is a closed form; for what other surfaces do see `searching`.
"""

import math

from engine.kernels.agenda import enqueue
from engine.kernels.circles import (
    both_discs,
    circle_meets_wall,
    circles_meet,
    discs_meet,
    room_at_wall,
    stays_clear,
    wall_of,
)
from engine.kernels.pose import place
from engine.kernels.searching import is_part, search
from engine.manifolds.any_pair import gap_between, touching_points
from engine.manifolds.link import is_link, nearest_neighbour
from engine.tables import FREE, NEVER, PASSING, RESTING, SENSING, Tables

SINKS = 1e-3
"""What slides over from one piece to the next may sink into it by so much until the part is over,
in reaches of the smaller body; else it strikes it."""


def measure_rims(t: Tables, count: int, part: float) -> None:
    """Bound how far any point of each body moves by its rotation in the part (m)."""
    bodies = t.bodies
    for row in range(count):
        rim = 0.0
        if bodies.moves[row] == 1:
            swing = swing_of(t, row)
            if swing > 0.0:
                rim = (abs(bodies.spin[row]) + abs(bodies.path_spin[row]) * part) * swing
        bodies.rim[row] = rim * part


def swing_of(t: Tables, row: int) -> float:
    """How far any point of a body moves at most as it turns by 1 rad (m)."""
    bodies = t.bodies
    if bodies.pieces[row] == 1:
        return t.pieces.swing[bodies.first_piece[row]]
    return bodies.reach[row]


def find_meetings(t: Tables, pair_count: int, part: float) -> int:
    """Find which free pairs meet within the part (s); queue them and return their number.

    Pairs that are further apart than their surfaces move towards each other are left at a glance:
    bodies that fall side by side hardly do.
    """
    pairs = t.pairs
    vx = t.bodies.vx
    vy = t.bodies.vy
    path_x = t.bodies.path_x
    path_y = t.bodies.path_y
    rim = t.bodies.rim
    queued = 0
    for pair in range(pair_count):
        if pairs.state[pair] != FREE:
            continue
        a = pairs.a[pair]
        b = pairs.b[pair]
        way = (abs(vx[b] - vx[a]) + abs(vy[b] - vy[a])) * part
        way += (abs(path_x[b] - path_x[a]) + abs(path_y[b] - path_y[a])) * part * part
        left = pairs.apart[pair] - way - rim[a] - rim[b]
        if left > 0.0:
            pairs.apart[pair] = left
            continue
        notice_passing(t, pair)
        find_meeting(t, pair, 0.0, part)
        queued = enqueue(t, pair, queued)
    return queued


def foresee_meetings(t: Tables, pair_count: int, part: float) -> int:
    """The same where all fly straight: what was once found to stay clear needs no other look."""
    pairs = t.pairs
    state = pairs.state
    clear = pairs.clear
    queued = 0
    for pair in range(pair_count):
        left = clear[pair] - part
        if left > 0.0:
            clear[pair] = left
            continue
        if state[pair] != FREE:
            continue
        notice_passing(t, pair)
        find_meeting(t, pair, 0.0, part)
        queued = enqueue(t, pair, queued)
    return queued


def find_meeting(t: Tables, pair: int, start: float, end: float) -> None:
    """Set when the pair meets in the part of the tick from `start` to `end` (s), and how fast.

    Notes as well how far apart the two are at least until then.
    """
    pairs = t.pairs
    pairs.meeting[pair] = NEVER
    pairs.apart[pair] = 0.0
    pairs.clear[pair] = 0.0
    if pairs.state[pair] != FREE:
        return
    straight = t.progress.straight[0] == 1
    bodies = t.bodies
    a = pairs.a[pair]
    b = pairs.b[pair]
    from_a = start - bodies.clock[a]
    from_b = start - bodies.clock[b]
    path_ax = bodies.path_x[a]
    path_ay = bodies.path_y[a]
    path_bx = bodies.path_x[b]
    path_by = bodies.path_y[b]
    vx = bodies.vx[b] + path_bx * from_b - bodies.vx[a] - path_ax * from_a
    vy = bodies.vy[b] + path_by * from_b - bodies.vy[a] - path_ay * from_a
    ax = path_bx - path_ax
    ay = path_by - path_ay
    lasts = end - start
    bound = math.sqrt(vx * vx + vy * vy) + math.sqrt(ax * ax + ay * ay) * lasts
    wall = wall_of(t, pair)
    if wall < 0:
        x = (
            bodies.x[b] + (bodies.vx[b] + path_bx * from_b / 2.0) * from_b
            - bodies.x[a] - (bodies.vx[a] + path_ax * from_a / 2.0) * from_a
        )  # fmt: skip
        y = (
            bodies.y[b] + (bodies.vy[b] + path_by * from_b / 2.0) * from_b
            - bodies.y[a] - (bodies.vy[a] + path_ay * from_a / 2.0) * from_a
        )  # fmt: skip
        reach = bodies.reach[a] + bodies.reach[b]
        if straight and stays_clear(t, pair, circles_meet(t, pair, x, y, vx, vy, reach) - lasts):
            return
        far = reach + bound * lasts
        if x * x + y * y > far * far:
            pairs.apart[pair] = math.sqrt(x * x + y * y) - far
            return
        if ax == 0.0 and ay == 0.0 and both_discs(t, pair):
            discs_meet(t, pair, start, end, x, y, vx, vy, reach)
            return
    else:
        if straight and stays_clear(t, pair, circle_meets_wall(t, pair, wall, start) - lasts):
            return
        room = room_at_wall(t, wall, a + b - t.pieces.body[wall], start, bound * lasts)
        if room > 0.0:
            pairs.apart[pair] = room
            return
    bound += rim_speed(t, a, t.pairs.piece_a[pair], lasts)
    bound += rim_speed(t, b, t.pairs.piece_b[pair], lasts)
    search(t, pair, start, end, bound)
    if pairs.meeting[pair] == NEVER or not slides_over(t, pair, pairs.speed[pair], end - start):
        return
    if pairs.speed[pair] * (end - pairs.meeting[pair]) <= SINKS * pairs.size[pair]:
        pairs.meeting[pair] = NEVER


def slides_over(t: Tables, pair: int, speed: float, lasts: float) -> bool:
    """Whether what rests on one link of a chain, or piece of a body, comes to another (m/s).

    That is no impact, unless it is faster than forces explain within `lasts` seconds.
    """
    bodies = t.bodies
    pairs = t.pairs
    if not is_part(t, pair):
        return False
    a = pairs.a[pair]
    b = pairs.b[pair]
    fall = abs(bodies.ax[a]) + abs(bodies.ay[a]) + abs(bodies.ax[b]) + abs(bodies.ay[b])
    if speed > 2.0 * fall * lasts:
        return False
    body = a if bodies.moves[a] == 1 else b
    first = bodies.first_link[body]
    for i in range(first, first + bodies.links[body]):
        other = t.links.pair[i]
        if pairs.a[other] == a and pairs.b[other] == b and pairs.state[other] == RESTING:
            return True
    return False


def rim_speed(t: Tables, row: int, piece: int, lasts: float) -> float:
    """The most that rotation adds to the speed of the surface of a piece of a body (m/s)."""
    swing = t.pieces.swing[piece]
    if swing == 0.0:
        return 0.0
    spin = t.bodies.spin[row]
    more = t.bodies.path_spin[row] * lasts
    return ((spin if spin > 0.0 else -spin) + (more if more > 0.0 else -more)) * swing


def height_above(t: Tables, wall: int, x: float, y: float) -> float:
    """Height of a point over the positive side of a placed wall (m)."""
    first = t.pieces.first[wall]  # whose first side is the negative one
    return t.corners.world_normal_x[first] * (t.corners.world_x[first] - x) + (
        t.corners.world_normal_y[first] * (t.corners.world_y[first] - y)
    )


def middle_of(t: Tables, piece: int) -> tuple[float, float]:
    """A point within a placed piece: its body's centre, or the mean of its corners if it is one of
    several (m, world).
    """
    body = t.pieces.body[piece]
    if t.bodies.pieces[body] == 1:
        return t.bodies.here_x[body], t.bodies.here_y[body]
    first = t.pieces.first[piece]
    count = t.pieces.corners[piece]
    x = 0.0
    y = 0.0
    for row in range(first, first + count):
        x += t.corners.world_x[row]
        y += t.corners.world_y[row]
    return x / count, y / count


def notice_passing(t: Tables, pair: int) -> None:
    """Let through a one-sided wall what comes from behind; stop it again once it is through.

    Each piece of a body does so by itself: one may still be behind when the body's centre is not.
    """
    if t.progress.one_sided[0] == 0:
        return
    pairs = t.pairs
    wall = pairs.piece_a[pair]
    piece = pairs.piece_b[pair]
    if t.pieces.one_sided[wall] == 0:
        wall = pairs.piece_b[pair]
        piece = pairs.piece_a[pair]
        if t.pieces.one_sided[wall] == 0:
            return
    if pairs.state[pair] == SENSING:
        return
    body = t.pieces.body[piece]
    place(t.bodies, t.corners, body, t.bodies.clock[body])
    x, y = middle_of(t, piece)
    above = height_above(t, wall, x, y)
    if above < 0.0 and is_link(t.pieces, wall) and touching_points(t, pair) == 0:
        above = height_above(t, nearest_neighbour(t, wall, x, y), x, y)
    if above < 0.0 or (pairs.state[pair] != RESTING and passes_beside(t, piece, wall)):
        pairs.state[pair] = PASSING
        pairs.apart[pair] = 0.0
    elif pairs.state[pair] == PASSING and gap_between(t, pair) > 0.0:
        pairs.state[pair] = FREE


def passes_beside(t: Tables, piece: int, link: int) -> bool:
    """Whether a piece of a body is half through a link of a chain next to another: what is behind
    the one comes through the other as well.
    """
    before = t.pieces.before[link]
    after = t.pieces.after[link]
    if before + after == 0:
        return False
    first = t.bodies.first_piece[t.pieces.body[link]] - 1
    body = t.pieces.body[piece]
    start = t.bodies.first_link[body]
    for at in range(start, start + t.bodies.links[body]):
        pair = t.links.pair[at]
        if t.pairs.state[pair] == PASSING:
            one = t.pairs.piece_a[pair]
            other = t.pairs.piece_b[pair]
            beside = one + other - piece
            if (
                (one == piece or other == piece)
                and (
                    (before > 0 and beside == first + before)
                    or (after > 0 and beside == first + after)
                )
                and gap_between(t, pair) <= 0.0
            ):
                return True
    return False
