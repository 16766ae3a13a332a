"""Joined bodies go on from where they were saved to the same bits, whatever strikes them first.

Bodies that rock slap what they rest on as a tick begins. In a restored world that was before joints
had read what their bodies weigh: they did not answer, and it went another way by metres a second.
"""

from typing import Any

import pytest

from engine import Box, Circle, Pin, Slider, Wall, Weld, World


@pytest.mark.parametrize(
    ("joint", "speed", "restitution"),
    [(Weld(at=(0.35, 0.7)), 2, 0.0), (Slider(axis=(1, 0.3), at=(0.35, 0.7)), 5, 0.5)],
)
def test_every_tick_from_a_snapshot(joint: Any, speed: float, restitution: float) -> None:
    world = World(gravity=(0, -9.81))
    world.add(Wall((-5, 0), (5, 0)), friction=0.5, restitution=restitution)
    one = world.add(
        Box(0.6, 0.3), position=(0, 0.6), angle=0.05, velocity=(2, 0),
        spin=speed, friction=0.5,
    )  # fmt: skip
    other = world.add(Box(0.6, 0.3), position=(0.7, 0.9), friction=0.5)
    world.join(one, other, joint)
    for _ in range(50):
        before = world.snapshot()
        world.step()
        after = world.digest()
        world.restore(before)
        world.step()
        assert world.digest() == after


@pytest.mark.parametrize("joint", [Weld(at=(0.5, 0)), Pin(at=(0.5, 0)), Slider(axis=(0, 1))])
def test_a_change_of_mass_counts_at_once(joint: Any) -> None:
    """An elastic blow along the line of two joined discs gives them 2 m v / (m + M)."""
    world = World(gravity=(0, 0))
    a = world.add(Circle(0.2), mass=1, position=(0, 0), restitution=1)
    b = world.add(Circle(0.2), mass=1, position=(1, 0), restitution=1)
    world.join(a, b, joint)
    world.step()
    world.add(Circle(0.2), mass=2, position=(-0.4, 0), velocity=(3, 0), restitution=1)
    b.mass = 3.0
    world.step()
    assert a.vx == pytest.approx(2 * 2 * 3 / (2 + 4), rel=1e-12)
    assert b.vx == pytest.approx(a.vx, rel=1e-12)
