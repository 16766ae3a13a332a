"""What is refused at the door, each in one sentence that names the value."""

import math
from collections.abc import Iterable
from numbers import Real
from typing import Any

from engine.vector import Vector


def finite(value: Any, name: str) -> float:
    """Return `value` as a float; refuse what is no number, NaN and infinities.

    Raises:
        TypeError: if it is no real number.
        ValueError: if it is NaN or infinite.
    """
    if isinstance(value, bool) or not isinstance(value, Real):
        raise TypeError(f"{name} must be a number, not {value!r}")
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(f"{name} must be finite, not {number}")
    return number


def positive(value: Any, name: str) -> float:
    """Return `value` as a float; refuse zero and negative numbers as well."""
    number = finite(value, name)
    if number <= 0.0:
        raise ValueError(f"{name} must be greater than zero, not {number}")
    return number


def not_negative(value: Any, name: str) -> float:
    """Return `value` as a float; refuse negative numbers as well."""
    number = finite(value, name)
    if number < 0.0:
        raise ValueError(f"{name} must not be negative, not {number}")
    return number


def fraction(value: Any, name: str) -> float:
    """Return `value` as a float; refuse what is not between 0 and 1."""
    number = finite(value, name)
    if not 0.0 <= number <= 1.0:
        raise ValueError(f"{name} must be between 0 and 1, not {number}")
    return number


def whole(value: Any, name: str, at_least: int) -> int:
    """Return `value` as an int; refuse what is no whole number or too small."""
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise TypeError(f"{name} must be a whole number, not {value!r}")
    number = int(value.__index__())
    if number < at_least:
        raise ValueError(f"{name} must be at least {at_least}, not {number}")
    return number


def vector(value: Any, name: str) -> Vector:
    """Return `value`, a pair of finite numbers, as a `Vector`."""
    if isinstance(value, str) or not isinstance(value, Iterable):
        raise TypeError(f"{name} must be a pair of numbers, not {value!r}")
    pair = list(value)
    if len(pair) != 2:
        raise ValueError(f"{name} must be a pair of numbers, not {len(pair)} of them")
    return Vector(finite(pair[0], f"{name}[0]"), finite(pair[1], f"{name}[1]"))
