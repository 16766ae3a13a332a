"""The one loop: events -> lesson -> frames and moments -> outputs.

Export, playback, a live window and recording differ only in the ends handed in here.
"""

from collections.abc import Callable, Iterable, Sequence
from weakref import WeakKeyDictionary

from app.camera import Camera
from app.frames import Moment
from app.scenario.model import Caption, Hide, Marker, Screenshot, Show, Speed
from engine import World
from screens.kit.events import Event, Tick
from screens.lesson import Lesson

Cue = Caption | Marker | Screenshot | Speed | Hide | Show
"""What a source may say to the camera rather than to the lesson."""


def never_wait() -> None:
    """The pace of a run that nobody watches."""


class Session:
    """One run of a lesson, from its first event to its last."""

    def __init__(
        self,
        lesson: Lesson,
        camera: Camera,
        listeners: Sequence[Callable[[Moment], None]],
        heed: Callable[[Cue], None],
        pace: Callable[[], None] = never_wait,
    ) -> None:
        """Every moment goes to `listeners`, every cue to `heed`; `pace` may wait after a tick."""
        self.lesson = lesson
        self.camera = camera
        self._listeners = listeners
        self._heed = heed
        self._pace = pace
        self._told: WeakKeyDictionary[World, int] = WeakKeyDictionary()

    def run(self, source: Iterable[Event | Cue]) -> None:
        """Do what the source says, in order, until it ends."""
        for doing in source:
            match doing:
                case Tick():
                    self._tell()
                    self.camera.film_until_tick(self.lesson)
                    self.lesson.update(doing)
                    self._tell()
                    self._pace()
                case Caption() | Marker() | Screenshot() | Speed() | Hide() | Show():
                    self._direct(doing)
                case _:
                    self.camera.touch(doing)
                    self.lesson.update(doing)
        self._tell()
        self.camera.finish(self.lesson)

    def _tell(self) -> None:
        """Hand the moment on, unless this world was already told of at this tick."""
        world = self.lesson.world
        if self._told.get(world) == world.tick:
            return
        self._told[world] = world.tick
        moment = Moment(world.time, world, self.lesson.collisions)
        for listen in self._listeners:
            listen(moment)

    def _direct(self, cue: Cue) -> None:
        match cue:
            case Caption(text=words):
                self.camera.caption(words)
            case Speed(factor=factor):
                self.camera.clock.play_at(factor)
            case Hide(what=what) | Show(what=what):
                self._reveal(what, isinstance(cue, Show))
            case Marker() | Screenshot():
                pass
        self._heed(cue)

    def _reveal(self, what: str, shown: bool) -> None:
        match what:
            case "film":
                self.camera.hidden = not shown
            case "taps":
                self.camera.overlay.shows_taps = shown
            case "captions":
                self.camera.overlay.shows_captions = shown
