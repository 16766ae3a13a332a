"""Impacts of one instant on the same bodies are one: what is its own mirror image stays so.

Newton's law of restitution for all points together: each leaves with e times the speed with which
it came. Impulses follow from that and from momentum; those between equal partners are equal.
"""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine import Body, Box, Circle, Wall, World

RESTITUTIONS = [0.0, 0.5, 0.9, 1.0]
GRAVITY = 9.81


@pytest.mark.parametrize("e", RESTITUTIONS)
@pytest.mark.parametrize("mass", [0.1, 1.0, 7.0])
def test_a_ball_that_meets_two_at_once(mass: float, e: float) -> None:
    """The break in billiards. Both lines of centres make the angle a with the way of the first, of
    mass M: P (1/m + 2 cos^2(a) / M) = (1 + e) v cos(a) for each.
    """
    world = World()
    cue = world.add(
        Circle(0.5), mass=mass, position=(-3, 0), velocity=(4, 0), restitution=e, friction=0
    )
    others = [
        world.add(Circle(0.5), mass=1, position=(0, y), restitution=e, friction=0)
        for y in (0.5, -0.5)
    ]
    hits = [hit for _ in range(60) for hit in world.step()]
    assert len(hits) == 2
    assert hits[0].time == hits[1].time
    cos = math.sqrt(0.75)
    impulse = (1 + e) * 4 * cos / (1 + 2 * cos**2 / mass)
    assert cue.vx == pytest.approx(4 - 2 * impulse * cos / mass, abs=1e-12)
    assert cue.vy == pytest.approx(0.0, abs=1e-12)
    for side, other in zip((1, -1), others, strict=True):
        assert other.vx == pytest.approx(impulse * cos, rel=1e-12)
        assert other.vy == pytest.approx(side * impulse / 2, rel=1e-12)


@pytest.mark.parametrize("e", RESTITUTIONS)
@pytest.mark.parametrize("rows", [2, 3, 4, 5])
def test_a_rack_of_balls_breaks_evenly(rows: int, e: float) -> None:
    """Every ball and its mirror image go mirrored ways; momentum stays, and with e = 1 energy.

    What stays together after e = 0 is swept as resting contacts, in turn and so not as evenly.
    """
    world = World()
    world.add(Circle(0.5), position=(-3, 0), velocity=(5, 0), restitution=e, friction=0)
    rack = {
        (i, j): world.add(
            Circle(0.5), position=(i * math.sqrt(0.75), j - i / 2), restitution=e, friction=0
        )
        for i in range(rows)
        for j in range(i + 1)
    }
    momentum, energy = world.momentum, world.kinetic_energy
    world.run(120)
    exact = 1e-12 if e > 0.0 else 5e-3
    for (i, j), ball in rack.items():
        image = rack[i, i - j]
        assert ball.x == pytest.approx(image.x, abs=exact)
        assert ball.y == pytest.approx(-image.y, abs=exact)
    assert world.momentum == pytest.approx(momentum, abs=1e-12)
    left = world.kinetic_energy / energy
    assert left == pytest.approx(1.0, rel=1e-13) if e == 1.0 else left < 1.0


@pytest.mark.parametrize("e", [0.5, 1.0])
@pytest.mark.parametrize("props", [(-0.7, 0.7), (-0.9, 0.2), (-0.1, 0.8), (-0.6, 0.1, 0.7)])
def test_a_plank_on_props_bounces_level(props: tuple[float, ...], e: float) -> None:
    """It comes without spin, so all of it leaves with e v, wherever the props are below it; of what
    they give together, (1 + e) m v, each has its part.
    """
    world = World(gravity=(0, -GRAVITY), integrator="velocity-verlet")
    for x in props:
        world.add(Box(0.1, 1), kind="static", position=(x, 0.5), restitution=e)
    plank = world.add(Box(2, 0.1), mass=3, position=(0, 2.05), restitution=e)
    hits = []
    while not hits:
        hits = world.step()
    speed = math.sqrt(2 * GRAVITY)
    assert sum(abs(hit.impulse.y) for hit in hits) == pytest.approx(3 * (1 + e) * speed, rel=1e-9)
    assert plank.spin == pytest.approx(0.0, abs=1e-9)
    after = plank.vy + GRAVITY * (world.time - hits[0].time)
    assert after == pytest.approx(e * speed, rel=1e-9)


@pytest.mark.parametrize("e", [0.3, 1.0])
@pytest.mark.parametrize("slope", [0.3, math.pi / 4, 1.2])
def test_a_ball_in_a_groove_comes_back_up(slope: float, e: float) -> None:
    """It meets both sides at once, with v cos(slope) each, and leaves them with e times that."""
    world = World(gravity=(0, -GRAVITY), integrator="velocity-verlet")
    x, y = 3 * math.cos(slope), 3 * math.sin(slope)
    world.add(Wall((-x, y), (0, 0)), restitution=e, friction=0)
    world.add(Wall((0, 0), (x, y)), restitution=e, friction=0)
    low = 0.3 / math.cos(slope)
    ball = world.add(Circle(0.3), position=(0, low + 1), restitution=e, friction=0)
    hits = []
    while not hits:
        hits = world.step()
    after = ball.vy + GRAVITY * (world.time - hits[0].time)
    assert after == pytest.approx(e * math.sqrt(2 * GRAVITY), rel=1e-9)
    assert ball.vx == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("friction", [0.1, 0.3, 0.8])
@pytest.mark.parametrize("steeper", [1.15, 1.5, 3.0])
def test_a_ball_between_closing_jaws_slips_out_above_the_angle_of_friction(
    friction: float, steeper: float
) -> None:
    """Jaws at half an angle a to each other that close at v drive it out, as nothing bounces, at
    v/tan(a), whatever the friction, and straight, as the scene is its own mirror image. Friction
    brakes the ball, which presses it on both jaws again: blow follows blow.
    """
    half = math.atan(friction * steeper)
    out = 0.5 / math.sin(half)
    along = out * math.cos(half)
    world = World()
    for side in (1, -1):
        x, y = along * math.cos(half) - 0.5 * math.sin(half), 0.5 * math.cos(half)
        world.add(
            Box(2 * out, 1), kind="kinematic", position=(x, side * (along * math.sin(half) + y)),
            angle=side * half, velocity=(0, -side * 0.2), friction=friction,
        )  # fmt: skip
    ball = world.add(Circle(0.5), position=(out, 0), friction=friction)
    world.step()
    assert ball.vx == pytest.approx(0.2 / math.tan(half), rel=1e-4)
    assert abs(ball.vy) + abs(ball.spin) < 1e-4


@pytest.mark.parametrize("speed", [1.0, 100.0])
@pytest.mark.parametrize(
    "masses", [(1, 0.033, 3), (1, 1, 1), (1, 1, 1, 1, 1), (2, 0.2, 2, 0.2, 1), (1, 0.1) * 3]
)
def test_cars_that_couple_go_on_as_one(masses: tuple[float, ...], speed: float) -> None:
    """Plastic impacts one after another, each handed on to and fro between all cars that touch:
    v = v0 m1/(m1 + m2 + ...), and nobody is thrown back.
    """
    world = World()
    cars = [
        world.add(Box(1, 0.5), mass=mass, position=(1.1 * i, 0)) for i, mass in enumerate(masses)
    ]
    cars[0].velocity = (speed, 0)
    world.run(60 if speed > 50 else 240)
    together = speed * masses[0] / sum(masses)
    assert [car.vx for car in cars] == pytest.approx([together] * len(cars), rel=1e-9)


def star(world: World, arms: int, turned: float, e: float, mu: float, mass: float) -> list[Body]:
    """Balls that fly towards one in the middle and meet it at the same instant."""
    world.add(Circle(0.3), mass=mass, spin=3.0, restitution=e, friction=mu)
    for arm in range(arms):
        angle = turned + 2 * math.pi * arm / 6
        x, y = math.cos(angle), math.sin(angle)
        world.add(
            Circle(0.3),
            mass=1 + arm,
            position=(1.9 * x, 1.9 * y),
            velocity=(-2 * x, -2 * y),
            restitution=e,
            friction=mu,
        )
    return list(world.bodies)


@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
@pytest.mark.parametrize("slope", [0.3, math.pi / 4, 1.2])
@pytest.mark.parametrize("friction", [0.1, 0.4, 2.0])
def test_a_ball_in_a_groove_with_friction_is_braked_on_its_way_out(
    friction: float, slope: float, e: float
) -> None:
    """Each side gives P = m (1 + e) v/(2 cos a), then mu P against the sliding, which that would
    begin: 2 mu P sin a less of m e v, until nothing slides. It never turns.
    """
    world = World()
    for side in (-1, 1):
        end = (9 * side * math.cos(slope), 9 * math.sin(slope))
        world.add(Wall((0, 0), end), friction=friction)
    height = 0.5 / math.cos(slope)
    ball = world.add(
        Circle(0.5), position=(0, height + 0.04), velocity=(0, -4), restitution=e, friction=friction
    )
    world.run(2)
    leaves = e - friction * (1 + e) * math.tan(slope)
    assert ball.vy == pytest.approx(4 * max(leaves, 0.0), abs=1e-9)
    assert ball.vx == pytest.approx(0.0, abs=1e-9)
    assert ball.spin == pytest.approx(0.0, abs=1e-9)


@settings(max_examples=60, deadline=None)
@given(
    arms=st.integers(2, 5),
    turned=st.floats(-3, 3),
    e=st.sampled_from([0.0, 0.5, 1.0]),
    mu=st.sampled_from([0.0, 0.4]),
    mass=st.floats(1e-3, 1e3),
)
def test_what_meets_at_once_keeps_momentum_and_gains_no_energy(
    arms: int, turned: float, e: float, mu: float, mass: float
) -> None:
    """Momentum and angular momentum stay, the books say where the energy went; e = 1 and no
    friction keep it, also where one is so light that blows go to and fro between the others.
    """
    world = World()
    star(world, arms, turned, e, mu, mass)
    before = world.ledger()
    world.run(90)
    after = world.ledger()
    scale = 10.0 * (arms + mass)
    assert after.momentum == pytest.approx(before.momentum, abs=1e-12 * scale)
    assert after.angular_momentum == pytest.approx(before.angular_momentum, abs=1e-12 * scale)
    assert abs(after.energy_error) < 1e-11 * scale
    assert after.kinetic <= before.kinetic * (1 + 1e-12)
    if e == 1.0 and mu == 0.0:
        assert after.kinetic == pytest.approx(before.kinetic, rel=1e-12)
