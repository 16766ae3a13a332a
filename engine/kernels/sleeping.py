"""Bodies that have come to rest may sleep, if the world lets them: they cost next to nothing.

A body that sleeps is taken for one that nothing moves: its inverse mass is zero and it stands. An
*island*, bodies that rest on each other, falls asleep as a whole, if each of them was slower than
the set speed for the set time, one of them rests on something immovable, and neither a joint, a
push nor a Python function acts on them. It wakes as a whole, before anything can touch it.
"""

from engine.kernels.accelerate import act_on
from engine.kernels.books import book_halt
from engine.kernels.pose import put
from engine.kernels.rousing import ALL
from engine.kernels.searching import gap_at
from engine.settings import Laws
from engine.tables import FREE, RESTING, SLEEPING, Tables
from engine.tables.bodies import GIVEN

EVERY = 8
"""Ticks between two looks for islands that may fall asleep."""


def fall_asleep(t: Tables, laws: Laws, dt: float) -> None:
    """Let islands sleep that have been quiet for long enough; called when a tick is over."""
    bodies = t.bodies
    count = t.counts.bodies[0]
    ready = False
    for row in range(count):
        if bodies.inverse_mass[row] > 0.0:
            bodies.quiet[row] += dt
            quick = speed(t, row) >= laws.sleep_speed or bodies.parting[row] == 1
            if bodies.held[row] == 0 or quick:
                bodies.quiet[row] = 0.0
            ready = ready or bodies.quiet[row] >= laws.sleep_time
    if not ready or t.state.tick[0] % EVERY != 0:
        return
    mark_restless(t, laws)
    spread(t)
    for row in range(count):
        if (
            bodies.inverse_mass[row] > 0.0
            and bodies.restless[row] == 0
            and bodies.anchored[row] == 1
        ):
            lay_down(t, row)
    for pair in range(t.counts.pairs[0]):
        if t.pairs.state[pair] == RESTING and both_stand(t, pair):
            t.pairs.state[pair] = SLEEPING


def speed(t: Tables, row: int) -> float:
    """A bound of the speed of any point of a body (m/s)."""
    bodies = t.bodies
    return abs(bodies.vx[row]) + abs(bodies.vy[row]) + abs(bodies.spin[row]) * bodies.reach[row]


def both_stand(t: Tables, pair: int) -> bool:
    """Whether nothing moves the bodies of a pair, or they sleep."""
    inverse = t.bodies.inverse_mass
    return inverse[t.pairs.a[pair]] == 0.0 and inverse[t.pairs.b[pair]] == 0.0


def mark_restless(t: Tables, laws: Laws) -> None:
    """Mark the bodies that cannot sleep yet, and those that rest on something immovable."""
    bodies = t.bodies
    for row in range(t.counts.bodies[0]):
        restless = bodies.quiet[row] < laws.sleep_time or bodies.joined[row] == 1
        bodies.restless[row] = 1 if restless else 0
        bodies.anchored[row] = 0
    for push in range(t.counts.pushes[0]):
        bodies.restless[t.pushes.row[push]] = 1
    for field in range(t.fields.used[0]):
        if t.fields.kind[field] == GIVEN:
            bodies.restless[t.fields.row[field]] = 1
    for pair in range(t.counts.pairs[0]):
        if t.pairs.state[pair] == RESTING:
            a = t.pairs.a[pair]
            b = t.pairs.b[pair]
            if bodies.inverse_mass[a] == 0.0:
                lean_on(t, b, a)
            elif bodies.inverse_mass[b] == 0.0:
                lean_on(t, a, b)


def lean_on(t: Tables, row: int, support: int) -> None:
    """Note that a body rests on one that no force moves, which may be on its way."""
    if speed(t, support) > 0.0:
        t.bodies.restless[row] = 1
    else:
        t.bodies.anchored[row] = 1


def spread(t: Tables) -> None:
    """Let all bodies of an island be restless, or anchored, if one of them is."""
    bodies = t.bodies
    changed = True
    while changed:
        changed = False
        for pair in range(t.counts.pairs[0]):
            if t.pairs.state[pair] != RESTING:
                continue
            a = t.pairs.a[pair]
            b = t.pairs.b[pair]
            if bodies.inverse_mass[a] == 0.0 or bodies.inverse_mass[b] == 0.0:
                continue
            if bodies.restless[a] != bodies.restless[b]:
                bodies.restless[a] = bodies.restless[b] = 1
                changed = True
            if bodies.anchored[a] != bodies.anchored[b]:
                bodies.anchored[a] = bodies.anchored[b] = 1
                changed = True


def lay_down(t: Tables, row: int) -> None:
    """Let a body sleep."""
    bodies = t.bodies
    book_halt(t, row)
    bodies.asleep[row] = 1
    bodies.moves[row] = 0
    bodies.inverse_mass[row] = bodies.inverse_inertia[row] = 0.0
    bodies.vx[row] = bodies.vy[row] = bodies.spin[row] = 0.0
    bodies.ax[row] = bodies.ay[row] = bodies.aspin[row] = 0.0
    bodies.lead_x[row] = bodies.lead_y[row] = bodies.lead_spin[row] = 0.0
    bodies.force_x[row] = bodies.force_y[row] = bodies.torque[row] = 0.0
    put(bodies, t.corners, row, bodies.x[row], bodies.y[row], bodies.angle[row])


def wake(t: Tables, row: int) -> None:
    """Wake a body with its island, if it sleeps."""
    bodies = t.bodies
    pairs = t.pairs
    if bodies.asleep[row] == 0:
        return
    get_up(t, row)
    t.progress.roused[0] = ALL  # for what waits on it, it was ground
    changed = True
    while changed:
        changed = False
        for pair in range(t.counts.pairs[0]):
            if pairs.state[pair] == SLEEPING and not both_stand(t, pair):
                pairs.state[pair] = RESTING
                changed = True
                if bodies.asleep[pairs.a[pair]] == 1:
                    get_up(t, pairs.a[pair])
                elif bodies.asleep[pairs.b[pair]] == 1:
                    get_up(t, pairs.b[pair])


def get_up(t: Tables, row: int) -> None:
    """Wake one body; it is restless from now on."""
    bodies = t.bodies
    bodies.asleep[row] = 0
    bodies.moves[row] = 1
    bodies.inverse_mass[row] = 1.0 / bodies.mass[row]
    bodies.inverse_inertia[row] = 1.0 / bodies.inertia[row]
    bodies.quiet[row] = 0.0
    bodies.restless[row] = 1
    bodies.path_x[row] = bodies.path_y[row] = bodies.path_spin[row] = 0.0


def wake_in_time(t: Tables, laws: Laws, dt: float) -> None:
    """Wake the islands that something may touch within a tick (s), before it moves.

    Forces have acted on the others already; now they act on what woke. What wakes later in the
    tick is restless: no force acts on it in this tick (`books.book_forces`).
    """
    bodies = t.bodies
    pairs = t.pairs
    count = t.counts.bodies[0]
    for row in range(count):
        bodies.restless[row] = 0
    for pair in range(t.counts.pairs[0]):
        a = pairs.a[pair]
        b = pairs.b[pair]
        if pairs.state[pair] == FREE and bodies.asleep[a] != bodies.asleep[b]:
            sleeper = a if bodies.asleep[a] == 1 else b
            comes = a + b - sleeper
            if bodies.moves[comes] == 1 and is_near(t, pair, comes, dt):
                wake(t, sleeper)
    for row in range(count):
        if bodies.restless[row] == 1:
            bodies.restless[row] = 0
            act_on(bodies, row, t.fields, laws, dt)


def is_near(t: Tables, pair: int, comes: int, dt: float) -> bool:
    """Whether a body may touch the other of its pair, which stands, within a tick (s)."""
    bodies = t.bodies
    gained = abs(bodies.ax[comes]) + abs(bodies.ay[comes])
    gained += abs(bodies.aspin[comes]) * bodies.reach[comes]
    way = (speed(t, comes) + gained * dt) * dt
    return gap_at(t, pair, 0.0) <= 1.01 * way + 1e-4 * t.pairs.size[pair]
