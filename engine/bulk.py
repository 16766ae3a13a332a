"""Many ticks, or many bodies, in one call: tracks and states as arrays."""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

from engine import kinds, tables, validate
from engine.clockwork import Clockwork
from engine.collision import Collision
from engine.shapes import Barrier
from engine.tracks import Tracks
from engine.validate import shown

if TYPE_CHECKING:
    from engine.world import World

STATE = ("id", "x", "y", "angle", "vx", "vy", "spin")
"""Columns of `World.state`."""

RECORDED = ("x", "y", "angle", "vx", "vy", "spin", "force_x", "force_y", "torque")
"""Columns that `World.run` can record; see `Body` for their units."""


BLOCK = 1 << 18
"""Rows of tracks that kernels write at once (a row a body and tick)."""


def run(
    world: "World",
    clockwork: Clockwork,
    ticks: int,
    dt: float,
    record: Iterable[str],
    collisions: bool,
) -> Tracks:
    """Step many times; see `World.run`."""
    ticks, dt = validate.whole(ticks, "ticks", 0), validate.tick(dt)
    names, collisions = _names(record), validate.truth(collisions, "collisions")
    world.store.refuse_while_asking()
    if _needs_python(world):
        return _step_by_step(world, ticks, dt, names, collisions)
    return _at_once(world, clockwork, ticks, dt, names, collisions)


def _needs_python(world: "World") -> bool:
    """Whether anything is to be called between two ticks."""
    store = world.store
    listens = store.listened_to or any(joint.on_break for joint in store.joints)
    return listens or world.recorder is not None or any(law.is_python for law in world.force_laws)


def _at_once(
    world: "World",
    clockwork: Clockwork,
    ticks: int,
    dt: float,
    names: list[str],
    collisions: bool,
) -> Tracks:
    """Let the kernels take all ticks, and write tracks in blocks of `BLOCK` rows."""
    world.store.close_books()
    rows = _Rows(world)
    count = len(rows.ids)
    columns = {name: np.empty((ticks + 1, count)) for name in names}
    times = np.empty(ticks + 1)
    times[0] = world.time
    rows.read(columns, 0)
    happened: list[Collision] = []
    total = done = 0
    while done < ticks:
        now = min(ticks - done, max(1, BLOCK // max(1, count)))
        with _tracking(world, names, now * count):
            happened += clockwork.advance(world.laws, world.rules, dt, now, silent=not collisions)
            total += clockwork.collisions
            rows.take(columns, slice(done + 1, done + 1 + now))
        done += now
    state = world.tables.state
    before = state.ticks[0] - ticks
    times[1:] = state.base[0] + (before + np.arange(1, ticks + 1)) * dt
    return Tracks(times, rows.ids, columns, tuple(happened), total)


@contextmanager
def _tracking(world: "World", names: list[str], rows: int) -> Iterator[None]:
    """Give the kernels room for so many rows of tracks."""
    store, progress = world.store, world.tables.progress
    room = {name: rows if name in names else 1 for name in RECORDED}
    block = [np.empty(room[name]) for name in tables.Tracks._fields]
    store.tables = store.tables._replace(tracks=tables.views(tables.Tracks(*block)))
    progress.recording[0] = sum(1 << i for i, name in enumerate(RECORDED) if name in names)
    progress.moment[0] = 0
    try:
        yield
    finally:
        progress.recording[0] = 0


def _step_by_step(
    world: "World", ticks: int, dt: float, names: list[str], collisions: bool
) -> Tracks:
    """Step, because functions are called between ticks, which may even add and remove bodies."""
    rows = _Rows(world)
    times = np.empty(ticks + 1)
    columns = {name: np.empty((ticks + 1, len(rows.ids))) for name in names}
    happened: list[Collision] = []
    count = 0
    times[0] = world.time
    rows.read(columns, 0)
    for i in range(1, ticks + 1):
        found = world.step(dt)
        count += len(found)
        if collisions:
            happened += found
        times[i] = world.time
        rows.read(columns, i)
    return Tracks(times, rows.ids, columns, tuple(happened), count)


class _Rows:
    """Where the bodies of the start are in the tables, whatever callbacks add or remove."""

    def __init__(self, world: "World") -> None:
        self.world = world
        self.ids = np.asarray(world.bodies.id)[: len(world)].copy()
        self._last = self._known()
        self._rows: Any = slice(0, len(self.ids))
        self._gone = np.zeros(len(self.ids), bool)
        at = [body.position if body.is_wall else (0.0, 0.0) for body in world]
        self._walls = {"x": np.array([x for x, _ in at]), "y": np.array([y for _, y in at])}

    def _known(self) -> tuple[int, int]:
        return len(self.world), self.world.tables.state.next_body[0]

    def read(self, columns: dict[str, Any], i: int) -> None:
        """Write row `i` of every column."""
        if self._last != self._known():
            self._last = self._known()
            rows = self.world.store.rows
            self._gone = np.array([id not in rows for id in self.ids.tolist()], bool)
            self._rows = np.array([rows.get(id, 0) for id in self.ids.tolist()], np.int64)
        bodies = self.world.bodies
        for name, column in columns.items():
            column[i] = np.asarray(getattr(bodies, name))[self._rows]
            if name in self._walls:
                column[i] += self._walls[name]
            if self._gone.any():
                column[i, self._gone] = np.nan

    def take(self, columns: dict[str, Any], moments: slice) -> None:
        """Copy what the kernels recorded."""
        tracks = self.world.tables.tracks
        for name, column in columns.items():
            block = np.asarray(getattr(tracks, name)).reshape(-1, len(self.ids))
            column[moments] = block[: moments.stop - moments.start]
            if name in self._walls:
                column[moments] += self._walls[name]


def _names(record: Iterable[str]) -> list[str]:
    known = len(RECORDED)
    names = [record] if isinstance(record, str) else validate.sequence(record, "record", known)
    for name in names:
        if not isinstance(name, str) or name not in RECORDED:
            raise ValueError(f"record knows {', '.join(RECORDED)}, not {shown(name)}")
    return names


def state(world: "World") -> Any:
    """Read all bodies at once; see `World.state`."""
    count = len(world)
    read = np.empty((count, len(STATE)))
    for i, name in enumerate(STATE):
        read[:, i] = np.asarray(getattr(world.bodies, name))[:count]
    for row, body in enumerate(world.store.handles):
        if isinstance(body.shape, Barrier):
            read[row, 1:3] = body.position
    return read


def set_state(world: "World", given: Any) -> None:
    """Set many bodies at once; see `World.set_state`."""
    try:
        wanted = np.asarray(given, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"a state must be an array of numbers, not {shown(given)}") from None
    if wanted.ndim != 2 or wanted.shape[1] != len(STATE):
        raise ValueError(f"a state has rows of {', '.join(STATE)}, not the shape {wanted.shape}")
    if not np.isfinite(wanted).all():
        raise ValueError("a state must be finite, but has NaN or infinities")
    if len(np.unique(wanted[:, 0])) != len(wanted):
        raise ValueError("a state must name each body once")
    rows = np.array([world.row(world.body(id)) for id in wanted[:, 0].tolist()], np.int64)
    before = state(world)[rows]
    for body, old, new in zip(
        (world.store.handles[row] for row in rows), before, wanted, strict=True
    ):
        if body.is_wall and (old != new).any():
            raise ValueError(f"a wall is immovable: {body.name} takes no state")
        if new[-1] != 0.0 and body.fixed_rotation:
            raise ValueError(f"{body.name} cannot have spin {new[-1]}: it never rotates")
        if body.kind == "static" and (old[4:] != new[4:]).any():
            raise ValueError(f"{body.name} is static: it takes no velocity and no spin")
    movable = np.array([not world.store.handles[row].is_wall for row in rows], bool)
    for i, name in enumerate(STATE[1:], start=1):
        np.asarray(getattr(world.bodies, name))[rows[movable]] = wanted[movable, i]
    for row in rows[movable]:
        kinds.repose(world.store, int(row))
    world.displaced()
