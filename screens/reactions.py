"""Newton's third law."""

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from engine import Body, Collision, Force, Particle, Push, Vector, Wall
from screens.kit import gauge, hits, impulses, page, probes, theme
from screens.kit.bodies import distance, enclose, new_world, opacity
from screens.kit.canvas import Canvas, bar_room
from screens.kit.events import Event, Resize, Tap, Tick, Tilt
from screens.kit.geometry import Point, Rect, Size
from screens.kit.impulses import Mark
from screens.kit.layout import GAP, TOUCH, Layout, layout, rows
from screens.kit.numbers import UNKNOWN
from screens.kit.view import View, room_of
from screens.kit.widgets import NAVIGATION, navigation, touched
from screens.kit.words import Words
from screens.lesson import Dice, Setting, Widget

if TYPE_CHECKING:
    from screens.kit.surface import Surface

INNER = (
    ((-0.80, 0.42), (-0.35, 0.58)),
    ((0.35, 0.66), (0.80, 0.40)),
    ((-0.70, -0.44), (-0.30, -0.62)),
    ((0.45, -0.36), (0.45, -0.74)),
)
"""Inner walls, in halves of the room's width and height. They leave a straight way from wall to
wall along both axes: |y| < 0.36 and -0.3 < x < 0.35."""
LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
"""Names of the balls as a pupil sees them; there are no more balls than letters."""
LIGHTEST, HEAVIEST = 0.125, 16.0
"""Range of the masses that can be tapped, in masses of the first ball."""
CROSS = 6.0
"""Half the size of the cross where a ball found no room (dp)."""
NOTICE = 1.5
"""How long a refused tap is explained (s of the world)."""


class Reactions:
    """The third law: when A pushes B, B pushes A just as hard, the opposite way."""

    id = "reactions"
    SETTINGS: Mapping[str, Setting] = {
        "tilt.force": Setting(0.0, 50.0, 2.0, "N", "force on every ball at a tilt of 90°"),
        "particle.radius": Setting(0.1, 0.5, 0.25, "m", "radius of a ball of particle.mass"),
        "particle.mass": Setting(0.05, 50.0, 1.0, "kg", "mass of the first ball"),
        "particle.restitution": Setting(0.0, 1.0, None, "", "speed kept in a hit, 0 to 1"),
    }
    PROBES = (
        *probes.WORLD,
        "particles.count",
        *probes.names("particle.N"),
        "tilt.x",
        "tilt.y",
        "force.x",
        "force.y",
        "ball.mass",
    )
    WIDGETS = ("canvas", "ball.lighter", "ball.heavier", "clear", *NAVIGATION)

    def __init__(self, size: Size, dice: Dice, settings: Mapping[str, float], words: Words) -> None:
        """The dice are rolled once for every ball, whatever the settings."""
        self.size = size
        self.words = words
        self.dice = dice
        self.room = room_of(size, layout(size).canvas)
        self.world = new_world()
        known = {name: s.default for name, s in self.SETTINGS.items() if s.default is not None}
        self.chosen = {**known, **settings}
        enclose(self.world, self.room)
        self.inner: list[Wall] = []
        for number, ends in enumerate(INNER, start=1):
            start, end = (self._in_room(end) for end in ends)
            self.world.add(Wall(start, end), name=f"wall.{number}")
            self.inner.append(Wall(start, end))
        self.ball_mass = self.chosen["particle.mass"]
        """Of the next ball (kg)."""
        self.balls: list[Body] = []
        self.pushes: list[Push] = []
        self.tilt = Tilt(0.0, 0.0)
        self.collisions: Sequence[Collision] = ()
        self.collision_count = 0
        self.marks: tuple[Mark, ...] = ()
        self.last_hit: Collision | None = None
        self.refusal: tuple[str, Point, float] | None = None
        """Name of the sentence that explains why a tap gave no ball, the place, the time (s)."""

    def update(self, event: Event) -> None:
        """Take one event."""
        match event:
            case Resize(size=size):
                self.size = size
                self.marks = tuple(Mark(mark.hit) for mark in self.marks)
            case Tick(dt=dt):
                self._advance(dt)
            case Tilt():
                self.tilt = event
                self._push_all()
            case Tap(at=at):
                self._tap(touched(self.widgets(), at), at)
            case _:
                pass

    def widgets(self) -> list[Widget]:
        """The navigation, the canvas, the mass of the next ball, and the button that clears."""
        area, words = layout(self.size), self.words
        lighter, heavier, _, clear = controls(area)
        least, most = (self.chosen["particle.mass"] * k for k in (LIGHTEST, HEAVIEST))
        return [
            *navigation(area, words),
            Widget("canvas", self.view.frame, ""),
            Widget("ball.lighter", lighter, words("reactions.lighter"), self.ball_mass > least),
            Widget("ball.heavier", heavier, words("reactions.heavier"), self.ball_mass < most),
            Widget("clear", clear, words("reactions.clear")),
        ]

    def probes(self) -> dict[str, float]:
        """Those of the world and every ball.

        Also `tilt.x`, `tilt.y`: roll and pitch in degrees; `force.x`, `force.y`: what the tilt
        exerts on every ball (N); `ball.mass`: of the next ball (kg).
        """
        read = probes.of_world(self.world, self.collision_count)
        read["particles.count"] = float(len(self.balls))
        for number, ball in enumerate(self.balls, start=1):
            read |= probes.of_body(f"particle.{number}", ball)
        force = self.force
        read |= {"tilt.x": self.tilt.roll, "tilt.y": self.tilt.pitch}
        return read | {"force.x": force.x, "force.y": force.y, "ball.mass": self.ball_mass}

    @property
    def view(self) -> View:
        """The room on the screen."""
        return View(layout(self.size).canvas, self.room)

    @property
    def force(self) -> Vector:
        """What the tilt exerts on every ball, heavy or light (N): roll to +x, pitch to -y."""
        full = self.chosen["tilt.force"]
        return Vector(
            Vector.polar(full, math.radians(self.tilt.roll)).y + 0.0,
            -Vector.polar(full, math.radians(self.tilt.pitch)).y + 0.0,
        )

    def radius(self, mass: float) -> float:
        """Of a ball of some mass (m): all are of the same stuff, so it grows with the cube root.

        Rounded: the last bit of a root is not the same on all machines.
        """
        part = round(math.cbrt(mass / self.chosen["particle.mass"]), 12)
        return self.chosen["particle.radius"] * part

    def draw(self, surface: "Surface") -> None:
        """Draw what is."""
        key = (self.id, self.words.file, self.size, self.room, self.ball_mass)
        surface.static(key, self._draw_page)
        canvas = Canvas(surface, self.view.rect, self.room)
        self._draw_balls(canvas)
        if self.refusal:
            self._draw_refusal(canvas, *self.refusal)
        place = _readouts(layout(self.size))[0]
        gauge.draw(surface, place, self.tilt, self.force, self.words)
        self._draw_numbers(surface)

    def _draw_page(self, surface: "Surface") -> None:
        """Draw all that stays as it is from frame to frame."""
        area, words = layout(self.size), self.words
        page.page(surface, area, words, self.id)
        canvas = Canvas(surface, self.view.rect, self.room)
        canvas.background()
        for wall in self.inner:
            canvas.wall(wall)
        tilted, count, _ = _readouts(area)
        gauge.draw_ground(surface, tilted)
        page.heading(surface, count, words("reactions.collisions"))
        buttons = {widget.id: widget for widget in self.widgets()}
        for id in ("ball.lighter", "ball.heavier", "clear"):
            page.outlined_button(surface, buttons[id])
        _, _, between, _ = controls(area)
        middle = between.center
        surface.text(
            words("reactions.next"),
            Point(middle.x, middle.y - 9),
            theme.SMALL,
            theme.TEXT_MEDIUM,
            align="center",
            valign="middle",
        )
        surface.text(
            page.chosen(self.ball_mass, words("unit.kg")),
            Point(middle.x, middle.y + 8),
            theme.VALUE,
            theme.TEXT,
            align="center",
            valign="middle",
        )

    def _draw_balls(self, canvas: Canvas) -> None:
        """The balls; over them the impulses of their hits, but for the letters.

        What is said of hits, and the scale bar, lie below and do not show through.
        """
        under = impulses.draw_words(canvas, self.marks, self.world.time)
        under.append(bar_room(canvas.rect))
        first = self.chosen["particle.mass"]
        looks = [
            (
                theme.BODY_COLORS[number % len(theme.BODY_COLORS)],
                opacity(ball.mass, LIGHTEST * first, HEAVIEST * first),
            )
            for number, ball in enumerate(self.balls)
        ]
        for ball, look in zip(self.balls, looks, strict=True):
            canvas.body(ball, *look, over=under)
        impulses.draw_arrows(canvas, self.marks, self.world.time)
        for ball, letter, look in zip(self.balls, LETTERS, looks, strict=False):
            canvas.letter(letter, canvas.view.to_screen(ball.position), *look)

    def _draw_refusal(self, canvas: Canvas, name: str, at: Point, since: float) -> None:
        """A cross where a ball found no room, and the reason."""
        faded = 1.0 - (self.world.time - since) / NOTICE
        for slope in (1, -1):
            a = Point(at.x - CROSS, at.y - slope * CROSS)
            b = Point(at.x + CROSS, at.y + slope * CROSS)
            canvas.surface.capsule(a, b, 2.5, theme.TEXT, faded)
        for wall in self.inner:
            canvas.block_wall(wall)
        words = self.words(f"reactions.{name}", count=str(len(LETTERS)))
        canvas.label(words, at, theme.TEXT, faded, gap=12)

    def _draw_numbers(self, surface: "Surface") -> None:
        """How many collisions there were; of the last one, whose it was, and its impulse."""
        words = self.words
        _, count, last = _readouts(layout(self.size))
        page.value(surface, count, str(self.collision_count))
        if self.last_hit:
            page.heading(surface, last, words("reactions.last_of", **self._pair(self.last_hit)))
            page.value(surface, last, self._impulse(self.last_hit), theme.ORANGE)
        else:
            page.heading(surface, last, words("reactions.last"))
            page.value(surface, last, UNKNOWN, theme.TEXT_MEDIUM)

    def _impulse(self, hit: Collision) -> str:
        return page.measured(hits.size(hit.impulse), self.words("unit.impulse"), 2)

    def _pair(self, hit: Collision) -> dict[str, str]:
        """What a pupil calls the bodies of a hit; a wall comes second."""
        first, second = (hit.b, hit.a) if hit.a.is_wall else (hit.a, hit.b)
        return {"a": self._letter(first), "b": self._letter(second)}

    def _letter(self, body: Body) -> str:
        return self.words("reactions.wall") if body.is_wall else LETTERS[self.balls.index(body)]

    def _said(self, hit: Collision) -> str:
        """What is written beside a hit."""
        return self.words("reactions.each", impulse=self._impulse(hit), **self._pair(hit))

    def _place(self, hit: Collision, words: str, marks: Sequence[Mark]) -> Rect | None:
        """Where that is written (dp)."""
        return impulses.find_place(self.view, self.inner, self.balls, marks, hit, words)

    def _advance(self, dt: float) -> None:
        self.collisions = self.world.step(dt)
        self.collision_count += len(self.collisions)
        now = self.world.time
        self.marks = impulses.remember(self.marks, self.collisions, now, self._said, self._place)
        told = [mark for mark in self.marks if mark.place] or self.marks
        if told:  # what bounces on faintly does not contradict what is written beside its hit
            self.last_hit = told[-1].hit
        if self.refusal and self.world.time - self.refusal[2] > NOTICE:
            self.refusal = None

    def _tap(self, id: str, at: Point) -> None:
        match id:
            case "canvas":
                self._spawn(at)
            case "ball.lighter":
                self.ball_mass /= 2
            case "ball.heavier":
                self.ball_mass *= 2
            case "clear":
                self._clear()

    def _spawn(self, at: Point) -> None:
        """Add a ball at rest; beside the border it is moved inwards, elsewhere it needs room."""
        radius = self.radius(self.ball_mass)
        x, y = self.view.to_world(at)
        room = self.room
        place = Vector(
            min(max(x, room.left + radius), room.right - radius),
            min(max(y, room.bottom + radius), room.top - radius),
        )
        full = len(self.balls) == len(LETTERS)
        if full or not self._is_free(place, radius):
            self.refusal = ("full" if full else "occupied", at, self.world.time)
            return
        rolled = self.dice()
        ball = self.world.add(
            Particle(radius),
            mass=self.ball_mass,
            position=place,
            restitution=self.chosen.get("particle.restitution", rolled),
            name=f"particle.{len(self.balls) + 1}",
        )
        self.balls.append(ball)
        self.refusal = None
        self._push_all()

    def _is_free(self, place: Vector, radius: float) -> bool:
        """Whether a ball touches neither an inner wall nor another ball."""
        gaps = [math.dist(place, b.position) - self.radius(b.mass) for b in self.balls]
        for start, end in INNER:
            gaps.append(distance(place, self._in_room(start), self._in_room(end)))
        return min(gaps) > radius

    def _in_room(self, part: tuple[float, float]) -> Vector:
        return Vector(part[0] * self.room.right, part[1] * self.room.top)

    def _push_all(self) -> None:
        """Exert the force of the tilt on every ball, and on no ball if the device lies flat."""
        force = Force(*self.force)
        if force == Force(0.0, 0.0):
            for push in reversed(self.pushes):
                push.stop()
            self.pushes = []
            return
        for push in self.pushes:
            push.change(force)
        self.pushes += [ball.exert(force) for ball in self.balls[len(self.pushes) :]]

    def _clear(self) -> None:
        """Take all balls away; the count begins anew, the tilt and the next mass stay."""
        for ball in self.balls:
            self.world.remove(ball)
        self.balls, self.pushes = [], []
        self.marks, self.last_hit, self.refusal = (), None, None
        self.collision_count = 0


def controls(area: Layout) -> tuple[Rect, Rect, Rect, Rect]:
    """Places of lighter, heavier, the mass between them, and clear (dp)."""
    if area.portrait:
        row = area.controls
        stepper = Rect(row.x, row.y, row.width - 108, TOUCH)
        clear = Rect(row.right - 96, row.y, 96.0, TOUCH)
    else:
        stepper, clear = rows(area.controls, 2, GAP)
    lighter = Rect(stepper.x, stepper.y, TOUCH, TOUCH)
    heavier = Rect(stepper.right - TOUCH, stepper.y, TOUCH, TOUCH)
    between = Rect(lighter.right, stepper.y, heavier.x - lighter.right, TOUCH)
    return lighter, heavier, between, clear


def _readouts(area: Layout) -> list[Rect]:
    """Places of the gauge, of the number of collisions and of the last impulse."""
    if area.portrait:
        return page.shares(area.readouts, (160.0, 56.0, 112.0))
    x, y, width, _ = area.readouts
    below = Rect(x, area.readouts.bottom - 30, width, 30.0)
    return [Rect(x, y, width, gauge.HEIGHT), *page.shares(below, (60.0, 116.0))]
