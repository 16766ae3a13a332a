"""A copy of all that varies in a world, to come back to."""

import struct
from typing import Any, NamedTuple

import numpy as np

from engine.body import Body
from engine.filters import ALL
from engine.force_laws import ActingLaw
from engine.joints import Joint
from engine.settings import AS_FRICTION
from engine.tables import Bodies, Pushes, arrays

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


def digest(
    bodies: Bodies, count: int, pushes: Pushes, pushing: int, clock: tuple[float, ...], rest: Any
) -> str:
    """Hash of the bytes of the state (SHA-256, hexadecimal): equal worlds have equal digests.

    Names, callbacks, the process and the machine have no part in it; `rest` holds arrays of the
    resting contacts.
    """
    import hashlib  # see `materials`

    hashed = hashlib.sha256(struct.pack("<qq", count, pushing))
    hashed.update(struct.pack(f"<{len(clock)}d", *clock))
    columns = [np.asarray(getattr(bodies, name))[:count] for name in STATE]
    columns += [column[:pushing] for column in arrays(pushes)]
    for name, usual in UNUSUAL.items():
        column = np.asarray(getattr(bodies, name))[:count]
        if (column != usual).any():
            hashed.update(name.encode())
            columns.append(column)
    for column in [*columns, *rest]:
        kind = "<i8" if column.dtype.kind == "i" else "<f8"
        hashed.update(np.ascontiguousarray(column).astype(kind, copy=False).tobytes())
    return hashed.hexdigest()
