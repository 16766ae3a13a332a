"""Shapes without corners: discs, and the stadium that a disc sweeps along a line."""

import math
from dataclasses import dataclass
from functools import lru_cache

from engine import validate
from engine.shapes.piece import ALIKE, ORIGIN, Piece
from engine.vector import Vector


@dataclass(frozen=True)
class _Round:
    """What discs have in common, whether they turn or not."""

    radius: float
    """(m)"""

    def __post_init__(self) -> None:
        """Refuse a radius that is no positive number."""
        object.__setattr__(self, "radius", validate.positive(self.radius, "radius"))

    @property
    def area(self) -> float:
        """(m^2)"""
        return math.pi * self.radius * self.radius

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """The disc."""
        return _disc(self.radius)


@dataclass(frozen=True)
class Circle(_Round):
    """A disc of uniform density, of some `radius` (m); it spins."""

    def inertia(self, mass: float) -> float:
        """Mass moment of inertia about the centre (kg m^2): m r^2 / 2."""
        return mass * self.radius * self.radius / 2.0


@dataclass(frozen=True)
class Particle(_Round):
    """A small round body of some `radius` (m) that never rotates: its inertia is infinite."""

    def inertia(self, mass: float) -> float:
        """Infinite, whatever the mass: no torque turns it."""
        del mass
        return math.inf


@dataclass(frozen=True)
class Capsule:
    """A stadium of uniform density: a rectangle between two half discs, along the x axis.

    Args:
        length: of the straight part (m): from the centre of one half disc to that of the other.
        radius: of the half discs (m): the capsule is length + 2 radius long and 2 radius wide.
    """

    length: float
    radius: float

    def __post_init__(self) -> None:
        """Refuse what is no positive number."""
        object.__setattr__(self, "length", validate.positive(self.length, "length"))
        object.__setattr__(self, "radius", validate.positive(self.radius, "radius"))

    @property
    def area(self) -> float:
        """(m^2)"""
        return self.radius * (2.0 * self.length + math.pi * self.radius)

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """The stadium."""
        return _stadium(self.length / 2.0, self.radius)

    def inertia(self, mass: float) -> float:
        """Mass moment of inertia about the centre (kg m^2).

        A rectangle l x 2r and a disc of which each half has moved out by l/2: about the centre of
        its full circle a half disc has r^2/2 for 1 kg, its centre of mass lies 4r/(3 pi) further
        out than that centre, so moving it by l/2 adds l^2/4 + (l/2) 2 (4r/(3 pi)).
        """
        length, radius = self.length, self.radius
        of_ends = radius * radius / 2.0 + length * length / 4.0
        of_ends += 4.0 * radius * length / (3.0 * math.pi)
        of_middle = (length * length + 4.0 * radius * radius) / 12.0
        share = math.pi * radius / (math.pi * radius + 2.0 * length)
        return mass * (share * of_ends + (1.0 - share) * of_middle)


@lru_cache(ALIKE)
def _disc(radius: float) -> tuple[Piece, ...]:
    return (Piece((ORIGIN,), radius=radius),)


@lru_cache(ALIKE)
def _stadium(half: float, radius: float) -> tuple[Piece, ...]:
    return (Piece((Vector(-half, 0.0), Vector(half, 0.0)), radius=radius),)
