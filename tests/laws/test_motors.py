"""Motors that do all that they can: what they exert then is known, whatever else acts.

M. W. Spong, S. Hutchinson, M. Vidyasagar, "Robot Modeling and Control" (2006), ch. 7: joints that
exert given torques accelerate their links as the equations of motion say. Three faults are shown. A
motor that was overstrained only by what another one wanted, before that was overstrained too, drove
the wrong way for good. A motor that drove away from a limit was held there by it. And a motor that
pulled at what cannot move did nothing, or tore it: which of the two depended on what was joined
first.
"""

import math

import pytest

from engine import Box, Circle, Distance, Joint, Pin, Pulley, Rope, Weld, World

G = 9.81


@pytest.mark.parametrize("limits", [None, (0.0, 9.0)])
@pytest.mark.parametrize("hurry", [-100.0, 100.0])
def test_each_of_two_motors_turns_its_disc_with_its_own_torque(
    hurry: float, limits: tuple[float, float] | None
) -> None:
    """Discs of I = 1/2 and 1/8 kg m^2 on one axle: I1 a1 = T1 - T2, I2 a2 = T2."""
    world = World()
    large = world.add(Circle(1.0), mass=1.0, mask=0)
    small = world.add(Circle(0.5), mass=1.0, mask=0)
    spec = Pin(at=(0, 0), limits=limits, motor_speed=4.0, max_torque=2.0)
    axle = world.join(None, large, spec)
    inner = world.join(large, small, Pin(at=(0, 0), motor_speed=hurry, max_torque=0.5))
    torque = math.copysign(0.5, hurry)
    for _ in range(30):
        world.step()
        assert (axle.torque, inner.torque) == pytest.approx((2.0, torque), rel=1e-9)
        assert large.spin == pytest.approx((2.0 - torque) / 0.5 * world.time, rel=1e-9)
        assert small.spin == pytest.approx(torque / 0.125 * world.time, rel=1e-9)


def test_two_motors_of_an_arm_accelerate_it_as_lagrange_says() -> None:
    """Two rods end to end, both horizontal at rest: M(q) a = T - g(q), from the textbook above."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    upper = world.add(Box(1.0, 0.1), mass=2.0, position=(0.5, 0), mask=0)
    lower = world.add(Box(0.8, 0.1), mass=1.0, position=(1.4, 0), mask=0)
    world.join(None, upper, Pin(at=(0, 0), motor_speed=1.0, max_torque=40.0))
    world.join(upper, lower, Pin(at=(1.0, 0), motor_speed=-300.0, max_torque=9.0))
    inertia = 1.0 * 0.4**2 + lower.inertia
    coupling = 1.0 * 1.0 * 0.4
    a = 2.0 * 0.5**2 + upper.inertia + 1.0 * 1.0**2 + inertia + 2 * coupling
    b = inertia + coupling
    pull = 40.0 - G * (2.0 * 0.5 + 1.0 * 1.4), -9.0 - G * 1.0 * 0.4
    scale = a * inertia - b * b
    first = (inertia * pull[0] - b * pull[1]) / scale
    second = (a * pull[1] - b * pull[0]) / scale
    world.step(1e-5)
    assert upper.spin == pytest.approx(first * 1e-5, rel=1e-6)
    assert lower.spin - upper.spin == pytest.approx(second * 1e-5, rel=1e-6)


def lever(first: bool, speed: float, holds: str) -> tuple[World, Joint, Joint]:
    """A lever of 2 m, turned downwards by a motor; what holds its end is joined first, or last."""
    world = World()
    beam = world.add(Box(2.0, 0.1), mass=3.0, position=(1, 0), mask=0)
    block = world.add(Box(1, 1), kind="kinematic", position=(5, 0))

    def hold() -> Joint:
        if holds == "pulley":
            ends = {"anchor_a": (2, 0), "anchor_b": (5, 0)}
            return world.join(beam, block, Pulley(over_a=(2, 1), over_b=(5, 1), **ends))
        spec = {"rod": Distance, "rope": Rope}[holds]
        return world.join(None, beam, spec(anchor_a=(2, 1), anchor_b=(2, 0)))

    joints = [hold()] if first else []
    pin = world.join(None, beam, Pin(at=(0, 0), motor_speed=speed, max_torque=50.0))
    return world, pin, joints[0] if first else hold()


@pytest.mark.parametrize("first", [True, False])
@pytest.mark.parametrize("speed", [-0.01, -1.0, -100.0])
@pytest.mark.parametrize("holds", ["rod", "rope", "pulley"])
def test_a_motor_that_cannot_turn_pulls_with_its_torque(
    first: bool, speed: float, holds: str
) -> None:
    """F = T/r, however slowly it wants to turn, and nothing gives way."""
    world, pin, joint = lever(first, speed, holds)
    for _ in range(20):
        world.step()
        assert pin.coordinate == pytest.approx(0.0, abs=1e-12)
        assert pin.torque == pytest.approx(-50.0, rel=1e-9)
        pull = joint.force.y if holds != "pulley" else -pin.force.y
        assert pull == pytest.approx(25.0, rel=1e-9)


@pytest.mark.parametrize("first", [True, False])
def test_nor_does_it_turn_a_weld(first: bool) -> None:
    world = World()
    beam = world.add(Box(2.0, 0.1), mass=3.0, position=(1, 0))
    weld = world.join(None, beam, Weld(at=(0, 0))) if first else None
    pin = world.join(None, beam, Pin(at=(0, 0), motor_speed=0.01, max_torque=50.0))
    weld = weld or world.join(None, beam, Weld(at=(0, 0)))
    for _ in range(20):
        world.step()
        assert beam.angle == pytest.approx(0.0, abs=1e-12)
        assert (pin.torque, weld.torque) == pytest.approx((50.0, -50.0), rel=1e-9)


def test_a_motor_without_bounds_keeps_its_speed_when_it_is_struck() -> None:
    """Motors give no impulses in impacts; after the tick the paddle turns as before."""
    world = World(gravity=(0, -G))
    paddle = world.add(Box(2.0, 0.1), mass=3.0)
    world.join(None, paddle, Pin(at=(0, 0), motor_speed=0.5))
    ball = world.add(Circle(0.1), mass=2.0, position=(0.8, 0.5), restitution=0.5)
    hits = 0
    for _ in range(60):
        hits += len(world.step())
        assert paddle.spin == pytest.approx(0.5, abs=1e-9)
    assert hits > 0
    assert ball.speed < 10.0
