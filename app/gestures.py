"""What a hand does, as events: shared by the player and by the rehearsal of a scenario."""

from collections.abc import Iterator
from typing import NamedTuple

from app.scenario.model import Drag as DragStep
from app.scenario.model import Fill, Tap, ticks
from app.targets import NoTarget, resolve
from screens.kit import events
from screens.kit.events import Event
from screens.kit.geometry import Point
from screens.lesson import Lesson

FIELD = ".field"
"""What the id of a field has behind the name that a scenario gives it."""


class Touch(NamedTuple):
    """Events that belong to one instant."""

    events: tuple[Event, ...]
    after_tick: bool
    """Whether a tick passes before them."""


def gesture(lesson: Lesson, step: Tap | DragStep | Fill) -> Iterator[Touch]:
    """The touches of a step, in order; ask for the next one when the last was done.

    Raises NoTarget when it comes to something that cannot be touched. A drag of n ticks is the
    finger going down, then n moves, the last with the finger going up; both its ends are found
    before the finger goes down. A tap and a fill take no time.
    """
    match step:
        case Tap():
            yield Touch((events.Tap(resolve(lesson, step.target)),), after_tick=False)
        case DragStep():
            down, up = resolve(lesson, step.start), resolve(lesson, step.end)
            yield from _drag(down, up, ticks(step.over))
        case Fill():
            for name, value in step.values.items():
                yield Touch(_fill(lesson, name, value), after_tick=False)


def _drag(down: Point, up: Point, count: int) -> Iterator[Touch]:
    """A straight line, evenly in time."""
    yield Touch((events.Drag(down, down),), after_tick=False)
    for tick in range(1, count):
        part = tick / count
        at = Point(down.x + part * (up.x - down.x), down.y + part * (up.y - down.y))
        yield Touch((events.Drag(down, at),), after_tick=True)
    yield Touch((events.Drag(down, up), events.Release(up)), after_tick=count > 0)


def _fill(lesson: Lesson, name: str, value: float) -> tuple[Event, ...]:
    """A tap on a field, which selects what it holds, then a key for each digit, then enter."""
    field = name + FIELD
    ids = [widget.id for widget in lesson.widgets()]
    if field not in ids:
        fields = [known.removesuffix(FIELD) for known in ids if known.endswith(FIELD)]
        if not fields:
            raise NoTarget("missing", "no dialog with fields is open", "open it with a tap first")
        raise NoTarget(
            "missing", f"the open dialog has no field '{name}'", f"it has: {', '.join(fields)}"
        )
    keys = [events.Key(character) for character in typed(value)]
    return (events.Tap(resolve(lesson, field)), *keys, events.Key("enter"))


def typed(value: float) -> str:
    """A number as somebody types it: digits, a point, a minus sign; never an exponent."""
    text = f"{value:.12f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
