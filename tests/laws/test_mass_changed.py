"""A body that rests and whose mass is set anew goes on to rest.

Contacts kept the mass for which they had been measured: one sweep over a box that had become a
hundred times as light gave it a hundred times the impulse that stops it. It left at 180 m/s.
"""

import pytest

from engine import Body, Box, Capsule, Circle, Pin, Wall, World


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


def test_a_cart_that_is_loaded_later_stands_on_its_wheels() -> None:
    """How joints are solved depends on masses: they are looked at anew, restored or not."""
    world = World(gravity=(0, -9.81), integrator="velocity-verlet", kernels="compiled")
    world.add(Wall((-10, 0), (10, 0)), friction=0.6)
    frame = world.add(Box(2, 0.2), mass=0.1, position=(0, 0.4))
    for x in (-0.8, 0.8):
        wheel = world.add(Circle(0.3), mass=0.1, position=(x, 0.3), friction=0.6)
        world.join(frame, wheel, Pin(at=(x, 0.3)))
    world.run(10)
    frame.mass = 1000.0
    before = world.snapshot()
    world.run(100)
    assert frame.y == pytest.approx(0.4, abs=2e-4)
    ended = world.digest()
    world.restore(before)
    world.run(100)
    assert world.digest() == ended
