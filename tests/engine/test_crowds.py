"""Contacts of a crowd are swept side by side, and that is the same as one after another."""

import pytest

from engine import Box, Circle, Wall, World
from engine.kernels.contacts import CROWD
from engine.kernels.crowds import sweep_crowd, sweep_until_calm, warm_start_crowd
from engine.kernels.packing import STREAMS, pack
from engine.kernels.sweeps import sweep, warm_start
from engine.tables import LANES, RESTING

G = 9.81
Kicks = list[tuple[float, float, float]]


def wall_of_bricks(rolling: float = 0.0) -> World:
    """Bricks on bricks with discs on top, that have begun to settle."""
    world = World(gravity=(0, -G), integrator="velocity-verlet", kernels="interpreted")
    world.add(Wall((-20, 0), (20, 0)), friction=0.5)
    for row in range(5):
        for i in range(9):
            place = (1.02 * i + 0.5 * (row % 2), 0.501 * row + 0.251)
            world.add(Box(1, 0.5), position=place, friction=0.5)
    for i in range(8):
        disc = world.add(Circle(0.4), position=(1.02 * i + 0.7, 2.906), friction=0.5)
        disc.rolling_resistance = rolling
    world.run(3)
    return world


def list_resting(world: World) -> int:
    """List the pairs that rest, and let all bodies begin with their velocities; how many pairs."""
    pairs, bodies = world.tables.pairs, world.tables.bodies
    rest = [i for i in range(world.tables.counts.pairs[0]) if pairs.state[i] == RESTING]
    for k, pair in enumerate(rest):
        pairs.resting[k] = pair
    for row in range(world.tables.counts.bodies[0]):
        bodies.kick_x[row] = bodies.vx[row]
        bodies.kick_y[row] = bodies.vy[row] - G / 360 if bodies.inverse_mass[row] > 0.0 else 0.0
        bodies.kick_spin[row] = bodies.spin[row]
    return len(rest)


def take_in_turns(world: World, count: int) -> None:
    """Reorder the list of pairs that rest as they are packed: of each quarter one in turn."""
    resting = world.tables.pairs.resting
    listed = [resting[k] for k in range(count)]
    length = -(-count // STREAMS)
    quarters = [listed[start : start + length] for start in range(0, count, length)]
    turns = [quarter[i] for i in range(length) for quarter in quarters if i < len(quarter)]
    for k, pair in enumerate(turns):
        resting[k] = pair


def kicks(world: World) -> Kicks:
    """Velocities at the end of the part, of all bodies."""
    bodies = world.tables.bodies
    count = world.tables.counts.bodies[0]
    return [(bodies.kick_x[i], bodies.kick_y[i], bodies.kick_spin[i]) for i in range(count)]


def impulses(world: World) -> list[tuple[float, float]]:
    """Impulses of all points that rest."""
    pairs, contacts = world.tables.pairs, world.tables.contacts
    return [
        (contacts.normal_impulse[row], contacts.tangent_impulse[row])
        for pair in range(world.tables.counts.pairs[0])
        if pairs.state[pair] == RESTING
        for row in range(2 * pair, 2 * pair + pairs.points[pair])
    ]


def packed(world: World) -> list[list[int]]:
    """Pairs by blocks."""
    lanes = world.tables.lanes
    return [
        [lanes.pair[block * LANES + i] for i in range(lanes.filled[block])]
        for block in range(lanes.sizes[0])
    ]


def test_side_by_side_is_the_same_as_one_after_another() -> None:
    """To the bit, warm start included: a contact comes after all that came before it in the list
    and has a body in common with it.
    """
    one, other = wall_of_bricks(), wall_of_bricks()
    count = list_resting(one)
    assert list_resting(other) == count > CROWD
    take_in_turns(one, count)
    warm_start(one.tables, count)
    pack(other.tables, count, len(other))
    warm_start_crowd(other.tables)
    assert kicks(one) == kicks(other)
    for i in range(4):
        sweep(one.tables, count, 1e-9, i % 2 == 0)
    assert not sweep_until_calm(other.tables, 4, 1e-9, 1)
    assert kicks(one) == kicks(other)
    assert impulses(one) == impulses(other)


def test_no_block_moves_a_body_twice() -> None:
    world = wall_of_bricks()
    count = list_resting(world)
    pack(world.tables, count, len(world))
    pairs, inverse_mass = world.tables.pairs, world.tables.bodies.inverse_mass
    assert sorted(pair for block in packed(world) for pair in block) == sorted(
        pairs.resting[k] for k in range(count)
    )
    for block in packed(world):
        rows = [row for pair in block for row in (pairs.a[pair], pairs.b[pair])]
        movable = [row for row in rows if inverse_mass[row] > 0.0]
        assert len(movable) == len(set(movable))
    assert len(packed(world)) < 2 * count / LANES


def test_what_resists_rolling_is_swept_by_itself() -> None:
    world = wall_of_bricks(rolling=0.01)
    world.run(1)  # none is about to leave the others
    count = list_resting(world)
    pack(world.tables, count, len(world))
    pairs = world.tables.pairs
    apart = world.tables.lanes.sizes[1]
    assert apart > 0
    listed = [pairs.resting[k] for k in range(count)]
    assert all(pairs.rolling_resistance[pair] > 0.0 for pair in listed[:apart])
    assert all(pairs.rolling_resistance[pair] == 0.0 for pair in listed[apart:])
    assert len(set(listed)) == count
    before = kicks(world)
    sweep_crowd(world.tables, 1e-9, False)
    changed = [i for i, kick in enumerate(kicks(world)) if kick != before[i]]
    assert changed == [i for i, body in enumerate(world) if not body.is_wall]


def plank() -> World:
    """More boxes on a plank than there are blocks: each contact of one body needs its own."""
    world = World(gravity=(0, -G), integrator="velocity-verlet", kernels="interpreted")
    world.add(Wall((-60, 0), (60, 0)), friction=0.5)
    world.add(Box(100, 0.5), mass=100.0, position=(0, 0.25), friction=0.5)
    for i in range(70):
        world.add(Box(1, 1), mass=1.0, position=(1.2 * (i - 35), 1.0), friction=0.5)
    return world


def test_contacts_that_find_no_block_are_swept_by_themselves() -> None:
    world = plank()
    world.run(20)
    count = list_resting(world)
    pack(world.tables, count, len(world))
    assert count == 71
    assert world.tables.lanes.sizes[1] > 0
    assert world.ledger().energy_error == pytest.approx(0.0, abs=1e-9)
    assert max(body.speed for body in world) < 1e-3


def test_how_much_room_a_world_has_does_not_matter() -> None:
    worlds = [plank(), plank()]
    worlds[1].store.make_room_for_pairs(1000)
    for world in worlds:
        world.run(5)
    assert worlds[0].digest() == worlds[1].digest()
    worlds[1] = World.from_dict(worlds[0].to_dict())
    for world in worlds:
        world.run(3)
    assert worlds[0].digest() == worlds[1].digest()


def test_a_crowd_comes_to_rest_with_its_books_balanced() -> None:
    """More contacts than make a crowd: springs take back what they lend, and it stands still."""
    world = World(gravity=(0, -G), integrator="velocity-verlet", kernels="interpreted")
    world.add(Wall((-20, 0), (20, 0)), friction=0.6)
    base = 9
    boxes = [
        world.add(Box(1, 1), position=(1.05 * (i - (base - row) / 2), row + 0.501), friction=0.6)
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
