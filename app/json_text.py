"""JSON as text that is the same on every machine: sorted keys, shortest numbers, no NaN, no -0."""

import json
import math
from collections.abc import Iterable, Iterator, Mapping
from typing import Any


def clean(value: Any) -> Any:
    """The value as JSON can say it: no number that is not finite (None instead), no -0."""
    match value:
        case float():
            return value + 0.0 if math.isfinite(value) else None
        case Mapping():
            return {str(key): clean(part) for key, part in value.items()}
        case list() | tuple():
            return [clean(part) for part in value]
        case _:
            return value


def dumps(value: Any) -> str:
    """One line of JSON."""
    return json.dumps(clean(value), sort_keys=True, ensure_ascii=False, allow_nan=False)


def document(parts: Mapping[str, Any]) -> Iterator[str]:
    """A whole document, piece by piece: one line for each entry of a list or an iterator."""
    yield "{\n"
    for number, key in enumerate(sorted(parts)):
        yield ",\n" * (number > 0) + f"  {dumps(key)}: "
        value = parts[key]
        if isinstance(value, (str, Mapping, tuple)) or not isinstance(value, Iterable):
            yield dumps(value)
        else:
            yield from _rows(value)
    yield "\n}\n"


def _rows(values: Iterable[Any]) -> Iterator[str]:
    separator = "[\n    "
    for value in values:
        yield separator + dumps(value)
        separator = ",\n    "
    yield "[]" if separator.startswith("[") else "\n  ]"
