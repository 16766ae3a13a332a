"""Starts a second Python that runs a module of ours, with the packages that this one has."""

import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import IO

Stream = IO[bytes] | int | None
"""What a stream of a process may be, as `subprocess` wants it."""


def start(
    module: str,
    *arguments: str,
    stdin: Stream = subprocess.DEVNULL,
    stdout: Stream = subprocess.DEVNULL,
    stderr: Stream = subprocess.DEVNULL,
    pass_fds: Sequence[int] = (),
) -> subprocess.Popen[bytes]:
    """Run `python -m module`, out of reach of this terminal's Ctrl-C; raises OSError."""
    root = Path(__file__).parents[1]
    path = [str(root), *(entry for entry in sys.path if os.path.isabs(entry))]
    return subprocess.Popen(
        [sys.executable, "-W", "ignore", "-m", module, *arguments],
        stdin=stdin,
        stdout=stdout,
        stderr=stderr,
        cwd=root,
        env=os.environ | {"PYTHONPATH": os.pathsep.join(path)},
        start_new_session=True,
        pass_fds=pass_fds,
    )
