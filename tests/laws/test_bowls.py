"""Bowls, half-pipes and slides made of links, which stand for the curves that they were drawn for.

What slides or rolls in a smooth bowl is a pendulum of the length R - r (with a moment of inertia if
it rolls): Landau and Lifshitz, "Mechanics", 1976, par. 11; period T = 2 pi sqrt(k L/g)/agm(1,
cos(a/2)). Friction on a curve brakes as on a capstan: v = v_0 exp(-mu phi).
"""

import math
from collections.abc import Callable

import pytest

from engine import Body, Chain, Circle, Particle, World

G = 9.81
RADIUS = 1.0
BALL = 0.05
Curve = Callable[[float], tuple[tuple[float, float], tuple[float, float]]]


def bowl(gravity: float, links: int, friction: float) -> World:
    """A world with a ring of links about the origin."""
    world = World(gravity=(0, -gravity), integrator="velocity-verlet")
    turns = [2 * math.pi * i / links for i in range(links)]
    points = [(RADIUS * math.sin(turn), -RADIUS * math.cos(turn)) for turn in turns]
    world.add(Chain(points, loop=True), friction=friction)
    return world


def energy(world: World) -> float:
    return world.kinetic_energy + world.potential_energy


def period(length: float, amplitude: float) -> float:
    """Of a pendulum: the arithmetic-geometric mean of 1 and cos(a/2) (Gauss)."""
    one, other = 1.0, math.cos(amplitude / 2)
    for _ in range(6):
        one, other = (one + other) / 2, math.sqrt(one * other)
    return 2 * math.pi * math.sqrt(length / G) / one


@pytest.mark.parametrize("amplitude", [0.5, 1.2])
@pytest.mark.parametrize("links", [180, 720])
@pytest.mark.parametrize("friction", [0.0, 1.0])
def test_a_marble_swings_in_its_bowl_as_a_pendulum(
    friction: float, links: int, amplitude: float
) -> None:
    """For ten seconds, and neither corners nor contacts take energy, or bring any; friction takes a
    hundredth where a ball that rolls hops over corners.
    """
    world = bowl(G, links, friction)
    length = RADIUS - BALL
    place = (length * math.sin(amplitude), -length * math.cos(amplitude))
    ball = world.add(Circle(BALL), position=place, friction=friction)
    start = energy(world)
    passed = []
    before = ball.x
    for _ in range(600):
        world.step()
        if before < 0 <= ball.x:
            passed.append(world.time - ball.x / ball.vx)
        before = ball.x
    lifted = ball.mass * G * length * (1 - math.cos(amplitude))
    assert -1e-2 * lifted < energy(world) - start < 1e-4 * lifted
    heavy = length * (1.5 if friction else 1.0)
    measured = (passed[-1] - passed[0]) / (len(passed) - 1)
    assert measured == pytest.approx(period(heavy, amplitude), rel=2e-3)


@pytest.mark.parametrize("amplitude", [0.1, 0.3])
def test_a_marble_swings_little_for_long(amplitude: float) -> None:
    """In a bowl of 720 links, of which it passes a dozen."""
    world = bowl(G, 720, 0.0)
    length = RADIUS - BALL
    place = (length * math.sin(amplitude), -length * math.cos(amplitude))
    ball = world.add(Circle(BALL), position=place)
    start = energy(world)
    world.run(600)
    lifted = ball.mass * G * length * (1 - math.cos(amplitude))
    assert energy(world) - start == pytest.approx(0.0, abs=1e-3 * lifted)


@pytest.mark.parametrize("mu", [0.0, 0.1, 0.3])
def test_friction_on_a_curve_brakes_as_on_a_capstan(mu: float) -> None:
    """Without weight m v' = -mu m v^2/r, so that v = v_0 exp(-mu phi), whatever r is (Euler)."""
    world = bowl(0.0, 180, mu)
    place = (0, -RADIUS * math.cos(math.pi / 180) + BALL)
    bead = world.add(Particle(BALL), position=place, velocity=(4, 0), friction=mu)
    turned, last = 0.0, 0.0
    while turned < math.pi:
        world.step()
        angle = math.atan2(bead.x, -bead.y)
        turned += (angle - last) % (2 * math.pi)
        last = angle
    assert bead.speed == pytest.approx(4 * math.exp(-mu * turned), rel=1e-2)


def test_a_ball_that_falls_into_a_bowl_keeps_what_its_blow_leaves() -> None:
    """The blow takes the speed along the normal; from then on nothing takes any."""
    world = bowl(G, 180, 0.0)
    ball = world.add(Circle(BALL), position=(0.5, 0.2))
    while not world.step():
        pass
    world.run(2)
    start = energy(world)
    world.run(480)
    assert energy(world) - start == pytest.approx(0.0, abs=1e-3 * ball.mass * G * RADIUS)


def cycloid(share: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """Place and upward normal at a share of half an arch, rolled off by a circle of 1 m."""
    turn = math.pi * share
    x, y = math.sin(turn / 2), math.cos(turn / 2)
    return (turn - math.sin(turn), -2 * math.sin(turn / 2) ** 2), (y, x)


def straight(share: float) -> tuple[tuple[float, float], tuple[float, float]]:
    long = math.hypot(math.pi, 2)
    return (math.pi * share, -2 * share), (2 / long, math.pi / long)


def circular(share: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """The arc that sets off straight down, which Galilei took for the fastest (1638)."""
    radius = (math.pi**2 + 4) / (2 * math.pi)
    turn = share * math.atan2(2, radius - math.pi)
    x, y = math.cos(turn), math.sin(turn)
    return (radius - radius * x, -radius * y), (x, y)


def time_of(curve: Curve) -> float:
    """Time of a bead on a curve: the sum of 2 ds/(v_1 + v_2), which is exact on straight pieces."""
    time = 0.0
    (x, y), _ = curve(0.0)
    for i in range(1, 20001):
        (there, low), _ = curve((i / 20000) ** 2)
        way = math.hypot(there - x, low - y)
        time += 2 * way / (math.sqrt(-2 * G * y) + math.sqrt(-2 * G * low))
        x, y = there, low
    return time


def race(curve: Curve) -> tuple[float, Body]:
    """Time at which a bead is at the end of a curve of 200 links; its centre follows the curve."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    points = []
    for i in range(201):
        (x, y), (nx, ny) = curve(i / 200)
        points.append((x - 0.02 * nx, y - 0.02 * ny))
    world.add(Chain(points))
    bead = world.add(Particle(0.02), position=curve(0.0)[0])
    before = 0.0
    while bead.x < math.pi:
        before = bead.x
        world.step()
    return world.time - (bead.x - math.pi) / (bead.x - before) / 60, bead


def test_the_cycloid_is_the_curve_of_fastest_descent() -> None:
    """Johann Bernoulli (1696): pi sqrt(a/g) on the cycloid; the arc and the straight ramp are
    slower, by 2.5 % and by 18.5 %.
    """
    times = {}
    for curve in (cycloid, circular, straight):
        times[curve], bead = race(curve)
        assert times[curve] == pytest.approx(time_of(curve), rel=3e-4)
        assert bead.speed == pytest.approx(math.sqrt(-2 * G * bead.y), rel=2e-3)
    assert times[cycloid] == pytest.approx(math.pi / math.sqrt(G), rel=1e-4)
    assert times[cycloid] < times[circular] < times[straight]
