"""The dialog in which mass and acceleration of a cart are chosen; the force follows from them."""

from typing import TYPE_CHECKING

from screens.kit import page, theme
from screens.kit.entry import THUMB, Entry
from screens.kit.events import Drag, Event, Key, Release, Resize, Tap
from screens.kit.geometry import Point, Rect, Size
from screens.kit.layout import GAP, TOUCH, dialog
from screens.kit.numbers import quantity
from screens.kit.widgets import MODAL, touched
from screens.kit.words import Words
from screens.lesson import Widget

if TYPE_CHECKING:
    from screens.kit.surface import Surface

MASS = (0.5, 10.0)
"""Lightest and heaviest cart (kg)."""
ACCELERATION = (0.0, 5.0)
"""Range of the acceleration (m/s^2)."""
STEP = 0.1
"""Of both sliders (kg, m/s^2)."""
FIELD = Size(120.0, TOUCH)
"""It holds 0.00123 m/s²."""
NAME = theme.mix(theme.WHITE, 0.7, theme.DIALOG)
UNITS = {"mass": "unit.kg", "acceleration": "unit.acceleration"}
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

    def draw_ground(self, surface: "Surface") -> None:
        """Draw what stays whatever is chosen, over the screen below."""
        page.dialog(surface, self.panel, self.head, self.words(f"forces.{self.cart}"))
        cancel, accept = self.widgets()[1:3]
        page.plain_button(surface, cancel)
        page.filled_button(surface, accept)

    def draw(self, surface: "Surface") -> None:
        """Draw the quantities and the force over the ground."""
        for name, entry in self.entries.items():
            self._draw_entry(surface, name, entry)
        self._draw_force(surface)

    @property
    def panel(self) -> Rect:
        """The dialog itself (dp)."""
        return dialog(self.size, Size(304.0, 376.0) if self._upright else Size(410.0, 320.0))

    @property
    def head(self) -> Rect:
        """Where the title is (dp)."""
        panel = self.panel
        return Rect(panel.x + 24, panel.y + 16, panel.width - 48, 28.0)

    def row(self, name: str) -> Rect:
        """Where a quantity has its name, its field and its slider (dp)."""
        panel, below = self.panel, ROW * list(self.entries).index(name)
        return Rect(panel.x + 24, panel.y + 52 + below, panel.width - 48, ROW)

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
        beside = 0.0 if self._upright else panel.right - self.buttons[0].x
        return Rect(panel.x + 24, panel.y + 56 + 2 * ROW, panel.width - 48 - beside, 72.0)

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

    def _draw_entry(self, surface: "Surface", name: str, entry: Entry) -> None:
        words, row, field, track = self.words, self.row(name), self.field(name), self.slider(name)
        label = Point(row.x, field.center.y)
        if entry.refusal:
            label = Point(row.x, row.y + 10)
            surface.text(
                self._refusal(name, entry),
                (row.x, row.y + 29),
                theme.SMALL,
                theme.ORANGE,
                valign="middle",
            )
        surface.text(words(f"cart.{name}"), label, theme.BODY, NAME, valign="middle")
        self._draw_field(surface, field, entry, words(UNITS[name]))
        middle, thumb = track.center.y, entry.thumb(track)
        surface.capsule((row.x + 2, middle), (row.right - 2, middle), 4, theme.TRACK)
        surface.capsule((row.x + 2, middle), (thumb, middle), 4, theme.TEAL)
        surface.circle((thumb, middle), THUMB, theme.TEAL)

    def _draw_field(self, surface: "Surface", field: Rect, entry: Entry, unit: str) -> None:
        """A number, its unit, and while it is typed a caret or a mark over what is selected."""
        typing = entry.text is not None
        line = theme.TEAL if typing else theme.OUTLINE
        box = field.inset(2)
        surface.rect(box, theme.FIELD, radius=8, outline=line, outline_width=2 if typing else 1)
        middle = box.center.y
        end = box.right - 10 - surface.measure(unit, theme.BODY).width
        surface.text(unit, (end, middle), theme.BODY, theme.TEXT_MEDIUM, valign="middle")
        right = end - 5
        width = surface.measure(entry.shown, theme.VALUE).width if entry.shown else 0.0
        with surface.clip(box.inset(2)):
            if typing and entry.selected:
                mark = Rect(right - width - 2, middle - 10, width + 3, 20.0)
                surface.rect(mark, theme.TEAL, 0.4, radius=3)
            surface.text(
                entry.shown,
                (right, middle),
                theme.VALUE,
                theme.TEXT,
                align="right",
                valign="middle",
            )
            if typing and not entry.selected:
                surface.rect(Rect(right + 1, middle - 9, 1.5, 18.0), theme.TEAL)

    def _draw_force(self, surface: "Surface") -> None:
        """The force, as an arrow that grows with it and as a number."""
        words, place = self.words, self.force_row
        shown = page.chosen(self.force, words("unit.N"))
        # On a dialog that lies across, the buttons leave room for the arrow only.
        line = place.y + (14 if self._upright else 8)
        label, number = Point(place.x, line), Point(self.panel.right - 24, line)
        surface.text(words("cart.force"), label, theme.BODY, NAME, valign="middle")
        surface.text(shown, number, theme.BIG_VALUE, theme.ORANGE, align="right", valign="middle")
        y, longest = place.y + 48, place.width - 4
        surface.capsule((place.x + 2, y), (place.right - 2, y), 2, theme.TRACK)
        reach = longest * self.force / (MASS[1] * ACCELERATION[1])
        surface.arrow((place.x + 2, y), (place.x + 2 + reach, y), theme.ORANGE, width=5)

    def _refusal(self, name: str, entry: Entry) -> str:
        unit = self.words(UNITS[name])
        low, high = quantity(entry.low, unit, 1), quantity(entry.high, unit, 1)
        return self.words(f"cart.{entry.refusal}", low=low, high=high)
