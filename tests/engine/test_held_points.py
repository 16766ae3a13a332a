"""Two points of joined bodies meet at once, and joints let only one of them yield, or neither.

Equations of both points were solved that held nothing but rounding, or what velocities were amiss:
two rods in one place, pinned to a link of a bridge, were thrown apart with 80,000 J.
"""

import math

import pytest

from engine import Box, Pin, World
from engine.kernels.impulses import WEDGED, split
from engine.kernels.joined_impacts import JAMMED


def bridge() -> World:
    """Five links between two fixed points, pushed along, and two rods pinned to the first."""
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    before, x, y, links = None, 0.0, 0.0, []
    for angle in (-0.26, 0.2, 0.21, -0.26, 0.19):
        way = (0.3 * math.cos(angle), 0.3 * math.sin(angle))
        place = {"position": (x + way[0], y + way[1]), "angle": angle, "velocity": (1.0, 0.0)}
        link = world.add(Box(0.6, 0.06), mass=0.06, friction=0.4, **place)
        world.join(before, link, Pin(at=(x, y)))
        before, x, y = link, x + 2 * way[0], y + 2 * way[1]
        links.append(link)
    world.join(None, before, Pin(at=(x, y)))
    first = links[0]
    for _ in range(2):
        rod = world.add(
            Box(0.36, 0.08), mass=0.05, friction=0.4, position=(first.x + 0.18, first.y)
        )
        world.join(first, rod, Pin(at=first.position))
    return world


def test_rods_in_one_place_on_a_bridge_gain_no_energy() -> None:
    """Impacts and joints can only take energy: what the joints find amiss at first, and more."""
    world = bridge()
    before = world.kinetic_energy + world.potential_energy
    for _ in range(30):
        world.step()
        assert world.kinetic_energy + world.potential_energy < before


def test_what_is_jammed_is_stopped_at_one_point() -> None:
    """Joints that turn a push at one point into one at the other leave nothing to be divided by."""
    k, amiss = 7.2727, 1e-9
    share, total = split(k, -k * (1 - amiss), k, 1.378, -1.27, JAMMED)
    assert (share, total) == (0.0, 1.378 / k)


def test_points_that_yield_share_it() -> None:
    """k11 p1 + k12 p2 = v1 and k12 p1 + k22 p2 = v2, by hand: p1 = p2 = 0.2, or each alone."""
    share, total = split(3.0, 2.0, 3.0, 1.0, 1.0, WEDGED)
    assert (share, total) == pytest.approx((0.5, 0.4))
    assert split(2.0, 2.0, 2.0, 1.0, 1.0, WEDGED) == (0.5, 0.5)
    assert split(2.0, 1.0, 2.0, 1.0, 0.1, WEDGED) == (0.0, 0.5)
