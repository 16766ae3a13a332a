"""An encoder that works in a process of its own, so that drawing and encoding share no interpreter.

Threads would: whenever one lets go of the interpreter's lock for a moment the other takes it, and
the first must wait until it is woken again. A GIF took longer with a thread than without.
"""

import atexit
import os
import pickle
import subprocess
from collections.abc import Sequence
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np

from app.frames import Film, Frame, Moment, Pixels
from app.outputs.shared import AVAILABLE, Memory, most_waiting
from engine.own_process import start


class Begin(NamedTuple):
    """Make the encoder `name` of `module` for a film."""

    module: str
    name: str
    part: Path
    film: Film


class Picture(NamedTuple):
    """Encode the picture at a place, which stays as it is until an answer says it is done with."""

    number: int
    place: int


class Finish(NamedTuple):
    """Write the rest of the film and let go of its file."""


Request = Begin | Picture | Finish


class Answer(NamedTuple):
    """To each request, in turn, when it is done."""

    failure: Exception | None
    """What failed, in this request or one before."""
    done_with: list[int]
    """Places whose pictures are not needed any more."""


class Remote:
    """An `Encoder` whose work is done by a worker (`worker.py`).

    Each request is answered in turn. Of pictures no answer is awaited before a few are waiting, so
    what fails comes out of a later call.
    """

    def __init__(self, module: str, name: str, part: Path, film: Film) -> None:
        """Let a worker make the encoder `name` of `module`; raises what that raises."""
        self._worker = _any_worker(module)
        self._finished = False
        try:
            self._film = film
            self._most = most_waiting(film)
            self._lent: list[tuple[int, Pixels]] = []
            """Places and pictures that the worker may still need."""
            self._worker.send(Begin(module, name, part, film))
            self._worker.hear()
        except BaseException:
            self.abandon()
            raise

    def frame(self, frame: Frame) -> None:
        """Hand on the next picture; wait while too many are waiting.

        An encoder that has answered all it was asked needs the next before it is done with others.
        """
        while len(self._lent) >= self._most and self._worker.owes:
            for place in self._worker.hear():
                del self._lent[[at for at, _ in self._lent].index(place)]
        place, pixels = _shared(frame.pixels, self._film)
        self._lent.append((place, pixels))
        self._worker.send(Picture(frame.index, place))

    def moment(self, moment: Moment) -> None:
        """Pictures have no use for it."""

    def finish(self) -> None:
        """Let the worker finish; it may then be used for another film."""
        self._worker.send(Finish())
        while self._worker.owes:
            self._worker.hear()
        self._lent.clear()
        self._finished = True
        _idle.append(self._worker)

    def abandon(self) -> None:
        """End the worker, whatever it is doing; one that has finished is free for others."""
        if not self._finished:
            self._worker.end()


class WorkerProcess:
    """A process that carries out requests, and sees the memory of pictures."""

    def __init__(self, module: str) -> None:
        """Start it, ready for the encoders of `module`; raises OSError."""
        memory = _memory().descriptor
        self._process = start(
            "app.outputs.worker",
            str(memory),
            module,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=None,
            pass_fds=(memory,),
        )
        self.owes = 0
        """Answers that are still to come."""

    @property
    def lives(self) -> bool:
        """Whether it has not ended."""
        return self._process.poll() is None

    def send(self, request: Request) -> None:
        """Ask for something; raises OSError if the process has ended."""
        assert self._process.stdin is not None
        try:
            pickle.dump(request, self._process.stdin)
            self._process.stdin.flush()
        except BrokenPipeError:
            raise self._has_ended() from None
        self.owes += 1

    def hear(self) -> list[int]:
        """Wait for the next answer: places whose pictures are not needed any more.

        Raises what failed, or OSError if the process has ended.
        """
        assert self._process.stdout is not None
        try:
            answer: Answer = pickle.load(self._process.stdout)
        except EOFError:
            raise self._has_ended() from None
        self.owes -= 1
        if answer.failure is not None:
            raise answer.failure
        return answer.done_with

    def end(self) -> None:
        """End it at once."""
        self._process.kill()
        self.leave()

    def leave(self) -> None:
        """Let it end, which it does when its input ends."""
        with suppress(BrokenPipeError), self._process:  # closes its streams, and waits
            pass

    def _has_ended(self) -> OSError:
        code = self._process.wait()
        return OSError(f"the process that encodes it has ended ({code})")


@cache
def _memory() -> Memory:
    """What all workers of this process see."""
    return Memory()


def new_pixels(shape: tuple[int, int]) -> Pixels:
    """A picture of (height, width) with anything in it, where workers see it if that can be."""
    if AVAILABLE:
        with suppress(OSError):
            return _memory().new(shape)
    return np.empty(shape, np.uint32)


def _shared(pixels: Pixels, film: Film) -> tuple[int, Pixels]:
    """Where workers see this picture of a film, or a copy of it, and what keeps it there.

    Raises OSError, and ValueError for a picture of another size.
    """
    memory, shape = _memory(), (film.height, film.width)
    place = memory.place(pixels) if pixels.shape == shape else None
    if place is not None:
        return place, pixels
    copy = memory.new(shape)
    copy[:] = pixels
    copy.flags.writeable = False
    place = memory.place(copy)
    assert place is not None
    return place, copy


_idle: list[WorkerProcess] = []
"""Workers without a film."""


def _any_worker(module: str) -> WorkerProcess:
    """One that is idle, or a new one; raises OSError."""
    while _idle:
        worker = _idle.pop()
        if worker.lives:
            return worker
        worker.leave()
    return WorkerProcess(module)


def prepare_workers(modules: Sequence[str]) -> None:
    """Start workers for the encoders of these modules, which takes them a moment."""
    with suppress(OSError):  # told to whoever asks for one
        _idle.extend(WorkerProcess(module) for module in modules[len(_idle) :])


@atexit.register
def dismiss_workers() -> None:
    """Let those end that have no film."""
    while _idle:
        _idle.pop().leave()


# A forked process may not talk to the workers of the one it comes from, nor paint in its memory.
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_idle.clear)
    os.register_at_fork(after_in_child=_memory.cache_clear)
