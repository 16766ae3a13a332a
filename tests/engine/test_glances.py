"""Pairs that stay apart are left at a glance: nothing may be missed by that, nor changed."""

import random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine import Box, Circle, Polygon, Wall, World
from engine.kernels import aftermath, travel
from engine.kernels.searching import gap_at
from engine.tables import FREE


def falling(seed: int) -> World:
    """A bin into which bodies of all shapes fall, beside each other, across, or into each other."""
    dice = random.Random(seed)
    spread = dice.choice([1.0, 0.5])
    world = World(gravity=(0, -9.81), integrator="velocity-verlet", kernels="interpreted")
    for start, end in (((-0.2, 0), (4.2, 0)), ((4, 0), (4, 9)), ((0, 9), (0, 0))):
        world.add(Wall(start, end), restitution=0.4, friction=0.4)
    for i in range(dice.randrange(6, 16)):
        shape = dice.choice(
            [Circle(dice.uniform(0.1, 0.3)), Box(0.4, 0.3), Polygon.regular(3 + i % 4, 0.25)]
        )
        world.add(
            shape,
            position=(0.5 + i % 4 * 0.9 * spread, 0.5 + i // 4 * 0.8 * spread),
            velocity=dice.choice([(0.0, -5.0), (dice.uniform(-4, 4), dice.uniform(-9, 9))]),
            spin=dice.choice([0.0, dice.uniform(-6, 6)]),
            gravity_scale=dice.choice([1.0, 1.0, 0.5]),
            restitution=dice.choice([0.0, 0.6]),
            friction=0.4,
        )
    return world


def look_at_all(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let kernels look at every pair as each part begins, and at all of a body after an impact."""
    measure: Any = travel.measure_rims

    def forget(t: Any, count: int, part: float) -> None:
        measure(t, count, part)
        for pair in range(t.counts.pairs[0]):
            t.pairs.apart[pair] = 0.0

    monkeypatch.setattr(travel, "measure_rims", forget)
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


@settings(max_examples=15)
@given(seed=st.integers(0, 2**30))
def test_no_pair_is_nearer_than_what_is_known_of_it(seed: int) -> None:
    """Not even where what overlaps deeply was moved apart at the end of the tick; of discs, whose
    gaps are distances.
    """
    world = falling(seed)
    for _ in range(30):
        world.step()
        t = world.tables
        for pair in range(t.counts.pairs[0]):
            bodies = (world.body(t.bodies.id[row]) for row in (t.pairs.a[pair], t.pairs.b[pair]))
            discs = any(isinstance(body.shape, Circle) for body in bodies)
            if discs and t.pairs.state[pair] == FREE and t.pairs.apart[pair] > 0.0:
                assert t.pairs.apart[pair] <= gap_at(t, pair, 0.0) + 1e-12
