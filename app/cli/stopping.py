"""Ctrl-C, a polite kill, a closed terminal: they unwind the run, and no unfinished file is left."""

import signal
import sys
from types import FrameType

SIGNALS = [signal.SIGINT, signal.SIGTERM]
if sys.platform != "win32":
    SIGNALS.append(signal.SIGHUP)


class Stopped(BaseException):
    """Somebody wants the program to end; nobody but `main` may catch it."""

    def __init__(self, number: int) -> None:
        """`number` of the signal."""
        super().__init__(number)
        self.exit_code = 128 + number


class Wish:
    """Whether somebody wants this process to end."""

    def __init__(self) -> None:
        """Nobody does."""
        self._number: int | None = None

    def heed_signals(self) -> None:
        """From here on a signal raises Stopped, once; while things are put away, more do nothing.

        Signals that were ignored before, as under nohup, stay so.
        """
        sys.unraisablehook = _tell_faults
        for number in SIGNALS:
            if signal.getsignal(number) is not signal.SIG_IGN:
                signal.signal(number, self._stop)

    def insist(self) -> None:
        """Raise Stopped again if a signal came: what it raises in a callback goes nowhere."""
        if self._number is not None:
            raise Stopped(self._number)

    def _stop(self, number: int, frame: FrameType | None) -> None:
        for each in SIGNALS:
            signal.signal(each, signal.SIG_IGN)
        self._number = number
        raise Stopped(number)


def _tell_faults(unraisable: "sys.UnraisableHookArgs") -> None:
    """Say nothing of a stop that came within a callback or a destructor; `insist` raises it."""
    if not isinstance(unraisable.exc_value, Stopped):
        sys.__unraisablehook__(unraisable)


wish = Wish()
"""Of this process: it has its signals once."""
