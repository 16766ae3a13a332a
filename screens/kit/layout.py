"""Where everything lies on a screen of any size, upright or across, in dp.

Nothing is measured here: words get room for a fixed number of lines, so that a picture without
letters has the same places as one with them.
"""

from functools import lru_cache
from typing import NamedTuple

from screens.kit.geometry import Rect, Size

SCREENS = ("inertia", "forces", "reactions")
"""The lessons' ids in the order of the navigation."""

MARGIN = 16.0
"""Between the words and the edge of the screen."""
EDGE = 12.0
"""Between the canvas and the edge of an upright screen."""
GAP = 8.0
TOUCH = 40.0
"""Least height of what is touched."""
UPRIGHT = 1.1
"""From this ratio of height to width on a screen has one column."""
NAV = 56.0
"""Height of the navigation of an upright screen."""


class Layout(NamedTuple):
    """The parts of a screen."""

    size: Size
    portrait: bool
    words: Rect
    """Title, law and explanation."""
    canvas: Rect
    readouts: Rect
    controls: Rect
    """One row of 40 if upright, two with a gap if across."""
    nav: Rect

    @property
    def screen(self) -> Rect:
        """All of it."""
        return Rect(0.0, 0.0, *self.size)


@lru_cache(maxsize=16)
def layout(size: Size) -> Layout:
    """Divide a screen: one column if it is upright, words beside the canvas if not."""
    return _upright(size) if size.height >= UPRIGHT * size.width else _across(size)


def _upright(size: Size) -> Layout:
    wide, high = size
    inner = wide - 2 * MARGIN
    nav = Rect(0.0, high - NAV, wide, NAV)
    controls = Rect(MARGIN, nav.y - 6 - TOUCH, inner, TOUCH)
    readouts = Rect(MARGIN, controls.y - GAP - 40, inner, 40.0)
    words = Rect(MARGIN, 12.0, inner, 102.0)
    top = words.bottom + 6
    canvas = Rect(EDGE, top, wide - 2 * EDGE, readouts.y - 6 - top)
    return Layout(size, True, words, canvas, readouts, controls, nav)


def _across(size: Size) -> Layout:
    wide, high = size
    # The panel takes what a canvas of 5 to 4 leaves over, up to a comfortable width.
    panel = min(max(202.0, wide - GAP - (high - 2 * GAP) * 1.25), 320.0)
    inner = panel - MARGIN - 10
    nav = Rect(0.0, high - 44, panel - 2, 44.0)
    rows = 2 * TOUCH + GAP
    controls = Rect(MARGIN, nav.y - 6 - rows, inner, rows)
    readouts = Rect(MARGIN, controls.y - 6 - 72, inner, 72.0)
    words = Rect(MARGIN, 4.0, inner, readouts.y - 4 - 4)
    canvas = Rect(panel, GAP, wide - panel - GAP, high - 2 * GAP)
    return Layout(size, False, words, canvas, readouts, controls, nav)


def dialog(size: Size, wanted: Size) -> Rect:
    """Where a dialog lies: in the middle of an upright screen, else in the middle of the canvas.

    So what stands beside the canvas, a caption too, stays in sight.
    """
    area = layout(size)
    middle = (area.screen if area.portrait else area.canvas).center
    x, y = middle.x - wanted.width / 2, middle.y - wanted.height / 2
    return Rect(x, y, wanted.width, wanted.height)


def columns(rect: Rect, count: int, gap: float = 0.0) -> list[Rect]:
    """A rectangle divided into equal columns."""
    width = (rect.width - (count - 1) * gap) / count
    return [Rect(rect.x + i * (width + gap), rect.y, width, rect.height) for i in range(count)]


def rows(rect: Rect, count: int, gap: float = 0.0) -> list[Rect]:
    """A rectangle divided into equal rows."""
    height = (rect.height - (count - 1) * gap) / count
    return [Rect(rect.x, rect.y + i * (height + gap), rect.width, height) for i in range(count)]


def pair(area: Layout) -> tuple[Rect, Rect]:
    """Places of two buttons in the controls: side by side, or one above the other."""
    divide = columns if area.portrait else rows
    first, second = divide(area.controls, 2, 12.0 if area.portrait else GAP)
    return first, second
