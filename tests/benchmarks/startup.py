"""Processor time of commands that draw nothing, next to that of importing numpy, in one run.

    python tests/benchmarks/startup.py

Each is run several times in turn; the smallest of each is shown. Byte code is kept, as a program
that runs for the second time has it; the last columns are with only what is there already, and how
much of our own sources a command loads, which no other work on the machine changes.
"""

import os
import resource
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

ROUNDS = 7
ROOT = Path(__file__).parents[2]
SCENARIO = ROOT / "assets/scenarios/inertia-rest-push-coast.yaml"

TELL = """
import atexit, runpy, sys
def tell():
    for module in list(sys.modules.values()):
        print(getattr(module, "__file__", None), file=sys.stderr)
atexit.register(tell)
del sys.argv[0]
if sys.argv[0] == "-m":
    del sys.argv[0]
    runpy.run_module(sys.argv[0], run_name="__main__", alter_sys=True)
else:
    exec(sys.argv[1])
"""
"""Does what the interpreter would do, then names the files of all modules that are loaded."""

COMMANDS = {
    "python": ("-c", "pass"),
    "import numpy": ("-c", "import numpy"),
    "first tick": ("-c", "from engine import World\nWorld().step()"),
    "laws --help": ("-m", "app.cli", "--help"),
    "laws check": ("-m", "app.cli", "check", str(SCENARIO)),
}


def spent(arguments: tuple[str, ...], **environment: str) -> float:
    """Processor time of one process (s), its start and end included."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    inherited = {name: os.environ[name] for name in os.environ if "BYTECODE" not in name}
    subprocess.run(
        [sys.executable, *arguments],
        env=inherited | {"OPENBLAS_NUM_THREADS": "1"} | environment,
        stdout=subprocess.DEVNULL,
        cwd=ROOT,
        check=True,
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def loaded(arguments: tuple[str, ...]) -> tuple[int, int]:
    """How many of our own modules a command loads, and how many bytes of source they have."""
    told = subprocess.run(
        [sys.executable, "-c", TELL, *arguments],
        capture_output=True,
        text=True,
        cwd=ROOT,
        check=True,
    ).stderr
    files = [Path(line) for line in told.splitlines() if Path(line).is_relative_to(ROOT)]
    return len(files), sum(file.stat().st_size for file in files)


def main() -> None:
    """Measure and print."""
    with TemporaryDirectory() as folder:
        kept = {name: [] for name in COMMANDS}
        fresh = {name: [] for name in COMMANDS}
        for arguments in COMMANDS.values():
            spent(arguments, PYTHONPYCACHEPREFIX=folder)
        for _ in range(ROUNDS):
            for name, arguments in COMMANDS.items():
                kept[name].append(spent(arguments, PYTHONPYCACHEPREFIX=folder))
                fresh[name].append(spent(arguments, PYTHONDONTWRITEBYTECODE="1"))
    unit = min(kept["import numpy"])
    print(f"{'':14} {'s':>7} {'x numpy':>8} {'s, none of our own':>20} {'modules':>9} {'KB':>5}")
    for name in COMMANDS:
        least = min(kept[name])
        modules, size = loaded(COMMANDS[name])
        print(
            f"{name:14} {least:7.3f} {least / unit:8.2f} {min(fresh[name]):20.3f} {modules:9} "
            f"{size / 1024:5.0f}"
        )


if __name__ == "__main__":
    main()
