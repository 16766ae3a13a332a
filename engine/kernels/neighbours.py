"""Which pieces may touch: their boxes overlap. Found in a grid, or by looking at all of them.

The grid has squares as large as the largest piece, a few aside that are larger (long walls) and are
compared with all. A piece belongs to the square in which its box has its centre, so that boxes
which overlap belong to the same or to neighbouring squares. Squares are kept by a hash of their
column and row (as in Teschner and others, "Optimized Spatial Hashing", 2003): the world has no
borders. Boxes are sorted by squares (by counting), so that those of a square, and of one above the
other, stand side by side in memory: in a large world, what a look from piece to piece costs is the
way to their rows. So a flag that says that nothing but its box matters stands beside each box.
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

LARGER = -1
"""In `Grid.square`: a piece that is larger than squares."""

SCATTER = 0.382
"""Numbers from one column to the next in a world that is too high for its squares, as a share of
their number: the golden section spreads columns evenly."""

PLAIN = 1
"""Category of bodies that were given no other."""

FARTHEST = 1e12
"""Columns and rows end there (squares): what is beyond belongs to the last ones."""


def find_neighbours(t: Tables, pieces: int, room: int) -> int:
    """Write to `Found`, which has `room`, all pairs of pieces whose boxes overlap, sorted.

    Returns their number; if it is more than `room`, not all were written.
    """
    find_ignored(t)
    if pieces <= FEW:
        return compare_all(t, pieces, room)
    found = search_grid(t, pieces, room)
    if found <= room:
        sort(t, pieces, found)
    return found


def may_touch(t: Tables, a: int, b: int) -> bool:
    """Whether two pieces whose boxes overlap have to be watched: one of them can be moved, and no
    filter (see `filters`) lets one pass through the other. The body of a stands before that of b or
    is the same.
    """
    body_a = t.pieces.body[a]
    body_b = t.pieces.body[b]
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
    return not ignores(t, body_a, body_b)


def find_ignored(t: Tables) -> None:
    """Find for each body the first row of those behind it which it ignores; the rows of the next
    body begin where they end.
    """
    bodies = t.bodies
    row = 0
    for body in range(t.counts.bodies[0]):
        while row < t.counts.ignored[0] and t.ignored.a[row] < bodies.id[body]:
            row += 1
        bodies.first_ignored[body] = row


def ignores(t: Tables, a: int, b: int) -> bool:
    """Whether two bodies, a standing before b, were told to pass through each other."""
    low = t.bodies.first_ignored[a]
    end = t.bodies.first_ignored[a + 1]
    high = end
    other = t.bodies.id[b]
    while low < high:
        middle = (low + high) // 2
        if t.ignored.b[middle] < other:
            low = middle + 1
        else:
            high = middle
    return low < end and t.ignored.b[low] == other


def compare_all(t: Tables, pieces: int, room: int) -> int:
    """Find pairs by looking at every two pieces."""
    low_x = t.pieces.low_x
    low_y = t.pieces.low_y
    high_x = t.pieces.high_x
    high_y = t.pieces.high_y
    found = 0
    for a in range(pieces):
        left = low_x[a]
        right = high_x[a]
        bottom = low_y[a]
        top = high_y[a]
        for b in range(a + 1, pieces):
            if (
                low_x[b] <= right
                and left <= high_x[b]
                and low_y[b] <= top
                and bottom <= high_y[b]
                and may_touch(t, a, b)
            ):
                found = note(t.found, a, b, found, room)
    return found


def note(found: Found, a: int, b: int, number: int, room: int) -> int:
    """Write a pair, a < b, after `number` others if there is room; return their number."""
    if number < room:
        found.a[number] = a
        found.b[number] = b
    return number + 1


def is_plain(t: Tables, piece: int) -> bool:
    """Whether a piece has to be watched with every other plain one that its box overlaps: the whole
    of a body that can be moved, with no filter of its own, where no two bodies ignore each other.
    """
    bodies = t.bodies
    body = t.pieces.body[piece]
    return (
        bodies.pieces[body] == 1
        and bodies.inverse_mass[body] != 0.0
        and bodies.category[body] == PLAIN
        and bodies.mask[body] & PLAIN != 0
        and bodies.group[body] == 0
        and t.counts.ignored[0] == 0
    )


def search_grid(t: Tables, pieces: int, room: int) -> int:
    """Find pairs in a grid, in no order."""
    grid = t.grid
    start = grid.start
    side = side_of_squares(t, pieces)
    squares = 64
    while squares < 2 * pieces:
        squares *= 2
    placed = pieces - find_squares(t, pieces, side)
    stride = number_squares(t, pieces, squares)
    sort_by_squares(t, pieces, squares)
    found = 0
    for k in range(placed):
        square = grid.square[grid.order[k]]  # then half of those around, as the others look at it
        if square + 1 < squares:
            found = look_into(t, k, k + 1, start[square + 2], found, room)
        else:
            found = look_into(t, k, k + 1, start[squares], found, room)
            found = look_into(t, k, 0, start[1], found, room)
        beside = (square + stride - 1) & (squares - 1)
        if beside + 2 < squares:
            found = look_into(t, k, start[beside], start[beside + 3], found, room)
        else:
            found = look_into(t, k, start[beside], start[squares], found, room)
            found = look_into(t, k, 0, start[beside + 3 - squares], found, room)
    for k in range(placed, pieces):
        found = look_into(t, k, 0, k, found, room)
    return found


def look_into(t: Tables, place: int, first: int, end: int, found: int, room: int) -> int:
    """Pair the piece at a place of the grid with those from place `first` to `end`; return how many
    pairs there are then.
    """
    grid = t.grid
    low_x = grid.low_x
    low_y = grid.low_y
    high_x = grid.high_x
    high_y = grid.high_y
    left = low_x[place]
    right = high_x[place]
    bottom = low_y[place]
    top = high_y[place]
    for k in range(first, end):
        if low_x[k] <= right and left <= high_x[k] and low_y[k] <= top and bottom <= high_y[k]:
            a = grid.order[place]
            b = grid.order[k]
            if b < a:
                other = a
                a = b
                b = other
            if grid.plain[place] + grid.plain[k] == 2 or may_touch(t, a, b):
                found = note(t.found, a, b, found, room)
    return found


def find_squares(t: Tables, pieces: int, side: float) -> int:
    """Find column and row of all pieces but those that are too large; return the number of these.

    To be called after `side_of_squares`, which measures them.
    """
    grid = t.grid
    boxes = t.pieces
    large = 0
    for piece in range(pieces):
        if grid.extent[piece] > side:
            grid.square[piece] = LARGER
            large += 1
        else:
            grid.square[piece] = 0
            grid.column[piece] = square_of((boxes.low_x[piece] + boxes.high_x[piece]) / 2.0, side)
            grid.row[piece] = square_of((boxes.low_y[piece] + boxes.high_y[piece]) / 2.0, side)
    return large


def number_squares(t: Tables, pieces: int, squares: int) -> int:
    """Give each piece the hash of its square, from 0 to `squares`, a power of two; return by how
    much it grows from one column to the next.

    Squares of a column are numbered one after the other, columns too, and what is too much begins
    again at 0: a world that is no larger than so many squares has no two with the same number.
    Squares around any one have different numbers in any case.
    """
    grid = t.grid
    lowest = 0
    highest = 0
    for piece in range(pieces):
        if grid.square[piece] != LARGER:
            lowest = grid.row[piece] if grid.row[piece] < lowest else lowest
            highest = grid.row[piece] if grid.row[piece] > highest else highest
    stride = highest - lowest + 3
    if stride > squares // 2 - 2:
        stride = math.floor(SCATTER * squares)
    for piece in range(pieces):
        if grid.square[piece] != LARGER:
            number = grid.column[piece] * stride + grid.row[piece]
            grid.square[piece] = number & (squares - 1)
    return stride


def sort_by_squares(t: Tables, pieces: int, squares: int) -> None:
    """Sort the boxes by squares, by counting; those that are larger come last."""
    grid = t.grid
    start = grid.start
    for square in range(squares + 1):
        start[square] = 0
    larger = pieces
    for piece in range(pieces):
        if grid.square[piece] != LARGER:
            start[grid.square[piece]] += 1
        else:
            larger -= 1
            put_at(t, piece, larger)
    for square in range(squares):  # for now, `start` says where a square ends
        start[square + 1] += start[square]
    for piece in range(pieces - 1, -1, -1):
        square = grid.square[piece]
        if square != LARGER:
            start[square] -= 1
            put_at(t, piece, start[square])


def put_at(t: Tables, piece: int, place: int) -> None:
    """Write a piece to a place of the grid."""
    grid = t.grid
    boxes = t.pieces
    grid.order[place] = piece
    grid.low_x[place] = boxes.low_x[piece]
    grid.low_y[place] = boxes.low_y[piece]
    grid.high_x[place] = boxes.high_x[piece]
    grid.high_y[place] = boxes.high_y[piece]
    grid.plain[place] = is_plain(t, piece)


def square_of(at: float, side: float) -> int:
    """Column or row of a coordinate (m)."""
    number = at / side
    if number > FARTHEST:
        number = FARTHEST
    elif number < -FARTHEST:
        number = -FARTHEST
    return math.floor(number)


def side_of_squares(t: Tables, pieces: int) -> float:
    """Side of the squares (m): the extent of the largest piece but for a few that are larger.

    Extents, the width or the height of a box, whichever is more, are left in the grid.
    """
    extent = t.grid.extent
    boxes = t.pieces
    allowed = LARGE + pieces // LARGE_SHARE
    total = 0.0
    for piece in range(pieces):
        wide = boxes.high_x[piece] - boxes.low_x[piece]
        high = boxes.high_y[piece] - boxes.low_y[piece]
        extent[piece] = wide if wide > high else high
        total += extent[piece]
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
        if fitting < extent[piece] <= side:
            fitting = extent[piece]
    side = fitting if fitting > LEAST else LEAST
    return side * 1.000001  # boxes as wide as a square stay neighbours whatever is rounded


def larger_than(t: Tables, pieces: int, side: float) -> int:
    """How many pieces are larger (m)."""
    extent = t.grid.extent
    larger = 0
    for piece in range(pieces):
        if extent[piece] > side:
            larger += 1
    return larger


def sort(t: Tables, pieces: int, number: int) -> None:
    """Sort the pairs by (a, b): by counting, first by b, then by a."""
    found = t.found
    start = t.grid.start
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
