"""What is heavy and joined to what is light stands on it: a rigid body is one, however it is built.

A sweep over contacts stops what the lighter body brings, and joints then bring more of what the
heavy one does: a table whose top weighs a thousand times as much as a leg sank by 3 cm where it
stood, and by 60 cm as it landed from half a metre.
"""

import math
from typing import Any

import pytest

from engine import Body, Box, Capsule, Circle, Pin, Polygon, Wall, Weld, World


def build_table(world: World, load: float, height: float, welded: bool) -> list[Body]:
    """A top of `load` kg on two legs of 0.1 kg and 1 m, `height` above the ground."""
    world.add(Wall((-10, 0), (10, 0)), friction=0.6)
    top = world.add(Box(2, 0.1), mass=load, position=(0, 1.05 + height), friction=0.5)
    legs = []
    for x in (-0.9, 0.9):
        leg = world.add(Box(0.1, 1), mass=0.1, position=(x, 0.5 + height), friction=0.5)
        if welded:
            world.join(top, leg, Weld(at=(x, 1 + height)))
        else:
            world.join(top, leg, Pin(at=(x - 0.05, 1 + height)))
            world.join(top, leg, Pin(at=(x + 0.05, 1 + height)))
        legs.append(leg)
    return legs


@pytest.mark.parametrize("welded", [True, False])
@pytest.mark.parametrize(
    ("load", "height", "most"),
    [(10.0, 0.0, 1e-4), (100.0, 0.5, 1e-4), (1000.0, 0.0, 1e-4), (1000.0, 3.0, 5e-4)],
)
def test_a_table_stands_on_its_legs(load: float, height: float, most: float, welded: bool) -> None:
    """It sinks no deeper than soft contacts give way: as a rigid body would."""
    world = World(gravity=(0, -9.81), integrator="velocity-verlet", kernels="compiled")
    legs = build_table(world, load, height, welded)
    deepest = 0.0
    for _ in range(120):
        world.step()
        deepest = max(deepest, *(0.5 - leg.y for leg in legs))
    assert deepest < most
    assert max(0.5 - leg.y for leg in legs) < 1e-4
    assert max(abs(leg.angle) for leg in legs) < 0.001
    assert world.ledger().energy_error == pytest.approx(0.0, abs=1e-6)
    up = sum(contact.impulse.y for contact in world.contacts) * 60
    assert up == pytest.approx((load + 0.2) * 9.81, rel=1e-3)


@pytest.mark.parametrize("welded", [True, False])
@pytest.mark.parametrize("load", [0.2, 3.0, 100.0, 1000.0])
@pytest.mark.parametrize("restitution", [0.5, 1.0])
def test_what_is_heavy_bounces_on_a_light_foot(
    load: float, restitution: float, welded: bool
) -> None:
    """Height of a bounce: e^2 h (Newton's law of restitution), whatever the foot weighs.

    A foot that yields little, as something heavy is joined to it, was taken for one that joints
    hold: from thirty times its mass on it sank in and did not bounce at all.
    """
    height = 0.5
    world = World(gravity=(0, -9.81), integrator="velocity-verlet", kernels="compiled")
    world.add(Wall((-10, 0), (10, 0)), restitution=restitution)
    top = world.add(Box(0.4, 0.4), mass=load, position=(0, 0.3 + height))
    foot = world.add(Circle(0.05), mass=0.1, position=(0, 0.05 + height))
    world.join(top, foot, (Weld if welded else Pin)(at=(0, 0.1 + height)))
    highest = 0.0
    for tick in range(40):
        world.step()
        if (tick > 20 and restitution < 1.0) or tick > 30:
            highest = max(highest, foot.y - 0.05)
    assert highest == pytest.approx(restitution**2 * height, abs=0.005)


@pytest.mark.parametrize("height", [0.0, 0.5, 3.0])
@pytest.mark.parametrize("load", [3.0, 30.0, 1000.0])
def test_a_cart_stands_on_its_wheels(load: float, height: float) -> None:
    """Hinged to wheels of 0.1 kg it sinks no deeper than welded to legs: by 19 cm it did."""
    world = World(gravity=(0, -9.81), integrator="velocity-verlet", kernels="compiled")
    world.add(Wall((-10, 0), (10, 0)), friction=0.6)
    frame = world.add(Box(2, 0.2), mass=load, position=(0, 0.4 + height))
    wheels = []
    for x in (-0.8, 0.8):
        wheel = world.add(Circle(0.3), mass=0.1, position=(x, 0.3 + height), friction=0.6)
        world.join(frame, wheel, Pin(at=(x, 0.3 + height)))
        wheels.append(wheel)
    deepest = 0.0
    for _ in range(150):
        world.step()
        deepest = max(deepest, *(0.3 - wheel.y for wheel in wheels))
    assert deepest < 3e-4
    assert max(body.speed for body in (frame, *wheels)) < 1e-6


@pytest.mark.parametrize("limits", [None, (-1e6, 1e6)])
@pytest.mark.parametrize("load", [5.0, 100.0, 1000.0])
def test_a_cart_rolls_down_a_slope(load: float, limits: Any) -> None:
    """Without slipping a = g sin / (1 + sum I / (M r^2)), M being the mass of all."""
    radius, slope = 0.3, 0.2
    world = World(
        gravity=(9.81 * math.sin(slope), -9.81 * math.cos(slope)), integrator="velocity-verlet",
        kernels="compiled",
    )  # fmt: skip
    world.add(Wall((-10, 0), (50, 0)), friction=0.9)
    frame = world.add(Box(2, 0.1), mass=load, position=(0, radius))
    resisting = 0.0
    for x in (-0.9, 0.9):
        wheel = world.add(Circle(radius), mass=0.1, position=(x, radius), friction=0.9)
        world.join(frame, wheel, Pin(at=(x, radius), limits=limits))
        resisting += wheel.inertia / radius**2
    world.run(120)
    pull = 9.81 * math.sin(slope) / (1 + resisting / (load + 0.2))
    assert frame.vx == pytest.approx(2 * pull, rel=2e-4)


@pytest.mark.parametrize("load", [0.5, 5.0, 100.0, 1000.0])
@pytest.mark.parametrize("limits", [None, (-1e6, 1e6)])
def test_light_wheels_resist_the_rolling_of_what_they_bear(load: float, limits: Any) -> None:
    """A cart of mass M on wheels of radius r, of which each resists by c times its load, slows
    down by a = c M g / (r (M + sum I / r^2)): it was not braked at all where the hinges had limits.
    """
    radius = 0.3
    coefficient = 0.01
    world = World(gravity=(0, -9.81), integrator="velocity-verlet", kernels="compiled")
    world.add(Wall((-30, 0), (30, 0)), friction=0.9)
    frame = world.add(Box(2, 0.1), mass=load, position=(0, radius), velocity=(3, 0))
    resisting = 0.0
    for x in (-0.9, 0.9):
        wheel = world.add(
            Circle(radius), mass=0.1, position=(x, radius), velocity=(3, 0), spin=-3 / radius,
            friction=0.9, rolling_resistance=coefficient,
        )  # fmt: skip
        world.join(frame, wheel, Pin(at=(x, radius), limits=limits))
        resisting += wheel.inertia / radius**2
    world.run(60)
    mass = load + 0.2
    slower = coefficient * mass * 9.81 / radius / (mass + resisting)
    assert frame.vx == pytest.approx(3 - slower, rel=1e-4)
    assert frame.y == pytest.approx(radius, abs=1e-4)


@pytest.mark.parametrize("turned", [16, 34, 35])
def test_what_is_squeezed_between_two_that_do_not_yield(turned: int) -> None:
    """A light hook welded to something heavy on the ground gets under one that whirls by itself.

    No impulses let it obey both: those that came closest threw it away at 5e8 m/s.
    """
    hook = Polygon.concave([(0, 0), (1, 0), (1, 0.3), (0.3, 0.3), (0.3, 1), (0, 1)])
    world = World(gravity=(0, -9.81), kernels="compiled")
    world.add(Wall((-4, 0), (4, 0)), friction=0.9)
    light = world.add(
        hook, mass=1, position=(-0.142, 3.171), angle=-1.155 + 0.02 * turned,
        velocity=(1.465, -0.948), friction=0.3, fixed_rotation=True,
    )  # fmt: skip
    world.add(
        hook, kind="kinematic", position=(0.09, 3.9), angle=0.345, velocity=(-0.256, 0.054),
        spin=4.285, friction=0.8,
    )  # fmt: skip
    heavy = world.add(
        Capsule(0.5, 0.2), mass=20, position=(0.535, 0.254), angle=1.921,
        velocity=(1.465, -0.948), friction=0.9,
    )  # fmt: skip
    world.join(light, heavy, Weld(at=(0.2, 1.7)))
    for _ in range(40):
        world.step()
        assert light.speed < 25
