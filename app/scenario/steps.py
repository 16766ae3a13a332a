"""The steps of a scenario file: what each may say, and what it becomes."""

import re
from itertools import pairwise
from math import inf
from typing import Any, NamedTuple

from app.gestures import typed
from app.scenario import model
from app.scenario.catalogue import Names, numbered, unknown_name
from app.scenario.kinds import Field, Kind, Number, Pair, Schema, Time, read_all, unknown, wrong
from app.scenario.mistakes import Mistake, Refused, quote, refuse
from app.scenario.nodes import ListNode, MapNode, Node, ScalarNode
from app.targets import Target
from screens.kit.entry import LONGEST

ANY = Number(-inf, inf)
ANGLES = Pair(Number(-90, 90, unit="degrees"), "a tilt [roll, pitch] in degrees")
PLACE = Pair(ANY, "a place [x, y] in dp")
_ID = re.compile(r"[a-z][a-z0-9]*(\.[a-z0-9_]+)+")


class TargetKind(NamedTuple):
    """Something to touch."""

    names: Names

    @property
    def name(self) -> str:
        return "a widget's id, a label, or a place [x, y] in dp"

    def read(self, node: Node, key: str) -> Target:
        if isinstance(node, ListNode):
            return PLACE.read(node, key)
        if not isinstance(node, ScalarNode) or not node.is_text or not node.text.strip():
            raise wrong(node, key, self)
        if _ID.fullmatch(node.text) and node.text not in self.names.widgets:
            raise unknown_name(node, self.names, "widget")
        return node.text

    def schema(self) -> Schema:
        label = {"type": "string", "not": {"pattern": f"^{_ID.pattern}$"}, "minLength": 1}
        return {"anyOf": [{"enum": list(self.names.widgets)}, label, PLACE.schema()]}


class ProbeKind(NamedTuple):
    """The name of a number that the lesson shows."""

    names: Names

    @property
    def name(self) -> str:
        return "the name of a probe"

    def read(self, node: Node, key: str) -> str:
        if not isinstance(node, ScalarNode) or not node.is_text:
            raise wrong(node, key, self)
        if not self.names.has_probe(node.text):
            raise unknown_name(node, self.names, "probe")
        return node.text

    def schema(self) -> Schema:
        fixed = [name for name in self.names.probes if ".N." not in name]
        patterns = [numbered(name) for name in self.names.probes if ".N." in name]
        schemas: list[Schema] = [{"enum": fixed}]
        schemas += [{"type": "string", "pattern": f"^({'|'.join(patterns)})$"}] if patterns else []
        return {"anyOf": schemas}


class FillKind(NamedTuple):
    """Numbers for the fields of a dialog."""

    names: Names

    @property
    def name(self) -> str:
        return "a mapping of fields to numbers, such as {mass: 2}"

    def read(self, node: Node, key: str) -> dict[str, float]:
        if not isinstance(node, MapNode) or not node.entries:
            raise wrong(node, key, self)
        values: dict[str, float] = {}
        mistakes: list[Mistake] = []
        for name, value in node.entries:
            try:
                if name.text not in self.names.fields:
                    raise unknown(name, "field", tuple(self.names.fields), "unknown-field")
                values[name.text] = self.names.fields[name.text].read(value, name.text)
                if not fits(values[name.text]):
                    raise refuse(
                        value.place,
                        "text-too-long",
                        f"{quote(name.text)} has too many digits: a field holds {LONGEST}",
                    )
            except Refused as refused:
                mistakes.extend(refused.mistakes)
        if mistakes:
            raise Refused(*mistakes)
        return values

    def schema(self) -> Schema:
        return {
            "type": "object",
            "properties": {name: kind.schema() for name, kind in self.names.fields.items()},
            "additionalProperties": False,
            "minProperties": 1,
        }


def fits(value: float) -> bool:
    """Whether a number can be typed into a field as it is."""
    text = typed(value)
    return len(text) <= LONGEST and float(text) == value


class CurvePoint:
    """One moment of a tilt: time, roll, pitch."""

    name = "a moment [time, roll, pitch], such as [1s, 15, 0]"

    def read(self, node: Node, key: str) -> tuple[float, float, float]:
        if not isinstance(node, ListNode) or len(node.items) != 3:
            raise wrong(node, key, self)
        time, *angles = node.items
        try:
            seconds = Time().read(time, key)
        except Refused as refused:
            raise Refused(*refused.mistakes, *_mistakes(ANGLES.each, angles, key)) from None
        roll, pitch = read_all(ANGLES.each, angles, key)
        return seconds, roll, pitch

    def schema(self) -> Schema:
        angle = ANGLES.each.schema()
        items = [Time().schema(), angle, angle]
        return {"type": "array", "items": items, "minItems": 3, "maxItems": 3}


def _mistakes(kind: Kind[Any], nodes: list[Node], key: str) -> tuple[Mistake, ...]:
    try:
        read_all(kind, nodes, key)
    except Refused as refused:
        return refused.mistakes
    return ()


class ShownKind:
    """What `hide` and `show` are about."""

    options = ("film", "taps", "captions")
    name = "film, taps or captions, or nothing"

    def read(self, node: Node, key: str) -> str:
        if isinstance(node, ScalarNode) and node.is_nothing:
            return "film"
        if not isinstance(node, ScalarNode) or not node.is_text:
            raise wrong(node, key, self)
        if node.text not in self.options:
            raise unknown(node, f"thing to {key}", self.options, "unknown-word")
        return node.text

    def schema(self) -> Schema:
        return {"enum": [*self.options, None]}


def comparison(node: MapNode, values: dict[str, Any]) -> model.Comparison:
    """The comparison in an `expect` or `until`; raises Refused if there is none or too much."""
    given = [name for name in ("equals", "near", "above", "below") if values[name] is not None]
    if not given:
        raise refuse(
            node.place,
            "missing-key",
            "nothing says what the probe is compared with",
            "add one of: equals, near with tol, above, below",
        )
    if len(given) > 1 and given != ["above", "below"]:
        names = " and ".join(f"'{name}'" for name in given)
        raise refuse(node.place, "too-many-keys", f"{names} do not go together", "keep one of them")
    if ("near" in given) != (values["tol"] is not None):
        missing = "tol" if "near" in given else "near"
        other = "near" if "near" in given else "tol"
        raise refuse(
            node.place,
            "missing-key",
            f"'{other}' needs '{missing}' beside it",
            "near: the expected value, tol: how far from it still counts",
        )
    if given == ["above", "below"] and values["above"] >= values["below"]:
        raise refuse(
            node.place, "out-of-range", "no value is above 'above' and below 'below' at once"
        )
    return model.Comparison(
        values["equals"], values["near"], values["tol"] or 0.0, values["above"], values["below"]
    )


def comparison_fields(names: Names) -> dict[str, Field]:
    """The keys that `expect` and `until` share."""
    return {
        "probe": Field(ProbeKind(names), "The number to look at.", required=True),
        "equals": Field(ANY, "Exactly this value."),
        "near": Field(ANY, "This value, give or take 'tol'."),
        "tol": Field(Number(0, inf), "How far from 'near' still counts, in the probe's unit."),
        "above": Field(ANY, "More than this; together with 'below', between the two."),
        "below": Field(ANY, "Less than this."),
    }


def tilt(node: MapNode, values: dict[str, Any]) -> dict[str, Any]:
    """Either a target or a curve, whose times start at 0 and rise."""
    if (values["to"] is None) == (values["curve"] is None):
        code = "missing-key" if values["to"] is None else "too-many-keys"
        raise refuse(node.place, code, "'tilt' needs either 'to' or 'curve'")
    if values["curve"] is None:
        return {"to": values["to"], "over": values["over"] or 0.0, "curve": ()}
    if values["over"] is not None:
        raise refuse(
            node.place,
            "too-many-keys",
            "'over' does not go with 'curve', which has times of its own",
        )
    times = [time for time, _, _ in values["curve"]]
    rising = all(a < b for a, b in pairwise(times))
    if times[0] != 0 or not rising:
        curve = node.get("curve")
        raise refuse(
            curve.place if curve else node.place,
            "bad-time",
            "the times of a curve must start with 0s and rise from one moment to the next",
        )
    return {"to": None, "over": times[-1], "curve": values["curve"]}


def as_given(node: MapNode, values: dict[str, Any]) -> dict[str, Any]:
    """The values as they are."""
    return values
