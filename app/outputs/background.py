"""Encode in another thread while the next frame is drawn."""

import sys
from collections import deque
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager

from app.frames import Frame, Moment, Sink

DEPTH = 4
"""Frames that may wait. More smooths nothing and costs memory: 3.7 MB each at 720x1280."""

TURN = 0.0002
"""How long a thread computes at most while another wants the interpreter (s). With Python's usual
0.005 an encoder that is done with a picture waits for half a frame before it gets the next."""


@contextmanager
def brief_turns() -> Iterator[None]:
    """Meanwhile threads take turns often."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(TURN)
    try:
        yield
    finally:
        sys.setswitchinterval(before)


class Background:
    """A `Sink` whose frames are handled by a thread of its own, in order.

    Encoders release the interpreter's lock, so drawing and encoding share two cores. What the inner
    sink raises comes out of the next call. Moments are handed on at once: the world moves on.
    """

    def __init__(self, sink: Sink, depth: int = DEPTH) -> None:
        self._sink = sink
        self._depth = depth
        self._waiting: deque[Future[None]] = deque()
        self._thread = ThreadPoolExecutor(max_workers=1, thread_name_prefix="laws-output")

    def frame(self, frame: Frame) -> None:
        """Queue the next picture; wait while the queue is full."""
        while self._waiting and (len(self._waiting) >= self._depth or self._waiting[0].done()):
            self._waiting.popleft().result()
        self._waiting.append(self._thread.submit(self._sink.frame, frame))

    def moment(self, moment: Moment) -> None:
        """Hand on the next state of the world, now and in the caller's thread."""
        self._sink.moment(moment)

    def close(self) -> None:
        """Wait for all frames, then finish the file; a failure leaves nothing behind."""
        try:
            while self._waiting:
                self._waiting.popleft().result()
        except BaseException:
            self.abort()
            raise
        self._thread.shutdown()
        self._sink.close()

    def abort(self) -> None:
        """Forget the waiting frames, wait for the one in work, drop the file."""
        self._thread.shutdown(wait=True, cancel_futures=True)
        self._waiting.clear()
        self._sink.abort()
