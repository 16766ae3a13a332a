import errno
import os
from pathlib import Path

import pytest

from app.outputs.promise import OutputError, Promise, check_place, explained, promised


def names(folder: Path) -> list[str]:
    return sorted(entry.name for entry in folder.iterdir())


def test_nothing_stands_under_the_name_before_it_is_kept(tmp_path: Path) -> None:
    promise = Promise(tmp_path / "film.gif")
    promise.part.write_bytes(b"whole")
    assert not (tmp_path / "film.gif").exists()
    assert promise.part.parent == tmp_path
    assert promise.part.name.startswith(".film.gif.")
    promise.keep()
    assert names(tmp_path) == ["film.gif"]
    assert (tmp_path / "film.gif").read_bytes() == b"whole"


def test_what_stood_there_stays_when_it_is_dropped(tmp_path: Path) -> None:
    (tmp_path / "film.gif").write_bytes(b"old")
    promise = Promise(tmp_path / "film.gif")
    promise.part.write_bytes(b"half")
    promise.drop()
    promise.drop()
    assert names(tmp_path) == ["film.gif"]
    assert (tmp_path / "film.gif").read_bytes() == b"old"


def test_missing_folders_are_made_and_go_again(tmp_path: Path) -> None:
    promise = Promise(tmp_path / "a" / "b" / "film.gif")
    assert (tmp_path / "a" / "b").is_dir()
    promise.drop()
    assert names(tmp_path) == []
    kept = Promise(tmp_path / "a" / "b" / "film.gif")
    kept.keep()
    assert (tmp_path / "a" / "b" / "film.gif").exists()


def test_folders_that_others_use_by_now_stay(tmp_path: Path) -> None:
    promise = Promise(tmp_path / "out" / "one.gif")
    other = Promise(tmp_path / "out" / "two.gif")
    other.keep()
    promise.drop()
    assert names(tmp_path / "out") == ["two.gif"]


def test_two_promises_of_one_name_do_not_mix(tmp_path: Path) -> None:
    one, two = Promise(tmp_path / "film.gif"), Promise(tmp_path / "film.gif")
    assert one.part != two.part
    two.part.write_bytes(b"two")
    one.drop()
    two.keep()
    assert (tmp_path / "film.gif").read_bytes() == b"two"


def test_a_link_is_followed(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "link.gif").symlink_to(tmp_path / "real" / "film.gif")
    promise = Promise(tmp_path / "link.gif")
    promise.part.write_bytes(b"whole")
    promise.keep()
    assert (tmp_path / "link.gif").is_symlink()
    assert (tmp_path / "real" / "film.gif").read_bytes() == b"whole"


def test_a_folder_of_frames_replaces_an_old_one(tmp_path: Path) -> None:
    old = tmp_path / "frames"
    old.mkdir()
    for number in range(1, 4):
        (old / f"frame-{number:05d}.png").write_bytes(b"old")
    promise = Promise(old, folder=True)
    (promise.part / "frame-00001.png").write_bytes(b"new")
    assert len(names(old)) == 3
    promise.keep()
    assert names(old) == ["frame-00001.png"]
    assert names(tmp_path) == ["frames"]


def test_a_folder_of_something_else_is_not_replaced(tmp_path: Path) -> None:
    (tmp_path / "thesis").mkdir()
    (tmp_path / "thesis" / "chapter.tex").write_text("years of work")
    with pytest.raises(OutputError, match=r"'chapter\.tex', which is not a frame"):
        Promise(tmp_path / "thesis", folder=True)
    assert names(tmp_path) == ["thesis"]


def test_a_file_that_came_into_the_folder_meanwhile_is_not_lost(tmp_path: Path) -> None:
    promise = Promise(tmp_path / "frames", folder=True)
    (tmp_path / "frames").mkdir()
    (tmp_path / "frames" / "notes.txt").write_text("mine")
    with pytest.raises(OutputError, match="not a frame"):
        promise.keep()
    assert (tmp_path / "frames" / "notes.txt").read_text() == "mine"
    assert names(tmp_path) == ["frames"]


def test_a_failed_swap_puts_the_old_folder_back(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    old = tmp_path / "frames"
    old.mkdir()
    (old / "frame-00001.png").write_bytes(b"old")
    promise = Promise(old, folder=True)
    rename = Path.rename

    def refuse_parts(self: Path, target: Path) -> Path:
        if self.name.endswith(".part"):
            raise OSError(errno.EACCES, "no")
        return rename(self, target)

    monkeypatch.setattr(Path, "rename", refuse_parts)
    with pytest.raises(OutputError, match="does not let you write"):
        promise.keep()
    assert names(tmp_path) == ["frames"]
    assert (old / "frame-00001.png").read_bytes() == b"old"


@pytest.mark.parametrize(
    ("name", "folder", "sentence"),
    [
        ("folder", False, "it is a folder"),
        ("file", True, "it is a file, not a folder of frames"),
        ("file/film.gif", False, "file"),
        ("pipe", False, "not a regular file"),
        ("x" * 300 + ".gif", False, "name is too long"),
    ],
)
def test_places_that_cannot_be_written(
    tmp_path: Path, name: str, folder: bool, sentence: str
) -> None:
    (tmp_path / "folder").mkdir()
    (tmp_path / "file").write_text("")
    os.mkfifo(tmp_path / "pipe")
    for attempt in (check_place, Promise):
        with pytest.raises(OutputError, match=sentence) as caught:
            attempt(tmp_path / name, folder=folder)
        assert str(tmp_path / name) in str(caught.value)
    assert names(tmp_path) == ["file", "folder", "pipe"]


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_that_may_not_be_written(tmp_path: Path) -> None:
    (tmp_path / "locked").mkdir(mode=0o500)
    with pytest.raises(OutputError, match="does not let you write"):
        check_place(tmp_path / "locked" / "film.gif")


def test_a_place_without_permission_is_found_before_anything_is_made(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(os, "access", lambda *_: False)
    with pytest.raises(OutputError, match="does not let you write in"):
        Promise(tmp_path / "a" / "film.gif")
    assert names(tmp_path) == []


def test_an_error_without_a_sentence_of_ours_keeps_the_systems() -> None:
    with pytest.raises(OutputError, match="Input/output error"), explained("film.gif"):
        raise OSError(errno.EIO, "Input/output error")


def test_a_file_that_cannot_be_written_leaves_nothing(tmp_path: Path) -> None:
    def write() -> None:
        with promised(tmp_path / "new/a") as part:
            part.write_text("half")
            raise OSError(errno.ENOSPC, "No space left on device")

    with pytest.raises(OutputError, match="the disk is full"):
        write()
    assert list(tmp_path.iterdir()) == []
