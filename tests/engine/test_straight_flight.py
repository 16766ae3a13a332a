"""Without forces, pairs are looked at only when they may meet: nothing may be missed by that."""

import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine import Circle, Force, Polygon, Snapshot, SpringTo, Wall, World


def thrown(seed: int) -> World:
    """A room of bodies that fly, turn and bounce without forces; one of its walls is one-sided."""
    dice = random.Random(seed)
    world = World(integrator="velocity-verlet", kernels="interpreted")
    corners = [(0.0, 0.0), (6.0, 0.4), (6.5, 6.0), (-0.4, 6.0)]
    for i in range(4):
        world.add(Wall(corners[i], corners[(i + 1) % 4]), restitution=1.0)
    world.add(Wall((1.0, 3.0), (4.0, 3.2), one_sided=True), restitution=0.8)
    for i in range(dice.randrange(4, 14)):
        shape = Circle(dice.uniform(0.05, 0.4)) if i % 3 else Polygon.regular(3 + i % 4, 0.3)
        way = (dice.uniform(-3, 3), dice.choice([0.0, dice.uniform(-20, 20)]))
        world.add(
            shape,
            kind="kinematic" if i == 3 else None,
            position=(1.0 + i % 4 * 1.2, 1.0 + i // 4 * 1.3),
            velocity=(0.0, 0.0) if i == 3 else way,  # what squeezes others makes them storm
            spin=dice.uniform(-3, 3),
            restitution=dice.choice([0.3, 1.0]),
            friction=0.2,
        )
    return world


def told(world: World, ticks: int) -> list[tuple[float, int, int, float]]:
    """When who collided with whom, and how fast."""
    return [(c.time, c.a.id, c.b.id, c.speed) for _ in range(ticks) for c in world.step()]


@settings(max_examples=40)
@given(seed=st.integers(0, 2**30))
def test_a_law_that_pulls_at_nothing_changes_nothing(seed: int) -> None:
    """It makes the kernels look at every pair in every tick."""
    worlds = [thrown(seed), thrown(seed)]
    worlds[1].add_law(SpringTo((0.0, 0.0), 0.0))
    assert told(worlds[0], 40) == told(worlds[1], 40)
    assert worlds[0].state().tolist() == worlds[1].state().tolist()


def passers() -> World:
    """Two discs that fly past each other."""
    world = World(integrator="velocity-verlet")
    world.add(Circle(0.5), position=(0, 0), velocity=(1, 0), restitution=1.0)
    world.add(Circle(0.5), position=(4, 1.5), velocity=(-1, 0), restitution=1.0)
    for _ in range(60):
        assert world.step() == []
    assert world.tables.progress.straight[0] == 1
    return world


def test_what_was_clear_meets_if_a_hand_turns_it() -> None:
    world = passers()
    world.body(2).velocity = (-1, -1.5)
    assert [tuple(at[1:3]) for at in told(world, 60)] == [(1, 2)]


def test_what_was_clear_meets_if_a_force_turns_it() -> None:
    world = passers()
    world.body(2).exert(Force(0, -100), duration=1 / 60)
    assert [tuple(at[1:3]) for at in told(world, 60)] == [(1, 2)]


def test_a_snapshot_does_not_remember_what_was_clear_before() -> None:
    world = passers()
    world.body(2).velocity = (-1, -1.5)
    saved: Snapshot = world.snapshot()
    expected = told(world, 60)
    world.restore(saved)
    assert told(world, 60) == expected != []


def test_a_near_miss_is_a_miss_and_a_graze_is_an_impact() -> None:
    for gap, hits in ((1e-7, 0), (-1e-7, 1)):
        world = World(integrator="velocity-verlet")
        world.add(Circle(0.5), position=(0, 0), velocity=(2, 0), restitution=1.0)
        world.add(Circle(0.5), position=(5, 1.0 + gap), velocity=(-1, 0), restitution=1.0)
        assert len(told(world, 180)) == hits


def test_the_time_of_a_late_impact_is_that_of_the_closed_form() -> None:
    """Two discs a long way apart: (d - 2 r) / (v1 + v2)."""
    world = World(integrator="velocity-verlet")
    world.add(Circle(0.5), position=(0, 0), velocity=(1.7, 0), restitution=1.0)
    world.add(Circle(0.5), position=(40, 0), velocity=(-2.4, 0), restitution=1.0)
    (at, *_), *others = told(world, 900)
    assert at == pytest.approx(39 / 4.1, abs=1e-12)
    assert others == []
