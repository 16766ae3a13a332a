"""Pairs that stay apart are left at a glance: nothing may be missed by that, nor changed."""

import random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine import Box, Circle, Polygon, Wall, World
from engine.kernels import aftermath, travel


def falling(seed: int) -> World:
    """A bin into which bodies of all shapes fall, some beside each other, some across."""
    dice = random.Random(seed)
    world = World(gravity=(0, -9.81), integrator="velocity-verlet", kernels="interpreted")
    for start, end in (((-0.2, 0), (4.2, 0)), ((4, 0), (4, 9)), ((0, 9), (0, 0))):
        world.add(Wall(start, end), restitution=0.4, friction=0.4)
    for i in range(dice.randrange(6, 16)):
        shape = dice.choice(
            [Circle(dice.uniform(0.1, 0.3)), Box(0.4, 0.3), Polygon.regular(3 + i % 4, 0.25)]
        )
        world.add(
            shape,
            position=(0.5 + i % 4 * 0.9, 0.5 + i // 4 * 0.8),
            velocity=dice.choice([(0.0, -5.0), (dice.uniform(-4, 4), dice.uniform(-9, 9))]),
            spin=dice.choice([0.0, dice.uniform(-6, 6)]),
            gravity_scale=dice.choice([1.0, 1.0, 0.5]),
            restitution=dice.choice([0.0, 0.6]),
            friction=0.4,
        )
    return world


def look_at_all(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let kernels look at every pair as each part begins, and at all of a body after an impact."""
    measure: Any = travel.measure_ways

    def forget(t: Any, count: int, part: float) -> None:
        measure(t, count, part)
        for pair in range(t.counts.pairs[0]):
            t.pairs.apart[pair] = 0.0

    monkeypatch.setattr(travel, "measure_ways", forget)
    monkeypatch.setattr(aftermath, "stays_apart", lambda t, pair, closer: False)


@settings(max_examples=15)
@given(seed=st.integers(0, 2**30))
def test_a_glance_changes_nothing(seed: int) -> None:
    """Worlds whose kernels look at every pair end in the same bits."""
    quick, slow = falling(seed), falling(seed)
    quick.run(40)
    with pytest.MonkeyPatch.context() as monkeypatch:
        look_at_all(monkeypatch)
        slow.run(40)
    assert quick.digest() == slow.digest()
