"""Friction at rest and in motion, rolling resistance, conveyors, materials: closed forms."""

import math
from collections.abc import Callable
from typing import Any

import pytest

from engine import Body, Box, Capsule, Chain, Circle, Particle, Wall, World

G = 9.81


def incline(theta: float, **floor: float) -> World:
    """A floor under a gravity that is tilted by theta, downhill to +x."""
    world = World(gravity=(G * math.sin(theta), -G * math.cos(theta)))
    world.add(Wall((-50, 0), (50, 0)), **floor)
    return world


def steps(world: World, seconds: float) -> None:
    for _ in range(round(seconds * 60)):
        world.step()


@pytest.mark.parametrize("grip", [0.3, 0.6, 1.0])
def test_what_rests_holds_up_to_the_tangent_of_static_friction(grip: float) -> None:
    """Coulomb: it slips where tan(theta) = mu_s, and then slides with mu_k, at once."""
    for factor, holds in ((0.995, True), (1.005, False)):
        theta = math.atan(grip * factor)
        world = incline(theta, friction=0.2, static_friction=grip)
        box = world.add(Box(1, 0.4), position=(0, 0.2), friction=0.2, static_friction=grip)
        steps(world, 2)
        if holds:
            assert box.speed < 1e-6
            assert abs(box.x) < 1e-3
        else:
            rate = G * (math.sin(theta) - 0.2 * math.cos(theta))
            assert box.vx == pytest.approx(2 * rate, abs=rate / 300)


def test_what_slides_to_a_stop_stays_by_static_friction() -> None:
    """mu_k < tan(theta) < mu_s: sliding it would not stop by itself; uphill it stops, and holds."""
    theta = 0.3
    world = incline(theta, friction=0.1, static_friction=0.5)
    box = world.add(
        Box(1, 0.4), position=(0, 0.2), velocity=(-3, 0), friction=0.1, static_friction=0.5
    )
    rate = G * (math.sin(theta) + 0.1 * math.cos(theta))
    steps(world, 2.0)
    assert box.x == pytest.approx(-9 / (2 * rate), rel=5e-3)
    assert box.speed < 1e-6


@pytest.mark.parametrize("vx", [-0.05, 0.0, 0.05, 1.0])
@pytest.mark.parametrize(("grip", "holds"), [(0.2, False), (0.58, False), (0.6, True)])
def test_static_friction_holds_the_foot_of_a_rod_that_lands_on_it(
    grip: float, holds: bool, vx: float
) -> None:
    """Routh, 1905, art. 187: the foot of a rod that falls without turning is driven aside by
    (r x n)(r x t)/I a unit impulse, which friction stops with 1/m + (r x t)^2/I: static friction
    holds if the ratio is no larger than mu_s. What slid before must come to a stop first. Friction
    in turn drives the foot down, so that both laws hold only together: nothing approaches, and the
    foot stands, or kinetic friction does all that it can.
    """
    theta, length = 0.8, 2.0
    world = World()
    world.add(Wall((-9, 0), (9, 0)), friction=0.2, static_friction=grip)
    foot = (-length / 2 * math.cos(theta), -length / 2 * math.sin(theta))
    world.add(
        Capsule(length, 1e-6), inertia=length**2 / 12, friction=0.2, static_friction=grip,
        position=(0, 1), angle=theta, velocity=(vx, -4),
    )  # fmt: skip
    while not (hits := world.step()):
        pass
    turn = 12 / length**2
    down, aside, cross = 1 + foot[0] ** 2 * turn, 1 + foot[1] ** 2 * turn, foot[0] * foot[1] * turn
    assert cross / aside == pytest.approx(0.58942, abs=1e-5)
    if holds and vx >= 0.0:
        normal = (4 * aside - vx * cross) / (down * aside - cross**2)
        along = (normal * cross - vx) / aside
    else:
        normal = 4 / (down - 0.2 * cross)
        along = 0.2 * normal
    assert hits[0].impulse == pytest.approx((along, normal), rel=1e-5)


@pytest.mark.parametrize("size", [0.05, 1.0, 8.0])
@pytest.mark.parametrize("belt", [0.0, 1.5])
def test_what_slides_feels_no_static_friction_until_it_stops(belt: float, size: float) -> None:
    """A column of half-width w and height 2 h slides upright if mu_k < w/h, whatever mu_s (Coulomb;
    moments about its front edge): it stops, or has the speed of its belt, after v^2/(2 mu_k g).
    """
    v = 0.8 * math.sqrt(size)
    world = World(gravity=(0, -G))
    world.add(Wall((-90, 0), (90, 0)), friction=0.1, static_friction=0.9, surface_speed=belt * v)
    column = world.add(
        Box(0.4 * size, 2 * size), position=(0, size), velocity=((belt + 1) * v, 0),
        friction=0.1, static_friction=0.9,
    )  # fmt: skip
    lasts = v / (0.1 * G)
    ticks = math.ceil(60 * lasts) + 30
    for _ in range(ticks):
        assert world.step() == []
        assert abs(column.angle) < 3e-3
    way = v * v / (0.2 * G) + belt * v * ticks / 60
    assert column.x == pytest.approx(way, abs=2e-3 * size)
    assert column.vx == pytest.approx(belt * v, abs=1e-4 * v)


def test_static_friction_is_that_of_motion_unless_given() -> None:
    world = World()
    box = world.add(Box(1, 1), friction=0.4)
    assert box.static_friction == 0.4
    box.friction = 0.6
    assert box.static_friction == 0.6
    box.static_friction = 0.9
    assert (box.friction, box.static_friction) == (0.6, 0.9)
    with pytest.raises(ValueError, match=r"at least friction, which is 1.0, not 0.9"):
        box.friction = 1.0
    box.static_friction = None
    assert box.static_friction == 0.6


@pytest.mark.parametrize(
    ("belt", "way"),
    [
        (lambda world: world.add(Wall((-9, 0), (9, 0)), friction=0.25, surface_speed=2), 1),
        (lambda world: world.add(Wall((9, 0), (-9, 0)), friction=0.25, surface_speed=2), -1),
        (
            lambda world: world.add(
                Chain([(-9, 0), (-1, 0), (1, 0), (9, 0)]), friction=0.25, surface_speed=2
            ),
            1,
        ),
        (
            lambda world: world.add(
                Box(18, 1), kind="static", position=(0, -0.5), friction=0.25, surface_speed=-2
            ),
            1,
        ),
    ],
)
def test_a_conveyor_brings_a_box_to_its_speed(belt: Callable[[World], Body], way: int) -> None:
    """After v / (mu g), on a way of v^2 / (2 mu g)."""
    world = World(gravity=(0, -G))
    belt(world)
    box = world.add(Box(1, 0.4), mass=3, position=(0, 0.2), friction=1.0)
    rate = 0.5 * G
    steps(world, 0.2)
    assert box.vx == pytest.approx(way * rate * 0.2, rel=1e-3)
    steps(world, 0.8)
    assert box.vx == pytest.approx(way * 2.0, rel=1e-6)
    assert box.x == pytest.approx(way * (2.0 * 1.0 - 4.0 / (2 * rate)), rel=2e-3)


def test_a_box_held_on_a_conveyor_is_pulled_with_kinetic_friction() -> None:
    """The stop bears mu_k m g, so that the box stays."""
    world = World(gravity=(0, -G))
    world.add(Wall((-9, 0), (9, 0)), friction=0.3, surface_speed=1.0)
    world.add(Wall((2, -1), (2, 3)))
    box = world.add(Box(1, 1), position=(1.5, 0.5), friction=0.3)
    steps(world, 3)
    assert box.position == pytest.approx((1.5, 0.5), abs=2e-3)
    assert box.speed < 1e-3


@pytest.mark.parametrize(("friction", "leaves"), [(1.0, 3.0), (0.1, 0.1 * 1.5 * 4.0)])
def test_a_conveyor_pulls_at_what_bounces_off_it(friction: float, leaves: float) -> None:
    """What sticks leaves with its speed, what slips with mu (1 + e) v_n."""
    world = World()
    world.add(Wall((-9, 0), (9, 0)), friction=friction, surface_speed=3.0)
    ball = world.add(
        Particle(0.2), position=(0, 1), velocity=(0, -4), restitution=0.5, friction=friction
    )
    while not world.step():
        pass
    assert ball.velocity == pytest.approx((leaves, 2.0), rel=1e-9)


@pytest.mark.parametrize(("radius", "arm"), [(0.5, 0.01), (0.2, 0.02)])
def test_a_rolling_disc_is_braked_by_rolling_resistance(radius: float, arm: float) -> None:
    """I w' = f R - b N, m v' = -f, v = w R, I = m R^2 / 2: v' = -(2/3) (b / R) g."""
    world = incline(0.0, friction=1.0, rolling_resistance=arm)
    disc = world.add(
        Circle(radius), position=(0, radius), velocity=(1.5, 0), spin=-1.5 / radius, friction=1.0
    )
    rate = 2 / 3 * arm / radius * G
    steps(world, 1.0)
    assert disc.vx == pytest.approx(1.5 - rate, rel=2e-3)
    assert disc.spin == pytest.approx(-disc.vx / radius, rel=1e-3)
    steps(world, 1.5 / rate)
    assert disc.x == pytest.approx(1.5 * 1.5 / (2 * rate), rel=5e-3)
    assert disc.speed < 1e-6


@pytest.mark.parametrize(("factor", "holds"), [(0.99, True), (1.05, False)])
def test_rolling_resistance_holds_a_disc_on_a_slope(factor: float, holds: bool) -> None:
    """Up to tan(theta) = b / R."""
    world = incline(math.atan(factor * 0.1), friction=1.0, rolling_resistance=0.05)
    disc = world.add(Circle(0.5), position=(0, 0.5), friction=1.0)
    steps(world, 3)
    assert (disc.speed < 1e-6) is holds


@pytest.mark.parametrize("shape", [0.25, 0.5, 1.0])
@pytest.mark.parametrize("radius", [0.01, 0.5, 8.0])
@pytest.mark.parametrize(
    ("theta", "friction", "factor"),
    [(0.0525, 1.1, 0.05), (0.3, 0.5, 0.1), (0.6, 0.2, 0.1), (0.7, 0.16, 0.19), (1.0, 2.0, 0.3)],
)
def test_a_disc_rolls_or_slides_off_down_a_slope_in_its_first_tick(
    shape: float, radius: float, theta: float, friction: float, factor: float
) -> None:
    """I = k m R^2, b = c R: it rolls with a = g (sin - c cos)/(1 + k) if that takes no more than
    mu g cos of friction; else it slides with g (sin - mu cos), and turns with (mu - c) g cos/(k R),
    if at all. Friction and rolling resistance depend on each other: solved in turn, they take many
    sweeps.
    """
    world = incline(theta, friction=friction)
    disc = world.add(
        Circle(radius), inertia=shape * radius**2, position=(0, radius), friction=friction,
        rolling_resistance=factor * radius,
    )  # fmt: skip
    drive, load = G * math.sin(theta), G * math.cos(theta)
    a = (drive - factor * load) / (1 + shape)
    turns = a
    if drive - a > friction * load:
        a = drive - friction * load
        turns = (friction - factor) * load / shape if friction > factor else 0.0
    world.step()
    assert disc.vx * 60 == pytest.approx(a, rel=5e-4)
    assert disc.spin * radius * 60 == pytest.approx(-turns, rel=5e-4, abs=1e-9)


def test_rubbing_keeps_momentum_and_angular_momentum() -> None:
    """Two free bodies pressed together by forces; what one loses by friction the other gets."""
    world = World()
    table = world.add(
        Box(3, 0.5), mass=2, friction=0.3, static_friction=0.6, rolling_resistance=0.02
    )
    ball = world.add(
        Circle(0.3), position=(0.3, 0.55), velocity=(1, 0), spin=5, friction=0.3, mass=0.5
    )
    momentum, turning = world.momentum, world.angular_momentum
    for _ in range(200):
        way = (table.x - ball.x, table.y - ball.y)
        ball.apply_impulse((0.01 * way[0], 0.01 * way[1]))
        table.apply_impulse((-0.01 * way[0], -0.01 * way[1]))
        world.step()
    assert world.momentum == pytest.approx(momentum, abs=1e-12)
    assert world.angular_momentum == pytest.approx(turning, abs=1e-12)


def test_two_materials_have_coefficients_of_their_own() -> None:
    world = incline(0.0, friction=1.0, material="ice")
    world.set_material_pair("steel", "ice", friction=0.05, restitution=0.5)
    sled = world.add(
        Box(1, 0.4), position=(0, 0.2), velocity=(4, 0), friction=1.0, material="steel"
    )
    boot = world.add(
        Box(1, 0.4), position=(-5, 0.2), velocity=(2, 0), friction=1.0, material="rubber"
    )
    drop = world.add(Particle(0.1), position=(20, 0.6), material="steel")
    hits = []
    for _ in range(60):
        hits += world.step()
    assert sled.vx == pytest.approx(4 - 0.05 * G, rel=1e-3)
    assert boot.vx == pytest.approx(0, abs=1e-6)
    assert {hit.restitution for hit in hits if hit.b is drop} == {0.5}
    assert sled.material == "steel"
    sled.material = None
    steps(world, 0.2)
    assert sled.vx < 4 - 0.05 * G - 1.0


def test_materials_are_saved_and_told_apart() -> None:
    def fill(friction: float) -> World:
        world = incline(0.0, friction=1.0, material="ice")
        world.set_material_pair("wood", "ice", friction=0.7)
        world.set_material_pair("ice", "wood", friction=friction)
        world.add(Box(1, 0.4), position=(0, 0.2), velocity=(4, 0), friction=1.0, material="wood")
        steps(world, 0.1)
        return world

    one, other = fill(0.1), fill(0.2)
    assert one.digest() != other.digest()
    again = World.from_dict(one.to_dict())
    assert again.body(2).material == "wood"
    steps(one, 0.5)
    steps(again, 0.5)
    assert again.digest() == one.digest()
    assert one.body(2).vx == pytest.approx(4 - 0.1 * G * 0.6, rel=1e-3)


def test_a_rule_of_ones_own_makes_static_friction_too() -> None:
    world = World(gravity=(0, -G), friction_rule=lambda a, b: a + b)
    world.add(Wall((-9, 0), (9, 0)), friction=0.1, static_friction=0.2)
    world.add(Box(1, 0.4), position=(0, 0.2), friction=0.2, static_friction=0.5)
    world.step()
    assert world.tables.pairs.friction[0] == pytest.approx(0.3)
    assert world.tables.pairs.static_friction[0] == pytest.approx(0.7)


NAN = math.nan


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"static_friction": -1}, "static_friction must not be negative, not -1.0"),
        ({"static_friction": 0.1, "friction": 0.2}, "must be at least friction, which is 0.2"),
        ({"static_friction": "x"}, "static_friction must be a number, not 'x'"),
        ({"rolling_resistance": NAN}, "rolling_resistance must be finite, not nan"),
        ({"rolling_resistance": -0.1}, "rolling_resistance must not be negative"),
        ({"surface_speed": math.inf}, "surface_speed must be finite, not inf"),
        ({"material": 3}, "material must be a name, not 3"),
        ({"material": ""}, "material must have 1 to 100 characters, not 0"),
    ],
)
def test_bad_contact_laws(given: dict[str, Any], says: str) -> None:
    world = World()
    with pytest.raises((ValueError, TypeError), match=says):
        world.add(Circle(1), **given)
    body = world.add(Circle(1), friction=0.2)
    name, value = next(iter(given.items()))
    with pytest.raises((ValueError, TypeError)):
        setattr(body, name, value)
    with pytest.raises(TypeError, match="material must be a name"):
        world.set_material_pair("a", None)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="friction must not be negative"):
        world.set_material_pair("a", "b", friction=-1)
    with pytest.raises(ValueError, match="restitution must be between 0 and 1"):
        world.set_material_pair("a", "b", restitution=2)
