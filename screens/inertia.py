"""Newton's first law."""

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from engine import Collision, Force, Polygon, Push, Vector, World
from screens.kit import hits, probes
from screens.kit.bodies import enclose
from screens.kit.dial import STRONGEST, ForceDial
from screens.kit.events import Event, Resize, Tap, Tick
from screens.kit.geometry import Rect, Size
from screens.kit.layout import layout, pair
from screens.kit.view import Room, View
from screens.kit.widgets import NAVIGATION, navigation, seen, touched
from screens.kit.words import Words
from screens.lesson import Dice, Setting, Widget

if TYPE_CHECKING:
    from screens.kit.surface import Surface

UPRIGHT, ACROSS = Room(-3.0, -3.25, 3.0, 3.25), Room(-3.75, -3.0, 3.75, 3.0)
"""Rooms for upright and other screens (m); the origin is in the middle, where the body rests."""
RADIUS = 0.5
"""From the middle of the body to its corners (m)."""
TRAIL_STEP, TRAIL_LENGTH = 15, 16
"""A dot of the trail is left every so many ticks, and so many dots are kept."""


class Inertia:
    """The first law: a body keeps its velocity until a force changes it."""

    id = "inertia"
    SETTINGS: Mapping[str, Setting] = {
        "body.sides": Setting(5, 6, None, "", "corners of the body", whole=True),
        "body.mass": Setting(0.1, 100.0, 2.0, "kg", "its mass"),
        "body.restitution": Setting(0.0, 1.0, None, "", "speed kept when it bounces, 0 to 1"),
        "body.friction": Setting(0.0, 1.0, None, "", "friction between it and the walls"),
        "force.x": Setting(-STRONGEST, STRONGEST, 3.0, "N", "force to the right"),
        "force.y": Setting(-STRONGEST, STRONGEST, 0.0, "N", "force upwards"),
    }
    PROBES = (*probes.WORLD, *probes.names("body"), "force.applied", "force.x", "force.y")
    WIDGETS = (
        "body",
        "force.change",
        "force.toggle",
        "force.arrow",
        "dialog.accept",
        "dialog.cancel",
        *NAVIGATION,
    )

    def __init__(self, size: Size, dice: Dice, settings: Mapping[str, float], words: Words) -> None:
        """Three dice are rolled, whatever the settings: sides, restitution, friction."""
        self.size = size
        self.words = words
        self.room = UPRIGHT if size.height >= size.width else ACROSS
        self.world = World(integrator="velocity-verlet")
        rolled = {
            "body.sides": 5.0 if dice() < 0.5 else 6.0,
            "body.restitution": dice(),
            "body.friction": dice(),
        }
        known = {name: s.default for name, s in self.SETTINGS.items() if s.default is not None}
        chosen = {**known, **rolled, **settings}
        enclose(self.world, self.room, friction=chosen["body.friction"])
        self.body = self.world.add(
            Polygon.regular(int(chosen["body.sides"]), RADIUS),
            mass=chosen["body.mass"],
            angle=math.pi / 2,
            restitution=chosen["body.restitution"],
            friction=chosen["body.friction"],
            name="body",
        )
        self.force = Vector(chosen["force.x"], chosen["force.y"])
        self.push: Push | None = None
        self.dialog: ForceDial | None = None
        self.collisions: Sequence[Collision] = ()
        self.collision_count = 0
        self.hits: tuple[Collision, ...] = ()
        self.trail: tuple[Vector, ...] = ()

    def update(self, event: Event) -> None:
        """Take one event."""
        match event:
            case Resize(size=size):
                self.size = size
                if self.dialog:
                    self.dialog.update(event)
            case Tick(dt=dt):
                self.collisions = ()
                if not self.dialog:
                    self._advance(dt)
            case _ if self.dialog:
                self.dialog.update(event)
                if self.dialog.closed:
                    self._close(self.dialog)
            case Tap(at=at):
                self._tap(touched(self.widgets(), at))
            case _:
                pass

    def widgets(self) -> list[Widget]:
        """The navigation, the body, the two buttons, and the dialog over them if it is open."""
        area, words = layout(self.size), self.words
        change, toggle = pair(area)
        below = [
            *navigation(area, words),
            Widget("body", self._outline(), ""),
            Widget("force.change", change, words("inertia.change")),
            Widget("force.toggle", toggle, words(f"inertia.{'stop' if self.push else 'start'}")),
        ]
        return below + (self.dialog.widgets() if self.dialog else [])

    def probes(self) -> dict[str, float]:
        """Those of the world and the body; the chosen force (N) and whether it acts (1 or 0)."""
        return {
            **probes.of_world(self.world, self.collision_count),
            **probes.of_body("body", self.body),
            "force.applied": 1.0 if self.push else 0.0,
            "force.x": self.force.x,
            "force.y": self.force.y,
        }

    @property
    def view(self) -> View:
        """The room on the screen."""
        return View(layout(self.size).canvas, self.room)

    def draw(self, surface: "Surface") -> None:
        """Draw what is."""

    def _advance(self, dt: float) -> None:
        self.collisions = self.world.step(dt)
        self.collision_count += len(self.collisions)
        self.hits = hits.fresh((*self.hits, *self.collisions), self.world.time)
        if self.world.tick % TRAIL_STEP == 0 and self.body.speed > 0.0:
            self.trail = (*self.trail, self.body.position)[-TRAIL_LENGTH:]

    def _tap(self, id: str) -> None:
        if id in ("force.change", "body"):
            self.dialog = ForceDial(self.force, self.size, self.words)
        elif id == "force.toggle":
            self._stop() if self.push else self._start()

    def _close(self, dialog: ForceDial) -> None:
        self.dialog = None
        if dialog.accepted:
            self.force = dialog.force
            if self.push:
                self._stop()
                self._start()

    def _start(self) -> None:
        self.push = self.body.exert(Force(self.force.x, self.force.y))

    def _stop(self) -> None:
        if self.push:
            self.push.stop()
        self.push = None

    def _outline(self) -> Rect:
        """What of the body is in sight (dp)."""
        corners = [self.view.to_screen(corner) for corner in self.body.vertices]
        left, top = min(at.x for at in corners), min(at.y for at in corners)
        right, bottom = max(at.x for at in corners), max(at.y for at in corners)
        return seen(Rect(left, top, right - left, bottom - top), self.view.frame)
