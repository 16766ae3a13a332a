"""The outermost kernel: its clock, and what it records."""

import numpy as np
import pytest

from engine import Circle, Force, Particle, World, tables
from engine.bulk import RECORDED
from engine.kernels.tick import record, tell_time


def drifting() -> World:
    world = World()
    for i in range(3):
        body = world.add(Circle(0.1), position=(i, 2 * i), velocity=(i + 1, -i), spin=0.5 * i)
        body.angle = 0.1 * i
    world.add(Particle(0.1), position=(9, 9)).exert(Force(2, -3))
    world.step()
    return world


def room_for(world: World, moments: int) -> None:
    """Give the kernel room for tracks, filled with a number that it never writes."""
    rows = moments * len(world)
    columns = {name: np.full(rows, -77.0) for name in tables.Tracks._fields}
    store = world.store
    store.tables = store.tables._replace(tracks=tables.views(tables.Tracks(**columns)))
    world.tables.progress.moment[0] = 0


@pytest.mark.parametrize("name", RECORDED)
def test_it_records_what_is_asked_for_row_by_row(name: str) -> None:
    world = drifting()
    room_for(world, 2)
    world.tables.progress.recording[0] = 1 << RECORDED.index(name)
    record(world.tables)
    first = [getattr(world.bodies, name)[row] for row in range(4)]
    world.bodies.x[0] += 1.0
    record(world.tables)
    world.tables.progress.recording[0] = 0
    tracks = world.tables.tracks
    assert list(getattr(tracks, name)[:4]) == first
    assert list(getattr(tracks, name)[4:]) == [getattr(world.bodies, name)[row] for row in range(4)]
    assert world.tables.progress.moment[0] == 2
    for other in set(RECORDED) - {name}:
        assert set(getattr(tracks, other)) == {-77.0}


def test_it_records_all_at_once() -> None:
    world = drifting()
    room_for(world, 1)
    world.tables.progress.recording[0] = (1 << len(RECORDED)) - 1
    record(world.tables)
    world.tables.progress.recording[0] = 0
    for name in RECORDED:
        recorded = list(getattr(world.tables.tracks, name))
        assert recorded == [getattr(world.bodies, name)[row] for row in range(4)]
    assert world.tables.tracks.force_y[3] == pytest.approx(-3)


def test_its_clock_counts_ticks_of_one_length_without_adding_them_up() -> None:
    """A thousand ticks of 1/60 s end exactly where the product does."""
    world = World()
    for _ in range(1000):
        tell_time(world.tables, 1 / 60)
    assert world.time == 1000 * (1 / 60)
    tell_time(world.tables, 0.5)
    assert world.time == 1000 * (1 / 60) + 0.5
    assert world.tick == 1001
