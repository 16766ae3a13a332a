"""The three kernels of a step, as the world calls them: interpreted or compiled."""

from engine.accelerate import accelerate
from engine.broadphase import holds
from engine.settings import Laws
from engine.tables import Pushes, Tables
from engine.travel import begin, end, runaway, travel

SOUND = -1
"""No body has run away."""


def start(
    t: Tables, count: int, pushes: Pushes, pushing: int, laws: Laws, dt: float
) -> tuple[int, bool]:
    """Let forces accelerate the bodies for a tick of `dt` seconds.

    Returns the row of a body that leaves the range of numbers, or `SOUND`, and whether the list of
    pairs holds for this tick.
    """
    accelerate(t.bodies, count, pushes, pushing, t.fields, laws, dt)
    lost = runaway(t.bodies, count, dt)
    if lost != SOUND:
        return lost, False
    return SOUND, holds(t, count, dt)


def go(
    t: Tables, count: int, pair_count: int, now: float, dt: float, substep: float, limit: int
) -> tuple[int, float]:
    """Move the bodies from `now` on (s, since the tick began); see `travel` for what it returns."""
    if now == 0.0 and t.impacts.written[1] < 0:
        t.impacts.written[1] = 0
        begin(t, count, pair_count, substep)
    return travel(t, count, pair_count, now, dt, substep, limit)


def finish(t: Tables, count: int, pair_count: int, laws: Laws, dt: float) -> int:
    """End the tick; return the row of a body that left the range of numbers, or `SOUND`."""
    end(t, count, pair_count, laws.integrator, dt)
    return runaway(t.bodies, count, dt)
