"""Scenes that benchmarks and tests share, built through the door of `peers.Engine`."""

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

GRAVITY = -9.81

Point = tuple[float, float]

States = list[tuple[float, float, float, float, float, float]]
"""Of each body: x, y, angle, vx, vy, spin."""


class Phase(NamedTuple):
    """Ticks of a scene in which much the same happens."""

    what: str
    begin: int
    """Ticks that are over when it begins."""
    end: int


@dataclass(frozen=True)
class Scene:
    """What all engines are asked to do."""

    name: str
    gravity: float
    """(m/s^2)"""
    restitution: float
    friction: float
    build: Callable[[Any], list[Any]]
    """Puts bodies into an engine; returns those that move, all of density 1 kg/m^2."""
    phases: tuple[Phase, ...]
    """In which the clock runs, in their order."""
    wanted: float
    """How many times as long the fastest other engine should take."""
    quality: Callable[[States, States], float]
    """How wrong the second state is, from the first: the smaller the better."""
    unit: str
    """What the quality is."""


def room(engine: Any, width: float, height: float) -> None:
    """Four walls from the origin."""
    corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)]
    for start, end in itertools.pairwise([*corners, corners[0]]):
        engine.wall(start, end)


def gas(count: int) -> Scene:
    """Elastic discs without gravity in a room, at the density of a lesson."""
    radius = 0.2

    def build(engine: Any) -> list[Any]:
        side = int(count**0.5) + 1
        room(engine, float(side), float(side))
        return [
            engine.circle(
                0.5 + i % side,
                0.5 + i // side,
                radius,
                (i * 7919 % 13 - 6) / 4,
                (i * 104729 % 11 - 5) / 4,
            )
            for i in range(count)
        ]

    def drift(before: States, after: States) -> float:
        return abs(kinetic(after, radius) / kinetic(before, radius) - 1.0)

    flying = Phase("flying", 10, 610 if count > 100 else 7210)
    wanted = 1.4 if count > 12 else 1.0
    return Scene(
        f"elastic gas, {count}", 0.0, 1.0, 0.0, build, (flying,), wanted, drift, "energy drift"
    )


def kinetic(states: States, radius: float) -> float:
    """Kinetic energy of discs of 1 kg (J)."""
    turning = radius * radius / 2.0
    return sum(vx * vx + vy * vy + turning * w * w for _, _, _, vx, vy, w in states) / 2.0


def pyramid(base: int) -> Scene:
    """Boxes of 1 m on boxes, at rest."""

    def build(engine: Any) -> list[Any]:
        engine.wall((-1000.0, 0.0), (1000.0, 0.0))
        return [
            engine.box((i - (base - row) / 2) * 1.05, row + 0.5, 1.0, 1.0)
            for row in range(base)
            for i in range(base - row)
        ]

    phases = (Phase("first ticks", 0, 60), Phase("standing", 60, 660))
    return Scene(f"pyramid, base {base}", GRAVITY, 0.0, 0.6, build, phases, 1.4, moved, "creep (m)")


def moved(before: States, after: States) -> float:
    """The longest way that a body went (m)."""
    return max(math.dist(a[:2], b[:2]) for a, b in zip(before, after, strict=True))


def pile() -> Scene:
    """Twelve mixed bodies that have settled between four walls."""

    def build(engine: Any) -> list[Any]:
        room(engine, 4.0, 4.0)
        bodies = []
        for i in range(12):
            x, y = 0.6 + (i % 4) * 0.85, 0.5 + i // 4
            disc = (x, y, 0.35)
            bodies.append(engine.box(x, y, 0.8, 0.6) if i % 2 else engine.circle(*disc))
        return bodies

    lying = Phase("lying", 240, 7440)
    return Scene("pile, 12", GRAVITY, 0.2, 0.5, build, (lying,), 1.0, moved, "creep (m)")


def bin_of(count: int) -> Scene:
    """Discs and boxes that fall into a bin and come to lie on each other."""
    radius = 0.25

    def build(engine: Any) -> list[Any]:
        columns = max(10, int(math.sqrt(count / 2)))
        room(engine, columns * 0.75, 5.0 * count / columns)
        bodies = []
        for i in range(count):
            x = 0.4 + 0.74 * (i % columns) + 0.04 * (i // columns % 3)
            y = 0.4 + 0.72 * (i // columns)
            round_one = i * 7919 % 3 == 0
            bodies.append(engine.circle(x, y, radius) if round_one else engine.box(x, y, 0.5, 0.4))
        return bodies

    def overlap(before: States, after: States) -> float:
        del before
        discs = [state for i, state in enumerate(after) if i * 7919 % 3 == 0]
        return deepest(discs, radius)

    name, phases = f"bin, {count} mixed", SMALL_BIN if count < 1000 else LARGE_BIN
    return Scene(name, GRAVITY, 0.1, 0.5, build, phases, 1.2, overlap, "overlap (m)")


SMALL_BIN = (
    Phase("falling", 20, 120), Phase("settling", 120, 300), Phase("coming to rest", 300, 600),
    Phase("at rest", 600, 900),
)  # fmt: skip

LARGE_BIN = (
    Phase("falling", 0, 40), Phase("first columns land", 40, 60), Phase("columns land", 60, 80),
    Phase("columns land", 80, 100), Phase("settling", 100, 300), Phase("settled", 300, 330),
)  # fmt: skip


def deepest(discs: Sequence[tuple[float, ...]], radius: float) -> float:
    """The deepest overlap of two discs (m)."""
    cells: dict[tuple[int, int], list[tuple[float, ...]]] = {}
    for disc in discs:
        at = (math.floor(disc[0] / radius / 2), math.floor(disc[1] / radius / 2))
        cells.setdefault(at, []).append(disc)
    most = 0.0
    for (i, j), here in cells.items():
        around = [cells.get((i + x, j + y), []) for x in (-1, 0, 1) for y in (-1, 0, 1)]
        for a, b in itertools.product(here, itertools.chain(*around)):
            if a is not b:
                most = max(most, 2 * radius - math.dist(a[:2], b[:2]))
    return most


def chains(count: int, links: int) -> Scene:
    """Chains of pinned boxes that swing down from the horizontal, each on a pin of its own."""
    length = 0.4

    def build(engine: Any) -> list[Any]:
        bodies: list[Any] = []
        for k in range(count):
            before = None
            for i in range(links):
                link = engine.box((i + 0.5) * length, 25.0 * k, length, 0.1)
                engine.pin(before, link, i * length, 25.0 * k)
                bodies.append(link)
                before = link
        return bodies

    def stretch(before: States, after: States) -> float:
        del before
        most = 0.0
        for i, (x, y, angle, *_) in enumerate(after):
            end = (x - math.cos(angle) * length / 2, y - math.sin(angle) * length / 2)
            held = (0.0, 25.0 * (i // links))
            if i % links:
                x, y, angle, *_ = after[i - 1]
                held = (x + math.cos(angle) * length / 2, y + math.sin(angle) * length / 2)
            most = max(most, math.dist(end, held))
        return most

    name = f"{count} chains of {links} links"
    phases = (
        Phase("falling", 1, 40), Phase("swinging", 40, 200), Phase("whipping", 200, 300),
        Phase("tangled", 300, 640),
    )  # fmt: skip
    return Scene(name, GRAVITY, 0.0, 0.5, build, phases, 1.2, stretch, "gap in a joint (m)")


LIMBS = (
    # Centre and half sizes of each part of a doll, which part it is pinned to, and where (m).
    ((0.0, 1.25), (0.2, 0.2), None, (0.0, 0.0)),
    ((0.0, 0.9), (0.17, 0.15), 0, (0.0, 1.05)),
    ((0.0, 1.6), (0.1, 0.15), 0, (0.0, 1.45)),
    ((-0.4, 1.4), (0.2, 0.05), 0, (-0.2, 1.4)),
    ((-0.8, 1.4), (0.2, 0.05), 3, (-0.6, 1.4)),
    ((0.4, 1.4), (0.2, 0.05), 0, (0.2, 1.4)),
    ((0.8, 1.4), (0.2, 0.05), 5, (0.6, 1.4)),
    ((-0.1, 0.55), (0.06, 0.2), 1, (-0.1, 0.75)),
    ((-0.1, 0.15), (0.06, 0.2), 7, (-0.1, 0.35)),
    ((0.1, 0.55), (0.06, 0.2), 1, (0.1, 0.75)),
    ((0.1, 0.15), (0.06, 0.2), 9, (0.1, 0.35)),
)


def ragdolls(count: int) -> Scene:
    """Dolls of eleven boxes on ten pins each, that fall on a floor side by side."""
    joints: list[tuple[int, Point, int, Point]] = []

    def build(engine: Any) -> list[Any]:
        joints.clear()
        engine.wall((-10.0, 0.0), (3.0 * count + 10.0, 0.0))
        bodies: list[Any] = []
        for k in range(count):
            left, low, first = 3.0 * k, 0.5 + 0.1 * (k % 5), len(bodies)
            for (x, y), (width, height), other, (pin_x, pin_y) in LIMBS:
                bodies.append(engine.box(left + x, low + y, 2 * width, 2 * height))
                if other is not None:
                    engine.pin(bodies[first + other], bodies[-1], left + pin_x, low + pin_y)
                    centre = LIMBS[other][0]
                    on_other = (pin_x - centre[0], pin_y - centre[1])
                    joints.append(
                        (first + other, on_other, len(bodies) - 1, (pin_x - x, pin_y - y))
                    )
        return bodies

    def stretch(before: States, after: States) -> float:
        del before
        return max(
            math.dist(seen(after[a], at_a), seen(after[b], at_b)) for a, at_a, b, at_b in joints
        )

    name = f"{count} ragdolls of 10 joints"
    phases = (
        Phase("in the air", 2, 18), Phase("landing", 22, 60), Phase("landing", 60, 130),
        Phase("in heaps of limbs", 130, 400), Phase("most at rest", 400, 700),
    )  # fmt: skip
    return Scene(name, GRAVITY, 0.0, 0.5, build, phases, 1.2, stretch, "gap in a joint (m)")


def seen(state: tuple[float, ...], at: Point) -> Point:
    """Where a point of a body is in the world (m)."""
    cos, sin = math.cos(state[2]), math.sin(state[2])
    return state[0] + cos * at[0] - sin * at[1], state[1] + sin * at[0] + cos * at[1]


SHORT = (gas(12), gas(100), pile(), pyramid(10))
"""Scenes that take a moment."""

LONG = (
    gas(1000), gas(4000), pyramid(20), pyramid(40), bin_of(300), bin_of(2000), chains(25, 20),
    ragdolls(50),
)  # fmt: skip
"""Scenes that take minutes."""
