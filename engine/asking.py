"""Forces given as Python functions: asked between the kernels, before each tick.

A function is asked at the start of the tick; for velocity Verlet and Runge-Kutta once more at its
end, with every body where it would be if the forces at the start went on. That makes both methods
of second order in such forces. A call costs what Python costs, some microseconds a body, and one
more pass of the kernels that let forces act.
"""

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from typing import Any

import numpy as np

from engine.force_laws import effort
from engine.settings import RK4, VELOCITY_VERLET, Laws
from engine.store import Store
from engine.tables.bodies import GIVEN

Columns = dict[str, Any]
"""Arrays by the names of columns."""

ACTED_ON = (
    "x", "y", "angle", "vx", "vy", "spin", "ax", "ay", "aspin", "lead_x", "lead_y", "lead_spin",
    "force_x", "force_y", "torque", "field_x", "field_y",
)  # fmt: skip
"""Columns of `Bodies` that a look ahead changes."""

ANSWERS = ("x", "y", "torque", "later_x", "later_y", "later_torque")
"""Columns of `Fields` that functions fill."""


def ask_functions(store: Store, laws: Laws, dt: float) -> None:
    """Let the laws of force that are Python functions say what they give in a tick of `dt` (s)."""
    if any(law.is_python for law in store.acting.values()):
        ask(store, laws, dt)


def ask(store: Store, laws: Laws, dt: float) -> None:
    """Write to `Fields` what the functions give for a tick; if one fails, nothing has changed.

    Args:
        store: of the world.
        laws: of the world.
        dt: length of the tick (s).
    """
    fields = store.tables.fields
    with store.asked(), ExitStack() as undo:
        undo.callback(put_back, *copied(fields, ANSWERS, fields.used[0]))
        for i, (x, y, torque) in answers(store, store.time):
            fields.x[i], fields.y[i], fields.torque[i] = x, y, torque
            fields.later_x[i], fields.later_y[i], fields.later_torque[i] = x, y, torque
        if laws.integrator in (VELOCITY_VERLET, RK4):
            with foreseen(store, laws, dt):
                at_the_end = answers(store, store.time + dt)
            for i, given in at_the_end:
                fields.later_x[i], fields.later_y[i], fields.later_torque[i] = given
        undo.pop_all()


def copied(table: Any, names: tuple[str, ...], rows: int) -> tuple[Columns, Columns]:
    """Columns of a table as arrays, and copies of them."""
    columns = {name: np.asarray(getattr(table, name))[:rows] for name in names}
    return columns, {name: column.copy() for name, column in columns.items()}


def put_back(columns: Columns, before: Columns) -> None:
    """Let columns hold again what they held before."""
    for name, column in columns.items():
        column[:] = before[name]


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

    tables = store.tables
    bodies, bodies_before = copied(tables.bodies, ACTED_ON, store.count("bodies"))
    pushes, pushes_before = copied(tables.pushes, ("left",), store.count("pushes"))
    try:
        act(tables, laws, dt)
        for pose, speed, lead, force in (
            ("x", "vx", "lead_x", "ax"),
            ("y", "vy", "lead_y", "ay"),
            ("angle", "spin", "lead_spin", "aspin"),
        ):
            bodies[pose] += (bodies[speed] + bodies[lead] + bodies[force] * (dt / 2.0)) * dt
            bodies[speed] += bodies[force] * dt
        yield
    finally:
        put_back(bodies, bodies_before)
        put_back(pushes, pushes_before)
