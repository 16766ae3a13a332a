"""Joints press bodies on others: springs, motors, axles. What they press on bears the load.

French, "Newtonian Mechanics" (1971), ch. 7 and 14: what stands still, or rolls, is in balance with
the forces of contact. Joints give half of what they give in a part of a tick at its start and half
at its end, contacts give it evenly. Contacts stopped only what was left at the end of a part, so
that bodies which joints pressed with more than some five times their weight sank into the ground:
a spring of 130 m/s^2 pushed a box by 5 cm into it, and the wheel of a loaded cart sank by 10 cm.
"""

import math

import pytest

from engine import Body, Box, Circle, Pin, Slider, Spring, Wall, World

G = 9.81


def on_floor() -> tuple[World, Body]:
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    return world, world.add(Wall((-50, 0), (50, 0)), friction=3.0)


def borne(world: World, body: Body, dt: float = 1 / 60) -> float:
    """Upward force of contacts on a body, on the mean over the last tick (N)."""
    signs = [(c, 1.0 if c.b is body else -1.0) for c in world.contacts if body in (c.a, c.b)]
    return sum(sign * contact.impulse.y for contact, sign in signs) / dt


@pytest.mark.parametrize("extension", [0.01, 0.1, 1.0])
def test_the_ground_bears_a_box_that_a_spring_presses_on_it(extension: float) -> None:
    """N = m g + k x, here up to a hundred times the weight."""
    world, _ = on_floor()
    box = world.add(Box(0.6, 0.4), mass=2.0, position=(0, 0.2))
    world.join(None, box, Slider(axis=(0, 1)))
    spec = Spring(2000.0, anchor_a=(0, 1.4), anchor_b=(0, 0.4), length=1.0 + extension)
    world.join(None, box, spec)
    for _ in range(60):
        world.step()
        assert box.y == pytest.approx(0.2, abs=2e-3)
    assert borne(world, box) == pytest.approx(2.0 * G + 2000.0 * extension, rel=0.01)


@pytest.mark.parametrize("speed", [-0.05, -1.0, -50.0])
@pytest.mark.parametrize("torque", [10.0, 100.0])
def test_a_peg_bears_a_lever_that_a_motor_presses_on_it(torque: float, speed: float) -> None:
    """N r = T + m g L/2, however slowly the motor wants to turn."""
    world = World(gravity=(0, -G))
    world.add(Circle(0.25), kind="static", position=(0.5, -0.3))
    lever = world.add(Box(1.0, 0.1), mass=1.0, position=(0.5, 0))
    pin = world.join(None, lever, Pin(at=(0, 0), motor_speed=speed, max_torque=torque))
    for _ in range(60):
        world.step()
    assert lever.angle == pytest.approx(0.0, abs=3e-3)
    assert pin.torque == pytest.approx(-torque, rel=1e-9)
    assert borne(world, lever) == pytest.approx((torque + G / 2) / 0.5, rel=5e-3)


def test_a_cart_swings_on_its_spring_while_its_wheel_stays_on_the_floor() -> None:
    """y = A cos(w t) above rest with w^2 = k/M."""
    world, _ = on_floor()
    wheel = world.add(Circle(0.3), mass=1.0, position=(0, 0.3))
    body = world.add(Box(1.0, 0.3), mass=8.0, position=(0, 1.2))
    stiffness, swing = 1500.0, 0.03
    rest = 0.9 + 8.0 * G / stiffness
    world.join(body, wheel, Slider(axis=(0, 1), at=(0, 0.3)))
    world.join(body, wheel, Spring(stiffness, length=rest + swing))
    pace = math.sqrt(stiffness / 8.0)
    for _ in range(60):
        world.step()
        assert wheel.y == pytest.approx(0.3, abs=5e-4)
        expected = 1.2 + swing - swing * math.cos(pace * world.time)
        assert body.y == pytest.approx(expected, abs=0.05 * swing)


def test_motors_drive_a_cart() -> None:
    """a (M + 2 m + 2 I/r^2) = 2 T/r, as long as wheels do not slip."""
    world, _ = on_floor()
    body = world.add(Box(2.0, 0.2), mass=5.0, position=(0, 0.3), mask=0)
    wheels = []
    for x in (-1.0, 1.0):
        wheel = world.add(Circle(0.3), mass=1.0, position=(x, 0.3), friction=3.0)
        world.join(body, wheel, Pin(at=(x, 0.3), motor_speed=-1e3, max_torque=2.0))
        wheels.append(wheel)
    for _ in range(60):
        world.step()
    acceleration = 2 * 2.0 / 0.3 / (5.0 + 2 * 1.0 + 2 * wheels[0].inertia / 0.3**2)
    assert body.vx == pytest.approx(acceleration, rel=2e-3)
    assert wheels[0].spin == pytest.approx(-body.vx / 0.3, rel=2e-3)
    assert world.ledger().energy_error == pytest.approx(0.0, abs=1e-9)
