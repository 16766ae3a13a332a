"""Newton's third law."""

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from engine import Body, Collision, Force, Particle, Push, Vector, Wall, World
from screens.kit import arrows, gauge, hits, page, probes, theme
from screens.kit.bodies import conceal, distance, enclose, fitting, opacity
from screens.kit.canvas import Canvas
from screens.kit.events import Event, Resize, Tap, Tick, Tilt
from screens.kit.geometry import Point, Rect, Size
from screens.kit.layout import GAP, TOUCH, Layout, columns, layout, rows
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
PER_IMPULSE, LONGEST = 32.0, 72.0
"""Length of the arrow of an impulse (dp per N s), and how long it can get (dp)."""
ARROWS, LABELS = 5, 3
"""How many hits at once show their impulses, and how many say how great they are: the strongest."""
FAINTEST = 0.02
"""The least impulse that gets a label (N s)."""
NEAR = 0.95
"""An arrow nearer to the middle of a ball than this many radii is hidden by it."""
BESIDE = 7.0
"""How far beside the ball the arrow of the push on a wall is drawn (dp)."""
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
        self.world = World(integrator="velocity-verlet")
        known = {name: s.default for name, s in self.SETTINGS.items() if s.default is not None}
        self.chosen = {**known, **settings}
        enclose(self.world, self.room)
        for number, ends in enumerate(INNER, start=1):
            start, end = (self._in_room(end) for end in ends)
            self.world.add(Wall(start, end), name=f"wall.{number}")
        self.ball_mass = self.chosen["particle.mass"]
        """Of the next ball (kg)."""
        self.balls: list[Body] = []
        self.pushes: list[Push] = []
        self.tilt = Tilt(0.0, 0.0)
        self.collisions: Sequence[Collision] = ()
        self.collision_count = 0
        self.hits: tuple[Collision, ...] = ()
        self.last_hit: Collision | None = None
        self.refusal: tuple[str, Point, float] | None = None
        """Name of the sentence that explains why a tap gave no ball, the place, the time (s)."""

    def update(self, event: Event) -> None:
        """Take one event."""
        match event:
            case Resize(size=size):
                self.size = size
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
            full * math.sin(math.radians(self.tilt.roll)) + 0.0,
            -full * math.sin(math.radians(self.tilt.pitch)) + 0.0,
        )

    def radius(self, mass: float) -> float:
        """Of a ball of some mass (m): all are of the same stuff, so it grows with the cube root."""
        part = math.cbrt(mass / self.chosen["particle.mass"])
        return self.chosen["particle.radius"] * part

    def draw(self, surface: "Surface") -> None:
        """Draw what is."""
        key = (self.id, self.words.file, self.size, self.room, self.ball_mass)
        surface.static(key, self._draw_page)
        canvas = Canvas(surface, self.view.rect, self.room)
        canvas.labels.block(canvas.bar_room())
        for ends in INNER:
            a, b = (canvas.view.to_screen(self._in_room(end)) for end in ends)
            canvas.labels.block_line(a, b, theme.WALL_WIDTH)
        shown = hits.strongest(self.hits, ARROWS)
        drawn = [shaft for hit in shown for shaft in self._draw_impulses(canvas, hit)]
        for number, ball in enumerate(self.balls):
            self._draw_ball(canvas, ball, LETTERS[number], drawn)
        for hit in hits.strongest(shown, LABELS):
            self._draw_label(canvas, hit)
        self._draw_refusal(canvas)
        place = _readouts(layout(self.size))[0]
        gauge.draw(surface, place, self.tilt, self.force, self.words)
        self._draw_numbers(surface)

    def _draw_page(self, surface: "Surface") -> None:
        """Draw all that stays as it is from frame to frame."""
        area, words = layout(self.size), self.words
        page.page(surface, area, words, self.id)
        canvas = Canvas(surface, self.view.rect, self.room)
        canvas.background()
        for body in self.world:
            if isinstance(body.shape, Wall) and body.name[5:].isdigit():
                canvas.wall(body.shape)
        _, count, last = _readouts(area)
        page.heading(surface, count, words("reactions.collisions"))
        page.heading(surface, last, words("reactions.last"))
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

    def _draw_ball(
        self, canvas: Canvas, ball: Body, letter: str, drawn: Sequence[tuple[Vector, Vector]]
    ) -> None:
        """A ball, over the arrows `drawn` already (their ends, m): none may cross its letter."""
        radius = self.radius(ball.mass)
        center, bar = canvas.view.to_screen(ball.position), canvas.bar_room()
        is_on_bar = bar.inset(-radius * canvas.view.scale).holds(center)
        if is_on_bar or any(distance(ball.position, *way) < NEAR * radius for way in drawn):
            conceal(canvas, ball)
        color = theme.BODY_COLORS[LETTERS.index(letter) % len(theme.BODY_COLORS)]
        first = self.chosen["particle.mass"]
        shade = opacity(ball.mass, LIGHTEST * first, HEAVIEST * first)
        canvas.body(ball, color, shade, letter)

    def _draw_impulses(self, canvas: Canvas, hit: Collision) -> list[tuple[Vector, Vector]]:
        """What b received, with a solid head, and what a received, with a hollow one.

        Returns where the arrows start and end (m).
        """
        faded = hits.fading(hit, self.world.time)
        reach = hits.reach(hit.impulse, PER_IMPULSE, LONGEST)
        ends = [
            (body, other, (sign * reach[0], sign * reach[1]), kind)
            for body, other, sign, kind in (
                (hit.b, hit.a, 1.0, arrows.FORCE),
                (hit.a, hit.b, -1.0, arrows.REACTION),
            )
        ]
        # Both are shortened alike, so that they are seen to be equal.
        part = min(
            fitting(canvas, canvas.edge(body, way), way) if not body.is_wall else 1.0
            for body, _, way, _ in ends
        )
        shafts = []
        for body, other, whole, kind in ends:
            way = (whole[0] * part, whole[1] * part)
            start = (
                self._beside(canvas, hit, other, way) if body.is_wall else canvas.edge(body, way)
            )
            tip = canvas.view.to_world(canvas.arrow(start, way, kind, faded))
            shafts.append((Vector(*start), tip))
        return shafts

    def _beside(
        self, canvas: Canvas, hit: Collision, ball: Body, reach: tuple[float, float]
    ) -> Vector:
        """Where the push on a wall starts (m): it ends on the wall, beside the ball that gives it.

        Of both sides of the ball the one that is nearer to the middle of the room.
        """
        scale = canvas.view.scale
        away = self.radius(ball.mass) + BESIDE / scale
        x, y = -hit.normal.y * away, hit.normal.x * away
        if x * hit.point.x + y * hit.point.y > 0.0:
            x, y = -x, -y
        return Vector(hit.point.x + x - reach[0] / scale, hit.point.y + y - reach[1] / scale)

    def _draw_label(self, canvas: Canvas, hit: Collision) -> None:
        size = hits.size(hit.impulse)
        if size < FAINTEST:
            return
        first, second = (hit.b, hit.a) if hit.a.is_wall else (hit.a, hit.b)
        words = self.words(
            "reactions.each",
            a=self._letter(first),
            b=self._letter(second),
            impulse=page.measured(size, self.words("unit.impulse"), 2),
        )
        anchor = canvas.view.to_screen(hit.point)
        canvas.label(words, anchor, theme.ORANGE, hits.fading(hit, self.world.time), gap=10)

    def _draw_refusal(self, canvas: Canvas) -> None:
        """A cross where a ball found no room, and the reason."""
        if self.refusal is None:
            return
        name, at, since = self.refusal
        faded = 1.0 - (self.world.time - since) / NOTICE
        for slope in (1, -1):
            a = Point(at.x - CROSS, at.y - slope * CROSS)
            b = Point(at.x + CROSS, at.y + slope * CROSS)
            canvas.surface.capsule(a, b, 2.5, theme.TEXT, faded)
        words = self.words(f"reactions.{name}", count=str(len(LETTERS)))
        canvas.label(words, at, theme.TEXT, faded, gap=12)

    def _draw_numbers(self, surface: "Surface") -> None:
        """How many collisions there were, and the impulse of the last one."""
        words = self.words
        _, count, last = _readouts(layout(self.size))
        page.value(surface, count, str(self.collision_count))
        if self.last_hit:
            size = hits.size(self.last_hit.impulse)
            shown = page.measured(size, words("unit.impulse"), 2)
            page.value(surface, last, shown, theme.ORANGE)

    def _letter(self, body: Body) -> str:
        """What a pupil calls a body."""
        return self.words("reactions.wall") if body.is_wall else LETTERS[self.balls.index(body)]

    def _advance(self, dt: float) -> None:
        self.collisions = self.world.step(dt)
        self.collision_count += len(self.collisions)
        self.hits = hits.fresh((*self.hits, *self.collisions), self.world.time)
        if self.hits:
            self.last_hit = self.hits[-1]
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
        """Exert the force of the tilt on every ball, instead of the one before."""
        for push in self.pushes:
            push.stop()
        force = self.force
        tilted = force != (0.0, 0.0)
        self.pushes = [b.exert(Force(force.x, force.y)) for b in self.balls] if tilted else []

    def _clear(self) -> None:
        """Take all balls away; the count begins anew, the tilt and the next mass stay."""
        for ball in self.balls:
            self.world.remove(ball)
        self.balls, self.pushes = [], []
        self.hits, self.last_hit, self.refusal = (), None, None
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
        return page.shares(area.readouts, (176.0, 70.0, 82.0))
    x, y, width, _ = area.readouts
    below = Rect(x, area.readouts.bottom - 30, width, 30.0)
    return [Rect(x, y, width, gauge.HEIGHT), *columns(below, 2)]
