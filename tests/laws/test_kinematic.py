"""Bodies of infinite mass that move: pistons, platforms, paddles, and static ones of any shape."""

import math

import pytest

from engine import Circle, Particle, Polygon, Wall, World

G = 9.81


def run(world: World, seconds: float) -> int:
    return sum(len(world.step()) for _ in range(round(60 * seconds)))


@pytest.mark.parametrize("restitution", [1.0, 0.5, 0.0])
def test_a_ball_leaves_a_piston(restitution: float) -> None:
    """v' = u + e (u + v), away from a piston at speed u; elastic: 2u + v. It meets it in time."""
    u, v = 3.0, 5.0
    world = World()
    piston = world.add(
        Polygon.box(1, 4), kind="kinematic", velocity=(u, 0), restitution=restitution
    )
    ball = world.add(Circle(0.25), position=(4.75, 0.0), velocity=(-v, 0))
    (hit,) = [hit for _ in range(60) for hit in world.step()]
    assert hit.time == pytest.approx((4.75 - 0.25 - 0.5) / (u + v), abs=1e-12)
    assert hit.speed == pytest.approx(u + v, rel=1e-12)
    assert ball.vx == pytest.approx(u + restitution * (u + v), rel=1e-12)
    assert piston.velocity == (u, 0)
    assert piston.x == pytest.approx(u * world.time, rel=1e-12)


def test_a_ball_between_closing_pistons_gains_the_work_of_the_pistons() -> None:
    """Each elastic impact adds twice the piston's speed (Fermi's acceleration)."""
    world = World()
    for side in (-1.0, 1.0):
        world.add(
            Polygon.box(1, 1), kind="kinematic", position=(5.5 * side, 0),
            velocity=(-0.5 * side, 0), restitution=1.0,
        )  # fmt: skip
    ball = world.add(Circle(0.1), mass=2.0, velocity=(4.0, 0))
    hits = [hit for _ in range(480) for hit in world.step()]
    assert len(hits) > 4
    assert ball.speed == pytest.approx(4.0 + len(hits), rel=1e-9)


def test_a_moving_platform_carries_a_box_by_friction() -> None:
    """The box slides for v / (mu g) and lags behind by v^2 / (2 mu g); then it rides along."""
    v, mu = 2.0, 0.4
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    platform = world.add(
        Polygon.box(20, 1), kind="kinematic", position=(0, -0.5), velocity=(v, 0), friction=mu
    )
    box = world.add(Polygon.box(1, 1), position=(0, 0.5), friction=mu)
    run(world, 1.0)
    assert box.vx == pytest.approx(v, abs=1e-3)
    assert platform.x - box.x == pytest.approx(v * v / (2 * mu * G), rel=0.01)
    lag = platform.x - box.x
    run(world, 2.0)
    assert platform.x - box.x == pytest.approx(lag, abs=1e-3)
    assert platform.position == pytest.approx((3 * v, -0.5), rel=1e-12)


@pytest.mark.parametrize("pull", [0.5, 0.9, 1.1, 5.0])
@pytest.mark.parametrize("length", [4.0, 900.0])
def test_a_column_slips_on_a_platform_that_sets_off_and_does_not_fall(
    pull: float, length: float
) -> None:
    """Coulomb: it is carried at mu g at most; as mu < w/h, that does not tip it. This holds from
    the first tick on, however slow the platform is by its own measure.
    """
    mu, half = 0.2, 0.25
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    platform = world.add(
        Polygon.box(length, 0.1), kind="kinematic", position=(0, -0.05), friction=mu
    )
    column = world.add(Polygon.box(2 * half, 2.0), position=(0, 1.0), friction=mu)
    run(world, 0.25)
    for tick in range(1, 31):
        platform.velocity = (pull * mu * G * tick / 60, 0)
        world.step()
        carried = min(pull, 1.0) * mu * G * tick / 60
        assert column.vx == pytest.approx(carried, abs=0.04 * mu * G / 60)
        assert abs(column.angle) < 1e-3


def test_a_lift_carries_what_stands_on_it() -> None:
    world = World(gravity=(0, -G))
    lift = world.add(Polygon.box(4, 0.2), kind="kinematic", position=(0, -0.1), velocity=(0, 1.5))
    boxes = [world.add(Polygon.box(1, 1), position=(0, 0.5 + i), friction=0.5) for i in range(3)]
    run(world, 2.0)
    assert lift.y == pytest.approx(2.9, rel=1e-12)
    for i, box in enumerate(boxes):
        assert box.y == pytest.approx(3.5 + i, abs=5e-3)
        assert box.vy == pytest.approx(1.5, abs=5e-3)


def test_a_lift_that_sets_off_strikes_what_stands_on_it() -> None:
    """From rest to u at once: an impact, after which the box flies at (1 + e) u."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    lift = world.add(Polygon.box(4, 0.2), kind="kinematic", position=(0, -0.1), restitution=1.0)
    box = world.add(Polygon.box(1, 1), position=(0, 0.5))
    run(world, 0.5)
    lift.velocity = (0.0, 2.0)
    hits = world.step()
    assert [(hit.a, hit.b) for hit in hits] == [(lift, box)]
    assert hits[0].impulse.y == pytest.approx(4.0, rel=1e-2)
    assert box.vy == pytest.approx(4.0 - G / 60, rel=1e-2)


def test_a_slowly_changing_lift_does_not_strike() -> None:
    """0.5 m/s^2, set tick by tick: what stands on it keeps standing."""
    world = World(gravity=(0, -G))
    lift = world.add(Polygon.box(4, 0.2), kind="kinematic", position=(0, -0.1), restitution=1.0)
    box = world.add(Polygon.box(1, 1), position=(0, 0.5))
    for tick in range(120):
        lift.velocity = (0.0, 0.5 * tick / 60)
        assert tick == 0 or world.step() == []
    assert box.y - lift.y == pytest.approx(0.6, abs=2e-3)


def test_a_spinning_paddle_hits_at_its_own_instant() -> None:
    """A beam of half-length 2 and no width to speak of turns at 1 rad/s; a point at (1, 1) is met
    after pi / 4 and leaves square to the beam with (1 + e) omega r.
    """
    world = World()
    world.add(Polygon.box(4, 2e-6), kind="kinematic", spin=1.0, restitution=1.0)
    point = world.add(Particle(1e-6), position=(1, 1))
    (hit,) = [hit for _ in range(60) for hit in world.step()]
    assert hit.time == pytest.approx(math.pi / 4, abs=1e-5)
    out = 2.0 * math.sqrt(2.0)
    assert point.velocity == pytest.approx((-out * math.sqrt(0.5), out * math.sqrt(0.5)), rel=1e-5)


@pytest.mark.parametrize("restitution", [0.0, 0.5])
def test_a_whirling_bar_throws_out_a_disc_that_lies_on_it(restitution: float) -> None:
    """Its centre slides out as r = s cosh(w t) (r'' = w^2 r in the frame of the bar: Kleppner &
    Kolenkow, "An Introduction to Mechanics", example 2.12) and stays at its distance, though the
    bar turns by 0.11 rad in a part of a tick and drives into it: in a few blows, after which it
    rests on the bar; each of endless ones would cost an instant of its own.
    """
    world = World(integrator="velocity-verlet")
    spin, start, radius, half = 40.0, 0.3, 0.1, 0.05
    bar = world.add(Polygon.box(4, 2 * half), kind="kinematic", spin=spin, restitution=restitution)
    disc = world.add(
        Circle(radius), position=(start, half + radius), restitution=restitution,
        velocity=(-spin * (half + radius), spin * start),
    )  # fmt: skip
    hits = 0
    while world.time * spin < 1.8:
        hits += len(world.step())
        out = disc.x * math.cos(bar.angle) + disc.y * math.sin(bar.angle)
        above = disc.y * math.cos(bar.angle) - disc.x * math.sin(bar.angle) - half - radius
        assert out == pytest.approx(start * math.cosh(spin * world.time), rel=0.015)
        assert -0.03 * radius < above < 0.02 * radius
    assert hits < 40


def test_two_kinematic_bodies_and_walls_pass_through_each_other() -> None:
    world = World()
    a = world.add(Polygon.box(1, 1), kind="kinematic", velocity=(2, 0))
    world.add(Circle(1), kind="static", position=(3, 0))
    b = world.add(Circle(1), kind="kinematic", position=(6, 0), velocity=(-2, 0))
    assert run(world, 3.0) == 0
    assert a.position == pytest.approx((6, 0), rel=1e-12)
    assert b.position == pytest.approx((0, 0), abs=1e-12)


def test_neither_gravity_nor_drag_nor_a_blow_moves_them() -> None:
    world = World(gravity=(0, -G))
    kinematic = world.add(Polygon.box(1, 1), kind="kinematic", velocity=(1, 0), spin=2.0)
    static = world.add(Polygon.box(1, 1), kind="static", position=(0, -3), angle=0.5)
    for x in (0.2, 0.9):
        world.add(Circle(0.3), mass=1000.0, position=(x, 3), restitution=0.5)
    run(world, 3.0)
    assert kinematic.velocity == (1, 0)
    assert kinematic.position == pytest.approx((3, 0), abs=1e-12)
    assert kinematic.spin == 2.0
    assert (static.position, static.angle, static.velocity) == ((0, -3), 0.5, (0, 0))


@pytest.mark.parametrize("shape", [Circle(1.0), Particle(1.0), Polygon.box(2, 2)])
def test_a_static_body_of_any_shape_stops_what_comes(shape: Circle | Particle | Polygon) -> None:
    """A ball falls on its top, 1 m above its middle, and comes back to where it was dropped."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(shape, kind="static", restitution=1.0)
    ball = world.add(Circle(0.5), position=(0, 4.0))
    period = 2 * math.sqrt(2 * 2.5 / G)
    run(world, 10 * period)
    assert ball.x == pytest.approx(0.0, abs=1e-6)
    assert ball.vy**2 / 2 + G * ball.y == pytest.approx(G * 4.0, rel=1e-9)


@pytest.mark.parametrize("speed", [2e-5, 1e-4, 1e-3])
def test_what_is_pushed_slowly_keeps_up(speed: float) -> None:
    """Rigid bodies that touch move alike along their normal, however slowly: x = v t. Friction
    holds the box as soon as nothing pushes it, and held it for half of the time.
    """
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-20, 0), (20, 0)), friction=0.5)
    world.add(Polygon.box(1, 1), position=(-1, 0.6), kind="kinematic", velocity=(speed, 0))
    box = world.add(Polygon.box(1, 1), position=(0, 0.5), friction=0.5)
    run(world, 10)
    assert box.vx == pytest.approx(speed, rel=1e-6)
    assert box.x == pytest.approx(10 * speed, rel=0.05)
