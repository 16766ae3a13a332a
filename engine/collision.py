"""What a step reports."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

from engine.tables import Impacts
from engine.vector import Vector

if TYPE_CHECKING:
    from engine.body import Body


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
    return [
        Collision(
            a=handles[impacts.a[i]],
            b=handles[impacts.b[i]],
            point=Vector(impacts.x[i], impacts.y[i]),
            normal=Vector(impacts.normal_x[i], impacts.normal_y[i]),
            impulse=Vector(impacts.impulse_x[i], impacts.impulse_y[i]),
            speed=impacts.speed[i],
            restitution=impacts.restitution[i],
            time=impacts.time[i],
        )
        for i in range(number)
    ]


class Diverged(ArithmeticError):
    """A body left the range of numbers; the sentence names the tick and the body."""


class Removed(LookupError):
    """A body was used after it had been removed from its world."""
