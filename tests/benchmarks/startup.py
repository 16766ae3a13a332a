"""Processor time of commands that draw nothing, next to that of importing numpy, in one run.

    python tests/benchmarks/startup.py

Each is run several times in turn; the smallest of each is shown. Byte code is kept, as a program
that runs for the second time has it; the last column is with only what is there already.
"""

import os
import resource
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

ROUNDS = 7
SCENARIO = Path(__file__).parents[2] / "assets/scenarios/inertia-rest-push-coast.yaml"

COMMANDS = {
    "python": ("-c", "pass"),
    "import numpy": ("-c", "import numpy"),
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
        cwd=Path(__file__).parents[2],
        check=True,
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


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
    print(f"{'':14} {'s':>7} {'x numpy':>8} {'s, none of our own':>20}")
    for name in COMMANDS:
        least = min(kept[name])
        print(f"{name:14} {least:7.3f} {least / unit:8.2f} {min(fresh[name]):20.3f}")


if __name__ == "__main__":
    main()
