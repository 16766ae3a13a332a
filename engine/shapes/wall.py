"""What stands in a room and never moves: straight walls, and chains of them."""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

from engine import validate
from engine.shapes.piece import Piece
from engine.vector import Vector, distance

MOST_POINTS = 100_000
"""Points of a chain."""


@dataclass(frozen=True)
class Wall:
    """An immovable straight wall without thickness, solid from both sides and at its ends.

    Its positive side is to the left of `start` -> `end`. A one-sided wall stops what comes from its
    positive side and lets through what comes from behind.
    """

    start: Vector
    """(m), in world coordinates."""
    end: Vector
    """(m), in world coordinates."""
    one_sided: bool = False

    def __init__(self, start: Any, end: Any, one_sided: bool = False) -> None:
        """Take two different points as (x, y) pairs (m, world coordinates)."""
        first, last = validate.vector(start, "start"), validate.vector(end, "end")
        if distance(first, last) <= 0.0:
            raise ValueError(f"a wall must have a length, but starts and ends at {tuple(first)}")
        object.__setattr__(self, "start", first)
        object.__setattr__(self, "end", last)
        object.__setattr__(self, "one_sided", validate.truth(one_sided, "one_sided"))

    def __str__(self) -> str:
        """Say from where to where it goes."""
        return f"Wall from {tuple(self.start)} to {tuple(self.end)}"

    @property
    def normal(self) -> Vector:
        """Unit vector to the positive side."""
        x, y = self.end.x - self.start.x, self.end.y - self.start.y
        length = math.sqrt(x * x + y * y)
        return Vector(-y / length, x / length)

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """The wall, in world coordinates."""
        return (Piece((self.start, self.end), self.middle, one_sided=self.one_sided),)

    @property
    def middle(self) -> Vector:
        """(m), in world coordinates."""
        return Vector((self.start.x + self.end.x) / 2.0, (self.start.y + self.end.y) / 2.0)


@dataclass(frozen=True)
class Chain:
    """Immovable walls end to end, over whose inner corners bodies slide and roll unhindered.

    Like walls they have no thickness and are solid from both sides and at the two ends of the
    chain; `one_sided` ones stop what comes from the left of their way and let through the rest.
    Points that repeat the one before are left out.
    """

    points: tuple[Vector, ...]
    """In sequence (m), in world coordinates."""
    loop: bool = False
    """Whether the last point is joined to the first."""
    one_sided: bool = False

    def __init__(self, points: Iterable[Any], loop: bool = False, one_sided: bool = False) -> None:
        """Take two or more different points as (x, y) pairs (m), three or more for a loop."""
        given = validate.vectors(points, "points", MOST_POINTS)
        loop = validate.truth(loop, "loop")
        kept = [p for i, p in enumerate(given) if i == 0 or p != given[i - 1]]
        if loop and len(kept) > 1 and kept[0] == kept[-1]:
            kept.pop()
        least = 3 if loop else 2
        if len(kept) < least:
            raise ValueError(f"a chain needs at least {least} different points, not {len(kept)}")
        object.__setattr__(self, "points", tuple(kept))
        object.__setattr__(self, "loop", loop)
        object.__setattr__(self, "one_sided", validate.truth(one_sided, "one_sided"))

    def __str__(self) -> str:
        """Say how many points it has; `repr` lists them."""
        return f"Chain of {len(self.points)} points"

    @property
    def middle(self) -> Vector:
        """Middle of the box around it (m), in world coordinates."""
        xs, ys = [p.x for p in self.points], [p.y for p in self.points]
        return Vector((min(xs) + max(xs)) / 2.0, (min(ys) + max(ys)) / 2.0)

    @cached_property
    def pieces(self) -> tuple[Piece, ...]:
        """Its links, in world coordinates."""
        ends = list(pairwise((*self.points, self.points[0]) if self.loop else self.points))
        links = []
        for i, (start, end) in enumerate(ends):
            before = i if i > 0 else (len(ends) if self.loop else 0)
            after = i + 2 if i + 1 < len(ends) else (1 if self.loop else 0)
            middle = Vector((start.x + end.x) / 2.0, (start.y + end.y) / 2.0)
            links.append(
                Piece((start, end), middle, one_sided=self.one_sided, before=before, after=after)
            )
        return tuple(links)
