"""Joints that were torn apart by hand pull their bodies together, and do not throw them.

They closed within a part of a tick, at a thousand metres a second: a doll whose arm was put three
metres away had 260,000 J.
"""

import math

import pytest

from engine import Body, Box, Joint, Pin, Wall, Weld, World

G = 9.81
Limits = tuple[float, float] | None


def doll(limits: Limits) -> tuple[World, list[Body], list[Joint]]:
    """Three hinged planks of 1 kg that lie on the ground."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-20, 0), (20, 0)))
    planks = [world.add(Box(0.8, 0.25), position=(0.8 * i, 0.125)) for i in range(3)]
    joints = [
        world.join(planks[i], planks[i + 1], Pin((0.8 * i + 0.4, 0.125), limits=limits))
        for i in range(2)
    ]
    for _ in range(10):
        world.step()
    return world, planks, joints


@pytest.mark.parametrize("limits", [None, (-2.0, 2.0)])
@pytest.mark.parametrize("how", ["put elsewhere", "turned"])
def test_a_limb_that_is_moved_by_hand_comes_back(limits: Limits, how: str) -> None:
    world, planks, joints = doll(limits)
    if how == "put elsewhere":
        planks[0].position = (-3.0, 0.8)
    else:
        planks[1].angle += 1.5
    for _ in range(300):
        world.step()
        assert world.kinetic_energy < 10.0
    assert all(math.dist(*joint.anchors) < 1e-6 for joint in joints)
    assert world.ledger().energy_error == pytest.approx(0.0, abs=1e-10)


def test_a_small_gap_closes_within_a_few_ticks() -> None:
    world, planks, joints = doll(None)
    planks[0].position = (-0.03, 0.125)
    for _ in range(4):
        world.step()
    assert all(math.dist(*joint.anchors) < 1e-6 for joint in joints)


@pytest.mark.parametrize("turn", [1.0, 2.5])
def test_a_weld_that_is_turned_by_hand_turns_back(turn: float) -> None:
    world = World(integrator="velocity-verlet")
    a, b = (world.add(Box(0.8, 0.25), position=(0.8 * i, 0.0)) for i in range(2))
    weld = world.join(a, b, Weld((0.4, 0.0)))
    world.step()
    b.angle += turn
    for _ in range(60):
        world.step()
        assert world.kinetic_energy < 10.0
    assert weld.coordinate == pytest.approx(0.0, abs=1e-8)
    assert math.dist(*weld.anchors) < 1e-8
