"""A high heap has no source of energy: once all has come down, it comes to rest."""

import math

import pytest

from engine import Box, Circle, Wall, World

pytest.importorskip("numba")  # interpreted, such a heap takes minutes


def test_a_heap_of_a_thousand_does_not_drive_itself() -> None:
    """Columns of forty-five fall into a bin and topple over each other. What pushes overlaps apart
    may lend velocities, but not keep the heap moving: it did so for as long as one looked, with
    20 J, ninety impacts a tick, and 130 W of friction that nothing but contacts paid for.
    """
    world = World(gravity=(0, -9.81), integrator="velocity-verlet", kernels="compiled")
    columns, each = 22, 46
    width, height = 0.75 * columns, 240.0
    corners = [(0, 0), (width, 0), (width, height), (0, height)]
    for i in range(4):
        world.add(Wall(corners[i], corners[(i + 1) % 4]), restitution=0.1, friction=0.5)
    for i in range(columns * each):
        place = (
            0.4 + 0.74 * (i % columns) + 0.04 * (i // columns % 3),
            0.4 + 0.72 * (i // columns),
        )
        shape = Circle(0.25) if i * 7919 % 3 == 0 else Box(0.5, 0.4)
        mass = math.pi / 16 if i * 7919 % 3 == 0 else 0.2
        world.add(shape, mass=mass, position=place, restitution=0.1, friction=0.5)
    for _ in range(420):
        world.step()
    before = world.ledger()
    for _ in range(60):
        world.step()
    spent = world.ledger().since(before).dissipated
    assert world.kinetic_energy < 0.5
    assert spent.friction < 5.0
