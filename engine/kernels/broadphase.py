"""Where bodies may be for some ticks: boxes with a margin.

A list of pairs holds as long as no body can leave its box within the tick. It is sorted by rows,
and pairs in it that do not touch have no effect: results do not depend on how pairs were found.
"""

from engine.kernels.escaping import MOST, farthest, farthest_turn, turns_out
from engine.kernels.pose import put
from engine.kernels.resting import KEEPING
from engine.tables import Bodies, Pieces, Tables

SLACK = 0.2
"""Margin as a share of the reach."""

TICKS_AHEAD = 3.0
"""Margin as a share of the way of one tick."""

FLIGHT = 2.0
"""Both are so many times as large where nothing acts on any body: pairs then cost least, as most of
them are not even looked at (see `meeting.foresee_meetings`)."""

OTHERS_AHEAD = 10.0
"""Margin as a share of the mean way of all bodies: a slow one may be hit by a fast one."""

MOST_AHEAD = 1.0
"""That margin at most, as a share of the reach."""

TURN_SLACK = 0.2
"""How far a body of several pieces may turn besides (rad)."""


def look_ahead(t: Tables, count: int, dt: float) -> tuple[int, int]:
    """How many bodies leave the range of numbers in a tick of `dt` seconds (see `runaway`), and how
    many may leave their boxes (see `has_escaped`).

    All conditions are looked at for every body, without a choice, so that a processor can look at
    several bodies at once.
    """
    bodies = t.bodies
    moves = bodies.moves
    x = bodies.x
    y = bodies.y
    vx = bodies.vx
    vy = bodies.vy
    ax = bodies.ax
    ay = bodies.ay
    spin = bodies.spin
    aspin = bodies.aspin
    angle = bodies.angle
    reach = bodies.reach
    low_x = bodies.low_x
    high_x = bodies.high_x
    low_y = bodies.low_y
    high_y = bodies.high_y
    lost = 0
    escaping = 0
    for row in range(count):
        here_x = x[row]
        here_y = y[row]
        way_x = (abs(vx[row]) + abs(ax[row]) * dt) * dt
        way_y = (abs(vy[row]) + abs(ay[row]) * dt) * dt
        turn = (abs(spin[row]) + abs(aspin[row]) * dt) * dt
        far = abs(here_x) + abs(here_y) + abs(angle[row]) + way_x + way_y + turn
        lost += not far < MOST
        room = reach[row] * (1.0 + 2.0 * KEEPING)
        escaping += (moves[row] == 1) & (
            (here_x - room - way_x < low_x[row])
            | (here_x + room + way_x > high_x[row])
            | (here_y - room - way_y < low_y[row])
            | (here_y + room + way_y > high_y[row])
        )
    if t.counts.pieces[0] > count:
        for row in range(count):
            if bodies.pieces[row] > 1 and moves[row] == 1 and turns_out(bodies, row, dt):
                escaping += 1
    return lost, escaping


def fit_boxes(t: Tables, count: int, dt: float) -> None:
    """Draw boxes with a margin around the ways of every body and piece in `dt` seconds."""
    bodies = t.bodies
    ahead = OTHERS_AHEAD * mean_way(bodies, count, dt)
    more = FLIGHT if all_fly_straight(bodies, count) else 1.0
    for row in range(count):
        if bodies.moves[row] == 1:
            reach = bodies.reach[row]
            way_x, way_y = farthest(t, row, dt)
            shared = ahead if ahead < MOST_AHEAD * reach else MOST_AHEAD * reach
            own = more * TICKS_AHEAD * (way_x - reach)
            way_x += more * SLACK * reach + (own if own > shared else shared)
            own = more * TICKS_AHEAD * (way_y - reach)
            way_y += more * SLACK * reach + (own if own > shared else shared)
            bodies.low_x[row] = bodies.x[row] - way_x
            bodies.high_x[row] = bodies.x[row] + way_x
            bodies.low_y[row] = bodies.y[row] - way_y
            bodies.high_y[row] = bodies.y[row] + way_y
            if bodies.pieces[row] == 1:
                box_as_body(bodies, t.pieces, bodies.first_piece[row], row)
            else:
                fit_pieces(t, row, way_x, way_y, dt)
        else:
            for piece in range(
                bodies.first_piece[row], bodies.first_piece[row] + bodies.pieces[row]
            ):
                fit_still(t, piece)


def all_fly_straight(bodies: Bodies, count: int) -> bool:
    """Whether no body is accelerated or held."""
    acting = 0
    for row in range(count):
        acting += (bodies.held[row] > 0) | (bodies.ax[row] != 0.0) | (bodies.ay[row] != 0.0)
    return acting == 0


def mean_way(bodies: Bodies, count: int, dt: float) -> float:
    """How far a body that moves goes in `dt` seconds along an axis, in the mean (m)."""
    total = 0.0
    moving = 0
    for row in range(count):
        if bodies.moves[row] == 1:
            total += abs(bodies.vx[row]) + abs(bodies.vy[row])
            moving += 1
    return total / (2.0 * moving) * dt if moving > 0 else 0.0


def box_as_body(bodies: Bodies, pieces: Pieces, piece: int, row: int) -> None:
    """Give a piece the box of its body."""
    pieces.low_x[piece] = bodies.low_x[row]
    pieces.low_y[piece] = bodies.low_y[row]
    pieces.high_x[piece] = bodies.high_x[row]
    pieces.high_y[piece] = bodies.high_y[row]


def fit_pieces(t: Tables, row: int, way_x: float, way_y: float, dt: float) -> None:
    """Draw a box around each of the pieces of a body that stays in its own, and turns so far."""
    bodies = t.bodies
    pieces = t.pieces
    turn = farthest_turn(bodies, row, dt)
    turn += TURN_SLACK + TICKS_AHEAD * turn
    bodies.low_angle[row] = bodies.angle[row] - turn
    bodies.high_angle[row] = bodies.angle[row] + turn
    put(bodies, t.corners, row, bodies.x[row], bodies.y[row], bodies.angle[row])
    for piece in range(bodies.first_piece[row], bodies.first_piece[row] + bodies.pieces[row]):
        box_as_body(bodies, pieces, piece, row)
        more_x = way_x - bodies.reach[row] + turn * pieces.swing[piece]
        more_y = way_y - bodies.reach[row] + turn * pieces.swing[piece]
        low_x, low_y, high_x, high_y = extent(t, piece)
        if low_x - more_x > pieces.low_x[piece]:
            pieces.low_x[piece] = low_x - more_x
        if low_y - more_y > pieces.low_y[piece]:
            pieces.low_y[piece] = low_y - more_y
        if high_x + more_x < pieces.high_x[piece]:
            pieces.high_x[piece] = high_x + more_x
        if high_y + more_y < pieces.high_y[piece]:
            pieces.high_y[piece] = high_y + more_y


def fit_still(t: Tables, piece: int) -> None:
    """Draw a box around a piece that does not move."""
    low_x, low_y, high_x, high_y = extent(t, piece)
    t.pieces.low_x[piece] = low_x
    t.pieces.low_y[piece] = low_y
    t.pieces.high_x[piece] = high_x
    t.pieces.high_y[piece] = high_y


def extent(t: Tables, piece: int) -> tuple[float, float, float, float]:
    """The lowest and the highest x and y of a placed piece (m): low x, low y, high x, high y."""
    corners = t.corners
    first = t.pieces.first[piece]
    low_x = corners.world_x[first]
    low_y = corners.world_y[first]
    high_x = low_x
    high_y = low_y
    for i in range(first + 1, first + t.pieces.corners[piece]):
        x = corners.world_x[i]
        y = corners.world_y[i]
        low_x = x if x < low_x else low_x
        high_x = x if x > high_x else high_x
        low_y = y if y < low_y else low_y
        high_y = y if y > high_y else high_y
    radius = t.pieces.radius[piece]
    return low_x - radius, low_y - radius, high_x + radius, high_y + radius
