"""Forces given as Python functions: asked between the kernels, before each tick.

A function is asked at the start of the tick; for velocity Verlet and Runge-Kutta once more at its
end, with every body where it would be if the forces at the start went on. That makes both methods
of second order in such forces. A call costs what Python costs, some microseconds a body, and one
more pass of the kernels that let forces act.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from engine.force_laws import effort
from engine.kernels.fields import GIVEN
from engine.settings import RK4, VELOCITY_VERLET, Laws
from engine.store import Store

MOVED = ("x", "y", "angle", "vx", "vy", "spin")


def ask_functions(store: Store, laws: Laws, dt: float) -> None:
    """Let the laws of force that are Python functions say what they give in a tick of `dt` (s)."""
    if any(law.is_python for law in store.acting.values()):
        ask(store, laws, dt)


def ask(store: Store, laws: Laws, dt: float) -> None:
    """Write to `Fields` what the functions give for a tick.

    Args:
        store: of the world.
        laws: of the world.
        dt: length of the tick (s).
    """
    fields = store.tables.fields
    for i, (x, y, torque) in answers(store, store.time):
        fields.x[i], fields.y[i], fields.torque[i] = x, y, torque
        fields.later_x[i], fields.later_y[i], fields.later_torque[i] = x, y, torque
    if laws.integrator in (VELOCITY_VERLET, RK4):
        with foreseen(store, laws, dt):
            at_the_end = answers(store, store.time + dt)
        for i, given in at_the_end:
            fields.later_x[i], fields.later_y[i], fields.later_torque[i] = given


def answers(store: Store, time: float) -> list[tuple[int, tuple[float, float, float]]]:
    """Rows of `Fields` that functions fill, with force and torque at a time (s)."""
    given = []
    fields = store.tables.fields
    for i in range(fields.used[0]):
        if fields.kind[i] == GIVEN:
            law = store.acting[fields.law[i]]
            function: Any = law.law
            given.append((i, effort(function(store.handles[fields.row[i]], time), law)))
    return given


@contextmanager
def foreseen(store: Store, laws: Laws, dt: float) -> Iterator[None]:
    """Put the bodies where forces alone would bring them in `dt` seconds; afterwards, back."""
    from engine.kernels.tick import act  # see `store`

    bodies, count = store.tables.bodies, store.count("bodies")
    left = np.asarray(store.tables.pushes.left)
    column = {name: np.asarray(getattr(bodies, name))[:count] for name in bodies._fields}
    before = {name: column[name].copy() for name in MOVED}
    time_left = left.copy()
    try:
        act(store.tables, laws, dt)
        for pose, speed, lead, force in (
            ("x", "vx", "lead_x", "ax"),
            ("y", "vy", "lead_y", "ay"),
            ("angle", "spin", "lead_spin", "aspin"),
        ):
            column[pose] += (column[speed] + column[lead] + column[force] * (dt / 2.0)) * dt
            column[speed] += column[force] * dt
        yield
    finally:
        left[:] = time_left
        for name in MOVED:
            column[name][:] = before[name]
