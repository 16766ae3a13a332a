"""When bodies that overlap are moved apart, and when that ends."""

import pytest

from engine import Box, Wall, World
from engine.kernels.following import DEEP
from engine.kernels.parting import NEARLY, is_parting
from engine.kernels.spring import sag


def resting_box() -> World:
    """A box that stands on a floor."""
    world = World(gravity=(0, -9.81))
    world.add(Wall((-5, 0), (5, 0)), friction=0.5)
    world.add(Box(1, 1), position=(0, 0.5), friction=0.5)
    for _ in range(3):
        world.step()
    return world


@pytest.mark.parametrize("moved", [0, 1])
def test_moving_ends_a_little_deeper_than_loads_press(moved: int) -> None:
    """A load presses a contact as deep as its spring yields, and by rounding deeper: if that were
    moved away, it would be for ever. What nobody moves yet may be as deep as `DEEP`.
    """
    world = resting_box()
    tables = world.tables
    tables.bodies.parting[1] = moved
    most = NEARLY * sag(tables, 0) if moved else DEEP * tables.pairs.size[0]
    assert 0.0 < sag(tables, 0) < most
    for share, parts in ((1.01 / NEARLY, False), (0.99, False), (1.01, True)):
        tables.contacts.gap[0] = -share * most
        assert is_parting(tables, 0) is parts
