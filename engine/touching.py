"""What touched what in the last tick, read from the tables as contacts of bodies."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from engine.contact import Contact
from engine.kernels.touches import impulses_of, number_of_tick
from engine.store import Store
from engine.tables import RESTING, SENSING, SLEEPING, Pairs
from engine.vector import Vector

BEGIN, STAY, END = "begin", "stay", "end"


class _Part(NamedTuple):
    """What one pair of pieces has to say."""

    now: bool
    before: bool
    points: tuple[Vector, ...]
    normal: Vector
    x: float
    y: float


def contacts(store: Store) -> list[Contact]:
    """All contacts of the last tick, in the order of the ids of their bodies."""
    parts: dict[tuple[int, int], list[_Part]] = {}
    for a, b, part in [*_listed(store, _handed_on(store)), *_parted(store)]:
        parts.setdefault((a, b), []).append(part)
    return [_joined(store, a, b, parts[a, b]) for a, b in sorted(parts)]


def _joined(store: Store, a: int, b: int, parts: list[_Part]) -> Contact:
    """Put together what the pieces of two bodies say."""
    rows, bodies = (store.rows[a], store.rows[b]), store.tables.bodies
    now, before = any(part.now for part in parts), any(part.before for part in parts)
    where = [part for part in parts if part.now and part.points]
    return Contact(
        a=store.handles[rows[0]],
        b=store.handles[rows[1]],
        phase=(STAY if before else BEGIN) if now else END,
        points=tuple(point for part in where for point in part.points),
        normal=where[0].normal if where else Vector(0.0, 0.0),
        impulse=Vector(sum(part.x for part in parts), sum(part.y for part in parts)),
        sensor=any(bodies.sensor[row] == 1 for row in rows),
    )


def _handed_on(store: Store) -> Pairs:
    """Pairs that have given what steady loads did not bear besides, as the kernels have it counted
    where a steady tick is cut short.
    """
    from engine.kernels.halting import hand_on  # see `store`

    t, count = store.tables, store.count("pairs")
    rests = np.asarray(t.pairs.state)[:count] == RESTING
    steady = np.flatnonzero(rests & (np.asarray(t.pairs.steady)[:count] == 1))
    if len(steady) == 0:
        return t.pairs
    given = {name: np.array(getattr(t.pairs, name)) for name in ("given_x", "given_y")}
    names = ("shift_x", "shift_y", "cluster", "stirred")
    scratch = {name: np.array(getattr(t.bodies, name)) for name in names}
    copy = t._replace(
        pairs=t.pairs._replace(**given, resting=steady), bodies=t.bodies._replace(**scratch)
    )
    hand_on(copy, store.count("bodies"), len(steady), 1.0)
    return copy.pairs


def _listed(store: Store, pairs: Pairs) -> Iterator[tuple[int, int, _Part]]:
    """Of the pairs in the list, those that touch or did in the tick before, by ids."""
    count, tick = store.count("pairs"), _last_tick(store)
    state = np.asarray(pairs.state)[:count]
    touched = np.asarray(pairs.touched)[:count]
    ids = store.tables.bodies.id
    still = (state == RESTING) | (state == SLEEPING)
    for pair in map(int, np.flatnonzero(still | (touched >= tick - 1))):
        fresh = pairs.touched[pair] == tick
        rests = bool(still[pair])
        sleeps = pairs.state[pair] == SLEEPING
        now = fresh or rests
        before = pairs.touched_before[pair] == tick - 1 if fresh else True
        x, y = 0.0, 0.0
        if fresh and not sleeps:
            x, y = float(pairs.given_x[pair]), float(pairs.given_y[pair])
        normal = Vector(pairs.normal_x[pair], pairs.normal_y[pair])
        points: tuple[Vector, ...] = ()
        if rests and pairs.points[pair] > 0:
            push, rub = (0.0, 0.0) if sleeps else impulses_of(store.tables, pair)
            x, y = x + push * normal.x - rub * normal.y, y + push * normal.y + rub * normal.x
            points = _resting_points(store, pair)
        elif now and pairs.state[pair] != SENSING:
            points = (Vector(pairs.hit_x[pair], pairs.hit_y[pair]),)
        yield ids[pairs.a[pair]], ids[pairs.b[pair]], _Part(now, before, points, normal, x, y)


def _last_tick(store: Store) -> int:
    """Number of the last tick, as in `touches`."""
    return number_of_tick(store.tables) - 1


def _resting_points(store: Store, pair: int) -> tuple[Vector, ...]:
    """Where a resting pair touches (m, world)."""
    t = store.tables
    pairs, a = t.pairs, t.pairs.a[pair]
    x, y, nx, ny = t.bodies.x[a], t.bodies.y[a], pairs.normal_x[pair], pairs.normal_y[pair]
    return tuple(
        Vector(
            x + t.contacts.tangent_arm_a[i] * nx + t.contacts.normal_arm_a[i] * ny,
            y + t.contacts.tangent_arm_a[i] * ny - t.contacts.normal_arm_a[i] * nx,
        )
        for i in range(2 * pair, 2 * pair + pairs.points[pair])
    )


def _parted(store: Store) -> Iterator[tuple[int, int, _Part]]:
    """The same of pairs that were dropped from the list, if both bodies are still there."""
    parted, tick = store.tables.parted, _last_tick(store)
    for i in range(store.count("parted")):
        a, b, now = parted.a[i], parted.b[i], parted.touched[i] == tick
        if a in store.rows and b in store.rows:
            before = parted.touched_before[i] == tick - 1 if now else True
            hit = (Vector(parted.hit_x[i], parted.hit_y[i]),)
            normal = Vector(parted.normal_x[i], parted.normal_y[i])
            x, y = (parted.given_x[i], parted.given_y[i]) if now else (0.0, 0.0)
            yield a, b, _Part(now, before, hit if normal != (0.0, 0.0) else (), normal, x, y)
