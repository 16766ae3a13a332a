"""The tree of a YAML file, with the place of everything in it."""

import re
from typing import NamedTuple

from app.scenario.mistakes import Place, quote

_INT = re.compile(r"[-+]?[0-9]+")
_FLOAT = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?")
_ENDLESS = re.compile(r"[-+]?\.?(inf|infinity|nan)", re.IGNORECASE)
_NOTHING = ("", "~", "null", "Null", "NULL")
_TRUTH = ("true", "True", "TRUE", "false", "False", "FALSE")


class ScalarNode(NamedTuple):
    """A single value."""

    place: Place
    text: str
    plain: bool
    """Whether it stands without quotes, so that it may be a number (YAML 1.2, core schema)."""

    @property
    def is_nothing(self) -> bool:
        """Whether it is empty or null."""
        return self.plain and self.text in _NOTHING

    @property
    def is_truth(self) -> bool:
        """Whether it is true or false."""
        return self.plain and self.text in _TRUTH

    @property
    def is_whole(self) -> bool:
        """Whether it is a whole number."""
        return self.plain and bool(_INT.fullmatch(self.text))

    @property
    def is_number(self) -> bool:
        """Whether it is a number, even one too large to be finite."""
        return self.plain and bool(_FLOAT.fullmatch(self.text) or _ENDLESS.fullmatch(self.text))

    @property
    def is_text(self) -> bool:
        """Whether it is text, with or without quotes."""
        return not (self.is_nothing or self.is_truth or self.is_number)

    @property
    def number(self) -> float:
        """Its value; infinite or not a number if it says so. Only if `is_number`."""
        if _FLOAT.fullmatch(self.text):
            return float(self.text)
        return float(self.text.replace(".", ""))


class ListNode(NamedTuple):
    """Several values."""

    place: Place
    items: tuple["Node", ...]


class MapNode(NamedTuple):
    """Values by key; no key occurs twice."""

    place: Place
    entries: tuple[tuple[ScalarNode, "Node"], ...]

    def get(self, key: str) -> "Node | None":
        """The value of a key, or None."""
        for name, value in self.entries:
            if name.text == key:
                return value
        return None


Node = ScalarNode | ListNode | MapNode


def found(node: Node) -> str:
    """How a sentence names what stands there."""
    match node:
        case ListNode():
            return f"a list of {len(node.items)}" if node.items else "an empty list"
        case MapNode():
            return "a mapping" if node.entries else "an empty mapping"
        case ScalarNode() if node.is_nothing:
            return "nothing"
        case ScalarNode() if node.is_number and len(node.text) < 30:
            return node.text
        case ScalarNode() if node.is_truth:
            return node.text
        case ScalarNode():
            return quote(node.text)
