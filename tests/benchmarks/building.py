"""Processor time of building a world, body by body, beside other engines, in one run.

    python tests/benchmarks/building.py

Each scene is built several times in each engine, in turn; the smallest times are shown.
"""

import time
from typing import Any

import scenes
from peers import PEERS, Ours

ROUNDS = 7
SCENES = (scenes.pyramid(40), scenes.gas(4000), scenes.chains(25, 20), scenes.chains(1, 2000))
LEFT_OUT = "Box2D 2.3"
"""Box2D v3 is the faster one."""


def build(scene: scenes.Scene, engine: Any) -> tuple[float, int]:
    """Processor time that it takes (s), and how many bodies there are."""
    world = engine(scene.gravity, scene.restitution, scene.friction)
    begun = time.process_time()
    bodies = scene.build(world)
    return time.process_time() - begun, len(bodies)


def main() -> None:
    """Print the table."""
    engines: dict[str, Any] = {Ours.name: Ours}
    engines |= {name: engine for name, engine in PEERS.items() if name != LEFT_OUT}
    print(f"{'microseconds a body':<28}" + "".join(f"{name:>12}" for name in engines))
    for scene in SCENES:
        best = dict.fromkeys(engines, float("inf"))
        for _ in range(ROUNDS):
            for name, engine in engines.items():
                taken, number = build(scene, engine)
                best[name] = min(best[name], taken / number * 1e6)
        print(f"{scene.name:<28}" + "".join(f"{best[name]:>12.1f}" for name in engines))


if __name__ == "__main__":
    main()
