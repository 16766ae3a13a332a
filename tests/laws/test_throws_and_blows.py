"""Blows and throws of the first weeks: cannons of balls, pendulums that are shot at, carts.

Impacts by momentum and restitution; between them energy (Kleppner and Kolenkow, 2014, ch. 3, 4).
"""

import math

import pytest

from engine import Body, Box, Circle, Distance, Pin, Wall, Weld, World

G = 9.81


def still_world() -> World:
    return World(gravity=(0, -G), integrator="velocity-verlet")


@pytest.mark.parametrize("ratio", [9.0, 99.0, 1e6])
@pytest.mark.parametrize("gap", [0.0, 1e-4])
def test_a_small_ball_on_a_large_one_is_shot_up(ratio: float, gap: float) -> None:
    """Huygens' two blows, one after the other: v = v_0 (3 M - m)/(M + m), up to three times as fast
    (Harter, Am. J. Phys. 39, 1971), be there a gap between them or none.
    """
    world = still_world()
    world.add(Wall((-5, 0), (5, 0)), restitution=1.0)
    world.add(Circle(0.12), mass=0.06 * ratio, position=(0, 1.12), restitution=1.0)
    small = world.add(Circle(0.03), mass=0.06, position=(0, 1.27 + gap), restitution=1.0)
    while small.vy <= 0 or small.y < 0.6:
        world.step()
    rises = small.y + small.vy**2 / (2 * G) - 0.27
    thrown = (3 * ratio - 1) / (ratio + 1)
    assert math.sqrt(rises / 1.0) == pytest.approx(thrown, rel=1e-12 if gap == 0 else 2e-5)


def test_a_ballistic_pendulum_tells_the_speed_of_its_bullet() -> None:
    """h = (m v/(m + M))^2/(2 g), for a block on two strings that the bullet sticks in."""
    world = still_world()
    block = world.add(Box(0.3, 0.3), mass=2.0)
    for side in (-0.1, 0.1):
        world.join(None, block, Distance(anchor_a=(side, 2), anchor_b=(side, 0)))
    bullet = world.add(Circle(0.01), mass=0.02, position=(-5, 0), velocity=(300, 0))
    while not world.step():
        pass
    world.join(block, bullet, Weld(at=bullet.position))
    highest = 0.0
    for _ in range(60):
        world.step()
        highest = max(highest, block.y)
    speed = 0.02 * 300 / 2.02
    assert highest == pytest.approx(speed**2 / (2 * G), rel=1e-3)


def test_a_cradle_on_rods_swings_at_its_ends() -> None:
    """Of five balls that touch, pinned to rods, the outer two take turns; those between hang."""
    world = still_world()
    balls: list[Body] = []
    for i in range(5):
        lean = -0.6 if i == 0 else 0.0
        place = (0.2 * i + math.sin(lean), 1 - math.cos(lean))
        ball = world.add(Circle(0.1), mass=1.0, position=place, angle=lean, restitution=1.0)
        world.join(None, ball, Pin(at=(0.2 * i, 1)))
        balls.append(ball)
    start = world.kinetic_energy + world.potential_energy
    swings = [0.0] * 5
    for _ in range(300):
        world.step()
        swings = [max(far, abs(b.x - 0.2 * i)) for i, (far, b) in enumerate(zip(swings, balls))]  # noqa: B905
    assert swings[4] == pytest.approx(swings[0], rel=1e-3)
    assert max(swings[1:4]) < 1e-3
    energy = world.kinetic_energy + world.potential_energy
    assert energy - start == pytest.approx(0.0, abs=1e-3 * G * (1 - math.cos(0.6)))


def cart(friction: float) -> tuple[World, Body]:
    """A cart of 2 kg that runs at 3 m/s over a floor without friction."""
    world = still_world()
    world.add(Wall((-5, 0), (90, 0)), friction=0.0)
    body = world.add(Box(20, 0.2), mass=2.0, position=(0, 0.1), velocity=(3, 0), friction=friction)
    return world, body


def test_a_ball_thrown_up_on_a_cart_comes_back_to_it() -> None:
    """Galilei (1632): what is thrown up goes on with the cart."""
    world, carries = cart(0.0)
    ball = world.add(Circle(0.1), mass=0.5, position=(0, 0.3), velocity=(3, 0))
    world.run(10)
    ball.apply_impulse((0, 2.5))
    world.run(60)
    assert ball.y > 0.3
    assert ball.x == pytest.approx(carries.x, abs=1e-6)
    world.run(20)
    assert ball.y == pytest.approx(0.3, abs=1e-3)
    assert ball.x == pytest.approx(carries.x, abs=1e-6)


def test_what_falls_on_a_cart_is_taken_along() -> None:
    """A box of 1 kg ends with it at M V/(M + m); a disc that comes to roll is given 1/3 as much."""
    world, carries = cart(1.0)
    box = world.add(Box(0.2, 0.2), mass=1.0, position=(1, 1), friction=1.0)
    world.run(120)
    assert (carries.vx, box.vx) == pytest.approx((2.0, 2.0), abs=1e-6)
    world, carries = cart(0.5)
    disc = world.add(Circle(0.2), mass=1.0, position=(5, 0.4), friction=0.5)
    world.run(120)
    last = 2 * 3 / (2 + 1 / 3)
    assert (carries.vx, disc.vx) == pytest.approx((last, last / 3), rel=5e-4)
