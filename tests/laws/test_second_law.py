"""The change of motion is proportional to the force: closed forms of mechanics."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine import Circle, Force, LinearDrag, Polygon, QuadraticDrag, Torque, World

G = 9.81
INTEGRATORS = ("semi-implicit-euler", "velocity-verlet", "explicit-euler", "rk4")


def run(world: World, seconds: float, dt: float = 1 / 60) -> None:
    for _ in range(round(seconds / dt)):
        world.step(dt)


@pytest.mark.parametrize(
    ("integrator", "share"),
    [
        ("semi-implicit-euler", 0.5),
        ("explicit-euler", -0.5),
        ("velocity-verlet", 0.0),
        ("rk4", 0.0),
    ],
)
def test_constant_force(integrator: str, share: float) -> None:
    """x = a T^2 / 2, and the Euler methods err by exactly a T dt / 2 (thesis, eq. 16-17)."""
    world = World(integrator=integrator)
    body = world.add(Circle(0.5), mass=2.0)
    body.exert(Force(3.0, -1.0))
    run(world, 2.0)
    dt, a = 1 / 60, 1.5
    assert body.vx == pytest.approx(a * 2.0, rel=1e-12)
    assert body.x == pytest.approx(a * 2.0 + share * a * 2.0 * dt, rel=1e-12)
    assert body.y == pytest.approx(-(0.5 * 2.0 + share * 0.5 * 2.0 * dt), rel=1e-12)
    assert body.force == (3.0, -1.0)


@given(
    dt=st.floats(1e-3, 0.1),
    duration=st.floats(1e-4, 3.0),
    integrator=st.sampled_from(INTEGRATORS),
)
@settings(max_examples=60, deadline=None)
def test_a_timed_force_delivers_exactly_force_times_duration(
    dt: float, duration: float, integrator: str
) -> None:
    world = World(integrator=integrator)
    body = world.add(Polygon.box(1, 1), mass=2.5)
    push = body.exert(Force(7.0, -3.0), duration=duration)
    turn = body.exert(Torque(0.3), duration=duration)
    while push.active or turn.active:
        world.step(dt)
    assert body.momentum.x == pytest.approx(7.0 * duration, rel=1e-12)
    assert body.momentum.y == pytest.approx(-3.0 * duration, rel=1e-12)
    assert body.inertia * body.spin == pytest.approx(0.3 * duration, rel=1e-12)


@given(dt=st.floats(1e-3, 0.1), duration=st.floats(1e-3, 1.0))
@settings(max_examples=40, deadline=None)
def test_velocity_verlet_is_exact_over_the_partial_last_tick(dt: float, duration: float) -> None:
    """x = F/m tau (T - tau / 2) at the time T after a force that lasted tau."""
    world = World(integrator="velocity-verlet")
    body = world.add(Circle(0.5), mass=2.0)
    push = body.exert(Force(4.0, 0.0), duration=duration)
    while push.active:
        world.step(dt)
    world.step(dt)
    assert body.x == pytest.approx(2.0 * duration * (world.time - duration / 2), rel=1e-11)


def test_a_push_that_changes_delivers_the_sum_of_what_it_was() -> None:
    """p = sum of F dt, L = sum of r x F dt + M dt; half a tick is left for the last force."""
    world, dt = World(), 1 / 60
    body = world.add(Circle(0.5), mass=2.0, inertia=0.5)
    push = body.exert(Force(1.0, 0.0), duration=2.5 * dt, at=(0.0, 0.5))
    world.step(dt)
    push.change(Torque(3.0))
    world.step(dt)
    push.change(Force(-4.0, 2.0))
    assert body.momentum == pytest.approx((dt, 0.0), rel=1e-12)
    assert 0.5 * body.spin == pytest.approx((3.0 - 0.5) * dt, rel=1e-12)
    world.step(dt)
    assert body.momentum == pytest.approx(((1.0 - 4.0 / 2) * dt, 2.0 / 2 * dt), rel=1e-12)
    assert not push.active


@pytest.mark.parametrize("ticks", [1, 2, 3])
def test_a_force_of_a_few_ticks_acts_for_just_these(ticks: int) -> None:
    """The thesis sums timed forces before it tests their expiry: 1/60 s then acts for two ticks."""
    world = World()
    body = world.add(Circle(1), mass=1.0)
    push = body.exert(Force(60.0, 0.0), duration=ticks / 60)
    for done in range(ticks):
        assert push.active
        world.step()
        assert body.vx == pytest.approx(done + 1)
    assert not push.active
    world.step()
    assert body.vx == pytest.approx(ticks)
    assert body.force == (0.0, 0.0)


def test_a_point_of_attack_turns_with_the_body() -> None:
    world = World(integrator="velocity-verlet")
    body = world.add(Polygon.box(2, 2), mass=1.0, position=(1, 1), angle=0.3)
    body.exert(Force(0.0, 2.0), at=(2.0, 1.0))
    world.step()
    assert body.torque == pytest.approx(2.0)
    assert body.spin == pytest.approx(2.0 / body.inertia / 60)
    body.angle += math.pi
    body.spin = 0.0
    world.step()
    assert body.torque == pytest.approx(-2.0, rel=1e-3)


def test_a_push_can_be_stopped() -> None:
    world = World()
    body = world.add(Circle(1))
    push = body.exert(Force(1, 0))
    world.step()
    push.stop()
    push.stop()
    speed = body.vx
    world.step()
    assert body.vx == speed > 0
    assert not push.active


@pytest.mark.parametrize("integrator", INTEGRATORS)
def test_projectile(integrator: str) -> None:
    """20 m/s at 45 degrees: apex 10.1937 m, range 40.7747 m."""
    world = World(gravity=(0, -G), integrator=integrator)
    v = 20 * math.sqrt(0.5)
    ball = world.add(Circle(0.1), velocity=(v, v))
    high = 0.0
    while ball.y > 0 or ball.vy > 0:
        before = ball.position
        world.step()
        high = max(high, ball.y)
    part = before.y / (before.y - ball.y)
    off = 0.25 if "euler" in integrator else 1e-3  # v dt / 2 of height, v dt of range
    assert high == pytest.approx(10.1937, abs=off)
    assert before.x + part * (ball.x - before.x) == pytest.approx(40.7747, abs=2 * off)


@pytest.mark.parametrize(("integrator", "error"), [("rk4", 1e-9), ("velocity-verlet", 1e-5)])
def test_linear_drag(integrator: str, error: float) -> None:
    """v = v0 exp(-k t / m)."""
    world = World(drag=LinearDrag(0.5), integrator=integrator)
    body = world.add(Circle(1), mass=2.0, velocity=(3, 4))
    run(world, 2.0)
    assert body.speed == pytest.approx(5 * math.exp(-0.5), rel=error)
    distance = math.dist(body.position, (0, 0))
    assert distance == pytest.approx(5 * 4 * (1 - math.exp(-0.5)), rel=10 * error)


@pytest.mark.parametrize("integrator", INTEGRATORS)
@pytest.mark.parametrize(
    ("drag", "speed"), [(LinearDrag(2.0), 3 * G / 2), (QuadraticDrag(2.0), math.sqrt(3 * G / 2))]
)
def test_terminal_speed(integrator: str, drag: LinearDrag | QuadraticDrag, speed: float) -> None:
    """m g / k, or the root of it."""
    world = World(gravity=(0, -G), drag=drag, integrator=integrator)
    body = world.add(Circle(1), mass=3.0)
    run(world, 40.0)
    assert body.speed == pytest.approx(speed, rel=1e-9)
    assert body.force.y == pytest.approx(0.0, abs=1e-6)


def test_torque_turns_by_the_moment_of_inertia() -> None:
    world = World(integrator="velocity-verlet")
    body = world.add(Polygon.regular(5, 2.0), mass=3.0)
    body.exert(Torque(2.0))
    run(world, 1.0)
    assert body.spin == pytest.approx(2.0 / body.inertia, rel=1e-12)
    assert body.angle == pytest.approx(1.0 / body.inertia, rel=1e-12)
