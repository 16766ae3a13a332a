"""Ctrl-C and a polite kill: both unwind the run, so that no unfinished file is left."""

import signal
from types import FrameType

SIGNALS = (signal.SIGINT, signal.SIGTERM)


class Stopped(BaseException):
    """Somebody wants the program to end; nobody but `main` may catch it."""

    def __init__(self, number: int) -> None:
        """`number` of the signal."""
        super().__init__(number)
        self.exit_code = 128 + number


def heed_signals() -> None:
    """From here on a signal raises Stopped, once; while things are put away, more do nothing."""
    for number in SIGNALS:
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, _stop)


def _stop(number: int, frame: FrameType | None) -> None:
    for each in SIGNALS:
        signal.signal(each, signal.SIG_IGN)
    raise Stopped(number)
