"""The books of angular momentum: p x J of every cause, about the origin; they always close."""

import math
import random
from typing import Any

import pytest

from engine import (
    Body,
    Box,
    Capsule,
    Circle,
    Distance,
    Force,
    Joint,
    Ledger,
    LinearDrag,
    Particle,
    Pin,
    PointGravity,
    Polygon,
    Pulley,
    Rope,
    Slider,
    Spring,
    SpringTo,
    Torque,
    Wall,
    Weld,
    World,
)

INTEGRATORS = ["semi-implicit-euler", "velocity-verlet", "explicit-euler", "rk4"]
G = 9.81


def closes(world: World, gross: float = 1.0) -> Ledger:
    """Angular momentum is what the books say, to rounding of what went through them."""
    ledger = world.ledger()
    through = gross + sum(abs(each) for each in ledger.angular_impulses)
    assert abs(ledger.angular_momentum_error) <= 1e-12 * through
    return ledger


def others(ledger: Ledger, *names: str) -> float:
    """The largest entry but for some."""
    entries = ledger.angular_impulses._asdict().items()
    return max(abs(value) for name, value in entries if name not in names)


@pytest.mark.parametrize("integrator", ["velocity-verlet", "rk4"])
def test_gravity_and_a_push_give_a_thrown_ball_their_moments(integrator: str) -> None:
    """dL/dt = x m g_y and -y F_x, along x = x0 + u t + F t^2/2m, y = y0 + w t - g t^2/2."""
    mass, push, t = 2.0, 3.0, 1.5
    world = World(gravity=(0, -G), integrator=integrator)
    ball = world.add(Circle(0.1), mass=mass, position=(1, 2), velocity=(4, 5), spin=7)
    ball.exert(Force(push, 0), duration=9)
    start = world.ledger()
    world.run(90)
    change = closes(world).since(start)
    way = 1 * t + 4 * t**2 / 2 + push / mass * t**3 / 6
    high = 2 * t + 5 * t**2 / 2 - G * t**3 / 6
    assert change.angular_impulses.gravity == pytest.approx(-mass * G * way, rel=1e-12)
    assert change.angular_impulses.pushes == pytest.approx(-push * high, rel=1e-12)
    assert others(change, "gravity", "pushes") == 0
    assert change.outside_angular_impulse == pytest.approx(change.angular_momentum, rel=1e-12)


@pytest.mark.parametrize("integrator", INTEGRATORS)
def test_the_error_of_the_integrator_has_a_moment_too(integrator: str) -> None:
    """Both Euler methods fly with m a dt/2 more, or less, from where a flight begins to its end."""
    world = World(gravity=(0, -G), integrator=integrator)
    ball = world.add(Circle(0.1), mass=2, position=(3, 50), velocity=(1, 0))
    world.run(60)
    ledger = closes(world)
    lead = {"semi-implicit-euler": 1 / 120, "explicit-euler": -1 / 120}.get(integrator, 0.0)
    assert ball.x == pytest.approx(4, rel=1e-12)
    expected = -2 * G * lead * (3 - 4)
    assert ledger.angular_impulses.integrator == pytest.approx(expected, abs=1e-10)


def test_a_central_field_gives_a_satellite_no_angular_impulse_about_its_centre() -> None:
    """x x F = c x F for a field about c (Kepler's second law): none about the origin for c = 0."""
    for centre in ((0.0, 0.0), (30.0, -20.0)):
        world = World(integrator="velocity-verlet")
        world.add_law(PointGravity(centre, 8 * math.pi**2))
        at = (centre[0] + 2, centre[1])
        world.add(Circle(0.1), mass=3, position=at, velocity=(0, 1.2 * math.pi))
        start = world.ledger()
        world.run(240)
        change = closes(world).since(start)
        x, y = change.momentum
        given = centre[0] * y - centre[1] * x
        both = change.angular_impulses.laws + change.angular_impulses.integrator
        assert both == pytest.approx(given, abs=1e-11)
        assert change.angular_momentum == pytest.approx(given, abs=1e-11)


@pytest.mark.parametrize("spin", [-30.0, 0.0, 12.0])
def test_a_wall_gives_the_moment_of_its_impulse_where_it_gives_it(spin: float) -> None:
    """p x J, friction included; what reaches the disc is its spin and its flight."""
    world = World()
    world.add(Wall((6, -9), (6, 9)), restitution=0.7, friction=0.3)
    disc = world.add(
        Circle(0.5), mass=2, position=(3, 1), velocity=(4, 2), spin=spin, restitution=0.7,
        friction=0.3,
    )  # fmt: skip
    start = world.ledger()
    (hit,) = world.run(60, collisions=True).collisions
    change = closes(world).since(start)
    impulse = -hit.impulse if hit.b is not disc else hit.impulse
    moment = hit.point.x * impulse.y - hit.point.y * impulse.x
    assert change.angular_impulses.walls == pytest.approx(moment, abs=1e-12)
    assert change.angular_momentum == pytest.approx(moment, abs=1e-12)
    assert others(change, "walls") == 0


def test_about_a_point_of_the_floor_friction_turns_nothing() -> None:
    """What slides and comes to roll keeps its angular momentum about the floor: v = 2/3 v0."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-5, 0), (60, 0)), friction=0.3)
    disc = world.add(Circle(0.5), mass=2, position=(3, 0.5), velocity=(6, 0), friction=0.3)
    start = world.ledger()
    world.run(180)
    change = closes(world).since(start)
    assert disc.vx == pytest.approx(4, rel=1e-3)
    assert abs(change.angular_momentum) < 2e-4  # it sinks in by 25 micrometres
    assert change.angular_impulses.walls == pytest.approx(-change.angular_impulses.gravity)


@pytest.mark.parametrize("spec", ["pin", "rod", "weld and pin"])
def test_the_pivot_of_a_pendulum_gives_the_moment_of_its_force(spec: str) -> None:
    """All of its impulse acts at the pivot: p x J (Newton, Euler)."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    bob = world.add(Box(0.4, 0.2), mass=2, position=(4.5, 2))
    if spec == "weld and pin":
        other = world.add(Circle(0.2), position=(5, 2))
        world.join(bob, other, Weld(at=(4.8, 2)))
    world.join(None, bob, Distance(anchor_a=(3, 2)) if spec == "rod" else Pin(at=(3, 2)))
    start = world.ledger()
    world.run(120)
    change = closes(world).since(start)
    pull = change.impulses.joints
    assert change.angular_impulses.joints == pytest.approx(3 * pull.y - 2 * pull.x, abs=1e-9)
    assert others(change, "joints", "gravity") == 0


def test_a_motor_gives_the_spin_that_it_drives() -> None:
    """I w, wherever the wheel stands."""
    world = World()
    wheel = world.add(Circle(0.5), mass=2, position=(7, -3))
    world.join(None, wheel, Pin(at=(7, -3), motor_speed=3.0, max_torque=0.1))
    world.run(60)
    ledger = closes(world)
    assert ledger.angular_impulses.joints == pytest.approx(0.1 * 1.0, rel=1e-9)
    assert ledger.angular_impulses.joints == pytest.approx(wheel.inertia * wheel.spin, rel=1e-12)


def test_what_would_turn_a_particle_is_lost() -> None:
    """Friction mu m g acts at its rim, radius r: mu m g r t does not turn it; a push may, too."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-5, 0), (60, 0)), friction=0.2)
    particle = world.add(Particle(0.3), mass=2, position=(1, 0.3), velocity=(9, 0), friction=0.2)
    start = world.ledger()
    world.run(60)
    change = closes(world).since(start)
    # Clockwise, as friction acts at the bottom, against the motion to the right.
    assert change.angular_impulses.particles == pytest.approx(0.2 * 2 * G * 0.3 * 1.0, rel=1e-4)
    particle.exert(Force(0, 1), duration=0.5, at=(particle.x + 0.2, particle.y))
    before = world.ledger()
    world.run(60)
    assert world.ledger().since(before).angular_impulses.pushes > 0
    closes(world)


def test_setting_and_moving_bodies_is_booked_to_the_hand() -> None:
    world = World()
    body = world.add(Circle(0.5), mass=2, position=(1, 0), velocity=(0, 3))
    assert world.ledger().angular_impulses.hand == pytest.approx(6)
    world.step()
    body.position = (5, 1)
    body.spin = 4
    ledger = closes(world)
    assert ledger.angular_impulses.hand == pytest.approx(2 * 5 * 3 + 0.25 * 4)
    assert ledger.outside_angular_impulse == 0
    world.remove(body)
    assert world.ledger().angular_impulses.total == pytest.approx(0, abs=1e-12)


def test_what_is_pushed_apart_is_a_correction() -> None:
    """Discs that are moved apart, or out of a wall, slide on along other lines."""
    world = World(gravity=(0, -G))
    world.add(Wall((-5, 0), (9, 0)), friction=0.4)
    for i in range(5):
        world.add(Circle(0.4), position=(2 + 0.02 * i, 0.2), velocity=(i, 0), friction=0.4)
    world.run(60)
    assert abs(closes(world).angular_impulses.corrections) > 1e-6


@pytest.mark.parametrize("spec", [Pin, Weld])
def test_a_torn_hinge_is_a_correction(spec: Any) -> None:
    """It pulls at both anchors, which are apart."""
    world = World()
    bodies = [world.add(Box(1, 0.3), position=(3 + i, 0), spin=0.1 * i) for i in range(3)]
    for i in range(2):
        world.join(bodies[i], bodies[i + 1], spec(at=(3.5 + i, 0)))
    world.run(10)
    assert abs(world.ledger().angular_impulses.corrections) < 1e-12
    bodies[2].position = (5, 2)
    for _ in range(60):
        world.step()
    assert abs(closes(world).angular_impulses.corrections) > 1e-6


def joined(world: World, a: Body | None, b: Body, kind: int, at: tuple[float, float]) -> Joint:
    """Join two bodies, or a body to the world, by one of all kinds of joints."""
    specs: list[Any] = [
        Pin(at=at), Pin(at=at, limits=(-0.5, 0.5)), Pin(at=at, motor_speed=2, max_torque=0.5),
        Weld(at=at), Rope(anchor_a=at), Distance(anchor_a=at), Slider(axis=(1, 0.3), at=at),
        Spring(30.0, damping=0.3, anchor_a=at, length=0.5),
    ]  # fmt: skip
    return world.join(a, b, specs[kind % len(specs)], collide=kind % 3 == 0)


def test_isolated_bodies_give_each_other_no_angular_momentum() -> None:
    """Struck, joined in every way, or lying on each other: every entry but the hand's is zero."""
    for seed in range(1, 5):
        dice = random.Random(seed)
        world = World()
        shapes = (Circle(0.3), Box(0.6, 0.4), Capsule(0.4, 0.2), Polygon.regular(5, 0.35))
        bodies = [
            world.add(
                shapes[i % 4], mass=dice.uniform(0.5, 3), restitution=0.4, friction=0.5,
                position=(3 + 0.75 * (i % 4), 3 + 0.75 * (i // 4)), spin=dice.uniform(-3, 3),
                velocity=(1.5 - i % 4 + dice.uniform(-1, 1), 1.5 - i // 4 + dice.uniform(-1, 1)),
            )
            for i in range(16)
        ]  # fmt: skip
        for i in range(seed):
            a, b = dice.sample(bodies, 2)
            at = ((a.x + b.x) / 2, (a.y + b.y) / 2)
            joined(world, a, b, seed + i, at)
        size = sum(abs(body.angular_momentum) for body in bodies)
        world.run(90)
        assert others(closes(world, size), "hand") < 1e-12 * size


@pytest.mark.parametrize("seed", range(8))
def test_the_books_of_any_world_close(seed: int) -> None:
    """Walls, belts and platforms, joints of all kinds, fields, drag, pushes, sleep, and hands."""
    dice = random.Random(seed)
    drag = dice.choice([None, LinearDrag(0.3)])
    world = World(
        gravity=(0.3, -G), drag=drag, integrator=INTEGRATORS[seed % 4], sleeping=dice.random() < 0.3
    )
    corners = [(0, 0), (7, 0.3), (7, 9), (0, 9)]
    for i in range(4):
        belt = dice.choice([0.0, 0.0, 1.5])
        wall = Wall(corners[i], corners[(i + 1) % 4])
        world.add(wall, restitution=0.3, friction=dice.random(), surface_speed=belt)
    world.add(Box(1, 0.3), kind="kinematic", position=(3, 2), velocity=(0.2, 0.1), spin=0.5)
    if dice.random() < 0.5:
        world.add_law(PointGravity((2, 2), 3.0, softening=0.5))
        world.add_law(SpringTo((1, 1), 2.0, damping=0.1))
    shapes = (
        Circle(0.3),
        Particle(0.25),
        Box(0.6, 0.4),
        Polygon.regular(5, 0.35),
        Capsule(0.4, 0.2),
    )
    bodies = [
        world.add(
            dice.choice(shapes), mass=dice.uniform(0.3, 4), restitution=dice.choice([0, 0, 0.6]),
            position=(0.8 + 0.9 * (i % 6), 0.8 + 0.9 * (i // 6)), friction=dice.random(),
            velocity=(dice.uniform(-3, 3), dice.uniform(-3, 3)), rolling_resistance=0.01,
        )
        for i in range(14)
    ]  # fmt: skip
    for _ in range(dice.randrange(6)):
        a, b = dice.sample(bodies, 2)
        joined(world, dice.choice([None, a]), b, dice.randrange(8), (b.x + 0.3, b.y + 0.2))
    if dice.random() < 0.3:
        world.join(bodies[0], bodies[1], Pulley(over_a=(2, 8), over_b=(4, 8)))
    gross, last = 1.0, world.ledger()
    for tick in range(100):
        if tick % 29 == 1:
            bodies[tick % 5].exert(Force(3, 2), duration=0.11, at=bodies[tick % 5].position)
            bodies[6 + tick % 7].exert(Torque(0.5), duration=0.2)
        elif tick == 70:
            bodies[3].velocity, bodies[2].mass, bodies[4].position = (1, 1), 3, (6, 6)
            world.remove(bodies[5])
        world.step()
        if tick % 10 == 9:
            ledger = world.ledger()
            gross += sum(abs(each) for each in ledger.since(last).angular_impulses)
            closes(world, 10 * gross)
            last = ledger


def test_discs_that_roll_on_each_other_give_each_other_nothing() -> None:
    """Loads that are relied on from tick to tick act where the bodies are, not where they were."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-50, 0), (50, 0)), friction=0.9)
    plank = world.add(Box(6, 0.2), mass=1, position=(0, 0.9), friction=0.9)
    for x in (-1.5, 1.5):
        world.add(Circle(0.4), mass=3, position=(x, 0.4), friction=0.9)
    for body in world:
        if body.is_dynamic:
            body.velocity = (0.2 if body is plank else 0.1, 0)
            body.spin = 0 if body is plank else -0.25
    world.run(240)
    closes(world)


def test_the_books_of_angular_momentum_are_saved_and_restored() -> None:
    world = World(gravity=(0, -G))
    world.add(Wall((-5, 0), (5, 0)))
    world.add(Circle(0.5), position=(1, 2), velocity=(1, 0), restitution=0.5)
    world.run(50)
    data, kept = world.to_dict(), world.ledger()
    assert World.from_dict(data).ledger() == kept
    for name in list(data["tables"]["books"]):
        if name.endswith("_turn"):
            del data["tables"]["books"][name]
    older = World.from_dict(data)
    begun = older.ledger()
    assert begun.angular_momentum == kept.angular_momentum == begun.angular_impulses.hand
    assert others(begun, "hand") == 0
    assert begun.impulses == kept.impulses
    assert "hand_turn" not in data["tables"]["books"]
    for each in (world, older):
        each.run(60)
    assert older.digest() == world.digest()
    closes(older)
