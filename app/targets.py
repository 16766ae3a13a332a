"""Where a finger goes: a widget's id, a visible label or a place becomes a point of the screen."""

from collections.abc import Sequence
from typing import Literal

from app.scenario.mistakes import quote, suggest
from screens.kit.geometry import Point, Rect
from screens.kit.layout import SCREENS
from screens.lesson import Lesson, Widget
from screens.lessons import lesson_class

Target = str | Point
"""A widget's id, a label a pupil can read, or a place in dp."""

Reason = Literal["outside", "missing", "covered", "disabled", "ambiguous"]
"""Why something cannot be touched."""

TRIES = (0.5, 0.25, 0.75, 0.1, 0.9)
"""Parts of a widget's width and height at which it is touched, the first free one first."""


class NoTarget(Exception):
    """There is nothing to touch; `sentence` says why and `help` what to do about it."""

    def __init__(self, reason: Reason, sentence: str, help: str = "") -> None:
        """`help` may be empty."""
        super().__init__(sentence)
        self.reason = reason
        self.sentence = sentence
        self.help = help


def resolve(lesson: Lesson, target: Target) -> Point:
    """The point (dp) at which `target` can be touched now; raises NoTarget if it cannot be."""
    if isinstance(target, Point):
        return _inside(lesson, target)
    widgets = lesson.widgets()
    named = [widget for widget in widgets if widget.id == target] or _labelled(widgets, target)
    if not named:
        raise _missing(lesson.id, widgets, target)
    free = [(widget, at) for widget in named if (at := _free_point(widgets, widget)) is not None]
    if not free:
        raise _covered(widgets, named[-1])
    enabled = [(widget, at) for widget, at in free if widget.enabled]
    if not enabled:
        raise NoTarget("disabled", f"'{free[0][0].id}' is disabled now")
    if len(enabled) > 1:
        ids = ", ".join(f"'{widget.id}'" for widget, _ in enabled)
        raise NoTarget("ambiguous", f"'{target}' could be any of {ids}", "use the id")
    return enabled[0][1]


def touched(widgets: Sequence[Widget], at: Point) -> Widget | None:
    """The widget that gets a touch at `at`: the last drawn there."""
    return next((widget for widget in reversed(widgets) if widget.rect.holds(at)), None)


def _inside(lesson: Lesson, at: Point) -> Point:
    width, height = lesson.size
    if not Rect(0, 0, width, height).holds(at):
        raise NoTarget(
            "outside",
            f"[{at.x:g}, {at.y:g}] lies outside the screen",
            f"the screen is {width:g} dp wide and {height:g} dp high",
        )
    return at


def _labelled(widgets: Sequence[Widget], label: str) -> list[Widget]:
    """The widgets with this label; its case and spacing do not matter."""
    wanted = _plain(label)
    return [widget for widget in widgets if widget.label and _plain(widget.label) == wanted]


def _plain(label: str) -> str:
    return " ".join(label.split()).casefold()


def _free_point(widgets: Sequence[Widget], widget: Widget) -> Point | None:
    """A point at which nothing covers the widget, its middle if possible."""
    rect = widget.rect
    for down in TRIES:
        for across in TRIES:
            at = Point(rect.x + across * rect.width, rect.y + down * rect.height)
            if touched(widgets, at) is widget:
                return at
    return None


def _missing(screen: str, widgets: Sequence[Widget], target: str) -> NoTarget:
    words = [widget.id for widget in widgets] + [widget.label for widget in widgets if widget.label]
    sentence = f"there is no {quote(target)} on the screen now"
    if screen in SCREENS and target in lesson_class(screen).WIDGETS:
        return NoTarget("missing", sentence, "it is there while a dialog is open: open it first")
    words = list(dict.fromkeys(words))
    return NoTarget("missing", sentence, suggest(target, words))


def _covered(widgets: Sequence[Widget], widget: Widget) -> NoTarget:
    cover = touched(widgets, widget.rect.center)
    if cover is None:
        return NoTarget("outside", f"'{widget.id}' lies outside the screen")
    ways_out = [w.id for w in widgets if w.id in ("dialog.accept", "dialog.cancel") and w.enabled]
    if not ways_out:
        return NoTarget("covered", f"'{widget.id}' is covered by '{cover.id}'")
    first = " or ".join(f"'{way}'" for way in ways_out)
    return NoTarget("covered", f"'{widget.id}' is covered by the open dialog", f"tap {first} first")
