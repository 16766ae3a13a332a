"""Impacts against closed forms: restitution, rotation, several bodies, time and place."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine import Circle, Collision, Particle, Pin, Polygon, Wall, World

G = 9.81


def until_impact(world: World, ticks: int = 600) -> list[Collision]:
    for _ in range(ticks):
        collisions = world.step()
        if collisions:
            return collisions
    raise AssertionError("nothing collided")


@given(
    m1=st.floats(0.1, 100),
    m2=st.floats(0.1, 100),
    u1=st.floats(0.5, 30),
    u2=st.floats(-30, 0),
    e=st.one_of(st.just(0.0), st.floats(1e-6, 1)),
    kind=st.sampled_from([Circle, Particle]),
)
@settings(max_examples=40, deadline=None)
def test_head_on(m1: float, m2: float, u1: float, u2: float, e: float, kind: type) -> None:
    """v1' = (m1 u1 + m2 u2 + m2 e (u2 - u1)) / (m1 + m2), and the energy that is lost."""
    world = World()
    a = world.add(kind(0.5), mass=m1, position=(0, 0), velocity=(u1, 0), restitution=e)
    b = world.add(kind(0.5), mass=m2, position=(3, 0), velocity=(u2, 0))
    before = world.kinetic_energy
    (collision,) = until_impact(world)
    v1 = (m1 * u1 + m2 * u2 + m2 * e * (u2 - u1)) / (m1 + m2)
    v2 = (m1 * u1 + m2 * u2 + m1 * e * (u1 - u2)) / (m1 + m2)
    assert a.vx == pytest.approx(v1, rel=1e-9, abs=1e-9)
    assert b.vx == pytest.approx(v2, rel=1e-9, abs=1e-9)
    lost = 0.5 * m1 * m2 / (m1 + m2) * (1 - e * e) * (u1 - u2) ** 2
    assert before - world.kinetic_energy == pytest.approx(lost, rel=1e-9, abs=1e-9 * before)
    assert collision.a is a
    assert collision.b is b
    assert collision.normal == pytest.approx((1, 0))
    assert collision.impulse.x == pytest.approx(m2 * (v2 - u2), rel=1e-9)
    assert collision.speed == pytest.approx(u1 - u2, rel=1e-9)
    assert collision.restitution == e
    assert collision.time == pytest.approx(2 / (u1 - u2), abs=1e-9)
    assert collision.point.x == pytest.approx(u1 * collision.time + 0.5, abs=1e-9)


@pytest.mark.parametrize("kind", [Circle, Particle])
def test_ball_hits_free_rod(kind: type) -> None:
    """1 kg at 3 m/s, 1 m from the centre of a free rod of 1 kg and 3 m: physics.md."""
    world = World()
    rod = world.add(Polygon.box(0.02, 3), mass=1, inertia=1 * 3 * 3 / 12)
    ball = world.add(kind(0.1), mass=1, position=(-1, 1), velocity=(3, 0), restitution=1)
    (collision,) = until_impact(world)
    assert math.dist(collision.impulse, (0, 0)) == pytest.approx(1.8, abs=1e-9)
    assert ball.vx == pytest.approx(1.2, abs=1e-9)
    assert rod.vx == pytest.approx(1.8, abs=1e-9)
    assert abs(rod.spin) == pytest.approx(2.4, abs=1e-9)


@pytest.mark.parametrize(
    ("degrees", "speed", "spin"), [(15, 0.428571, 7.273098), (30, 1.995995, 5.485984)]
)
@pytest.mark.parametrize("mirrored", [1, -1])
def test_turned_square_on_the_floor(
    degrees: float, speed: float, spin: float, mirrored: int
) -> None:
    """Thesis, eq. 40, with m = 1, I = 1/6, e = 1: figures of physics.md."""
    world = World()
    world.add(Wall((-5, 0), (5, 0)))
    angle = math.radians(degrees) * mirrored
    box = world.add(Polygon.box(1, 1), position=(0, 2), velocity=(0, -3), angle=angle)
    box.restitution = 1.0
    until_impact(world)
    assert box.vy == pytest.approx(speed, abs=5e-7)
    assert abs(box.spin) == pytest.approx(spin, abs=5e-7)
    assert box.kinetic_energy == pytest.approx(4.5, rel=1e-12)


@given(
    sides=st.integers(3, 9),
    angle=st.floats(0, 6.28),
    e=st.floats(0, 1),
    vx=st.floats(-3, 3),
    spin=st.floats(-4, 4),
    mass=st.floats(0.1, 50),
)
@settings(max_examples=40, deadline=None)
def test_equation_40(
    sides: int, angle: float, e: float, vx: float, spin: float, mass: float
) -> None:
    """P = -(1 + e) v_n / (1/m + (r x n)^2 / I) at the one corner that hits."""
    world = World()
    world.add(Wall((-20, 0), (20, 0)))
    body = world.add(
        Polygon.regular(sides, 0.7),
        mass=mass,
        position=(0, 1.5),
        velocity=(vx, -8),
        angle=angle,
        spin=spin,
        restitution=e,
    )
    collision = until_impact(world)[0]
    dt = collision.time  # where and how fast it was then, by the first law
    x, y = vx * dt, 1.5 - 8 * dt
    arm = collision.point.x - x
    k = 1 / mass + arm * arm / body.inertia
    approach = 8 - spin * arm
    assert collision.point.y == pytest.approx(0, abs=1e-8)
    assert y > 0
    if collision.impulse.y == pytest.approx((1 + e) * approach / k, rel=1e-9):
        assert collision.speed == pytest.approx(approach, rel=1e-9)
    else:  # a side that landed flat: between its two corners
        assert sorted(v.y for v in body.vertices)[1] < 0.05


def test_side_that_lands_flat_does_not_start_to_spin() -> None:
    world = World()
    world.add(Wall((-5, 0), (5, 0)))
    box = world.add(Polygon.box(2, 1), position=(0, 2), velocity=(0, -3), restitution=0.5)
    (collision,) = until_impact(world)
    assert box.velocity == pytest.approx((0, 1.5), abs=1e-12)
    assert box.spin == pytest.approx(0, abs=1e-12)
    assert collision.point.x == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("elsewhere", [False, True])
@pytest.mark.parametrize("tilt", [0.003, 0.012])
@pytest.mark.parametrize("speed", [3.0, 8.0, 12.0])
def test_ends_of_a_plate_land_one_after_the_other(
    speed: float, tilt: float, elsewhere: bool
) -> None:
    """A plate falls flat, but for a small angle, without weight and restitution: the blow at one
    end (eq. 40) turns it about that end, so the other comes down at an instant of its own; both
    ends together then stop it, and it lies flat. What moves elsewhere changes nothing.
    """
    world = World()
    world.add(Wall((-50, 0), (50, 0)))
    if elsewhere:  # joints cut a tick into parts
        one = world.add(Circle(0.1), position=(10, 5), velocity=(0, 1))
        world.join(one, world.add(Circle(0.1), position=(11, 5)), Pin(at=(10.5, 5)))
    height = 0.05 * math.cos(tilt) + math.sin(tilt)
    plate = world.add(
        Polygon.box(2, 0.1),
        mass=1,
        position=(0, height + speed * 0.0005),
        angle=tilt,
        velocity=(0, -speed),
    )
    hits = world.step() + world.step()
    arm = math.cos(tilt) - 0.05 * math.sin(tilt)
    blow = speed / (1 + arm * arm / plate.inertia)
    spin = -arm * blow / plate.inertia

    def other_end(time: float) -> float:
        angle = tilt + spin * time
        sunk = (speed - blow) * time
        return height - sunk + math.sin(angle) - 0.05 * math.cos(angle)

    early, late = 0.0, 0.02
    for _ in range(60):
        middle = (early + late) / 2
        early, late = (middle, late) if other_end(middle) > 0 else (early, middle)
    assert [hit.time for hit in hits] == pytest.approx([0.0005, 0.0005 + early], abs=1e-12)
    assert [hit.impulse.y for hit in hits] == pytest.approx([blow, speed - blow], rel=1e-9)
    assert plate.speed + abs(plate.spin) < 1e-12
    assert abs(plate.angle) < tilt * tilt  # the first end rose by the square of the turn


def test_grazing_impact_of_a_spinning_disc_obeys_coulomb() -> None:
    """Sliding: tangential impulse mu P; v_x' = v_x - mu (1 + e) v_n, spin by 2 / r of it."""
    world = World()
    world.add(Wall((-50, 0), (50, 0)), friction=0.2)
    disc = world.add(Circle(0.5), position=(0, 1), velocity=(10, -2), restitution=0.5, friction=0.2)
    until_impact(world)
    assert disc.vx == pytest.approx(10 - 0.2 * 3)
    assert disc.vy == pytest.approx(1)
    assert disc.spin == pytest.approx(-0.2 * 3 * 2 / 0.5)


def test_gripping_impact_of_a_disc() -> None:
    """Enough friction: the point of contact stops; a third of the sliding goes, 2/3 v_x stay."""
    world = World()
    world.add(Wall((-50, 0), (50, 0)), friction=1.0)
    disc = world.add(Circle(0.5), position=(0, 1), velocity=(1, -4), friction=1.0)
    until_impact(world)
    assert disc.vx == pytest.approx(2 / 3)
    assert disc.vx + disc.spin * 0.5 == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("kind", [Circle, Particle])
@pytest.mark.parametrize("e", [0.3, 0.5, 0.9, 0.95])
@pytest.mark.parametrize("substeps", [1, 6])
def test_drop(kind: type, e: float, substeps: int) -> None:
    """The n-th rebound reaches e^(2n) h; all bouncing ends at sqrt(2h/g)(1 + e)/(1 - e)."""
    h = 1.0
    world = World(gravity=(0, -G), integrator="velocity-verlet", substeps=substeps)
    world.add(Wall((-5, 0), (5, 0)))
    ball = world.add(kind(0.1), position=(0, h + 0.1), restitution=e)
    impacts: list[Collision] = []
    end = math.sqrt(2 * h / G) * (1 + e) / (1 - e)
    while world.time < min(end + 0.5, 12.0):
        impacts += world.step()
    for n, impact in enumerate(impacts[:10]):
        height = impact.speed**2 / (2 * G)
        assert height == pytest.approx(e ** (2 * n) * h, rel=1e-3)
        if n < 5:
            fall = math.sqrt(2 * h / G)
            when = fall * (1 + 2 * sum(e**k for k in range(1, n + 1)))
            assert impact.time == pytest.approx(when, abs=1e-6)
    if end < 11:  # a flight shorter than a substep is none
        assert impacts[-1].time == pytest.approx(end, abs=1.2 / 60 / substeps / (1 - e))
        assert ball.speed < 1e-6
        assert ball.y == pytest.approx(0.1, abs=1e-3)


@pytest.mark.parametrize("shape", [Circle(0.1), Polygon.box(0.2, 0.2)])
def test_a_perfectly_elastic_ball_bounces_for_ever(shape: Circle | Polygon) -> None:
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-5, 0), (5, 0)))
    ball = world.add(shape, position=(0, 1.1), restitution=1.0)
    energy = world.kinetic_energy + world.potential_energy
    for _ in range(6000):
        world.step()
        assert ball.y > 0.1 - 1e-9
    assert world.kinetic_energy + world.potential_energy == pytest.approx(energy, rel=1e-9)


@pytest.mark.parametrize("integrator", ["semi-implicit-euler", "explicit-euler"])
def test_an_elastic_ball_gains_no_height_from_a_coarse_integrator(integrator: str) -> None:
    world = World(gravity=(0, -G), integrator=integrator)
    world.add(Wall((-5, 0), (5, 0)))
    world.add(Circle(0.1), position=(0, 1.1), restitution=1.0)
    speeds = [c.speed for _ in range(1200) for c in world.step()]
    assert len(speeds) > 20
    assert speeds == pytest.approx([speeds[0]] * len(speeds), rel=1e-9)


@pytest.mark.parametrize("kind", [Circle, Particle])
def test_newtons_cradle(kind: type) -> None:
    """Touching balls, one pair after the other, the fastest first: the last takes all."""
    world = World()
    row = [world.add(kind(0.1), position=(0.2 * i, 0), restitution=1) for i in range(5)]
    world.add(kind(0.1), position=(-1, 0), velocity=(2, 0), restitution=1)
    collisions = [c for _ in range(60) for c in world.step()]
    assert row[-1].vx == pytest.approx(2, rel=1e-12)
    assert [ball.vx for ball in row[:-1]] == pytest.approx([0] * 4, abs=1e-12)
    assert len(collisions) == 5


@pytest.mark.parametrize(("ratio", "impacts"), [(1, 3), (100, 31), (10_000, 314)])
def test_galperins_blocks_count_pi(ratio: float, impacts: int) -> None:
    """G. Galperin, "Playing pool with pi", 2003."""
    world = World()
    world.add(Wall((0, -1), (0, 1)))
    world.add(Particle(0.1), position=(1, 0), mass=1, restitution=1)
    world.add(Particle(0.1), position=(3, 0), mass=ratio, velocity=(-5, 0), restitution=1)
    assert sum(len(world.step()) for _ in range(300)) == impacts


def test_mass_goes_through_heavy_and_light() -> None:
    """Equal masses swap; a wall-like mass sends a light one back at twice its own speed."""
    world = World()
    light = world.add(Particle(0.1), mass=1e-3, position=(1, 0), restitution=1)
    heavy = world.add(Particle(0.1), mass=1e6, velocity=(1, 0), restitution=1)
    until_impact(world)
    assert light.vx == pytest.approx(2, rel=1e-8)
    assert heavy.vx == pytest.approx(1, rel=1e-8)


@pytest.mark.parametrize("e", [0.0, 0.4, 1.0])
def test_rules_of_a_world_may_be_replaced(e: float) -> None:
    world = World(restitution_rule=lambda a, b: a * b, friction_rule=lambda a, b: a + b)
    a = world.add(Circle(0.5), velocity=(1, 0), restitution=1.0)
    world.add(Circle(0.5), position=(2, 0), restitution=e)
    (collision,) = until_impact(world)
    assert collision.restitution == e
    assert a.vx == pytest.approx((1 - e) / 2)
