"""Compiled and interpreted kernels are one and the same source, and give the same bits."""

import itertools
import math
import random
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from engine import (
    Box,
    Capsule,
    Chain,
    Circle,
    Compound,
    Distance,
    Force,
    LinearDrag,
    Particle,
    Pin,
    PointGravity,
    Polygon,
    Pulley,
    QuadraticDrag,
    Rope,
    Slider,
    Spring,
    SpringTo,
    Torque,
    Wall,
    Weld,
    World,
    warming,
)
from engine.jit import compiled
from engine.modes import INTERPRETED
from engine.tables import ROWS
from tests.benchmarks.worlds import SCENES, gas, pyramid

pytest.importorskip("numba")


@pytest.mark.parametrize("scene", SCENES)
def test_every_scene_of_the_benchmark_ends_in_the_same_bits(scene: str) -> None:
    worlds = [SCENES[scene](mode) for mode in ("interpreted", "compiled")]
    for world in worlds:
        for _ in range(20):
            world.step()
    assert worlds[0].digest() == worlds[1].digest()
    assert [world.kernels for world in worlds] == ["interpreted", "compiled"]


def throw(seed: int, integrator: str, drag: Any, gravity: tuple[float, float], mode: str) -> World:
    """A room into which bodies of all shapes were thrown, some of them pushed."""
    dice = random.Random(seed)
    world = World(gravity=gravity, integrator=integrator, drag=drag, kernels=mode)
    corners = [(0.0, 0.0), (5.0, 0.3), (5.0, 5.0), (-0.5, 5.0)]
    for i in range(4):
        world.add(Wall(corners[i], corners[(i + 1) % 4]), restitution=0.5, friction=0.4)
    makers: list[Callable[[], Any]] = [
        lambda: Circle(dice.uniform(0.1, 0.4)),
        lambda: Particle(dice.uniform(0.1, 0.3)),
        lambda: Polygon.box(dice.uniform(0.2, 0.8), dice.uniform(0.2, 0.8)),
        lambda: Polygon.regular(dice.randrange(3, 9), dice.uniform(0.2, 0.5)),
    ]
    for i in range(dice.randrange(2, 14)):
        body = world.add(
            dice.choice(makers)(),
            mass=dice.uniform(0.2, 5.0),
            position=(0.8 + i % 4 * 1.1, 0.8 + i // 4 * 1.2),
            angle=dice.choice([1.0, 1e8]) * dice.uniform(-3, 3),
            velocity=(dice.uniform(-4, 4), dice.uniform(-4, 4)),
            restitution=dice.choice([0.0, 0.3, 1.0]),
            friction=dice.choice([0.0, 0.5]),
        )
        if i % 3 == 0:
            body.exert(Force(dice.uniform(-5, 5), 3), duration=0.11, at=(body.x + 0.1, body.y))
        if i % 4 == 1:
            body.exert(Torque(dice.uniform(-1, 1)))
    if seed % 2:
        world.add_law(SpringTo((2.0, 2.0), 3.0, damping=0.1))
    return world


@settings(max_examples=25, suppress_health_check=list(HealthCheck))
@given(
    seed=st.integers(0, 2**30),
    integrator=st.sampled_from(
        ["semi-implicit-euler", "velocity-verlet", "explicit-euler", "rk4"],
    ),
    drag=st.sampled_from([None, LinearDrag(0.3), QuadraticDrag(0.2)]),
    gravity=st.sampled_from([(0.0, 0.0), (0.0, -9.81), (3.0, -1.0)]),
)
def test_random_worlds_end_in_the_same_bits(
    seed: int, integrator: str, drag: Any, gravity: tuple[float, float]
) -> None:
    worlds = [throw(seed, integrator, drag, gravity, m) for m in ("interpreted", "compiled")]
    told = []
    for world in worlds:
        told.append([(c.time, c.a.id, c.b.id, c.impulse) for _ in range(12) for c in world.step()])
    assert worlds[0].digest() == worlds[1].digest()
    assert told[0] == told[1]


def everything(mode: str) -> World:
    """Laws of force, filters, kinds of bodies, a sensor, sleepers that are woken."""
    world = World(gravity=(0, -9.81), integrator="velocity-verlet", kernels=mode, sleeping=True)
    world.add(Wall((-20, 0), (20, 0)), friction=0.5)
    for i in range(3):
        world.add(Polygon.box(1, 1), position=(0, 0.5 + i), friction=0.5)
    world.add(
        Polygon.box(4, 0.2), kind="kinematic", position=(-8, 1), velocity=(0.5, 0), spin=0.7,
        restitution=0.4,
    )  # fmt: skip
    world.add(Circle(1), kind="static", sensor=True, position=(1, 1))
    balls = [
        world.add(
            Circle(0.3), position=(-6 + i, 6 + i), restitution=0.5, friction=0.3,
            gravity_scale=0.5, group=i % 2,
        )
        for i in range(4)
    ]  # fmt: skip
    world.add_law(SpringTo((2, 3), 3.0, 0.1), balls[:2])
    world.add_law(PointGravity((0, 5), 2.0, 0.3))
    world.add_law(lambda body, time: (2.0 * time, -body.x, 0.1), balls[2:])
    world.add(Circle(0.3), mass=3, position=(-10, 0.5), velocity=(3, 4), restitution=0.3)
    return world


def test_all_that_a_world_can_hold_gives_the_same_bits() -> None:
    told = []
    for mode in ("interpreted", "compiled"):
        world = everything(mode)
        contacts = []
        for _ in range(150):
            world.step()
            contacts += [(c.a.id, c.b.id, c.phase, c.impulse) for c in world.contacts]
        told.append((world.digest(), contacts, [body.is_asleep for body in world]))
    assert told[0] == told[1]


def linked(mode: str) -> World:
    """Every joint, and every shape and law of contact, over a bumpy chain."""
    world = World(gravity=(0.0, -9.81), kernels=mode)
    world.add(Chain([(-4, 1), (-2, 0), (0, 0.2), (2, 0), (6, 1)]), friction=0.5)
    world.add(Box(4, 0.4), kind="static", position=(0, -3), friction=0.6, surface_speed=1.5)
    shapes = [
        Box(0.6, 0.4, rounding=0.05),
        Capsule(0.5, 0.2),
        Polygon.concave([(0, 0), (0.8, 0), (0.8, 0.3), (0.3, 0.3), (0.3, 0.9), (0, 0.9)]),
        Compound([(Circle(0.2), (-0.4, 0)), (Circle(0.2), (0.4, 0)), Box(0.8, 0.1)]),
        Circle(0.25),
        Polygon.regular(5, 0.3),
    ]
    bodies = [
        world.add(shape, position=(-2 + i, 2.5), friction=0.4, restitution=0.2, static_friction=0.6)
        for i, shape in enumerate(shapes)
    ]
    bodies[4].rolling_resistance = 0.01
    a, b, c, d, e, f = bodies
    world.join(a, b, Pin((-1.5, 2.5), limits=(-0.5, 0.5)), collide=True)
    world.join(b, c, Distance())
    world.join(c, d, Spring(40.0, 1.0))
    world.join(d, e, Rope(length=1.2), break_force=60.0)
    world.join(None, f, Slider((0, 1), limits=(-1, 1), motor_speed=0.5, max_force=30.0))
    world.join(e, f, Weld())
    world.join(a, f, Pulley((-2, 6), (3, 6)))
    return world


def limbs(mode: str) -> World:
    """Short chains of hinged boxes that fall on the floor and on each other."""
    world = World(gravity=(0.0, -9.81), kernels=mode)
    world.add(Wall((-9, 0), (9, 0)), friction=0.3)
    for i in range(5):
        x, y = 0.35 * i, 0.4 + 0.5 * i
        links = [
            world.add(Box(0.5, 0.15), mass=0.1, position=(x + 0.5 * k, y), angle=0.0, friction=0.4)
            for k in range(3)
        ]
        for k, (a, b) in enumerate(itertools.pairwise(links)):
            world.join(a, b, Pin((x + 0.5 * k + 0.25, y)))
    return world


@pytest.mark.parametrize(("scene", "ticks"), [(limbs, 120), (linked, 90)])
def test_joints_shapes_and_contact_laws_give_the_same_bits(
    scene: Callable[[str], World], ticks: int
) -> None:
    worlds = [scene(mode) for mode in ("interpreted", "compiled")]
    for world in worlds:
        for _ in range(ticks):
            world.step()
    assert worlds[0].digest() == worlds[1].digest()
    assert worlds[0].ledger() == worlds[1].ledger()


def built(seed: int, mode: str) -> World:
    """Stacks that touch exactly, of which some stand, in a world whose forces change."""
    dice = random.Random(seed)
    world = World(gravity=(0, -9.81), kernels=mode)
    world.add(Wall((-50, 0), (50, 0)), friction=dice.choice([0.0, 0.3, 0.6]))
    stack: list[Any] = []
    for x in range(-6, 7, 4):
        y = 0.0
        for _ in range(dice.randint(1, 5)):
            width, height, mass = dice.uniform(0.5, 1.5), dice.uniform(0.2, 1.0), dice.uniform(1, 9)
            place = (x + dice.uniform(-0.2, 0.2), y + height / 2)
            stack.append(world.add(Box(width, height), mass=mass, position=place, friction=0.5))
            y += height
        world.add(Circle(0.3), position=(x, y + 0.3), friction=0.5)
    world.run(3)
    stack[0].exert(Force(dice.uniform(-9, 9), 0), duration=0.1)
    world.run(3)
    world.gravity = (dice.uniform(-2, 2), -5.0)
    world.run(3)
    world.remove(dice.choice(stack))
    world.run(3)
    return world


@given(seed=st.integers(0, 2**32))
@settings(max_examples=20, deadline=None)
def test_what_is_built_ends_in_the_same_bits(seed: int) -> None:
    assert built(seed, "interpreted").digest() == built(seed, "compiled").digest()


def test_a_pyramid_of_base_40_stands_where_it_was_built() -> None:
    """820 boxes; here because only compiled kernels do that in a moment."""
    world = pyramid(40, "compiled")
    before = world.state()
    assert (world.run(1, record=("x", "y", "angle"))["y"][1] == before[:, 2]).all()
    world.run(599)
    assert (world.state() == before).all()
    assert world.kinetic_energy == 0.0


def test_a_pyramid_of_base_40_that_lands_comes_to_rest() -> None:
    """Its rows fall on each other by a millimetre; after a second it creeps by less than that."""
    world = pyramid(40, "compiled", 1e-3)
    boxes = [body for body in world if math.isfinite(body.mass)]
    world.run(60)
    places = [box.position for box in boxes]
    world.run(540)
    ways = [math.dist(box.position, p) for box, p in zip(boxes, places, strict=True)]
    assert max(ways) < 1e-3
    assert max(box.speed for box in boxes) < 1e-12


def test_an_elastic_gas_of_a_hundred_keeps_its_books_for_a_minute() -> None:
    """Energy, and momentum with what the walls gave, to rounding."""
    world = gas(100, "compiled")
    energy = world.kinetic_energy
    world.run(3600)
    assert world.kinetic_energy == pytest.approx(energy, rel=1e-9)
    books = world.ledger()
    scale = math.sqrt(2 * energy * sum(body.mass for body in world if math.isfinite(body.mass)))
    assert math.hypot(*books.momentum_error) < 1e-12 * scale
    assert math.hypot(*books.momentum) < scale


def test_a_hundred_circles_in_one_point_come_apart() -> None:
    """They overlap no more, and nothing is thrown: 1 kg and 10 J in all are 0.45 m/s each."""
    world = World(kernels="compiled")
    discs = [world.add(Circle(0.1)) for _ in range(100)]
    world.run(600)
    assert all(math.isfinite(value) for disc in discs for value in (*disc.position, disc.angle))
    assert world.kinetic_energy < 10.0
    gaps = [math.dist(a.position, b.position) - 0.2 for a, b in itertools.combinations(discs, 2)]
    assert min(gaps) > -2e-3


def test_a_world_may_change_between_two_ticks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LAWS_KERNELS", "auto")
    monkeypatch.setattr("engine.clockwork.WORTHWHILE", 0.0)
    monkeypatch.setattr("engine.clockwork.AGAIN", 0.02)

    class Ready:
        asked = 0

        def kernels(self) -> Any:
            self.asked += 1
            return compiled() if self.asked > 1 else None

    ready = Ready()
    monkeypatch.setattr(warming, "background", lambda: ready)
    worlds = [throw(5, "velocity-verlet", None, (0.0, -9.81), m) for m in ("interpreted", "auto")]
    for world in worlds:
        for _ in range(100):
            world.step()
    assert worlds[1].kernels == "compiled"
    assert worlds[0].kernels == "interpreted"
    assert worlds[0].digest() == worlds[1].digest()


def test_many_ticks_in_one_call_are_the_same_ticks() -> None:
    """The door for long runs."""
    worlds = [SCENES["gas, 100"](mode) for mode in ("interpreted", "compiled")]
    stepped = [collision.time for _ in range(40) for collision in worlds[0].step()]
    clockwork = worlds[1]._clockwork
    laws, rules = worlds[1].laws, worlds[1].rules
    at_once = clockwork.advance(laws, rules, 1 / 60, 40)
    assert [collision.time for collision in at_once] == stepped
    assert worlds[0].digest() == worlds[1].digest()
    assert worlds[1].tick == 40


def test_books_and_tracks_are_the_same() -> None:
    runs = []
    for mode in ("interpreted", "compiled"):
        world = throw(3, "semi-implicit-euler", LinearDrag(0.3), (0.0, -9.81), mode)
        tracks = world.run(60, record=("x", "spin"))
        runs.append((world.ledger(), tracks["x"].tolist(), tracks.collision_count))
    assert runs[0] == runs[1]


def test_worlds_in_threads_do_not_disturb_each_other() -> None:
    """Machine code runs without the lock: each thread has a world of its own."""
    alone = [throw(seed, "rk4", None, (0.0, -9.81), "compiled") for seed in range(4)]
    threaded = [throw(seed, "rk4", None, (0.0, -9.81), "compiled") for seed in range(4)]
    for world in alone:
        world.run(120)
    with ThreadPoolExecutor(4) as pool:
        list(pool.map(lambda world: world.run(120), threaded))
    assert [w.digest() for w in threaded] == [w.digest() for w in alone]


def test_rules_of_python_are_asked_by_both() -> None:
    digests = set()
    for mode in ("interpreted", "compiled"):
        world = World(restitution_rule=min, friction_rule=max, kernels=mode)
        world.add(Wall((0, 0), (9, 0)), restitution=1.0)
        ball = world.add(Circle(1), position=(3, 1.2), velocity=(0, -9), restitution=0.25)
        world.step()
        world.step()
        assert ball.velocity == pytest.approx((0, 2.25))
        digests.add(world.digest())
    assert len(digests) == 1


def test_tables_that_grow_are_followed() -> None:
    """Machine code holds addresses: they change whenever a table gets more room."""
    worlds = [World(gravity=(0, -9.81), kernels=mode) for mode in ("interpreted", "compiled")]
    for world in worlds:
        world.add(Wall((-50, 0), (50, 0)), friction=0.5)
        for i in range(112):
            world.add(
                Polygon.regular(3 + i % 5, 0.5), position=(i % 8, 1 + i // 8), friction=0.5
            ).exert(Force(0.1, 0), duration=0.2)
            if i % 4 == 0:
                world.step()
        saved = world.snapshot()
        world.step()
        world.restore(saved)
        world.remove(world.body(7))
        world.step()
        assert world.store.tables.progress.room[0] > ROWS["pairs"]
    assert worlds[0].digest() == worlds[1].digest()
    assert INTERPRETED.compiled is False
