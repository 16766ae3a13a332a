"""A number that can be chosen with a slider or typed into a field."""

import math
from typing import Literal

from screens.kit.geometry import Rect
from screens.kit.numbers import digits_of

Refusal = Literal["", "range", "number"]
"""Why a text was not taken as it is: outside of the range, or not a number."""

LONGEST = 12
"""Characters that fit into a field."""
THUMB = 9.0
"""Radius of what is drawn along the slider (dp): its ends are this far from those of its place."""


class Entry:
    """A number within a range, its slider and its field."""

    def __init__(self, value: float, low: float, high: float, step: float) -> None:
        """Sliders go in steps; a field takes any value within the range."""
        self.value = value
        self.low, self.high, self.step = low, high, step
        self.text: str | None = None
        """What is being typed; None if nothing is."""
        self.selected = False
        """Whether the next character replaces the whole text."""
        self.refusal: Refusal = ""

    def slide(self, x: float, track: Rect) -> None:
        """Move the thumb to an x of the screen (dp)."""
        self.text, self.refusal = None, ""
        part = (x - track.x - THUMB) / (track.width - 2 * THUMB)
        value = self.low + min(max(part, 0.0), 1.0) * (self.high - self.low)
        steps = round(1 / self.step)
        self.value = min(max(round(value * steps) / steps, self.low), self.high)

    def thumb(self, track: Rect) -> float:
        """Where the thumb is on a slider (x, dp)."""
        part = (self.value - self.low) / (self.high - self.low)
        return track.x + THUMB + part * (track.width - 2 * THUMB)

    def focus(self) -> None:
        """Begin to type; all that the field holds is selected."""
        self.text, self.selected, self.refusal = self.shown, True, ""

    def type(self, key: str) -> None:
        """Take a key: a character of a number, `backspace`, `enter` or `escape`."""
        if self.text is None:
            return
        if key == "enter":
            self.commit()
        elif key == "escape":
            self.text = None
        elif key == "backspace":
            self.text, self.selected = "" if self.selected else self.text[:-1], False
        elif len(key) == 1 and key in "0123456789.,-":
            self.text, self.selected = ("" if self.selected else self.text) + key, False
            self.text = self.text[:LONGEST]

    def commit(self) -> None:
        """Take what was typed.

        What lies outside of the range becomes its nearest end; what is no number leaves the value
        as it was; `refusal` then says so.
        """
        if self.selected:  # nothing was typed: what is shown may be rounded
            self.text, self.selected = None, False
        if self.text is None:
            return
        number = _number(self.text)
        self.text, self.selected = None, False
        if math.isnan(number):
            self.refusal = "number"
            return
        self.value = min(max(number, self.low), self.high)
        self.refusal = "" if self.value == number else "range"

    @property
    def shown(self) -> str:
        """The text in the field: what is typed, or the value."""
        if self.text is not None:
            return self.text
        return f"{self.value:.{digits_of(self.value)}f}"


def _number(text: str) -> float:
    try:
        return float(text.replace(",", "."))
    except ValueError:
        return math.nan
