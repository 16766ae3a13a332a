"""Same pictures, same bytes: twice in one process, and in processes with other surroundings."""

import hashlib
import os
import subprocess
import sys
from pathlib import Path

import pytest

from app.frames import Film, Frame, Pixels
from app.outputs import open_sink

NAMES = ("film.mp4", "film.webm", "film.gif", "film.apng", "film.webp", "frames/")

CODE = f"""
import sys
sys.path.insert(0, {str(Path(__file__).parent)!r})
from conftest import FPS, HEIGHT, WIDTH, picture
from app.frames import Film, Frame
from app.outputs import open_sink
for name in {NAMES!r}:
    film = Film(WIDTH, HEIGHT, FPS, "A disc", "A disc moves to the right.")
    sink = open_sink(sys.argv[1] + "/" + name, film)
    for number in range(40):
        sink.frame(Frame(number, picture(number - (number % 4 == 3))))
    sink.close()
"""


def digests(folder: Path) -> dict[str, str]:
    files = sorted(path for path in folder.rglob("*") if path.is_file())
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in files
    }


def test_twice_here_and_twice_elsewhere(tmp_path: Path, film: Film, pictures: list[Pixels]) -> None:
    pytest.importorskip("av")
    for run in ("one", "two"):
        for name in NAMES:
            sink = open_sink(f"{tmp_path}/{run}/{name}", film)
            for index, pixels in enumerate(pictures):
                sink.frame(Frame(index, pixels))
            sink.close()
    for run, seed, locale, zone in (
        ("three", "1", "C", "UTC"),
        ("four", "2", "de_DE.UTF-8", "Asia/Tokyo"),
    ):
        (tmp_path / f"cwd-{run}").mkdir()
        surroundings = {"PYTHONHASHSEED": seed, "LC_ALL": locale, "LANG": locale, "TZ": zone}
        subprocess.run(
            [sys.executable, "-c", CODE, str(tmp_path / run)],
            cwd=tmp_path / f"cwd-{run}",
            env={**os.environ, **surroundings},
            check=True,
        )
    first = digests(tmp_path / "one")
    assert len(first) == 5 + 40
    for run in ("two", "three", "four"):
        assert digests(tmp_path / run) == first
