"""The process that encodes pictures, while another simulates and draws the next ones.

    python -m app.outputs.worker DESCRIPTOR MODULE

Requests come in on its standard input and are answered one by one on its standard output. Pictures
lie in memory that both processes share, under the descriptor.
The module is that of the first encoder that will be asked for. The process ends when its input
does, however the other one ended. See `remote.py`.
"""

import importlib
import os
import pickle
import sys
import traceback
from collections.abc import Iterator
from contextlib import suppress
from typing import BinaryIO

from app.frames import Frame
from app.outputs.kept import Encoder
from app.outputs.promise import OutputError
from app.outputs.remote import Answer, Begin, Picture, Request
from app.outputs.shared import Lender


class Worker:
    """Carries out requests; once something failed it only says so again."""

    def __init__(self, memory: int) -> None:
        """`memory` is the descriptor of the shared memory."""
        self._memory = memory
        self._failure: Exception | None = None
        self._pictures: Lender | None = None
        self._encoder: Encoder

    def serve(self, requests: BinaryIO, replies: BinaryIO) -> None:
        """Carry out all requests, and answer each."""
        for request in _each(requests):
            if self._failure is None:
                try:
                    self._carry_out(request)
                except Exception as error:  # noqa: BLE001 - whoever asked is told
                    self._failure = _portable(error)
            done_with = self._pictures.given_back() if self._pictures is not None else []
            pickle.dump(Answer(self._failure, done_with), replies)
            replies.flush()

    def _carry_out(self, request: Request) -> None:
        if isinstance(request, Picture):
            assert self._pictures is not None
            self._encoder.frame(Frame(request.number, self._pictures.lend(request.place)))
        elif isinstance(request, Begin):
            self._pictures = Lender(self._memory, request.film)
            make = getattr(importlib.import_module(request.module), request.name)
            self._encoder = make(request.part, request.film)
        else:
            self._encoder.finish()


def _each(requests: BinaryIO) -> Iterator[Request]:
    """All requests, until the other process ends, in the middle of one or not."""
    while True:
        try:
            yield pickle.load(requests)
        except (EOFError, pickle.UnpicklingError):
            return


def _portable(error: Exception) -> Exception:
    """What says the same in another process."""
    if isinstance(error, OutputError):
        return error
    if isinstance(error, OSError):  # encoders have types of their own for it
        return OSError(error.errno, error.strerror) if error.errno else OSError(str(error))
    told = RuntimeError(f"{type(error).__name__}: {error}")
    told.add_note(traceback.format_exc())
    return told


def main() -> None:
    """Serve the process that started this one."""
    replies = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # what an encoder prints is no reply
    with suppress(ImportError):  # told to whoever asks for it
        importlib.import_module(sys.argv[2])
    Worker(int(sys.argv[1])).serve(sys.stdin.buffer, replies)


if __name__ == "__main__":
    main()
