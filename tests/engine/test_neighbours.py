"""Neighbours in the grid are those that looking at every two pieces finds, in the same order."""

import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine import Circle, Polygon, Wall, World
from engine.kernels import neighbours
from engine.kernels.broadphase import fit_boxes

places = st.floats(-50, 50) | st.sampled_from([0.0, 1e6, -1e15, 1e90])
sizes = st.sampled_from([1e-3, 0.3, 1.0, 7.0, 200.0])


def listed(world: World, few: int) -> list[tuple[int, int]]:
    """The pairs of pieces, found by comparing all where there are no more than `few`."""
    t = world.tables
    fit_boxes(t, t.counts.bodies[0], 1 / 60)
    before, neighbours.FEW = neighbours.FEW, few
    try:
        found = neighbours.find_neighbours(t, t.counts.pieces[0], t.progress.room[0])
    finally:
        neighbours.FEW = before
    return list(zip(t.found.a[:found], t.found.b[:found], strict=True))


@given(discs=st.lists(st.tuples(places, places, sizes, st.integers(0, 2)), min_size=2, max_size=40))
def test_the_grid_finds_what_comparing_all_finds(
    discs: list[tuple[float, float, float, int]],
) -> None:
    world = World()
    for i, (x, y, size, group) in enumerate(discs):
        if i % 5 == 4:
            world.add(Wall((x, y), (x + size + 0.001 * abs(x) + 1, y)))
        else:
            world.add(Circle(size), position=(x, y), velocity=(x % 7, 0), group=group)
    if len(discs) > 3:
        world.ignore(world.body(1), world.body(4))
    world.store.make_room_for_pairs(len(discs) ** 2)
    assert listed(world, few=0) == listed(world, few=10**6)


def test_no_way_of_finding_pairs_changes_a_world(monkeypatch: pytest.MonkeyPatch) -> None:
    digests = set()
    for few in (0, 10**6):
        monkeypatch.setattr(neighbours, "FEW", few)
        dice = random.Random(3)
        world = World(gravity=(0, -9.81))
        world.add(Wall((-20, 0), (20, 0)), restitution=0.4, friction=0.3)
        for i in range(30):
            world.add(
                Circle(0.3) if i % 2 else Polygon.box(0.5, 0.9),
                position=(i % 6, 0.6 + i // 6),
                velocity=(dice.uniform(-3, 3), 0),
                restitution=0.5,
                friction=0.3,
            )
        for _ in range(40):
            world.step()
        digests.add(world.digest())
    assert len(digests) == 1


def test_large_and_many_bodies_are_set_apart() -> None:
    """The side of the squares follows the many, not the few that are large."""
    world = World()
    world.add(Wall((-1e4, 0), (1e4, 0)))
    for i in range(100):
        world.add(Circle(0.5), position=(2.0 * (i % 10), 1.0 + i // 10))
    fit_boxes(world.tables, 101, 1 / 60)
    assert 1.0 < neighbours.side_of_squares(world.tables, 101) < 3.0
