"""What a step reports."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

from engine.tables import Impacts
from engine.vector import Vector

if TYPE_CHECKING:
    from engine.body import Body


_row = tuple.__new__
"""Makes named tuples in half the time that their classes take."""


class Collision(NamedTuple):
    """One impact of two bodies: they met with some speed and were turned back."""

    a: "Body"
    b: "Body"
    point: Vector
    """Where they touched (m, world)."""
    normal: Vector
    """Unit vector from a to b."""
    impulse: Vector
    """What b received (N s, world); a received its exact opposite."""
    speed: float
    """With which they approached each other along the normal, before (m/s, >= 0)."""
    restitution: float
    """Of the pair, 0..1."""
    time: float
    """Of the impact (s, time of the world)."""


def read(impacts: Impacts, handles: Sequence["Body"]) -> list[Collision]:
    """Turn the table of impacts into collisions and empty it.

    Args:
        impacts: the table, with times of the world.
        handles: the bodies in order of their rows.
    """
    number = impacts.written[0]
    impacts.written[0] = 0
    a, b, time = impacts.a, impacts.b, impacts.time
    x, y, speed, restitution = impacts.x, impacts.y, impacts.speed, impacts.restitution
    normal_x, normal_y = impacts.normal_x, impacts.normal_y
    impulse_x, impulse_y = impacts.impulse_x, impacts.impulse_y
    return [
        _row(
            Collision,
            (
                handles[a[i]],
                handles[b[i]],
                _row(Vector, (x[i], y[i])),
                _row(Vector, (normal_x[i], normal_y[i])),
                _row(Vector, (impulse_x[i], impulse_y[i])),
                speed[i],
                restitution[i],
                time[i],
            ),
        )
        for i in range(number)
    ]


class Diverged(ArithmeticError):
    """A body left the range of numbers; the sentence names the tick and the body."""


class Removed(LookupError):
    """A body was used after it had been removed from its world."""
