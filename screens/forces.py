"""Newton's second law."""

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from engine import Body, Collision, Force, Polygon, Push, Vector, World
from screens.kit import arrows, page, probes, theme
from screens.kit.bodies import new_world, opacity
from screens.kit.canvas import Canvas
from screens.kit.cart_dialog import ACCELERATION, MASS, CartDialog
from screens.kit.events import Event, Resize, Tap, Tick
from screens.kit.geometry import Point, Rect, Size
from screens.kit.layout import GAP, Layout, columns, layout, pair, rows
from screens.kit.view import Room, View
from screens.kit.widgets import NAVIGATION, navigation, touched
from screens.kit.words import Words
from screens.lesson import Dice, Setting, Widget

if TYPE_CHECKING:
    from screens.kit.surface import Surface

CART = 0.9
"""Side of a cart (m)."""
TRACK = 4.0
"""From where a cart starts, x = 0, to where its push ends (m, of its middle)."""
LANES = {"a": 1.5, "b": -1.5}
"""Height of the lanes (y, m). The carts move along x and never meet."""
LEFT, RIGHT = -0.6, 6.4
"""What of a lane is in sight (x, m); more in a picture so wide that a cart would be too high."""
HEAD = 28.0
"""Height of the words in a lane (dp)."""
MARK = TRACK + CART / 2
"""Where the end mark is drawn: the front of a cart passes it when its middle is at TRACK (x, m)."""
PER_NEWTON, PER_SPEED = 0.3, 0.25
"""Lengths of arrows: m per N (less for both carts if one is too long), m per m/s."""
LONGEST = 1.8
"""Greatest length of an arrow (m): it fits beside a cart that is at the mark."""
ASIDE = 0.27
"""How far above and below the middle of a cart its arrows are drawn (m): clear of its words."""
CLEAR = 0.05
"""Between the tip of a velocity and the end of its lane (m)."""
INSET = 12.0
"""Between the words in a lane and its sides (dp)."""
STRONG = theme.Style(12, theme.SEMIBOLD, 16)
"""How the force of a lane is set."""
FITS = len("10.0 kg")
"""Longest words on a cart; a longer mass is shown without its unit."""
WAITING = 0.45
"""Opacity of the arrow of a force that does not act yet."""


class Cart:
    """One of the two bodies, with what was chosen for it."""

    def __init__(self, lane: str, mass: float, acceleration: float, world: World) -> None:
        """At the start of its lane, `a` or `b`; kg, m/s^2."""
        self.lane = lane
        self.acceleration = acceleration
        self.finish_time: float | None = None
        """When its middle passed the end mark, after the start of the run (s)."""
        self.push: Push | None = None
        self.body: Body = world.add(
            Polygon.box(CART, CART), mass=mass, position=(0.0, LANES[lane]), name=f"cart.{lane}"
        )

    @property
    def force(self) -> float:
        """Needed for the acceleration, F = m a (N)."""
        return self.body.mass * self.acceleration

    def start(self) -> None:
        """Push until the end mark, which takes sqrt(2 s / a): the force ends there exactly."""
        if self.acceleration > 0.0:
            lasts = math.sqrt(2.0 * TRACK / self.acceleration)
            self.push = self.body.exert(Force(self.force, 0.0), duration=lasts)

    def stop(self) -> None:
        """End the push and forget the time."""
        if self.push:
            self.push.stop()
        self.push = self.finish_time = None

    def time_to_mark(self, x: float, v: float, force: float) -> float:
        """From x (m), v (m/s) under a force (N) to the end mark (s).

        The root of v t + a t^2 / 2 = s, in the form that does not cancel.
        """
        s, a = TRACK - x, force / self.body.mass
        return 2.0 * s / (v + math.sqrt(v * v + 2.0 * a * s))


class Forces:
    """The second law: acceleration is the net force divided by the mass."""

    id = "forces"
    SETTINGS: Mapping[str, Setting] = {
        "cart.a.mass": Setting(*MASS, 1.0, "kg", "mass of the upper cart"),
        "cart.a.acceleration": Setting(*ACCELERATION, 2.0, "m/s²", "its acceleration"),
        "cart.b.mass": Setting(*MASS, 2.0, "kg", "mass of the lower cart"),
        "cart.b.acceleration": Setting(*ACCELERATION, 2.0, "m/s²", "its acceleration"),
    }
    PROBES = (
        *probes.WORLD,
        *(
            name
            for cart in ("cart.a", "cart.b")
            for name in (
                *probes.names(cart), f"{cart}.acceleration", f"{cart}.force", f"{cart}.finish_time"
            )
        ),
    )  # fmt: skip
    WIDGETS = (
        "cart.a",
        "cart.b",
        "forces.reset",
        "forces.apply",
        "mass",
        "mass.field",
        "acceleration",
        "acceleration.field",
        "dialog.accept",
        "dialog.cancel",
        *NAVIGATION,
    )

    def __init__(self, size: Size, dice: Dice, settings: Mapping[str, float], words: Words) -> None:
        """No dice are rolled: all is chosen."""
        self.size = size
        self.words = words
        self.world = new_world()
        known = {name: s.default for name, s in self.SETTINGS.items() if s.default is not None}
        chosen = {**known, **settings}
        self.carts = {
            lane: Cart(
                lane,
                chosen[f"cart.{lane}.mass"],
                chosen[f"cart.{lane}.acceleration"],
                self.world,
            )
            for lane in LANES
        }
        self.begun: float | None = None
        """Time of the world when the forces were applied (s); None before."""
        self.dialog: CartDialog | None = None
        self.collisions: Sequence[Collision] = ()

    def update(self, event: Event) -> None:
        """Take one event."""
        match event:
            case Resize(size=size):
                self.size = size
                if self.dialog:
                    self.dialog.update(event)
            case Tick(dt=dt):
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
        """The navigation, the lanes, the buttons, and the dialog over them if it is open."""
        area, words = layout(self.size), self.words
        reset, apply = pair(area)
        start = Widget("forces.apply", apply, words("forces.apply"), self.begun is None)
        below = [
            *navigation(area, words),
            *(Widget(f"cart.{lane}", self.lane(lane), words(f"forces.{lane}")) for lane in LANES),
            Widget("forces.reset", reset, words("forces.reset")),
            start,
        ]
        return below + (self.dialog.widgets() if self.dialog else [])

    def probes(self) -> dict[str, float]:
        """Those of the world and the carts, the chosen acceleration (m/s^2) and force (N) of each.

        `finish_time` (s) is there once the cart has passed the end mark.
        """
        read = probes.of_world(self.world, 0)
        for lane, cart in self.carts.items():
            prefix = f"cart.{lane}"
            read |= probes.of_body(prefix, cart.body)
            read[f"{prefix}.acceleration"] = cart.acceleration
            read[f"{prefix}.force"] = cart.force
            if cart.finish_time is not None:
                read[f"{prefix}.finish_time"] = cart.finish_time
        return read

    def lane(self, lane: str) -> Rect:
        """Where a lane is on the screen (dp)."""
        upper, lower = rows(layout(self.size).canvas, 2, GAP)
        return upper if lane == "a" else lower

    def view(self, lane: str) -> View:
        """A lane on the screen: as high as there is room for, its cart below the words."""
        rect, y = self.lane(lane), LANES[lane]
        scale = min(rect.width / (RIGHT - LEFT), (rect.height - 2 * HEAD) / CART)
        long, half = rect.width / scale, rect.height / scale / 2
        return View(rect, Room(LEFT, y - half, LEFT + long, y + half))

    def draw(self, surface: "Surface") -> None:
        """Draw what is."""
        if not self.dialog:
            self._draw_scene(surface)
            return
        # Below an open dialog nothing moves.
        still = (self.world.digest(), self.dialog.cart)
        surface.static((*self._key, *still), self._draw_below)
        self.dialog.draw(surface)

    @property
    def _key(self) -> tuple[object, ...]:
        carts = self.carts.values()
        chosen = tuple((cart.body.mass, cart.acceleration, cart.finish_time) for cart in carts)
        return (self.id, self.words.file, self.size, self.begun, chosen)

    def _draw_below(self, surface: "Surface") -> None:
        self._draw_scene(surface)
        if self.dialog:
            self.dialog.draw_ground(surface)

    def _draw_scene(self, surface: "Surface") -> None:
        area = layout(self.size)
        surface.static(self._key, self._draw_page)
        for cart in self.carts.values():
            self._draw_cart(surface, cart)
        for place, cart in zip(_readouts(area), self.carts.values(), strict=True):
            speed, time = columns(place, 2)
            shown = page.measured(cart.body.speed, self.words("unit.speed"), 2)
            page.value(surface, speed, shown, theme.YELLOW)
            page.value(surface, time, page.measured(self._time(cart), self.words("unit.s"), 2))

    def _draw_page(self, surface: "Surface") -> None:
        """Draw all that stays as it is from frame to frame."""
        area = layout(self.size)
        page.page(surface, area, self.words, self.id)
        for cart in self.carts.values():
            self._draw_lane(surface, cart)
        for place, lane in zip(_readouts(area), LANES, strict=True):
            page.heading(surface, place, self.words(f"forces.{lane}"))
        buttons = {widget.id: widget for widget in self.widgets()}
        page.outlined_button(surface, buttons["forces.reset"])
        page.filled_button(surface, buttons["forces.apply"])

    def _draw_lane(self, surface: "Surface", cart: Cart) -> None:
        """An empty lane: its grid, the end mark, and what was chosen for its cart."""
        words, rect, view = self.words, self.lane(cart.lane), self.view(cart.lane)
        canvas = Canvas(surface, rect, view.room)
        canvas.background(bar=cart.lane == "b")
        mark = view.to_screen((MARK, LANES[cart.lane])).x
        top, bottom = rect.y + 30, rect.bottom - 8
        surface.line((mark, top), (mark, bottom), 2, theme.WALL, dash=(4, 4))
        y = rect.y + 17
        mass = words("forces.mass", mass=page.chosen(cart.body.mass, words("unit.kg")))
        unit = words("unit.acceleration")
        rate = words("forces.acceleration", acceleration=page.chosen(cart.acceleration, unit))
        force = words("forces.force", force=page.chosen(cart.force, words("unit.N")))
        for text, x in ((mass, rect.x + INSET), (rate, rect.x + INSET + 76)):
            surface.text(text, (x, y), theme.BODY, theme.TEXT_MEDIUM, valign="middle")
        at = Point(rect.right - INSET, y)
        surface.text(force, at, STRONG, theme.ORANGE, align="right", valign="middle")

    def _draw_cart(self, surface: "Surface", cart: Cart) -> None:
        """A cart with its arrows; once it has passed the mark, the time it took."""
        words, view, body = self.words, self.view(cart.lane), cart.body
        canvas = Canvas(surface, view.rect, view.room)
        canvas.labels.block(view.rect._replace(height=HEAD))
        front, end = body.x + CART / 2, view.room.right
        if front < end + 2 * CART:
            mass = page.chosen(body.mass, words("unit.kg"))
            if len(mass) > FITS:
                mass = page.chosen(body.mass, "")
            canvas.body(body, theme.TEAL, opacity(body.mass, *MASS), mass, over=(canvas.rect,))
            # Its head stays in sight until the cart leaves.
            reach = body.vx * PER_SPEED
            tail = max(min(front, end - CLEAR - reach), front - CART)
            canvas.arrow((tail, body.y - ASIDE), (reach * view.scale, 0.0), arrows.VELOCITY)
        if cart.force > 0.0 and cart.finish_time is None:
            reach = cart.force * self._per_newton() * view.scale
            faded = WAITING if self.begun is None else 1.0
            at = (front, body.y + ASIDE)
            tip = canvas.arrow(at, (reach, 0.0), arrows.FORCE, faded)
            shown = page.chosen(cart.force, words("unit.N"))
            canvas.label(shown, Point(tip.x - reach / 2, tip.y), theme.ORANGE)
        if cart.finish_time is not None:
            mark = view.to_screen((MARK, LANES[cart.lane]))
            time = page.measured(cart.finish_time, words("unit.s"), 2)
            size = canvas.pill_size(time)
            flag = Rect(mark.x - size.width / 2, view.rect.bottom - 10 - size.height, *size)
            canvas.pill(time, flag, theme.TEXT)

    def _per_newton(self) -> float:
        """Length of the arrows of both forces (m per N): the same for both, however strong."""
        strongest = max(cart.force for cart in self.carts.values())
        return min(PER_NEWTON, LONGEST / strongest) if strongest > 0.0 else PER_NEWTON

    def _time(self, cart: Cart) -> float:
        """How long a cart has run, up to the mark (s)."""
        if cart.finish_time is not None:
            return cart.finish_time
        return 0.0 if self.begun is None else self.world.time - self.begun

    def _advance(self, dt: float) -> None:
        before = {lane: (cart.body.x, cart.body.vx) for lane, cart in self.carts.items()}
        now = self.world.time
        self.collisions = self.world.step(dt)
        for lane, cart in self.carts.items():
            if self.begun is not None and cart.finish_time is None and cart.body.x >= TRACK:
                x, v = before[lane]
                # The push lasts until the mark, so up to there the acceleration is the chosen one.
                last = cart.time_to_mark(x, v, cart.force)
                cart.finish_time = now - self.begun + last

    def _tap(self, id: str) -> None:
        match id:
            case "cart.a" | "cart.b":
                cart = self.carts[id[-1]]
                self.dialog = CartDialog(
                    cart.lane, cart.body.mass, cart.acceleration, self.size, self.words
                )
            case "forces.apply":
                self.begun = self.world.time
                for cart in self.carts.values():
                    cart.start()
            case "forces.reset":
                self._reset()

    def _close(self, dialog: CartDialog) -> None:
        """An accepted change puts both carts back: a comparison begins anew."""
        self.dialog = None
        if dialog.accepted:
            self.carts[dialog.cart].body.mass = dialog.mass
            self.carts[dialog.cart].acceleration = dialog.acceleration
            self._reset()

    def _reset(self) -> None:
        """Put both carts back to the start, at rest."""
        self.begun = None
        for lane, cart in self.carts.items():
            cart.stop()
            cart.body.position = Vector(0.0, LANES[lane])
            cart.body.velocity = Vector(0.0, 0.0)


def _readouts(area: Layout) -> list[Rect]:
    """Places of speed and time of the upper and the lower cart."""
    return columns(area.readouts, 2, 12.0) if area.portrait else rows(area.readouts, 2)
