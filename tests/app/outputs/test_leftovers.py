"""Unfinished files of killed runs go; those that somebody still writes stay."""

import signal
import subprocess
import sys
from pathlib import Path

import pytest

from app.outputs import leftovers
from app.outputs.promise import Promise

BEGIN = """
import sys
sys.path[:0] = {path!r}
from app.outputs.promise import Promise
promise = Promise({target!r}, folder={folder!r})
(promise.part / "frame-00001.png" if {folder!r} else promise.part).write_bytes(b"half")
print("begun", flush=True)
sys.stdin.read()
"""

pytestmark = pytest.mark.skipif(leftovers.lock is None, reason="the system has no such locks")


def begin(target: Path, folder: bool) -> subprocess.Popen[str]:
    """A process that has begun to write, and waits."""
    code = BEGIN.format(path=sys.path, target=str(target), folder=folder)
    run = subprocess.Popen(
        [sys.executable, "-c", code], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    assert run.stdout is not None
    assert run.stdout.readline() == "begun\n"
    return run


def parts(folder: Path) -> list[str]:
    return sorted(entry.name for entry in folder.iterdir() if entry.name.endswith(".part"))


@pytest.mark.parametrize("folder", [False, True], ids=["file", "folder"])
def test_what_a_killed_run_left_is_removed_but_not_what_is_being_written(
    tmp_path: Path, folder: bool
) -> None:
    target = tmp_path / "film.gif"
    with begin(target, folder) as dead, begin(target, folder) as alive:
        assert len(parts(tmp_path)) == 2
        dead.send_signal(signal.SIGKILL)
        dead.wait()
        other = Promise(tmp_path / "other.gif")
        assert len(parts(tmp_path)) == 3
        own = Promise(target, folder=folder)
        left = parts(tmp_path)
        assert len(left) == 3
        assert not any(f".{dead.pid}." in name for name in left)
        assert any(f".{alive.pid}." in name for name in left)
        for promise in (own, other):
            promise.drop()
        alive.communicate("")
    assert parts(tmp_path) == [name for name in left if f".{alive.pid}." in name]


def test_only_parts_of_the_same_name_are_looked_at(tmp_path: Path) -> None:
    names = [".film.gif.12.part.txt", ".film.gif.old", ".film.gif.12.old", ".film.gift.12.part"]
    names += ["film.gif.12.part", ".film.gif.x.part"]
    for name in names:
        (tmp_path / name).write_bytes(b"mine")
    (tmp_path / "far").write_bytes(b"mine")
    (tmp_path / ".film.gif.12.part").symlink_to(tmp_path / "far")
    (tmp_path / ".film.gif.13.2.part").write_bytes(b"left")
    Promise(tmp_path / "film.gif").drop()
    kept = sorted([*names, "far", ".film.gif.12.part"])
    assert sorted(entry.name for entry in tmp_path.iterdir()) == kept


def test_without_locks_nothing_is_removed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(descriptor: int) -> None:
        raise OSError("no locks on this disk")

    (tmp_path / ".film.gif.13.part").write_bytes(b"left")
    for lock in (None, refuse):
        monkeypatch.setattr(leftovers, "lock", lock)
        promise = Promise(tmp_path / "film.gif")
        promise.keep()
        assert parts(tmp_path) == [".film.gif.13.part"]
