"""What strikes a joined body strikes all that is joined to it, at the same instant."""

import random
from itertools import pairwise

import pytest

from engine import (
    Box,
    Circle,
    Distance,
    LinearDrag,
    Particle,
    Pin,
    Polygon,
    Slider,
    Wall,
    Weld,
    World,
)


@pytest.mark.parametrize("restitution", [1.0, 0.5, 0.2])
def test_a_ball_hits_a_rod_on_a_pivot(restitution: float) -> None:
    """J = (1 + e) v / (1/m + s^2/I) with I about the pivot (Goldstein, 5); the pivot answers.

    The rod's centre gets M w L/2, of which the ball gave J: the rest is the pivot's impulse, zero
    only at the centre of percussion s = 2 L/3.
    """
    world = World()
    length, mass, ball_mass, s, v = 1.2, 2.0, 1.0, 0.9, 3.0
    rod = world.add(
        Polygon.box(0.1, length), mass=mass, position=(0, -length / 2), restitution=restitution
    )
    pin = world.join(None, rod, Pin(at=(0, 0)))
    ball = world.add(Circle(0.1), mass=ball_mass, position=(-0.2, -s), velocity=(v, 0))
    collision = next(each for _ in range(10) for each in world.step())
    about_pivot = rod.inertia + mass * length * length / 4
    impulse = (1 + restitution) * v / (1 / ball_mass + s * s / about_pivot)
    assert abs(collision.impulse.x) == pytest.approx(impulse, rel=1e-9)
    assert ball.vx == pytest.approx(v - impulse / ball_mass, abs=1e-9)
    assert rod.spin == pytest.approx(impulse * s / about_pivot, rel=1e-7)
    answer = mass * rod.spin * length / 2 - impulse
    assert pin.force.x / 60 == pytest.approx(answer, abs=0.01 * impulse)  # and what turning takes


def test_a_ball_hits_a_row_of_joined_bodies() -> None:
    world = World()
    row = [world.add(Particle(0.1), position=(0, -i), mass=1 + i) for i in range(4)]
    for a, b in pairwise(row):
        world.join(a, b, Distance())
    world.add(Circle(0.1), position=(-1, 0.05), velocity=(2, 0), restitution=1.0, mass=2)
    momentum, turning, energy = world.momentum, world.angular_momentum, world.kinetic_energy
    assert sum(len(world.step()) for _ in range(60)) == 1
    assert world.momentum == pytest.approx(momentum, abs=1e-12)
    assert world.angular_momentum == pytest.approx(turning, abs=1e-12)
    assert world.kinetic_energy == pytest.approx(energy, rel=1e-4)


def test_a_jammed_chain_that_touches_a_wall_gains_no_energy() -> None:
    """Hardly anything yields where a taut chain is struck: an impulse that was found by division by
    what yields was a hundred times too large, and the chain gained 158 J in one tick.
    """
    world = World(gravity=(0, -9.81), integrator="velocity-verlet", drag=LinearDrag(0.1))
    world.add(Wall((-20, -3), (20, -3)), friction=0.5, restitution=0.3)
    dice = random.Random(1)
    before = None
    for i in range(6):
        x = 0.05 + 0.5 * i
        body = world.add(
            Polygon.box(0.5, 0.2),
            position=(0.3 + 0.5 * i, 0),
            mass=dice.uniform(0.5, 2),
            restitution=0.5,
            friction=0.4,
        )
        turning = Pin(at=(x, 0), motor_speed=2.0, max_torque=1.0)
        rod = Distance((x - 0.2 if before else 0, 0), (x + 0.2, 0))
        world.join(before, body, [Pin(at=(x, 0)), turning, rod][(i + 1) % 3 if i else 0])
        before = body
    world.add(Circle(0.3), position=(1, 3), velocity=(0.2, -3), restitution=0.8)
    energy = world.kinetic_energy + world.potential_energy
    for _ in range(80):
        world.step()
        now = world.kinetic_energy + world.potential_energy
        assert now < energy + 0.2  # two motors of 1 N m at 2 rad/s give 0.07 J a tick at most
        energy = now


JAMS = [
    (
        [
            (0.2, 0.3, 1.0, -0.6, 1.4, 2.0),
            (0.3, 0.3, 1.0, 0.0, 1.8, 2.1),
            (0.5, 0.1, 5.0, -0.5, 1.5, 0.8),
        ],
        [(2, 1, "slider"), (1, 0, "slider")],
    ),
    (
        [
            (0.4, 0.2, 0.02, 0.5, 1.3, -1.5),
            (0.7, 0.1, 1.0, 0.2, 1.1, 0.3),
            (0.7, 0.3, 1.0, 0.3, 1.1, 2.1),
            (0.5, 0.2, 0.2, 0.5, 1.7, 1.8),
        ],
        [(3, 1, "weld"), (3, 2, "weld")],
    ),
    (
        [
            (0.3, 0.3, 5.0, 0.1, 1.4, -2.8),
            (0.7, 0.1, 5.0, 0.3, 1.5, 0.9),
            (0.3, 0.1, 1.0, -0.4, 1.7, -1.2),
            (0.7, 0.2, 0.02, -0.2, 1.9, 2.1),
        ],
        [(2, 0, "pin"), (1, 2, "weld")],
    ),
    (
        [
            (0.6, 0.2, 5.0, -0.4, 1.9, 0.8),
            (0.4, 0.2, 5.0, -0.4, 1.6, -1.4),
            (0.8, 0.2, 0.2, -0.2, 0.9, 1.3),
            (0.3, 0.2, 1.0, -0.5, 1.5, 2.0),
        ],
        [(1, 3, "weld"), (3, 2, "weld"), (2, 0, "weld")],
    ),
]


@pytest.mark.parametrize(("boxes", "joints"), JAMS)
def test_boxes_joined_where_they_overlap_gain_no_energy_as_they_land(
    boxes: list[tuple[float, ...]], joints: list[tuple[int, int, str]]
) -> None:
    """What joints press together presses back, all through a part of a tick: velocities within it
    are not those that joints allow. An impact that took them for such gained up to 14 times what
    lifts all boxes by a metre.
    """
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    world.add(Wall((-30, 0), (30, 0)), friction=0.4)
    bodies = [
        world.add(Box(width, height), mass=mass, position=(x, y), angle=angle, friction=0.4)
        for width, height, mass, x, y, angle in boxes
    ]
    for first, second, kind in joints:
        a, b = bodies[first], bodies[second]
        middle = ((a.x + b.x) / 2, (a.y + b.y) / 2)
        slider = Slider(axis=(1, 0.3), limits=(-0.5, 0.5))
        world.join(a, b, {"pin": Pin(at=middle), "weld": Weld(middle), "slider": slider}[kind])
    start = world.ledger()
    most = 0.0
    for _ in range(150):
        world.step()
        now = world.ledger()
        most = max(most, now.kinetic + now.potential - start.kinetic - start.potential)
    assert most < 1e-3 * 9.81 * sum(body.mass for body in bodies)
    assert world.ledger().energy_error == pytest.approx(0.0, abs=1e-7)
