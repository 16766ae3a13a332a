"""Time of a step: interpreted and compiled kernels on the same scenes, interleaved in one run.

Usage: python tests/benchmarks/engine_steps.py [--interpreted]
Prints milliseconds of processor time per step (median of interleaved rounds) and their ratio.
"""

import statistics
import sys
import time
from collections.abc import Callable

from engine import Circle, Particle, Polygon, Wall, World

ROUNDS, STEPS = 7, 30


def room(world: World, size: float, restitution: float, friction: float) -> World:
    corners = [(0.0, 0.0), (size, 0.0), (size, size), (0.0, size)]
    for i in range(4):
        world.add(
            Wall(corners[i], corners[(i + 1) % 4]), restitution=restitution, friction=friction
        )
    return world


def gas(count: int, kernels: str) -> World:
    """Elastic particles without gravity, at the density of a lesson."""
    side = int(count**0.5) + 1
    world = room(World(kernels=kernels), float(side), 1.0, 0.0)
    for i in range(count):
        world.add(
            Particle(0.2),
            position=(0.5 + i % side, 0.5 + i // side),
            velocity=((i * 7919 % 13 - 6) / 4, (i * 104729 % 11 - 5) / 4),
            restitution=1.0,
        )
    return world


def pile(kernels: str) -> World:
    """Twelve mixed bodies that have settled between four walls."""
    world = room(World(gravity=(0, -9.81), kernels=kernels), 4.0, 0.2, 0.5)
    for i in range(12):
        world.add(
            Polygon.box(0.8, 0.6) if i % 2 else Circle(0.35),
            position=(0.7 + (i % 4) * 0.85, 0.5 + (i // 4)),
            angle=0.1 * i,
            restitution=0.2,
            friction=0.5,
        )
    for _ in range(240):
        world.step()
    return world


def pyramid(base: int, kernels: str, apart: float = 0.0) -> World:
    """Boxes on boxes, at rest, or `apart` by so much (m), so that they fall on each other."""
    world = World(gravity=(0, -9.81), kernels=kernels)
    world.add(Wall((-50, 0), (50, 0)), friction=0.6)
    for row in range(base):
        for i in range(base - row):
            x = (i - (base - row) / 2) * 1.05
            y = row + 0.5 + apart * (row + 1)
            world.add(Polygon.box(1, 1), position=(x, y), friction=0.6)
    return world


SCENES: dict[str, Callable[[str], World]] = {
    "free flight, 12": lambda kernels: gas(12, kernels),
    "gas, 100": lambda kernels: gas(100, kernels),
    "pile, 12": pile,
    "pyramid, base 10": lambda kernels: pyramid(10, kernels),
    "the same, landed": lambda kernels: pyramid(10, kernels, 1e-3),
}


def main() -> None:
    """Print the table."""
    modes = ["interpreted"] if "--interpreted" in sys.argv else ["interpreted", "compiled"]
    print(f"{'scene':<20}" + "".join(f"{mode:>14}" for mode in modes) + f"{'ratio':>9}")
    for name, make in SCENES.items():
        worlds = [make(mode) for mode in modes]
        times: list[list[float]] = [[] for _ in modes]
        for world in worlds:
            world.step()
        for _ in range(ROUNDS):
            for world, spent in zip(worlds, times, strict=True):
                begin = time.process_time()
                for _ in range(STEPS):
                    world.step()
                spent.append((time.process_time() - begin) / STEPS * 1e3)
        medians = [statistics.median(spent) for spent in times]
        row = "".join(f"{median:>11.4f} ms" for median in medians)
        print(f"{name:<20}{row}{medians[0] / medians[-1]:>9.1f}", flush=True)
        digests = {world.digest() for world in worlds}
        if len(digests) > 1:
            print("  the digests differ")


if __name__ == "__main__":
    main()
