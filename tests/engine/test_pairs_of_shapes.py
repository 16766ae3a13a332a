"""Every pair of shapes collides; walls are solid at both sides and ends; nothing tunnels."""

import math
from itertools import combinations_with_replacement

import pytest

from engine import (
    Body,
    Box,
    Capsule,
    Circle,
    Compound,
    Particle,
    Polygon,
    Shape,
    Wall,
    World,
)

SHAPES: list[Shape] = [
    Circle(0.5),
    Particle(0.5),
    Polygon.box(1, 1),
    Polygon.regular(3, 0.6),
    Polygon.regular(7, 0.5),
    Box(1.2, 0.6),
    Box(0.8, 0.6, rounding=0.2),
    Capsule(0.6, 0.3),
    Polygon.concave([(0, 0), (1.2, 0), (1.2, 0.4), (0.5, 0.4), (0.5, 1.1), (0, 1.1)]),
    Compound([(Circle(0.3), (-0.4, 0)), (Circle(0.3), (0.4, 0)), Box(0.8, 0.2)]),
]


@pytest.mark.parametrize(("one", "other"), list(combinations_with_replacement(SHAPES, 2)))
@pytest.mark.parametrize("angle", [0.0, 0.7])
@pytest.mark.parametrize("speed", [2.0, 2000.0])
def test_two_movable_shapes(one: Shape, other: Shape, angle: float, speed: float) -> None:
    world = World()
    a = world.add(one, position=(-3, 0), velocity=(speed, 0), angle=angle, restitution=1)
    b = world.add(other, position=(3, 0.1), velocity=(-speed, 0), restitution=1)
    energy = world.kinetic_energy
    hits = []
    while not hits and world.tick < 200:
        hits = world.step()
    assert hits
    assert hits[0].a is a
    assert hits[0].normal.x > 0.3
    assert hits[0].impulse.x * hits[0].normal.x > 0
    assert world.kinetic_energy == pytest.approx(energy, rel=1e-9)
    assert world.momentum == pytest.approx((0, 0), abs=1e-9 * speed)
    assert a.x < b.x or abs(a.y - b.y) > 0.5  # one may fly past the other after a glancing blow


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("speed", [3.0, 1000.0])
def test_a_wall_is_solid_from_both_sides(shape: Shape, side: int, speed: float) -> None:
    world = World()
    wall = world.add(Wall((-5, 0), (5, 0)))
    body = world.add(
        shape, position=(0.3, 2 * side), velocity=(0, -speed * side), restitution=1, angle=0.2
    )
    hits = []
    while not hits and world.tick < 200:
        hits = world.step()
    assert hits[0].a is wall
    assert hits[0].normal == pytest.approx((0, side), abs=1e-12)
    for _ in range(5):
        world.step()
    assert body.y * side > 0


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("speed", [3.0, 500.0])
def test_the_ends_of_a_wall_are_solid(shape: Shape, speed: float) -> None:
    """The thesis lets through a particle whose centre misses the wall (physics.md, fault 4)."""
    world = World()
    world.add(Wall((0, 0), (0, 5)))
    body = world.add(shape, position=(-3, -0.2), velocity=(speed, 0), restitution=1)
    hits = []
    while not hits and world.tick < 200:
        hits = world.step()
    assert hits
    assert hits[0].point == pytest.approx((0, 0), abs=1e-6)
    assert body.vx < speed


@pytest.mark.parametrize("shape", SHAPES)
def test_a_one_sided_wall_lets_in_and_not_out(shape: Shape) -> None:
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    world.add(Wall((-5, 0), (5, 0), one_sided=True))
    body = world.add(shape, position=(0, -2), velocity=(0, 9.5), restitution=0.5, angle=0.3)
    hits = []
    while body.y < 1 and world.tick < 120:
        hits += world.step()
    assert not hits
    while not hits and world.tick < 400:
        hits = world.step()
    assert hits[0].normal == pytest.approx((0, 1), abs=1e-12)
    for _ in range(300):
        world.step()
    assert body.y > 0


def falls_asleep(world: World, body: Body) -> None:
    for _ in range(300):
        world.step()
    assert body.speed < 1e-3


@pytest.mark.parametrize("shape", SHAPES)
def test_every_shape_comes_to_rest_on_a_polygon(shape: Shape) -> None:
    world = World(gravity=(0, -9.81))
    world.add(Wall((-5, 0), (5, 0)), friction=0.5)
    table = world.add(Polygon.box(4, 1), mass=20, position=(0, 0.5), friction=0.5)
    body = world.add(shape, position=(0, 2.2), restitution=0.3, friction=0.5)
    falls_asleep(world, body)
    assert 1.2 < body.y < 1.8
    assert table.y == pytest.approx(0.5, abs=1e-3)


def test_a_spinning_rod_hits_the_wall_with_its_end() -> None:
    world = World()
    world.add(Wall((1.0, -5), (1.0, 5)))
    rod = world.add(Polygon.box(2.4, 0.05), angle=math.pi / 2, spin=-30, restitution=1)
    energy = rod.kinetic_energy
    hits = []
    while not hits and world.tick < 60:
        hits = world.step()
    assert hits[0].point.x == pytest.approx(1.0, abs=1e-6)
    assert rod.kinetic_energy == pytest.approx(energy, rel=1e-9)
    for _ in range(60):
        world.step()
        assert max(v.x for v in rod.vertices) < 1.0 + 1e-3


def test_containment_is_resolved() -> None:
    """A body inside another is pushed out; the thesis's overlap ignores containment (fault 5)."""
    world = World()
    big = world.add(Polygon.box(2, 2), mass=5)
    small = world.add(Polygon.box(0.4, 0.4), position=(0.5, 0.1))
    for _ in range(600):
        world.step()
    assert small.x - big.x > 1.15
