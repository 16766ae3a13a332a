"""The books: every cause is booked, they always close, and their entries are those of theory."""

import math
import random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine import (
    Box,
    Circle,
    Force,
    Ledger,
    LinearDrag,
    Particle,
    Pin,
    PointGravity,
    Polygon,
    QuadraticDrag,
    Spring,
    SpringTo,
    Torque,
    Wall,
    World,
)

INTEGRATORS = ["semi-implicit-euler", "velocity-verlet", "explicit-euler", "rk4"]
G = 9.81


def closes(ledger: Ledger, rel: float = 1e-12) -> None:
    """Energy and momentum are what the books say, to rounding of what went through them."""
    flow = abs(ledger.work.gravity) + abs(ledger.work.hand) + ledger.dissipated.total
    assert abs(ledger.energy_error) <= rel * max(1.0, flow)
    through = sum(abs(v) for v in (*ledger.impulses.gravity, *ledger.impulses.hand))
    through += sum(abs(v) for v in ledger.impulses.walls)
    assert max(abs(v) for v in ledger.momentum_error) <= 10 * rel * max(1.0, through)


@given(
    seed=st.integers(0, 10**6),
    integrator=st.sampled_from(INTEGRATORS),
    drag=st.sampled_from([None, LinearDrag(0.3), QuadraticDrag(0.2)]),
    gravity=st.sampled_from([(0, 0), (0.7, -G)]),
    fields=st.booleans(),
)
@settings(max_examples=16, derandomize=True)
def test_the_books_of_any_world_close(
    seed: int, integrator: str, drag: Any, gravity: Any, fields: bool
) -> None:
    dice = random.Random(seed)
    world = World(gravity=gravity, drag=drag, integrator=integrator)
    corners = [(0, 0), (5, 0.3), (5, 5), (0, 5)]
    for i in range(4):
        wall = Wall(corners[i], corners[(i + 1) % 4])
        world.add(wall, restitution=dice.random(), friction=dice.random())
    if fields:
        world.add_law(PointGravity((2, 2), 3.0, softening=0.5))
        world.add_law(SpringTo((1, 1), 2.0, damping=0.1))
    shapes = (Circle(0.3), Particle(0.25), Polygon.box(0.6, 0.4), Polygon.regular(5, 0.35))
    bodies = [
        world.add(
            shapes[i % 4],
            mass=dice.uniform(0.3, 4),
            position=(0.8 + 1.1 * (i % 4), 0.8 + 1.3 * (i // 4)),
            velocity=(dice.uniform(-5, 5), dice.uniform(-5, 5)),
            restitution=dice.random(),
            friction=dice.random(),
        )
        for i in range(8)
    ]
    for tick in range(100):
        if tick % 13 == 1:
            bodies[tick % 8].exert(Force(3, 2), duration=0.11, at=bodies[tick % 8].position)
            bodies[(tick + 4) % 8].exert(Torque(0.5), duration=0.2)
        elif tick == 40:
            bodies[3].velocity, bodies[2].mass = (1, 1), 3
            bodies[6].apply_impulse((1, 0), at=(1, 1))
        elif tick == 60:
            world.remove(bodies[5])
            bodies[5] = world.add(Circle(0.2), position=(2.5, 4.5), velocity=(0, -1))
        world.step()
        if tick % 20 == 19:
            closes(world.ledger())


def test_a_ledger_says_what_the_world_says() -> None:
    world = World(gravity=(0, -G))
    world.add(Circle(0.5), mass=2, position=(1, 3), velocity=(1, 2), spin=3)
    world.add(Particle(0.5), mass=1, position=(5, 3))
    world.run(30)
    ledger = world.ledger()
    assert ledger.time == world.time
    assert ledger.momentum == pytest.approx(world.momentum, rel=1e-14)
    assert ledger.angular_momentum == world.angular_momentum
    assert ledger.kinetic == pytest.approx(world.kinetic_energy, rel=1e-14)
    assert ledger.potential == world.potential_energy


@pytest.mark.parametrize("e", [0.0, 0.3, 0.8, 1.0])
def test_an_impact_costs_half_the_reduced_mass_times_the_square_of_the_speed(e: float) -> None:
    """1/2 mu (1 - e^2) u^2: Newton's law of impact."""
    world = World()
    world.add(Circle(0.5), mass=2, velocity=(3, 0), restitution=e)
    world.add(Circle(0.5), mass=5, position=(2, 0), velocity=(-1, 0), restitution=e)
    world.run(60)
    lost = world.ledger().dissipated
    assert lost.restitution == pytest.approx(0.5 * (10 / 7) * (1 - e * e) * 16, abs=1e-12)
    assert (lost.friction, lost.contact, lost.drag) == (0, 0, 0)


def test_what_a_sliding_block_loses_is_friction_along_its_way() -> None:
    """mu m g s, which is all its kinetic energy (Coulomb)."""
    mass, mu = 2.0, 0.3
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-1, 0), (30, 0)), friction=mu)
    block = world.add(Polygon.box(1, 1), mass=mass, position=(0, 0.5), velocity=(5, 0), friction=mu)
    start = world.ledger()
    world.run(180)
    change = world.ledger().since(start)
    assert block.speed < 1e-9
    assert change.kinetic == pytest.approx(-mass * 25 / 2)
    assert change.dissipated.friction == pytest.approx(mass * 25 / 2, rel=1e-4)
    assert change.dissipated.friction == pytest.approx(mu * mass * G * block.x, rel=1e-3)
    assert change.impulses.walls.x == pytest.approx(-mass * 5)
    assert change.impulses.walls.y == pytest.approx(mass * G * 3.0, rel=1e-9)
    closes(world.ledger())


@pytest.mark.parametrize("integrator", INTEGRATORS)
def test_falling_books_work_of_gravity_and_the_error_of_the_integrator(integrator: str) -> None:
    """m g h; the two Euler methods fall too far, or too short, by one part in that of the ticks."""
    world = World(gravity=(0, -G), integrator=integrator)
    body = world.add(Circle(0.1), mass=3, position=(0, 100))
    world.run(120)
    ledger = world.ledger()
    assert ledger.work.gravity == pytest.approx(3 * G * (100 - body.y), rel=1e-12)
    assert ledger.impulses.gravity == pytest.approx((0, -3 * G * 2), rel=1e-12)
    assert ledger.outside_impulse == pytest.approx(ledger.momentum, rel=1e-12)
    longer = {"semi-implicit-euler": 1 / 120, "explicit-euler": -1 / 120}.get(integrator, 0.0)
    share = ledger.work.integrator / ledger.work.gravity
    assert share == pytest.approx(-longer / (1 + longer), abs=1e-12)
    closes(ledger)


@pytest.mark.parametrize(
    ("drag", "speed"), [(LinearDrag(2.0), G / 2), (QuadraticDrag(2.0), math.sqrt(G / 2))]
)
def test_at_terminal_speed_drag_takes_what_gravity_gives(drag: Any, speed: float) -> None:
    """Terminal speed m g / k and sqrt(m g / k): power in is m g v, all of it heat."""
    world = World(gravity=(0, -G), drag=drag, integrator="rk4")
    body = world.add(Circle(0.1), mass=1, velocity=(0, -speed))
    start = world.ledger()
    world.run(60)
    change = world.ledger().since(start)
    assert body.speed == pytest.approx(speed, rel=1e-9)
    assert change.work.gravity == pytest.approx(G * speed, rel=1e-9)
    assert change.dissipated.drag == pytest.approx(G * speed, rel=1e-9)
    assert change.impulses.drag.y == pytest.approx(G, rel=1e-9)
    closes(world.ledger())


def test_pushes_do_force_times_way_and_torque_times_turn() -> None:
    world = World(integrator="velocity-verlet")
    body = world.add(Circle(0.5), mass=2)
    body.exert(Force(4, 0), duration=0.25)
    body.exert(Torque(0.5))
    world.run(60)
    ledger = world.ledger()
    linear = 2 * body.speed**2 / 2
    assert ledger.work.pushes == pytest.approx(linear + 0.5 * body.angle, rel=1e-9)
    assert ledger.impulses.pushes == pytest.approx((1, 0), abs=1e-12)
    closes(ledger)


def test_what_is_done_by_hand_is_booked_as_such() -> None:
    world = World()
    body = world.add(Circle(0.5), mass=2, velocity=(3, 0))
    other = world.add(Circle(0.5), mass=1, position=(0, 9), velocity=(0, 1))
    assert world.ledger().work.hand == pytest.approx(9.5)
    world.step()
    body.velocity = (0, 1)
    world.remove(other)
    ledger = world.ledger()
    assert ledger.impulses.hand == pytest.approx((0, 2))
    assert ledger.work.hand == pytest.approx(1)
    assert ledger.outside_impulse == (0, 0)
    closes(ledger)


def test_a_box_that_rests_takes_and_gives_no_energy() -> None:
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-5, 0), (5, 0)), friction=0.5)
    for i in range(3):
        world.add(Polygon.box(1, 1), position=(0, 0.5 + i), friction=0.5)
    world.run(120)
    start = world.ledger()
    world.run(120)
    change = world.ledger().since(start)
    assert abs(change.kinetic) < 1e-12
    assert abs(change.dissipated.total) < 1e-4
    # Second law: the floor's push less the weight is the change of momentum, 8e-8 N s of settling.
    assert change.impulses.walls.y - 3 * G * 2 == pytest.approx(change.momentum.y, abs=1e-12 * 60)
    assert abs(change.momentum.y) < 1e-6
    closes(world.ledger())


def test_the_books_are_saved_and_restored_with_the_world() -> None:
    world = World(gravity=(0, -G))
    world.add(Wall((-5, 0), (5, 0)))
    world.add(Circle(0.5), position=(0, 2), restitution=0.5)
    world.run(50)
    saved, kept = world.snapshot(), world.ledger()
    loaded = World.from_dict(world.to_dict())
    assert loaded.ledger() == kept
    world.run(30)
    loaded.run(30)
    assert loaded.ledger() == world.ledger()
    world.restore(saved)
    assert world.ledger() == kept
    world.body(2).velocity = (1, 1)
    world.restore(saved)
    assert world.ledger() == kept


def test_a_ledger_is_compared_with_ledgers_only() -> None:
    with pytest.raises(TypeError, match="only a Ledger can be compared with, not 3"):
        World().ledger().since(3)  # type: ignore[arg-type]


def test_a_belt_does_the_work_that_friction_takes_and_bodies_keep() -> None:
    """A box comes to the speed of a belt: half of the work of the belt is heat (m v^2 / 2)."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-5, 0), (20, 0)), friction=0.5, surface_speed=1.5)
    box = world.add(Polygon.box(1, 1), mass=2, position=(0, 0.5), friction=0.5)
    start = world.ledger()
    world.run(60)
    change = world.ledger().since(start)
    speed = abs(box.velocity.x)
    assert speed == pytest.approx(1.5, rel=1e-3)
    assert change.work.walls == pytest.approx(2 * 1.5**2, rel=1e-2)
    assert change.dissipated.friction == pytest.approx(2 * 1.5**2 / 2, rel=2e-2)
    closes(world.ledger())


def test_moving_platforms_and_rolling_resistance_are_booked() -> None:
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-5, 0), (20, 0)), friction=0.5)
    platform = Polygon.box(2, 0.2)
    world.add(
        platform, position=(3, 1), kind="kinematic", velocity=(0.5, 0.3), spin=0.2, friction=0.6,
        restitution=0.5,
    )  # fmt: skip
    ball = world.add(Circle(0.3), position=(3, 2), restitution=0.6, rolling_resistance=0.05)
    world.add(
        Circle(0.5), position=(-3, 0.5), velocity=(2, 0), friction=0.5, rolling_resistance=0.02
    )
    for _ in range(5):
        world.run(24)
        closes(world.ledger())
    assert world.ledger().work.walls > 0
    assert ball.y > 0


@pytest.mark.parametrize("integrator", INTEGRATORS)
def test_the_books_of_joined_bodies_close(integrator: str) -> None:
    """Chains with a motor, a spring and a rod, that swing, are struck, and lie down."""
    world = World(gravity=(0, -G), integrator=integrator)
    world.add(Wall((-9, -1.5), (9, -1.5)), friction=0.5, restitution=0.3)
    before = None
    for i in range(4):
        at = (0.05 + 0.5 * i, 0)
        link = world.add(Polygon.box(0.5, 0.2), position=(0.3 + 0.5 * i, 0), friction=0.4)
        motor = 2.0 if i == 2 else None
        world.join(before, link, Pin(at=at, motor_speed=motor, max_torque=1.0))
        before = link
    bob = world.add(Circle(0.3), position=(-2, 0))
    world.join(None, bob, Spring(20.0, damping=0.5, anchor_a=(-2, 2), anchor_b=(-2, 0.3)))
    world.add(Circle(0.3), position=(1, 3), velocity=(0.2, -3), restitution=0.8)
    for _ in range(4):
        world.run(30)
        closes(world.ledger())


def test_a_motor_does_torque_times_turn() -> None:
    world = World(integrator="velocity-verlet")
    wheel = world.add(Circle(0.5), mass=2)
    world.join(None, wheel, Pin(at=(0, 0), motor_speed=3.0, max_torque=0.1))
    world.run(120)
    assert world.ledger().work.joints == pytest.approx(wheel.kinetic_energy, rel=1e-9)
    assert world.ledger().work.joints == pytest.approx(0.1 * wheel.angle, rel=1e-6)


def test_bodies_that_fall_asleep_leave_the_books_closed() -> None:
    world = World(gravity=(0, -G), sleeping=True)
    world.add(Wall((-5, 0), (9, 0)), friction=0.5)
    for i in range(2):
        world.add(Polygon.box(1, 1), position=(2 * i, 0.6), velocity=(0.3 * i, 0), friction=0.5)
    world.add(Circle(0.3), position=(0, 20), restitution=0.5)
    world.run(150)
    closes(world.ledger())


def test_what_is_woken_within_a_tick_is_booked_no_force() -> None:
    """A ball that nobody expected, as another had struck it in the same tick, hit what slept: no
    force acted on that in this tick, but the books said that its weight had.
    """
    world = World(gravity=(0, -9.81), sleeping=True)
    world.add(Wall((-50, 0), (50, 0)), friction=0.5)
    box = world.add(Box(1, 1), mass=2.0, position=(0, 0.5), friction=0.5)
    world.run(120)
    assert box.is_asleep
    free = {"gravity_scale": 0.0, "restitution": 1.0}
    world.add(Circle(0.2), position=(-0.75, 0.5), **free)
    world.add(Circle(0.2), position=(-1.3, 0.5), velocity=(30, 0), **free)
    before = world.ledger()
    world.step()
    change = world.ledger().since(before)
    assert not box.is_asleep
    assert box.vx > 0.0
    assert abs(change.momentum_error.x) + abs(change.momentum_error.y) < 1e-10
    assert abs(change.angular_momentum_error) < 1e-10
    assert abs(change.energy_error) < 1e-9
    for _ in range(60):
        before = world.ledger()
        world.step()
        assert abs(world.ledger().since(before).momentum_error.y) < 1e-10
