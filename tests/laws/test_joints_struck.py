"""What strikes a joined body strikes all that is joined to it, at the same instant."""

from itertools import pairwise

import pytest

from engine import Circle, Distance, Particle, Pin, Polygon, World


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
