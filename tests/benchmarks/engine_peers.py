"""Our engine against pymunk, Box2D 2.3 and Box2D v3: speed and quality of the same scenes.

Usage: python tests/benchmarks/engine_peers.py [--long] [--interpreted] [--growth] [WORD...]
Words pick scenes by name. All engines run in one process, a few ticks each in turn; what is printed
is the median of the processor time of a tick (ms), API included, and beside it how wrong the scene
is in the end. `speed` is the time of the fastest other engine over ours. Needs the extra `bench`.
"""

import statistics
import sys
import time
from typing import Any

from peers import PEERS, Ours
from scenes import LONG, SHORT, Scene, bin_of, gas

ROUNDS = 12
SHARE = 0.15
"""Processor time of a round of one engine (s)."""


def measure(scene: Scene, engines: dict[str, Any]) -> dict[str, tuple[float, float]]:
    """Milliseconds a tick and quality, for each engine."""
    bodies = {name: scene.build(engine) for name, engine in engines.items()}
    starts = {}
    for name, engine in engines.items():
        for _ in range(scene.warm):
            engine.step()
        starts[name] = [engine.state(body) for body in bodies[name]]
    steps = max(5, min(600, int(SHARE / max(spent(engine, 3) for engine in engines.values()))))
    times: dict[str, list[float]] = {name: [] for name in engines}
    for _ in range(ROUNDS):
        for name, engine in engines.items():
            times[name].append(spent(engine, steps) * 1e3)
    return {
        name: (
            statistics.median(times[name]),
            scene.quality(starts[name], [engine.state(body) for body in bodies[name]]),
        )
        for name, engine in engines.items()
    }


def spent(engine: Any, steps: int) -> float:
    """Processor time of a tick (s)."""
    begin = time.process_time()
    for _ in range(steps):
        engine.step()
    return (time.process_time() - begin) / steps


def engines_for(scene: Scene, kernels: str) -> dict[str, Any]:
    """All engines, empty, with the laws of a scene."""
    laws = (scene.gravity, scene.restitution, scene.friction)
    others = {name: make(*laws) for name, make in PEERS.items()}
    return {"ours": Ours(*laws, kernels=kernels)} | others


def table(scenes: list[Scene], kernels: str) -> None:
    """Print a row a scene, in Markdown."""
    names = ["ours", *PEERS]
    print(
        "| scene (ms a tick) | " + " | ".join(names) + " | speed | quality | " + " | ".join(names)
    )
    print("| --- " * (2 * len(names) + 3) + "|")
    for scene in scenes:
        found = measure(scene, engines_for(scene, kernels))
        speed = min(found[name][0] for name in PEERS) / found["ours"][0]
        times = " | ".join(f"{found[name][0]:.4f}" for name in names)
        quality = " | ".join(f"{found[name][1]:.2g}" for name in names)
        print(f"| {scene.name} | {times} | {speed:.2f} | {scene.unit} | {quality} |", flush=True)


def growth(kernels: str) -> None:
    """Print how the cost of a body grows from 1,000 to 10,000 of them."""
    for make in (gas, bin_of):
        cost = {}
        for count in (1000, 10_000):
            scene = make(count)
            engine = Ours(scene.gravity, scene.restitution, scene.friction, kernels=kernels)
            scene.build(engine)
            spent(engine, 10)
            cost[count] = statistics.median(spent(engine, 5) for _ in range(7)) / count * 1e6
        print(
            f"{make.__name__}: {cost[1000]:.3f} and {cost[10_000]:.3f} microseconds a body and "
            f"tick for 1,000 and 10,000: {cost[10_000] / cost[1000]:.2f} times"
        )


def main() -> None:
    """Print the tables that were asked for."""
    options = {word for word in sys.argv[1:] if word.startswith("--")}
    words = [word for word in sys.argv[1:] if not word.startswith("--")]
    kernels = "interpreted" if "--interpreted" in options else "compiled"
    scenes = [*SHORT, *LONG] if "--long" in options or words else list(SHORT)
    table([scene for scene in scenes if all(word in scene.name for word in words)], kernels)
    if "--growth" in options:
        growth(kernels)


if __name__ == "__main__":
    main()
