"""Collisions that are still shown: their impulses fade within half a second of the world's time."""

import math
from collections.abc import Iterable, Sequence

from engine import Collision, Vector

FADE = 0.5
"""How long the impulses of a collision are shown (s)."""
LEAST = 0.005
"""Weaker impulses (N s) are not shown: those of a body that comes to rest on a wall."""


def is_fresh(hit: Collision, now: float) -> bool:
    """Whether a collision is still shown at a time of the world (s)."""
    return now - hit.time < FADE and size(hit.impulse) >= LEAST


def fresh(hits: Iterable[Collision], now: float) -> tuple[Collision, ...]:
    """Those that are still shown at a time of the world (s)."""
    return tuple(hit for hit in hits if is_fresh(hit, now))


def fading(hit: Collision, now: float) -> float:
    """How visible a collision still is: from 1 when it happens down to 0."""
    return min(max(1.0 - (now - hit.time) / FADE, 0.0), 1.0)


def strongest(hits: Sequence[Collision], count: int) -> list[Collision]:
    """Those with the greatest impulses, in the order in which they happened."""
    ranked = sorted(range(len(hits)), key=lambda i: (-size(hits[i].impulse), i))
    return [hits[i] for i in sorted(ranked[:count])]


def size(vector: Vector) -> float:
    """Length of a vector, in its own unit."""
    return math.sqrt(vector.x * vector.x + vector.y * vector.y)


def reach(vector: Vector, per_unit: float, longest: float) -> tuple[float, float]:
    """How far the arrow of a vector reaches (dp, +y up): in proportion, up to a greatest length."""
    length = size(vector)
    if length == 0.0:
        return (0.0, 0.0)
    drawn = min(length * per_unit, longest)
    return (vector.x / length * drawn, vector.y / length * drawn)
