"""Paths in a file: what they may name, and that they stay where they belong."""

import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import NamedTuple

from app.formats import SUFFIXES, kind_of
from app.scenario.kinds import Schema, Text, read_all, wrong
from app.scenario.mistakes import Mistake, Place, quote, refuse
from app.scenario.nodes import ListNode, MapNode, Node

FILMS = (".mp4", ".webm")
"""Their pictures need even sides."""


class Folders(NamedTuple):
    """The folders that paths in a file may lead into."""

    working: Path
    """Relative outputs and screenshots start here."""
    scenario: Path
    """Where the scenario file lies."""

    def place_of(self, path: str) -> str:
        """Where the file really is, symbolic links followed."""
        return os.path.realpath(self.working / path)

    def refuse_outside(self, path: str, base: Path, place: Place) -> None:
        """Raise Refused if `path`, seen from `base`, leaves both folders."""
        target = Path(os.path.realpath(base / path))
        homes = [Path(os.path.realpath(home)) for home in (self.working, self.scenario)]
        if not any(home in target.parents for home in homes):
            raise refuse(
                place,
                "outside-folder",
                f"{quote(path)} leads out of the scenario's folder and the working folder",
                "use a path inside one of them",
            )


class OutputKind(NamedTuple):
    """The path of a film, of pictures or of data."""

    folders: Folders | None
    """None: it may lie anywhere, because the person at the command line says so."""

    @property
    def name(self) -> str:
        return "a path that ends in " + ", ".join(SUFFIXES) + " or /"

    def read(self, node: Node, key: str) -> tuple[Place, str]:
        path = _path(node, key)
        *others, _ = path.split(", ")
        if any(map(kind_of, others)):
            raise refuse(
                node.place,
                "bad-output",
                f"{quote(path)} looks like several outputs",
                f"make it a list: [{path}]",
            )
        ends = path.casefold()
        if not ends.endswith((*SUFFIXES, "/")) or Path(path).name.startswith("."):
            raise refuse(
                node.place,
                "bad-output",
                f"{quote(path)} is no output that there is a format for",
                _hint(ends),
            )
        if self.folders is not None:
            self.folders.refuse_outside(path, self.folders.working, node.place)
        return node.place, path

    def schema(self) -> Schema:
        kinds = "|".join(suffix[1:] for suffix in SUFFIXES)
        return {"type": "string", "pattern": rf"^(?!~/)(?!.*(\.({kinds})|/), ).*(\.({kinds})|/)$"}


def _path(node: Node, key: str) -> str:
    path = Text(1000).read(node, key)
    if path.startswith("~/"):
        raise refuse(
            node.place,
            "bad-output",
            f"{quote(path)} begins with '~', which stands for no folder here",
            "write out the path",
        )
    return path


def _hint(path: str) -> str:
    if path.endswith(".png"):
        return "end the path in '/' for a folder of frames; the step 'screenshot' writes one PNG"
    return "end it in one of: " + " ".join(SUFFIXES) + ", or in '/' for a folder of PNG frames"


class OutputsKind(NamedTuple):
    """One output, or a list of them."""

    each: OutputKind

    @property
    def name(self) -> str:
        return f"{self.each.name}, or a list of such paths"

    def read(self, node: Node, key: str) -> tuple[tuple[Place, str], ...]:
        match node:
            case MapNode():
                raise wrong(node, key, self)
            case ListNode():
                return tuple(read_all(self.each, node.items, key))
            case _:
                return (self.each.read(node, key),)

    def schema(self) -> Schema:
        one = self.each.schema()
        return {"anyOf": [one, {"type": "array", "items": one}]}


class ScreenshotKind(NamedTuple):
    """The path of one picture."""

    folders: Folders

    @property
    def name(self) -> str:
        return "a path that ends in .png"

    def read(self, node: Node, key: str) -> str:
        path = _path(node, key)
        if not path.casefold().endswith(".png") or Path(path).name.startswith("."):
            raise wrong(node, key, self, "bad-output")
        self.folders.refuse_outside(path, self.folders.working, node.place)
        return path

    def schema(self) -> Schema:
        return {"type": "string", "pattern": r"^(?!~/).*\.png$"}


def clashes(
    folders: Folders, outputs: Sequence[tuple[Place, str]], pictures: Sequence[tuple[Place, str]]
) -> Iterable[Mistake]:
    """Files that would be written twice, or into a folder that is itself an output."""
    taken: dict[str, str] = {}
    frames = {folders.place_of(path): path for _, path in outputs if path.endswith("/")}
    for place, path in (*outputs, *pictures):
        target = folders.place_of(path)
        if target in taken:
            sentence = f"{quote(path)} would be written twice"
            yield Mistake(place, "double-output", sentence, "give each a name of its own")
        taken[target] = path
        holder = next((f for f in frames if target.startswith(f + os.sep)), None)
        if holder is not None:
            sentence = f"{quote(path)} lies in {quote(frames[holder])}, which is itself an output"
            yield Mistake(place, "double-output", sentence, "give it another folder")
