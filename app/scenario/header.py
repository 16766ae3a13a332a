"""The header of a scenario file: version, screen, picture, outputs, settings."""

import re
from typing import NamedTuple

from app.scenario.catalogue import SCREENS, Names, unknown_name
from app.scenario.kinds import Choice, Field, Number, Schema, Text, wrong
from app.scenario.mistakes import Mistake, Refused, refuse
from app.scenario.nodes import MapNode, Node, ScalarNode
from app.scenario.paths import Folders, OutputKind, OutputsKind
from screens.kit.words import languages

VERSION = 1
RATES = ("60", "30", "20", "15", "12", "10")
"""Pictures per second of a film: those at which every frame falls on a tick."""

SIZE = (720, 1280)
"""Of the pictures if the file does not say: 360 x 640 dp at scale 2 (pixels)."""

SMALLEST, LARGEST = 64, 8192
"""Pixels of a picture's side."""

MOST_PIXELS = 7680 * 4320
"""Of a picture: 8K."""


class SizeKind:
    """Width x height in pixels."""

    name = f"a size such as 720x1280, each side from {SMALLEST} to {LARGEST} pixels"

    def read(self, node: Node, key: str) -> tuple[int, int]:
        match = _SIZE.fullmatch(node.text) if isinstance(node, ScalarNode) else None
        if match is None:
            raise wrong(node, key, self, "bad-size")
        width, height = int(match[1]), int(match[2])
        if not (SMALLEST <= width <= LARGEST and SMALLEST <= height <= LARGEST):
            raise wrong(node, key, self, "bad-size")
        if width * height > MOST_PIXELS:
            raise refuse(
                node.place,
                "bad-size",
                f"a picture of {width} x {height} has {width * height} pixels; "
                f"it may have {MOST_PIXELS} (7680 x 4320)",
            )
        return width, height

    def schema(self) -> Schema:
        return {"type": "string", "pattern": "^[0-9]{2,4}[xX×][0-9]{2,4}$"}


_SIZE = re.compile(r"([0-9]{1,9})[xX×]([0-9]{1,9})")


class VersionKind:
    """The version of the format."""

    name = f"{VERSION}, the version of the format"

    def read(self, node: Node, key: str) -> int:
        if not isinstance(node, ScalarNode) or not node.is_whole:
            raise wrong(node, key, self)
        if node.text != str(VERSION):
            raise wrong(node, key, self, "bad-version")
        return VERSION

    def schema(self) -> Schema:
        return {"const": VERSION}


class SettingsKind(NamedTuple):
    """Values for the lesson to start with."""

    names: Names

    @property
    def name(self) -> str:
        return "a mapping of settings to numbers, such as {body.mass: 2}"

    def read(self, node: Node, key: str) -> dict[str, float]:
        if isinstance(node, ScalarNode) and node.is_nothing:
            return {}
        if not isinstance(node, MapNode):
            raise wrong(node, key, self)
        values: dict[str, float] = {}
        mistakes: list[Mistake] = []
        for name, value in node.entries:
            try:
                values[name.text] = self.setting(name).read(value, name.text)
            except Refused as refused:
                mistakes.extend(refused.mistakes)
        if mistakes:
            raise Refused(*mistakes)
        return values

    def setting(self, name: ScalarNode) -> Number:
        """The range of the setting that a node names."""
        setting = self.names.settings.get(name.text)
        if setting is None:
            raise unknown_name(name, self.names, "setting")
        return Number(setting.low, setting.high, setting.whole, setting.unit)

    def schema(self) -> Schema:
        return {
            "type": ["object", "null"],
            "properties": {
                name: Number(setting.low, setting.high, setting.whole).schema()
                | {"description": setting.about}
                for name, setting in self.names.settings.items()
            },
            "additionalProperties": False,
        }


def header_fields(names: Names, folders: Folders) -> dict[str, Field]:
    """Every key beside `steps`."""
    return {
        "laws": Field(VersionKind(), "Version of the format: 1.", required=True),
        "screen": Field(
            Choice(SCREENS, "unknown-screen", "screen"),
            "The lesson to begin with.",
            required=True,
        ),
        "title": Field(Text(200), "Title of the film.", default=""),
        "alt": Field(
            Text(2000), "What is seen, in words, for people who cannot see it.", default=""
        ),
        "seed": Field(
            Number(0, 2**32 - 1, whole=True),
            "Decides everything that the lesson draws at random. Same seed, same film.",
            default=0,
        ),
        "lang": Field(Choice(languages(), "unknown-lang", "language"), LANG, default="en"),
        "size": Field(SizeKind(), "Width x height of the pictures in pixels.", default=SIZE),
        "fps": Field(
            Choice(RATES, "bad-fps", "rate", numbers=True), "Frames per second.", default="60"
        ),
        "output": Field(
            OutputsKind(OutputKind(folders)),
            "Files to write, from the working folder. One that ends in / is a folder of frames.",
            default=(),
        ),
        "set": Field(SettingsKind(names), "What the lesson starts with.", default={}),
    }


LANG = "Language of the lesson's words."
