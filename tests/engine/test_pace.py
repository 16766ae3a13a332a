"""How long a part of a tick may be for hinges."""

import pytest

from engine import Box, Pin, World
from engine.linkage.pace import LASH, SHORTEST, SNAP, part_for_joints

TICK = 1 / 60


def chain(masses: tuple[float, ...]) -> World:
    """Rods of 1 m that hang from each other, without weight."""
    world = World()
    above = None
    for i, mass in enumerate(masses):
        rod = world.add(Box(0.1, 1.0), mass=mass, position=(0.0, -i - 0.5))
        world.join(above, rod, Pin(at=(0.0, -i)))
        above = rod
    world.step(TICK)
    return world


def part(world: World) -> float:
    """Length of the next part of a whole tick (s)."""
    substep = TICK / world.laws.substeps
    return part_for_joints(world.tables, substep, TICK, 0, float(world.laws.substeps))


def spin(world: World, *spins: float) -> World:
    """Let rods turn (rad/s), and do no more than that."""
    for row, value in enumerate(spins):
        world.tables.bodies.spin[row] = value
        world.tables.bodies.vx[row] = world.tables.bodies.vy[row] = 0.0
    return world


def test_where_all_energy_is_in_what_turns_it_turns_little_in_a_part() -> None:
    """A whip: the light end has the energy of the whole chain."""
    assert part(spin(chain((1.0, 1.0, 1.0)), 0.0, 0.0, 100.0)) == pytest.approx(LASH / 100.0)
    assert part(spin(chain((1.0,)), 100.0)) == pytest.approx(LASH / 100.0)


def test_what_has_little_energy_may_turn_further() -> None:
    """A light link that turns ten times as fast as the heavy ones that swing."""
    world = spin(chain((100.0, 100.0, 0.001)), 8.0, 8.0, 80.0)
    assert part(world) == pytest.approx(SNAP / 80.0)


def test_no_part_is_shorter_than_a_32nd_of_a_substep() -> None:
    world = spin(chain((1.0,)), 1e6)
    assert part(world) == TICK / world.laws.substeps * SHORTEST
