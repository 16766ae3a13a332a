"""The format of a scenario file: all that may stand in it, and what it becomes."""

from collections.abc import Callable
from math import inf
from typing import Any, NamedTuple

from app.scenario import model
from app.scenario.catalogue import Names
from app.scenario.header import header_fields
from app.scenario.kinds import Field, Kind, ListOf, Number, Record, Schema, Text, Time, wrong
from app.scenario.mistakes import Mistake, Place, Refused, quote, refuse, suggest
from app.scenario.nodes import ListNode, MapNode, Node, ScalarNode, found
from app.scenario.paths import Folders, ScreenshotKind
from app.scenario.steps import (
    ANGLES,
    CurvePoint,
    FillKind,
    ShownKind,
    TargetKind,
    as_given,
    comparison,
    comparison_fields,
    tilt,
)

Include = Callable[[str, Place], tuple[model.Step, ...]]
"""Reads the steps of the scenario file at a path, named at a place; raises Refused."""


class Context(NamedTuple):
    """What the meaning of a file depends on, besides its text."""

    names: Names
    folders: Folders
    include: Include


class StepKind(NamedTuple):
    """How one step is written, and what it becomes."""

    kind: Kind[Any]
    about: str
    build: Callable[[Place, Any], model.Step]
    bare: bool = False
    """Whether it may stand without a value."""
    points_at_value: bool = False
    """Whether its place is that of the value rather than of the key."""


class StepsKind:
    """The list of steps."""

    name = "a list of steps, each starting with '- '"

    def __init__(self, context: Context) -> None:
        self.context = context
        self.kinds = step_kinds(self)

    def read(self, node: Node, key: str) -> tuple[model.Step, ...]:
        if not isinstance(node, ListNode):
            raise wrong(node, key, self)
        if not node.items:
            raise refuse(node.place, "missing-value", f"{quote(key)} needs at least one step")
        steps: list[model.Step] = []
        mistakes: list[Mistake] = []
        for item in node.items:
            try:
                steps.append(self.step(item))
            except Refused as refused:
                mistakes.extend(refused.mistakes)
        if mistakes:
            raise Refused(*mistakes)
        return tuple(steps)

    def step(self, node: Node) -> model.Step:
        """One entry of the list."""
        if isinstance(node, ScalarNode) and node.is_text:
            return self.bare(node)
        if not isinstance(node, MapNode) or not node.entries:
            raise refuse(
                node.place,
                "wrong-type",
                f"a step must be a mapping with one key, such as 'wait: 1s', not {found(node)}",
            )
        (name, value), *others = node.entries
        kind = self.kinds.get(name.text)
        if kind is None:
            raise self.unknown(name)
        if others:
            raise self.crowded(name, [other for other, _ in others])
        if isinstance(value, ScalarNode) and value.is_nothing and not kind.bare:
            raise refuse(
                name.place,
                "missing-value",
                f"'{name.text}' needs a value",
                f"it must be {kind.kind.name}",
            )
        place = value.place if kind.points_at_value else name.place
        return kind.build(place, kind.kind.read(value, name.text))

    def bare(self, node: ScalarNode) -> model.Step:
        """A step without a value."""
        kind = self.kinds.get(node.text)
        if kind is None:
            raise self.unknown(node)
        if not kind.bare:
            raise refuse(
                node.place,
                "missing-value",
                f"'{node.text}' needs a value",
                f"write '- {node.text}: ' and {kind.kind.name}",
            )
        return kind.build(node.place, kind.kind.read(ScalarNode(node.place, "", True), node.text))

    def unknown(self, name: ScalarNode) -> Refused:
        """The refusal of a step that there is not."""
        return refuse(
            name.place,
            "unknown-step",
            f"unknown step {quote(name.text)}",
            suggest(name.text, tuple(self.kinds)),
        )

    def crowded(self, name: ScalarNode, others: list[ScalarNode]) -> Refused:
        """The refusal of a step with more than one key."""
        if others[0].text in self.kinds:
            help = f"start a step of its own: '- {others[0].text}: ...'"
        else:
            help = f"indent {quote(others[0].text)} further to make it part of '{name.text}'"
        return refuse(
            others[0].place,
            "two-steps",
            f"a step has one key; this one has '{name.text}' and {quote(others[0].text)}",
            help,
        )

    def schema(self) -> Schema:
        return {"type": "array", "items": {"$ref": "#/definitions/step"}, "minItems": 1}


def step_kinds(steps: StepsKind) -> dict[str, StepKind]:
    """Every step, by its key."""
    return _doing(steps.context) | _looking(steps.context) | _showing(steps.context) | _flow(steps)


def _doing(context: Context) -> dict[str, StepKind]:
    """What a hand does."""
    target = TargetKind(context.names)
    drag = {
        "from": Field(target, "Where the finger goes down.", required=True),
        "to": Field(target, "Where it goes up.", required=True),
        "over": Field(Time(), "How long it takes.", default=0.5),
    }
    tilting = {
        "to": Field(ANGLES, "Roll and pitch in degrees, reached linearly."),
        "over": Field(Time(), "How long it takes to get there; at once if not given."),
        "curve": Field(
            ListOf(CurvePoint(), "a list of moments [time, roll, pitch]"),
            "Moments [time, roll, pitch], connected linearly; the first time is 0s.",
        ),
    }
    return {
        "tap": StepKind(
            target, "Touch a widget, by id, label or place.", model.Tap, points_at_value=True
        ),
        "drag": StepKind(
            Record("a mapping with 'from' and 'to'", drag, as_given),
            "Pull from one place to another in a straight line.",
            lambda place, v: model.Drag(place, v["from"], v["to"], v["over"]),
        ),
        "fill": StepKind(
            FillKind(context.names),
            "Type numbers into fields of the open dialog.",
            model.Fill,
        ),
        "tilt": StepKind(
            Record("a mapping with 'to' or 'curve'", tilting, tilt),
            "Turn the device.",
            lambda place, v: model.Tilt(place, v["to"], v["over"], v["curve"]),
        ),
        "wait": StepKind(Time(), "Let time pass.", model.Wait),
    }


def _looking(context: Context) -> dict[str, StepKind]:
    """What is asked of the numbers."""
    fields = comparison_fields(context.names)
    within = Field(Time(), "How long it may take at most.", default=10.0)

    def compared(node: MapNode, values: dict[str, Any]) -> dict[str, Any]:
        return values | {"comparison": comparison(node, values)}

    what = "a mapping such as {probe: time, above: 1}"
    return {
        "until": StepKind(
            Record(what, fields | {"within": within}, compared),
            "Wait until a number is as it should be; the run fails if it never is.",
            lambda place, v: model.Until(place, v["probe"], v["comparison"], v["within"]),
        ),
        "expect": StepKind(
            Record(what, fields, compared),
            "A number must be as it should be now, or the run fails.",
            lambda place, v: model.Expect(place, v["probe"], v["comparison"]),
        ),
    }


def _showing(context: Context) -> dict[str, StepKind]:
    """What is made of the picture."""
    return {
        "caption": StepKind(
            Text(300, may_be_empty=True, is_drawn=True),
            "Words on the film until the next caption; an empty one takes them away.",
            lambda place, words: model.Caption(place, words.strip()),
            bare=True,
        ),
        "marker": StepKind(Text(100), "A name for this moment in the report.", model.Marker),
        "screenshot": StepKind(
            ScreenshotKind(context.folders),
            "Write the picture as a PNG, from the working folder.",
            model.Screenshot,
            points_at_value=True,
        ),
        "speed": StepKind(
            Number(0.05, 20),
            "Play at this multiple of true speed from here on; the physics stays the same.",
            model.Speed,
        ),
        "hide": StepKind(
            ShownKind(), "Stop filming; or no longer draw taps or captions.", model.Hide, bare=True
        ),
        "show": StepKind(
            ShownKind(), "Film again; or draw taps or captions again.", model.Show, bare=True
        ),
    }


def _flow(steps: StepsKind) -> dict[str, StepKind]:
    """Steps of steps."""
    repeat = {
        "times": Field(Number(1, inf, whole=True), "How often.", required=True),
        "steps": Field(steps, "What to do each time.", required=True),
    }
    return {
        "repeat": StepKind(
            Record("a mapping with 'times' and 'steps'", repeat, as_given),
            "Do some steps several times.",
            lambda place, v: model.Repeat(place, v["times"], v["steps"]),
        ),
        "run": StepKind(
            RunKind(steps.context),
            "Do the steps of another scenario of the same screen, from this file's folder.",
            lambda place, v: model.Run(place, *v),
        ),
    }


class RunKind(NamedTuple):
    """The path of another scenario file."""

    context: Context

    @property
    def name(self) -> str:
        return "the path of a scenario file"

    def read(self, node: Node, key: str) -> tuple[str, tuple[model.Step, ...]]:
        path = Text(1000).read(node, key)
        return path, self.context.include(path, node.place)

    def schema(self) -> Schema:
        return Text(1000).schema()


def file_fields(context: Context) -> dict[str, Field]:
    """Every key of a file."""
    header = header_fields(context.names, context.folders)
    return header | {"steps": Field(StepsKind(context), "What happens, in order.", required=True)}
