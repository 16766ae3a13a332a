"""Values as plain data, for JSON and back, without losing a bit.

Numbers, strings, booleans and None stand for themselves, sequences become lists. Everything else
becomes an object with a single key that says what it is: `{"Vector": [1.0, 2.0]}`,
`{"Circle": {"radius": 0.5}}`, `{"float": "inf"}`, `{"Body": 3}`, `{"function": "lesson.pull"}`.
"""

import inspect
import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields, is_dataclass
from numbers import Integral, Real
from typing import Any

from engine.validate import shown
from engine.vector import Vector

Functions = Mapping[str, Callable[..., Any]]
"""Python functions by the names under which they were saved (`module.name`)."""

INFINITIES = {"inf": math.inf, "-inf": -math.inf}


def encode(value: Any) -> Any:
    """Turn a value into plain data.

    Handles (what has a world and an id, such as a `Body`) are named by their ids, functions by
    their names.

    Raises:
        TypeError: for a value of a kind that cannot be saved.
        ValueError: for NaN.
    """
    if value is None or isinstance(value, bool | str):
        return value
    if isinstance(value, Integral):
        return int(value)
    if isinstance(value, Real):
        return encode_float(float(value))
    if isinstance(value, Vector):
        return {"Vector": [encode(each) for each in value]}
    if is_dataclass(value) and not isinstance(value, type):
        inside = {each.name: encode(getattr(value, each.name)) for each in fields(value)}
        return {type(value).__name__: inside}
    if hasattr(value, "_world") and hasattr(value, "id"):
        return {type(value).__name__: value.id}
    if callable(value):
        return {"function": name_of(value)}
    if isinstance(value, Iterable):
        return [encode(each) for each in value]
    raise TypeError(f"{shown(value)} cannot be saved")


def encode_float(value: float) -> Any:
    """Turn a number into one that JSON has: infinities are spelt out."""
    if math.isfinite(value):
        return value
    if math.isnan(value):
        raise ValueError("a number that is none (NaN) cannot be saved")
    return {"float": "inf" if value > 0.0 else "-inf"}


def name_of(function: Any) -> str:
    """The name under which a function is saved: its module and its own."""
    kind = function if hasattr(function, "__qualname__") else type(function)
    return f"{kind.__module__}.{kind.__qualname__}"


class Decoder:
    """Turns plain data back into values.

    Args:
        kinds: the dataclasses that may occur.
        functions: the functions that may occur.
        handle: finds a handle from the name of its class and its id.
    """

    def __init__(
        self,
        kinds: Iterable[type],
        functions: Functions | None = None,
        handle: Callable[[str, int], Any] | None = None,
    ) -> None:
        self._kinds = {kind.__name__: kind for kind in kinds}
        self._functions = dict(functions or {})
        self._handle = handle

    def __call__(self, data: Any) -> Any:
        """Turn plain data into the value that it was.

        Raises:
            ValueError: for data that `encode` would not have made.
            LookupError: for a function that was not handed in, or a handle that is not there.
        """
        if data is None or isinstance(data, bool | int | str):
            return data
        if isinstance(data, float):
            if not math.isfinite(data):
                raise ValueError(f"a saved number must be finite, not {data}")
            return data
        if isinstance(data, list | tuple):
            return tuple(self(each) for each in data)
        if not isinstance(data, dict) or len(data) != 1:
            raise ValueError(f"{shown(data)} is no saved value")
        ((kind, inside),) = data.items()
        return self._special(kind, inside)

    def _special(self, kind: str, inside: Any) -> Any:
        if kind == "float" and isinstance(inside, str) and inside in INFINITIES:
            return INFINITIES[inside]
        if kind == "Vector":
            values = self(inside)
            if not isinstance(values, tuple) or len(values) != 2 or not _numbers(values):
                raise ValueError(f"a saved Vector must be a pair of numbers, not {shown(inside)}")
            return Vector(float(values[0]), float(values[1]))
        if kind == "function":
            if not isinstance(inside, str) or inside not in self._functions:
                said = shown(inside)
                raise LookupError(f"the function {said} was not saved: hand it in by its name")
            return self._functions[inside]
        if kind in self._kinds and isinstance(inside, dict):
            return self._record(self._kinds[kind], inside)
        if self._handle is not None and isinstance(inside, int):
            return self._handle(kind, inside)
        raise ValueError(f"a saved value cannot be a {shown(kind)} of {shown(inside)}")

    def _record(self, kind: Any, inside: dict[str, Any]) -> Any:
        """Make a dataclass: by its constructor, which refuses wrong values, then to the last bit.

        A constructor that computes from what it is given may round anew, so that fields are set
        as they were saved.
        """
        names = [each.name for each in fields(kind)]
        if sorted(inside) != sorted(names):
            told, wanted = ", ".join(map(str, inside)), ", ".join(names)
            raise ValueError(f"a saved {kind.__name__} must have {wanted}, not {told}")
        values = {name: self(inside[name]) for name in names}
        asked = list(inspect.signature(kind).parameters)
        known = all(name in values for name in asked)
        made = kind(**{name: values[name] for name in asked}) if known else object.__new__(kind)
        for name, value in values.items():
            if known and type(value) is not type(getattr(made, name)):
                raise ValueError(f"{name} of a saved {kind.__name__} cannot be {shown(value)}")
            object.__setattr__(made, name, value)
        return made


def _numbers(values: tuple[Any, ...]) -> bool:
    return all(isinstance(each, Real) and not isinstance(each, bool) for each in values)
