"""The list of pairs between two uses of the kernels: made anew, carried over, cut."""

from typing import Any

import numpy as np

from engine.filters import may_touch
from engine.jit import Kernels
from engine.settings import Rule
from engine.tables import (
    NEVER,
    RESTING,
    Contacts,
    Links,
    Pairs,
    Tables,
    allocate,
    arrays,
    views,
)

CARRIED_OVER = (
    "state", "points", "carried", "part", "struck", "normal_x", "normal_y", "drift",
    "seen_x", "seen_y", "seen_angle_a", "seen_angle_b",
)  # fmt: skip
"""Columns of `Pairs` that a pair keeps when the list is made anew."""


RESTING_STATE = ("piece_a", "piece_b", "points", "carried", "part", "drift", "seen_x", "seen_y")
"""Columns of `Pairs` that tell two worlds apart where pairs rest."""


def pair_up(t: Tables, dt: float, rules: tuple[Rule, Rule], kernels: Kernels) -> tuple[Tables, int]:
    """List the pairs that may touch within `dt` seconds; return the tables and their number."""
    count, piece_count, pair_count = t.counts.bodies[0], t.counts.pieces[0], t.counts.pairs[0]
    plain = as_arrays(t) if kernels.compiled else t
    kernels.fit_boxes(plain, count, dt)
    kernels.sort(plain.pieces, piece_count)
    room = max(64, 4 * piece_count)
    a: Any = np.zeros(room, np.int64)
    b: Any = np.zeros(room, np.int64)
    found = sweep_into(plain, piece_count, a, b, kernels)
    if found > room:
        a, b = np.zeros(found, np.int64), np.zeros(found, np.int64)
        sweep_into(plain, piece_count, a, b, kernels)
    a, b = a[:found], b[:found]
    sorted_rows = np.lexsort((b, a))
    a, b = a[sorted_rows], b[sorted_rows]
    body = np.asarray(t.pieces.body)
    heeded = may_touch(t, body[a], body[b])
    a, b = a[heeded], b[heeded]
    found = len(a)
    room = len(t.pairs.a)
    while room < found:
        room *= 2
    pairs, contacts = allocate(Pairs, room), allocate(Contacts, 2 * room)
    np.asarray(pairs.piece_a)[:found], np.asarray(pairs.piece_b)[:found] = a, b
    np.asarray(pairs.a)[:found], np.asarray(pairs.b)[:found] = body[a], body[b]
    carry_over(t, pair_count, pairs, contacts, found)
    sizes = size_of_pieces(t)
    np.asarray(pairs.size)[:found] = np.minimum(sizes[a], sizes[b])
    a, b = body[a], body[b]
    t = t._replace(pairs=views(pairs), contacts=views(contacts), links=links(t, a, b, count))
    mix(t, found, *rules)
    return t, found


def size_of_pieces(t: Tables) -> Any:
    """Reach of the body of each piece (m); infinite for walls."""
    pieces = t.pieces
    thin = (np.asarray(pieces.corners) == 2) & (np.asarray(pieces.radius) == 0.0)
    return np.where(thin, np.inf, np.asarray(t.bodies.reach)[np.asarray(pieces.body)])


def sweep_into(t: Tables, piece_count: int, a: Any, b: Any, kernels: Kernels) -> int:
    """Write the pairs of pieces whose boxes overlap into two arrays; return their number."""
    if kernels.compiled:
        return kernels.sweep(t.bodies, t.pieces, piece_count, a, b)
    return kernels.sweep(t.bodies, t.pieces, piece_count, memoryview(a), memoryview(b))


def as_arrays(t: Tables) -> Tables:
    """The same tables through numpy arrays, as compiled kernels take them."""
    columns: Any = [type(table)(*arrays(table)) for table in t]
    return Tables(*columns)


def carry_over(t: Tables, pair_count: int, pairs: Pairs, contacts: Contacts, found: int) -> None:
    """Copy what known pairs remember into a new list."""
    old = keys(t.pairs, pair_count)
    new = keys(pairs, found)
    at = np.searchsorted(old, new)
    at[at == len(old)] = 0
    np.asarray(pairs.struck)[:found] = -NEVER
    known = np.flatnonzero(old[at] == new) if len(old) else np.zeros(0, np.int64)
    source = at[known]
    for name in CARRIED_OVER:
        np.asarray(getattr(pairs, name))[known] = np.asarray(getattr(t.pairs, name))[source]
    for before, after in zip(arrays(t.contacts), arrays(contacts), strict=True):
        after[2 * known], after[2 * known + 1] = before[2 * source], before[2 * source + 1]


def keys(pairs: Pairs, pair_count: int) -> Any:
    """One number for each pair, in the order of the list."""
    a, b = np.asarray(pairs.piece_a)[:pair_count], np.asarray(pairs.piece_b)[:pair_count]
    return (a << 32) | b


def link(t: Tables, count: int, pair_count: int) -> Tables:
    """List the pairs of each body anew, for a list of pairs that was put back."""
    a, b = np.asarray(t.pairs.a)[:pair_count], np.asarray(t.pairs.b)[:pair_count]
    return t._replace(links=links(t, a, b, count))


def links(t: Tables, a: Any, b: Any, count: int) -> Links:
    """List the pairs of each body, and say in `Bodies` where they stand."""
    ends = np.concatenate((a, b))
    table = allocate(Links, max(1, len(ends)))
    np.asarray(table.pair)[: len(ends)] = np.argsort(ends, kind="stable") % max(1, len(a))
    number = np.bincount(ends, minlength=count)[:count]
    np.asarray(t.bodies.links)[:count] = number
    np.asarray(t.bodies.first_link)[:count] = np.cumsum(number) - number
    return views(table)


def mix(t: Tables, pair_count: int, restitution: Rule, friction: Rule) -> None:
    """Give each pair its coefficients by the rules of the world."""
    bodies, pairs = t.bodies, t.pairs
    for pair in range(pair_count):
        a, b = pairs.a[pair], pairs.b[pair]
        pairs.restitution[pair] = restitution(bodies.restitution[a], bodies.restitution[b])
        pairs.friction[pair] = friction(bodies.friction[a], bodies.friction[b])


def forget(t: Tables, pair_count: int, row: int) -> int:
    """Drop the pairs of a body that leaves; return how many are left.

    Its row, and the rows of its pieces, still stand.
    """
    last, pieces = t.bodies.first_piece[row] + t.bodies.pieces[row], t.bodies.pieces[row]
    a, b = np.asarray(t.pairs.a)[:pair_count], np.asarray(t.pairs.b)[:pair_count]
    kept = np.flatnonzero((a != row) & (b != row))
    for column in arrays(t.pairs):
        column[: len(kept)] = column[kept]
    for column in arrays(t.contacts):
        column[: 2 * len(kept)] = np.stack((column[2 * kept], column[2 * kept + 1]), 1).ravel()
    for rows in (a[: len(kept)], b[: len(kept)]):
        rows[rows > row] -= 1
    for column in (t.pairs.piece_a, t.pairs.piece_b):
        rows = np.asarray(column)[: len(kept)]
        rows[rows >= last] -= pieces
    return len(kept)


def resting_columns(t: Tables, pair_count: int) -> list[Any]:
    """Copies of what the resting pairs remember, for the digest of a world."""
    state = np.asarray(t.pairs.state)[:pair_count]
    at = np.flatnonzero(state == RESTING)
    columns = [np.asarray(getattr(t.pairs, name))[at] for name in RESTING_STATE]
    for name in ("normal_impulse", "tangent_impulse", "gap"):
        column = np.asarray(getattr(t.contacts, name))
        for point in (0, 1):
            used = np.asarray(t.pairs.points)[at] > point
            columns.append(np.where(used, column[2 * at + point], 0.0))
    return columns
