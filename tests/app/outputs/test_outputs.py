import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from app.frames import Film, Frame
from app.outputs import SUFFIXES, OutputError, check_output, kind_of, open_sink


@pytest.mark.parametrize(
    ("path", "kind"),
    [
        ("out/film.mp4", "mp4"),
        ("film.WebM", "webm"),
        ("a.b/film.gif", "gif"),
        ("film.apng", "apng"),
        ("film.webp", "webp"),
        ("film.csv", "csv"),
        ("film.json", "json"),
        ("frames/", "png"),
        ("film.gif/", "png"),
        ("film.avi", None),
        ("film", None),
        (".gif", None),
        ("out.gif/film", None),
    ],
)
def test_kind_by_suffix(path: str, kind: str | None) -> None:
    assert kind_of(path) == kind


def test_the_check_imports_nothing_heavy() -> None:
    code = (
        "import sys; from app.outputs import check_output; check_output('x.mp4', (64, 48), 30);"
        "print([name for name in ('numpy', 'av', 'PIL', 'pygame', 'numba') if name in sys.modules])"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "[]"


@pytest.mark.parametrize(
    ("name", "size", "fps", "sentence"),
    [
        ("film.avi", (64, 48), 30, "its kind is not known"),
        ("film.mp4", (63, 48), 30, "even sides, not 63x48"),
        ("film.webm", (64, 47), 30, "even sides, not 64x47"),
        ("film.gif", (64, 48), 0, "0 frames per second"),
        ("film.webp", (20000, 48), 30, "16383"),
        ("film.gif", (70000, 48), 30, "65535"),
    ],
)
def test_refused_before_the_first_frame(
    tmp_path: Path, name: str, size: tuple[int, int], fps: int, sentence: str
) -> None:
    with pytest.raises(OutputError, match=sentence):
        check_output(tmp_path / name, size, fps)
    with pytest.raises(OutputError, match=sentence):
        open_sink(tmp_path / name, Film(*size, fps, "Film"))
    assert list(tmp_path.iterdir()) == []


def test_a_missing_extra_names_the_command(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    with pytest.raises(OutputError, match=r'pip install "laws-of-motion\[video\]"'):
        open_sink(tmp_path / "film.mp4", Film(64, 48, 30, "Film"))


def test_a_report_is_no_film(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match="report"):
        open_sink(tmp_path / "film.json", Film(64, 48, 30, "Film"))


FILMS = [f"film{suffix}" for suffix in SUFFIXES if suffix not in (".json", ".csv")] + ["frames/"]


@pytest.mark.parametrize("name", FILMS)
def test_aborted_films_leave_nothing(tmp_path: Path, film: Film, name: str) -> None:
    sink = open_sink(f"{tmp_path}/{name}", film)
    for index in range(5):
        sink.frame(Frame(index, np.full((film.height, film.width), index, np.uint32)))
    sink.abort()
    sink.abort()
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", FILMS)
def test_a_film_without_pictures_is_an_error(tmp_path: Path, film: Film, name: str) -> None:
    sink = open_sink(f"{tmp_path}/{name}", film)
    with pytest.raises(OutputError, match="no picture"):
        sink.close()
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", FILMS)
def test_abort_after_close_keeps_the_film(tmp_path: Path, film: Film, name: str) -> None:
    sink = open_sink(f"{tmp_path}/{name}", film)
    sink.frame(Frame(0, np.zeros((film.height, film.width), np.uint32)))
    sink.close()
    sink.abort()
    assert [entry.name for entry in tmp_path.iterdir()] == [name.rstrip("/")]
