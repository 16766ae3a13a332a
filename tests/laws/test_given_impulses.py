"""Newton's second law tick by tick: what contacts and forces give a body is what it gains."""

import math
from collections.abc import Callable

import pytest

from engine import Circle, Force, Particle, Polygon, SpringTo, Wall, World

DT = 1 / 60


def closed_room(world: World, restitution: float, friction: float) -> None:
    corners = [(0, 0), (6, 0.5), (6, 6), (0, 6)]
    for i in range(4):
        wall = Wall(corners[i], corners[(i + 1) % 4])
        world.add(wall, restitution=restitution, friction=friction)


def tumbling() -> World:
    world = World(gravity=(0.5, -9.81), integrator="velocity-verlet")
    closed_room(world, 0.6, 0.2)
    kinds = [Circle(0.3), Particle(0.25), Polygon.box(0.7, 0.5), Polygon.regular(5, 0.4)]
    for i in range(12):
        world.add(
            kinds[i % 4],
            mass=0.5 + 0.25 * i,
            position=(0.9 + 1.3 * (i % 4), 1.3 + 1.5 * (i // 4)),
            angle=0.3 * i,
            velocity=(math.sin(i) * 3, math.cos(3 * i)),
            restitution=0.1 * (i % 10),
            friction=0.05 * i,
        )
    return world


def tower() -> World:
    """It stands, and is hit by a ball after a while."""
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    world.add(Wall((-9, 0), (9, 0)), friction=0.5)
    for i in range(5):
        world.add(Polygon.box(1, 1), position=(0, 0.5 + i), friction=0.5)
    world.add(Circle(0.3), mass=3.0, position=(-8.0, 2.8), velocity=(9, 2.5), restitution=0.3)
    return world


def gas() -> World:
    world = World(integrator="velocity-verlet")
    closed_room(world, 1.0, 0.0)
    for i in range(20):
        angle = 2.4 * i
        world.add(
            Circle(0.2), mass=1.0 + i % 3, position=(0.8 + i % 5, 1.0 + i // 5),
            velocity=(20 * math.cos(angle), 20 * math.sin(angle)), restitution=1.0,
        )  # fmt: skip
    return world


def carried() -> World:
    """A moving platform, a box that is pushed on it, and a ball in a spring."""
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    world.add(
        Polygon.box(20, 1), kind="kinematic", position=(0, -0.5), velocity=(1, 0), friction=0.4
    )
    box = world.add(Polygon.box(1, 1), mass=2.0, position=(0, 0.5), friction=0.4)
    box.exert(Force(3.0, 1.0), duration=0.71, at=(0.2, 0.9))
    ball = world.add(Circle(0.25), position=(2.0, 1.5), restitution=0.7, friction=0.3)
    world.add_law(SpringTo((0, 1), 8.0), [ball])
    return world


def rocking() -> World:
    """Boxes that topple and slap: contacts that begin and end within a tick."""
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    world.add(Wall((-9, 0), (9, 0)), friction=0.6, restitution=0.2)
    for i in range(6):
        world.add(
            Polygon.box(1, 0.4), position=(0.35 * i - 1, 1.0 + 0.6 * i), angle=0.4 * i,
            friction=0.6,
        )  # fmt: skip
    return world


@pytest.mark.parametrize("scene", [tumbling, tower, gas, carried, rocking])
def test_impulses_of_contacts_and_forces_add_up_to_the_change_of_momentum(
    scene: Callable[[], World],
) -> None:
    world = scene()
    bodies = [body for body in world if body.is_dynamic]
    scale = max(body.mass * (body.speed + 9.81) for body in bodies)
    for _ in range(150):
        before = {body: body.momentum for body in bodies}
        world.step(DT)
        given_x = {body: body.force.x * DT for body in world}
        given_y = {body: body.force.y * DT for body in world}
        for contact in world.contacts:
            given_x[contact.b] += contact.impulse.x
            given_y[contact.b] += contact.impulse.y
            given_x[contact.a] -= contact.impulse.x
            given_y[contact.a] -= contact.impulse.y
        for body in bodies:
            gained_x = body.momentum.x - before[body].x
            gained_y = body.momentum.y - before[body].y
            assert given_x[body] == pytest.approx(gained_x, abs=1e-12 * scale)
            assert given_y[body] == pytest.approx(gained_y, abs=1e-12 * scale)


def test_a_floor_carries_the_weight_of_what_stands_on_it() -> None:
    """m g dt a tick, through every box of a tower: 1, 2, 3 weights."""
    world = World(gravity=(0, -9.81))
    world.add(Wall((-9, 0), (9, 0)), friction=0.5)
    for i in range(3):
        world.add(Polygon.box(1, 1), mass=2.0, position=(0, 0.5 + i), friction=0.5)
    for _ in range(300):
        world.step(DT)
    weight = 2.0 * 9.81 * DT
    loads = [contact.impulse.y / weight for contact in world.contacts]
    assert loads == pytest.approx([3.0, 2.0, 1.0], rel=1e-3)
    assert [contact.normal.y for contact in world.contacts] == pytest.approx([1, 1, 1])
    for i, contact in enumerate(world.contacts):
        assert sorted(point.x for point in contact.points) == pytest.approx([-0.5, 0.5], abs=1e-2)
        assert [point.y for point in contact.points] == pytest.approx([i, i], abs=1e-2)


def test_friction_on_a_slope_balances_the_pull() -> None:
    """A block that sticks on 20 degrees: the slope gives it m g straight up."""
    angle = math.radians(20)
    world = World(gravity=(0, -9.81))
    way = (math.cos(angle), math.sin(angle))
    world.add(Wall((-5 * way[0], -5 * way[1]), (5 * way[0], 5 * way[1])), friction=0.5)
    world.add(
        Polygon.box(1, 1), mass=3.0, position=(-0.5 * way[1], 0.5 * way[0]), angle=angle,
        friction=0.5,
    )  # fmt: skip
    for _ in range(200):
        world.step(DT)
    (contact,) = world.contacts
    assert contact.impulse.x == pytest.approx(0.0, abs=3.0 * 9.81 * DT * 1e-3)
    assert contact.impulse.y == pytest.approx(3.0 * 9.81 * DT, rel=1e-3)
    assert contact.normal == pytest.approx((-way[1], way[0]), abs=1e-4)
