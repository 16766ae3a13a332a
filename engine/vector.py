"""A pair of numbers with a direction, and its geometry, to the same bits on every machine."""

import math
from contextlib import suppress
from numbers import Real
from typing import Any, NamedTuple, Self

from engine.kernels.elementary import cos_sin

HALVINGS = 3
"""An angle of an eighth turn, halved so often, is where the series of the arctangent is short."""


class Vector(NamedTuple):
    """A vector of the plane: x to the right, y upwards; its unit is that of what it describes.

    Vectors, or a vector and any pair of numbers, are added and subtracted; by a number they are
    multiplied and divided. Everything else is that of a tuple.
    """

    x: float
    y: float

    def __add__(self, other: Any) -> "Vector":
        """Their sum."""
        x, y = _pair(other)
        return Vector(self.x + x, self.y + y)

    def __radd__(self, other: Any) -> "Vector":
        """The same, the pair first."""
        return self.__add__(other)

    def __sub__(self, other: Any) -> "Vector":
        """What leads from the other to this one."""
        x, y = _pair(other)
        return Vector(self.x - x, self.y - y)

    def __rsub__(self, other: Any) -> "Vector":
        """What leads from this one to the other."""
        x, y = _pair(other)
        return Vector(x - self.x, y - self.y)

    def __mul__(self, by: Any) -> "Vector":
        """So many times as long."""
        share = _number(by)
        return Vector(share * self.x, share * self.y)

    def __rmul__(self, by: Any) -> "Vector":
        """The same, the number first."""
        return self.__mul__(by)

    def __truediv__(self, by: Any) -> "Vector":
        """As long as one of so many parts."""
        parts = _number(by)
        return Vector(self.x / parts, self.y / parts)

    def __neg__(self) -> "Vector":
        """The opposite."""
        return Vector(-self.x, -self.y)

    @property
    def length(self) -> float:
        """Its length, never negative."""
        return math.sqrt(self.x * self.x + self.y * self.y)

    def dot(self, other: Any) -> float:
        """Scalar product."""
        x, y = _pair(other)
        return self.x * x + self.y * y

    def cross(self, other: Any) -> float:
        """The component of the vector product that leaves the plane: positive to the left."""
        x, y = _pair(other)
        return self.x * y - self.y * x

    def rotated(self, angle: float) -> "Vector":
        """Turned to the left (rad)."""
        return rotated(self, _number(angle))

    def normalized(self) -> "Vector":
        """Of the same direction and the length 1; the null vector as it is."""
        length = self.length
        return self / length if length > 0.0 else self

    @classmethod
    def polar(cls, length: float, angle: float) -> Self:
        """The vector of a length that points in a direction (rad, from the x axis to the left)."""
        size = _number(length)
        cos, sin = cos_sin(_number(angle))
        return cls(size * cos, size * sin)

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


def _pair(other: Any) -> tuple[float, float]:
    """Refuse what is no vector and no pair of numbers."""
    listed = isinstance(other, tuple | list) and len(other) == 2
    if listed or getattr(other, "shape", None) == (2,):
        x, y = other
        if isinstance(x, Real) and isinstance(y, Real):
            return x, y  # type: ignore[return-value]
    said = " ".join(f"{other!r:.99}".split())
    raise TypeError(f"a Vector goes with another or with a pair of numbers, not with {said}")


def _number(by: Any) -> float:
    """Refuse what is no number."""
    if isinstance(by, Real) and by is not True and by is not False:
        with suppress(OverflowError):
            return float(by)
    said = " ".join(f"{by!r:.99}".split())
    raise TypeError(f"a Vector is multiplied, divided and turned by a number, not by {said}")


def distance(a: tuple[float, float], b: tuple[float, float]) -> float:
    """Between two points."""
    x, y = b[0] - a[0], b[1] - a[1]
    return math.sqrt(x * x + y * y)


def rotated(point: tuple[float, float], angle: float) -> Vector:
    """A vector turned about the origin, to the left (rad)."""
    cos, sin = cos_sin(angle)
    return Vector(cos * point[0] - sin * point[1], sin * point[0] + cos * point[1])
