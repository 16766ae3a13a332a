"""Sweeps over a crowd, in turns from all of it."""

import pytest

from engine import Polygon, Wall, World
from engine.kernels.contacts import CROWD
from engine.kernels.sweeps import interleave

G = 9.81


def towers(number: int, high: int) -> World:
    """Boxes on boxes, side by side, that have stood for a tick."""
    world = World(gravity=(0, -G), integrator="velocity-verlet", kernels="interpreted")
    world.add(Wall((-2, 0), (3.0 * number, 0)), friction=0.5)
    for i in range(number):
        for k in range(high):
            world.add(Polygon.box(1, 1), position=(2.5 * i, k + 0.5), friction=0.5)
    world.step()
    return world


def resting(world: World) -> int:
    """List the pairs that rest; return their number."""
    pairs = world.tables.pairs
    rest = [i for i in range(world.tables.counts.pairs[0]) if pairs.state[i] == 1]
    for k, pair in enumerate(rest):
        pairs.resting[k] = pair
    return len(rest)


def test_a_list_in_turns_holds_the_same_pairs() -> None:
    world = towers(7, 3)
    count = resting(world)
    before = [world.tables.pairs.resting[k] for k in range(count)]
    interleave(world.tables, count)
    after = [world.tables.pairs.resting[k] for k in range(count)]
    assert sorted(after) == before
    length = -(-count // 4)
    assert after[:4] == [before[0], before[length], before[2 * length], before[3 * length]]


def test_a_crowd_comes_to_rest_with_its_books_balanced() -> None:
    """More contacts than make a crowd: springs take back what they lend, and it stands still."""
    world = World(gravity=(0, -G), integrator="velocity-verlet", kernels="interpreted")
    world.add(Wall((-20, 0), (20, 0)), friction=0.6)
    base = 9
    boxes = [
        world.add(
            Polygon.box(1, 1), position=(1.05 * (i - (base - row) / 2), row + 0.5), friction=0.6
        )
        for row in range(base)
        for i in range(base - row)
    ]
    energy = world.kinetic_energy + world.potential_energy
    for _ in range(6):
        world.run(20)
        assert world.kinetic_energy + world.potential_energy < energy
    assert world.ledger().energy_error == pytest.approx(0.0, abs=1e-12 * energy)
    assert (
        sum(1 for i in range(world.tables.counts.pairs[0]) if world.tables.pairs.state[i]) > CROWD
    )
    assert max(box.speed for box in boxes) == 0.0
