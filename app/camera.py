"""The camera: decides when a picture is due, draws it, and hands it to the outputs."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from app.frames import Frame, Pixels, Sink
from app.overlay import Overlay
from screens.kit.events import Event
from screens.lesson import Lesson

if TYPE_CHECKING:
    from screens.kit.surface import Surface

TICKS_PER_SECOND = 60


class NothingFilmed(Exception):
    """A film without a single frame was asked for."""


class FilmClock:
    """Film time against ticks, in exact fractions of a second: it never drifts.

    Frame k is shown from k/fps on, and shows the latest state that began at or before k/fps.
    At speed s every tick lasts 1/(60 s) of film, so that frames repeat or are left out.
    """

    def __init__(self, fps: int) -> None:
        """Begin at film time 0, at true speed."""
        self.fps = fps
        self.frames = 0
        """Frames given out so far."""
        self.now = Fraction(0)
        """When the present state began (s of film)."""
        self._tick = Fraction(1, TICKS_PER_SECOND)

    def play_at(self, speed: float) -> None:
        """From the next tick on, play at this multiple of true speed."""
        self._tick = 1 / (TICKS_PER_SECOND * Fraction(str(speed)))

    def tick(self) -> range:
        """Let one tick pass; the numbers of the frames that show the state before it."""
        self.now += self._tick
        upcoming = -(-self.now * self.fps // 1)  # the first frame that shows the next state
        return self._give(int(upcoming))

    def finish(self) -> range:
        """The numbers of the frames that show the last state: at least one."""
        last = -(-self.now * self.fps // 1)
        return self._give(int(last) + 1)

    def _give(self, end: int) -> range:
        due = range(self.frames, max(end, self.frames))
        self.frames = due.stop
        return due


class Camera:
    """Films a lesson, with captions and the marks of fingers over it."""

    def __init__(
        self,
        surface: "Surface",
        overlay: Overlay,
        sinks: Sequence[Sink],
        fps: int,
        filmed: Callable[[int], None] = lambda frames: None,
    ) -> None:
        """Draw on `surface`, hand every frame to all `sinks`, tell `filmed` how many there are.

        Without sinks frames are only counted: who wants the numbers alone waits for no drawing.
        """
        self.clock = FilmClock(fps)
        self.overlay = overlay
        self.hidden = False
        """While true nothing is filmed, and film time stands still."""
        self._surface = surface
        self._sinks = sinks
        self._filmed = filmed
        self._picture: Pixels | None = None

    def touch(self, event: Event) -> None:
        """Something happened to the lesson: leave its mark, and draw anew."""
        self.overlay.mark(event, self.seconds)
        self._picture = None

    def caption(self, words: str) -> None:
        """Show these words until others come."""
        self.overlay.caption = words
        self._picture = None

    @property
    def seconds(self) -> float:
        """Film time at which the present state began (s)."""
        return float(self.clock.now)

    def film_until_tick(self, lesson: Lesson) -> None:
        """Film what is due before the next tick."""
        if not self.hidden:
            for index in self.clock.tick():
                self._film(lesson, index)
        self._picture = None

    def finish(self, lesson: Lesson) -> None:
        """Film the last state; raises NothingFilmed if a film would be empty."""
        if not self.hidden:
            for index in self.clock.finish():
                self._film(lesson, index)
        if self._sinks and not self.clock.frames:
            raise NothingFilmed("the film has no frames: all of it is hidden")

    def picture(self, lesson: Lesson) -> Pixels:
        """What the film shows at the beginning of the present state."""
        return self._draw(lesson, self.seconds)

    def _film(self, lesson: Lesson, index: int) -> None:
        if self._sinks:
            seconds = index / self.clock.fps
            if self._picture is None or self.overlay.is_moving(seconds):
                self._picture = self._draw(lesson, seconds)
            frame = Frame(index, self._picture)
            for sink in self._sinks:
                sink.frame(frame)
        self._filmed(index + 1)

    def _draw(self, lesson: Lesson, seconds: float) -> Pixels:
        lesson.draw(self._surface)
        self.overlay.draw(self._surface, lesson, seconds)
        return self._surface.pixels()
