"""What is promised at 60 ticks a second, number by number: gases, bounces, bullets, rods, sizes.

All closed forms are elementary mechanics (Landau and Lifshitz, "Mechanics", 1976); bounds are those
that the engine promises in docs/engine.md.
"""

import math
import random

import pytest

from engine import (
    Body,
    Box,
    Capsule,
    Circle,
    Collision,
    Compound,
    Distance,
    Force,
    Particle,
    Polygon,
    Shape,
    Wall,
    World,
)

G = 9.81


def until_impact(world: World, ticks: int = 600) -> list[Collision]:
    for _ in range(ticks):
        collisions = world.step()
        if collisions:
            return collisions
    raise AssertionError("nothing collided")


def test_an_elastic_gas_in_a_free_box_is_an_isolated_system() -> None:
    """First integrals: energy to 1e-9, momentum and angular momentum to 1e-12.

    The box flies and turns; it weighs five times as much as the gas.
    """
    dice = random.Random(5)
    world = World()
    sides = [
        (Box(10.4, 0.4), (0, -5.2)),
        (Box(10.4, 0.4), (0, 5.2)),
        (Box(0.4, 10), (-5.2, 0)),
        (Box(0.4, 10), (5.2, 0)),
    ]
    frame = world.add(Compound(sides), mass=500, velocity=(0.1, 0), spin=0.02, restitution=1.0)
    for i in range(100):
        world.add(
            Particle(dice.uniform(0.05, 0.2)),
            mass=dice.uniform(0.1, 3),
            position=(-4.5 + i % 10, -4.5 + i // 10),
            velocity=(dice.uniform(-2, 2), dice.uniform(-2, 2)),
            restitution=1.0,
        )
    energy, momentum, turning = world.kinetic_energy, world.momentum, world.angular_momentum
    of_size = math.fsum(body.mass * body.speed for body in world)
    collisions = sum(len(world.step()) for _ in range(400))
    assert collisions > 400
    assert world.kinetic_energy == pytest.approx(energy, rel=1e-9)
    assert world.momentum == pytest.approx(momentum, abs=1e-12 * of_size)
    assert world.angular_momentum == pytest.approx(turning, abs=1e-12 * of_size * 5.0)
    centre = frame.position
    assert all(math.dist(body.position, centre) < 7.1 for body in world)


def test_a_hundred_elastic_particles_between_walls_keep_the_books_of_momentum() -> None:
    """The walls' impulses are all that changes momentum: to 1e-12 of what goes back and forth."""
    dice = random.Random(7)
    world = World()
    corners = [(0, 0), (10, 0), (10, 10), (0, 10)]
    for i in range(4):
        world.add(Wall(corners[i], corners[(i + 1) % 4]), restitution=1.0)
    for i in range(100):
        world.add(
            Particle(dice.uniform(0.05, 0.2)),
            mass=dice.uniform(0.1, 3),
            position=(0.5 + i % 10, 0.5 + i // 10),
            velocity=(dice.uniform(-2, 2), dice.uniform(-2, 2)),
            restitution=1.0,
        )
    of_size = math.fsum(body.mass * body.speed for body in world if body.is_dynamic)
    for _ in range(600):
        world.step()
    books = world.ledger()
    assert math.dist(books.outside_impulse, (0, 0)) > 0.1
    assert books.momentum_error == pytest.approx((0, 0), abs=1e-12 * of_size)
    assert books.energy_error == pytest.approx(0, abs=1e-12 * books.kinetic)


def test_an_elastic_ball_keeps_time_for_a_hundred_seconds() -> None:
    """The n-th impact is at (2 n + 1) sqrt(2 h / g), each with the speed of the first."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-5, 0), (5, 0)))
    world.add(Circle(0.1), position=(0, 1.1), restitution=1.0)
    impacts = [c for _ in range(6000) for c in world.step()]
    fall = math.sqrt(2 / G)
    assert len(impacts) == math.floor((100 / fall + 1) / 2)
    assert [c.time for c in impacts] == pytest.approx(
        [(2 * n + 1) * fall for n in range(len(impacts))], abs=1e-9
    )
    heights = [c.speed**2 / (2 * G) for c in impacts]
    assert heights == pytest.approx([1.0] * len(impacts), rel=1e-9)


@pytest.mark.parametrize("e", [0.5, 0.8, 0.9])
@pytest.mark.parametrize("shape", [Circle(0.1), Box(0.4, 0.2)])
def test_a_zeno_sequence_ends_at_rest_at_the_right_time(shape: Shape, e: float) -> None:
    """Infinitely many bounces end at sqrt(2 h / g) (1 + e) / (1 - e).

    Flights shorter than a substep are none: what is left out of the sum is less than one divided
    by 1 - e, and no flight that is left out rises above 3.4 micrometres.
    """
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-5, 0), (5, 0)))
    ball = world.add(shape, position=(0, 1.1), restitution=e)
    end = math.sqrt(2 / G) * (1 + e) / (1 - e)
    last = 0.0
    while world.time < end:
        for impact in world.step():
            last = impact.time
    assert end - 1 / 360 / (1 - e) < last <= end
    for _ in range(60):
        assert world.step() == []
        assert ball.speed < 1e-6
        assert ball.y == pytest.approx(0.1, abs=2e-5)


@pytest.mark.parametrize(
    ("one", "other", "gap"),
    [
        (Circle(0.01), Particle(0.01), 15.2 - 0.02),
        (Box(0.02, 0.02), Circle(0.01), 15.2 - 0.02),
        (Box(0.02, 0.01), Box(0.02, 0.01), 15.2 - 0.02),
        (Capsule(0.02, 0.01), Polygon.regular(3, 0.01), 15.2 - 0.02 - 0.005),
    ],
)
@pytest.mark.parametrize("speed", [1.0, 1000.0])
def test_two_bullets_meet(one: Shape, other: Shape, gap: float, speed: float) -> None:
    """Head on at the time gap / 2 v; equal masses swap their velocities."""
    world = World()
    a = world.add(one, position=(-7.3, 0), velocity=(speed, 0), restitution=1.0)
    b = world.add(other, position=(7.9, 0), velocity=(-speed, 0), restitution=1.0)
    (impact,) = until_impact(world)
    assert impact.time == pytest.approx(gap / (2 * speed), abs=1e-9)
    assert impact.speed == pytest.approx(2 * speed, rel=1e-12)
    for _ in range(3):
        assert world.step() == []
    assert a.vx == pytest.approx(-speed, rel=1e-12)
    assert b.vx == pytest.approx(speed, rel=1e-12)


def test_bullets_cross_a_volley_of_bullets() -> None:
    """Nothing passes through anything: on a line, the order of the bodies stays."""
    world = World()
    dice = random.Random(3)
    bodies = [
        world.add(
            Circle(0.01),
            position=(x, 0),
            velocity=(dice.choice([-1000, -10, 10, 1000]), 0),
            restitution=1.0,
        )
        for x in range(12)
    ]
    speeds = sorted(body.vx for body in bodies)
    for _ in range(120):
        world.step()
        assert [body.id for body in sorted(bodies, key=lambda b: b.x)] == [b.id for b in bodies]
    assert sorted(body.vx for body in bodies) == pytest.approx(speeds, rel=1e-12)


@pytest.mark.parametrize("spin", [0.7, 10.0, 1000.0])
def test_a_spinning_rod_hits_a_peg_on_time(spin: float) -> None:
    """Its side, half a thickness d from its centre, touches a peg of radius r at a distance s when
    s cos(angle) = r + d; the tip of a fast one moves 8 lengths of the rod a tick.
    """
    world = World()
    rod = world.add(Box(2, 0.002), spin=spin)
    world.add(Circle(0.01), kind="static", position=(0, 0.9), restitution=1.0)
    energy = rod.kinetic_energy
    (impact, *_) = until_impact(world)
    assert impact.time == pytest.approx(math.acos(0.011 / 0.9) / spin, abs=1e-9)
    assert rod.kinetic_energy == pytest.approx(energy, rel=1e-12)


@pytest.mark.parametrize("spin", [3.0, 800.0])
def test_two_spinning_rods_strike_each_other(spin: float) -> None:
    """Two rods of length 2, centres 1.9 apart: the first turns towards the other, which points at
    it. Its side is at the tip's corner, 0.9 away and d below the axis, when 0.9 sin(angle) equals
    d cos(angle) + d.
    """
    half = 0.01
    world = World()
    a = world.add(Box(2, 2 * half), angle=-0.5, spin=spin, restitution=1.0)
    b = world.add(Box(2, 2 * half), position=(1.9, 0))
    energy, turning = world.kinetic_energy, world.angular_momentum
    (impact, *_) = until_impact(world)
    # The side of a, d left of its axis, reaches the corner (0.9, -d) of b.
    low, high = -0.5, 0.0
    for _ in range(100):
        middle = (low + high) / 2
        above = -math.sin(middle) * 0.9 + math.cos(middle) * -half
        low, high = (middle, high) if above > half else (low, middle)
    assert impact.time == pytest.approx((low + 0.5) / spin, abs=1e-9)
    for _ in range(5):
        world.step()
    assert world.kinetic_energy == pytest.approx(energy, rel=1e-12)
    assert world.angular_momentum == pytest.approx(turning, rel=1e-12)
    assert a.spin != spin
    assert b.spin != 0.0


@pytest.mark.parametrize("gap", [0.0, 1e-6])
def test_a_cradle_of_hung_balls_hands_the_speed_to_the_last(gap: float) -> None:
    """Balls on strings, touching: v = sqrt(2 g L (1 - cos a)), and the last takes 99.9 % of it."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    balls: list[Body] = []
    for i in range(5):
        x = i * (0.1 + gap)
        swung = 0.3 if i == 0 else 0.0
        at = (x - math.sin(swung), -math.cos(swung))
        balls.append(world.add(Circle(0.05), position=at, restitution=1.0))
        world.join(None, balls[-1], Distance(anchor_a=(x, 0)))
    impacts = until_impact(world)
    assert len(impacts) == 4
    assert impacts[0].speed == pytest.approx(math.sqrt(2 * G * (1 - math.cos(0.3))), rel=1e-3)
    handed = impacts[-1].impulse.x  # of 1 kg that was at rest
    assert handed == pytest.approx(impacts[0].speed, rel=1e-3)
    assert [abs(ball.vx) < 1e-3 * handed for ball in balls[:-1]] == [True] * 4
    while not (impacts := world.step()):
        assert balls[0].speed < 1e-3
    world.step()
    assert [abs(ball.vx) < 1e-3 * handed for ball in balls[1:]] == [True] * 4


SIZES = [1e-3, 1.0, 1e3]
"""Of a grain, a person and a mountain (m); v ~ sqrt(g s) makes them alike (Froude)."""


@pytest.mark.parametrize("size", SIZES)
def test_bodies_of_any_size_bounce(size: float) -> None:
    """Heights e^(2 n) h; the first impact at sqrt(2 h / g)."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-9 * size, 0), (9 * size, 0)))
    world.add(Circle(size), position=(0, 2 * size), restitution=0.8)
    impacts: list[Collision] = []
    while len(impacts) < 4:
        impacts += world.step()
    heights = [impact.speed**2 / (2 * G * size) for impact in impacts]
    assert heights == pytest.approx([0.64**n for n in range(len(heights))], rel=1e-3)
    assert impacts[0].time == pytest.approx(math.sqrt(2 * size / G), abs=1e-6)


@pytest.mark.parametrize("size", SIZES)
def test_bodies_of_any_size_slide_to_a_stop(size: float) -> None:
    """After v^2 / (2 mu g), within 0.1 %."""
    speed = math.sqrt(G * size)
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-5 * size, 0), (9 * size, 0)), friction=0.3)
    box = world.add(
        Box(size, size), position=(0, size / 2), velocity=(speed, 0), friction=0.3, mass=size**3
    )
    for _ in range(round(speed / (0.3 * G) * 60) + 10):
        world.step()
    assert box.speed < 1e-6 * speed
    assert box.x == pytest.approx(speed**2 / (2 * 0.3 * G), rel=1e-3)


@pytest.mark.parametrize("size", SIZES)
def test_discs_of_any_size_come_to_roll(size: float) -> None:
    """At 2/3 of the speed, within 0.1 %."""
    speed = math.sqrt(G * size)
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-5 * size, 0), (99 * size, 0)), friction=0.3)
    disc = world.add(
        Circle(size / 2), position=(0, size / 2), velocity=(speed, 0), friction=0.3, mass=size**3
    )
    for _ in range(round(speed / (3 * 0.3 * G) * 60) + 30):
        world.step()
    assert disc.vx == pytest.approx(2 / 3 * speed, rel=1e-3)
    assert disc.spin * disc.y == pytest.approx(-disc.vx, rel=1e-3)


@pytest.mark.parametrize("size", SIZES)
def test_bodies_of_any_size_hold_and_slip_on_a_slope(size: float) -> None:
    """Coulomb: they hold below tan(theta) = mu and slip above it, within 0.5 %."""
    for factor, holds in ((0.995, True), (1.005, False)):
        theta = math.atan(0.4 * factor)
        world = World(gravity=(G * math.sin(theta), -G * math.cos(theta)))
        world.add(Wall((-9 * size, 0), (9 * size, 0)), friction=0.4)
        box = world.add(Box(size, size / 2), position=(0, size / 4), friction=0.4)
        for _ in range(60):
            world.step()
        slipped = G * math.cos(theta) * 0.4 * 0.005  # a = g (sin - mu cos) of one that slides
        assert (box.vx < 0.1 * slipped) is holds


def test_a_world_has_one_rule_of_restitution_at_a_time() -> None:
    """The larger unless told otherwise; a rule of one's own may come later, and be the product."""
    world = World()
    walls = [world.add(Wall((x, -1), (x, 1)), restitution=0.5) for x in (-2, 2)]
    ball = world.add(Particle(0.1), velocity=(6, 0), restitution=0.8)
    (impact,) = until_impact(world)
    assert impact.restitution == 0.8
    assert ball.vx == pytest.approx(-6 * 0.8)
    world.restitution_rule = lambda a, b: a * b
    (impact,) = until_impact(world)
    assert impact.a is walls[0]
    assert impact.restitution == pytest.approx(0.4)
    assert ball.vx == pytest.approx(6 * 0.8 * 0.4)
    apart = World(restitution_rule=min)
    apart.add(Wall((2, -1), (2, 1)), restitution=0.5)
    other = apart.add(Particle(0.1), velocity=(6, 0), restitution=0.8)
    until_impact(apart)
    assert other.vx == pytest.approx(-3)


def heap() -> tuple[World, list[Body]]:
    """Three boxes on each other, about to rest."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-50, 0), (50, 0)), friction=0.5)
    boxes = [world.add(Box(1, 1), position=(0, i + 0.5), friction=0.5) for i in range(3)]
    for _ in range(10):
        world.step()
    return world, boxes


@pytest.mark.parametrize("pressed", [0, 1, 2])
def test_a_heap_bears_an_immense_force(pressed: int) -> None:
    """1e12 N down for a tick on boxes of 1 kg: what carries carries, and nothing is left of it."""
    world, boxes = heap()
    boxes[pressed].exert(Force(0, -1e12), duration=1 / 60)
    for _ in range(20):
        world.step()
        assert all(body.y > i + 0.4 for i, body in enumerate(boxes))
    assert [body.y for body in boxes] == pytest.approx([0.5, 1.5, 2.5], abs=0.05)
    assert max(body.speed for body in boxes) < 1.0


def test_an_immense_blow_on_a_heap_leaves_numbers() -> None:
    """1e9 N s into an anvil: what is between turns thousands of times a tick, but is numbers."""
    world, boxes = heap()
    boxes[1].apply_impulse((0, -1e9))
    energy = world.kinetic_energy
    for _ in range(10):
        world.step()
        for body in boxes:
            assert all(map(math.isfinite, (*body.position, *body.velocity, body.angle)))
        assert world.kinetic_energy <= energy * (1 + 1e-9)
