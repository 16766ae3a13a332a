"""Joints without motors bring no energy, however they are mixed: pins with limits, welds, rods,
ropes, sliders and springs between bodies of which some weigh 250 times as much as others.

Gravity alone does work: what bodies have as kinetic and potential energy, that of springs included,
never exceeds what they had at rest (d'Alembert: ideal constraints do no work; limits and ropes that
stop something take energy). It did, up to a thousand times over, for four reasons. A limit that
would pull was let go of only after a step of Newton's method that made it pull: the step led far
away, and no solution was found. A rope that was too long after such a part of a tick was shortened
within the next as if by a winch, and what it pulled flew on. Impulses that were in balance, as two
joints say nearly the same, were begun with where bodies had turned. And springs exerted nothing for
as long as no solution was found, while they were stretched.
"""

import math
import random

import pytest

from engine import Body, Box, Distance, Joint, Pin, Rope, Slider, Spring, Weld, World

G = 9.81


def mixed(seed: int, springs: bool) -> tuple[World, list[Joint]]:
    """Boxes at rest, anywhere, with joints between them that hold as they are; nothing touches."""
    dice = random.Random(seed)
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    boxes: list[Body] = []
    for _ in range(dice.randrange(3, 14)):
        size = (dice.uniform(0.2, 0.8), dice.uniform(0.05, 0.3))
        at = (dice.uniform(-2, 2), dice.uniform(-2, 2))
        mass = dice.choice([5, 1, 0.2, 0.02])
        box = world.add(Box(*size), mass=mass, position=at, angle=dice.uniform(-3, 3), mask=0)
        boxes.append(box)
    joints: list[Joint] = []
    for _ in range(dice.randrange(2, 2 * len(boxes))):
        a, b = dice.choice([None, *boxes]), dice.choice(boxes)
        end = (b.x + dice.uniform(-1, 1), b.y + dice.uniform(-1, 1)) if a is None else a.position
        middle = ((end[0] + b.x) / 2, (end[1] + b.y) / 2)
        ends = {"anchor_a": end, "anchor_b": b.position}
        kinds = [
            Pin(at=middle), Pin(at=middle, limits=(-0.5, 0.5)), Weld(at=middle), Distance(**ends),
            Rope(**ends), Slider(axis=(1, 0.3), at=middle, limits=(-0.5, 0.5)),
            Spring(dice.choice([10, 1000]), dice.choice([0, 1]), **ends),
        ]  # fmt: skip
        spec = dice.choice(kinds if springs else kinds[:6])
        if a is not b:
            joints.append(world.join(a, b, spec))
    return world, joints


def energy(world: World, joints: list[Joint]) -> float:
    """Kinetic and potential energy, that of springs included (J)."""
    total = world.kinetic_energy + world.potential_energy
    for joint in joints:
        if joint.kind is Spring:
            stretched = math.dist(*joint.anchors) - joint.length
            total += joint.stiffness * stretched * stretched / 2
    return total


def gained(seed: int, springs: bool) -> float:
    """The most that is gained in four seconds, as a share of what lifts all boxes by 3 m."""
    world, joints = mixed(seed, springs)
    scale = sum(box.mass for box in world) * G * 3
    first = energy(world, joints)
    most = 0.0
    for _ in range(240):
        world.step()
        most = max(most, energy(world, joints) - first)
    return most / scale


@pytest.mark.parametrize("seed", [233, 358, 322, 161])
def test_joints_bring_no_energy(seed: int) -> None:
    assert gained(seed, springs=False) < 1e-3


@pytest.mark.parametrize("seed", [43, 267, 275, 221])
def test_nor_do_springs_beyond_what_is_stored_in_them(seed: int) -> None:
    assert gained(seed, springs=True) < 1e-3


def test_what_a_rope_is_shortened_to_comes_to_rest_there() -> None:
    """A winch that pulls by 10 cm at once: the rope can only pull, but took what it pulled along
    as fast as that, for ever.
    """
    world = World(integrator="velocity-verlet")
    load = world.add(Box(0.4, 0.2), position=(2, 0))
    rope = world.join(None, load, Rope(anchor_a=(0, 0)))
    rope.length = 1.9
    for _ in range(10):
        world.step()
        assert load.x == pytest.approx(1.9, abs=1e-8)
        assert load.speed == pytest.approx(0.0, abs=1e-12)
