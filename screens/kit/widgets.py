"""What can be touched on every screen, and which of several things gets a touch."""

from collections.abc import Sequence

from screens.kit.geometry import Point, Rect
from screens.kit.layout import SCREENS, Layout, columns
from screens.kit.words import Words
from screens.lesson import Widget

NAVIGATION = tuple(f"nav.{screen}" for screen in SCREENS)
"""Ids of the widgets that lead to another lesson."""

MODAL = "dialog"
"""Id of what lies between an open dialog and the screen, and takes all touches beside it."""


def touched(widgets: Sequence[Widget], at: Point) -> str:
    """The id of the widget that gets a touch: the last one drawn there, if it is enabled.

    An empty string if there is none.
    """
    for widget in reversed(widgets):
        if widget.rect.holds(at):
            return widget.id if widget.enabled else ""
    return ""


def navigation(area: Layout, words: Words) -> list[Widget]:
    """The three lessons, side by side."""
    places = columns(area.nav, len(NAVIGATION))
    return [Widget(id, rect, words(id)) for id, rect in zip(NAVIGATION, places, strict=True)]


def seen(rect: Rect, through: Rect) -> Rect:
    """The part of a rectangle that lies in another; without area if there is none."""
    x, y = max(rect.x, through.x), max(rect.y, through.y)
    right, bottom = min(rect.right, through.right), min(rect.bottom, through.bottom)
    return Rect(x, y, max(right - x, 0.0), max(bottom - y, 0.0))
