"""Newton's second law."""

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from engine import Body, Collision, Force, Polygon, Push, Vector, World
from screens.kit import probes
from screens.kit.cart_dialog import ACCELERATION, MASS, CartDialog
from screens.kit.events import Event, Resize, Tap, Tick
from screens.kit.geometry import Rect, Size
from screens.kit.layout import GAP, layout, pair, rows
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
"""What of a lane is in sight (x, m)."""


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
        self.world = World(integrator="velocity-verlet")
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
        waits = self.begun is None
        start = Widget(
            "forces.apply", apply, words(f"forces.{'apply' if waits else 'running'}"), waits
        )
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
        """A lane on the screen: always of the same length, as high as there is room for."""
        rect = self.lane(lane)
        half = (RIGHT - LEFT) * rect.height / rect.width / 2
        return View(rect, Room(LEFT, LANES[lane] - half, RIGHT, LANES[lane] + half))

    def draw(self, surface: "Surface") -> None:
        """Draw what is."""

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
