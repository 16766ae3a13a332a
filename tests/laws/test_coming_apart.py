"""What is put into one place comes apart, and gains no energy by it.

There is no law of nature for bodies that overlap. What is promised: momentum, angular momentum and
the place of the common centre are kept, the kinetic energy does not grow, all come apart.
"""

import math
import random

import pytest

from engine import Body, Box, Capsule, Circle, Particle, Pin, Polygon, Shape, Wall, World


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
    ("shape", "across"), [(Circle(0.1), 0.2), (Particle(0.1), 0.2), (Box(1, 1), 0.9)]
)
def test_five_in_one_place_come_apart(shape: Shape, across: float) -> None:
    world = World()
    bodies, peak = burst(world, shape, 5, 150)
    assert peak < 1e-20
    assert closest(bodies) > 0.98 * across
    assert sum(body.mass * body.x for body in bodies) == pytest.approx(0, abs=1e-12)
    assert sum(body.mass * body.y for body in bodies) == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize(
    ("shape", "number", "apart"),
    [(Circle(0.1), 16, 0.19), (Polygon.regular(5, 0.5), 12, 0.7), (Box(1, 1), 16, 0.9)],
)
def test_a_crowd_in_one_place_is_not_thrown_apart(shape: Shape, number: int, apart: float) -> None:
    world = World()
    bodies, peak = burst(world, shape, number, 120)
    assert peak < 1e-12
    assert closest(bodies) > apart


def test_those_that_move_come_apart_and_gain_no_energy() -> None:
    """However they slide over each other and spin meanwhile, with friction or without."""
    chance = random.Random(3)
    shapes = (Box(1, 0.6), Circle(0.4), Polygon.regular(5, 0.5), Capsule(0.6, 0.2), Particle(0.3))
    for _ in range(25):
        world = World()
        for _ in range(chance.choice((2, 3, 5))):
            world.add(
                chance.choice(shapes),
                position=(chance.uniform(-0.3, 0.3), chance.uniform(-0.3, 0.3)),
                angle=chance.uniform(0, 3),
                velocity=(chance.uniform(-1, 1), chance.uniform(-1, 1)),
                friction=chance.choice((0.0, 0.5)),
                restitution=0.0,
            )
        momentum, turn, energy = world.momentum, world.angular_momentum, world.kinetic_energy
        rounds = any(isinstance(body.shape, Particle) for body in world)
        most = energy * (1 + 1e-4)
        for _ in range(60):
            world.step()
            assert world.kinetic_energy < most
        assert world.momentum == pytest.approx(momentum, abs=1e-12)
        if not rounds:  # particles take no angular momentum of their own
            assert world.angular_momentum == pytest.approx(turn, abs=1e-12)
        assert world.ledger().energy_error == pytest.approx(0, abs=1e-12)


def test_discs_that_slide_over_each_other_part_like_a_skater_who_stretches_out() -> None:
    """Angular momentum m r v / 2 of two equal ones is kept: twice as far apart, half as fast."""
    world = World()
    a = world.add(Circle(0.2), position=(-0.1, 0), velocity=(0, -0.001), friction=0)
    b = world.add(Circle(0.2), position=(0.1, 0), velocity=(0, 0.001), friction=0)
    for _ in range(90):
        world.step()
    way_x, way_y = b.x - a.x, b.y - a.y
    apart = math.hypot(way_x, way_y)
    round_each_other = ((b.vy - a.vy) * way_x - (b.vx - a.vx) * way_y) / apart
    assert apart == pytest.approx(0.4, rel=1e-3)
    assert round_each_other == pytest.approx(0.002 * 0.2 / apart, rel=1e-9)
    assert (a.spin, b.spin) == (0, 0)


def test_lifting_out_of_an_overlap_is_paid_for_by_contacts() -> None:
    """What potential energy grows by is booked as energy that contacts gave."""
    world = World(gravity=(0, -9.81))
    world.add(Wall((-5, 0), (5, 0)))
    box = world.add(Box(1, 1), mass=2, position=(0, 0.2))
    before = world.ledger()
    for _ in range(60):
        world.step()
    books = world.ledger().since(before)
    assert box.y == pytest.approx(0.5, abs=2e-3)
    assert books.potential == pytest.approx(2 * 9.81 * (box.y - 0.2), rel=1e-12)
    assert books.dissipated.contact == pytest.approx(-books.potential, rel=1e-3)
    assert books.energy_error == pytest.approx(0, abs=1e-12)


def test_joined_bodies_in_one_place_come_apart_slowly() -> None:
    """Joints would be torn if they were moved: springs push them, which lends some velocity."""
    world = World()
    for _ in range(4):
        a = world.add(Box(0.6, 0.2), mass=1)
        b = world.add(Box(0.6, 0.2), position=(0.6, 0), mass=1)
        world.join(a, b, Pin(at=(0.3, 0)))
    peak = 0.0
    for _ in range(120):
        world.step()
        peak = max(peak, world.kinetic_energy)
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


def test_a_world_saved_while_bodies_come_apart_goes_on_to_the_same_bits() -> None:
    world = World(gravity=(0, -9.81))
    world.add(Wall((-5, 0), (5, 0)), friction=0.5)
    for x in (0, 0.1, 0.1, 0.4):
        world.add(Box(0.5, 0.5), position=(x, 0.2), friction=0.5)
    world.run(9)
    loaded = World.from_dict(world.to_dict())
    kept = world.snapshot()
    world.run(60)
    loaded.run(60)
    assert loaded.digest() == world.digest()
    world.restore(kept)
    world.run(60)
    assert loaded.digest() == world.digest()
