"""Where words go: results to stdout, words for people to stderr, whatever state these are in."""

import errno
import os
import sys
from typing import TextIO


def prepare() -> None:
    """Make both streams safe to write to: closed ones go nowhere, no character is too much."""
    _occupy_standard_descriptors()
    for name in ("stdout", "stderr"):
        stream: TextIO | None = getattr(sys, name)
        if stream is None:
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115
        elif hasattr(stream, "reconfigure"):
            encoding = stream.encoding if stream.isatty() else "utf-8"
            stream.reconfigure(encoding=encoding, errors="replace")


class ResultLost(Exception):
    """What a command found out could not be written; the sentence says why."""


def result(text: str) -> None:
    """Write a line to stdout; if nobody reads it any more, go on in silence.

    Raises:
        ResultLost: if it cannot be written, as on a full disk.
    """
    try:
        print(text, flush=True)  # noqa: T201
    except BrokenPipeError:
        _silence(sys.stdout)
    except OSError as error:
        _silence(sys.stdout)
        reason = "the disk is full" if error.errno == errno.ENOSPC else error.strerror
        raise ResultLost(f"cannot write the result to standard output: {reason}") from error


def say(text: str) -> None:
    """Write a line for people to stderr; a failure to do so is nobody's concern."""
    try:
        print(text, file=sys.stderr, flush=True)  # noqa: T201
    except OSError:
        _silence(sys.stderr)


def is_terminal() -> bool:
    """Whether a person watches stderr: a terminal that can redraw lines, and no build machine."""
    return sys.stderr.isatty() and os.environ.get("TERM") != "dumb" and not os.environ.get("CI")


def _silence(stream: TextIO) -> None:
    """Send the rest nowhere, so that nothing fails when the interpreter flushes at its end."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, stream.fileno())
    os.close(nowhere)


def _occupy_standard_descriptors() -> None:
    """Keep files that are opened later from becoming stdout or stderr if these are closed."""
    descriptor = os.open(os.devnull, os.O_RDWR)
    while descriptor <= 2:
        descriptor = os.open(os.devnull, os.O_RDWR)
    os.close(descriptor)
