"""What is pressed through a wall is held on the side that it came from.

A wall is a line: once the centre of what overlaps it is beyond it, the shortest way out leads to
the other side. So what rests on a wall, and is pressed that deep by heavy bodies, would be lost.
"""

from engine.kernels.circles import wall_of
from engine.tables import RESTING, Tables


def is_pressed_through(t: Tables, pair: int) -> bool:
    """Whether the points that were just found in `Touch` push a resting pair, of which one is a
    wall, the other way than those that were known, beside the wall's ends.
    """
    pairs = t.pairs
    if pairs.state[pair] != RESTING or pairs.points[pair] == 0:
        return False
    way = t.touch.normal_x[0] * pairs.normal_x[pair] + t.touch.normal_y[0] * pairs.normal_y[pair]
    if way >= 0.0:
        return False
    wall = lone_wall(t, pair)
    if wall < 0:
        return False
    body = pairs.b[pair] if wall == pairs.piece_a[pair] else pairs.a[pair]
    corners = t.corners
    first = t.pieces.first[wall]
    to_x = corners.world_x[first + 1] - corners.world_x[first]
    to_y = corners.world_y[first + 1] - corners.world_y[first]
    along = to_x * (t.bodies.here_x[body] - corners.world_x[first])
    along += to_y * (t.bodies.here_y[body] - corners.world_y[first])
    return 0.0 <= along <= to_x * to_x + to_y * to_y


def lone_wall(t: Tables, pair: int) -> int:
    """Row of the piece of a pair that is a line, alone or in a chain, and belongs to no body with
    an inside; -1 if there is none.
    """
    wall = wall_of(t, pair)
    if wall >= 0 and (t.pieces.seams[wall] == 1 or t.pieces.radius[wall] > 0.0):
        return -1
    return wall


def hold_back(t: Tables, pair: int) -> int:
    """Write to `Touch` the lowest points of what is pressed through a wall, seen from the side that
    it came from; return how many.
    """
    pairs = t.pairs
    pieces = t.pieces
    corners = t.corners
    touch = t.touch
    wall = lone_wall(t, pair)
    other = pairs.piece_a[pair] + pairs.piece_b[pair] - wall
    sign = 1.0 if wall == pairs.piece_a[pair] else -1.0
    side = pieces.first[wall]
    x = corners.world_normal_x[side]
    y = corners.world_normal_y[side]
    if sign * (x * pairs.normal_x[pair] + y * pairs.normal_y[pair]) < 0.0:
        x = -x
        y = -y
    touch.normal_x[0] = sign * x
    touch.normal_y[0] = sign * y
    first = pieces.first[other]
    count = pieces.corners[other]
    lowest = first
    for i in range(first + 1, first + count):
        if height(t, side, i, x, y) < height(t, side, lowest, x, y):
            lowest = i
    write_lowest(t, 0, side, lowest, pieces.radius[other], x, y)
    if count == 1:
        return 1
    following = lowest + 1 if lowest + 1 < first + count else first
    before = lowest - 1 if lowest > first else first + count - 1
    if height(t, side, before, x, y) < height(t, side, following, x, y):
        following = before
    write_lowest(t, 1, side, following, pieces.radius[other], x, y)
    return 2


def height(t: Tables, side: int, corner: int, x: float, y: float) -> float:
    """Of a placed corner over a wall's side with the normal (x, y) (m)."""
    corners = t.corners
    above = (corners.world_x[corner] - corners.world_x[side]) * x
    return above + (corners.world_y[corner] - corners.world_y[side]) * y


def write_lowest(
    t: Tables, row: int, side: int, corner: int, radius: float, x: float, y: float
) -> None:
    """Write where a corner, rounded by a radius (m), is below a wall's side."""
    gap = height(t, side, corner, x, y) - radius
    t.touch.x[row] = t.corners.world_x[corner] - (radius + gap / 2.0) * x
    t.touch.y[row] = t.corners.world_y[corner] - (radius + gap / 2.0) * y
    t.touch.gap[row] = gap
    t.touch.feature[row] = corner
