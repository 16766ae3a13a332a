"""Who passes through whom: categories, masks, groups, pairs that ignore each other."""

import itertools
import json
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine import Body, Box, Circle, Polygon, Removed, Wall, World

BALL, BOX, GHOST = 1, 2, 4


def meeting(world: World, **second: Any) -> tuple[Body, Body]:
    """Two discs that run into each other, elastic."""
    a = world.add(Circle(0.5), position=(-2, 0), velocity=(4, 0), restitution=1.0)
    return a, world.add(Circle(0.5), position=(2, 0), velocity=(-4, 0), **second)


def collisions(world: World, ticks: int = 60) -> int:
    return sum(len(world.step()) for _ in range(ticks))


@pytest.mark.parametrize(
    ("first", "second", "touch"),
    [
        ({}, {}, True),
        ({"category": BOX}, {"mask": BALL}, False),
        ({"category": BOX}, {"mask": BOX}, True),
        ({"category": BOX | GHOST}, {"mask": BOX}, True),
        ({"mask": 0}, {}, False),
        ({"category": GHOST, "mask": BALL}, {"category": BALL, "mask": BALL}, False),
        ({"category": GHOST, "mask": BALL}, {"category": BALL, "mask": BALL | GHOST}, True),
        ({"group": 3}, {"group": 3}, False),
        ({"group": 3}, {"group": 4}, True),
        ({"group": 3}, {}, True),
    ],
)
def test_two_bodies_touch_if_each_wants_to(
    first: dict[str, int], second: dict[str, int], touch: bool
) -> None:
    world = World()
    a, b = meeting(world, **second)
    for name, value in first.items():
        setattr(a, name, value)
        assert getattr(a, name) == value
    assert collisions(world) == int(touch)
    assert a.vx == pytest.approx(-4.0 if touch else 4.0)
    del b


def test_walls_have_filters_too() -> None:
    world = World(gravity=(0, -9.81))
    world.add(Wall((-5, 0), (5, 0)), category=GHOST)
    falls = world.add(Circle(0.5), position=(0, 1), mask=BALL)
    rests = world.add(Circle(0.5), position=(3, 0.5))
    collisions(world, 60)
    assert falls.y < -2.0
    assert rests.y == pytest.approx(0.5, abs=1e-2)


def test_a_filter_that_changes_counts_from_the_next_tick_on() -> None:
    world = World(gravity=(0, -9.81))
    floor = world.add(Wall((-5, 0), (5, 0)))
    box = world.add(Polygon.box(1, 1), position=(0, 0.5))
    collisions(world, 30)
    assert box.y == pytest.approx(0.5, abs=1e-2)
    box.mask = GHOST
    collisions(world, 30)
    assert box.y == pytest.approx(0.5 - 9.81 * 0.5**2 / 2, rel=0.05)
    box.position, box.velocity, box.mask = (0, 1), (0, 0), BALL
    collisions(world, 60)
    assert box.y == pytest.approx(0.5, abs=1e-2)
    floor.group = box.group = 7
    collisions(world, 30)
    assert box.y < 0.0


def test_two_bodies_ignore_each_other_until_told_otherwise() -> None:
    world = World()
    a, b = meeting(world)
    other = world.add(Circle(0.5), position=(-2, 3), velocity=(4, 0), restitution=1.0)
    target = world.add(Circle(0.5), position=(2, 3))
    world.ignore(b, a)
    world.ignore(a, b)
    assert world.ignores(a, b)
    assert not world.ignores(a, other)
    assert collisions(world) == 1
    assert target.vx == pytest.approx(4.0)
    assert a.vx == 4.0
    a.position, b.position = (-2, 0), (2, 0)
    world.heed(a, b)
    world.heed(a, b)
    assert not world.ignores(a, b)
    assert collisions(world) == 1


@given(st.lists(st.tuples(st.integers(0, 4), st.integers(0, 4), st.booleans()), max_size=30))
def test_pairs_ignore_each_other_in_whatever_order_they_were_told(
    told: list[tuple[int, int, bool]],
) -> None:
    world = World()
    bodies = [world.add(Circle(0.1), position=(i, 0)) for i in range(5)]
    ignoring: set[frozenset[int]] = set()
    for i, k, ignores in told:
        if i != k:
            (world.ignore if ignores else world.heed)(bodies[i], bodies[k])
            (ignoring.add if ignores else ignoring.discard)(frozenset((i, k)))
    for i, k in itertools.combinations(range(5), 2):
        assert world.ignores(bodies[i], bodies[k]) == (frozenset((i, k)) in ignoring)


def test_what_is_ignored_is_saved_restored_digested_and_forgotten_with_its_body() -> None:
    world = World()
    a, b = meeting(world)
    plain = world.digest()
    world.ignore(a, b)
    assert world.digest() != plain
    saved, loaded = world.snapshot(), World.from_dict(json.loads(json.dumps(world.to_dict())))
    assert loaded.ignores(loaded.body(1), loaded.body(2))
    assert loaded.digest() == world.digest()
    world.heed(a, b)
    assert world.digest() == plain
    world.restore(saved)
    assert world.ignores(a, b)
    world.remove(a)
    assert world.store.count("ignored") == 0
    b.group = 5
    assert World.from_dict(world.to_dict()).body(2).group == 5


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ({"category": 0}, "category must be at least 1, not 0"),
        ({"category": 2**32}, "category must be at most 4294967295, not 4294967296"),
        ({"category": 1.0}, "category must be a whole number, not 1.0"),
        ({"mask": -1}, "mask must be at least 0, not -1"),
        ({"mask": "all"}, "mask must be a whole number, not 'all'"),
        ({"group": -2}, "group must be at least 0, not -2"),
        ({"group": True}, "group must be a whole number, not True"),
        ({"group": 2**31}, "group must be at most 2147483647"),
    ],
)
def test_bad_filters_are_refused(given: dict[str, Any], sentence: str) -> None:
    world = World()
    body = world.add(Circle(1))
    with pytest.raises((TypeError, ValueError), match=sentence):
        world.add(Circle(1), **given)
    with pytest.raises((TypeError, ValueError), match=sentence):
        setattr(body, *given.popitem())


def test_ignoring_takes_two_bodies_of_the_world() -> None:
    world = World()
    a, _ = meeting(world)
    with pytest.raises(ValueError, match="it takes two bodies, not circle 1 twice"):
        world.ignore(a, a)
    with pytest.raises(TypeError, match="it takes a body of this world, not 3"):
        world.ignore(a, 3)  # type: ignore[arg-type]
    with pytest.raises(Removed):
        world.heed(a, World().add(Circle(1)))


def test_to_ignore_twice_wakes_nobody() -> None:
    world = World(gravity=(0, -9.81), sleeping=True)
    world.add(Wall((-5, 0), (5, 0)))
    box, ghost = world.add(Box(1, 1), position=(0, 0.5)), world.add(Circle(0.5), position=(3, 0.5))
    world.ignore(box, ghost)
    world.run(120)
    assert box.is_asleep
    world.ignore(ghost, box)
    assert box.is_asleep
    world.heed(ghost, box)
    assert not box.is_asleep
