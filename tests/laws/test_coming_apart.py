"""What is put into one place comes apart, and is not thrown apart.

There is no law of nature for bodies that overlap. What is promised: momentum and angular momentum
are kept, nothing is faster than a push that separates two bodies a few times over, all come apart.
"""

import math

import pytest

from engine import Body, Box, Circle, Particle, Shape, Wall, World


def burst(world: World, shape: Shape, number: int, ticks: int) -> tuple[list[Body], float]:
    """Put bodies into one place; return them, and their greatest kinetic energy."""
    bodies = [world.add(shape) for _ in range(number)]
    peak = 0.0
    for _ in range(ticks):
        world.step()
        peak = max(peak, world.kinetic_energy)
    return bodies, peak


def closest(bodies: list[Body]) -> float:
    places = [body.position for body in bodies]
    return min(math.dist(p, q) for i, p in enumerate(places) for q in places[:i])


@pytest.mark.parametrize(
    ("shape", "across", "most"),
    [(Circle(0.1), 0.2, 0.02), (Particle(0.1), 0.2, 0.02), (Box(1, 1), 0.9, 1.0)],
)
def test_five_in_one_place_come_apart(shape: Shape, across: float, most: float) -> None:
    world = World()
    bodies, peak = burst(world, shape, 5, 150)
    assert peak < most
    assert closest(bodies) > 0.98 * across
    assert world.momentum == pytest.approx((0, 0), abs=1e-12)
    if not isinstance(shape, Particle):  # which takes no angular momentum of its own
        assert world.angular_momentum == pytest.approx(0, abs=1e-12)


def test_a_crowd_in_one_place_is_not_thrown_apart() -> None:
    world = World()
    _, peak = burst(world, Circle(0.1), 16, 45)
    assert peak < 0.01
    assert world.momentum == pytest.approx((0, 0), abs=1e-12)
    assert world.angular_momentum == pytest.approx(0, abs=1e-12)


def test_what_flies_apart_faster_than_a_push_goes_on() -> None:
    """The first law holds for what overlaps and leaves."""
    world = World()
    a = world.add(Circle(0.5), velocity=(-3, 0))
    b = world.add(Circle(0.5), position=(0.2, 0), velocity=(3, 0))
    for _ in range(60):
        world.step()
    assert (a.vx, b.vx) == pytest.approx((-3, 3), abs=1e-9)


def test_a_box_spawned_in_the_floor_rises_and_rests() -> None:
    world = World(gravity=(0, -9.81))
    world.add(Box(20, 2), kind="static", position=(0, -1), friction=0.5)
    box = world.add(Box(1, 1), position=(0, 0.2), friction=0.5)
    for _ in range(120):
        world.step()
        assert box.y < 0.501
    assert box.y == pytest.approx(0.5, abs=1e-3)
    assert box.speed < 1e-3


def test_bodies_spawned_in_a_heap_find_room() -> None:
    """They are pushed up against gravity, by no more than the room that they take."""
    world = World(gravity=(0, -9.81))
    world.add(Wall((-20, 0), (20, 0)), friction=0.5)
    bodies = [world.add(Box(1, 1), position=(0, 0.5 + i), friction=0.5) for i in range(3)]
    bodies.append(world.add(Box(1, 1), position=(0.1, 1.1), friction=0.5))
    for _ in range(240):
        world.step()
        assert max(body.y for body in bodies) < 4.6
    assert closest(bodies) > 0.9
    assert min(body.y for body in bodies) > 0.45
