"""Sensors tell when bodies overlap, by closed forms of the first law: whatever the tick, however
fast and thin the body, and on the way that it really takes.
"""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine import Body, Box, Capsule, Circle, Particle, Pin, Polygon, Shape, Wall, World

DT = 1.0 / 60.0


def phases(world: World, ticks: int, sensor: Body) -> list[str | None]:
    """What is told of a sensor in each tick; it meets one body at most."""
    told: list[str | None] = []
    for _ in range(ticks):
        world.step()
        met = [c.phase for c in world.contacts if c.a is sensor or c.b is sensor]
        told.append(met[0] if met else None)
    return told


@given(
    speed=st.floats(1.0, 2000.0),
    start=st.floats(-3.0, -1.1),
    height=st.floats(-1.04, 1.04),
    angle=st.floats(-math.pi, math.pi),
)
def test_a_ball_is_within_a_disc_from_one_root_to_the_other(
    speed: float, start: float, height: float, angle: float
) -> None:
    """|p + v t| = R + r has two roots; between them they overlap."""
    world = World()
    gate = world.add(Circle(1.0), kind="static", sensor=True)
    way = (math.cos(angle), math.sin(angle))
    at = (start * way[0] - height * way[1], start * way[1] + height * way[0])
    world.add(Circle(0.05), position=at, velocity=(speed * way[0], speed * way[1]))
    half = math.sqrt(1.05 * 1.05 - height * height)
    enters, leaves = ((-start + side * half) / speed / DT for side in (-1.0, 1.0))
    if any(abs(tick - round(tick)) < 1e-6 for tick in (enters, leaves)):
        return
    begins, ends = math.floor(enters), max(math.floor(leaves), math.floor(enters) + 1)
    told = phases(world, min(ends + 3, 200), gate)
    for tick, phase in enumerate(told):
        stays = "stay" if begins < tick < ends else None
        assert phase == {begins: "begin", ends: "end"}.get(tick, stays), (tick, enters, leaves)


@pytest.mark.parametrize("turns", [10.0, 60.0, 610.0])
@pytest.mark.parametrize("thick", [0.001, 0.05])
def test_the_tip_of_a_rod_passes_twice_a_turn(turns: float, thick: float) -> None:
    """It is there in every tick in which its angle passes a multiple of pi; it begins again only if
    a tick went by without.
    """
    world = World()
    world.add(Box(0.01, 0.0001), kind="static", sensor=True, position=(0.5, 0))
    spin = 2.0 * math.pi * turns
    rod = world.add(Box(1.0, thick), angle=1.0, spin=spin)
    width = math.asin((thick / 2.0 + 0.0001) / 0.495)
    told = []
    for _ in range(40):
        before = rod.angle
        world.step()
        first = math.ceil((before - width) / math.pi) * math.pi
        clear = math.ceil((before + width) / math.pi) * math.pi
        (phase,) = [contact.phase for contact in world.contacts] or [None]
        inside = phase in ("begin", "stay")
        if clear + width < rod.angle:
            assert inside
        elif first - width > rod.angle:
            assert not inside
        told.append(inside)
    assert sum(told) >= min(40, 40 * turns * 2.0 / 60.0 - 2)


@pytest.mark.parametrize("depth", [1e-2, 1e-4, 1e-6])
@pytest.mark.parametrize("speed", [3.0, 70.0, 1000.0])
@pytest.mark.parametrize("large", [True, False])
def test_what_clips_a_corner_is_noticed(depth: float, speed: float, large: bool) -> None:
    """A corner of pi/2 that is passed at a depth d overlaps on a way of 2 d: less than any share
    of either body.
    """
    world = World()
    half = 5.0 if large else 0.5
    gate = world.add(
        Box(2.0 * half, 2.0 * half), kind="static", angle=math.pi / 4, sensor=True, name="gate"
    )
    height = math.sqrt(2.0) * half + 0.25 - depth
    world.add(Box(0.5, 0.5), position=(-1.7, height), velocity=(speed, 0))
    ticks = math.ceil(4.0 / speed / DT)
    assert "begin" in phases(world, ticks, gate)


@pytest.mark.parametrize("depth", [1e-2, 1e-4, 1e-6])
@pytest.mark.parametrize("speed", [3.0, 70.0, 1000.0])
def test_what_clips_a_corner_is_hit(depth: float, speed: float) -> None:
    """Impacts are searched for alike: a disc meets the corner where that is its radius away."""
    world = World()
    corner = math.sqrt(2.0) * 5.0
    world.add(Box(10.0, 10.0), kind="static", angle=math.pi / 4)
    world.add(Circle(0.25), position=(-1.7, corner + 0.25 - depth), velocity=(speed, 0))
    hits = [hit for _ in range(math.ceil(4.0 / speed / DT)) for hit in world.step()]
    aside = math.sqrt(0.25 * 0.25 - (0.25 - depth) ** 2)
    assert hits[0].time == pytest.approx((1.7 - aside) / speed, abs=1e-9)


def test_a_sensor_behind_a_wall_is_not_touched() -> None:
    """A ball that bounces off at x = 0 never was at x > 0: it was told to have been."""
    world = World()
    world.add(Wall((0, -1), (0, 1)), restitution=1.0)
    gate = world.add(Box(0.02, 2), kind="static", position=(0.05, 0), sensor=True)
    ball = world.add(Circle(0.05), position=(-0.1, 0), velocity=(20, 0))
    assert phases(world, 3, gate) == [None] * 3
    assert ball.vx == -20


@pytest.mark.parametrize("ticks", [1, 2, 3])
def test_what_is_passed_after_an_impact_is_noticed(ticks: int) -> None:
    """To the wall, back through the barrier, and away, all in one tick (or several)."""
    world = World()
    world.add(Wall((0, -1), (0, 1)), restitution=1.0)
    gate = world.add(Wall((-1.5, -1), (-1.5, 1)), sensor=True)
    world.add(Circle(0.05), position=(-0.1, 0), velocity=(200 / ticks, 0))
    passes = math.floor((0.05 + 1.4) / (200 / ticks) / DT)
    told = phases(world, 6, gate)
    assert told.index("begin") == passes
    assert told.index("end") == passes + 1
    assert told.count(None) == 4


def test_what_joints_pull_is_noticed_on_its_way() -> None:
    """A mass on a massless rod passes the lowest point after a quarter of its period, K(sin 1/2)/w,
    and is beyond within the same tick.
    """
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    bob = world.add(Circle(0.001), mass=1.0, position=(math.sin(1.0), -math.cos(1.0)))
    world.join(None, bob, Pin((0, 0)))
    gate = world.add(Wall((0, -0.9), (0, -1.1)), sensor=True)
    told = phases(world, 80, gate)
    mean, other = 1.0, math.cos(0.5)
    for _ in range(8):  # the arithmetic-geometric mean gives K = pi / (2 M(1, k'))
        mean, other = (mean + other) / 2.0, math.sqrt(mean * other)
    quarter = math.pi / (2.0 * mean) / math.sqrt(9.81 / (1.0 + 0.5 * 1e-6))
    assert told.index("begin") == math.floor(quarter / DT)
    assert told.count("begin") == math.floor((80 * DT / quarter + 1.0) / 2.0)
    assert told.count("end") == told.count("begin")


@pytest.mark.parametrize("shape", [Circle(0.5), Particle(0.5), Box(1, 1), Capsule(0.5, 0.25)])
def test_where_overlaps_are_moved_apart_counts_where_bodies_end(shape: Shape) -> None:
    """They are moved apart when the tick is over: what left a sensor by that has left it."""
    world = World()
    world.add(shape, kind="static", position=(0.6, 0))
    body = world.add(Polygon.regular(4, 0.5))
    world.add(Wall((0, -2), (0, 2)), name="gate", sensor=True)
    for _ in range(120):
        world.step()
        told = [c.phase for c in world.contacts if c.sensor and c.phase != "end"]
        right = max(corner.x for corner in body.vertices)
        assert bool(told) == (right >= 0.0)


@pytest.mark.parametrize("sensors", [0, 1])
def test_what_joints_hold_is_struck_alike_among_sensors(sensors: int) -> None:
    """The wall gives the two all their momentum: looking for what they sense in the middle of an
    impact wrote over its normal.
    """
    world = World()
    world.add(Wall((0, -3), (0, 3)), restitution=1.0)
    one = world.add(Box(0.5, 0.3, rounding=0.05), position=(-0.6, 0), angle=0.7, velocity=(9, 1))
    other = world.add(Capsule(0.5, 0.1), position=(-1.6, 0.2), velocity=(9, 1))
    world.join(one, other, Pin((-1.1, 0.1)))
    for i in range(4 * sensors):
        world.add(Capsule(0.4, 0.1), kind="static", position=(-1.9 + 0.5 * i, 0.5), sensor=True)
    given = [hit for _ in range(10) for hit in world.step()]
    assert given
    assert sum(hit.impulse.y for hit in given) == pytest.approx(0.0, abs=1e-12)
    assert world.momentum.y == pytest.approx(one.mass + other.mass, abs=1e-12)
    change = world.momentum.x - 9.0 * (one.mass + other.mass)
    assert sum(hit.impulse.x for hit in given) == pytest.approx(change, abs=1e-12)
