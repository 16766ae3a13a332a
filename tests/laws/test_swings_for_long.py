"""Linkages that swing for minutes keep their energy, and find their way back.

A double pendulum has no other closed form than its energy, which parts of one length keep (Hairer,
Lubich & Wanner, *Geometric Numerical Integration*, 2006, IX.3); its small swings do (Goldstein,
*Classical Mechanics*, 6.4).
"""

import math

import pytest

from engine import Body, Box, Pin, World

G = 9.81


def hang(angles: tuple[float, ...], length: float = 1.0) -> tuple[World, list[Body]]:
    """Thin rods of 1 kg, pinned end to end below the origin; angles from the vertical (rad)."""
    world = World(gravity=(0, -G), kernels="compiled")
    x = y = 0.0
    above = None
    rods = []
    for angle in angles:
        along = (length * math.sin(angle), -length * math.cos(angle))
        middle = (x + along[0] / 2, y + along[1] / 2)
        rod = world.add(
            Box(length, 1e-6), mass=1.0, position=middle, angle=angle - math.pi / 2, mask=0
        )
        world.join(above, rod, Pin(at=(x, y)))
        x, y = x + along[0], y + along[1]
        above = rod
        rods.append(rod)
    return world, rods


def energy(world: World) -> float:
    return world.kinetic_energy + world.potential_energy


@pytest.mark.parametrize(
    "angles", [(2.8,), (1.0, 1.0), (2.0, 2.5), (2.5, 3.0, 1.0), (1.5, 1.4, 1.3, 1.2, 1.1)]
)
@pytest.mark.parametrize("length", [1.0, 0.2])
def test_energy_after_ten_minutes(angles: tuple[float, ...], length: float) -> None:
    """Within 0.2 % of what lifts all by its length; it is lost in the first minute, if at all."""
    world, _ = hang(angles, length)
    start = energy(world)
    weight = G * length * len(angles) ** 2
    errors = []
    for _ in range(10):
        world.run(60 * 60)
        errors.append((energy(world) - start) / weight)
    assert max(map(abs, errors)) < 2e-3
    assert max(errors[1:]) - min(errors[1:]) < 1e-3


@pytest.mark.parametrize(("sign", "phase"), [(-1, 1e-4), (1, 3e-4)])
def test_small_swings_of_two_rods_keep_period_and_amplitude(sign: int, phase: float) -> None:
    """w^2 = (3 -+ 6/sqrt 7) g/L: eigenvalues of (4/3, 1/2; 1/2, 1/3) against (3/2, 0; 0, 1/2)."""
    square = 3 + sign * 6 / math.sqrt(7)
    ratio = (3 - 8 / 3 * square) / square
    world, rods = hang((0.01, 0.01 * ratio))
    frequency = math.sqrt(square * G)
    world.run(60 * 60)
    x, rate = rods[0].angle + math.pi / 2, rods[0].spin / frequency
    late = (math.atan2(-rate, x) - frequency * world.time + math.pi) % (2 * math.pi) - math.pi
    assert abs(late) < phase * frequency * world.time
    assert math.hypot(x, rate) == pytest.approx(0.01, rel=2e-3)


def test_time_reversed_they_return() -> None:
    """Equal parts are the same forwards and backwards (VIII.1)."""
    world, rods = hang((0.9, 1.2))
    world.run(600)
    poses = [(*rod.position, rod.angle) for rod in rods]
    for _ in range(2):
        world.run(300)
        for rod in rods:
            rod.velocity = -rod.velocity
            rod.spin = -rod.spin
    for rod, pose in zip(rods, poses, strict=True):
        assert (*rod.position, rod.angle) == pytest.approx(pose, abs=1e-9)


@pytest.mark.parametrize("spin", [10, 60, 200])
def test_a_flail_in_free_flight_keeps_its_energy(spin: float) -> None:
    """Two light rods on a heavy one that nothing holds, turning fast: for a minute."""
    world = World(integrator="velocity-verlet", kernels="compiled")
    rods = [
        world.add(Box(1, 0.1), mass=20, group=1),
        world.add(Box(1, 0.1), mass=1, position=(1, 0), spin=spin, velocity=(0, spin / 2), group=1),
        world.add(
            Box(0.5, 0.1), mass=1, position=(1.75, 0), spin=-spin, velocity=(0, spin / 2), group=1
        ),
    ]
    world.join(rods[0], rods[1], Pin(at=(0.5, 0)))
    world.join(rods[1], rods[2], Pin(at=(1.5, 0)))
    world.step()
    before = world.kinetic_energy
    for _ in range(60):
        world.run(60)
        assert world.kinetic_energy == pytest.approx(before, rel=1e-3)
