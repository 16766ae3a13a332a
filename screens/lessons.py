"""The three lessons, and the way from one to another."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from engine import Collision, World
from screens.kit.events import Event, Resize, Tap, Tilt
from screens.kit.geometry import Size
from screens.kit.widgets import NAVIGATION, touched
from screens.kit.words import Words
from screens.lesson import Dice, Lesson, Widget

if TYPE_CHECKING:
    from screens.forces import Forces
    from screens.inertia import Inertia
    from screens.kit.surface import Surface
    from screens.reactions import Reactions


def lesson_class(id: str) -> "type[Inertia] | type[Forces] | type[Reactions]":
    """The class of a lesson by its id (see `layout.SCREENS`), loaded when it is first asked for.

    Raises:
        LookupError: if there is no such lesson.
    """
    match id:
        case "inertia":
            from screens.inertia import Inertia

            return Inertia
        case "forces":
            from screens.forces import Forces

            return Forces
        case "reactions":
            from screens.reactions import Reactions

            return Reactions
    raise LookupError(f"there is no lesson '{id}'")


class Lessons:
    """Shows one lesson at a time; those left behind wait as they were."""

    def __init__(
        self,
        first: str,
        size: Size,
        dice_for: Callable[[str], Dice],
        settings: Mapping[str, float],
        words: Words,
    ) -> None:
        """Begin with one lesson, to which the settings apply.

        The others are made when they are first visited, with the dice of their own that
        `dice_for` hands out by their id.
        """
        self.size = size
        self._dice_for = dice_for
        self._words = words
        self._tilt: Tilt | None = None
        self._visited: dict[str, Lesson] = {}
        self.lesson: Lesson = self._make(first, settings)

    @property
    def id(self) -> str:
        """Of the lesson that is shown."""
        return self.lesson.id

    @property
    def world(self) -> World:
        """Of the lesson that is shown."""
        return self.lesson.world

    @property
    def collisions(self) -> Sequence[Collision]:
        """Of its last tick."""
        return self.lesson.collisions

    def update(self, event: Event) -> None:
        """Go to another lesson, or let the one that is shown take the event."""
        match event:
            case Tap(at=at) if (id := touched(self.widgets(), at)) in NAVIGATION:
                self._show(id.removeprefix("nav."))
            case Resize(size=size):
                self.size = size
                self.lesson.update(event)
            case _:
                if isinstance(event, Tilt):
                    self._tilt = event
                self.lesson.update(event)

    def draw(self, surface: "Surface") -> None:
        """Draw the lesson that is shown."""
        self.lesson.draw(surface)

    def widgets(self) -> Sequence[Widget]:
        """Of the lesson that is shown."""
        return self.lesson.widgets()

    def probes(self) -> Mapping[str, float]:
        """Of the lesson that is shown."""
        return self.lesson.probes()

    def _show(self, id: str) -> None:
        """Go to a lesson; the device is as large and as tilted there as here."""
        if id == self.lesson.id:
            return
        self.lesson = self._visited.get(id) or self._make(id, {})
        if self.lesson.size != self.size:
            self.lesson.update(Resize(self.size))
        if self._tilt:
            self.lesson.update(self._tilt)

    def _make(self, id: str, settings: Mapping[str, float]) -> Lesson:
        made = lesson_class(id)(self.size, self._dice_for(id), settings, self._words)
        self._visited[id] = made
        return made
