"""What rests steadily is balanced once a tick, and wakes at once when something happens to it."""

import math

import numpy as np
import pytest

from engine import Body, Circle, Force, Polygon, Wall, World
from engine.kernels.steady import LONG, is_braked, is_unsteady, slides_on
from engine.kernels.sticking import FIXED, LOOSE

G = 9.81


def pyramid(base: int = 4) -> tuple[World, list[Body]]:
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-20, 0), (20, 0)), friction=0.6)
    boxes = [
        world.add(Polygon.box(1, 1), position=(1.05 * (i - (base - row) / 2), row + 0.5))
        for row in range(base)
        for i in range(base - row)
    ]
    for box in boxes:
        box.friction = 0.6
    return world, boxes


def steady_pairs(world: World) -> int:
    pairs = world.tables.pairs
    return sum(pairs.steady[i] for i in range(world.tables.counts.pairs[0]) if pairs.state[i] == 1)


def test_a_pyramid_becomes_steady_and_stays_where_it_is() -> None:
    world, boxes = pyramid()
    for _ in range(300):
        world.step()
    assert steady_pairs(world) > 0
    places = [box.position for box in boxes]
    for _ in range(600):
        assert world.step() == []
        assert max(box.speed for box in boxes) < 2e-4
    assert max(math.dist(box.position, p) for box, p in zip(boxes, places, strict=True)) < 1e-4


def test_what_hits_a_steady_pyramid_hits_it_in_time() -> None:
    """A ball that falls 2 m arrives after sqrt(2 h / g), and only loses energy."""
    world, boxes = pyramid()
    for _ in range(300):
        world.step()
    top = max(box.y for box in boxes) + 0.5
    above = next(box.x for box in boxes if box.y > top - 0.6)
    world.add(Circle(0.2), position=(above, top + 2.2), mass=2, restitution=0.5)
    began, energy = world.time, world.kinetic_energy + world.potential_energy
    collisions = []
    fastest = 0.0
    for _ in range(60):
        collisions += world.step()
        fastest = max(fastest, *(box.speed for box in boxes))
    assert collisions[0].time - began == pytest.approx(math.sqrt(2 * 2 / G), abs=1e-6)
    assert fastest > 1e-3
    assert world.kinetic_energy + world.potential_energy < energy


def test_steady_bodies_slide_as_soon_as_friction_is_not_enough() -> None:
    """a = g (sin - mu cos) from the tick in which gravity is turned."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-10, 0), (60, 0)), friction=0.3)
    box = world.add(Polygon.box(1, 1), position=(0, 0.5), friction=0.3)
    for _ in range(120):
        world.step()
    assert steady_pairs(world) == 1
    angle = math.radians(25)
    world.gravity = (G * math.sin(angle), -G * math.cos(angle))
    start = box.x
    for _ in range(60):
        world.step()
    a = G * (math.sin(angle) - 0.3 * math.cos(angle))
    assert box.vx == pytest.approx(a, rel=1e-3)
    assert box.x - start == pytest.approx(a / 2, rel=1e-3)


def test_friction_brakes_what_it_cannot_hold_not_what_jiggles() -> None:
    """Coulomb: friction that is below its most holds; a slip is then what sweeps have left."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-20, 0), (20, 0)), friction=0.5)
    box = world.add(Polygon.box(1, 1), position=(0, 0.5), friction=0.5)
    for _ in range(5):
        world.step()
    box.velocity = (1e-4, 0)
    contacts = world.tables.contacts
    held = sum(contacts.normal_impulse[row] for row in (0, 1))
    for rub, brakes in ((0.0, False), (0.2, False), (0.5, True), (-0.5, True)):
        contacts.tangent_impulse[0], contacts.tangent_impulse[1] = rub * held, 0.0
        assert is_braked(world.tables, 0) is brakes
    box.velocity = (0, 0)
    assert not is_braked(world.tables, 0)


def test_sliding_that_friction_ends_at_once_keeps_nothing_from_being_steady() -> None:
    """A slip of mu g h ends within h: slower sliding, though braked, has come to its end."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-20, 0), (20, 0)), friction=0.5)
    box = world.add(Polygon.box(1, 1), position=(0, 0.5), friction=0.5)
    for _ in range(5):
        world.step()
    tables = world.tables
    for row in (0, 1):
        tables.contacts.tangent_impulse[row] = -0.5 * tables.contacts.normal_impulse[row]
    tables.bodies.calm[0] = tables.bodies.calm[1] = LONG
    most = 0.5 * G * tables.pairs.part[0] / tables.contacts.tangent_mass[0]
    for slip, slides in ((0.9 * most, False), (1.1 * most, True)):
        box.velocity = (slip, 0)
        assert is_braked(tables, 0)
        assert is_unsteady(tables, 0) is slides


def test_what_slides_is_steady_only_if_others_fix_it() -> None:
    """A box that friction does not hold goes on to slide; one that is fixed creeps no further."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-20, 0), (20, 0)), friction=0.5)
    box = world.add(Polygon.box(1, 1), position=(0, 0.5), friction=0.5)
    for _ in range(5):
        world.step()
    box.velocity = (1e-3, 0)
    tables = world.tables
    for row in (0, 1):
        tables.contacts.tangent_impulse[row] = -0.5 * tables.contacts.normal_impulse[row]
    floor = tables.pairs.a[0] + tables.pairs.b[0] - 1
    for stuck, slides in ((FIXED, False), (LOOSE, True)):
        tables.bodies.stuck[floor], tables.bodies.stuck[1] = FIXED, stuck
        tables.bodies.calm[1] = LONG
        assert slides_on(tables, 1) is slides
        assert (tables.bodies.calm[1] < LONG) is slides


def test_free_bodies_that_are_pressed_together_keep_their_momentum() -> None:
    world = World()
    left = world.add(Polygon.box(1, 1), position=(0, 0), friction=0.5, mass=2)
    right = world.add(Polygon.box(1, 1), position=(1, 0), friction=0.5)
    left.exert(Force(3, 0))
    right.exert(Force(-3, 0))
    for _ in range(120):
        world.step()
    assert world.momentum == pytest.approx((0, 0), abs=1e-13)
    assert steady_pairs(world) == 1
    assert right.x - left.x == pytest.approx(1, abs=1e-4)


@pytest.mark.parametrize("after", [150, 400])
def test_a_world_continues_from_a_snapshot_bit_for_bit(after: int) -> None:
    world, boxes = pyramid(3)
    for _ in range(after):
        world.step()
    saved = world.snapshot()
    digests = []
    for _ in range(2):
        world.restore(saved)
        boxes[-1].exert(Force(2, 0), duration=0.5)
        for _ in range(60):
            world.step()
        digests.append(world.digest())
    assert digests[0] == digests[1]


def rolls_over_an_edge(restless: bool) -> tuple[list[tuple[float, float]], int]:
    """Where a disc is that rolls off a heavy box at 0.43 radii a second; in how many ticks all was
    steady. `restless`: nothing is ever taken for calm.
    """
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-9, 0), (99, 0)), friction=0.5)
    world.add(Polygon.box(2, 1), position=(0, 0.5), mass=50, friction=0.5)
    disc = world.add(
        Circle(0.35), position=(0.4, 1.35), velocity=(0.15, 0), spin=-0.15 / 0.35, friction=0.5
    )
    places, steady = [], 0
    for _ in range(330):
        if restless:
            np.asarray(world.store.tables.bodies.calm)[:] = 0
        world.step()
        places.append((disc.x, disc.y))
        steady += steady_pairs(world) > 0
    return places, steady


def test_a_disc_that_rolls_evenly_is_steady_until_it_rolls_over_the_edge() -> None:
    """Uniform motion needs no force; at the edge it must not be taken for uniform any longer."""
    places, steady = rolls_over_an_edge(restless=False)
    others, never = rolls_over_an_edge(restless=True)
    assert never == 0
    assert steady > 180
    assert places[120][0] - places[60][0] == pytest.approx(0.15, rel=1e-3)
    assert places[-1][1] < 1.0
    assert max(math.dist(a, b) for a, b in zip(places, others, strict=True)) < 5e-3
