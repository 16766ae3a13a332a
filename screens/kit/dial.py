"""The dialog in which a force is chosen by turning and lengthening an arrow."""

import math

from engine import Vector
from screens.kit.events import Drag, Event, Key, Release, Resize, Tap
from screens.kit.geometry import Point, Rect, Size
from screens.kit.layout import GAP, TOUCH
from screens.kit.widgets import MODAL, touched
from screens.kit.words import Words
from screens.lesson import Widget

STRONGEST = 6.0
"""What the arrow can be drawn out to (N)."""
HUB = 30.0
"""From the middle to the tail of the arrow: the body's outline (dp)."""
PER_NEWTON = 15.0
"""How much longer the arrow is for each newton (dp/N)."""
RIM = HUB + STRONGEST * PER_NEWTON
"""From the middle to the tip of the strongest arrow (dp)."""
STEP = 0.1
"""Strengths are multiples of this (N), directions whole degrees: what is read is what acts."""
HANDLE = TOUCH
"""Width and height of what is grabbed at the tip (dp)."""


class ForceDial:
    """A force, its arrow turned and lengthened by dragging the tip, then accepted or not."""

    def __init__(self, force: Vector, size: Size, words: Words) -> None:
        """Start from a force (N) on a screen of a size (dp)."""
        self.force = force
        self.words = words
        self.size = size
        self.closed = False
        self.accepted = False
        self._direction = math.atan2(force.y, force.x)
        self._held = ""

    @property
    def strength(self) -> float:
        """Of the force (N)."""
        return math.sqrt(self.force.x * self.force.x + self.force.y * self.force.y)

    @property
    def degrees(self) -> float:
        """Direction of the force, counter-clockwise from +x, from 0 up to 360."""
        return math.degrees(self._direction) % 360.0

    def update(self, event: Event) -> None:
        """Take what a hand does; time passes without a change."""
        match event:
            case Resize(size=size):
                self.size, self._held = size, ""
            case Tap(at=at):
                self._tap(touched(self.widgets(), at))
            case Drag(start=start, at=at):
                self._held = self._held or touched(self.widgets(), start) or MODAL
                if self._held == "force.arrow":
                    self._point_to(at)
            case Release():
                self._held = ""
            case Key(name="escape"):
                self.closed = True
            case _:
                pass

    def widgets(self) -> list[Widget]:
        """What lies over the screen, the buttons and the handle of the arrow."""
        words, (left, right) = self.words, self.buttons
        tip = self.tip
        handle = Rect(tip.x - HANDLE / 2, tip.y - HANDLE / 2, HANDLE, HANDLE)
        return [
            Widget(MODAL, Rect(0.0, 0.0, *self.size), ""),
            Widget("dialog.cancel", left, words("dialog.cancel")),
            Widget("dialog.accept", right, words("dialog.accept")),
            Widget("force.arrow", handle, ""),
        ]

    @property
    def panel(self) -> Rect:
        """The dialog itself (dp)."""
        wide, high = (304.0, 448.0) if self._upright else (520.0, 300.0)
        return Rect((self.size.width - wide) / 2, (self.size.height - high) / 2, wide, high)

    @property
    def center(self) -> Point:
        """The middle of the dial (dp)."""
        panel = self.panel
        if self._upright:
            return Point(panel.center.x, panel.y + 210)
        return Point(panel.x + RIM + HANDLE / 2 + GAP, panel.center.y)

    @property
    def head(self) -> Rect:
        """Where the title and the hint are (dp)."""
        panel = self.panel
        if self._upright:
            return Rect(panel.x + 24, panel.y + 16, panel.width - 48, 46.0)
        return Rect(panel.x + 306, panel.y + 24, panel.width - 322, 60.0)

    @property
    def readouts(self) -> Rect:
        """Where strength, direction and acceleration are (dp)."""
        panel = self.panel
        if self._upright:
            return Rect(panel.x + 24, panel.y + 352, panel.width - 48, 40.0)
        return Rect(panel.x + 306, panel.y + 96, panel.width - 322, 132.0)

    @property
    def buttons(self) -> tuple[Rect, Rect]:
        """Places of Cancel and Accept (dp)."""
        panel = self.panel
        y, right = panel.bottom - 12 - TOUCH, panel.right - 16
        accept = Rect(right - 92, y, 92.0, TOUCH)
        return Rect(accept.x - GAP - 84, y, 84.0, TOUCH), accept

    @property
    def tip(self) -> Point:
        """Where the arrow ends (dp); on the body's outline if there is no force."""
        reach = min(HUB + self.strength * PER_NEWTON, RIM)
        center = self.center
        return Point(
            center.x + reach * math.cos(self._direction),
            center.y - reach * math.sin(self._direction),
        )

    @property
    def _upright(self) -> bool:
        return self.size.height >= self.size.width

    def _tap(self, id: str) -> None:
        self.accepted = id == "dialog.accept"
        self.closed = id in ("dialog.accept", "dialog.cancel")

    def _point_to(self, at: Point) -> None:
        """Let the arrow end at a point, or as near to it as it can."""
        x, y = at.x - self.center.x, self.center.y - at.y
        reach = math.sqrt(x * x + y * y)
        steps = round(min(max((reach - HUB) / PER_NEWTON, 0.0), STRONGEST) / STEP)
        degrees = round(math.degrees(math.atan2(y, x))) % 360 if reach > 0.0 else 0
        self._direction = math.radians(degrees)
        self.force = polar(steps / round(1 / STEP), degrees)


def polar(length: float, degrees: int) -> Vector:
    """A vector by length and direction; along the axes exactly."""
    if degrees % 90 == 0:
        x, y = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[degrees // 90 % 4]
        return Vector(length * x + 0.0, length * y + 0.0)
    turn = math.radians(degrees)
    return Vector(length * math.cos(turn), length * math.sin(turn))
