"""A body that rests and whose mass is set anew goes on to rest.

Contacts kept the mass for which they had been measured: one sweep over a box that had become a
hundred times as light gave it a hundred times the impulse that stops it. It left at 180 m/s.
"""

import pytest

from engine import Body, Box, Capsule, Wall, World


def heap(sleeping: bool) -> tuple[World, list[Body]]:
    """Three boxes and a rod on each other, after two seconds."""
    world = World(gravity=(0, -9.81), integrator="velocity-verlet", sleeping=sleeping)
    world.add(Wall((-5, 0), (5, 0)))
    boxes = [world.add(Box(1, 1), mass=5, position=(0, 0.5 + level)) for level in range(3)]
    rod = world.add(Capsule(0.6, 0.2), mass=5, position=(0, 3.2))
    world.run(120)
    return world, [*boxes, rod]


@pytest.mark.parametrize("sleeping", [False, True])
@pytest.mark.parametrize("which", range(4))
@pytest.mark.parametrize("factor", [0.05, 0.3, 3.0, 20.0])
def test_a_heap_stays_where_it_is_when_a_mass_changes(
    sleeping: bool, which: int, factor: float
) -> None:
    world, bodies = heap(sleeping)
    before = [body.position for body in bodies]
    bodies[which].mass *= factor
    for _ in range(30):
        world.step()
        assert max(body.speed for body in bodies) < 0.15
    for body, start in zip(bodies, before, strict=True):
        assert abs(body.x - start.x) < 0.01
        assert abs(body.y - start.y) < 0.01


def test_the_ground_bears_the_new_weight() -> None:
    world = World(gravity=(0, -9.81))
    ground = world.add(Wall((-5, 0), (5, 0)))
    box = world.add(Box(1, 1), mass=500, position=(0, 0.5))
    world.run(60)
    box.mass = 2.0
    world.run(60)
    (contact,) = world.contacts
    assert (contact.a, contact.b) == (ground, box)
    assert contact.impulse.y == pytest.approx(2.0 * 9.81 / 60, rel=1e-9)
