"""A pair of numbers with a direction, and its geometry, to the same bits on every machine."""

import math
from typing import NamedTuple, Self

from engine.kernels.elementary import cos_sin

HALVINGS = 3
"""An angle of an eighth turn, halved so often, is where the series of the arctangent is short."""


class Vector(NamedTuple):
    """A vector of the plane: x to the right, y upwards; its unit is that of what it describes."""

    x: float
    y: float

    @classmethod
    def polar(cls, length: float, angle: float) -> Self:
        """The vector of a length that points in a direction (rad, from the x axis to the left)."""
        cos, sin = cos_sin(angle)
        return cls(length * cos, length * sin)

    @property
    def angle(self) -> float:
        """Its direction (rad), from -pi to pi; 0 for the null vector.

        The angle of half the slope's arctangent has the slope t/(1 + sqrt(1 + t^2)).
        """
        x, y = abs(self.x), abs(self.y)
        if x == y == 0.0:
            return 0.0
        t = y / x if y < x else x / y
        for _ in range(HALVINGS):
            t /= 1.0 + math.sqrt(1.0 + t * t)
        s = t * t
        series = 0.0
        for odd in range(17, 0, -2):
            series = 1.0 / odd - s * series
        angle = float(1 << HALVINGS) * t * series
        if y >= x:
            angle = math.pi / 2.0 - angle
        if self.x < 0.0:
            angle = math.pi - angle
        return -angle if self.y < 0.0 else angle


def distance(a: tuple[float, float], b: tuple[float, float]) -> float:
    """Between two points."""
    x, y = b[0] - a[0], b[1] - a[1]
    return math.sqrt(x * x + y * y)


def rotated(point: tuple[float, float], angle: float) -> Vector:
    """A vector turned about the origin, to the left (rad)."""
    cos, sin = cos_sin(angle)
    return Vector(cos * point[0] - sin * point[1], sin * point[0] + cos * point[1])
