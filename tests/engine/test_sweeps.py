"""Sweeps over a crowd: in turns from all of it, and past what is calm."""

import pytest

from engine import Polygon, Wall, World
from engine.kernels.contacts import CROWD
from engine.kernels.sweeps import QUIET, interleave, sweep

G = 9.81
FINE = 1e-9


def towers(number: int, high: int) -> World:
    """Boxes on boxes, side by side, that have stood for a tick."""
    world = World(gravity=(0, -G), integrator="velocity-verlet", kernels="interpreted")
    world.add(Wall((-2, 0), (3.0 * number, 0)), friction=0.5)
    for i in range(number):
        for k in range(high):
            world.add(Polygon.box(1, 1), position=(2.5 * i, k + 0.5), friction=0.5)
    world.step()
    return world


def resting(world: World) -> int:
    """List the pairs that rest; return their number."""
    pairs = world.tables.pairs
    rest = [i for i in range(world.tables.counts.pairs[0]) if pairs.state[i] == 1]
    for k, pair in enumerate(rest):
        pairs.resting[k] = pair
    return len(rest)


def kicks(world: World) -> list[tuple[float, float, float]]:
    """Velocities at the end of the part, of all bodies."""
    bodies = world.tables.bodies
    count = world.tables.counts.bodies[0]
    return [(bodies.kick_x[i], bodies.kick_y[i], bodies.kick_spin[i]) for i in range(count)]


def push(world: World, row: int) -> None:
    """Let all stand, as sweeps see it, but for one body, which comes down at 1 m/s."""
    bodies = world.tables.bodies
    for i in range(world.tables.counts.bodies[0]):
        bodies.kick_x[i] = bodies.kick_y[i] = bodies.kick_spin[i] = 0.0
        bodies.stirred[i] = 0
    bodies.kick_y[row] = -1.0
    contacts = world.tables.contacts
    for i in range(world.tables.counts.contacts[0]):
        contacts.target[i] = contacts.softness[i] = 0.0
        contacts.hardness[i] = contacts.normal_mass[i]
        contacts.normal_impulse[i] = contacts.tangent_impulse[i] = 0.0


def test_a_list_in_turns_holds_the_same_pairs() -> None:
    world = towers(7, 3)
    count = resting(world)
    before = [world.tables.pairs.resting[k] for k in range(count)]
    interleave(world.tables, count)
    after = [world.tables.pairs.resting[k] for k in range(count)]
    assert sorted(after) == before
    length = -(-count // 4)
    assert after[:4] == [before[0], before[length], before[2 * length], before[3 * length]]


def test_what_is_calm_is_passed_over_and_the_rest_comes_out_the_same() -> None:
    """One tower is hit from above: sweeps that look only where something stirs end as others do."""
    world = towers(6, 3)
    count = resting(world)
    hit = 3  # the top of the first tower
    for number in range(2):
        push(world, hit)
        for i in range(1, 400):
            found = sweep(world.tables, count, FINE, i % 2 == 0, i if number else 0)
            if found == QUIET:
                break
        if number == 0:
            everywhere = kicks(world)
    for (x, y, spin), (other_x, other_y, other_spin) in zip(kicks(world), everywhere, strict=True):
        assert (x, y, spin) == pytest.approx((other_x, other_y, other_spin), abs=1e-6)


def test_contacts_far_from_what_stirs_are_left_alone() -> None:
    world = towers(6, 3)
    count = resting(world)
    push(world, 3)
    bodies = world.tables.bodies
    sweep(world.tables, count, FINE, False, 1)
    bodies.kick_y[10] = -1.0  # unnoticed: nothing says that it stirs
    sweep(world.tables, count, FINE, True, 2)
    assert bodies.kick_y[10] == -1.0
    sweep(world.tables, count, FINE, False, 0)
    assert bodies.kick_y[10] > -1.0


def test_a_crowd_comes_to_rest_with_its_books_balanced() -> None:
    """More contacts than make a crowd: springs take back what they lend, and it stands still."""
    world = World(gravity=(0, -G), integrator="velocity-verlet", kernels="interpreted")
    world.add(Wall((-20, 0), (20, 0)), friction=0.6)
    base = 9
    boxes = [
        world.add(
            Polygon.box(1, 1), position=(1.05 * (i - (base - row) / 2), row + 0.5), friction=0.6
        )
        for row in range(base)
        for i in range(base - row)
    ]
    energy = world.kinetic_energy + world.potential_energy
    for _ in range(6):
        world.run(20)
        assert world.kinetic_energy + world.potential_energy < energy
    assert world.ledger().energy_error == pytest.approx(0.0, abs=1e-12 * energy)
    assert (
        sum(1 for i in range(world.tables.counts.pairs[0]) if world.tables.pairs.state[i]) > CROWD
    )
    assert max(box.speed for box in boxes) == 0.0
