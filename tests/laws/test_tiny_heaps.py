"""Bodies of a millimetre, from a gram to a ton, fall several of their lengths in a part of a tick.

Contacts had the effective masses of the places where their points had been found, though their
bodies had raced on by more than their own size: sweeps diverged, to 1e39 J and beyond all numbers.
"""

import itertools
import random

from engine import Box, Circle, Compound, Shape, Wall, World

MM = 1e-3
SHAPES: tuple[Shape, ...] = (
    Box(MM, MM),
    Circle(0.3 * MM),
    Compound(
        [
            (Circle(0.1 * MM), (-0.25 * MM, 0)),
            (Circle(0.1 * MM), (0.25 * MM, 0)),
            Box(0.5 * MM, 0.08 * MM),
        ]
    ),
)


def test_a_tiny_heap_gains_no_energy() -> None:
    dice = random.Random(17)
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    corners = [(-4 * MM, 9 * MM), (-4 * MM, 0.0), (4 * MM, 0.0), (4 * MM, 9 * MM)]
    for start, end in itertools.pairwise(corners):
        world.add(Wall(start, end), restitution=1.0, friction=0.0)
    for i in range(12):
        world.add(
            dice.choice(SHAPES),
            mass=10 ** dice.uniform(-3, 3),
            position=(dice.uniform(-0.1, 0.1) * MM, (0.5 + 1.2 * i) * MM),
            angle=dice.uniform(-3, 3),
            friction=0.5,
        )
    high = world.potential_energy
    for _ in range(3):
        world.step()
        assert world.kinetic_energy + world.potential_energy < 1.001 * high
