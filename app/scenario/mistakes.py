"""A mistake in a file: where it is, what is wrong in one sentence, and what would help."""

import difflib
import unicodedata
from collections.abc import Iterable, Sequence
from typing import NamedTuple

SHOWN = 100
"""Characters of a source line that a mistake shows at most."""

QUOTED = 60
"""Characters of somebody's text that a sentence quotes at most."""

LISTED = 12
"""Known words that a help lists at most."""

TOLD = 100
"""Mistakes that a report prints at most."""

SYNONYMS = {
    "assert": "expect",
    "check": "expect",
    "click": "tap",
    "delay": "wait",
    "description": "alt",
    "framerate": "fps",
    "include": "run",
    "language": "lang",
    "lesson": "screen",
    "loop": "repeat",
    "name": "title",
    "out": "output",
    "pause": "wait",
    "press": "tap",
    "resolution": "size",
    "settings": "set",
    "sleep": "wait",
    "text": "caption",
    "touch": "tap",
    "type": "fill",
    "version": "laws",
}
"""Words that people try, from other programs, for those that there are."""


class Place(NamedTuple):
    """A stretch of one line of a file; lines and columns count from 1, in characters."""

    path: str
    """As the person wrote it; for a value from the command line, the option's name."""
    line: int = 0
    """0: not in a file."""
    column: int = 0
    length: int = 1
    """How many characters the caret underlines."""
    source: str = ""
    """The whole line."""


class Mistake(NamedTuple):
    """One thing to mend."""

    place: Place
    code: str
    """A short name of the kind of mistake; docs/scenario.md lists them all."""
    sentence: str
    help: str = ""
    """What to do about it, or an empty string."""

    def __str__(self) -> str:
        return render(self)


class ScenarioMistakes(Exception):
    """A scenario was refused; `mistakes` holds everything that is wrong, in order of place."""

    def __init__(self, mistakes: Iterable[Mistake], first: str = "") -> None:
        """Sort the mistakes by place; those of the file shown as `first` come first."""
        self.mistakes: tuple[Mistake, ...] = tuple(
            sorted(
                dict.fromkeys(mistakes),
                key=lambda m: (m.place.path != first, m.place.path, m.place.line, m.place.column),
            )
        )
        super().__init__(report(self.mistakes))


class Refused(Exception):
    """A part of a file was refused while it was read; whoever reads the whole collects these."""

    def __init__(self, *mistakes: Mistake) -> None:
        """`mistakes` holds at least one."""
        super().__init__(*mistakes)
        self.mistakes = mistakes


def refuse(place: Place, code: str, sentence: str, help: str = "") -> Refused:
    """One mistake, ready to be raised."""
    return Refused(Mistake(place, code, sentence, help))


def render(mistake: Mistake) -> str:
    """The mistake as compilers print it: place, code, sentence, source line with a caret, help."""
    place = mistake.place
    where = f"{place.path}:{place.line}:{place.column}" if place.line else place.path
    rows = [f"{where}: error[{mistake.code}]: {mistake.sentence}"]
    if place.line and place.source.strip():
        source, column = _window(place.source, place.column)
        lead = "".join(_blank(character) for character in source[: column - 1])
        length = max(1, min(place.length, len(source) - column + 1))
        carets = "^" * sum(_width(character) for character in source[column - 1 :][:length])
        rows.append(f"{place.line:>5} | {visible(source)}".rstrip())
        rows.append(f"      | {lead}{carets or '^'}")
    if mistake.help:
        rows.append(f"      = help: {mistake.help}")
    return "\n".join(rows)


def report(mistakes: Sequence[Mistake]) -> str:
    """All mistakes, one below the other; of very many only the first, and how many more."""
    told = [render(mistake) for mistake in mistakes[:TOLD]]
    more = len(mistakes) - len(told)
    return "\n\n".join([*told, f"... and {more} more mistakes"] if more else told)


def visible(text: str) -> str:
    """The text with a mark in place of every character that a terminal might obey."""
    return "".join(c if c == "\t" or c.isprintable() else "\N{REPLACEMENT CHARACTER}" for c in text)


def quote(text: str) -> str:
    """Somebody's word within a sentence: in quotes, on one line, not too long."""
    text = " ".join(text.split("\n"))
    if len(text) > QUOTED:
        text = text[: QUOTED - 1] + "…"
    return f"'{visible(text)}'"


def nearest(word: str, known: Iterable[str]) -> str | None:
    """The known word that `word` was most likely meant to be, or None."""
    words = list(known)
    synonym = SYNONYMS.get(word.casefold())
    if synonym in words:
        return synonym
    lowered = {name.casefold(): name for name in reversed(words)}
    close = difflib.get_close_matches(word[:QUOTED].casefold(), lowered, n=1, cutoff=0.6)
    return lowered[close[0]] if close else None


def suggest(word: str, known: Sequence[str]) -> str:
    """The help for an unknown word: the nearest known one, or all of them if they are few."""
    close = nearest(word, known)
    if close is not None:
        return f"did you mean '{close}'?"
    if len(known) > LISTED:
        return "'laws list' shows all that there are"
    return f"known here: {', '.join(known)}" if known else ""


def _window(source: str, column: int) -> tuple[str, int]:
    """The part of a long line around `column`, and where the column is in that part."""
    source = source.rstrip()
    if len(source) <= SHOWN:
        return source, column
    start = max(0, min(column - 1 - SHOWN // 2, len(source) - SHOWN))
    part = source[start : start + SHOWN]
    if start:
        part = "…" + part[1:]
    if start + SHOWN < len(source):
        part = part[:-1] + "…"
    return part, column - start


def _width(character: str) -> int:
    """The columns of a terminal that a character takes."""
    if unicodedata.combining(character):
        return 0
    return 2 if unicodedata.east_asian_width(character) in "WF" else 1


def _blank(character: str) -> str:
    """The white space that is as wide as a character."""
    return "\t" if character == "\t" else " " * _width(character)
