"""Several shapes that are one rigid body."""

import math
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Union

from engine import validate
from engine.shapes.concave import Concave
from engine.shapes.piece import Piece
from engine.shapes.polygon import Box, Polygon
from engine.shapes.round import Capsule, Circle
from engine.validate import shown
from engine.vector import Vector

MOST_PARTS = 4096
"""Parts of a compound."""

Part = Union[Circle, Capsule, Polygon, Box, Concave, "Compound"]
"""What a compound can be made of."""


@dataclass(frozen=True)
class Compound:
    """Shapes joined to one rigid body; its centre of mass is the origin of its coordinates.

    The parts have masses in proportion to their areas, unless others are given; where parts
    overlap, both count.
    """

    parts: tuple[tuple[Part, Vector, float], ...]
    """Shape, where its centre of mass is (m), and by how much it is turned (rad)."""
    masses: tuple[float, ...] | None = None
    """Of the parts, in any unit: only their ratios matter."""
    area: float = field(init=False, compare=False, repr=False)
    """Of all parts (m^2)."""
    centroid: Vector = field(init=False, compare=False, repr=False)
    """Where the centre of mass lay in the coordinates that were given (m)."""
    gyration: float = field(init=False, compare=False, repr=False)
    """Mass moment of inertia about the centre of mass for 1 kg (m^2), by Steiner's theorem."""

    def __init__(self, parts: Iterable[Any], masses: Iterable[float] | None = None) -> None:
        """Take parts: a shape, (shape, offset), or (shape, offset, angle); (m), (rad)."""
        given = [
            _part(part, f"parts[{i}]")
            for i, part in enumerate(validate.sequence(parts, "parts", MOST_PARTS))
        ]
        if not given:
            raise ValueError("a compound needs at least one part")
        weights = _weights(given, masses)
        total = _sum(weights)
        if not 0.0 < total < math.inf:
            raise ValueError(f"a compound must have an area that can be computed, not {total}")
        pairs = list(zip(given, weights, strict=True))
        x = _sum(weight * at.x for (_, at, _), weight in pairs) / total
        y = _sum(weight * at.y for (_, at, _), weight in pairs) / total
        own = tuple((shape, Vector(at.x - x, at.y - y), angle) for shape, at, angle in given)
        turning = _sum(
            weight * (shape.inertia(1.0) + at.x * at.x + at.y * at.y)
            for (shape, at, _), weight in zip(own, weights, strict=True)
        )
        if not turning / total < math.inf:
            raise ValueError("a compound must have a moment of inertia that can be computed")
        object.__setattr__(self, "parts", own)
        object.__setattr__(self, "masses", None if masses is None else tuple(weights))
        object.__setattr__(self, "area", math.fsum(shape.area for shape, _, _ in own))
        object.__setattr__(self, "centroid", Vector(x, y))
        object.__setattr__(self, "gyration", turning / total)

    def __str__(self) -> str:
        """Say how many parts it has; `repr` lists them."""
        return f"Compound of {len(self.parts)} parts"

    @cached_property
    def pieces(self) -> tuple[Piece, ...]:
        """The pieces of all parts, where they are."""
        from engine.shapes.seams import sewn  # see `concave`

        return sewn(
            [piece.moved(at, angle) for shape, at, angle in self.parts for piece in shape.pieces]
        )

    def inertia(self, mass: float) -> float:
        """Mass moment of inertia about the centre of mass (kg m^2)."""
        return mass * self.gyration


def _sum(values: Iterable[float]) -> float:
    """The sum, rounded once; infinite if no number can hold it."""
    each = list(values)
    return math.fsum(each) if math.isfinite(sum(each)) else math.inf


JOINABLE = (Circle, Capsule, Polygon, Box, Concave, Compound)
"""What can be a part."""


def _part(given: Any, name: str) -> tuple[Part, Vector, float]:
    """Check one part."""
    each = tuple(given) if isinstance(given, tuple | list) else (given,)
    if not each or len(each) > 3 or not isinstance(each[0], JOINABLE):
        raise TypeError(
            f"{name} must be a Circle, Capsule, Polygon, Box, Concave or Compound, with an offset "
            f"and an angle if there are any, not {shown(given)}"
        )
    offset = validate.vector(each[1] if len(each) > 1 else (0.0, 0.0), f"{name} offset")
    return each[0], offset, validate.finite(each[2] if len(each) > 2 else 0.0, f"{name} angle")


def _weights(parts: list[tuple[Part, Vector, float]], masses: Any) -> list[float]:
    """Masses of the parts: those given, or their areas."""
    if masses is None:
        return [shape.area for shape, _, _ in parts]
    weights = [
        validate.positive(mass, f"masses[{i}]")
        for i, mass in enumerate(validate.sequence(masses, "masses", MOST_PARTS))
    ]
    if len(weights) != len(parts):
        raise ValueError(f"masses must be {len(parts)}, one a part, not {len(weights)}")
    return weights
