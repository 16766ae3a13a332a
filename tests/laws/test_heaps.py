"""A high heap has no source of energy: once all has come down, it comes to rest."""

import math

import pytest

from engine import Body, Box, Circle, Wall, World

pytest.importorskip("numba")  # interpreted, such a heap takes minutes


def bin_with(columns: int, each: int, height: float) -> tuple[World, list[Body]]:
    """Columns of discs and boxes that fall into a bin and topple over each other."""
    world = World(gravity=(0, -9.81), integrator="velocity-verlet", kernels="compiled")
    width = 0.75 * columns
    corners = [(0, 0), (width, 0), (width, height), (0, height)]
    for i in range(4):
        world.add(Wall(corners[i], corners[(i + 1) % 4]), restitution=0.1, friction=0.5)
    bodies = []
    for i in range(columns * each):
        place = (
            0.4 + 0.74 * (i % columns) + 0.04 * (i // columns % 3),
            0.4 + 0.72 * (i // columns),
        )
        shape = Circle(0.25) if i * 7919 % 3 == 0 else Box(0.5, 0.4)
        mass = math.pi / 16 if i * 7919 % 3 == 0 else 0.2
        bodies.append(world.add(shape, mass=mass, position=place, restitution=0.1, friction=0.5))
    return world, bodies


@pytest.mark.parametrize("each", [22, 25, 33])
def test_a_heap_comes_to_rest_to_the_last_bit(each: int) -> None:
    """In a dent a body may need all the friction there is at one point, and does not move. What
    sweeps left it made it creep, by some micrometres a second, and shake the heap now and then.
    """
    world, bodies = bin_with(12, each, 125.0)
    for _ in range(900):
        world.step()
    places = [(*body.position, body.angle) for body in bodies]
    assert world.kinetic_energy == 0.0
    for _ in range(120):
        world.step()
    assert [(*body.position, body.angle) for body in bodies] == places


def test_a_heap_of_a_thousand_does_not_drive_itself() -> None:
    """What pushes overlaps apart may lend velocities, but not keep the heap moving: it did so for
    as long as one looked, with 20 J, ninety impacts a tick, and 130 W of friction that nothing but
    contacts paid for.
    """
    world, _ = bin_with(22, 46, 240.0)
    for _ in range(420):
        world.step()
    before = world.ledger()
    for _ in range(60):
        world.step()
    spent = world.ledger().since(before).dissipated
    assert world.kinetic_energy < 0.5
    assert spent.friction < 5.0
