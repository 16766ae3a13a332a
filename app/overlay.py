"""What wraps a lesson in a film and what no lesson knows of: captions, and the marks of fingers."""

from collections import deque
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from screens.kit import theme
from screens.kit.events import Drag, Event, Release, Tap
from screens.kit.geometry import Point, Rect, Size
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

PADDING = 10.0
"""Between a caption's words and its edge (dp)."""

CAPTION = theme.Style(14, theme.MEDIUM, 19)
"""How captions are set."""


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

    def __init__(self) -> None:
        """Nothing to show yet."""
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
            draw_caption(surface, self.caption, caption_room(surface.size))
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
                surface.capsule(before.at, after.at, 5 * rest, theme.TEXT, alpha=0.4 * rest)
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


def caption_room(size: Size) -> Rect:
    """Where a caption may be: over the words beside or above the canvas, never over the canvas."""
    if size.height >= size.width:
        return Rect(12, 12, size.width - 24, 128)
    return Rect(12, 56, 188, 132)


def draw_caption(surface: "Surface", words: str, room: Rect) -> None:
    """Draw the words in a box at the lower edge of `room`, wrapped to its width."""
    width = room.width - 2 * PADDING
    needed = surface.measure(words, CAPTION, width=width)
    height = min(needed.height + 2 * PADDING, room.height)
    box = Rect(room.x, room.bottom - height, room.width, height)
    surface.rect(box, theme.DIALOG, radius=8, outline=theme.TEAL, outline_width=1)
    at = Point(box.x + PADDING, box.y + PADDING)
    surface.text(words, at, CAPTION, theme.TEXT, width=width)
