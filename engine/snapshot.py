"""A copy of all that varies in a world, to come back to."""

import struct
from typing import Any, NamedTuple

import numpy as np

from engine.body import Body
from engine.filters import ALL, ignored_columns
from engine.force_laws import ActingLaw, field_columns
from engine.joint import Joint
from engine.pair_rows import resting_columns
from engine.settings import AS_FRICTION, Laws, Rules
from engine.tables import State, Tables, arrays

STATE = (
    "id", "x", "y", "angle", "vx", "vy", "spin", "mass", "inertia", "restitution", "friction",
    "force_x", "force_y", "torque", "held", "calm",
)  # fmt: skip
"""The columns of `Bodies` that tell two worlds apart; the others follow from them."""

UNUSUAL = {
    "gravity_scale": 1.0, "category": 1, "mask": ALL, "group": 0, "sensor": 0,
    "static_friction": AS_FRICTION, "rolling_resistance": 0.0, "surface_speed": 0.0, "material": 0,
    "asleep": 0, "quiet": 0.0,
}  # fmt: skip
"""More such columns, hashed only if a body differs from what most have."""


class Snapshot(NamedTuple):
    """What `World.snapshot` copied; good for `World.restore`, any number of times."""

    tables: dict[str, tuple[Any, ...]]
    """Copies of the columns of each table that a world remembers, cut to the rows in use."""
    handles: tuple[Body, ...]
    force_laws: tuple[ActingLaw, ...]
    joints: tuple[Joint, ...]
    laws: Laws
    """Gravity among them, which may be set."""
    rules: Rules

    def __repr__(self) -> str:
        """Say of how many bodies it is, and of which tick."""
        tick = self.tables["state"][State._fields.index("tick")][0]
        return f"<Snapshot: {len(self.handles)} bodies, after tick {tick}>"


def digest(t: Tables, time: float) -> str:
    """Hash of the bytes of the state (SHA-256, hexadecimal): equal worlds have equal digests.

    Names, callbacks, the process and the machine have no part in it. Time is that of the world (s).
    """
    import hashlib  # see `materials`

    count, pushing = t.counts.bodies[0], t.counts.pushes[0]
    hashed = hashlib.sha256(struct.pack("<qqdd", count, pushing, t.state.tick[0], time))
    columns = [np.asarray(getattr(t.bodies, name))[:count] for name in STATE]
    columns += [column[:pushing] for column in arrays(t.pushes)]
    for name, usual in UNUSUAL.items():
        column = np.asarray(getattr(t.bodies, name))[:count]
        if (column != usual).any():
            hashed.update(name.encode())
            columns.append(column)
    columns += [*resting_columns(t, t.counts.pairs[0]), *field_columns(t.fields)]
    columns += ignored_columns(t)
    if t.counts.joints[0]:
        columns += [column[: t.counts.joints[0]] for column in arrays(t.joints)]
        columns += [np.asarray(column) for column in (t.state.pace, t.state.asked, t.state.paced)]
    columns += [column[: t.counts.materials[0]] for column in arrays(t.materials)]
    for column in columns:
        kind = "<i8" if column.dtype.kind == "i" else "<f8"
        hashed.update(np.ascontiguousarray(column).astype(kind, copy=False).tobytes())
    return hashed.hexdigest()
