"""The dialog in which a force is chosen by turning and lengthening an arrow."""

import math
from typing import TYPE_CHECKING

from engine import Body, Polygon, Vector
from screens.kit import page, theme
from screens.kit.events import Drag, Event, Key, Release, Resize, Tap
from screens.kit.geometry import Point, Rect, Size
from screens.kit.layout import GAP, TOUCH, dialog, rows
from screens.kit.numbers import quantity
from screens.kit.widgets import MODAL, touched
from screens.kit.words import Words
from screens.lesson import Widget

if TYPE_CHECKING:
    from screens.kit.surface import Surface

STRONGEST = 6.0
"""What the arrow can be drawn out to (N), unless it begins with more."""
HUB = 30.0
"""From the middle to the tail of the arrow: the body's outline (dp)."""
RIM = 120.0
"""From the middle to the tip of the strongest arrow (dp)."""
LOWERED = 26.0
"""How far below the middle of an upright screen the dialog lies (dp)."""
BESIDE = 290.0
"""Where the words begin that stand beside the dial (dp)."""
STEP = 0.1
"""Strengths are multiples of this (N), directions whole degrees: what is read is what acts."""
RING = theme.mix(theme.WHITE, 0.2, theme.DIALOG)
DIAGONAL = math.sqrt(0.5)
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
        self.strongest = max(STRONGEST, float(math.ceil(self.strength)))
        """What the arrow can be drawn out to (N)."""
        self._direction = force.angle
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

    def draw_ground(self, surface: "Surface", body: Body) -> None:
        """Draw what stays while the arrow is dragged, over the screen below; `body` is pushed."""
        words = self.words
        page.dialog(surface, self.panel, self.head, words("dial.title"))
        hint = self.hint
        surface.text(
            words("dial.hint"), (hint.x, hint.y), theme.BODY, theme.TEXT_MEDIUM, width=hint.width
        )
        self._draw_rings(surface)
        if isinstance(body.shape, Polygon):
            self._draw_body(surface, body.shape, body.angle)
        for rect, label, _, _ in self._numbers(body.mass):
            page.heading(surface, rect, label)
        _, cancel, accept, _ = self.widgets()
        page.plain_button(surface, cancel)
        page.filled_button(surface, accept)

    def draw(self, surface: "Surface", body: Body) -> None:
        """Draw the arrow and the numbers over the ground."""
        self._draw_arrow(surface)
        for rect, _, value, color in self._numbers(body.mass):
            page.value(surface, rect, value, color)

    @property
    def panel(self) -> Rect:
        """The dialog itself (dp)."""
        if not self._upright:
            return dialog(self.size, Size(426.0, 328.0))
        panel = dialog(self.size, Size(304.0, 448.0))
        # Lower than the middle: a caption ends above it.
        return panel._replace(y=panel.y + LOWERED)

    @property
    def center(self) -> Point:
        """The middle of the dial (dp)."""
        panel = self.panel
        if self._upright:
            return Point(panel.center.x, panel.y + 184)
        return Point(panel.x + RIM + HANDLE / 2 + 2, panel.center.y)

    @property
    def head(self) -> Rect:
        """Where the title is (dp)."""
        panel = self.panel
        if self._upright:
            return Rect(panel.x + 24, panel.y + 14, panel.width - 48, 24.0)
        return Rect(panel.x + BESIDE, panel.y + 18, panel.width - BESIDE - 10, 24.0)

    @property
    def hint(self) -> Rect:
        """Where it is said what to do: below the dial, or below the title (dp)."""
        panel, head = self.panel, self.head
        return Rect(head.x, panel.y + 326 if self._upright else head.bottom + 2, head.width, 16.0)

    @property
    def readouts(self) -> Rect:
        """Where strength, direction and acceleration are (dp)."""
        panel = self.panel
        if self._upright:
            return Rect(panel.x + 24, panel.y + 352, panel.width - 48, 40.0)
        return Rect(panel.x + BESIDE, panel.y + 92, panel.width - BESIDE - 10, 122.0)

    @property
    def buttons(self) -> tuple[Rect, Rect]:
        """Places of Cancel and Accept (dp)."""
        panel = self.panel
        if not self._upright:
            place = Rect(
                panel.x + BESIDE, panel.y + 232, panel.width - BESIDE - 16, 2 * TOUCH + GAP
            )
            accept, cancel = rows(place, 2, GAP)
            return cancel, accept
        y, right = panel.bottom - 8 - TOUCH, panel.right - 16
        accept = Rect(right - 92, y, 92.0, TOUCH)
        return Rect(accept.x - GAP - 84, y, 84.0, TOUCH), accept

    @property
    def tip(self) -> Point:
        """Where the arrow ends (dp); on the body's outline if there is no force."""
        return self._at(self._reach(self.strength))

    def _reach(self, newtons: float) -> float:
        """From the centre to the tip of an arrow of some strength (dp)."""
        return HUB + (RIM - HUB) * newtons / self.strongest

    def _at(self, reach: float) -> Point:
        """On the arrow's line, so far from the centre (dp)."""
        way = Vector.polar(reach, self._direction)
        return Point(self.center.x + way.x, self.center.y - way.y)

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
        part = min(max((reach - HUB) / (RIM - HUB), 0.0), 1.0)
        steps = round(part * self.strongest / STEP)
        degrees = round(math.degrees(Vector(x, y).angle)) % 360
        self._direction = math.radians(degrees)
        self.force = polar(steps / round(1 / STEP), degrees)

    def _draw_rings(self, surface: "Surface") -> None:
        """Circles at half and at full strength, with a mark every 30 degrees."""
        center = self.center
        for newtons in (self.strongest / 2, self.strongest):
            radius = self._reach(newtons)
            surface.circle(center, radius, None, outline=RING, outline_width=1)
            label = Point(center.x + radius * DIAGONAL + 4, center.y + radius * DIAGONAL + 6)
            words = quantity(newtons, self.words("unit.N"), 0 if newtons.is_integer() else 1)
            surface.text(words, label, theme.SMALL, theme.TEXT_MEDIUM, valign="middle")
        for turn in range(12):
            x, y = Vector.polar(1.0, math.pi * turn / 6)
            outer = Point(center.x + RIM * x, center.y + RIM * y)
            inner = Point(center.x + (RIM - 5) * x, center.y + (RIM - 5) * y)
            surface.line(inner, outer, 1.5, theme.TEXT_DISABLED)

    def _draw_body(self, surface: "Surface", shape: Polygon, angle: float) -> None:
        """The body as it is turned now, as large as the hub."""
        reach = max(math.dist(corner, (0.0, 0.0)) for corner in shape.vertices)
        along = Vector.polar((HUB - 2) / reach, angle)
        corners = [
            Point(
                self.center.x + along.x * x - along.y * y,
                self.center.y - along.y * x - along.x * y,
            )
            for x, y in shape.vertices
        ]
        surface.polygon(corners, theme.TEAL, 0.8, outline=theme.TEAL)

    def _draw_arrow(self, surface: "Surface") -> None:
        """From the hub to the tip, and the handle about the tip."""
        tip, tail = self.tip, self._at(HUB)
        surface.circle(
            tip, 16, theme.ORANGE, 0.12, outline=theme.ORANGE, outline_alpha=0.7, outline_width=2
        )
        surface.arrow(tail, tip, theme.ORANGE, width=5)

    def _numbers(self, mass: float) -> list[tuple[Rect, str, str, theme.Color]]:
        """Place, heading, value and colour of the readouts."""
        words = self.words
        parts = (92.0, 84.0, 80.0)
        places = page.shares(self.readouts, parts) if self._upright else rows(self.readouts, 3, GAP)
        values = (
            ("dial.strength", quantity(self.strength, words("unit.N"), 1), theme.ORANGE),
            ("dial.direction", quantity(self.degrees, words("unit.degree")), theme.TEXT),
            (
                "dial.acceleration",
                page.measured(self.strength / mass, words("unit.acceleration"), 2),
                theme.TEXT,
            ),
        )
        return [
            (place, words(name), value, color)
            for place, (name, value, color) in zip(places, values, strict=True)
        ]


def polar(length: float, degrees: int) -> Vector:
    """A vector by length and direction; along the axes exactly."""
    if degrees % 90 == 0:
        x, y = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[degrees // 90 % 4]
        return Vector(length * x + 0.0, length * y + 0.0)
    return Vector.polar(length, math.radians(degrees))
