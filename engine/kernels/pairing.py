"""The list of pairs: made anew when bodies leave their boxes; pairs keep what they remember."""

import math

from engine.kernels.broadphase import fit_boxes
from engine.kernels.neighbours import find_neighbours
from engine.kernels.rubbing import mix
from engine.kernels.touches import number_of_tick, part_with
from engine.manifolds.link import is_link
from engine.tables import FREE, NEVER, SENSING, Tables, clear_row, copy_row

REMEMBERED = 8
"""A free pair that touched more than so many ticks ago is as good as one that never did: longer
than any two impacts are taken for one (`impacts.AGAIN`)."""


CARRIED = 0.5
"""Who moved by more since a contact was measured was put elsewhere by hand, in reaches of the
smaller body."""


def find_pairs(t: Tables, dt: float) -> bool:
    """List the pairs that may touch within `dt` seconds; return whether there was room for them.

    If there was not, nothing has changed, and `Progress` says for how many there should be.
    """
    count = t.counts.bodies[0]
    fit_boxes(t, count, dt)
    found = find_neighbours(t, t.counts.pieces[0], t.progress.room[0])
    if found > t.progress.room[0]:
        t.progress.wanted[0] = found
        return False
    rearrange(t, t.counts.pairs[0], found)
    t.counts.pairs[0] = found
    t.counts.contacts[0] = 2 * found
    t.state.stale[0] = 0
    link(t, count, found)
    return True


def rearrange(t: Tables, before: int, found: int) -> None:
    """Bring the rows of `Pairs` and `Contacts` into the order of `Found`, both being sorted.

    Pairs that are no longer found are dropped, new ones begin with nothing, and so do those of
    which nothing is worth to be kept. As order is kept, rows that move up are out of each other's
    way if the last moves first, rows that move down if the first does.
    """
    pairs = t.pairs
    known = t.found.known
    old = 0
    for k in range(found):
        a = t.found.a[k]
        b = t.found.b[k]
        while old < before and comes_before(pairs.piece_a[old], pairs.piece_b[old], a, b):
            part_with(t, old)
            old += 1
        known[k] = -1
        if old < before and pairs.piece_a[old] == a and pairs.piece_b[old] == b:
            if not is_forgotten(t, old):
                known[k] = old
            old += 1
    for lost in range(old, before):
        part_with(t, lost)
    for k in range(found - 1, -1, -1):
        if 0 <= known[k] < k:
            move(t, known[k], k)
    for k in range(found):
        if known[k] > k:
            move(t, known[k], k)
    moved_by_hand = t.state.stale[0] == 1
    for k in range(found):
        if known[k] < 0:
            begin(t, k)
        elif moved_by_hand:
            pairs.apart[k] = 0.0
            mix(t, k)
            if is_carried_off(t, k):
                pairs.points[k] = 0
        pairs.queued[k] = 0


def comes_before(a: int, b: int, than_a: int, than_b: int) -> bool:
    """Whether the pair (a, b) stands before another."""
    return a < than_a or (a == than_a and b < than_b)


def move(t: Tables, source: int, target: int) -> None:
    """Move a pair with its contacts to another row."""
    pairs = t.pairs
    if is_fresh(t, source) and is_fresh(t, target):
        pairs.a[target] = pairs.a[source]
        pairs.b[target] = pairs.b[source]
        pairs.piece_a[target] = pairs.piece_a[source]
        pairs.piece_b[target] = pairs.piece_b[source]
        pairs.size[target] = pairs.size[source]
        pairs.restitution[target] = pairs.restitution[source]
        pairs.friction[target] = pairs.friction[source]
        pairs.static_friction[target] = pairs.static_friction[source]
        pairs.rolling_resistance[target] = pairs.rolling_resistance[source]
        pairs.belt_speed[target] = pairs.belt_speed[source]
        pairs.apart[target] = pairs.apart[source]
        pairs.clear[target] = pairs.clear[source]
        pairs.struck[target] = pairs.struck[source]
        pairs.meeting[target] = pairs.meeting[source]
        return
    copy_row(pairs, source, target)
    if pairs.points[source] > 0:
        copy_row(t.contacts, 2 * source, 2 * target)
        copy_row(t.contacts, 2 * source + 1, 2 * target + 1)


def is_fresh(t: Tables, pair: int) -> bool:
    """Whether a row holds, or is left from, a pair that has never touched: what a touch writes is
    zero there. Most are such, and rows are long.
    """
    return t.pairs.touched[pair] == 0 and t.pairs.state[pair] == FREE


def is_forgotten(t: Tables, pair: int) -> bool:
    """Whether the two fly, and touched so long ago that nobody asks when."""
    touched = t.pairs.touched[pair]
    return t.pairs.state[pair] == FREE and 0 < touched < number_of_tick(t) - REMEMBERED


def is_carried_off(t: Tables, pair: int) -> bool:
    """Whether a hand put one of a pair elsewhere: what is known of its contact holds no longer."""
    pairs = t.pairs
    a = pairs.a[pair]
    b = pairs.b[pair]
    x = t.bodies.x[b] - t.bodies.x[a] - pairs.seen_x[pair]
    y = t.bodies.y[b] - t.bodies.y[a] - pairs.seen_y[pair]
    return pairs.points[pair] > 0 and abs(x) + abs(y) > CARRIED * pairs.size[pair]


def begin(t: Tables, pair: int) -> None:
    """Write a new pair, which has no contacts, to its row."""
    pairs = t.pairs
    if is_fresh(t, pair):
        pairs.apart[pair] = pairs.clear[pair] = 0.0
    else:
        clear_row(pairs, pair)
    piece_a = t.found.a[pair]
    piece_b = t.found.b[pair]
    pairs.piece_a[pair] = piece_a
    pairs.piece_b[pair] = piece_b
    pairs.a[pair] = t.pieces.body[piece_a]
    pairs.b[pair] = t.pieces.body[piece_b]
    pairs.struck[pair] = -NEVER
    pairs.meeting[pair] = NEVER
    if t.bodies.sensor[pairs.a[pair]] == 1 or t.bodies.sensor[pairs.b[pair]] == 1:
        pairs.state[pair] = SENSING
    size_a = size(t, piece_a)
    size_b = size(t, piece_b)
    pairs.size[pair] = size_a if size_a < size_b else size_b
    mix(t, pair)


def size(t: Tables, piece: int) -> float:
    """Reach of the body of a piece (m); without end for walls."""
    if t.pieces.corners[piece] == 2 and t.pieces.radius[piece] == 0.0:
        return math.inf
    return t.bodies.reach[t.pieces.body[piece]]


def link(t: Tables, count: int, pair_count: int) -> None:
    """List the pairs of each body: first those in which it is a, then those in which it is b."""
    bodies = t.bodies
    pairs = t.pairs
    for row in range(count):
        bodies.links[row] = 0
    sensing = 0
    one_sided = 0
    linked = 0
    for pair in range(pair_count):
        bodies.links[pairs.a[pair]] += 1
        bodies.links[pairs.b[pair]] += 1
        if pairs.state[pair] == SENSING:
            sensing += 1
        one_sided += t.pieces.one_sided[pairs.piece_a[pair]]
        one_sided += t.pieces.one_sided[pairs.piece_b[pair]]
        if is_link(t.pieces, pairs.piece_a[pair]) or is_link(t.pieces, pairs.piece_b[pair]):
            linked += 1
    t.progress.sensing[0] = sensing
    t.progress.one_sided[0] = one_sided
    t.progress.linked[0] = linked
    first = 0
    for row in range(count):
        bodies.first_link[row] = first
        first += bodies.links[row]
        bodies.links[row] = 0
    for pair in range(pair_count):
        enlist(t, pairs.a[pair], pair)
    for pair in range(pair_count):
        enlist(t, pairs.b[pair], pair)


def enlist(t: Tables, row: int, pair: int) -> None:
    """Add a pair to the list of a body."""
    t.links.pair[t.bodies.first_link[row] + t.bodies.links[row]] = pair
    t.bodies.links[row] += 1
