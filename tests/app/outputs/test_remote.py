import os
import signal
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest

from app.frames import Film, Frame, Pixels, Sink
from app.outputs import OutputError, open_sink, remote
from app.outputs.remote import Remote
from app.outputs.shared import MOST
from screens.kit import theme
from screens.kit.surface import Surface

pytestmark = pytest.mark.usefixtures("no_idle_workers")

FORMATS = ("film.mp4", "film.webm", "film.gif", "film.apng", "film.webp", "frames/")


def shoot(sink: Sink, pictures: list[Pixels]) -> None:
    for number, pixels in enumerate(pictures):
        sink.frame(Frame(number, pixels))


def remaining(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def contents(path: Path) -> list[bytes]:
    files = sorted(path.iterdir()) if path.is_dir() else [path]
    return [file.read_bytes() for file in files]


def begun(target: Path, film: Film) -> tuple[Sink, int]:
    """A film with one picture, and the process id of its worker."""
    sink = open_sink(target, film, remote=True)
    sink.frame(Frame(0, np.zeros((film.height, film.width), np.uint32)))
    return sink, sink._encoder._worker._process.pid  # type: ignore[attr-defined]


@pytest.mark.parametrize("name", FORMATS)
def test_a_worker_writes_the_same_bytes(
    tmp_path: Path, film: Film, pictures: list[Pixels], name: str
) -> None:
    if name in ("film.mp4", "film.webm"):
        pytest.importorskip("av")
    for where in ("here", "there"):
        sink = open_sink(f"{tmp_path}/{where}/{name}", film, remote=where == "there")
        shoot(sink, pictures)
        sink.close()
    assert contents(tmp_path / "here" / name) == contents(tmp_path / "there" / name)


def test_what_was_handed_over_may_change_at_once(
    tmp_path: Path, film: Film, pictures: list[Pixels]
) -> None:
    kept, used_again = tmp_path / "kept.gif", tmp_path / "used-again.gif"
    sink = open_sink(kept, film)
    shoot(sink, pictures)
    sink.close()
    sink = open_sink(used_again, film, remote=True)
    memory = np.empty_like(pictures[0])
    for number, pixels in enumerate(pictures):
        memory[:] = pixels
        sink.frame(Frame(number, memory))
    sink.close()
    assert kept.read_bytes() == used_again.read_bytes()


def test_what_is_painted_where_workers_see_it_is_not_copied() -> None:
    surface, held = Surface(72, 128, remote.new_pixels), []
    for shade in range(6):
        surface.static(shade % 2, lambda page: page.fill(theme.CANVAS))
        surface.circle((40, 40), 10, (shade, shade, shade))
        held.append(surface.pixels())
        surface.circle((60, 60), 10, (shade, shade, shade))  # on a copy
        held.append(surface.pixels())
    places = [remote._memory().place(pixels) for pixels in held]
    assert None not in places
    assert len(set(places)) == len(held)


def test_a_worker_serves_film_after_film_of_any_size(tmp_path: Path) -> None:
    used = set()
    for number, (width, height) in enumerate([(64, 48), (320, 200), (16, 16)]):
        film = Film(width, height, 30, f"Film {number}")
        pictures = [np.full((height, width), 0x10101 * shade, np.uint32) for shade in range(9)]
        for where in ("here", "there"):
            sink = open_sink(f"{tmp_path}/{where}.gif", film, remote=where == "there")
            shoot(sink, pictures)
            sink.close()
        used.add(remote._idle[0])
        assert (tmp_path / "here.gif").read_bytes() == (tmp_path / "there.gif").read_bytes()
    assert len(used) == 1


def test_two_films_at_once_have_a_worker_each(
    tmp_path: Path, film: Film, pictures: list[Pixels]
) -> None:
    sinks = [open_sink(tmp_path / f"{name}.gif", film, remote=True) for name in "ab"]
    for number, pixels in enumerate(pictures):
        for sink in sinks:
            sink.frame(Frame(number, pixels))
    for sink in sinks:
        sink.close()
    assert len(remote._idle) == 2
    assert (tmp_path / "a.gif").read_bytes() == (tmp_path / "b.gif").read_bytes()


def test_a_film_that_vanished_leaves_its_worker_to_others(tmp_path: Path, film: Film) -> None:
    sink, _ = begun(tmp_path / "film.gif", film)
    for part in tmp_path.iterdir():
        part.unlink()
    with pytest.raises(OutputError, match="the file vanished"):
        sink.close()
    sink, _ = begun(tmp_path / "film.gif", film)
    sink.close()
    assert remaining(tmp_path) == ["film.gif"]


def test_prepared_workers_are_used(tmp_path: Path, film: Film) -> None:
    remote.prepare_workers(["app.outputs.gif"])
    remote.prepare_workers(["app.outputs.apng"])
    (prepared,) = remote._idle
    sink, pid = begun(tmp_path / "a.gif", film)
    assert pid == prepared._process.pid
    sink.close()


def test_a_worker_that_ended_while_it_was_idle_is_not_used(tmp_path: Path, film: Film) -> None:
    remote.prepare_workers(["app.outputs.gif"])
    (prepared,) = remote._idle
    prepared._process.kill()
    prepared._process.wait()
    sink, pid = begun(tmp_path / "a.gif", film)
    assert pid != prepared._process.pid
    sink.close()


def test_what_an_encoder_refuses_at_first_is_told_at_once(tmp_path: Path, film: Film) -> None:
    part = tmp_path / "no such folder" / "part"
    with pytest.raises(OSError, match="No such file or directory"):
        Remote("app.outputs.gif", "Gif", part, film)
    with pytest.raises(RuntimeError, match=r"AttributeError: .* 'Nothing'") as error:
        Remote("app.outputs.gif", "Nothing", part, film)
    assert "Traceback" in error.value.__notes__[0]


def test_a_failure_comes_out_of_a_later_call(
    tmp_path: Path, film: Film, pictures: list[Pixels]
) -> None:
    target = tmp_path / "film.gif"
    target.write_bytes(b"old")
    sink, _ = begun(target, film)
    sink.frame(Frame("one", pictures[1]))  # type: ignore[arg-type]
    with pytest.raises(RuntimeError, match="TypeError"):
        shoot(sink, pictures[: MOST + 1])
    sink.abort()
    assert remaining(tmp_path) == ["film.gif"]
    assert target.read_bytes() == b"old"


def test_a_failure_in_the_last_picture_comes_out_of_close(
    tmp_path: Path, film: Film, pictures: list[Pixels]
) -> None:
    sink, _ = begun(tmp_path / "film.gif", film)
    sink.frame(Frame("one", pictures[1]))  # type: ignore[arg-type]
    with pytest.raises(RuntimeError, match="TypeError"):
        sink.close()
    assert remaining(tmp_path) == []


def test_aborting_leaves_nothing_and_no_worker(tmp_path: Path, film: Film) -> None:
    sink, pid = begun(tmp_path / "film.gif", film)
    sink.abort()
    assert remaining(tmp_path) == []
    assert not Path(f"/proc/{pid}").exists()
    assert remote._idle == []


@pytest.mark.parametrize("count", [0, 40])
def test_a_worker_that_is_killed_is_told_in_a_sentence(
    tmp_path: Path, film: Film, pictures: list[Pixels], count: int
) -> None:
    target = tmp_path / "film.gif"
    target.write_bytes(b"old")
    sink, pid = begun(target, film)

    def go_on() -> None:
        shoot(sink, pictures[:count])
        sink.close()

    os.kill(pid, signal.SIGKILL)
    with pytest.raises(OutputError, match=r"film\.gif: the process that encodes it has ended"):
        go_on()
    sink.abort()
    assert remaining(tmp_path) == ["film.gif"]
    assert target.read_bytes() == b"old"


def test_a_worker_ends_when_who_started_it_is_killed(tmp_path: Path) -> None:
    code = (
        "import sys, numpy, time\n"
        "from app.frames import Film, Frame\n"
        "from app.outputs import open_sink\n"
        "sink = open_sink(sys.argv[1], Film(64, 48, 30, 'Film'), remote=True)\n"
        "sink.frame(Frame(0, numpy.zeros((48, 64), numpy.uint32)))\n"
        "print(sink._encoder._worker._process.pid, flush=True)\n"
        "time.sleep(60)\n"
    )
    parent = subprocess.Popen(
        [sys.executable, "-c", code, f"{tmp_path}/film.gif"], stdout=subprocess.PIPE
    )
    assert parent.stdout is not None
    child = int(parent.stdout.readline())
    parent.kill()
    parent.stdout.close()
    parent.wait()
    with suppress(FileNotFoundError):
        for _ in range(200):
            # Whoever adopts it may not have asked yet how it ended.
            if Path(f"/proc/{child}/stat").read_text().rsplit(")", 1)[1].split()[0] == "Z":
                break
            subprocess.run(["sleep", "0.05"], check=True)
        else:
            pytest.fail("the worker goes on")


def test_a_forked_process_uses_workers_of_its_own() -> None:
    code = (
        "import os, sys\n"
        "from app.outputs import remote\n"
        "remote.prepare_workers(['app.outputs.gif'])\n"
        "assert len(remote._idle) == 1\n"
        "if (child := os.fork()) == 0:\n"
        "    os._exit(len(remote._idle) + remote._memory.cache_info().currsize)\n"
        "sys.exit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))\n"
    )
    assert subprocess.run([sys.executable, "-W", "ignore", "-c", code], check=False).returncode == 0
