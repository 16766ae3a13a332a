"""The sentences and labels that a pupil reads, by name, from `assets/text/LANGUAGE.toml`."""

import tomllib
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import assets

FOLDER = Path(assets.__file__).parent / "text"


class MissingWords(LookupError):
    """A language, or one of its texts, is not there; the sentence names it and the file."""


class Words:
    """The texts of one language; calling it with a name gives the text.

    A name is the path through the tables of the file, joined by points: `inertia.title`.
    """

    def __init__(self, texts: Mapping[str, str], file: str) -> None:
        """Take the texts by name; `file` is what a complaint names."""
        self._texts = dict(texts)
        self.file = file

    def __call__(self, name: str, **values: str) -> str:
        """The text with its `{places}` filled in.

        Raises:
            MissingWords: if the file has no such text, or the text a place that is not given.
        """
        text = self._texts.get(name)
        if text is None:
            raise MissingWords(f"{self.file} has no text '{name}'")
        try:
            return text.format_map(values)
        except (KeyError, ValueError, IndexError) as wrong:
            raise MissingWords(
                f"{self.file}: the text '{name}' cannot be filled: {text}"
            ) from wrong

    def __contains__(self, name: str) -> bool:
        """Whether there is such a text."""
        return name in self._texts

    def names(self) -> tuple[str, ...]:
        """The names of all texts, in the order of the file."""
        return tuple(self._texts)


def languages() -> tuple[str, ...]:
    """The languages that have a file, sorted."""
    return tuple(sorted(path.stem for path in FOLDER.glob("*.toml")))


@cache
def load_words(lang: str = "en") -> Words:
    """The texts of a language.

    Raises:
        MissingWords: if there is no file for it.
    """
    if lang not in languages():
        raise MissingWords(f"there are no texts in '{lang}', only in {', '.join(languages())}")
    file = FOLDER / f"{lang}.toml"
    with file.open("rb") as opened:
        return Words(dict(_flat(tomllib.load(opened))), file.name)


def _flat(table: Mapping[str, Any], before: str = "") -> list[tuple[str, str]]:
    """Texts of nested tables, their names joined by points."""
    texts: list[tuple[str, str]] = []
    for key, value in table.items():
        name = f"{before}{key}"
        texts += _flat(value, f"{name}.") if isinstance(value, dict) else [(name, str(value))]
    return texts
