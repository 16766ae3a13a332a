"""What a step reports."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from engine.vector import Vector

if TYPE_CHECKING:
    from engine.body import Body


@dataclass(frozen=True, slots=True)
class Collision:
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


class Diverged(ArithmeticError):
    """A body left the range of numbers; the sentence names the tick and the body."""


class Removed(LookupError):
    """A body was used after it had been removed from its world."""
