"""What sticks and slips by turns, belts that start and stop, and pairs of materials.

A block on a spring that is drawn along at u slips when the spring pulls with mu_s N, and then
swings about mu_k N: with A = (mu_s - mu_k) m g/k and w^2 = k/m it slips for
(2 pi - 2 atan(A w/u))/w and sticks for 2 A/u (Den Hartog, "Mechanical Vibrations",
1956, par. 7.5).
"""

import math

import pytest

from engine import Box, Spring, Wall, World

G = 9.81


def still_world() -> World:
    return World(gravity=(0, -G), integrator="velocity-verlet")


@pytest.mark.parametrize(
    ("grip", "rubs", "speed", "stiffness"),
    [(0.5, 0.3, 0.1, 20.0), (0.6, 0.2, 0.2, 30.0), (0.4, 0.35, 0.05, 100.0)],
)
def test_a_block_on_a_spring_sticks_and_slips(
    grip: float, rubs: float, speed: float, stiffness: float
) -> None:
    world = still_world()
    world.add(Wall((-5, 0), (50, 0)), friction=1.0)
    block = world.add(
        Box(0.4, 0.2), mass=1.0, position=(0, 0.1), friction=rubs**2, static_friction=grip**2
    )
    hand = world.add(Box(0.1, 0.1), kind="kinematic", position=(2, 0.1), velocity=(speed, 0))
    world.join(
        hand,
        block,
        Spring(stiffness=stiffness, anchor_a=(2, 0.1), anchor_b=(0, 0.1), length=2.0),
    )
    begins = []
    slips = False
    while len(begins) < 5:
        world.step()
        if block.vx > 1e-6 and not slips:
            begins.append(world.time)
        slips = block.vx > 1e-6
    rate = math.sqrt(stiffness)
    excess = (grip - rubs) * G / stiffness
    slipping = (2 * math.pi - 2 * math.atan(excess * rate / speed)) / rate
    period = slipping + 2 * excess / speed
    assert (begins[-1] - begins[0]) / 4 == pytest.approx(period, abs=1 / 60 / 4 + 5e-3)


def test_a_belt_starts_and_stops() -> None:
    """A crate slips until it has the belt's speed, and again until it stops: u^2/(2 mu g) each."""
    world = still_world()
    belt = world.add(Box(40, 1), kind="static", position=(0, -0.5), friction=0.4)
    crate = world.add(Box(0.5, 0.5), position=(-10, 0.25), friction=0.4)
    world.run(30)
    assert crate.vx == 0.0
    belt.surface_speed = -2.0
    world.run(120)
    lag = 4 / (2 * 0.4 * G)
    assert crate.vx == pytest.approx(2.0, abs=1e-9)
    assert crate.x + 10 == pytest.approx(4.0 - lag, abs=1e-4)
    belt.surface_speed = 0.0
    place = crate.x
    world.run(120)
    assert crate.vx == 0.0
    assert crate.x - place == pytest.approx(lag, abs=1e-4)


def test_pairs_of_materials_brake_and_bounce_by_their_own_rules() -> None:
    """Three blocks on one floor: two pairs with coefficients of their own, one by the bodies'."""
    world = still_world()
    world.set_material_pair("rubber", "ice", friction=0.05, restitution=0.9)
    world.set_material_pair("steel", "ice", friction=0.02, restitution=0.2)
    world.add(Wall((-50, 0), (50, 0)), material="ice", friction=0.7, restitution=0.5)
    kinds = (("rubber", 0.05, 0.9), ("steel", 0.02, 0.2), (None, 0.7, 0.5))
    slide, drop = [], []
    for i, (material, _, _) in enumerate(kinds):
        slide.append(
            world.add(
                Box(0.4, 0.4),
                position=(-20, 0.2) if i == 0 else (10 * i - 15, 0.2),
                velocity=(2, 0),
                material=material,
                friction=0.7,
            )
        )
        drop.append(
            world.add(Box(0.2, 0.2), position=(-30 - 2 * i, 1.1), material=material, friction=0.7)
        )
    starts = [block.x for block in slide]
    bounces: list[float] = []
    for _ in range(60):
        for hit in world.step():
            if hit.b in drop and len(bounces) < 3:
                bounces.append(hit.impulse.y / (hit.b.mass * hit.speed) - 1)
    for i, (_, mu, e) in enumerate(kinds):
        stops = min(1.0, 2 / (mu * G))
        way = 2 * stops - mu * G * stops**2 / 2
        assert slide[i].x - starts[i] == pytest.approx(way, rel=1e-3)
        assert bounces[i] == pytest.approx(e, rel=1e-9)
