"""Resting contacts are looked at again only where something may have changed."""

import math

import pytest

from engine import Circle, Polygon, Wall, World
from engine.kernels.following import closes_faster
from engine.kernels.searching import approach_at

G = 9.81


def heap() -> World:
    """Boxes and discs that lie on each other in a bin."""
    world = World(gravity=(0, -G), integrator="velocity-verlet", kernels="interpreted")
    for start, end in (((0, 4), (0, 0)), ((0, 0), (3, 0)), ((3, 0), (3, 4))):
        world.add(Wall(start, end), friction=0.5)
    for i in range(12):
        shape = Circle(0.35) if i % 3 == 0 else Polygon.box(0.8, 0.5)
        world.add(shape, position=(0.6 + (i % 3) * 0.9, 0.5 + i // 3), friction=0.5)
    world.run(90)
    return world


@pytest.mark.parametrize("seed", range(5))
def test_no_contact_that_closes_fast_is_overlooked(seed: int) -> None:
    """Bodies get any velocities: what geometry finds closing, the noted contact finds as well."""
    world = heap()
    t = world.tables
    bodies = t.bodies
    for row in range(t.counts.bodies[0]):
        if bodies.moves[row] == 1:
            bodies.vx[row] = math.sin(7 * row + seed)
            bodies.vy[row] = math.sin(5 * row + 2 * seed)
            bodies.spin[row] = 3 * math.sin(3 * row + 3 * seed)
            bodies.path_x[row] = bodies.path_y[row] = bodies.path_spin[row] = 0.0
    looked_at = 0
    for pair in range(t.counts.pairs[0]):
        if t.pairs.state[pair] == 1:
            speed = approach_at(t, pair, 0.0)
            assert closes_faster(t, pair, 0.0, speed)
            looked_at += 1
    assert looked_at > 10


def test_a_contact_that_opens_is_left_alone() -> None:
    world = World(gravity=(0, -G), integrator="velocity-verlet", kernels="interpreted")
    world.add(Wall((-2, 0), (2, 0)), friction=0.5)
    box = world.add(Polygon.box(1, 1), position=(0, 0.5), friction=0.5)
    world.run(10)
    box.velocity = (0.0, 1.0)
    assert not closes_faster(world.tables, 0, 0.0, 0.1)
    box.velocity = (0.0, -1.0)
    assert closes_faster(world.tables, 0, 0.0, 0.1)


def test_a_blow_in_one_corner_leaves_the_other_as_it_was() -> None:
    """Two towers far apart in one world; what a ball does to one is not felt in the other: as long
    as all that rested ended that when something was hit, its springs yielded by 0.25 mm.
    """

    def towers(hit: bool) -> list[tuple[float, ...]]:
        world = World(gravity=(0, -G), integrator="velocity-verlet", kernels="interpreted")
        world.add(Wall((-5, 0), (25, 0)), friction=0.5)
        boxes = [
            world.add(Polygon.box(1, 1), position=(x, k + 0.5), friction=0.5)
            for x in (0.0, 20.0)
            for k in range(3)
        ]
        ball = world.add(Circle(0.2), position=(0.4, 4.0 if hit else 40.0), mass=3)
        world.run(60)
        assert (ball.speed < 3.0) == hit
        return [(*box.position, box.angle) for box in boxes[3:]]

    assert towers(True) == towers(False)
