"""When two surfaces meet: the first instant at which the gap between them is zero.

Bodies move along known parabolas, so the gap is a known function of time. Steps no longer than it
allows (conservative advancement) lead to the first time at which it is negative; a bracketed secant
(Illinois) then finds where it was zero, to rounding.
"""

from engine.kernels.circles import meet, stillness
from engine.kernels.pose import place_pair, velocity_at
from engine.manifolds.any_pair import gap_between, touching_points
from engine.manifolds.link import is_link
from engine.tables import NEVER, Tables

ZERO_GAP = 1e-10
"""Gap that counts as touching, as a share of the smaller body's reach."""

HALVINGS = 12
"""So often the time since two bodies touched is halved to see them apart."""

FINER = 32.0
"""So many times as often are those looked at that overlap where another link of a chain, or piece
of a body, answers: it may be this one's turn soon."""

MOST_LOOKS = 1024
"""So often two surfaces that stay close are looked at within a part; then its rest is cut in:"""

LAST_LOOKS = 64
"""so many pieces. What turns a thousand times within a part may then touch unnoticed."""

GOLDEN = 0.3819660112501051
"""Share of an interval at which its least value is looked for, from both ends: (3 - sqrt 5)/2."""

MOST_CUTS = 48
"""So often that interval is cut, to a ten thousand millionth of itself."""

NOWHERE = -1e300
"""Speed of approach of bodies that have no point to touch at (m/s)."""


def gap_at(t: Tables, pair: int, time: float) -> float:
    """Distance of the surfaces at `time` (m)."""
    place_pair(t, pair, time)
    return gap_between(t, pair)


def approach_at(t: Tables, pair: int, time: float) -> float:
    """Greatest speed (m/s) at which points that touch at `time` approach; negative if none does,
    `NOWHERE` if there are no points.

    Leaves the points of contact in `Touch`.
    """
    place_pair(t, pair, time)
    points = touching_points(t, pair)
    within = lowest_gap(t, points) + 1e-8 * t.pairs.size[pair]
    return fastest_within(t, pair, points, time, within)


def lowest_gap(t: Tables, points: int) -> float:
    """Least gap of the points in `Touch` (m)."""
    if points == 2 and t.touch.gap[1] < t.touch.gap[0]:
        return t.touch.gap[1]
    return t.touch.gap[0]


def fastest_within(t: Tables, pair: int, points: int, time: float, within: float) -> float:
    """Greatest speed (m/s) at which placed bodies approach at `time`, of the points in `Touch` with
    a gap of at most `within` (m); `NOWHERE` if there are none.
    """
    fastest = NOWHERE
    for i in range(points):
        if t.touch.gap[i] <= within:
            speed = approach_of(t, pair, i, time)
            if speed > fastest:
                fastest = speed
    return fastest


def approach_of(t: Tables, pair: int, point: int, time: float) -> float:
    """Speed (m/s) at which placed bodies approach at `time` at a point of `Touch`."""
    x = t.touch.x[point]
    y = t.touch.y[point]
    ax, ay = velocity_at(t.bodies, t.pairs.a[pair], time, x, y)
    bx, by = velocity_at(t.bodies, t.pairs.b[pair], time, x, y)
    return (ax - bx) * t.touch.normal_x[0] + (ay - by) * t.touch.normal_y[0]


def search(t: Tables, pair: int, start: float, end: float, bound: float) -> None:
    """Find the meeting of any two shapes whose surfaces move no faster than `bound` (m/s).

    Those that overlap, as what rested does, meet where they come to overlap more.
    """
    time = start
    gap = gap_at(t, pair, start)
    if gap > bound * (end - start):
        t.pairs.apart[pair] = gap - bound * (end - start)
        return
    level = gap if gap < 0.0 else 0.0
    near = level + ZERO_GAP * t.pairs.size[pair]
    still = stillness(t, pair)
    piece = 0.25 * inner_of_both(t, pair) / bound if bound > 0.0 else end - start
    joins = is_part(t, pair)
    if gap <= near:
        speed = approach_at(t, pair, start)
        if speed > still:
            meet(t, pair, start, speed)
            return
        time = start + flight(t, pair, -speed, piece, still)
        if time > end:
            time = end
        gap = gap_at(t, pair, time)
        if gap <= near:  # another corner came down, or they slide or turn on each other
            time = landing(t, pair, start, time, gap, level)
            speed = approach_at(t, pair, time)
            if speed > still:
                meet(t, pair, time, speed)
                return
            gap = gap_at(t, pair, time)
    looks = 0
    earlier = time
    wider = gap
    while time < end:
        looks += 1
        if looks == MOST_LOOKS:
            piece = (end - time) / LAST_LOOKS
        least = piece if gap > near or not joins else piece / FINER
        later = stride(time, gap, end, bound, least)
        after = gap_at(t, pair, later)
        if near < gap < wider and steps_over(earlier, wider, time, gap, later, after, bound, near):
            dips = dip(t, pair, earlier, later, bound, near)
            if dips < NEVER:
                later = dips
                after = gap_at(t, pair, later)
                time = earlier
                gap = wider
        if after <= near:
            if after < level < gap:
                later = root(t, pair, time, gap, later, after, level)
            speed = approach_at(t, pair, later)
            if speed > still:
                meet(t, pair, later, speed)
                return
        earlier = time
        wider = gap
        time = later
        gap = after


def stride(time: float, gap: float, end: float, bound: float, least: float) -> float:
    """How far (s) to look on from a `time` at which surfaces are a `gap` (m) apart, or as deep in
    each other: as long as it lasts, but the `least` (s) at any rate, and until the `end`.
    """
    step = gap / bound if gap > least * bound else least
    return time + step if time + step < end else end


def steps_over(
    earlier: float,
    wider: float,
    time: float,
    gap: float,
    later: float,
    after: float,
    bound: float,
    near: float,
) -> bool:
    """Whether a gap that was `wider`, is no wider after the middle of three looks and may have been
    as small as `near` between two of them, as it changes no faster than `bound` (m/s).
    """
    if gap > wider or gap > after:
        return False
    before = (wider + gap - bound * (time - earlier)) / 2.0
    behind = (gap + after - bound * (later - time)) / 2.0
    return before <= near or behind <= near


def dip(t: Tables, pair: int, low: float, high: float, bound: float, near: float) -> float:
    """A time between two others (s) at which the gap is `near` at most; `NEVER` if there is none.

    The least gap is found by golden sections (Kiefer, 1953): that of a corner that passes close by
    has one minimum between two looks.
    """
    one = low + GOLDEN * (high - low)
    other = high - GOLDEN * (high - low)
    of_one = gap_at(t, pair, one)
    of_other = gap_at(t, pair, other)
    for _ in range(MOST_CUTS):
        if of_one <= near:
            return one
        if of_other <= near:
            return other
        lesser = of_one if of_one < of_other else of_other
        if lesser - bound * (high - low) > near:
            return NEVER
        if of_one <= of_other:
            high = other
            other = one
            of_other = of_one
            one = low + GOLDEN * (high - low)
            of_one = gap_at(t, pair, one)
        else:
            low = one
            one = other
            of_one = of_other
            other = high - GOLDEN * (high - low)
            of_other = gap_at(t, pair, other)
    return NEVER


def inner_of_both(t: Tables, pair: int) -> float:
    """Radii of circles within both pieces of a pair together; of the larger, as much counts as of
    the smaller, if that has any (m).
    """
    one = t.pieces.inner[t.pairs.piece_a[pair]]
    other = t.pieces.inner[t.pairs.piece_b[pair]]
    if one == 0.0 or other == 0.0:
        return one + other
    return 2.0 * (one if one < other else other)


def landing(t: Tables, pair: int, start: float, end: float, gap: float, level: float) -> float:
    """When two bodies whose gap is at its `level` (m) when they `start` are there again, as a rod
    that leaves one end and lands on the other.

    That is before the `end`, where their `gap` is less, if they were seen apart in between; or as
    soon as they approach.
    """
    tiny = ZERO_GAP * t.pairs.size[pair]
    after = end
    for _ in range(HALVINGS):
        if gap >= level - tiny:
            return after
        before = start + (after - start) / 2.0
        now = gap_at(t, pair, before)
        if now > level + tiny:
            return root(t, pair, before, now, after, gap, level)
        if approach_at(t, pair, before) <= 0.0:
            return after
        after = before
        gap = now
    return after


def flight(t: Tables, pair: int, speed: float, piece: float, still: float) -> float:
    """Time (s) that two bodies, separating at `speed` (m/s), surely fly apart: to the apex if
    something drives them back together, else a `piece`, as where they separate no faster than what
    is `still`; the normal is that in `Touch`.
    """
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    fall = (t.bodies.path_x[a] - t.bodies.path_x[b]) * t.touch.normal_x[0] + (
        t.bodies.path_y[a] - t.bodies.path_y[b]
    ) * t.touch.normal_y[0]
    if fall * piece > speed > still:
        return speed / fall
    return piece


def root(
    t: Tables, pair: int, before: float, gap: float, after: float, overlap: float, level: float
) -> float:
    """The time at which the gap is at a `level`, between one where it is `gap`, which is more, and
    one of `overlap`, which is less (m).
    """
    gap -= level
    overlap -= level
    enough = 1e-15 * t.pairs.size[pair]
    kept = 0
    time = after
    for _ in range(60):
        time = before + (after - before) * (gap / (gap - overlap))
        if time <= before or time >= after:
            time = (before + after) / 2.0
            if time <= before or time >= after:
                return before
        now = gap_at(t, pair, time) - level
        if now > 0.0:
            before = time
            gap = now
            if now <= enough:
                return time
            if kept == 1:
                overlap /= 2.0
            kept = 1
        else:
            after = time
            overlap = now
            if now >= -enough:
                return time
            if kept == -1:
                gap /= 2.0
            kept = -1
    return time


def is_part(t: Tables, pair: int) -> bool:
    """Whether a piece of a pair is a link of a chain, or joins other pieces of its body."""
    a = t.pairs.piece_a[pair]
    b = t.pairs.piece_b[pair]
    if t.pieces.seams[a] + t.pieces.seams[b] > 0:
        return True
    return is_link(t.pieces, a) or is_link(t.pieces, b)
