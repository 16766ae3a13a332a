"""What is refused at the door, each in one sentence that names the value."""

import math
from collections.abc import Iterable
from itertools import islice
from numbers import Real
from operator import index
from typing import Any, TypeVar

import numpy as np

from engine.vector import Vector

F = TypeVar("F")

MOST_SHOWN = 200
"""Characters of a value that a sentence shows."""

MOST_SECONDS = 1e100
"""Ticks are at most as long, and at least as long as the inverse: what is divided by them, or by
their squares, stays within the range of numbers."""


def shown(value: Any) -> str:
    """How a value reads in a sentence: on one line, its beginning if it is long."""
    try:
        words = " ".join(repr(value).split())
    except ValueError:  # an integer of more digits than Python writes
        words = f"a huge {type(value).__name__}"
    return words if len(words) <= MOST_SHOWN else f"{words[:MOST_SHOWN]} ..."


def finite(value: Any, name: str) -> float:
    """Return `value` as a float; refuse what is no number, NaN and infinities.

    Raises:
        TypeError: if it is no real number.
        ValueError: if it is NaN or infinite.
    """
    if type(value) is float and -math.inf < value < math.inf:  # what most are, at once
        return value
    if type(value) is not int and (isinstance(value, bool) or not isinstance(value, Real)):
        raise TypeError(f"{name} must be a number, not {shown(value)}")
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
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
    """Return `value` as a float, never -0.0; refuse negative numbers as well."""
    if type(value) is float and 0.0 <= value < math.inf:
        return value + 0.0
    number = finite(value, name)
    if number < 0.0:
        raise ValueError(f"{name} must not be negative, not {number}")
    return number + 0.0


def positive_or_endless(value: Any, name: str) -> float:
    """Return `value` as a float; refuse what is neither greater than zero nor infinite."""
    return value if is_endless(value) else positive(value, name)


def is_endless(value: Any) -> bool:
    """Whether a value is the number infinity."""
    return isinstance(value, float) and value == math.inf


def tick(value: Any, name: str = "dt") -> float:
    """Return the length of a tick (s) as a float; refuse what cannot be computed with."""
    number = positive(value, name)
    if not 1.0 / MOST_SECONDS <= number <= MOST_SECONDS:
        raise ValueError(
            f"{name} must be between {1.0 / MOST_SECONDS} and {MOST_SECONDS} s, not {number}"
        )
    return number


def fraction(value: Any, name: str) -> float:
    """Return `value` as a float; refuse what is not between 0 and 1."""
    if type(value) is float and 0.0 <= value <= 1.0:
        return value
    number = finite(value, name)
    if not 0.0 <= number <= 1.0:
        raise ValueError(f"{name} must be between 0 and 1, not {number}")
    return number


def whole(value: Any, name: str, at_least: int, at_most: int | None = None) -> int:
    """Return `value` as an int; refuse what is no whole number, too small or too large."""
    if type(value) is int and at_least <= value and (at_most is None or value <= at_most):
        return value
    try:
        number = index(value)
    except TypeError:
        number = None
    if number is None or isinstance(value, bool):
        raise TypeError(f"{name} must be a whole number, not {shown(value)}")
    if number < at_least:
        raise ValueError(f"{name} must be at least {at_least}, not {shown(number)}")
    if at_most is not None and number > at_most:
        raise ValueError(f"{name} must be at most {at_most}, not {shown(number)}")
    return number


def identity(value: Any, what: str) -> Any:
    """Return `value`, a number that may be an id; refuse all else."""
    if isinstance(value, bool) or not isinstance(value, Real):
        raise TypeError(f"{what} is named by a number, its id, not by {shown(value)}")
    return value


def vector(value: Any, name: str) -> Vector:
    """Return `value`, a pair of finite numbers, as a `Vector`."""
    pair = value
    if type(value) is not Vector and type(value) is not tuple:
        if isinstance(value, str | bytes | dict | set | frozenset) or not isinstance(
            value, Iterable
        ):
            raise TypeError(f"{name} must be a pair of numbers, not {shown(value)}")
        pair = list(islice(value, MOST_SHOWN))
    if len(pair) != 2:
        raise ValueError(f"{name} must be a pair of numbers, not {len(pair)} of them")
    x, y = pair
    if type(x) is type(y) is float and -math.inf < x < math.inf and -math.inf < y < math.inf:
        return Vector(x, y)
    return Vector(finite(x, f"{name}[0]"), finite(y, f"{name}[1]"))


def keys(data: Any, wanted: Iterable[str], what: str) -> None:
    """Refuse what is no dictionary with exactly these keys."""
    if not isinstance(data, dict):
        raise TypeError(f"{what} must be a dictionary, not {shown(data)}")
    for key in wanted:
        if key not in data:
            raise ValueError(f"{what} must have {key!r}")
    for key in data:
        if key not in wanted:
            raise ValueError(f"{what} has no {shown(key)}")


def listed(data: Any, what: str, length: int | None = None) -> list[Any]:
    """Return `data`, a list, of this length if one is given."""
    if not isinstance(data, list):
        raise TypeError(f"{what} must be a list, not {shown(data)}")
    if length is not None and len(data) != length:
        raise ValueError(f"{what} must have {length} rows, not {len(data)}")
    return data


def version(value: Any, known: int, what: str) -> None:
    """Refuse saved data of another version."""
    if isinstance(value, bool) or value != known:
        raise ValueError(f"{what} must have the format {known}, not {shown(value)}")


def sequence(value: Any, name: str, at_most: int) -> list[Any]:
    """Return what can be gone through as a list; refuse strings and more than so many."""
    if isinstance(value, str) or not isinstance(value, Iterable):
        raise TypeError(f"{name} must be a sequence, not {shown(value)}")
    listed = list(islice(value, at_most + 1))
    if len(listed) > at_most:
        raise ValueError(f"{name} must be at most {at_most}, but there are more")
    return listed


def vectors(value: Any, name: str, at_most: int) -> list[Vector]:
    """Return a sequence of pairs of finite numbers as a list of `Vector`."""
    if isinstance(value, str) or not isinstance(value, Iterable):
        raise TypeError(f"{name} must be pairs of numbers, not {shown(value)}")
    return [vector(v, f"{name}[{i}]") for i, v in enumerate(sequence(value, name, at_most))]


def text(value: Any, name: str) -> str:
    """Return `value`, words; refuse all else."""
    if not isinstance(value, str):
        raise TypeError(f"{name} must be text, not {shown(value)}")
    return value


def function_or_none(value: F, name: str) -> F:
    """Return `value`, something that can be called, or None; refuse all else."""
    if value is not None and not callable(value):
        raise TypeError(f"{name} must be a function or None, not {shown(value)}")
    return value


def truth(value: Any, name: str) -> bool:
    """Return `value`, True or False; refuse all else."""
    if not isinstance(value, bool | np.bool_):
        raise TypeError(f"{name} must be True or False, not {shown(value)}")
    return bool(value)
