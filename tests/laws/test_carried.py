"""What belts, carts and lifts do to what they carry, by Newton's second and third law."""

import math

import pytest

from engine import Box, Circle, Polygon, Wall, World

G = 9.81


@pytest.mark.parametrize("gyration", [0.2, 0.5, 1.0])
@pytest.mark.parametrize("belt", [1.2, -3.0])
def test_a_disc_put_on_a_belt_rolls_on_at_a_share_of_its_speed(
    gyration: float, belt: float
) -> None:
    """Friction mu g makes v = mu g t and turns it by v/(k r), with I = k m r^2, until the rim has
    the speed u of the belt: v = u k/(1 + k), a third of u for a disc. Nothing brakes it then.
    """
    mu, radius = 0.3, 0.4
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-60, 0), (60, 0)), friction=mu, surface_speed=belt)
    disc = world.add(
        Circle(radius), mass=2.0, inertia=gyration * 2.0 * radius**2, position=(0, radius),
        friction=mu,
    )  # fmt: skip
    speed = belt * gyration / (1 + gyration)
    lasts = abs(speed) / (mu * G)
    for tick in range(1, 181):
        world.step()
        at = tick / 60
        if at < lasts:
            assert disc.vx == pytest.approx(math.copysign(mu * G * at, belt), rel=1e-5)
    assert disc.vx == pytest.approx(speed, rel=1e-4)
    assert disc.spin == pytest.approx((belt - speed) / radius, rel=1e-4)
    assert disc.x == pytest.approx(speed * (3 - lasts / 2), rel=1e-4)


@pytest.mark.parametrize("mass", [0.5, 2.0, 8.0])
def test_a_belt_on_a_cart_shares_its_speed_by_the_masses(mass: float) -> None:
    """The belt of a cart that glides without friction takes a box along until they part at its
    speed u; as momentum stays zero, the box has M u/(m + M), after u M/(mu g (m + M)).
    """
    mu, belt = 0.25, 1.5
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.set_material_pair("belt", "box", friction=mu)
    world.add(Wall((-60, 0), (60, 0)))
    cart = world.add(
        Box(20, 0.4), mass=2.0, position=(0, 0.2), material="belt", surface_speed=-belt
    )
    box = world.add(Box(0.8, 0.4), mass=mass, position=(0, 0.6), material="box")
    share = 2.0 / (mass + 2.0)
    lasts = belt * share / (mu * G)
    for tick in range(1, 91):
        world.step()
        assert abs(mass * box.vx + 2.0 * cart.vx) < 1e-12 * mass * belt
        assert box.vx == pytest.approx(min(tick / 60, lasts) * mu * G, abs=2e-3 * belt)
    assert box.vx - cart.vx == pytest.approx(belt, rel=1e-5)


@pytest.mark.parametrize("length", [3.0, 300.0])
def test_a_lift_bears_what_it_accelerates(length: float) -> None:
    """What stands on a lift whose velocity is set tick by tick gets m (g + a) dt a tick from it."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    lift = world.add(Box(length, 0.2), kind="kinematic", position=(0, -0.1))
    crate = world.add(Polygon.box(1, 1), mass=3.0, position=(0, 0.5))
    speed = 0.0
    for acceleration in [0.0] * 15 + [4.0] * 20 + [0.0] * 20 + [-3.0] * 20:
        speed += acceleration / 60
        lift.velocity = (0, speed)
        before = crate.vy
        world.step()
        given = math.fsum(contact.impulse.y for contact in world.contacts)
        assert given == pytest.approx(3.0 * (crate.vy - before + G / 60), abs=1e-12)
        if acceleration >= 0.0:  # a lift that drops by steps of its velocity leaves it behind
            assert crate.vy == pytest.approx(speed, abs=0.03 * G / 60)
    assert crate.y - lift.y == pytest.approx(0.6, abs=2e-3)
