"""Compiles the kernels while others wait for nothing: in a process of its own, into the cache.

`python -m engine.warming` is that process. It is in no hurry, says nothing, and may outlive the one
that started it: what it leaves in the cache serves the next.
"""

import atexit
import os
import subprocess
import sys
from functools import cache

from engine import jit
from engine.modes import Kernels
from engine.own_process import start

UNKEPT = 3
"""Exit code: the code could not be kept."""

BROKEN = 2
"""Exit code: numba is missing or broken."""


class Background:
    """At most one compiling process, and whether it is ready."""

    def __init__(self) -> None:
        """Start nothing yet."""
        self._child: subprocess.Popen[bytes] | None = None
        self._hopeless = not jit.available()

    def kernels(self) -> Kernels | None:
        """The compiled kernels once they can be had at once; None: not yet, or never."""
        if self._hopeless:
            return None
        try:
            if jit.is_ready() or self._is_done():
                return jit.compiled()
            if self._child is None:
                self._start()
        except (ImportError, OSError):
            self._hopeless = True
        return None

    def _is_done(self) -> bool:
        if self._child is None:
            return False
        code = self._child.poll()
        if code is not None and code != 0:
            self._hopeless = True
        return code == 0

    def _start(self) -> None:
        self._child = start("engine.warming")
        atexit.register(self._leave)

    def _leave(self) -> None:
        """At the end of this process: the other goes on by itself, which is no leak."""
        if self._child is not None and self._child.poll() is None:
            self._child.returncode = 0


@cache
def background() -> Background:
    """The compiling process of this process."""
    return Background()


def main() -> int:
    """Compile into the cache, politely; return an exit code."""
    if hasattr(os, "nice"):
        os.nice(10)
    try:
        if jit.folder() is None:
            return UNKEPT
        jit.compiled()
    except ImportError:
        return BROKEN
    return 0


if __name__ == "__main__":
    sys.exit(main())
