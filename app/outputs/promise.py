"""A promised file: written beside its name, renamed when whole; nothing half done is seen."""

import errno
import os
import re
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from app.outputs import leftovers

FRAME_NAME = re.compile(r"frame-\d{5,}\.png")
"""What a folder may hold and still be replaced: only frames of ours."""

_REASONS = {
    errno.ENOSPC: "the disk is full",
    errno.EDQUOT: "the disk quota is used up",
    errno.EFBIG: "the file would be larger than the system allows",
    errno.EACCES: "the system does not let you write there",
    errno.EPERM: "the system does not let you write there",
    errno.EROFS: "that disk can only be read",
    errno.ENAMETOOLONG: "the name is too long",
    errno.ENOTDIR: "a part of its path is a file, not a folder",
}


class OutputError(Exception):
    """A promised output cannot be made: one sentence for whoever asked for it."""

    def __init__(self, path: str | os.PathLike[str], sentence: str) -> None:
        super().__init__(f"cannot write {os.fspath(path)}: {sentence}")
        self.path = os.fspath(path)
        """As it was asked for."""
        self.sentence = sentence

    def __reduce__(self) -> tuple[type["OutputError"], tuple[str, str]]:
        """To be handed from one process to another."""
        return OutputError, (self.path, self.sentence)


@contextmanager
def explained(path: str | os.PathLike[str]) -> Iterator[None]:
    """Turn what the system refuses inside into an OutputError about `path`."""
    try:
        yield
    except OSError as error:
        reason = _REASONS.get(error.errno or 0) or error.strerror or str(error)
        raise OutputError(path, reason) from error


def check_place(path: str | os.PathLike[str], *, folder: bool = False) -> None:
    """Refuse a place where nothing could be written; touch nothing.

    A missing folder is fine if it can be made. OutputError says what is wrong.
    """
    with explained(path):
        target = Path(os.path.realpath(path))
        if target.name == "":
            raise OutputError(path, "this is not the name of a file")
        _check_target(path, target, folder)
        above = target.parent
        while not above.exists():
            above = above.parent
        if not above.is_dir():
            raise OutputError(path, f"{above} is a file, not a folder")
        if not os.access(above, os.W_OK | os.X_OK):
            raise OutputError(path, f"the system does not let you write in {above}")


def _check_target(path: str | os.PathLike[str], target: Path, folder: bool) -> None:
    if folder:
        if target.exists() and not target.is_dir():
            raise OutputError(path, "it is a file, not a folder of frames")
        if target.is_dir():
            for entry in sorted(os.listdir(target)):
                if not FRAME_NAME.fullmatch(entry):
                    raise OutputError(
                        path, f"the folder holds {entry!r}, which is not a frame; choose another"
                    )
    elif target.is_dir():
        raise OutputError(path, "it is a folder; for a folder of frames put a '/' after it")
    elif target.exists() and not target.is_file():
        raise OutputError(path, "it is not a regular file")


class Promise:
    """A file, or a folder of frames, in the making.

    It grows under a hidden name in the folder of its target (a rename across disks would copy);
    what killed runs left there is removed. `keep` gives it its name at once; `drop` leaves
    everything as it was before.
    """

    def __init__(self, path: str | os.PathLike[str], *, folder: bool = False) -> None:
        """Claim a place beside `path`; missing folders above it are made. Raises OutputError."""
        self.path = os.fspath(path)
        self._folder = folder
        self._made: list[Path] = []
        self._held: int | None = None
        check_place(path, folder=folder)
        self._target = Path(os.path.realpath(path))
        with explained(path):
            try:
                self._make_parents()
                leftovers.clear(self._target)
                self.part = self._claim()
                """Where to write until it is kept."""
            except OSError:
                self._remove_parents()
                raise

    def keep(self) -> None:
        """Give it its name, in place of what stood there. OutputError: nothing of it is kept."""
        try:
            with explained(self.path):
                _check_target(self.path, self._target, self._folder)
                if self._folder and self._target.is_dir():
                    self._swap_folders()
                else:
                    self.part.replace(self._target)
        except OutputError:
            self.drop()
            raise
        self._let_go()

    def drop(self) -> None:
        """Remove what was begun; calling it again, or after `keep`, does nothing."""
        if self._folder:
            shutil.rmtree(self.part, ignore_errors=True)
        else:
            with suppress(OSError):
                self.part.unlink()
        self._let_go()
        self._remove_parents()

    def _let_go(self) -> None:
        leftovers.let_go(self._held)
        self._held = None

    def _make_parents(self) -> None:
        missing = []
        above = self._target.parent
        while not above.exists():
            missing.append(above)
            above = above.parent
        for folder in reversed(missing):
            folder.mkdir(exist_ok=True)
            self._made.append(folder)

    def _remove_parents(self) -> None:
        for folder in reversed(self._made):
            with suppress(OSError):  # somebody else's file is in it by now
                folder.rmdir()
        self._made.clear()

    def _claim(self) -> Path:
        for attempt in range(1000):
            part = self._hidden(f"{attempt}.part" if attempt else "part")
            try:
                if self._folder:
                    part.mkdir()
                else:
                    part.touch(exist_ok=False)
                self._held = leftovers.hold(part)
            except FileExistsError:
                continue  # a second output of the same name
            return part
        raise FileExistsError(errno.EEXIST, "too many unfinished files lie beside it")

    def _hidden(self, ending: str) -> Path:
        return self._target.with_name(f".{self._target.name}.{os.getpid()}.{ending}")

    def _swap_folders(self) -> None:
        # No portable call exchanges two folders: between these two renames the name is free.
        old = self._hidden("old")
        self._target.rename(old)
        try:
            self.part.rename(self._target)
        except OSError:
            old.rename(self._target)
            raise
        shutil.rmtree(old, ignore_errors=True)


@contextmanager
def promised(path: str | os.PathLike[str]) -> Iterator[Path]:
    """Where to write a file that gets its name `path` at the end; OutputError if it cannot."""
    promise = Promise(path)
    try:
        with explained(path):
            yield promise.part
        promise.keep()
    finally:
        promise.drop()
