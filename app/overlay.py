"""What wraps a lesson in a film and what no lesson knows of: captions, and the marks of fingers."""

from collections import deque
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from screens.kit import theme
from screens.kit.events import Drag, Event, Release, Tap
from screens.kit.geometry import Point, Rect
from screens.kit.layout import layout
from screens.kit.page import explanation_of
from screens.kit.words import Words
from screens.lesson import Lesson

if TYPE_CHECKING:
    from screens.kit.surface import Surface

FADE = 0.4
"""How long the mark of a finger stays (s of film)."""

RIPPLE = (8.0, 26.0)
"""Radius of a ripple when it begins and when it is gone (dp)."""

TRAIL = 24
"""Places of a drag that are remembered for its trail."""

FINGER = 9.0
"""Radius of the disc under a dragging finger (dp)."""

SIZES = ((14.0, 19.0), (12.0, 16.0), (10.0, 13.0), (8.5, 11.0), (7.0, 9.0))
"""Size and leading of captions (dp), the preferred ones first; the last two for long lists."""

PADDING = 8.0
"""Between a caption's words and its edge (dp)."""

EDGE = 4.0
"""By how much a caption's box is larger on each side than the words it covers (dp)."""

STYLES = tuple(theme.Style(size, theme.MEDIUM, leading) for size, leading in SIZES)
"""How captions are set, the preferred one first."""


@dataclass(frozen=True, slots=True)
class Ripple:
    """The mark of a tap."""

    at: Point
    begun: float
    """Film time (s)."""


@dataclass(frozen=True, slots=True)
class Footprint:
    """Where a dragging finger was."""

    at: Point
    seen: float
    """Film time (s)."""


class Overlay:
    """Captions, ripples and trails, in film time: slow motion does not slow a ripple down."""

    def __init__(self, words: Words) -> None:
        """Nothing to show yet; `words` are those of the lessons."""
        self._words = words
        self.caption = ""
        self.shows_captions = True
        self.shows_taps = True
        self._ripples: list[Ripple] = []
        self._trail: deque[Footprint] = deque(maxlen=TRAIL)
        self._finger: Point | None = None

    def mark(self, event: Event, seconds: float) -> None:
        """Remember where a finger is, at film time `seconds`."""
        match event:
            case Tap(at=at):
                self._ripples = [r for r in self._ripples if seconds - r.begun < FADE]
                self._ripples.append(Ripple(at, seconds))
            case Drag(start=start, at=at):
                if at == start:
                    self._trail.clear()
                self._finger = at
                self._trail.append(Footprint(at, seconds))
            case Release():
                self._finger = None
            case _:
                pass

    def is_moving(self, seconds: float) -> bool:
        """Whether what it draws at film time `seconds` differs from what it drew just before."""
        marks = [r.begun for r in self._ripples] + [f.seen for f in self._trail]
        return any(seconds - begun <= 2 * FADE for begun in marks)

    def draw(self, surface: "Surface", lesson: Lesson, seconds: float) -> None:
        """Draw over a lesson that is drawn already; changes nothing."""
        if self.shows_captions and self.caption.strip():
            draw_caption(surface, self.caption, self._words, lesson.id)
        if self.shows_taps:
            self._draw_trail(surface, seconds)
            for ripple in self._ripples:
                self._draw_ripple(surface, ripple, seconds)

    def _draw_ripple(self, surface: "Surface", ripple: Ripple, seconds: float) -> None:
        age = (seconds - ripple.begun) / FADE
        if not 0 <= age < 1:
            return
        small, large = RIPPLE
        grown = 1 - (1 - age) * (1 - age)
        radius = small + (large - small) * grown
        rest = 1 - age
        surface.circle(
            ripple.at,
            radius,
            theme.TEXT,
            alpha=0.22 * rest,
            outline=theme.TEXT,
            outline_width=2,
            outline_alpha=0.9 * rest,
        )

    def _draw_trail(self, surface: "Surface", seconds: float) -> None:
        for before, after in pairwise(self._trail):
            rest = 1 - (seconds - after.seen) / FADE
            if rest > 0:
                surface.line(before.at, after.at, 4 * rest, theme.TEXT, alpha=0.45 * rest)
        if self._finger is not None:
            surface.circle(
                self._finger,
                FINGER,
                theme.TEXT,
                alpha=0.25,
                outline=theme.TEXT,
                outline_width=2,
                outline_alpha=0.9,
            )


def draw_caption(surface: "Surface", caption: str, words: Words, lesson_id: str) -> None:
    """Draw a caption in place of the lesson's explanation, or of more of its words if it is long.

    It never covers the canvas.
    """
    area = layout(surface.size)
    room, lowest = area.words, area.words.bottom + (EDGE if area.portrait else 0.0)
    explanation = explanation_of(surface, room, words, lesson_id)
    said, style, top, needed = _setting(surface, caption, room, lowest, explanation.y)
    bottom = min(max(top + needed, explanation.bottom + EDGE), lowest)
    box = Rect(room.x - EDGE, top, room.width + 2 * EDGE, bottom - top)

    def paint() -> None:
        surface.rect(box, theme.DIALOG, radius=theme.RADIUS, outline=theme.TEAL, outline_width=1)
        at = Point(box.x + PADDING, box.y + max(PADDING, (box.height - needed) / 2 + PADDING))
        with surface.clip(box):
            surface.text(said, at, style, theme.TEXT, width=_width(room))

    surface.still((caption, lesson_id, words.file), box, paint)


def _setting(
    surface: "Surface", caption: str, room: Rect, lowest: float, below_law: float
) -> tuple[str, theme.Style, float, float]:
    """How a caption is set to end above `lowest`: its words, style, top and height (dp).

    Its lines are joined if they find no room even in small letters, rather than set in tiny ones.
    """
    below_title = room.y + theme.TITLE.line_height
    large, middle, *small = STYLES
    places = [(top, style) for top in (below_law, below_title) for style in (large, middle)]
    places += [(room.y, style) for style in (middle, *small)]
    settings = [(caption, *place) for place in places[:-1]]
    settings += [(" ".join(caption.split()), *place) for place in places]
    for said, top, style in settings:
        needed = surface.measure(said, style, width=_width(room)).height + 2 * PADDING
        if top + needed <= lowest:
            break
    return said, style, top, needed


def _width(room: Rect) -> float:
    """Of the words of a caption (dp)."""
    return room.width + 2 * EDGE - 2 * PADDING
