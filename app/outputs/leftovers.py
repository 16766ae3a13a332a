"""What a killed run left: the next run that writes to the same name removes it.

Whoever writes a part holds a lock on it, which the system lets go when the process ends, however it
ends. A part that can be locked is nobody's any more. Where there are no such locks (Windows, some
network disks) nothing is removed.
"""

import os
import re
import shutil
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

try:
    from fcntl import LOCK_EX, LOCK_NB, flock
except ImportError:  # not on this system
    lock: Callable[[int], None] | None = None
else:

    def lock(descriptor: int) -> None:
        """Lock an open file or folder; raises OSError if somebody else holds it."""
        flock(descriptor, LOCK_EX | LOCK_NB)


def hold(part: Path) -> int | None:
    """Lock a part that was made just now; returns what `let_go` takes, None if there are no locks.

    Raises:
        FileExistsError: if somebody took it for a leftover in that moment.
    """
    try:
        descriptor = _locked(part)
        if descriptor is None or os.path.samestat(os.fstat(descriptor), part.stat()):
            return descriptor
        os.close(descriptor)
    except (BlockingIOError, FileNotFoundError):
        pass
    raise FileExistsError(part)


def let_go(descriptor: int | None) -> None:
    """End `hold`."""
    if descriptor is not None:
        os.close(descriptor)


def clear(target: Path) -> None:
    """Remove the unfinished files and folders of `target` that nobody writes any more."""
    name = re.compile(rf"\.{re.escape(target.name)}\.\d+\.(\d+\.)?part")
    with suppress(OSError):
        for entry in sorted(target.parent.iterdir()):
            if name.fullmatch(entry.name) and not entry.is_symlink():
                _remove_if_dead(entry)


def _remove_if_dead(part: Path) -> None:
    try:
        descriptor = _locked(part)
    except OSError:
        return
    if descriptor is None:
        return
    try:
        if part.is_dir():
            shutil.rmtree(part, ignore_errors=True)
        else:
            with suppress(OSError):
                part.unlink()
    finally:
        os.close(descriptor)


def _locked(part: Path) -> int | None:
    """A descriptor that holds the lock of a file or folder; None if there are no locks here.

    Raises:
        OSError: BlockingIOError if somebody else holds it.
    """
    if lock is None:
        return None
    descriptor = os.open(part, os.O_RDONLY | os.O_NOFOLLOW)
    try:
        lock(descriptor)
    except BlockingIOError:
        os.close(descriptor)
        raise
    except OSError:
        os.close(descriptor)
        return None
    return descriptor
