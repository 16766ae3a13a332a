"""What every lesson has around its canvas: words, numbers, buttons, the navigation, dialogs."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from screens.kit import theme
from screens.kit.geometry import Point, Rect
from screens.kit.layout import Layout
from screens.kit.numbers import digits_of, quantity
from screens.kit.theme import Color
from screens.kit.widgets import navigation
from screens.kit.words import Words
from screens.lesson import Widget

if TYPE_CHECKING:
    from screens.kit.surface import Surface

NUMERALS = ("I", "II", "III")
"""Of the laws, in the order of the navigation."""
INDICATOR = 56.0, 24.0
"""Width and height of the mark behind the numeral of the lesson that is shown (dp)."""
FORMULA = theme.Style(10, theme.MEDIUM, 14)


def page(surface: "Surface", area: Layout, words: Words, id: str) -> None:
    """The ground of a screen: its background, title, law, explanation and navigation."""
    surface.fill(theme.SURFACE)
    room = area.words
    title = surface.text(words(f"{id}.title"), (room.x, room.y), theme.TITLE, theme.TEXT)
    surface.text(
        words(f"{id}.law"), (room.x, title.bottom + 1), theme.LAW, theme.TEXT, width=room.width
    )
    below = explanation_of(surface, room, words, id)
    surface.text(
        words(f"{id}.explanation"),
        (below.x, below.y),
        theme.EXPLANATION,
        theme.TEXT_MEDIUM,
        width=below.width,
    )
    surface.rect(area.nav, theme.NAVIGATION)
    for numeral, place in zip(NUMERALS, navigation(area, words), strict=True):
        _way(surface, place, numeral, shown=place.id == f"nav.{id}")


def explanation_of(surface: "Surface", room: Rect, words: Words, id: str) -> Rect:
    """Where the explanation of a lesson lies within the room of its words, below title and law."""
    law = surface.measure(words(f"{id}.law"), theme.LAW, width=room.width)
    top = room.y + theme.TITLE.line_height + 1 + law.height + 3
    needed = surface.measure(words(f"{id}.explanation"), theme.EXPLANATION, width=room.width)
    return Rect(room.x, top, room.width, needed.height)


def _way(surface: "Surface", place: Widget, numeral: str, shown: bool) -> None:
    """One entry of the navigation; the lesson that is shown has a mark behind its numeral."""
    rect, (wide, high) = place.rect, INDICATOR
    middle = rect.center
    high = min(high, rect.height - 22)
    mark = Rect(middle.x - wide / 2, rect.y + (rect.height - high - 17) / 2, wide, high)
    if shown:
        surface.rect(mark, theme.SELECTED, radius=mark.height / 2)
    color = theme.TEAL if shown else theme.TEXT_MEDIUM
    surface.text(numeral, mark.center, theme.NUMERAL, color, align="center", valign="middle")
    color = theme.TEXT if shown else theme.TEXT_MEDIUM
    below = Point(middle.x, mark.bottom + 10)
    surface.text(place.label, below, theme.NAV, color, align="center", valign="middle")


def filled_button(surface: "Surface", button: Widget) -> None:
    """The one button of a row that is most likely wanted."""
    ground, ink = (
        (theme.BUTTON, theme.TEXT_DARK)
        if button.enabled
        else (theme.mix(theme.WHITE, 0.12, theme.SURFACE), theme.TEXT_DISABLED)
    )
    surface.rect(button.rect, ground, radius=button.rect.height / 2)
    _button_text(surface, button, ink)


def outlined_button(
    surface: "Surface", button: Widget, line: Color = theme.OUTLINE, ink: Color = theme.TEXT
) -> None:
    """A button beside the filled one."""
    color = ink if button.enabled else theme.TEXT_DISABLED
    line = line if button.enabled else theme.HAIRLINE
    surface.rect(button.rect, None, radius=button.rect.height / 2, outline=line)
    _button_text(surface, button, color)


def plain_button(surface: "Surface", button: Widget) -> None:
    """A button of a dialog that leaves all as it was."""
    _button_text(surface, button, theme.mix(theme.WHITE, 0.7, theme.DIALOG))


def _button_text(surface: "Surface", button: Widget, ink: Color) -> None:
    surface.text(
        button.label, button.rect.center, theme.BUTTON_TEXT, ink, align="center", valign="middle"
    )


def heading(surface: "Surface", rect: Rect, label: str) -> None:
    """What a readout shows, in the upper part of its place; a formula keeps its small letters."""
    style = FORMULA if "=" in label else theme.LABEL
    surface.text(label, (rect.x, rect.y), style, theme.TEXT_MEDIUM)


def value(surface: "Surface", rect: Rect, words: str, color: Color = theme.TEXT) -> None:
    """The number of a readout, below its heading."""
    surface.text(words, (rect.x, rect.y + 14), theme.VALUE, color)


def measured(number: float, unit: str, digits: int) -> str:
    """A number that changes, with fewer decimals the longer it is, so that its place suffices."""
    if abs(number) >= 99.995:
        digits = max(digits - (1 if abs(number) < 999.95 else 2), 0)
    return quantity(number, unit, digits)


def chosen(number: float, unit: str) -> str:
    """A number that was chosen, with one decimal, or as many as it really has, up to a limit."""
    return quantity(number, unit, digits_of(number))


def shares(rect: Rect, parts: Sequence[float]) -> list[Rect]:
    """A rectangle divided into columns whose widths are in proportion to `parts`."""
    whole, x, places = sum(parts), rect.x, []
    for part in parts:
        width = rect.width * part / whole
        places.append(Rect(x, rect.y, width, rect.height))
        x += width
    return places


def dialog(surface: "Surface", panel: Rect, head: Rect, title: str, hint: str = "") -> None:
    """The ground of a dialog, over a darkened screen."""
    surface.scrim(theme.SCRIM)
    surface.rect(panel, theme.DIALOG, radius=theme.DIALOG_RADIUS)
    below = surface.text(
        title, (head.x, head.y), theme.HEADING, theme.TEXT, width=head.width
    ).bottom
    if hint:
        surface.text(hint, (head.x, below + 2), theme.BODY, theme.TEXT_MEDIUM, width=head.width)
