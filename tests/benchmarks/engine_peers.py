"""Our engine beside pymunk, Box2D 2.3 and Box2D v3: speed and quality of the same scenes.

    python tests/benchmarks/engine_peers.py [--long] [--write] [--interpreted] [--growth] [WORD...]

Words pick scenes by name, `--long` all of them. In each run all engines begin a scene anew, in one
process, and go through each phase of it in turn. Shown is the processor time of a tick, API
included (ms, the middle of all runs); `ratio` is that of the fastest other engine over ours, from
the least of a run to the greatest, in bold if all are what is wanted; then how wrong each is at the
end of the phase. `--write` puts the rows into docs/performance.md. Needs the extra `bench`.
"""

import statistics
import sys
import time
from typing import Any

import page
from peers import PEERS, Ours
from scenes import LONG, SHORT, Phase, Scene, bin_of, gas

RUNS = 5

NAMES = (Ours.name, *PEERS)

HEADER = ("scene", "phase (ticks)", *NAMES, "ratio", "wanted", "wrong by", *NAMES)

Found = dict[str, tuple[float, float]]
"""Of each engine: how long a tick takes (ms), and how wrong it is."""


def run(scene: Scene, kernels: str) -> list[Found]:
    """What each phase of a scene takes; all engines begin anew."""
    laws = (scene.gravity, scene.restitution, scene.friction)
    engines: dict[str, Any] = {Ours.name: Ours(*laws, kernels=kernels)}
    engines |= {name: make(*laws) for name, make in PEERS.items()}
    bodies = {name: scene.build(engine) for name, engine in engines.items()}
    found: list[Found] = []
    tick = 0
    for phase in scene.phases:
        found.append({})
        for name, engine in engines.items():
            seconds(engine, phase.begin - tick)
            before = [engine.state(body) for body in bodies[name]]
            ticks = phase.end - phase.begin
            taken = seconds(engine, ticks) / ticks * 1e3
            after = [engine.state(body) for body in bodies[name]]
            found[-1][name] = taken, scene.quality(before, after)
        tick = phase.end
    return found


def seconds(engine: Any, ticks: int) -> float:
    """Processor time of so many ticks (s)."""
    begin = time.process_time()
    for _ in range(ticks):
        engine.step()
    return time.process_time() - begin


def row(scene: Scene, phase: Phase, runs: list[Found]) -> page.Row:
    """A row of the table: a phase in all runs."""
    middle = {name: statistics.median(found[name][0] for found in runs) for name in NAMES}
    ratios = [min(found[name][0] for name in PEERS) / found[Ours.name][0] for found in runs]
    low, high = f"{min(ratios):.2g}", f"{max(ratios):.2g}"
    ratio = low if low == high else f"{low} to {high}"
    return (
        scene.name,
        named(phase),
        *(f"{middle[name]:.2g}" for name in NAMES),
        f"**{ratio}**" if min(ratios) >= scene.wanted else ratio,
        str(scene.wanted),
        scene.unit,
        *(f"{runs[-1][name][1]:.1g}" for name in NAMES),
    )


def named(phase: Phase) -> str:
    """A phase, as the table calls it."""
    return f"{phase.what} ({phase.begin} to {phase.end})"


def growth(kernels: str) -> None:
    """Print how the cost of a body grows from 1,000 to 10,000 of them."""
    for make in (gas, bin_of):
        cost = {}
        for count in (1000, 10_000):
            scene = make(count)
            engine = Ours(scene.gravity, scene.restitution, scene.friction, kernels=kernels)
            scene.build(engine)
            seconds(engine, 10)
            cost[count] = statistics.median(seconds(engine, 5) for _ in range(7)) / count * 2e5
        print(
            f"{make.__name__}: {cost[1000]:.3f} and {cost[10_000]:.3f} microseconds a body and "
            f"tick for 1,000 and 10,000: {cost[10_000] / cost[1000]:.2f} times"
        )


def main() -> None:
    """Print what was asked for, row by row."""
    options = {word for word in sys.argv[1:] if word.startswith("--")}
    words = [word for word in sys.argv[1:] if not word.startswith("--")]
    kernels = "interpreted" if "--interpreted" in options else "compiled"
    scenes = [*SHORT, *LONG] if "--long" in options or words else list(SHORT)
    print(page.line(HEADER))
    print(page.line(["---"] * len(HEADER)))
    for scene in scenes:
        if all(word in scene.name for word in words):
            runs = [run(scene, kernels) for _ in range(RUNS)]
            for phase, found in zip(scene.phases, zip(*runs, strict=True), strict=True):
                measured = row(scene, phase, list(found))
                print(page.line(measured), flush=True)
                if "--write" in options:
                    page.put(HEADER, [measured], names=2)
    if "--growth" in options:
        growth(kernels)


if __name__ == "__main__":
    main()
