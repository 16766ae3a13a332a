"""Kinds of values: each reads a node and describes itself to people and to editors.

A kind is told the name of what it reads, so that its sentences can say "'seed' must be ...".
"""

import math
import re
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any, Generic, NamedTuple, Protocol, TypeVar

from app.scenario.mistakes import Mistake, Refused, nearest, quote, refuse, suggest
from app.scenario.nodes import ListNode, MapNode, Node, ScalarNode, found
from screens.kit.characters import drawable
from screens.kit.geometry import Point

Schema = dict[str, Any]
"""A part of a JSON Schema, draft 7."""

T = TypeVar("T")
T_co = TypeVar("T_co", covariant=True)


class Kind(Protocol[T_co]):
    """What a value may be."""

    @property
    def name(self) -> str:
        """What it must be, as the end of a sentence: "a number from 0 to 1"."""

    def read(self, node: Node, key: str) -> T_co:
        """The value of a node; raises Refused with every mistake in it."""

    def schema(self) -> Schema:
        """The same as a JSON Schema, as far as one can say it."""


def wrong(
    node: Node, key: str, kind: Kind[object], code: str = "wrong-type", help: str = ""
) -> Refused:
    """'key' must be this kind, not what stands there."""
    if isinstance(node, ScalarNode) and node.is_nothing:
        code, help = "missing-value", ""
    elif isinstance(node, ScalarNode) and node.is_text and not node.plain:
        bare = ScalarNode(node.place, node.text, plain=True)
        help = "remove the quotes" if bare.is_number else help
    return refuse(node.place, code, f"{quote(key)} must be {kind.name}, not {found(node)}", help)


def plain(value: float) -> str:
    """A number as people write it: 1, not 1.0."""
    return str(int(value)) if float(value).is_integer() and abs(value) < 1e15 else repr(value)


class Text(NamedTuple):
    """Words."""

    most: int = 200
    """Characters at most."""
    may_be_empty: bool = False
    """Then nothing at all counts as an empty text."""
    is_drawn: bool = False
    """Then it holds only what the fonts have."""

    @property
    def name(self) -> str:
        return "text"

    def read(self, node: Node, key: str) -> str:
        if not isinstance(node, ScalarNode):
            raise wrong(node, key, self)
        if node.is_nothing and self.may_be_empty:
            return ""
        if not node.is_text:
            help = f'put quotes around it: "{node.text}"' if not node.is_nothing else ""
            refused = wrong(node, key, self).mistakes[0]
            raise refuse(node.place, refused.code, refused.sentence, help)
        if len(node.text) > self.most:
            raise refuse(
                node.place,
                "text-too-long",
                f"{quote(key)} has {len(node.text)} characters; it may have {self.most}",
            )
        if not node.text.strip() and not self.may_be_empty:
            raise refuse(node.place, "missing-value", f"{quote(key)} must not be empty")
        odd = [c for c in node.text if not (c.isprintable() or c in "\n\u00ad")]
        if odd:
            raise refuse(
                node.place,
                "control-character",
                f"{quote(key)} holds the character U+{ord(odd[0]):04X}, which cannot be shown",
            )
        lacking = [c for c in node.text if c.isprintable() and c not in drawable()]
        if self.is_drawn and lacking:
            raise refuse(
                node.place,
                "no-glyph",
                f"{quote(key)} holds '{lacking[0]}' (U+{ord(lacking[0]):04X}), "
                "which the fonts do not have",
                "they have Latin, Greek and Cyrillic letters, arrows and signs of mathematics",
            )
        return node.text

    def schema(self) -> Schema:
        if self.may_be_empty:
            return {"type": ["string", "null"], "maxLength": self.most}
        return {"type": "string", "minLength": 1, "maxLength": self.most}


class Number(NamedTuple):
    """A finite number within a range."""

    low: float
    high: float
    whole: bool = False
    unit: str = ""

    @property
    def name(self) -> str:
        what = "a whole number" if self.whole else "a number"
        unit = f" {self.unit}" if self.unit else ""
        if self.high == math.inf:
            return what if self.low == -math.inf else f"{what} of at least {plain(self.low)}{unit}"
        return f"{what} from {plain(self.low)} to {plain(self.high)}{unit}"

    def read(self, node: Node, key: str) -> float:
        if isinstance(node, ScalarNode) and _ENDLESS.fullmatch(node.text):
            raise wrong(node, key, self, "not-finite")
        if not isinstance(node, ScalarNode) or not node.is_number:
            raise wrong(node, key, self, help=self._alone(node))
        value = node.number
        if not math.isfinite(value):
            raise wrong(node, key, self, "not-finite")
        if self.whole and not value.is_integer():
            raise wrong(node, key, self)
        if not self.low <= value <= self.high:
            raise wrong(node, key, self, "out-of-range")
        return int(value) if self.whole else value + 0.0

    def _alone(self, node: Node) -> str:
        """The help for a number with a unit, such as 2kg."""
        if not isinstance(node, ScalarNode) or not _MEASURE.fullmatch(node.text):
            return ""
        return "write the number alone" + f", in {self.unit}" * bool(self.unit)

    def schema(self) -> Schema:
        schema: Schema = {"type": "integer" if self.whole else "number"}
        if self.low != -math.inf:
            schema["minimum"] = self.low
        if self.high != math.inf:
            schema["maximum"] = self.high
        return schema


class Time(NamedTuple):
    """A length of time, as `1s`, `250ms`, `2min` or a number of seconds; read as seconds."""

    longest: float = 3600.0

    @property
    def name(self) -> str:
        return f"a time from 0s to {plain(self.longest)}s such as 1s, 250ms or 1.5"

    def read(self, node: Node, key: str) -> float:
        if not isinstance(node, ScalarNode):
            raise wrong(node, key, self, "bad-time")
        if node.is_number:
            seconds = node.number
        elif match := _TIME.fullmatch(node.text.strip()):
            seconds = float(Fraction(match["number"]) * _SECONDS[match["unit"]])
        else:
            raise wrong(node, key, self, "bad-time", "the units of time are ms, s and min")
        if not math.isfinite(seconds):
            raise wrong(node, key, self, "not-finite")
        if not 0 <= seconds <= self.longest:
            raise wrong(node, key, self, "out-of-range")
        return seconds + 0.0

    def schema(self) -> Schema:
        return {
            "anyOf": [
                {"type": "number", "minimum": 0, "maximum": self.longest},
                {"type": "string", "pattern": r"^\s*\+?([0-9]+\.?[0-9]*|\.[0-9]+) ?(ms|s|min)\s*$"},
            ]
        }


_ENDLESS = re.compile(r"[-+]?\.?(inf|infinity|nan)", re.IGNORECASE)
_TIME = re.compile(
    r"(?P<number>[-+]?([0-9]{1,12}\.?[0-9]{0,12}|\.[0-9]{1,12})) ?(?P<unit>ms|s|min)"
)
_MEASURE = re.compile(r"[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)? ?[^\s\d.,_][^\d]*")
_SECONDS = {"ms": Fraction(1, 1000), "s": Fraction(1), "min": Fraction(60)}


class Choice(NamedTuple):
    """One of a few words or numbers."""

    options: tuple[str, ...]
    code: str
    what: str
    """What each of them is: "screen"."""
    numbers: bool = False
    """Whether the options are numbers rather than words."""

    @property
    def name(self) -> str:
        return "one of " + ", ".join(self.options)

    def read(self, node: Node, key: str) -> str:
        if not isinstance(node, ScalarNode) or not (
            node.is_number if self.numbers else node.is_text
        ):
            raise wrong(node, key, self)
        if node.text in self.options:
            return node.text
        if self.numbers:
            raise wrong(node, key, self, self.code)
        raise unknown(node, self.what, self.options, self.code)

    def schema(self) -> Schema:
        if self.numbers:
            return {"type": "integer", "enum": [int(option) for option in self.options]}
        return {"type": "string", "enum": list(self.options)}


def unknown(node: ScalarNode, what: str, known: Sequence[str], code: str) -> Refused:
    """A word that is not among the known ones, with the nearest of them."""
    return refuse(node.place, code, f"unknown {what} {quote(node.text)}", suggest(node.text, known))


class Pair(NamedTuple):
    """Two numbers, such as a place or two angles."""

    each: Number
    what: str
    """Such as "a place [x, y] in dp"."""

    @property
    def name(self) -> str:
        return self.what

    def read(self, node: Node, key: str) -> Point:
        if not isinstance(node, ListNode) or len(node.items) != 2:
            raise wrong(node, key, self)
        first, second = read_all(self.each, node.items, key)
        return Point(first, second)

    def schema(self) -> Schema:
        return {"type": "array", "items": self.each.schema(), "minItems": 2, "maxItems": 2}


class ListOf(NamedTuple, Generic[T]):
    """Several of one kind."""

    each: Kind[T]
    what: str
    """Such as "a list of steps"."""

    @property
    def name(self) -> str:
        return self.what

    def read(self, node: Node, key: str) -> tuple[T, ...]:
        if not isinstance(node, ListNode):
            raise wrong(node, key, self)
        if not node.items:
            raise refuse(node.place, "missing-value", f"{quote(key)} must have an entry")
        return tuple(read_all(self.each, node.items, key))

    def schema(self) -> Schema:
        return {"type": "array", "items": self.each.schema(), "minItems": 1}


def read_all(kind: Kind[T], nodes: Sequence[Node], key: str) -> list[T]:
    """The values of all nodes; raises Refused with the mistakes of all of them."""
    values: list[T] = []
    mistakes: list[Mistake] = []
    for node in nodes:
        try:
            values.append(kind.read(node, key))
        except Refused as refused:
            mistakes.extend(refused.mistakes)
    if mistakes:
        raise Refused(*mistakes)
    return values


class Field(NamedTuple):
    """One key of a record."""

    kind: Kind[object]
    about: str
    """What it is for: shown by editors."""
    required: bool = False
    default: object = None

    def schema(self) -> Schema:
        """Its value's schema with the words for the hover."""
        schema = self.kind.schema() | {"description": self.about}
        if self.default is not None and isinstance(self.default, (int, float, str)):
            schema["default"] = self.default
        return schema


class Record(NamedTuple, Generic[T]):
    """A mapping with known keys."""

    what: str
    """Such as "a mapping with from and to"."""
    fields: Mapping[str, Field]
    build: Callable[[MapNode, dict[str, Any]], T]
    """Makes the value of the fields' values; may raise Refused."""

    @property
    def name(self) -> str:
        return self.what

    def read(self, node: Node, key: str) -> T:
        if not isinstance(node, MapNode):
            raise wrong(node, key, self)
        values: dict[str, Any] = {name: field.default for name, field in self.fields.items()}
        mistakes: list[Mistake] = []
        given = set()
        for name, value in node.entries:
            given.add(name.text)
            field = self.fields.get(name.text)
            try:
                if field is None:
                    raise unknown(name, "key", tuple(self.fields), "unknown-key")
                values[name.text] = field.kind.read(value, name.text)
            except Refused as refused:
                mistakes.extend(refused.mistakes)
        for word, field in self.fields.items():
            if field.required and word not in given and not _meant(word, given, self.fields):
                mistakes.append(
                    Mistake(
                        node.place,
                        "missing-key",
                        f"{quote(key)} needs the key '{word}'" if key else f"'{word}' is missing",
                        f"'{word}' must be {field.kind.name}",
                    )
                )
        if mistakes:
            raise Refused(*mistakes)
        return self.build(node, values)

    def schema(self) -> Schema:
        return {
            "type": "object",
            "properties": {name: field.schema() for name, field in self.fields.items()},
            "required": [name for name, field in self.fields.items() if field.required],
            "additionalProperties": False,
        }


def _meant(name: str, given: set[str], fields: Mapping[str, Field]) -> bool:
    """Whether a misspelt key was meant to be this one, so that it is not called missing too."""
    return any(word not in fields and nearest(word, tuple(fields)) == name for word in given)
