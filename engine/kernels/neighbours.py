"""Which pieces may touch: their boxes overlap. Found in a grid, or by looking at all of them.

The grid has squares as large as the largest piece, a few aside that are larger (long walls) and are
compared with all. A piece belongs to the square in which its box has its centre, so that boxes
which overlap belong to the same or to neighbouring squares. Squares are kept by a hash of their
column and row (as in Teschner and others, "Optimized Spatial Hashing", 2003): the world has no
borders.
"""

import math

from engine.tables import Found, Tables

FEW = 32
"""Up to so many pieces all are compared with all."""

LARGE = 8
"""So many pieces may be larger than a square, and one in `LARGE_SHARE` of all."""

LARGE_SHARE = 64

LEAST = 1e-12
"""Side of squares at least, and the inverse of the most (m)."""

NOBODY, LARGER = -1, -2
"""In `Grid.following`: the last piece of a square; one that is larger than squares."""

FALLBACK_STRIDE = 1000003
"""Numbers from one column to the next in a world that is too high for its squares."""

FARTHEST = 1e12
"""Columns and rows end there (squares): what is beyond belongs to the last ones."""


def find_neighbours(t: Tables, pieces: int, room: int) -> int:
    """Write to `Found`, which has `room`, all pairs of pieces whose boxes overlap, sorted.

    Returns their number; if it is more than `room`, not all were written.
    """
    if pieces <= FEW:
        return compare_all(t, pieces, room)
    found = search_grid(t, pieces, room)
    if found <= room:
        sort(t, pieces, found)
    return found


def may_touch(t: Tables, a: int, b: int) -> bool:
    """Whether two pieces have to be watched: their boxes overlap, and one of them can be moved,
    and no filter (see `filters`) lets one pass through the other. The body of a stands before that
    of b or is the same.
    """
    pieces = t.pieces
    if (
        pieces.low_x[a] > pieces.high_x[b]
        or pieces.low_x[b] > pieces.high_x[a]
        or pieces.low_y[a] > pieces.high_y[b]
        or pieces.low_y[b] > pieces.high_y[a]
    ):
        return False
    body_a = pieces.body[a]
    body_b = pieces.body[b]
    if body_a == body_b:
        return False
    bodies = t.bodies
    deaf = bodies.inverse_mass[body_a] == 0.0 and bodies.inverse_mass[body_b] == 0.0
    if deaf and bodies.asleep[body_a] == 0 and bodies.asleep[body_b] == 0:
        return False
    if bodies.category[body_a] & bodies.mask[body_b] == 0:
        return False
    if bodies.category[body_b] & bodies.mask[body_a] == 0:
        return False
    group = bodies.group[body_a]
    if group != 0 and group == bodies.group[body_b]:
        return False
    return not ignored(t, bodies.id[body_a], bodies.id[body_b])


def ignored(t: Tables, a: int, b: int) -> bool:
    """Whether two bodies, by their ids, a < b, were told to pass through each other."""
    low = 0
    high = t.counts.ignored[0]
    while low < high:
        middle = (low + high) // 2
        other = t.ignored.a[middle]
        if other < a or (other == a and t.ignored.b[middle] < b):
            low = middle + 1
        else:
            high = middle
    return low < t.counts.ignored[0] and t.ignored.a[low] == a and t.ignored.b[low] == b


def compare_all(t: Tables, pieces: int, room: int) -> int:
    """Find pairs by looking at every two pieces."""
    found = 0
    for a in range(pieces):
        for b in range(a + 1, pieces):
            if may_touch(t, a, b):
                found = note(t.found, a, b, found, room)
    return found


def note(found: Found, a: int, b: int, number: int, room: int) -> int:
    """Write a pair, a < b, after `number` others if there is room; return their number."""
    if number < room:
        found.a[number] = a
        found.b[number] = b
    return number + 1


def search_grid(t: Tables, pieces: int, room: int) -> int:
    """Find pairs in a grid, in no order."""
    grid = t.grid
    side = side_of_squares(t, pieces)
    squares = 64
    while squares < 2 * pieces:
        squares *= 2
    large = sort_out_large(t, pieces, side)
    stride = fill_grid(t, pieces, squares)
    found = 0
    for a in range(pieces):
        if grid.following[a] == LARGER:
            continue
        column = grid.column[a]
        row = grid.row[a]
        found = look_into(t, a, column, row, grid.following[a], found, room)
        for k in range(4):  # and half of the squares around, as the others look at this one
            i = column + 1 if k < 3 else column
            j = row - 1 + k if k < 3 else row + 1
            found = look_into(t, a, i, j, grid.head[place(i, j, stride, squares)], found, room)
    for k in range(large):
        a = grid.large[k]
        for b in range(pieces):
            if b > a and may_touch(t, a, b):
                found = note(t.found, a, b, found, room)
            elif b < a and grid.following[b] != LARGER and may_touch(t, b, a):
                found = note(t.found, b, a, found, room)
    return found


def look_into(t: Tables, a: int, column: int, row: int, top: int, found: int, room: int) -> int:
    """Pair a piece with those of a square, from `top` on; return the number of pairs."""
    grid = t.grid
    b = top
    while b >= 0:
        if grid.column[b] == column and grid.row[b] == row:
            if a < b:
                if may_touch(t, a, b):
                    found = note(t.found, a, b, found, room)
            elif may_touch(t, b, a):
                found = note(t.found, b, a, found, room)
        b = grid.following[b]
    return found


def sort_out_large(t: Tables, pieces: int, side: float) -> int:
    """Find the squares of all pieces but those that are too large; return the number of these."""
    grid = t.grid
    large = 0
    for piece in range(pieces):
        if extent(t, piece) > side:
            grid.large[large] = piece
            grid.following[piece] = LARGER
            large += 1
        else:
            grid.following[piece] = NOBODY
            grid.column[piece] = square_of(
                (t.pieces.low_x[piece] + t.pieces.high_x[piece]) / 2.0, side
            )
            grid.row[piece] = square_of(
                (t.pieces.low_y[piece] + t.pieces.high_y[piece]) / 2.0, side
            )
    return large


def fill_grid(t: Tables, pieces: int, squares: int) -> int:
    """Put the pieces into their squares, the last on top; return the stride for `place`."""
    grid = t.grid
    lowest = 0
    highest = 0
    for piece in range(pieces):
        if grid.following[piece] != LARGER:
            lowest = grid.row[piece] if grid.row[piece] < lowest else lowest
            highest = grid.row[piece] if grid.row[piece] > highest else highest
    stride = highest - lowest + 3
    if stride > squares:
        stride = FALLBACK_STRIDE
    for square in range(squares):
        grid.head[square] = NOBODY
    for piece in range(pieces):
        if grid.following[piece] != LARGER:
            own = place(grid.column[piece], grid.row[piece], stride, squares)
            grid.following[piece] = grid.head[own]
            grid.head[own] = piece
    return stride


def place(column: int, row: int, stride: int, squares: int) -> int:
    """Hash of a square, from 0 to `squares`, a power of two.

    Squares of a column are numbered one after the other, columns too, and what is too much begins
    again at 0: a world that is no larger than so many squares has no two with the same number.
    """
    return (column * stride + row) & (squares - 1)


def square_of(at: float, side: float) -> int:
    """Column or row of a coordinate (m)."""
    number = at / side
    if number > FARTHEST:
        number = FARTHEST
    elif number < -FARTHEST:
        number = -FARTHEST
    return math.floor(number)


def extent(t: Tables, piece: int) -> float:
    """Width or height of a box, whichever is more (m)."""
    wide = t.pieces.high_x[piece] - t.pieces.low_x[piece]
    high = t.pieces.high_y[piece] - t.pieces.low_y[piece]
    return wide if wide > high else high


def side_of_squares(t: Tables, pieces: int) -> float:
    """Side of the squares (m): the extent of the largest piece but for a few that are larger."""
    allowed = LARGE + pieces // LARGE_SHARE
    total = 0.0
    for piece in range(pieces):
        total += extent(t, piece)
    side = total / pieces
    if not LEAST < side < 1.0 / LEAST:
        side = LEAST if side < 1.0 else 1.0 / LEAST
    if larger_than(t, pieces, side) > allowed:
        while larger_than(t, pieces, side) > allowed and side < 1.0 / LEAST:
            side *= 1.5
    else:
        while side > LEAST and larger_than(t, pieces, side / 1.5) <= allowed:
            side /= 1.5
    fitting = 0.0
    for piece in range(pieces):
        if fitting < extent(t, piece) <= side:
            fitting = extent(t, piece)
    side = fitting if fitting > LEAST else LEAST
    return side * 1.000001  # boxes as wide as a square stay neighbours whatever is rounded


def larger_than(t: Tables, pieces: int, side: float) -> int:
    """How many pieces are larger (m)."""
    larger = 0
    for piece in range(pieces):
        if extent(t, piece) > side:
            larger += 1
    return larger


def sort(t: Tables, pieces: int, number: int) -> None:
    """Sort the pairs by (a, b): by counting, first by b, then by a."""
    found = t.found
    start = t.grid.head
    for piece in range(pieces + 1):
        start[piece] = 0
    for k in range(number):
        start[found.b[k] + 1] += 1
    for piece in range(pieces):
        start[piece + 1] += start[piece]
    for k in range(number):
        b = found.b[k]
        at = start[b]
        start[b] = at + 1
        found.before_a[at] = found.a[k]
        found.before_b[at] = b
    for piece in range(pieces + 1):
        start[piece] = 0
    for k in range(number):
        start[found.before_a[k] + 1] += 1
    for piece in range(pieces):
        start[piece + 1] += start[piece]
    for k in range(number):
        a = found.before_a[k]
        at = start[a]
        start[a] = at + 1
        found.a[at] = a
        found.b[at] = found.before_b[k]
