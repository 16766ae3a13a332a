"""Trees of hinged bodies: struck, whipping, and with many hinges on one body."""

import math
from itertools import pairwise

import pytest

from engine import Body, Circle, Pin, Polygon, World

G = 9.81


def energy(world: World) -> float:
    return world.kinetic_energy + world.potential_energy


def row_of_rods(world: World, count: int, length: float, mass: float, down: bool) -> list[Body]:
    """Rods hinged end to end, the first to the origin of the world: to the right, or downwards."""
    x, y = (0.0, -length) if down else (length, 0.0)
    angle = -math.pi / 2 if down else 0.0
    rods: list[Body] = []
    for i in range(count):
        at = ((i + 0.5) * x, (i + 0.5) * y)
        shape = Polygon.box(length, 1e-4)
        rods.append(world.add(shape, mass=mass, position=at, angle=angle, restitution=0.5))
        world.join(rods[i - 1] if i else None, rods[i], Pin(at=(i * x, i * y)))
    return rods


def test_a_ball_hits_the_end_of_a_double_rod() -> None:
    """J = (1 + e) v / (1/m + g M^-1 g): M the masses of the two angles, g = (L, L) the arms of the
    end (Lagrange's equations of the double pendulum, hanging straight; Goldstein, 1.6).
    """
    world = World()
    length, mass, ball_mass, v, e = 0.8, 1.5, 0.7, 2.0, 0.5
    rods = row_of_rods(world, 2, length, mass, True)
    y = -2 * length + 1e-9
    ball = world.add(Circle(0.1), mass=ball_mass, position=(-0.2, y), velocity=(v, 0))
    ball.restitution = e
    collision = next(each for _ in range(10) for each in world.step())
    own = [rod.inertia for rod in rods]
    m11 = own[0] + mass * length**2 / 4 + mass * length**2
    m12 = mass * length**2 / 2
    m22 = own[1] + mass * length**2 / 4
    yields = length**2 * (m22 - 2 * m12 + m11) / (m11 * m22 - m12**2)
    impulse = (1 + e) * v / (1 / ball_mass + yields)
    assert abs(collision.impulse.x) == pytest.approx(impulse, rel=1e-7)
    assert ball.vx == pytest.approx(v - impulse / ball_mass, rel=1e-7)


def test_friction_pulls_at_a_rod_that_its_hinge_holds() -> None:
    """Along a hanging rod nothing yields but the ball: it rolls off with w r/3 (I = m r^2/2)."""
    world = World()
    rod = row_of_rods(world, 1, 1.0, 2.0, True)[0]
    rod.friction = 10.0
    ball = world.add(
        Circle(0.1), mass=0.5, position=(-0.2, -0.5), velocity=(1, 0), spin=6, friction=10
    )
    collision = next(each for _ in range(20) for each in world.step())
    assert abs(collision.impulse.y) == pytest.approx(0.5 * 0.1 * 6.0 / 3, rel=1e-4)
    assert ball.spin == pytest.approx(6.0 / 3, rel=1e-4)
    assert abs(ball.vy) == pytest.approx(6.0 * 0.1 / 3, rel=1e-4)


@pytest.mark.parametrize("at", [0.5, 0.9, 1.3])
def test_a_box_that_lands_flat_on_a_hinged_plank_keeps_the_energy(at: float) -> None:
    """Both points leave as fast as they came, which takes both impulses through the hinge."""
    world = World()
    plank = world.add(Polygon.box(2, 0.1), mass=3, position=(1, 0), restitution=1.0)
    world.join(None, plank, Pin(at=(0, 0)))
    world.add(Polygon.box(0.6, 0.3), mass=1, position=(at, 0.3), velocity=(0, -2), restitution=1.0)
    before = world.kinetic_energy
    hits = []
    while not hits:
        hits = world.step()
    assert len(hits) == 1
    assert world.kinetic_energy == pytest.approx(before, rel=1e-6)
    assert world.ledger().energy_error == pytest.approx(0, abs=1e-12)


def test_a_whipping_chain_keeps_its_way_with_one_substep() -> None:
    """Parts follow the waves along the chain, however few substeps are asked for."""
    world = World(gravity=(0, -G), integrator="velocity-verlet", substeps=1)
    rods = row_of_rods(world, 40, 0.4, 0.04, False)
    start, scale = energy(world), 40 * 0.04 * G * 8
    fastest = 0.0
    for _ in range(150):
        world.step()
        fastest = max(fastest, *(abs(rod.spin) for rod in rods))
        assert abs(energy(world) - start) < 2e-3 * scale
    assert max(math.dist(*joint.anchors) for joint in world.joints) < 1e-8
    assert fastest > 5


def test_a_hub_of_many_spokes_keeps_momentum_and_energy() -> None:
    world = World()
    hub = world.add(Circle(0.5), mass=2, velocity=(0.3, 0.1), spin=1.0)
    spokes = []
    for i in range(30):
        turn = 2 * math.pi * i / 30
        x, y = math.cos(turn), math.sin(turn)
        at = (0.8 * x, 0.8 * y)
        spokes.append(world.add(Polygon.box(0.6, 0.02), mass=0.2, position=at, angle=turn))
        world.join(hub, spokes[-1], Pin(at=(0.5 * x, 0.5 * y)))
    for a, b in pairwise([*spokes, spokes[0]]):
        world.ignore(a, b)
    spokes[0].spin = 3.0
    world.step()
    momentum, turning, kinetic = world.momentum, world.angular_momentum, world.kinetic_energy
    for _ in range(60):
        world.step()
    assert world.momentum == pytest.approx(momentum, abs=1e-12)
    assert world.angular_momentum == pytest.approx(turning, abs=1e-12)
    assert world.kinetic_energy == pytest.approx(kinetic, rel=1e-4)
    assert max(math.dist(*joint.anchors) for joint in world.joints) < 1e-9
