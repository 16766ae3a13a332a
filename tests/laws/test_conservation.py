"""What is kept: momentum, angular momentum and, with e = 1, kinetic energy."""

import math
import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine import Circle, Particle, Polygon, Wall, World


def box_of(size: float, world: World, restitution: float) -> None:
    corners = [(0, 0), (size, 0), (size, size), (0, size)]
    for i in range(4):
        world.add(Wall(corners[i], corners[(i + 1) % 4]), restitution=restitution)


def shape(dice: random.Random, spinning: bool = True) -> Circle | Polygon | Particle:
    kind = dice.randrange(3)
    if kind == 0:
        return Circle(dice.uniform(0.2, 0.5))
    if kind == 1 and not spinning:
        return Particle(dice.uniform(0.2, 0.5))
    return Polygon.regular(dice.randrange(3, 8), dice.uniform(0.3, 0.6))


@given(seed=st.integers(0, 10**6), e=st.floats(0, 1), friction=st.floats(0, 1))
@settings(max_examples=12, deadline=None, derandomize=True)
def test_isolated_bodies_keep_momentum_and_angular_momentum(
    seed: int, e: float, friction: float
) -> None:
    dice = random.Random(seed)
    world = World()
    for i in range(9):
        place = (3 * (i % 3) + dice.uniform(-0.5, 0.5), 3 * (i // 3) + dice.uniform(-0.5, 0.5))
        aim = (dice.uniform(0, 1) * (3 - place[0]), dice.uniform(0, 1) * (3 - place[1]))
        world.add(
            shape(dice),
            mass=dice.uniform(0.2, 5),
            position=place,
            velocity=aim,
            spin=dice.uniform(-3, 3),
            restitution=e,
            friction=friction,
        )
    momentum, spin = world.momentum, world.angular_momentum
    energy = world.kinetic_energy
    of_size = sum(body.mass * body.speed for body in world)
    collisions = 0
    for _ in range(120):
        collisions += len(world.step())
        assert world.kinetic_energy <= energy * (1 + 1e-9)
    assert world.momentum == pytest.approx(momentum, abs=1e-12 * of_size)
    assert world.angular_momentum == pytest.approx(spin, abs=1e-11 * of_size)


def test_ten_thousand_steps_of_rubbing_bodies() -> None:
    """Two boxes and a disc that push, rub and turn on each other, far from everything else."""
    world = World()
    a = world.add(Polygon.box(1, 1), mass=2, velocity=(1, 0.2), friction=0.5, restitution=0.2)
    world.add(Polygon.box(1, 2), mass=1, position=(2, 0.3), spin=0.5, friction=0.5)
    world.add(Circle(0.5), mass=3, position=(4, -0.2), velocity=(-1.2, 0), friction=0.5)
    momentum, turning = world.momentum, world.angular_momentum
    collisions = sum(len(world.step()) for _ in range(10_000))
    assert collisions > 2
    assert a.speed > 0
    size = sum(body.mass * (body.speed + abs(body.spin)) for body in world)
    assert world.momentum == pytest.approx(momentum, abs=1e-12 * size)
    far = max(abs(body.x) + abs(body.y) for body in world)
    assert world.angular_momentum == pytest.approx(turning, abs=1e-12 * size * far)


def test_a_hundred_elastic_particles_keep_their_energy_for_a_minute() -> None:
    dice = random.Random(5)
    world = World()
    box_of(10, world, 1.0)
    for i in range(100):
        world.add(
            Particle(dice.uniform(0.05, 0.2)),
            mass=dice.uniform(0.1, 3),
            position=(0.5 + i % 10, 0.5 + i // 10),
            velocity=(dice.uniform(-2, 2), dice.uniform(-2, 2)),
            restitution=1.0,
        )
    energy = world.kinetic_energy
    collisions = sum(len(world.step()) for _ in range(3600))
    assert collisions > 1000
    assert world.kinetic_energy == pytest.approx(energy, rel=1e-9)
    for body in world:
        if not body.is_wall:
            assert 0 < body.x < 10
            assert 0 < body.y < 10


@pytest.mark.parametrize("friction", [0.0, 0.5])
def test_mixed_shapes_stay_in_their_box(friction: float) -> None:
    dice = random.Random(11)
    world = World(gravity=(0, -9.81))
    box_of(6, world, 0.5)
    for i in range(12):
        world.add(
            shape(dice, spinning=False),
            position=(0.8 + 1.4 * (i % 4), 0.8 + 1.6 * (i // 4)),
            velocity=(dice.uniform(-8, 8), dice.uniform(-8, 8)),
            restitution=dice.random(),
            friction=friction,
        )
    for _ in range(240):
        world.step()
    for body in world:
        if not body.is_wall:
            assert 0 < body.x < 6
            assert 0 < body.y < 6


@given(seed=st.integers(0, 10**6), e=st.floats(0.05, 1))
@settings(max_examples=12, deadline=None, derandomize=True)
def test_reported_impulses_sum_to_the_change_of_momentum(seed: int, e: float) -> None:
    dice = random.Random(seed)
    world = World()
    box_of(4, world, e)
    body = world.add(
        shape(dice, spinning=False),
        mass=dice.uniform(0.5, 3),
        position=(2, 2),
        velocity=(dice.uniform(-9, 9), dice.uniform(-9, 9)),
        restitution=e,
    )
    before = body.momentum
    x = y = 0.0
    for _ in range(90):
        for collision in world.step():
            sign = 1 if collision.b is body else -1
            assert body in (collision.a, collision.b)
            x += sign * collision.impulse.x
            y += sign * collision.impulse.y
    after = body.momentum
    assert (after.x - before.x, after.y - before.y) == pytest.approx((x, y), abs=1e-9)


@pytest.mark.parametrize("offset", [0.0, 0.1, 0.6])
@pytest.mark.parametrize(
    "pair",
    [
        (Circle(0.5), Circle(0.5)),
        (Particle(0.5), Circle(0.5)),
        (Polygon.box(1, 1), Circle(0.5)),
        (Polygon.box(1, 1), Polygon.regular(5, 0.6)),
    ],
)
def test_overlapping_bodies_come_apart_and_gain_no_energy(
    pair: tuple[Circle | Polygon | Particle, ...], offset: float
) -> None:
    world = World()
    a = world.add(pair[0], mass=2.0)
    b = world.add(pair[1], position=(offset, 0.05 * offset))
    peak = 0.0
    for _ in range(300):
        world.step()
        peak = max(peak, world.kinetic_energy)
    assert world.kinetic_energy < 1e-6
    assert math.dist(a.position, b.position) > 0.9
    assert world.momentum == pytest.approx((0, 0), abs=1e-9)
