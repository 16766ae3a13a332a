"""A disk that fills up in the middle of a film: one sentence, no remains, the old file stands.

Each film is encoded by a process that may not write files over some size, which the system
refuses as it refuses a full disk: within a frame, or only when the last bytes are flushed.
"""

import resource
import subprocess
import sys
from pathlib import Path

import pytest

CODE = """
import resource, sys
import numpy as np
from app.frames import Film, Frame
from app.outputs import OutputError, open_sink
target, limit = sys.argv[1], int(sys.argv[2])
dice = np.random.default_rng(1)
sink = open_sink(target, Film(160, 120, 30, "Noise"), remote=True)
worker = sink._encoder._worker._process.pid
resource.prlimit(worker, resource.RLIMIT_FSIZE, (limit, limit))
try:
    try:
        for index in range(12):
            sink.frame(Frame(index, dice.integers(0, 1 << 24, (120, 160), np.uint32)))
        sink.close()
    except BaseException:
        sink.abort()
        raise
except OutputError as error:
    print(error)
    sys.exit(1)
"""


def run(target: str, limit: int) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", CODE, target, str(limit)],
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )


@pytest.mark.parametrize("name", ["film.mp4", "film.webm", "film.gif", "film.apng", "film.webp"])
def test_the_old_film_stands(tmp_path: Path, name: str) -> None:
    if name in ("film.mp4", "film.webm"):
        pytest.importorskip("av")
    target = tmp_path / name
    whole = run(str(target), resource.RLIM_INFINITY)
    assert whole.returncode == 0, whole.stderr
    size = target.stat().st_size
    target.write_bytes(b"old")
    for limit in (10_000, size // 2, size - 1):
        cut = run(str(target), limit)
        assert cut.returncode == 1, (limit, cut.stdout, cut.stderr)
        assert cut.stdout.startswith(f"cannot write {target}: "), cut.stdout
        assert cut.stdout.count("\n") == 1
        assert [entry.name for entry in tmp_path.iterdir()] == [name]
        assert target.read_bytes() == b"old"


def test_a_folder_of_frames(tmp_path: Path) -> None:
    cut = run(f"{tmp_path}/frames/", 10_000)
    assert cut.returncode == 1, cut.stderr
    assert list(tmp_path.iterdir()) == []
