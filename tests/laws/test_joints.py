"""Joints against closed forms of the textbooks (Goldstein, "Classical Mechanics"; French,
"Vibrations and Waves"), most of them at 60 ticks a second.
"""

import math
from collections.abc import Callable

import pytest

from engine import (
    Body,
    Circle,
    Distance,
    Particle,
    Pin,
    Polygon,
    Pulley,
    Rope,
    Slider,
    Spring,
    Torque,
    Weld,
    World,
)

G = 9.81


def falling() -> World:
    return World(gravity=(0, -G))


def energy(world: World) -> float:
    return world.kinetic_energy + world.potential_energy


def swings(world: World, value: Callable[[], tuple[float, float]], seconds: float) -> list[float]:
    """Times at which a value, given with its rate, passes zero upwards."""
    times = []
    before = value()[0]
    for _ in range(round(seconds * 60)):
        world.step()
        now, rate = value()
        if before < 0 <= now:
            times.append(world.time - now / rate)
        before = now
    return times


def pendulum_period(length: float, amplitude: float) -> float:
    """2 pi sqrt(L/g) / agm(1, cos(amplitude / 2)): Gauss, 1799."""
    a, b = 1.0, math.cos(amplitude / 2)
    for _ in range(10):
        a, b = (a + b) / 2, math.sqrt(a * b)
    return 2 * math.pi * math.sqrt(length / G) / a


@pytest.mark.parametrize("amplitude", [0.01, 0.5, 1.5, 2.8])
def test_the_period_of_a_pendulum(amplitude: float) -> None:
    world = falling()
    x, y = 0.8 * math.sin(amplitude), -0.8 * math.cos(amplitude)
    bob = world.add(Particle(0.05), position=(x, y))
    world.join(None, bob, Distance(anchor_a=(0, 0)))
    period = pendulum_period(0.8, amplitude)
    times = swings(world, lambda: (bob.x, bob.vx), 3.9 * period)
    assert (times[-1] - times[0]) / (len(times) - 1) == pytest.approx(period, rel=1e-4)


def test_a_rod_swings_about_its_end() -> None:
    """I = m L^2/3, so that T = 2 pi sqrt(2 L/(3 g)) for small swings."""
    world = falling()
    length, small = 1.2, 0.01
    at = (length / 2 * math.sin(small), -length / 2 * math.cos(small))
    rod = world.add(Polygon.box(length, 1e-3), mass=2, position=at, angle=small - math.pi / 2)
    world.join(None, rod, Pin(at=(0, 0)))
    times = swings(world, lambda: (rod.x, rod.vx), 6.5)
    period = 2 * math.pi * math.sqrt(2 * length / (3 * G))
    assert (times[-1] - times[0]) / (len(times) - 1) == pytest.approx(period, rel=1e-4)


def test_a_pendulum_keeps_its_energy_for_a_minute() -> None:
    world = falling()
    bob = world.add(Particle(0.05), mass=3, position=(1, 0))
    world.join(None, bob, Distance(anchor_a=(0, 0)))
    start, scale = energy(world), 3 * G
    worst = 0.0
    late = []
    for tick in range(3600):
        world.step()
        worst = max(worst, abs(energy(world) - start) / scale)
        if tick >= 3000:
            late.append((energy(world) - start) / scale)
    assert worst < 1e-4
    assert abs(sum(late) / len(late)) < 2e-5
    assert math.hypot(bob.x, bob.y) == pytest.approx(1, abs=1e-9)


def test_atwood() -> None:
    """a = (4 - 2) g/(4 + 2) and T = 2 * 2 * 4 g/(4 + 2)."""
    world = falling()
    light = world.add(Particle(0.1), mass=2, position=(-1, 0))
    heavy = world.add(Particle(0.1), mass=4, position=(1, 0))
    string = world.join(light, heavy, Pulley(over_a=(-1, 5), over_b=(1, 5)))
    for _ in range(30):
        world.step()
        assert string.force == pytest.approx((0, 26.16), abs=1e-9)
    assert light.vy == pytest.approx(3.27 * 0.5, rel=1e-12)
    assert heavy.y == pytest.approx(-3.27 * 0.5**2 / 2, rel=1e-9)


def test_a_block_and_tackle_halves_the_force() -> None:
    """Two strings carry 4 kg: 2 kg at the other end balances it, and moves twice as far."""
    world = falling()
    load = world.add(Particle(0.1), mass=4, position=(0, 0), velocity=(0, 0.1))
    hand = world.add(Particle(0.1), mass=2, position=(3, 0), velocity=(0, -0.2))
    string = world.join(hand, load, Pulley(over_a=(3, 5), over_b=(0, 5), ratio=2))
    for _ in range(60):
        world.step()
    assert string.force == pytest.approx((0, 4 * G), rel=1e-9)
    assert (load.y, hand.y) == pytest.approx((0.1, -0.2), abs=1e-9)


def test_a_slack_string_pulls_nothing() -> None:
    world = World()
    a = world.add(Particle(0.1), position=(0, 0), velocity=(0, 1))
    b = world.add(Particle(0.1), position=(3, 0))
    string = world.join(a, b, Pulley(over_a=(0, 5), over_b=(3, 5)))
    world.step()
    assert string.force == (0, 0)
    assert (a.vy, b.vy) == (1, 0)


@pytest.mark.parametrize("damping", [0.0, 1.0, 5.0, 39.0, 90.0])
def test_a_damped_spring_follows_its_exact_solution(damping: float) -> None:
    """y'' + 2 c y' + w^2 y = 0 about the place where it hangs at rest: any damping, any tick."""
    world = falling()
    mass, stiffness = 2.0, 200.0
    bob = world.add(Particle(0.1), mass=mass, position=(0, -1.1))
    world.join(None, bob, Spring(stiffness, damping, anchor_a=(0, 0), length=1.0))
    rest = -1 - mass * G / stiffness
    start, c, w2 = -1.1 - rest, damping / (2 * mass), stiffness / mass
    for _ in range(180):
        world.step()
        t = world.time
        if c * c < w2:
            w = math.sqrt(w2 - c * c)
            y = start * math.exp(-c * t) * (math.cos(w * t) + c / w * math.sin(w * t))
        else:
            s = math.sqrt(c * c - w2)
            p, q = -c + s, -c - s
            y = start * (p * math.exp(q * t) - q * math.exp(p * t)) / (p - q)
        assert bob.y - rest == pytest.approx(y, abs=1e-6)


def test_coupled_oscillators() -> None:
    """Two masses between three springs: in step with sqrt(k/m), against each other sqrt(3k/m)."""
    for sign, factor in ((1, 1), (-1, 3)):
        world = World()
        a = world.add(Particle(0.1), mass=2, position=(1.05, 0))
        b = world.add(Particle(0.1), mass=2, position=(2 + 0.05 * sign, 0))
        for joined in (
            (None, a, {"anchor_a": (0, 0)}),
            (a, b, {}),
            (b, None, {"anchor_b": (3, 0)}),
        ):
            world.join(joined[0], joined[1], Spring(50, length=1.0, **joined[2]))
        period = 2 * math.pi * math.sqrt(2 / (50 * factor))
        times = swings(world, lambda a=a: (a.x - 1, a.vx), 8.5 * period)
        assert (times[-1] - times[0]) / (len(times) - 1) == pytest.approx(period, rel=1e-4)


def test_a_free_spring_keeps_its_centre_and_its_period() -> None:
    """T = 2 pi sqrt(mu/k) with the reduced mass mu."""
    world = World()
    a = world.add(Particle(0.1), mass=1, position=(-1.1, 0))
    b = world.add(Particle(0.1), mass=3, position=(1.1, 0))
    world.join(a, b, Spring(30, length=2.0))
    times = swings(world, lambda: (b.x - a.x - 2, b.vx - a.vx), 8)
    period = 2 * math.pi * math.sqrt(0.75 / 30)
    assert (times[-1] - times[0]) / (len(times) - 1) == pytest.approx(period, rel=1e-6)
    assert world.momentum == pytest.approx((0, 0), abs=1e-13)


def test_a_stiff_spring_is_stable() -> None:
    world = falling()
    bob = world.add(Particle(0.1), mass=1e-3, position=(1, 0))
    world.join(None, bob, Spring(1e9, 1.0, anchor_a=(0, 0)))
    for _ in range(120):
        world.step()
        assert math.hypot(bob.x, bob.y) == pytest.approx(1, abs=1e-3)


def test_what_hangs_pulls_with_its_weight() -> None:
    for spec in (
        Distance(anchor_a=(0, 1)),
        Rope(anchor_a=(0, 1)),
        Pin(at=(0, 1)),
        Weld(at=(0, 1)),
        Slider(axis=(1, 0), at=(0, 1)),
    ):
        world = falling()
        bob = world.add(Circle(0.2), mass=3, position=(0, 0))
        joint = world.join(None, bob, spec)
        for _ in range(30):
            world.step()
            assert joint.force == pytest.approx((0, 3 * G), abs=1e-9)
        assert bob.position == pytest.approx((0, 0), abs=1e-12)


def test_a_weld_carries_the_moment_of_a_beam() -> None:
    world = falling()
    beam = world.add(Polygon.box(2, 0.1), mass=5, position=(1, 0))
    joint = world.join(None, beam, Weld(at=(0, 0)))
    for _ in range(30):
        world.step()
    assert joint.force == pytest.approx((0, 5 * G), abs=1e-9)
    assert joint.torque == pytest.approx(5 * G * 1, abs=1e-9)
    assert beam.angle == pytest.approx(0, abs=1e-12)


def test_what_circles_is_pulled_by_m_v2_over_r() -> None:
    """On the mean over a tick, a chord's share: sin(w dt/2) / (w dt/2)."""
    world = World()
    ball = world.add(Particle(0.1), mass=2, position=(1.5, 0), velocity=(0, 3))
    rope = world.join(None, ball, Rope(anchor_a=(0, 0)))
    half = 3 / 1.5 / 120
    for _ in range(120):
        world.step()
        expected = 2 * 3**2 / 1.5 * math.sin(half) / half
        assert math.hypot(*rope.force) == pytest.approx(expected, rel=1e-5)
    assert ball.speed == pytest.approx(3, rel=1e-9)


def test_welded_bodies_move_as_one() -> None:
    """Two boxes of 1 m turn about their common centre as a box of 2 m: I = m (w^2 + h^2)/12."""
    world = World()
    a = world.add(Polygon.box(1, 1), mass=1, position=(-0.5, 0))
    b = world.add(Polygon.box(1, 1), mass=1, position=(0.5, 0))
    world.join(a, b, Weld())
    a.apply_impulse((0, -1), at=(-1, 0))
    world.step()
    spin = 1 * 1 / (2 * (4 + 1) / 12)
    for _ in range(60):
        assert (a.spin, b.spin) == pytest.approx((spin, spin), rel=1e-9)
        assert math.dist(a.position, b.position) == pytest.approx(1, abs=1e-9)
        world.step()
    assert b.angle == pytest.approx(spin * world.time, rel=1e-2)
    assert b.angle - a.angle == pytest.approx(0, abs=1e-9)


def test_a_motor_turns_with_its_torque_up_to_its_speed() -> None:
    world = World()
    wheel = world.add(Circle(1), mass=2)
    pin = world.join(None, wheel, Pin(at=(0, 0), motor_speed=3, max_torque=2))
    for _ in range(60):  # angular acceleration 2/(m r^2/2)
        world.step()
        assert wheel.spin == pytest.approx(2 * world.time, rel=1e-9)
        assert wheel.angle == pytest.approx(world.time**2, rel=1e-9)
        assert pin.torque == pytest.approx(2, rel=1e-9)
    for _ in range(60):
        world.step()
    assert wheel.spin == pytest.approx(3, rel=1e-12)
    assert pin.torque == pytest.approx(0, abs=1e-9)
    pin.motor_speed = None
    wheel.exert(Torque(-1))
    world.step()
    assert wheel.spin == pytest.approx(3 - 1 / 60, rel=1e-9)


def test_limits_stop_a_pin() -> None:
    """A beam falls on its limit and stays; the limit carries the moment of its weight."""
    world = falling()
    beam = world.add(Polygon.box(1, 0.2), mass=3, position=(0.5, 0))
    pin = world.join(None, beam, Pin(at=(0, 0), limits=(-0.5, 0.5)))
    for _ in range(120):
        world.step()
        assert pin.coordinate > -0.5 - 1e-8
    assert pin.coordinate == pytest.approx(-0.5, abs=1e-8)
    assert pin.torque == pytest.approx(3 * G * 0.5 * math.cos(0.5), rel=1e-9)
    assert beam.spin == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("degrees", [0, 30, 75])
def test_a_slider_on_an_incline(degrees: float) -> None:
    """a = g sin(slope) along the rail, m g cos(slope) across it."""
    world = falling()
    slope = math.radians(degrees)
    axis = (math.cos(slope), math.sin(slope))
    cart = world.add(Polygon.box(1, 0.5), mass=2, angle=0.3)
    rail = world.join(None, cart, Slider(axis=axis, limits=(-2, 2)))
    for _ in range(36):
        world.step()
        assert rail.coordinate == pytest.approx(-G * math.sin(slope) * world.time**2 / 2, abs=1e-9)
        assert math.hypot(*rail.force) == pytest.approx(2 * G * math.cos(slope), rel=1e-9)
    assert cart.angle == pytest.approx(0.3, abs=1e-12)
    for _ in range(120):
        world.step()
        assert rail.coordinate > -2 - 1e-8
    if degrees:
        assert rail.coordinate == pytest.approx(-2, abs=1e-8)


def test_a_slider_with_a_motor_is_a_lift() -> None:
    world = falling()
    cage = world.add(Polygon.box(1, 1), mass=10)
    rail = world.join(None, cage, Slider(axis=(0, 1), motor_speed=1.5, max_force=200))
    for _ in range(120):
        world.step()
        assert rail.force.y <= 200 + 1e-9
    assert cage.vy == pytest.approx(1.5, rel=1e-12)
    assert rail.force == pytest.approx((0, 10 * G), abs=1e-9)
    rise = 1.5 / (200 / 10 - G)
    assert cage.y == pytest.approx(1.5 * (2 - rise) + 1.5 * rise / 2, abs=1e-3)


def test_a_rope_is_slack_then_taut() -> None:
    """Free fall down to its end; there it stops, and hangs."""
    world = falling()
    bob = world.add(Particle(0.1), mass=2)
    rope = world.join(None, bob, Rope(anchor_a=(0, 0.5), length=1))
    while world.time < 0.3:
        world.step()
        assert rope.force == (0, 0)
        assert bob.vy == pytest.approx(-G * world.time, rel=1e-12)
    lost = 0.0
    while world.time < 1:
        before = bob.vy
        world.step()
        lost += 2 * (bob.vy - before) - (rope.force.y - 2 * G) / 60
    assert lost == pytest.approx(0, abs=1e-9)  # the reported impulse is the change of momentum
    assert bob.position == pytest.approx((0, -0.5), abs=1e-9)
    assert rope.force == pytest.approx((0, 2 * G), abs=1e-9)


def test_a_joint_breaks_at_its_load() -> None:
    """A force that grows by 60 N/s breaks what bears 30 N after 0.5 s."""
    world = World()
    broken = []
    bob = world.add(Particle(0.1))
    rod = world.join(bob, None, Distance(anchor_b=(1, 0)), break_force=30.5, on_break=broken.append)
    for tick in range(60):
        bob.apply_impulse((-tick / 60, 0))
        world.step()
        if tick <= 30:
            assert rod.force.x == pytest.approx(-tick, abs=1e-6)
        assert rod.broken == (tick >= 31)
    assert broken == [rod]
    assert bob.vx == pytest.approx(-sum(range(32, 60)) / 60)


def chain(world: World, links: int, start: tuple[float, float] | None) -> list[Body]:
    """Rods of 0.5 m, pinned end to end along the x axis."""
    rods: list[Body] = []
    for i in range(links):
        rods.append(world.add(Polygon.box(0.5, 0.1), mass=0.5, position=(0.5 * i + 0.25, 0)))
        if i or start is not None:
            world.join(rods[i - 1] if i else None, rods[i], Pin(at=(0.5 * i, 0)))
    return rods


def test_a_chain_keeps_momentum_and_angular_momentum_for_ten_thousand_steps() -> None:
    world = World(substeps=1)
    rods = chain(world, 2, None)
    rods[0].apply_impulse((0.3, 1), at=rods[0].position)
    rods[1].spin = 2.0
    momentum, turning = world.momentum, world.angular_momentum
    for _ in range(10_000):
        world.step()
    size = sum(rod.mass * rod.speed for rod in rods)
    assert world.momentum == pytest.approx(momentum, abs=1e-12 * size)
    far = max(abs(rod.x) + abs(rod.y) for rod in rods)
    assert world.angular_momentum == pytest.approx(turning, abs=1e-12 * size * far)
