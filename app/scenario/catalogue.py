"""What a scenario may call by name: the screens with their widgets, probes and settings."""

import re
from collections.abc import Mapping
from functools import cache
from math import inf
from typing import NamedTuple

from app.gestures import FIELD
from app.scenario.kinds import Number
from app.scenario.mistakes import Refused, quote, refuse, suggest
from app.scenario.nodes import ScalarNode
from screens.kit import layout
from screens.lesson import Setting
from screens.lessons import lesson_class

SCREENS: tuple[str, ...] = layout.SCREENS
"""The lessons' ids, in their order."""

NAVIGATION = "nav."
"""How the ids of the widgets begin that lead to another screen."""


class Names(NamedTuple):
    """The names of one screen, or of several."""

    widgets: tuple[str, ...]
    probes: tuple[str, ...]
    """With a literal N where a number from 1 stands."""
    settings: Mapping[str, Setting]
    fields: Mapping[str, Number]
    """What `fill` can type into; a field has the range of the settings that it stands for."""

    def has_probe(self, name: str) -> bool:
        """Whether there can be such a probe; whether it exists yet shows when it is read."""
        return any(
            re.fullmatch(numbered(known), name) if ".N." in known else name == known
            for known in self.probes
        )

    def of(self, what: str) -> tuple[str, ...]:
        """The names of one kind; `what` is "widget", "probe" or "setting"."""
        kinds = {"widget": self.widgets, "probe": self.probes, "setting": tuple(self.settings)}
        return kinds[what]


def numbered(pattern: str) -> str:
    """The regular expression for a probe's name with an N in it."""
    return re.escape(pattern).replace(r"\.N\.", r"\.[1-9][0-9]{0,4}\.")


@cache
def of_screen(screen: str) -> Names:
    """The names of one screen."""
    lesson = lesson_class(screen)
    fields = [name.removesuffix(FIELD) for name in lesson.WIDGETS if name.endswith(FIELD)]
    return Names(
        widgets=tuple(lesson.WIDGETS),
        probes=tuple(lesson.PROBES),
        settings=dict(lesson.SETTINGS),
        fields={field: _range(field, lesson.SETTINGS) for field in fields},
    )


def _range(field: str, settings: Mapping[str, Setting]) -> Number:
    meant = [setting for name, setting in settings.items() if name.endswith(f".{field}")]
    low = min((setting.low for setting in meant), default=-inf)
    high = max((setting.high for setting in meant), default=inf)
    return Number(low, high, unit=meant[0].unit if meant else "")


@cache
def of_all() -> Names:
    """The names of all screens together."""
    each = [of_screen(screen) for screen in SCREENS]
    return Names(
        widgets=tuple(dict.fromkeys(name for names in each for name in names.widgets)),
        probes=tuple(dict.fromkeys(name for names in each for name in names.probes)),
        settings={name: setting for names in each for name, setting in names.settings.items()},
        fields={name: field for names in each for name, field in names.fields.items()},
    )


def unknown_name(node: ScalarNode, names: Names, what: str) -> Refused:
    """The refusal of a name that is none of these; `what` is "widget", "probe" or "setting"."""
    word = node.text
    code, sentence = f"unknown-{what}", f"unknown {what} {quote(word)}"
    for screen in SCREENS:
        elsewhere = of_screen(screen)
        if elsewhere.has_probe(word) if what == "probe" else word in elsewhere.of(what):
            return refuse(node.place, code, sentence, f"it belongs to the screen '{screen}'")
    number = re.match(r"\w+\.([1-9][0-9]{0,4})\.", word)
    known = [name.replace(".N.", f".{number[1] if number else 1}.") for name in names.of(what)]
    return refuse(node.place, code, sentence, suggest(word, known))
