"""Where machine code is kept: one process writes it at a time, and says when it is whole."""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

if sys.platform != "win32":
    import fcntl

BESIDE = Path(__file__).parent / "__pycache__"
"""Where numba keeps it if that can be written; else in a folder of the user."""


@contextmanager
def alone(folder: Path) -> Iterator[None]:
    """Wait until no other process compiles into a folder, and keep others waiting meanwhile.

    The lock ends with the process, however that ends. On Windows, and in folders that cannot be
    written, nobody waits: two processes then do the same work, and one of the results stays.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        lock = os.open(folder / "laws-kernels.lock", os.O_RDWR | os.O_CREAT, 0o666)
    except OSError:
        yield
        return
    try:
        if sys.platform != "win32":
            fcntl.flock(lock, fcntl.LOCK_EX)
        yield
    finally:
        os.close(lock)


def mark(folder: Path, key: str) -> None:
    """Note that the code with this key is whole; do nothing where the folder cannot be written."""
    try:
        _mark_of(folder, key).touch()
    except OSError:
        return


def is_marked(folder: Path, key: str) -> bool:
    """Whether the code with this key is there."""
    return _mark_of(folder, key).is_file() and any(folder.glob("pointers.*.nbi"))


def _mark_of(folder: Path, key: str) -> Path:
    return folder / f"laws-kernels-{key[:32]}.ready"
