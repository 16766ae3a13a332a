"""Newton's first law."""

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from engine import Collision, Force, Polygon, Push, Vector
from screens.kit import arrows, hits, page, probes, theme
from screens.kit.bodies import enclose, leaving, new_world, opacity
from screens.kit.canvas import Canvas, bar_room
from screens.kit.dial import STRONGEST, ForceDial
from screens.kit.events import Event, Resize, Tap, Tick
from screens.kit.geometry import Point, Rect, Size
from screens.kit.layout import Layout, layout, pair, rows
from screens.kit.view import View, room_of
from screens.kit.widgets import NAVIGATION, navigation, seen, touched
from screens.kit.words import Words
from screens.lesson import Dice, Setting, Widget

if TYPE_CHECKING:
    from screens.kit.surface import Surface

RADIUS = 0.5
"""From the middle of the body to its corners (m)."""
LIGHT, HEAVY = 0.5, 10.0
"""Masses between which the body gets more solid to the eye (kg)."""
PER_NEWTON, PER_SPEED, PER_IMPULSE = 16.0, 36.0, 36.0
"""Lengths of arrows: dp per N, per m/s, per N s."""
LONGEST = 110.0
"""Arrows grow up to this length (dp)."""
BESIDE = 13.0
"""How far the arrow of a velocity moves aside for that of a force in the same direction (dp)."""
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
        self.room = room_of(size, layout(size).canvas)
        self.world = new_world()
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
        if not self.dialog:
            self._draw_scene(surface)
            return
        # Below an open dialog nothing moves.
        still = (self.world.digest(), self.force, bool(self.push), self.trail, len(self.hits))
        surface.static((*self._key, *still), self._draw_below)
        self.dialog.draw(surface, self.body)

    @property
    def _key(self) -> tuple[object, ...]:
        return (self.id, self.words.file, self.size, self.room)

    def _draw_below(self, surface: "Surface") -> None:
        self._draw_scene(surface)
        if self.dialog:
            self.dialog.draw_ground(surface, self.body)

    def _draw_scene(self, surface: "Surface") -> None:
        area = layout(self.size)
        surface.static((*self._key, bool(self.push)), self._draw_page)
        canvas = Canvas(surface, self.view.rect, self.room)
        canvas.labels.block(bar_room(canvas.rect))
        canvas.trail([at for at in self.trail if math.dist(at, self.body.position) > RADIUS])
        shade = opacity(self.body.mass, LIGHT, HEAVY)
        canvas.body(self.body, theme.TEAL, shade, over=(canvas.rect,))
        self._draw_vectors(canvas)
        for place, (_, shown, color) in zip(_readouts(area), self._numbers(), strict=True):
            page.value(surface, place, shown, color)

    def _draw_page(self, surface: "Surface") -> None:
        """Draw all that stays as it is from frame to frame."""
        area = layout(self.size)
        page.page(surface, area, self.words, self.id)
        Canvas(surface, self.view.rect, self.room).background()
        for place, (label, _, _) in zip(_readouts(area), self._numbers(), strict=True):
            page.heading(surface, place, label)
        buttons = {widget.id: widget for widget in self.widgets()}
        page.outlined_button(surface, buttons["force.change"])
        if self.push:
            page.outlined_button(surface, buttons["force.toggle"], theme.ORANGE, theme.ORANGE)
        else:
            page.filled_button(surface, buttons["force.toggle"])

    def _draw_vectors(self, canvas: Canvas) -> None:
        """Impulses of the walls, the velocity, the force while it acts; then their labels."""
        words, now = self.words, self.world.time
        vectors: list[tuple[str, Vector, float, arrows.Kind, float]] = []
        for hit in hits.strongest(self.hits, 2):
            given = hit.impulse if hit.b is self.body else Vector(-hit.impulse.x, -hit.impulse.y)
            shown = page.measured(hits.size(given), words("unit.impulse"), 2)
            label = words("inertia.wall", impulse=shown)
            faded = hits.fading(hit, now)
            vectors.append((label, given, PER_IMPULSE, arrows.FORCE, faded))
        if self.body.speed * PER_SPEED >= 1.0:
            shown = "v " + page.measured(self.body.speed, words("unit.speed"), 2)
            vectors.append((shown, self.body.velocity, PER_SPEED, arrows.VELOCITY, 1.0))
        if self.push and self.force != (0.0, 0.0):
            shown = "F " + page.measured(hits.size(self.force), words("unit.N"), 1)
            vectors.append((shown, self.force, PER_NEWTON, arrows.FORCE, 1.0))
        labels: list[tuple[str, Point, Point, theme.Color, float]] = []
        for shown, vector, per_unit, kind, faded in vectors:
            reach = hits.reach(vector, per_unit, LONGEST)
            aside = self._aside(vector) if kind is arrows.VELOCITY else 0.0
            start, part = leaving(canvas, self.body, reach, RADIUS, aside)
            tip = canvas.arrow(start, (reach[0] * part, reach[1] * part), kind, faded)
            labels.append((shown, tip, Point(reach[0], -reach[1]), kind.color, faded))
        for shown, tip, ahead, color, faded in labels:
            canvas.label(shown, tip, color, faded, ahead=ahead)

    def _numbers(self) -> list[tuple[str, str, theme.Color]]:
        """Heading, value and colour of the readouts."""
        words = self.words
        force = hits.size(self.force) if self.push else 0.0
        speed, momentum = self.body.speed, self.body.mass * self.body.speed
        return [
            (words("inertia.force"), page.measured(force, words("unit.N"), 1), theme.ORANGE),
            (words("inertia.speed"), page.measured(speed, words("unit.speed"), 2), theme.YELLOW),
            (
                words("inertia.momentum"),
                page.measured(momentum, words("unit.momentum"), 2),
                theme.TEXT,
            ),
            (words("inertia.time"), page.measured(self.world.time, words("unit.s"), 1), theme.TEXT),
        ]

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

    def _aside(self, velocity: Vector) -> float:
        """How far the velocity's arrow moves aside, for the force's to be seen (dp)."""
        if not self.push:
            return 0.0
        along = velocity.x * self.force.x + velocity.y * self.force.y
        sizes = hits.size(velocity) * hits.size(self.force)
        return BESIDE * max(along / sizes, 0.0) ** 2 if sizes else 0.0


def _readouts(area: Layout) -> list[Rect]:
    """Places of force, speed, momentum and time."""
    if area.portrait:
        return page.shares(area.readouts, (70.0, 94.0, 114.0, 50.0))
    upper, lower = rows(area.readouts, 2)
    force, speed = page.shares(upper, (72.0, 104.0))
    time, momentum = page.shares(lower, (72.0, 104.0))
    return [force, speed, momentum, time]
