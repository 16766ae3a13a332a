"""How long a part of a tick may be for hinges."""

import pytest

from engine import Box, Pin, World
from engine.linkage.pace import FEW, HELD, HELD_LASH, LASH, SHORTEST, SNAP, part_for_joints

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
    world = chain((1.0,) * (FEW + 1))
    assert part(spin(world, *(0.0,) * FEW, 100.0)) == pytest.approx(LASH / 100.0)


def test_what_has_little_energy_may_turn_further() -> None:
    """A light link that turns ten times as fast as the heavy ones that swing."""
    world = spin(chain((100.0,) * FEW + (0.001,)), *(8.0,) * FEW, 80.0)
    assert part(world) == pytest.approx(SNAP / 80.0)


def test_no_part_is_shorter_than_a_32nd_of_a_substep() -> None:
    for links in (1, FEW + 1):
        world = spin(chain((1.0,) * links), *(1e6,) * links)
        assert part(world) == pytest.approx(TICK / world.laws.substeps * SHORTEST, rel=1e-12)


def test_trees_of_few_limbs_hold_their_pace() -> None:
    """As many parts as the fastest motion wanted, a whole power of two to a substep."""
    world = spin(chain((1.0, 1.0)), 0.0, 100.0)
    substep = TICK / world.laws.substeps
    assert part(world) == pytest.approx(substep / 4)
    assert substep / 4 < HELD_LASH / 100.0
    assert part(spin(world, 0.0, 0.0)) == pytest.approx(substep / 4)


def test_a_pace_is_let_go_when_it_has_not_been_needed_for_long() -> None:
    world = spin(chain((1.0, 1.0)), 0.0, 100.0)
    held = part(world)
    spin(world, 0.0, 0.0)
    while world.time < 2.0 * HELD - 1.0:
        world.step()
        assert world.time > HELD or part(world) == held
    world.run(120)
    assert part(world) == TICK
