"""Billiards: a ball within walls that it meets without loss.

Between the walls it flies straight on, at each it leaves as it came (angle of reflection). In a
ring of links each blow is one on a straight wall: the path is that of a point within the ring that
is narrower by the radius of the ball. (Birkhoff, "Dynamical Systems", 1927, VI.)
"""

import math

import pytest

from engine import Chain, Circle, Particle, Shape, World

BALL = 0.05


def ring(links: int) -> list[tuple[float, float]]:
    turns = [2 * math.pi * i / links for i in range(links)]
    return [(math.cos(turn), math.sin(turn)) for turn in turns]


def reflections(links: int, x: float, y: float, vx: float, vy: float, count: int) -> list[float]:
    """Times of so many reflections of a point in the narrower ring (s)."""
    far = math.cos(math.pi / links) - BALL
    normals = [math.pi * (2 * i + 1) / links for i in range(links)]
    sides = [(math.cos(turn), math.sin(turn)) for turn in normals]
    times = []
    time = 0.0
    for _ in range(count):
        flight, side = min(
            ((far - x * nx - y * ny) / (vx * nx + vy * ny), (nx, ny))
            for nx, ny in sides
            if vx * nx + vy * ny > 1e-9
        )
        time += flight
        x, y = x + vx * flight, y + vy * flight
        out = 2 * (vx * side[0] + vy * side[1])
        vx, vy = vx - out * side[0], vy - out * side[1]
        times.append(time)
    return times


@pytest.mark.parametrize("shape", [Particle(BALL), Circle(BALL)])
@pytest.mark.parametrize("links", [12, 60])
def test_a_ball_is_reflected_a_hundred_times(shape: Shape, links: int) -> None:
    world = World()
    world.add(Chain(ring(links), loop=True), restitution=1.0, friction=0.0)
    ball = world.add(shape, position=(0.3, 0), velocity=(3, 6), restitution=1.0)
    start = world.kinetic_energy
    times: list[float] = []
    while len(times) < 100:
        times += [hit.time for hit in world.step()]
    assert times[:100] == pytest.approx(reflections(links, 0.3, 0, 3, 6, 100), abs=1e-9)
    assert world.kinetic_energy == pytest.approx(start, rel=1e-12)
    assert abs(ball.spin) < 1e-11


def test_a_stadium_keeps_the_energy_of_its_ball() -> None:
    """Two half rings and two straights (Bunimovich, 1979): chaotic, and without loss."""
    half = [math.pi * i / 40 - math.pi / 2 for i in range(41)]
    right = [(1 + math.cos(turn), math.sin(turn)) for turn in half]
    points = right + [(-x, -y) for x, y in right]
    world = World()
    world.add(Chain(points, loop=True), restitution=1.0)
    ball = world.add(Circle(BALL), position=(0.2, 0.1), velocity=(7, 3), restitution=1.0)
    start = world.kinetic_energy
    hits = sum(len(world.step()) for _ in range(600))
    assert hits > 30
    assert world.kinetic_energy == pytest.approx(start, rel=1e-12)
    assert abs(ball.y) < 1
    assert abs(ball.x) < 2
