"""Time of a step: interpreted and compiled kernels on the same scenes, interleaved in one run.

    python tests/benchmarks/engine_steps.py [--write]

Prints milliseconds of processor time per step (median of interleaved rounds) and their ratio, and
says so if the two end differently. `--write` puts the rows into docs/performance.md.
"""

import statistics
import sys
import time

import page
from worlds import SCENES

ROUNDS, STEPS = 7, 30

MODES = ("interpreted", "compiled")

HEADER = ("scene", "interpreted (ms)", "wanted", "compiled (ms)", "ratio")

WANTED = {"free flight, 12": "0.15", "pile, 12": "1.5"}
"""Interpreted (ms)."""


def main() -> None:
    """Print the table, row by row."""
    print(page.line(HEADER))
    print(page.line(["---"] * len(HEADER)))
    for name, make in SCENES.items():
        worlds = [make(mode) for mode in MODES]
        times: list[list[float]] = [[] for _ in MODES]
        for world in worlds:
            world.step()
        for _ in range(ROUNDS):
            for world, spent in zip(worlds, times, strict=True):
                begin = time.process_time()
                for _ in range(STEPS):
                    world.step()
                spent.append((time.process_time() - begin) / STEPS * 1e3)
        slow, fast = (statistics.median(spent) for spent in times)
        row = (name, f"{slow:.2g}", WANTED.get(name, ""), f"{fast:.2g}", f"{slow / fast:.0f}")
        print(page.line(row), flush=True)
        if len({world.digest() for world in worlds}) > 1:
            print("the digests differ")
        elif "--write" in sys.argv:
            page.put(HEADER, [row], names=1)


if __name__ == "__main__":
    main()
