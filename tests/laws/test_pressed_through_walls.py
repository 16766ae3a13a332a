"""What lies on a wall stays on its side, however heavy that is what falls on it.

A wall is a line. Light bodies are pressed into it by heavy ones, as contacts yield; once their
centres were beyond it, the shortest way out led to the other side, and each of them was lost: a
ball of 0.1 kg on which a box of 100 kg falls fell through the floor.
"""

import pytest

from engine import Body, Box, Capsule, Circle, Polygon, Shape, Wall, World

REACH = 0.3
"""Of the light bodies, about (m)."""


def struck(light: Shape, mass: float, substeps: int) -> tuple[World, Body, Body]:
    """A light body on a wall, and a box of 100 kg that falls on it at 10 m/s."""
    world = World(gravity=(0, -9.81), integrator="velocity-verlet", substeps=substeps)
    world.add(Wall((-50, 0), (50, 0)), friction=0.5)
    body = world.add(light, mass=mass, position=(0, 0.2), friction=0.5)
    heavy = world.add(Box(1, 1), mass=100, position=(0, 1.2), velocity=(0, -10), friction=0.5)
    return world, body, heavy


@pytest.mark.parametrize("substeps", [6, 2])
@pytest.mark.parametrize("mass", [0.1, 0.01])
@pytest.mark.parametrize(
    "light",
    [Circle(0.2), Box(0.4, 0.4), Capsule(0.2, 0.2), Polygon.regular(5, 0.2)],
    ids=lambda shape: type(shape).__name__,
)
def test_nothing_is_pressed_through_the_floor(light: Shape, mass: float, substeps: int) -> None:
    world, body, heavy = struck(light, mass, substeps)
    for _ in range(240):
        world.step()
        assert body.y > -REACH
        assert heavy.y > 0.4
    assert world.ledger().energy_error == pytest.approx(0.0, abs=1e-8)


def test_what_a_hand_puts_below_a_wall_stays_there() -> None:
    """It did not get there by being pressed, though it lay on the wall a tick before."""
    world, body, heavy = struck(Circle(0.2), 1.0, 6)
    world.remove(heavy)
    world.run(30)
    assert body.y == pytest.approx(0.2, abs=1e-3)
    world.gravity = (0, 0)
    body.position, body.velocity = (0, -0.19), (0, 0)
    world.run(60)
    assert body.y < -0.19
