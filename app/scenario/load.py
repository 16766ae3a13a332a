"""A scenario file becomes a Scenario, or every mistake in it is told."""

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from app.scenario import limits
from app.scenario.catalogue import NAVIGATION, SCREENS, Names, of_all, of_screen
from app.scenario.format import Context, file_fields
from app.scenario.header import header_fields
from app.scenario.kinds import Field, Kind, Record
from app.scenario.mistakes import Mistake, Place, Refused, ScenarioMistakes, quote, refuse
from app.scenario.model import Scenario, Step
from app.scenario.nodes import ListNode, MapNode, Node, ScalarNode, found
from app.scenario.paths import FILMS, Folders, OutputKind, OutputsKind, clashes
from app.scenario.reading import LARGEST, read
from app.scenario.steps import as_given

DEEPEST_RUN = 8
"""Scenarios that run each other, one inside the other, at most."""


class Overrides(NamedTuple):
    """What the command line says instead of the file; all of it text as it was typed."""

    seed: str | None = None
    size: str | None = None
    fps: str | None = None
    outputs: Sequence[str] = ()
    """If there are any, the file's own are not written. They may lie anywhere."""
    settings: Sequence[str] = ()
    """Each as `name=value`."""


AS_WRITTEN = Overrides()
"""The command line says nothing instead of the file."""


def load(path: str, overrides: Overrides = AS_WRITTEN, working: Path | None = None) -> Scenario:
    """The scenario in the file at `path`.

    `working` is the folder that outputs start from, the present one if not given. Raises
    ScenarioMistakes with all that is wrong with the file and the overrides.
    """
    folders = Folders(working or Path.cwd(), Path(os.path.dirname(path)))
    try:
        return _Files(folders).scenario(path, overrides)
    except Refused as refused:
        raise ScenarioMistakes(refused.mistakes, first=path) from None


class _Files:
    """Reads a scenario file and those that it runs, each of them once."""

    def __init__(self, folders: Folders) -> None:
        self.folders = folders
        self.chain: list[_Open] = []
        self.known: dict[str, tuple[Step, ...] | Refused] = {}
        self.noted: list[Mistake] = []
        """What may not stand in a file but does not keep it from being read to its end."""

    def scenario(self, path: str, overrides: Overrides) -> Scenario:
        """The file that the person named."""
        values: dict[str, Any] = {}
        mistakes: list[Mistake] = []
        root = self.tree(path, Place(path))
        try:
            values |= self.values(root, path)
        except Refused as refused:
            mistakes.extend(refused.mistakes)
        try:
            values |= _overridden(overrides, header_fields(_names(root), self.folders))
        except Refused as refused:
            mistakes.extend(refused.mistakes)
        if not mistakes:
            values["set"] = values["set"] | values.pop("more settings", {})
            mistakes.extend(_excess(values, self.folders))
        if mistakes or self.noted:
            raise Refused(*_on_other_lines(mistakes, self.noted), *self.noted)
        values["fps"] = int(values["fps"])
        values["outputs"] = tuple(output for _, output in values.pop("output"))
        values["settings"] = values.pop("set")
        return Scenario(path=path, **values)

    def tree(self, path: str, named: Place) -> Node:
        """The tree of a file; if it cannot be read, the mistake is where it is named."""
        root, noted = read(_content(path, named), path)
        self.noted.extend(noted)
        return root

    def values(self, root: Node, path: str) -> dict[str, Any]:
        """The values of a file's keys."""
        if not isinstance(root, MapNode):
            raise refuse(
                root.place,
                "wrong-type",
                f"a scenario must be a mapping with laws, screen and steps, not {found(root)}",
            )
        screen = root.get("screen")
        named = screen.text if isinstance(screen, ScalarNode) else ""
        context = Context(_names(root), self.folders, self.include)
        fields = file_fields(context)
        self.chain.append(_Open(os.path.realpath(path), path, named))
        try:
            return Record("a scenario", fields, as_given).read(root, "")
        finally:
            self.chain.pop()

    def include(self, path: str, place: Place) -> tuple[Step, ...]:
        """The steps of the file at `path`, which a file being read names at `place`."""
        parent = self.chain[-1]
        folder = os.path.dirname(parent.shown)
        self.folders.refuse_outside(path, Path(folder), place)
        shown = os.path.join(folder, path)
        real = os.path.realpath(shown)
        self.refuse_loop(real, shown, place)
        if real not in self.known:
            try:
                self.known[real] = self.included(shown, place, parent.screen)
            except Refused as refused:
                self.known[real] = refused
        steps = self.known[real]
        if isinstance(steps, Refused):
            raise Refused(*steps.mistakes)
        return steps

    def included(self, shown: str, place: Place, screen: str) -> tuple[Step, ...]:
        """The steps of a file that is read for the first time."""
        values = self.values(self.tree(shown, place), shown)
        if values["screen"] != screen:
            raise refuse(
                place,
                "other-screen",
                f"{quote(shown)} is for the screen '{values['screen']}', this file for '{screen}'",
            )
        steps: tuple[Step, ...] = values["steps"]
        return steps

    def refuse_loop(self, real: str, shown: str, place: Place) -> None:
        """Raise Refused if the file is being read already, or too many are."""
        reals = [opened.real for opened in self.chain]
        if real in reals:
            first, *others = [quote(opened.shown) for opened in self.chain[reals.index(real) :]]
            chain = ", which runs ".join([*others, first if others else "itself"])
            raise refuse(place, "include-loop", f"{first} runs {chain}")
        if len(self.chain) == DEEPEST_RUN:
            raise refuse(
                place,
                "too-deep",
                f"more than {DEEPEST_RUN} files run each other, one inside the other",
            )


class _Open(NamedTuple):
    """A file that is being read."""

    real: str
    """Where it is, symbolic links followed."""
    shown: str
    """How it was named."""
    screen: str


def _content(path: str, named: Place) -> bytes:
    """The bytes of a file, at most one more than allowed."""
    try:
        with open(path, "rb") as file:
            return file.read(LARGEST + 1)
    except FileNotFoundError:
        raise refuse(named, "no-file", f"there is no file {quote(path)}") from None
    except OSError as error:
        reason = error.strerror or "unknown reason"
        raise refuse(named, "no-file", f"cannot read {quote(path)}: {reason}") from None
    except ValueError:
        raise refuse(named, "no-file", f"{quote(path)} cannot be the name of a file") from None


def _on_other_lines(mistakes: Iterable[Mistake], noted: Iterable[Mistake]) -> Iterator[Mistake]:
    """The mistakes that do not share a line with an alias or a tag: they might follow from it."""
    lines = {(m.place.path, m.place.line) for m in noted if m.code in ("alias", "tag")}
    return (m for m in mistakes if (m.place.path, m.place.line) not in lines)


def _names(root: Node) -> Names:
    """What the file may call by name: all screens if it may navigate, else those of its own."""
    screen = root.get("screen") if isinstance(root, MapNode) else None
    if not isinstance(screen, ScalarNode) or screen.text not in SCREENS:
        return of_all()
    own = of_screen(screen.text)
    here = {name for name in own.widgets if not name.startswith(NAVIGATION)}
    if all(target in here for target in _tapped(root)):
        return own
    everything = of_all()
    return everything._replace(settings=own.settings)


def _tapped(node: Node) -> Iterator[str]:
    """What the taps in a tree touch, as text; a place counts as an empty text."""
    match node:
        case ListNode():
            for item in node.items:
                yield from _tapped(item)
        case MapNode():
            for key, value in node.entries:
                if key.text == "tap":
                    yield value.text if isinstance(value, ScalarNode) else ""
                else:
                    yield from _tapped(value)
        case _:
            pass


def _overridden(overrides: Overrides, fields: Mapping[str, Field]) -> dict[str, Any]:
    """The values that the command line gives; raises Refused with all its mistakes."""
    values: dict[str, Any] = {}
    mistakes: list[Mistake] = []
    for key, option, text in (
        ("seed", "--seed", overrides.seed),
        ("size", "--size", overrides.size),
        ("fps", "--fps", overrides.fps),
    ):
        if text is not None:
            node = ScalarNode(Place(option), text, plain=True)
            _keep(values, mistakes, key, fields[key].kind, node)
    if overrides.outputs:
        paths = tuple(ScalarNode(Place("--output"), path, False) for path in overrides.outputs)
        outputs = ListNode(Place("--output"), paths)
        _keep(values, mistakes, "output", OutputsKind(OutputKind(None)), outputs)
    if overrides.settings:
        assigned = _assigned(overrides.settings, mistakes)
        _keep(values, mistakes, "more settings", fields["set"].kind, assigned)
    if mistakes:
        raise Refused(*mistakes)
    return values


def _keep(
    values: dict[str, Any], mistakes: list[Mistake], key: str, kind: Kind[object], node: Node
) -> None:
    """Read a node; keep its value under `key`, or its mistakes."""
    try:
        values[key] = kind.read(node, key)
    except Refused as refused:
        mistakes.extend(refused.mistakes)


def _assigned(settings: Sequence[str], mistakes: list[Mistake]) -> MapNode:
    """Texts such as `body.mass=2` as a mapping; the last one of a name counts.

    One without a value is left out and added to the mistakes.
    """
    entries: dict[str, tuple[ScalarNode, Node]] = {}
    place = Place("--set")
    for text in settings:
        name, sign, value = text.partition("=")
        if not sign:
            sentence = f"{quote(text)} gives no value"
            help = "write it as --set name=value"
            mistakes.append(Mistake(place, "missing-value", sentence, help))
            continue
        entries[name.strip()] = (
            ScalarNode(place, name.strip(), plain=True),
            ScalarNode(place, value.strip(), plain=True),
        )
    return MapNode(Place("--set"), tuple(entries.values()))


def _excess(values: Mapping[str, Any], folders: Folders) -> Iterator[Mistake]:
    """What is wrong only with the file as a whole: too much of it, or outputs that clash."""
    too_much = list(limits.excess(values["steps"]))
    yield from too_much
    outputs: Sequence[tuple[Place, str]] = values["output"]
    shots = [] if too_much else [(s.place, s.path) for s in limits.pictures(values["steps"])]
    yield from clashes(folders, outputs, shots)
    width, height = values["size"]
    if width % 2 or height % 2:
        for place, path in outputs:
            if path.casefold().endswith(FILMS):
                sentence = f"{quote(path)} needs even sides; the size is {width}x{height}"
                size = f"{width + width % 2}x{height + height % 2}"
                yield Mistake(place, "bad-size", sentence, f"use size: {size}")
