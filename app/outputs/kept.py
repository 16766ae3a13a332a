"""One promised output: an encoder of some format, and the name it gets when it is whole."""

from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Protocol

from app.frames import Film, Frame, Moment
from app.outputs.promise import OutputError, Promise, explained


class Encoder(Protocol):
    """A file format. It writes to the path it was made with and knows nothing of promises."""

    def frame(self, frame: Frame) -> None:
        """Encode the next picture."""

    def moment(self, moment: Moment) -> None:
        """Note the next state of the world."""

    def finish(self) -> None:
        """Write the rest and let go of the file."""

    def abandon(self) -> None:
        """Let go of the file as it is; nobody will read it."""


class Kept:
    """A `Sink` that keeps its promise: `close` leaves the whole file there, or says why not."""

    def __init__(
        self,
        path: str,
        film: Film,
        make: Callable[[Path, Film], Encoder],
        *,
        folder: bool = False,
        pictures: bool = True,
    ) -> None:
        """Claim the place and open the encoder. Raises OutputError.

        `folder`: the encoder writes into a folder. `pictures`: without any, nothing is whole.
        """
        self._wants_pictures = pictures
        self._pictures = 0
        self._ended = False
        self._promise = Promise(path, folder=folder)
        try:
            with explained(path):
                self._encoder = make(self._promise.part, film)
        except BaseException:
            self._promise.drop()
            raise

    def frame(self, frame: Frame) -> None:
        """Encode the next picture."""
        self._pictures += 1
        with explained(self._promise.path):
            self._encoder.frame(frame)

    def moment(self, moment: Moment) -> None:
        """Hand on the next state of the world."""
        with explained(self._promise.path):
            self._encoder.moment(moment)

    def close(self) -> None:
        """Finish the file and give it its name; if that fails, nothing of it is left."""
        try:
            if self._wants_pictures and not self._pictures:
                raise OutputError(self._promise.path, "the film has no picture")
            with explained(self._promise.path):
                self._encoder.finish()
            self._check()
        except BaseException:
            self.abort()
            raise
        self._ended = True
        self._promise.keep()

    def abort(self) -> None:
        """Drop what was begun. After `close` or another `abort` it does nothing."""
        if self._ended:
            return
        self._ended = True
        try:
            with suppress(OSError):  # a disk that is full stays so when the rest is flushed
                self._encoder.abandon()
        finally:
            self._promise.drop()

    def _check(self) -> None:
        part = self._promise.part
        if not part.exists():
            raise OutputError(self._promise.path, "the file vanished while it was written")
        if part.is_file() and part.stat().st_size == 0:
            raise OutputError(self._promise.path, "nothing was written")
        if part.is_dir() and sum(1 for _ in part.iterdir()) != self._pictures:
            raise OutputError(self._promise.path, "frames are missing in the folder")
