"""How machine code is chosen, kept and made: whatever is missing or broken, worlds go on."""

import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from engine import Circle, Pin, World, jit, machine_code, modes, warming

ROOT = Path(jit.__file__).parents[1]


def python(code: str, path: Path, **variables: str) -> subprocess.CompletedProcess[str]:
    """Run a script in a fresh process that looks for modules in `path` first."""
    given = os.environ | {"PYTHONPATH": os.pathsep.join([str(path), str(ROOT)])} | variables
    return subprocess.run(
        [sys.executable, "-X", "dev", "-W", "error", "-c", code],
        env=given,
        cwd=path,
        text=True,
        capture_output=True,
        timeout=120,
        check=False,
    )


def test_the_environment_decides_for_auto(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LAWS_KERNELS", "interpreted")
    assert modes.resolve("auto") == "interpreted"
    monkeypatch.setenv("LAWS_KERNELS", "")
    assert modes.resolve("auto") == "auto"
    monkeypatch.setenv("LAWS_KERNELS", "quick")
    with pytest.raises(ValueError, match=r"LAWS_KERNELS must be one of .*, not 'quick'"):
        World()
    assert World(kernels="interpreted").kernels == "interpreted"


def test_without_numba_worlds_are_interpreted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(jit, "available", lambda: False)
    monkeypatch.setattr("engine.clockwork.WORTHWHILE", 0.0)
    monkeypatch.setenv("LAWS_KERNELS", "auto")
    jit.compiled.cache_clear()
    jit._outermost.cache_clear()
    monkeypatch.setattr(warming, "background", warming.Background)
    with pytest.raises(ImportError, match="compiled kernels need numba: pip install"):
        World(kernels="compiled")
    world = World()
    world.add(Circle(1), velocity=(1, 0))
    for _ in range(60):
        world.step()
    assert world.kernels == "interpreted"


def test_a_broken_numba_is_named_and_does_not_stop_worlds(tmp_path: Path) -> None:
    (tmp_path / "numba").mkdir()
    (tmp_path / "numba" / "__init__.py").write_text("raise OSError('no libLLVM')")
    done = python(
        "from engine import World, warming\n"
        "assert warming.main() == warming.BROKEN\n"
        "World(kernels='auto').step()\n"
        "try:\n    World(kernels='compiled')\n"
        "except ImportError as error:\n    print(error)\n",
        tmp_path,
        LAWS_KERNELS="auto",
    )
    assert done.stderr == ""
    assert "numba is installed but does not work (no libLLVM)" in done.stdout


def test_a_kernel_that_cannot_be_imported_is_not_blamed_on_numba(tmp_path: Path) -> None:
    pytest.importorskip("numba")
    shutil.copytree(ROOT / "engine", tmp_path / "engine", ignore=shutil.ignore_patterns("*.nb*"))
    spring = tmp_path / "engine" / "kernels" / "spring.py"
    spring.write_text("from engine.kernels import nothing_of_that_name\n")
    done = python("from engine import World\nWorld(kernels='compiled')", tmp_path)
    assert "ImportError: cannot import name 'nothing_of_that_name'" in done.stderr
    assert "numba" not in done.stderr.splitlines()[-1]


def test_without_a_folder_to_write_it_is_not_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    pointers = pytest.importorskip("engine.pointers")

    def njit(cache: bool = False, **options: Any) -> Any:
        if cache:
            raise RuntimeError("cannot cache function: no locator available")
        return lambda function: function

    monkeypatch.setattr(pointers, "njit", njit)
    kernel, folder = pointers.outermost("key")
    assert folder is None
    assert callable(kernel)
    monkeypatch.setattr(jit, "folder", lambda: None)
    monkeypatch.setattr(os, "nice", lambda by: 0)
    assert warming.main() == warming.UNKEPT


def test_a_background_that_fails_is_not_started_again(monkeypatch: pytest.MonkeyPatch) -> None:
    started = []

    class Child:
        def __init__(self, *args: Any, **options: Any) -> None:
            started.append(args)
            self.returncode = None

        def poll(self) -> int:
            return warming.UNKEPT

    monkeypatch.setattr(warming.subprocess, "Popen", Child)
    monkeypatch.setattr(jit, "is_ready", lambda: False)
    monkeypatch.setattr(jit, "available", lambda: True)
    background = warming.Background()
    assert [background.kernels() for _ in range(5)] == [None] * 5
    assert len(started) == 1


def test_a_process_that_ends_early_says_nothing(tmp_path: Path) -> None:
    """The one that compiles goes on by itself, without the pipes of the one that started it."""
    sleeper = tmp_path / "python"
    sleeper.write_text("#!/bin/sh\nsleep 3\n")
    sleeper.chmod(0o755)
    done = python(
        "import sys\nfrom engine import jit, warming\n"
        f"sys.executable = {str(sleeper)!r}\n"
        "jit.is_ready, jit.available = lambda: False, lambda: True\n"
        "assert warming.background().kernels() is None\n"
        "print('over')\n",
        tmp_path,
    )
    assert (done.stdout, done.stderr, done.returncode) == ("over\n", "", 0)


def test_edited_sources_need_new_machine_code(tmp_path: Path) -> None:
    """numba itself would notice an edit of one file only."""
    pytest.importorskip("numba")
    shutil.copytree(ROOT / "engine", tmp_path / "engine", ignore=shutil.ignore_patterns("*.nb*"))
    ask = "from engine import jit\nprint(jit.key(), jit.is_ready())"
    before = python(ask, tmp_path).stdout
    spring = tmp_path / "engine" / "kernels" / "spring.py"
    spring.write_text(spring.read_text().replace("10.0", "11.0"))
    after = python(ask, tmp_path).stdout
    assert before != after
    assert after.endswith("False\n")


def test_one_process_compiles_at_a_time(tmp_path: Path) -> None:
    fcntl = pytest.importorskip("fcntl")
    with (
        machine_code.alone(tmp_path),
        open(tmp_path / "laws-kernels.lock") as lock,
        pytest.raises(BlockingIOError),
    ):
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    with open(tmp_path / "laws-kernels.lock") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)


def test_machine_code_is_ready_once_it_is_whole(tmp_path: Path) -> None:
    assert not machine_code.is_marked(tmp_path, "a" * 64)
    machine_code.mark(tmp_path, "a" * 64)
    assert not machine_code.is_marked(tmp_path, "a" * 64)  # the code itself was deleted
    (tmp_path / "pointers.run.nbi").touch()
    assert machine_code.is_marked(tmp_path, "a" * 64)
    assert not machine_code.is_marked(tmp_path, "b" * 64)


def test_a_folder_that_cannot_be_written_is_no_failure(tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.touch()
    with machine_code.alone(file / "folder"):
        machine_code.mark(file / "folder", "a" * 64)
    assert not machine_code.is_marked(file / "folder", "a" * 64)


LONG_RUN = """
import sys, time
from engine import Box, Circle, Wall, World, clockwork
clockwork.WORTHWHILE, clockwork.AGAIN = 0.0, 1e-4

def fill(kernels):
    world = World(gravity=(0, -9.81), kernels=kernels)
    world.add(Wall((-9, 0), (9, 0)), friction=0.5)
    for i in range(3):
        world.add(Box(1, 1), position=(0, 0.5 + i), friction=0.5)
    world.add(Circle(0.3), position=(3, 5), velocity=(-2, 0), restitution=0.8)
    return world

worlds = [fill("interpreted"), fill("auto")]
swapped, end = 0, time.monotonic() + 500
while time.monotonic() < end and (not swapped or worlds[1].tick < swapped + 60):
    for world in worlds:
        world.step()
    if worlds[1].kernels == "compiled":
        swapped = swapped or worlds[1].tick
    else:
        time.sleep(0.05)
print(swapped > 1, [w.kernels for w in worlds], worlds[0].digest() == worlds[1].digest())
"""


def test_two_processes_compile_in_the_background_and_change_over_between_ticks(
    tmp_path: Path,
) -> None:
    """For real, from an empty cache: both go on interpreted, one child compiles, the other waits,
    and not a bit changes. This takes as long as a compiler takes.
    """
    pytest.importorskip("numba")
    shutil.copytree(
        ROOT / "engine", tmp_path / "engine", ignore=shutil.ignore_patterns("__pycache__")
    )
    given = os.environ | {"PYTHONPATH": str(tmp_path), "LAWS_KERNELS": "auto"}
    given.pop("NUMBA_CACHE_DIR", None)
    both = [
        subprocess.Popen(
            [sys.executable, "-c", LONG_RUN],
            env=given,
            cwd=tmp_path,
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
        for _ in range(2)
    ]
    told = [process.communicate(timeout=600) for process in both]
    assert told == [("True ['interpreted', 'compiled'] True\n", "")] * 2
    assert len(list(tmp_path.glob("engine/__pycache__/pointers.*.nbi"))) == 1


def test_joints_count_as_work(monkeypatch: pytest.MonkeyPatch) -> None:
    """A bridge of thirty planks was interpreted for two minutes, as if its joints cost nothing."""
    asked: list[int] = []
    monkeypatch.setenv("LAWS_KERNELS", "auto")
    monkeypatch.setattr("engine.clockwork.ready_in_background", lambda: asked.append(world.tick))
    world = World()
    before = None
    for i in range(30):
        link = world.add(Circle(0.1), position=(i, 0), mask=0)
        world.join(before, link, Pin(at=(i - 0.5, 0)))
        before = link
    world.run(180)
    assert 100 < asked[0] <= 150
