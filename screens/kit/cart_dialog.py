"""The dialog in which mass and acceleration of a cart are chosen; the force follows from them."""

from screens.kit.entry import Entry
from screens.kit.events import Drag, Event, Key, Release, Resize, Tap
from screens.kit.geometry import Rect, Size
from screens.kit.layout import GAP, TOUCH
from screens.kit.widgets import MODAL, touched
from screens.kit.words import Words
from screens.lesson import Widget

MASS = (0.5, 10.0)
"""Lightest and heaviest cart (kg)."""
ACCELERATION = (0.0, 5.0)
"""Range of the acceleration (m/s^2)."""
STEP = 0.1
"""Of both sliders (kg, m/s^2)."""
FIELD = Size(92.0, TOUCH)
ROW = 92.0
"""Height of a quantity: its name and field, and its slider below (dp)."""


class CartDialog:
    """Mass and acceleration of a cart, each with a slider and a field, and the force needed."""

    def __init__(
        self, cart: str, mass: float, acceleration: float, size: Size, words: Words
    ) -> None:
        """Start from a mass (kg) and an acceleration (m/s^2) on a screen of a size (dp)."""
        self.cart = cart
        """Which one: `a` or `b`."""
        self.entries = {
            "mass": Entry(mass, *MASS, STEP),
            "acceleration": Entry(acceleration, *ACCELERATION, STEP),
        }
        self.size = size
        self.words = words
        self.closed = False
        self.accepted = False
        self._held = ""

    @property
    def mass(self) -> float:
        """Chosen (kg)."""
        return self.entries["mass"].value

    @property
    def acceleration(self) -> float:
        """Chosen (m/s^2)."""
        return self.entries["acceleration"].value

    @property
    def force(self) -> float:
        """Needed for the acceleration, F = m a (N)."""
        return self.mass * self.acceleration

    def update(self, event: Event) -> None:
        """Take what a hand does; time passes without a change."""
        match event:
            case Resize(size=size):
                self.size, self._held = size, ""
            case Tap(at=at):
                self._tap(touched(self.widgets(), at), at.x)
            case Drag(start=start, at=at):
                self._held = self._held or touched(self.widgets(), start) or MODAL
                if self._held in self.entries:
                    self._slide(self._held, at.x)
            case Release():
                self._held = ""
            case Key(name=name):
                self._type(name)
            case _:
                pass

    def widgets(self) -> list[Widget]:
        """What lies over the screen, the buttons, the sliders and the fields."""
        cancel, accept = self.buttons
        shown = [
            Widget(MODAL, Rect(0.0, 0.0, *self.size), ""),
            Widget("dialog.cancel", cancel, self.words("dialog.cancel")),
            Widget("dialog.accept", accept, self.words("dialog.accept")),
        ]
        for name in self.entries:
            shown.append(Widget(name, self.slider(name), self.words(f"cart.{name}")))
            shown.append(Widget(f"{name}.field", self.field(name), ""))
        return shown

    @property
    def panel(self) -> Rect:
        """The dialog itself (dp)."""
        wide, high = (304.0, 376.0) if self._upright else (520.0, 300.0)
        return Rect((self.size.width - wide) / 2, (self.size.height - high) / 2, wide, high)

    @property
    def head(self) -> Rect:
        """Where the title is (dp)."""
        panel = self.panel
        return Rect(panel.x + 24, panel.y + 16, panel.width - 48, 28.0)

    def row(self, name: str) -> Rect:
        """Where a quantity has its name, its field and its slider (dp)."""
        panel, below = self.panel, ROW * list(self.entries).index(name)
        wide = panel.width - 48 if self._upright else 264.0
        return Rect(panel.x + 24, panel.y + 52 + below, wide, ROW)

    def field(self, name: str) -> Rect:
        """Where a number is typed (dp)."""
        row = self.row(name)
        return Rect(row.right - FIELD.width, row.y, *FIELD)

    def slider(self, name: str) -> Rect:
        """Where a slider is (dp)."""
        row = self.row(name)
        return Rect(row.x, row.y + TOUCH + GAP, row.width, TOUCH)

    @property
    def force_row(self) -> Rect:
        """Where the force is drawn (dp)."""
        panel = self.panel
        if self._upright:
            return Rect(panel.x + 24, panel.y + 52 + 2 * ROW + 4, panel.width - 48, 72.0)
        return Rect(panel.x + 320, panel.y + 52, panel.width - 344, 140.0)

    @property
    def buttons(self) -> tuple[Rect, Rect]:
        """Places of Cancel and Accept (dp)."""
        panel = self.panel
        y, right = panel.bottom - 12 - TOUCH, panel.right - 16
        accept = Rect(right - 92, y, 92.0, TOUCH)
        return Rect(accept.x - GAP - 84, y, 84.0, TOUCH), accept

    @property
    def _upright(self) -> bool:
        return self.size.height >= self.size.width

    def _tap(self, id: str, x: float) -> None:
        for name, entry in self.entries.items():
            if id == f"{name}.field":
                self._commit_others(name)
                entry.focus()
                return
        if id == "dialog.cancel":
            self.closed = True
            return
        refused = self._commit_others("")
        if id in self.entries:
            self._slide(id, x)
        elif id == "dialog.accept":
            self.closed = self.accepted = not refused

    def _type(self, key: str) -> None:
        typing = [entry for entry in self.entries.values() if entry.text is not None]
        for entry in typing:
            entry.type(key)
        if not typing and key == "escape":
            self.closed = True

    def _slide(self, name: str, x: float) -> None:
        self._commit_others(name)
        self.entries[name].slide(x, self.slider(name))

    def _commit_others(self, name: str) -> bool:
        """Take what is typed in all fields but one; whether something was not taken as it is."""
        refused = False
        for other, entry in self.entries.items():
            if other != name and entry.text is not None:
                entry.commit()
                refused = refused or bool(entry.refusal)
        return refused
