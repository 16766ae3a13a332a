"""Trees of hinges: their order, their elimination, and what they remember between ticks."""

import math
import random

import numpy as np
import pytest

from engine import Body, Circle, Distance, Particle, Pin, Polygon, World
from engine.kernels import travel
from engine.linkage.limbs import gather_masses, resolve, solve_all, stand


def sprawl(count: int, held: bool, seed: int) -> tuple[World, list[Body]]:
    """Boxes hinged to each other at random, without a ring."""
    dice = random.Random(seed)
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    bodies: list[Body] = []
    for i in range(count):
        at = (10.0 * dice.random(), 10.0 * dice.random())
        kind = Particle(0.1) if i % 5 == 4 else Polygon.box(0.5, 0.2)
        body = world.add(kind, position=at, mass=0.5 + dice.random(), spin=0.0)
        pin = Pin(at=(at[0] + dice.uniform(-1, 1), at[1] + dice.uniform(-1, 1)))
        if bodies:
            other = bodies[dice.randrange(len(bodies))]
            world.join(*((other, body) if i % 2 else (body, other)), pin)
        elif held:
            world.join(None, body, pin)
        for other in bodies:
            world.ignore(other, body)
        bodies.append(body)
    return world, bodies


@pytest.mark.parametrize("held", [False, True])
def test_a_tree_is_solved_as_its_whole_matrix_would_be(held: bool) -> None:
    """Impulses P with J M^-1 J^T P = u, and the velocities M^-1 J^T P."""
    world, _ = sprawl(12, held, 3)
    world.store.order_joints()
    t = world.tables
    limbs, bones = t.limbs, t.bones
    count, movable = bones.sizes[0], bones.sizes[1]
    assert (count, movable, t.braces.sizes[0]) == (12 if held else 11, 12, 0)
    gather_masses(t)
    stand(t)
    resolve(t)
    dice = random.Random(1)
    jacobian = np.zeros((2 * count, 3 * movable))
    inverse = np.zeros(3 * movable)
    for bone in range(movable):
        masses = (bones.inverse_mass[bone], bones.inverse_mass[bone], bones.inverse_inertia[bone])
        inverse[3 * bone : 3 * bone + 3] = masses
    wanted = np.zeros(2 * count)
    for k in range(count):
        limbs.rate_x[k], limbs.rate_y[k] = dice.uniform(-1, 1), dice.uniform(-1, 1)
        wanted[2 * k : 2 * k + 2] = limbs.rate_x[k], limbs.rate_y[k]
        ends = ((k, 1.0, limbs.arm_x[k], limbs.arm_y[k]),)
        ends += ((limbs.parent[k], -1.0, limbs.lever_x[k], limbs.lever_y[k]),)
        for bone, sign, x, y in ends:
            if bone < movable:
                jacobian[2 * k, 3 * bone : 3 * bone + 3] = sign, 0.0, -sign * y
                jacobian[2 * k + 1, 3 * bone : 3 * bone + 3] = 0.0, sign, sign * x
    solve_all(t)
    impulses = np.linalg.solve(jacobian * inverse @ jacobian.T, wanted)
    found = np.array([(limbs.answer_x[k], limbs.answer_y[k]) for k in range(count)]).ravel()
    assert found == pytest.approx(impulses, rel=1e-9, abs=1e-11)
    moves = inverse * (jacobian.T @ impulses)
    for bone in range(movable):
        step = (bones.step_x[bone], bones.step_y[bone], bones.step_spin[bone])
        assert step == pytest.approx(tuple(moves[3 * bone : 3 * bone + 3]), rel=1e-9, abs=1e-11)


def test_rings_rods_and_limits_are_no_trees() -> None:
    for spoil in ("ring", "rod", "limit", "second anchor"):
        world, bodies = sprawl(4, True, 5)
        if spoil == "ring":
            world.join(bodies[0], bodies[3], Pin(at=(0, 0)))
        elif spoil == "rod":
            world.join(bodies[3], None, Distance(anchor_b=(30, 0)))
        elif spoil == "limit":
            more = world.add(Circle(0.2), position=(20, 0))
            world.join(bodies[3], more, Pin(at=(19, 0), limits=(-1, 1)))
        else:
            world.join(None, bodies[3], Pin(at=bodies[3].position))
        world.store.order_joints()
        assert (world.tables.bones.sizes[0], world.tables.braces.sizes[0]) == (0, 5)
        world.step()


def test_a_restored_tree_goes_on_as_if_never_interrupted() -> None:
    world, bodies = sprawl(9, True, 7)
    for _ in range(20):
        world.step()
    saved = world.snapshot()
    loaded = World.from_dict(world.to_dict())
    for _ in range(20):
        world.step()
    digest = world.digest()
    world.restore(saved)
    for _ in range(20):
        world.step()
        loaded.step()
    assert world.digest() == digest == loaded.digest()
    assert bodies[0].spin != 0


def test_what_is_left_of_a_tree_when_a_body_goes_is_trees() -> None:
    world, bodies = sprawl(9, False, 7)
    world.step()
    hub = max(bodies, key=lambda body: sum(body in (joint.a, joint.b) for joint in world.joints))
    world.remove(hub)
    for _ in range(30):
        world.step()
    assert world.tables.bones.sizes[0] == len(world.joints)
    assert max(math.dist(*joint.anchors) for joint in world.joints) < 1e-8


def test_a_body_that_was_moved_by_hand_is_brought_back() -> None:
    world = World()
    disc = world.add(Circle(0.5), position=(1, 0))
    joint = world.join(None, disc, Pin(at=(0, 0)))
    world.step()
    disc.position = (1.05, 0)
    for _ in range(4):  # two radii a second: faster would throw it
        world.step()
    assert math.dist(*joint.anchors) < 1e-9


def test_slow_trees_take_long_parts_and_fast_ones_short() -> None:
    """The same pendulum, slow and fast: energy is kept alike."""
    for spin in (0.1, 3.0, 30.0):
        world = World(gravity=(0, -1.0), integrator="velocity-verlet")
        rod = world.add(Polygon.box(1, 0.01), position=(0, -0.5), angle=math.pi / 2)
        world.join(None, rod, Pin(at=(0, 0)))
        rod.spin, rod.velocity = spin, (0.5 * spin, 0)
        start = world.kinetic_energy + world.potential_energy
        for _ in range(120):
            world.step()
        now = world.kinetic_energy + world.potential_energy
        assert now == pytest.approx(start, abs=2e-4 * (1 + spin * spin / 6))


def runs_of(world: World) -> list[tuple[int, int, int]]:
    """First row, row after the last, and lead of each run."""
    bones = world.tables.bones
    columns = bones.run_first, bones.run_end, bones.run_lead
    return [tuple(column[run] for column in columns) for run in range(bones.sizes[12])]


def test_the_same_hinge_of_trees_of_one_shape_is_a_run() -> None:
    world = World()
    for tree in range(5):
        root = world.add(Circle(0.1), position=(3.0 * tree, 0.0))
        for side in (-1, 1):  # two limbs of two hinges each
            above = root
            for link in (1, 2):
                at = (3.0 * tree + side * link, 0.0)
                body = world.add(Circle(0.1), position=at)
                world.join(above, body, Pin(at=at))
                above = body
    world.store.order_joints()
    # The hands, then each arm: both are hinged to the root.
    assert [end - first for first, end, _ in runs_of(world)] == [10, 5, 5]


@pytest.mark.parametrize("held", [False, True])
def test_no_limb_of_a_run_depends_on_another(held: bool) -> None:
    world, _ = sprawl(40, held, 5)
    world.store.order_joints()
    parent, count = world.tables.limbs.parent, world.tables.bones.sizes[0]
    rows = [k for first, end, _ in runs_of(world) for k in range(first, end)]
    assert rows == list(range(count))
    for first, end, lead in runs_of(world):
        assert [parent[k] for k in range(first, end)] == [k + lead for k in range(first, end)]
        assert parent[first] >= end


def test_many_chains_swing_as_one() -> None:
    def swung(chains: int) -> list[tuple[float, float, float]]:
        world, links = World(gravity=(0, -9.81)), []
        for x in range(chains):
            above = None
            for link in range(6):
                body = world.add(Circle(0.05), position=(link + 0.5, 0.0), group=1)
                world.join(above, body, Pin(at=(float(link), 0.0)))
                above = body
                if x == 0:
                    links.append(body)
        for _ in range(40):
            world.step(1 / 60)
        return [(link.x, link.y, link.angle) for link in links]

    assert swung(1) == swung(9)


def test_hinges_solved_once_between_two_parts_move_as_if_solved_twice(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """What they exert at the end of a part, within a tick, is part of what they exert next."""

    def whip(ticks: int) -> list[Body]:
        world = World(gravity=(0, -9.81), integrator="velocity-verlet")
        rods: list[Body] = []
        for i in range(8):
            rods.append(world.add(Polygon.box(0.4, 0.1), mass=1.0, position=(0.4 * i + 0.2, 0)))
            rods[i].spin = 8.0 + i
            rods[i].mask = 0
            world.join(rods[i - 1] if i else None, rods[i], Pin(at=(0.4 * i, 0)))
        for _ in range(ticks):
            world.step()
        return rods

    once = whip(5)
    owing = []
    real = travel.let_owe
    monkeypatch.setattr(
        travel,
        "let_owe",
        lambda t, pairs, held, part, may: owing.append(may) or real(t, pairs, held, part, False),
    )
    twice = whip(5)
    assert any(owing)
    for a, b in zip(once, twice, strict=True):
        assert a.position == pytest.approx(b.position, abs=1e-7)
        assert a.velocity == pytest.approx(b.velocity, abs=1e-5)
        assert a.spin == pytest.approx(b.spin, abs=1e-4)
