"""Links that are pulled straight between two fixed points: no impulse keeps their lengths."""

import itertools
import math

import pytest

from engine import Box, Pin, World

G = 9.81


@pytest.mark.parametrize("sag", [0.0, 1e-4, 1e-2])
def test_a_box_falls_on_a_bridge_that_is_pulled_straight(sag: float) -> None:
    """Planks in a straight line cannot give way, and bear no load but by an endless pull: nothing
    may be thrown by it.
    """
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    ends = [(float(i), -4.0 * sag * (i / 3) * (1 - i / 3)) for i in range(4)]
    planks = []
    for (x, y), (to_x, to_y) in itertools.pairwise(ends):
        planks.append(
            world.add(
                Box(0.98, 0.2), position=((x + to_x) / 2, (y + to_y) / 2),
                angle=math.atan2(to_y - y, to_x - x),
            )
        )  # fmt: skip
    for at, a, b in zip(ends, [None, *planks], [*planks, None], strict=True):
        world.join(a, b, Pin(at))
    world.add(Box(0.5, 0.5), position=(1.8, 1.0))
    fall = G * 0.65
    for _ in range(90):
        world.step()
        assert world.kinetic_energy < 1.01 * fall
    assert all(math.dist(*joint.anchors) < 1e-3 for joint in world.joints)
    assert world.ledger().energy_error == pytest.approx(0.0, abs=1e-10)
