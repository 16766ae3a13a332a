"""Impacts of one instant on the same bodies: a ball that meets two at once, a plank on two props.

Struck one after another, the first would decide what the second finds, and what is its own mirror
image would not stay so. Newton's law of restitution holds for all points together: each leaves with
e times the speed with which it came, none pulls, and what leaves faster is not pushed (Moreau,
"Numerical aspects of the sweeping process", 1999, section 4); `complementarity` finds the impulses
that do so. Friction follows in the same way, at most mu times the impulse along the normal, so no
impact gains energy.
"""

from engine.kernels.circles import stillness
from engine.kernels.complementarity import UNBOUNDED, couple, solve_bounded
from engine.kernels.exchange import BLOWS, OPENS, sticks
from engine.kernels.footprint import PARALLEL, points_struck
from engine.kernels.gathering import is_ground
from engine.kernels.impacts import (
    choose_points,
    come_together,
    comes_to_stay,
    leave_struck,
    strike,
)
from engine.kernels.impulses import closing_speed
from engine.kernels.struck import (
    approach_at,
    book_pressing,
    book_rubbing,
    push,
    report_points,
    sliding_at,
)
from engine.kernels.touches import OVERLAP
from engine.linkage.tally import is_joined
from engine.tables import RESTING, Tables

PASSES = 300
"""So often the points are passed over."""

RUBS = 12
"""So often at most to find friction: what slides on sides that are all but parallel is found ever
so slowly, and changes nothing."""

ENOUGH = 1e-14
"""No speed changes by more in the last pass over all points, as a share of the fastest approach;
but"""

NEARLY = 1e-6
"""where passes come to their end, this will do: what still approaches is struck again at once. If
not even that is found, pairs are struck one by one."""


def strike_gathered(
    t: Tables,
    number: int,
    now: float,
    time: float,
    shortest: float,
    within: float,
    plastic: bool,
) -> None:
    """Let all pairs that were gathered collide at once; or, where no impulses are found that do
    so, one after another. For the rest see `impacts.strike`.

    Args:
        t: the tables.
        number: how many pairs are listed in `Hits`.
        now: when the part began, since the tick began (s).
        time: of the impact, since the part began (s).
        shortest: a flight shorter than this (s) is none: the bodies stay together.
        within: points of a resting pair that joints hold are struck if they land within this (s).
        plastic: whether to take restitution as zero, as the end of endless bouncing.
    """
    hits = t.hits
    pairs = t.pairs
    for k in range(number):
        hits.rested[k] = 1 if pairs.state[hits.gathered[k]] == RESTING else 0
    if number > 1 and strike_together(t, number, now, time, shortest, plastic):
        return
    for k in range(number):
        pair = hits.gathered[k]
        near = OVERLAP * pairs.size[pair] if hits.rested[k] == 1 else 0.0
        if within > 0.0 and is_joined(t, pair):
            near = pairs.speed[pair] * within
        strike(t, pair, now, time, shortest, near, plastic)


def strike_together(
    t: Tables, number: int, now: float, time: float, shortest: float, plastic: bool
) -> bool:
    """Let all pairs that were gathered collide at once; return False, with nothing done, if no
    impulses are found that do so, and True as well if nothing approaches any more.
    """
    hits = t.hits
    rows = 0
    fastest = 0.0
    for k in range(number):
        come_together(t, hits.gathered[k], time)
    for k in range(number):
        rows, speed = list_points(t, k, rows, now, time, shortest, plastic)
        if speed > fastest:
            fastest = speed
    if fastest == 0.0:
        return True
    for row in range(rows):
        hits.idle[row] = 1 if is_between(t, row, rows) else 0
    if not press_all(t, rows, fastest):
        return False
    if gains_energy(t, rows, fastest):
        for row in range(rows):
            if hits.came[row] < 0.0:
                hits.idle[row] = 1
        press_all(t, rows, fastest)
    press_and_rub(t, rows, fastest)
    for row in range(rows):
        hits.met[row] = hits.came[row]
        hits.given[row] = hits.impulse[row]
        hits.rubbed[row] = hits.along[row]
    for _ in range(BLOWS):
        if not closes_again(t, rows):
            break
        strike_on(t, rows, fastest)
    for k in range(number):
        if report_points(t, k, now + time):
            leave_struck(t, hits.gathered[k], hits.rests[k] == 1, now + time, shortest)
    return True


def press_and_rub(t: Tables, rows: int, fastest: float) -> None:
    """Give the impulses along the normals that were found, then those of friction."""
    hits = t.hits
    for row in range(rows):
        push(t, row, hits.impulse[row], 0.0)
    book_pressing(t, rows)
    rub_all(t, rows, fastest)
    for row in range(rows):
        push(t, row, 0.0, hits.along[row])
    book_rubbing(t, rows)


def closes_again(t: Tables, rows: int) -> bool:
    """Whether friction drives together again, at some point, what meets the ground at all of them,
    and bounces at none: in heaps that would come to no end.
    """
    hits = t.hits
    closes = False
    for row in range(rows):
        if hits.leaves[row] > 0.0 or on_ground(t, row) < 0:
            return False
        closes = closes or approach_at(t, row) > stillness(t, hits.pair[row])
    return closes


def strike_on(t: Tables, rows: int, fastest: float) -> None:
    """Stop what friction drives together again, and let it rub once more."""
    hits = t.hits
    for row in range(rows):
        hits.came[row] = approach_at(t, row)
        hits.slid[row] = sliding_at(t, row)
    press_all(t, rows, fastest)
    press_and_rub(t, rows, fastest)
    for row in range(rows):
        hits.given[row] += hits.impulse[row]
        hits.rubbed[row] += hits.along[row]


def list_points(
    t: Tables, k: int, rows: int, now: float, time: float, shortest: float, plastic: bool
) -> tuple[int, float]:
    """List the points of the pair that stands in place `k`; return the number of rows, and its
    fastest approach (m/s).
    """
    hits = t.hits
    pair = hits.gathered[k]
    near = OVERLAP * t.pairs.size[pair] if hits.rested[k] == 1 else 0.0
    points = points_struck(t, pair, time, near)
    one, other, speed = choose_points(t, pair, points, near)
    hits.first[k] = rows
    hits.rows[k] = 0
    if one < 0:
        if hits.rested[k] == 1:
            return list_props(t, k, rows, points, near), 0.0
        return rows, 0.0
    rests = comes_to_stay(t, pair, speed, now + time, shortest, plastic)
    restitution = 0.0 if rests else t.pairs.restitution[pair]
    list_point(t, pair, one, restitution, rows)
    hits.rows[k] = 1
    if other >= 0:
        list_point(t, pair, other, restitution, rows + 1)
        hits.rows[k] = 2
    hits.rests[k] = 1 if rests else 0
    return rows + hits.rows[k], speed


def list_props(t: Tables, k: int, rows: int, points: int, near: float) -> int:
    """List the points in `Touch` of a resting pair that does not approach, with a gap of at most
    `near` (m); return the number of rows.
    """
    hits = t.hits
    for point in range(points):
        if t.touch.gap[point] <= near:
            list_point(t, hits.gathered[k], point, 0.0, rows + hits.rows[k])
            hits.rows[k] += 1
    hits.rests[k] = 1
    return rows + hits.rows[k]


def list_point(t: Tables, pair: int, point: int, restitution: float, row: int) -> None:
    """List a point of `Touch`."""
    hits = t.hits
    x = t.touch.x[point]
    y = t.touch.y[point]
    nx = t.touch.normal_x[0]
    ny = t.touch.normal_y[0]
    speed = closing_speed(t, pair, x, y, nx, ny)
    hits.pair[row] = pair
    hits.x[row] = x
    hits.y[row] = y
    hits.normal_x[row] = nx
    hits.normal_y[row] = ny
    hits.came[row] = speed
    hits.leaves[row] = restitution * speed if speed > 0.0 else 0.0
    hits.slid[row] = sliding_at(t, row)


def is_between(t: Tables, row: int, rows: int) -> bool:
    """Whether a point at which a body touches the ground lies between two others with the same
    normal: they say all, and which of three bears how much would be found very slowly.
    """
    hits = t.hits
    body = on_ground(t, row)
    if body < 0:
        return False
    nx = hits.normal_x[row]
    ny = hits.normal_y[row]
    before = False
    after = False
    for other in range(rows):
        if on_ground(t, other) != body:
            continue
        if abs(hits.normal_x[other] * ny - hits.normal_y[other] * nx) <= PARALLEL:
            along = (hits.y[other] - hits.y[row]) * nx - (hits.x[other] - hits.x[row]) * ny
            before = before or along < 0.0
            after = after or along > 0.0
    return before and after


def on_ground(t: Tables, row: int) -> int:
    """The body that touches the ground at a point, or -1 if both yield."""
    pair = t.hits.pair[row]
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    if is_ground(t, a):
        return b
    return a if is_ground(t, b) else -1


def press_all(t: Tables, rows: int, fastest: float) -> bool:
    """Find the impulses along the normals, where the fastest approach is `fastest` (m/s); whether
    there are such.
    """
    hits = t.hits
    unknowns = t.unknowns
    for row in range(rows):
        unknowns.value[row] = 0.0
        unknowns.least[row] = 0.0
        unknowns.most[row] = UNBOUNDED if hits.idle[row] == 0 else 0.0
        unknowns.wanted[row] = hits.came[row] + hits.leaves[row]
    couple(t, rows, 0)
    changes = solve_bounded(t, rows, ENOUGH * fastest, PASSES)
    for row in range(rows):
        hits.impulse[row] = unknowns.value[row]
    return changes <= NEARLY * fastest


def gains_energy(t: Tables, rows: int, fastest: float) -> bool:
    """Whether the impulses along the normals that were found would give energy, where the fastest
    approach is `fastest` (m/s).

    The work of each is its mean speed times it. What opened, and would be driven back by what
    bounces elsewhere, must not be stopped at once then, but is struck itself once it approaches.
    """
    hits = t.hits
    lost = 0.0
    opens = False
    for row in range(rows):
        lost += hits.impulse[row] * (hits.came[row] - hits.leaves[row])
        opens = opens or (hits.impulse[row] > 0.0 and hits.came[row] < -OPENS * fastest)
    return opens and lost < 0.0


def rub_all(t: Tables, rows: int, fastest: float) -> None:
    """Find the impulses of friction of points that are pressed."""
    couple(t, rows, 1)
    for row in range(rows):
        bound_friction(t, row, t.delassus.coupling[row * rows + row])
    solve_bounded(t, rows, ENOUGH * fastest, RUBS)
    for row in range(rows):
        t.hits.along[row] = t.unknowns.value[row]


def bound_friction(t: Tables, row: int, yields: float) -> None:
    """Note how a point slides once it is pressed, how much friction it has, and what is sought; a
    unit impulse changes the sliding by `yields` (1/kg).
    """
    hits = t.hits
    unknowns = t.unknowns
    pair = hits.pair[row]
    before = hits.slid[row]
    slid = sliding_at(t, row)
    hits.slid[row] = slid
    most = t.pairs.friction[pair] * hits.impulse[row]
    if abs(slid) > most * yields and sticks(t, pair, before, slid, yields, hits.impulse[row]):
        most = abs(slid) / yields
    unknowns.value[row] = 0.0
    unknowns.least[row] = -most
    unknowns.most[row] = most
    unknowns.wanted[row] = -slid
