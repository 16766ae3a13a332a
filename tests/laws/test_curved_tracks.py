"""Tracks that curve: bowls, loops, hills, cycloids made of links, and channels that turn.

A contact that bears while its normal turns holds its bodies on the curve, whatever the tick, and
hands them from link to link. Closed forms: Landau and Lifshitz, "Mechanics", 1976; the cycloid:
Huygens, "Horologium Oscillatorium", 1673. What swings in bowls is in `test_bowls`.
"""

import math

import pytest

from engine import Body, Box, Chain, Circle, Compound, Particle, Shape, Wall, World

G = 9.81


def track_world(gravity: float = G) -> World:
    return World(gravity=(0, -gravity), integrator="velocity-verlet")


def loop(world: World, radius: float, links: int, friction: float = 0.0) -> Body:
    """A circle of links that stands on the origin."""
    turns = [2 * math.pi * i / links for i in range(links)]
    points = [(radius * math.sin(turn), radius - radius * math.cos(turn)) for turn in turns]
    return world.add(Chain(points, loop=True), friction=friction)


@pytest.mark.parametrize(
    ("radius", "marble", "speed"),
    [(0.15, 0.008, 3.0), (0.5, 0.01, 5.0), (1.0, 0.02, 7.0), (1.0, 0.05, 7.0)],
)
@pytest.mark.parametrize("links", [90, 720])
def test_a_marble_stays_in_its_loop(radius: float, marble: float, speed: float, links: int) -> None:
    """However fast it goes round: contacts are soft by hundredths of its size."""
    world = track_world()
    loop(world, radius, links)
    ball = world.add(Circle(marble), position=(0, marble), velocity=(speed, 0))
    for _ in range(60):
        world.step()
        assert math.hypot(ball.x, ball.y - radius) - (radius - marble) < 0.03 * marble


@pytest.mark.parametrize(("rolls", "least"), [(False, 2.5), (True, 2.75)])
def test_loops_are_looped_from_the_least_height(rolls: bool, least: float) -> None:
    """v^2 = g R at the top of a loop (R: of the path of the centre), so that 5/2 R is the least
    height above its foot if the ball slides, and 11/4 R if it rolls, as 1/3 of its energy then
    turns it. Below it falls off, above it goes round.
    """
    radius, ball_radius = 1.0, 0.05
    path = radius - ball_radius
    for factor, goes_round in ((0.98, False), (1.015, True)):
        world = track_world()
        loop(world, radius, 720, friction=2.0 if rolls else 0.0)
        speed = math.sqrt(2 * G * least * factor * path / (1.5 if rolls else 1.0))
        ball = world.add(
            Circle(ball_radius), position=(0, ball_radius), velocity=(speed, 0),
            spin=-speed / ball_radius if rolls else 0.0, friction=2.0 if rolls else 0.0,
        )  # fmt: skip
        lifted = 0.0
        for _ in range(120):
            world.step()
            lifted = max(lifted, path - math.hypot(ball.x, ball.y - radius))
            if ball.x < 0 and ball.y < radius:
                break
        assert (lifted < 1e-3) == goes_round


@pytest.mark.parametrize("start", [0.3, 1.0, 2.0])
@pytest.mark.parametrize("links", [400, 1600])
def test_the_cycloid_is_the_curve_of_equal_times(start: float, links: int) -> None:
    """From wherever a bead slides, it is at the foot after pi sqrt(a/g)."""
    world = track_world()
    turns = [2 * math.pi * i / links for i in range(links + 1)]
    world.add(Chain([(turn - math.sin(turn), math.cos(turn) - 1) for turn in turns]))
    bead = 1e-3
    nx, ny = math.sin(start), 1 - math.cos(start)
    out = bead / math.hypot(nx, ny)
    ball = world.add(
        Particle(bead),
        position=(start - math.sin(start) + nx * out, math.cos(start) - 1 + ny * out),
    )
    before = ball.x
    while ball.x < math.pi:
        before = ball.x
        world.step()
        assert world.time < 1.1
    passed = world.time - (ball.x - math.pi) / (ball.x - before) / 60
    assert passed == pytest.approx(math.pi * math.sqrt(1 / G), rel=1.5e-3)


@pytest.mark.parametrize("mu", [0.0, 5.0])
def test_what_slides_or_rolls_down_a_cylinder_follows_its_pendulum(mu: float) -> None:
    """theta'' = g sin(theta) / (k (R + r)), k = 1 for what slides and 3/2 for a disc that rolls,
    so that v^2 = 2 g (R + r) (cos(theta_0) - cos(theta)) / k.
    """
    world = track_world()
    world.add(Circle(1.0), kind="static", friction=mu)
    ball = world.add(Circle(0.1), position=(1.1 * math.sin(0.3), 1.1 * math.cos(0.3)), friction=mu)
    for _ in range(30):
        world.step()
    height = math.hypot(ball.x, ball.y)
    speed = math.sqrt(2 * G * (1.1 * math.cos(0.3) - ball.y) / (1.5 if mu else 1.0))
    assert height == pytest.approx(1.1, abs=2e-5)
    assert ball.speed == pytest.approx(speed, rel=1e-4)
    if mu:
        assert ball.spin == pytest.approx(-speed / 0.1, rel=1e-4)


@pytest.mark.parametrize("shape", [Circle(0.1), Box(0.3, 0.2)])
@pytest.mark.parametrize("spin", [2.0, -5.0])
def test_a_channel_that_turns_throws_outwards_what_is_in_it(shape: Shape, spin: float) -> None:
    """r'' = w^2 r in a channel without friction: r = r_0 cosh(w t)."""
    world = track_world(0.0)
    sides = Compound([(Box(8, 0.1), (0, 0.15)), (Box(8, 0.1), (0, -0.15))])
    world.add(sides, kind="kinematic", spin=spin)
    bead = world.add(shape, position=(0.5, 0), velocity=(0, 0.5 * spin), spin=spin)
    for _ in range(30):
        world.step()
    away = 0.5 * math.cosh(spin * 0.5)
    assert math.hypot(bead.x, bead.y) == pytest.approx(away, rel=3e-4)
    speed = abs(spin) * 0.5 * math.sqrt(math.cosh(2 * spin * 0.5))
    assert bead.speed == pytest.approx(speed, rel=5e-4)


@pytest.mark.parametrize("drop", [0.02, 0.2])
def test_a_ball_leaves_one_link_for_the_next_in_few_blows(drop: float) -> None:
    """A fast ball meets the first links of a curve at once; it is not struck without end."""
    world = track_world()
    loop(world, 0.5, 720)
    world.add(Wall((-3, 0), (0, 0)))
    world.add(Circle(0.01), position=(0, 0.01), velocity=(math.sqrt(2 * G * drop) + 2, 0))
    blows = sum(len(world.step()) for _ in range(30))
    assert blows < 300


def test_balls_that_chase_each_other_in_a_loop_keep_the_books_closed() -> None:
    """What is handed from link to link is booked once: energy and angular momentum add up."""
    world = track_world()
    loop(world, 0.5, 360, friction=0.5)
    for i in range(5):
        x = 0.05 * i - 0.1
        world.add(
            Circle(0.02), position=(x, 0.033 + x * x), velocity=(5 - 0.3 * i, 0), friction=0.5
        )
    for _ in range(60):
        world.step()
    books = world.ledger()
    assert abs(books.energy_error) < 1e-10
    assert abs(books.angular_momentum_error) < 1e-10
