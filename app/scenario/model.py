"""What a scenario file says: plain values, each step with its place in the file."""

import math
from collections.abc import Mapping
from fractions import Fraction
from typing import NamedTuple

from app.scenario.mistakes import Place
from app.targets import Target
from screens.kit.geometry import Point

TICKS_PER_SECOND = 60


def ticks(seconds: float) -> int:
    """The nearest number of ticks; halves are rounded up. Exact for decimal fractions."""
    return math.floor(Fraction(str(seconds)) * TICKS_PER_SECOND + Fraction(1, 2))


class Comparison(NamedTuple):
    """What a probe is held against; at least one of the values is there."""

    equals: float | None = None
    near: float | None = None
    tol: float = 0.0
    """How far from `near` still counts (same unit as the probe)."""
    above: float | None = None
    below: float | None = None
    """With `above`: both must hold."""

    def holds(self, value: float) -> bool:
        """Whether the value satisfies it; a value that is not a number never does."""
        return self.distance(value) == 0 and not (value == self.above or value == self.below)

    def distance(self, value: float) -> float:
        """How far the value is from satisfying it (0: it does, or lies on an open end)."""
        if math.isnan(value):
            return math.inf
        if self.equals is not None:
            return abs(value - self.equals)
        if self.near is not None:
            away = abs(value - self.near)
            return away if away > self.tol else 0.0
        low = -math.inf if self.above is None else self.above
        high = math.inf if self.below is None else self.below
        return max(low - value, value - high, 0.0)

    def __str__(self) -> str:
        """As in "above 1.5" or "near 2 (tol 0.01)"."""
        if self.equals is not None:
            return f"equal to {self.equals:g}"
        if self.near is not None:
            return f"near {self.near:g} (tol {self.tol:g})"
        parts = (("above", self.above), ("below", self.below))
        return " and ".join(f"{word} {value:g}" for word, value in parts if value is not None)


class Tap(NamedTuple):
    """Touch something."""

    place: Place
    target: Target


class Drag(NamedTuple):
    """Pull from one place to another, in a straight line."""

    place: Place
    start: Target
    end: Target
    over: float
    """Seconds."""


class Fill(NamedTuple):
    """Type numbers into the fields of the open dialog, in this order."""

    place: Place
    values: Mapping[str, float]


class Tilt(NamedTuple):
    """Turn the device.

    With `to`: from the present tilt to this one, linearly, over `over` seconds. Otherwise along
    `curve`, linearly between its points; its first time is 0.
    """

    place: Place
    to: Point | None
    """Roll and pitch (degrees)."""
    over: float
    """Seconds; of a curve, its last time."""
    curve: tuple[tuple[float, float, float], ...]
    """Time (s), roll, pitch (degrees)."""


class Wait(NamedTuple):
    """Let time pass."""

    place: Place
    seconds: float


class Until(NamedTuple):
    """Wait until a probe satisfies a comparison, at most `within` seconds."""

    place: Place
    probe: str
    comparison: Comparison
    within: float


class Expect(NamedTuple):
    """A probe must satisfy a comparison now."""

    place: Place
    probe: str
    comparison: Comparison


class Caption(NamedTuple):
    """Show these words until the next caption; an empty text takes them away."""

    place: Place
    text: str


class Marker(NamedTuple):
    """Give this moment a name in the report."""

    place: Place
    name: str


class Screenshot(NamedTuple):
    """Write the present picture to a PNG file."""

    place: Place
    path: str
    """Relative to the working folder, or absolute."""


class Speed(NamedTuple):
    """From here on the film runs at this multiple of true speed; the physics stays the same."""

    place: Place
    factor: float


class Hide(NamedTuple):
    """Stop filming, or drawing taps or captions."""

    place: Place
    what: str
    """`film`, `taps` or `captions`."""


class Show(NamedTuple):
    """Film again, or draw taps or captions again."""

    place: Place
    what: str
    """`film`, `taps` or `captions`."""


class Repeat(NamedTuple):
    """Do the steps several times."""

    place: Place
    times: int
    steps: tuple["Step", ...]


class Run(NamedTuple):
    """Do the steps of another scenario file."""

    place: Place
    path: str
    steps: tuple["Step", ...]


Step = (
    Tap
    | Drag
    | Fill
    | Tilt
    | Wait
    | Until
    | Expect
    | Caption
    | Marker
    | Screenshot
    | Speed
    | Hide
    | Show
    | Repeat
    | Run
)
"""One entry of `steps:`; `place` is where its key stands, or what is tapped, or the path."""


class Scenario(NamedTuple):
    """A whole file, valid in itself; `rehearse` tells whether its taps find what they touch."""

    path: str
    """As the person wrote it."""
    laws: int
    """Version of the format."""
    screen: str
    title: str
    alt: str
    seed: int
    lang: str
    size: tuple[int, int]
    """Width and height of the pictures (pixels)."""
    fps: int
    outputs: tuple[str, ...]
    """As written; relative to the working folder. One that ends in `/` is a folder of frames."""
    settings: Mapping[str, float]
    steps: tuple[Step, ...]
