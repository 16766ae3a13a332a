"""Where two bodies touch with all their pieces: what happens there at one instant is one impact.

A plank that lands flat on a floor of planks, or on a chain of walls, meets many pieces at once.
Struck one after another, the first would turn the plank before the next is asked. Of points along
one surface the two outermost say all: the speed of approach grows evenly from one to the other.
"""

from engine.kernels.pose import place_pair
from engine.kernels.searching import lowest_gap
from engine.kernels.touches import OVERLAP
from engine.manifolds.any_pair import touching_points
from engine.tables import FREE, RESTING, Tables

PARALLEL = 1e-3
"""Sine of the angle up to which two normals are one: either side may give it, of what lies flat but
for what it sank in."""

FIRST, LAST = 2, 3
"""Rows of `Touch` for the outermost points so far, along the normal turned left."""


def points_struck(t: Tables, pair: int, time: float, near: float) -> int:
    """Place a pair at `time` of the part (s) and write to `Touch` where it touches; where other
    pieces of the two do so as well, along the same normal, the outermost two points of all.

    Points touch whose gap (m) is `near` at most, or that of the closest, or those of resting pieces
    that are no further apart than these may be. Returns their number.
    """
    place_pair(t, pair, time)
    points = touching_points(t, pair)
    pairs = t.pairs
    a = pairs.a[pair]
    b = pairs.b[pair]
    if points == 0 or t.bodies.pieces[a] + t.bodies.pieces[b] == 2:
        return points
    lowest = lowest_gap(t, points)
    within = lowest + 1e-8 * pairs.size[pair]
    if within < near:
        within = near
    nx = t.touch.normal_x[0]
    ny = t.touch.normal_y[0]
    ends = take_outermost(t, points, within, 0)
    alone = True
    body = a if t.bodies.moves[a] == 1 else b
    first = t.bodies.first_link[body]
    for link in range(first, first + t.bodies.links[body]):
        other = t.links.pair[link]
        if other == pair or pairs.a[other] != a or pairs.b[other] != b:
            continue
        gap = within
        if pairs.state[other] == RESTING:
            if gap < OVERLAP * pairs.size[other]:
                gap = OVERLAP * pairs.size[other]
        elif pairs.state[other] != FREE or pairs.apart[other] > within:
            continue
        place_pair(t, other, time)
        more = touching_points(t, other)
        if more > 0 and is_normal(t, nx, ny):
            ends = take_outermost(t, more, gap, ends)
            alone = False
    if alone or ends < 2:
        place_pair(t, pair, time)
        return touching_points(t, pair)
    t.touch.normal_x[0] = nx
    t.touch.normal_y[0] = ny
    copy_point(t, FIRST, 0)
    copy_point(t, LAST, 1)
    t.touch.gap[0] = t.touch.gap[1] = lowest
    return 2


def is_normal(t: Tables, nx: float, ny: float) -> bool:
    """Whether the normal in `Touch` is this one."""
    x = t.touch.normal_x[0]
    y = t.touch.normal_y[0]
    return x * nx + y * ny > 0.0 and abs(x * ny - y * nx) <= PARALLEL


def take_outermost(t: Tables, points: int, within: float, ends: int) -> int:
    """Keep those of the points in `Touch`, with a gap of at most `within` (m), that lie further out
    than the `ends` kept so far; return how many are kept.
    """
    for point in range(points):
        if t.touch.gap[point] > within:
            continue
        if ends == 0:
            copy_point(t, point, FIRST)
            copy_point(t, point, LAST)
            ends = 1
            continue
        if along(t, point) < along(t, FIRST):
            copy_point(t, point, FIRST)
            ends = 2
        elif along(t, point) > along(t, LAST):
            copy_point(t, point, LAST)
            ends = 2
    return ends


def along(t: Tables, point: int) -> float:
    """Where a point of `Touch` is along the normal turned left (m)."""
    return t.touch.y[point] * t.touch.normal_x[0] - t.touch.x[point] * t.touch.normal_y[0]


def copy_point(t: Tables, source: int, target: int) -> None:
    """Copy the place of a point of `Touch`."""
    t.touch.x[target] = t.touch.x[source]
    t.touch.y[target] = t.touch.y[source]
