"""Bodies that rest, slide and roll: Coulomb's law against closed forms."""

import math

import pytest

from engine import Body, Circle, Force, Polygon, Wall, World

G = 9.81


def flat(friction: float, integrator: str = "velocity-verlet") -> World:
    world = World(gravity=(0, -G), integrator=integrator)
    world.add(Wall((-10, 0), (60, 0)), friction=friction)
    return world


def slope(degrees: float, friction: float) -> tuple[World, Body]:
    angle = math.radians(degrees)
    along, up = (math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(
        Wall((-40 * along[0], -40 * along[1]), (40 * along[0], 40 * along[1])), friction=friction
    )
    place = (20 * along[0] + 0.5 * up[0], 20 * along[1] + 0.5 * up[1])
    return world, world.add(
        Polygon.box(1, 1), position=place, angle=angle, friction=friction, mass=3.0
    )


@pytest.mark.parametrize("integrator", ["semi-implicit-euler", "velocity-verlet"])
@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
def test_a_box_at_rest_stays_at_rest_for_a_minute(integrator: str, e: float) -> None:
    world = flat(0.5, integrator)
    box = world.add(Polygon.box(1, 1), position=(1, 0.5), restitution=e, friction=0.5)
    collisions = 0
    for _ in range(3600 if e == 0.5 else 600):
        collisions += len(world.step())
        assert box.speed < 1e-3
    assert collisions == 0
    assert box.position == pytest.approx((1, 0.5), abs=1e-4)
    assert box.angle == pytest.approx(0, abs=1e-6)
    assert box.speed < 1e-9


def test_a_landing_is_reported_and_resting_is_not() -> None:
    world = flat(0.5)
    box = world.add(Polygon.box(1, 1), position=(0, 1.5), friction=0.5)
    when = [c.time for _ in range(300) for c in world.step()]
    assert when == pytest.approx([math.sqrt(2 / G)], abs=1e-6)
    assert box.y == pytest.approx(0.5, abs=1e-4)


def test_a_stack_of_five_stands() -> None:
    world = flat(0.5)
    boxes = [
        world.add(Polygon.box(1, 1), position=(0, 0.5 + i), friction=0.5, restitution=0.3)
        for i in range(5)
    ]
    for _ in range(600):
        world.step()
    for i, box in enumerate(boxes):
        assert box.x == pytest.approx(0, abs=1e-3)
        assert box.y == pytest.approx(0.5 + i, abs=3e-3)
        assert box.angle == pytest.approx(0, abs=1e-3)
        assert box.speed < 1e-3


@pytest.mark.parametrize(("degrees", "a"), [(10, 1.70349), (20, 3.35522), (30, 4.905)])
def test_slope_without_friction(degrees: float, a: float) -> None:
    world, box = slope(degrees, 0.0)
    start = box.position
    for _ in range(120):
        world.step()
    assert box.speed == pytest.approx(2 * a, rel=1e-5)
    assert math.dist(start, box.position) == pytest.approx(2 * a, rel=1e-5)


@pytest.mark.parametrize(("degrees", "a"), [(20, 1.51154), (30, 3.20586)])
def test_slope_with_friction(degrees: float, a: float) -> None:
    """a = g (sin - mu cos), mu = 0.2."""
    world, box = slope(degrees, 0.2)
    start = box.position
    for _ in range(120):
        world.step()
    assert box.speed == pytest.approx(2 * a, rel=1e-5)
    assert math.dist(start, box.position) == pytest.approx(2 * a, rel=1e-4)


@pytest.mark.parametrize("friction", [0.2, 0.5])
def test_a_box_slides_just_above_the_angle_of_friction(friction: float) -> None:
    limit = math.degrees(math.atan(friction))
    world, box = slope(limit * 0.995, friction)
    for _ in range(120):
        world.step()
    assert box.speed < 1e-6
    world, box = slope(limit * 1.005, friction)
    for _ in range(120):
        world.step()
    assert box.speed > 1e-3


def test_stopping_distance() -> None:
    """v0^2 / (2 mu g) = 4.24737 m after v0 / (mu g) = 1.69895 s."""
    world = flat(0.3)
    box = world.add(Polygon.box(1, 1), position=(0, 0.5), velocity=(5, 0), friction=0.3)
    while box.vx > 1e-6:
        world.step()
    assert world.time == pytest.approx(1.69895, abs=1 / 60)
    for _ in range(60):
        world.step()
    assert box.x == pytest.approx(4.24737, rel=1e-4)


def test_a_sliding_disc_comes_to_roll() -> None:
    """At 2/3 of its speed, after 0.566316 s and 2.359649 m (5 m/s, mu = 0.3)."""
    world = flat(0.3)
    disc = world.add(Circle(0.5), position=(0, 0.5), velocity=(5, 0), friction=0.3)
    while disc.vx + disc.spin * 0.5 > 1e-4:
        world.step()
    assert world.time == pytest.approx(0.566316, abs=1 / 60)
    after = world.time - 0.566316
    assert disc.x == pytest.approx(2.359649 + after * 10 / 3, rel=1e-3)
    for _ in range(120):
        world.step()
    assert disc.vx == pytest.approx(10 / 3, rel=1e-3)


def test_a_push_below_the_limit_of_friction_moves_nothing() -> None:
    world = flat(0.4)
    box = world.add(Polygon.box(1, 1), mass=2, position=(0, 0.5), friction=0.4)
    box.exert(Force(0.99 * 0.4 * 2 * G, 0))
    for _ in range(120):
        world.step()
    assert box.x == pytest.approx(0, abs=1e-3)


def test_a_rolling_disc_keeps_rolling() -> None:
    world = flat(0.5)
    disc = world.add(Circle(0.5), position=(0, 0.5), velocity=(2, 0), spin=-4, friction=0.5)
    for _ in range(600):
        world.step()
    assert disc.vx == pytest.approx(2, rel=2e-5)
    assert disc.x == pytest.approx(20, rel=2e-5)
