"""All that can happen to a lesson. Places are in dp of the screen; time is an event as well."""

from dataclasses import dataclass

from screens.kit.geometry import Point, Size

TICK = 1 / 60
"""Length of one tick (s)."""


@dataclass(frozen=True, slots=True)
class Tick:
    """One tick of simulated time passes."""

    dt: float = TICK


@dataclass(frozen=True, slots=True)
class Tap:
    """A finger touched and left the screen at one place."""

    at: Point


@dataclass(frozen=True, slots=True)
class Drag:
    """A finger that went down at `start` is now at `at`; the first one has `at == start`."""

    start: Point
    at: Point


@dataclass(frozen=True, slots=True)
class Release:
    """A drag ended at `at`."""

    at: Point


@dataclass(frozen=True, slots=True)
class Tilt:
    """The device is held at this angle (degrees): roll pushes to +x, pitch towards -y."""

    roll: float
    pitch: float


@dataclass(frozen=True, slots=True)
class Key:
    """A key: a printable character, or `backspace`, `enter`, `escape`."""

    name: str


@dataclass(frozen=True, slots=True)
class Resize:
    """The screen has a new size (dp)."""

    size: Size


Event = Tick | Tap | Drag | Release | Tilt | Key | Resize
