"""What the loop, the scenario checker and the outputs may ask of a lesson: nothing else."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple, Protocol

from engine import Collision, World
from screens.kit.events import Event
from screens.kit.geometry import Rect, Size

if TYPE_CHECKING:
    from screens.kit.surface import Surface

Dice = Callable[[], float]
"""Hands out the next number in 0 <= x < 1; the lesson never rolls dice of its own."""


class Setting(NamedTuple):
    """A value that a scenario's `set:` may give to a lesson."""

    low: float
    high: float
    default: float | None
    """None: drawn from the seed."""
    unit: str
    about: str
    whole: bool = False
    """Whether only whole numbers make sense."""


class Widget(NamedTuple):
    """Something that can be tapped or dragged."""

    id: str
    rect: Rect
    label: str
    """The words a pupil sees on it, or an empty string."""
    enabled: bool = True


class Lesson(Protocol):
    """One of the three screens, or the host that navigates between them."""

    @property
    def id(self) -> str:
        """Of the lesson: inertia, forces or reactions."""

    @property
    def size(self) -> Size:
        """Of the screen (dp)."""

    @property
    def world(self) -> World:
        """What moves now."""

    @property
    def collisions(self) -> Sequence[Collision]:
        """Those of the last tick, in order."""

    def update(self, event: Event) -> None:
        """Take one event: the only door to state."""

    def draw(self, surface: "Surface") -> None:
        """Draw what is; change nothing."""

    def widgets(self) -> Sequence[Widget]:
        """All that can be touched now, in drawing order: the last that holds a point gets it."""

    def probes(self) -> Mapping[str, float]:
        """Every number a scenario may ask for, in SI units (angles in radians), by name."""
