"""Whole ticks: the kernel that the world calls, interpreted or compiled.

It returns when the ticks are over, or before when only Python can go on: to make room in tables,
to read a full table of impacts, to ask rules that people wrote. Called again it goes on from there.
"""

from engine.kernels.accelerate import accelerate
from engine.kernels.books import book_forces, is_forced
from engine.kernels.broadphase import look_ahead
from engine.kernels.escaping import runaway, runaways
from engine.kernels.pairing import find_pairs
from engine.kernels.parting import move_apart
from engine.kernels.sensing import sense_at_end
from engine.kernels.sleeping import fall_asleep, wake_in_time
from engine.kernels.status import (
    CROWDED,
    DONE,
    ESCAPED,
    FULL,
    LOOSE,
    LOST,
    MOVING,
    PAIRING,
    UNMIXED,
    WAITING,
)
from engine.kernels.travel import begin, end, travel
from engine.settings import Laws
from engine.tables import Tables, copy_row

SOUND = -1
"""No body has run away."""


def run(t: Tables, laws: Laws, dt: float, ticks: int) -> int:
    """Take so many ticks of `dt` seconds, or finish the present one and take the others."""
    for _ in range(ticks):
        status = step(t, laws, dt)
        if status != DONE:
            return status
        if t.progress.recording[0] > 0:
            record(t)
    return DONE


def step(t: Tables, laws: Laws, dt: float) -> int:
    """Take one tick, or what is left of it; return `DONE` or what only Python can do."""
    progress = t.progress
    if progress.phase[0] == WAITING:
        if t.state.loose[0] == 1:
            return LOOSE
        act(t, laws, dt)
        progress.now[0] = 0.0
        t.counts.parted[0] = 0
        progress.begun[0] = 0
        lost, escaping = look_ahead(t, t.counts.bodies[0], dt)
        if lost > 0 and has_run_away(t, dt):
            return LOST
        progress.phase[0] = MOVING if escaping == 0 and t.state.stale[0] == 0 else PAIRING
    while progress.phase[0] != WAITING:
        if progress.phase[0] == PAIRING:
            if not find_pairs(t, dt):
                return FULL
            progress.phase[0] = MOVING
            if progress.own_rules[0] == 1:
                return UNMIXED
        if laws.sleep_time > 0.0 and progress.begun[0] == 0:
            wake_in_time(t, laws, dt)
        status = move(t, laws, dt)
        tell_time_of_impacts(t)
        if status == ESCAPED:
            progress.phase[0] = PAIRING
        elif status == CROWDED:
            return CROWDED
        else:
            progress.phase[0] = WAITING
    count = t.counts.bodies[0]
    if t.state.deep[0] > 0:
        move_apart(t, count, t.counts.pairs[0], dt)
        t.state.deep[0] -= 1
    if t.progress.sensing[0] > 0:
        sense_at_end(t, t.counts.pairs[0])
    if t.books.forced[0] == 1:
        book_forces(t, count, laws, dt)
    end(t, count, t.counts.pairs[0], laws.integrator, dt, dt / laws.substeps)
    straight = progress.straight[0] == 1  # where velocities last, `look_ahead` knew enough
    if not straight and runaways(t.bodies, count, dt) > 0 and has_run_away(t, dt):
        return LOST
    end_pushes(t)
    if laws.sleep_time > 0.0:
        fall_asleep(t, laws, dt)
    tell_time(t, dt)
    return DONE


def act(t: Tables, laws: Laws, dt: float) -> None:
    """Let forces accelerate the bodies for a tick of `dt` seconds."""
    forced = is_forced(t, laws)
    t.books.forced[0] = 1 if forced else 0
    if forced or t.state.stale[0] == 1:
        t.progress.straight[0] = 0
    if t.progress.straight[0] == 1:
        return
    count = t.counts.bodies[0]
    accelerate(t.bodies, count, t.pushes, t.counts.pushes[0], t.fields, laws, dt, forced)


def has_run_away(t: Tables, dt: float) -> bool:
    """Whether a body left the range of numbers; note which."""
    t.progress.lost[0] = runaway(t.bodies, t.counts.bodies[0], dt)
    return t.progress.lost[0] != SOUND


def move(t: Tables, laws: Laws, dt: float) -> int:
    """Move the bodies on, along their paths and from impact to impact; see `travel`."""
    count = t.counts.bodies[0]
    pairs = t.counts.pairs[0]
    substep = dt / laws.substeps
    t.lanes.sizes[3] = 0  # pairs may stand in other rows now
    if t.progress.begun[0] == 0:
        t.progress.begun[0] = 1
        t.progress.begins[0] = 0
        t.impacts.written[1] = 0
        begin(t, count, pairs, substep)
    status, now = travel(t, count, pairs, t.progress.now[0], dt, substep, 1000 + 50 * count)
    t.progress.now[0] = now
    return status if now < dt else DONE


def tell_time_of_impacts(t: Tables) -> None:
    """Turn the times of new impacts (s, since the tick began) into times of the world."""
    began = t.state.base[0] + t.state.ticks[0] * t.state.dt[0]
    for i in range(t.progress.told[0], t.impacts.written[0]):
        t.impacts.time[i] = began + t.impacts.time[i]
    t.progress.told[0] = t.impacts.written[0]


def end_pushes(t: Tables) -> None:
    """Drop the pushes whose time is over."""
    kept = 0
    for i in range(t.counts.pushes[0]):
        if t.pushes.left[i] > 0.0:
            if kept < i:
                copy_row(t.pushes, i, kept)
            kept += 1
    t.counts.pushes[0] = kept


def tell_time(t: Tables, dt: float) -> None:
    """Let the clock tick (s)."""
    state = t.state
    if dt != state.dt[0]:
        state.base[0] = state.base[0] + state.ticks[0] * state.dt[0]
        state.ticks[0] = 0
        state.dt[0] = dt
    state.tick[0] += 1
    state.ticks[0] += 1


def record(t: Tables) -> None:
    """Append what is recorded of all bodies to `Tracks`."""
    bodies = t.bodies
    tracks = t.tracks
    count = t.counts.bodies[0]
    columns = t.progress.recording[0]
    at = t.progress.moment[0] * count
    for row in range(count):
        if columns & 1:
            tracks.x[at] = bodies.x[row]
        if columns & 2:
            tracks.y[at] = bodies.y[row]
        if columns & 4:
            tracks.angle[at] = bodies.angle[row]
        if columns & 8:
            tracks.vx[at] = bodies.vx[row]
        if columns & 16:
            tracks.vy[at] = bodies.vy[row]
        if columns & 32:
            tracks.spin[at] = bodies.spin[row]
        if columns & 64:
            tracks.force_x[at] = bodies.force_x[row]
        if columns & 128:
            tracks.force_y[at] = bodies.force_y[row]
        if columns & 256:
            tracks.torque[at] = bodies.torque[row]
        at += 1
    t.progress.moment[0] += 1
