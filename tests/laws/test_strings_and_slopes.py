"""Blocks, strings, discs: what hangs pulls what lies; what rolls on one another turns.

Closed forms of any course (Kleppner and Kolenkow, "An Introduction to Mechanics", 2014, ch. 2, 7).
"""

import itertools
import math

import pytest

from engine import Body, Box, Circle, Distance, Force, Particle, Pin, Pulley, Wall, World

G = 9.81
STEEP = math.radians(30)
FRICTION = 0.2


def still_world() -> World:
    return World(gravity=(0, -G), integrator="velocity-verlet")


def block_on_slope(hangs: float) -> tuple[World, Body, Body]:
    """2 kg on a slope of 30 degrees, and so many kg that hang on its string."""
    world = still_world()
    along = (math.cos(STEEP), math.sin(STEEP))
    up = (-along[1], along[0])
    world.add(Wall((-20 * along[0], -20 * along[1]), (0, 0)), friction=FRICTION)
    place = (-6 * along[0] + 0.1 * up[0], -6 * along[1] + 0.1 * up[1])
    block = world.add(Box(0.4, 0.2), mass=2.0, position=place, angle=STEEP, friction=FRICTION)
    load = world.add(Particle(0.1), mass=hangs, position=(1, -1))
    world.join(block, load, Pulley(over_a=(0.1 * up[0], 0.1 * up[1]), over_b=(1, 0.1)))
    return world, block, load


@pytest.mark.parametrize("hangs", [0.3, 0.6, 1.0, 1.3, 1.4, 3.0])
def test_a_block_is_pulled_up_its_slope_slides_down_or_stays(hangs: float) -> None:
    """a = (M - m (sin +- mu cos)) g/(m + M), and none in between."""
    world, block, load = block_on_slope(hangs)
    world.run(60)
    pull = hangs - 2 * math.sin(STEEP)
    rubs = FRICTION * 2 * math.cos(STEEP)
    net = pull - rubs if pull > rubs else min(pull + rubs, 0.0)
    assert -load.vy == pytest.approx(net * G / (2 + hangs), rel=1e-3, abs=2e-4)
    assert block.speed == pytest.approx(abs(load.vy), abs=1e-4)


def test_a_disc_unrolls_down_a_wall_like_a_yo_yo() -> None:
    """A string that unwinds, or a rough wall: m a = m g - T and I w' = T R give a = 2 g/3."""
    world = still_world()
    world.add(Wall((0, -20), (0, 20)), friction=1.0)
    disc = world.add(Circle(0.2), mass=1.0, position=(0.2, 0), friction=1.0)
    disc.exert(Force(-20, 0))
    world.run(60)
    assert disc.vy == pytest.approx(-2 * G / 3, rel=1e-3)
    assert abs(disc.spin) * 0.2 == pytest.approx(-disc.vy, rel=1e-3)


def test_atwoods_masses_turn_a_heavy_pulley() -> None:
    """Racks of 1 and 2 kg, pressed on a disc of 4 kg on an axle: a = (2 - 1) g/(1 + 2 + 4/2)."""
    world = still_world()
    wheel = world.add(Circle(0.5), mass=4.0, friction=1.0)
    world.join(None, wheel, Pin(at=(0, 0)))
    racks = []
    for side, mass in ((-1, 1.0), (1, 2.0)):
        rack = world.add(
            Box(0.2, 20), mass=mass, position=(0.6 * side, 0), friction=1.0, fixed_rotation=True
        )
        rack.exert(Force(-60 * side, 0))
        racks.append(rack)
    world.run(60)
    expected = G / 5
    assert racks[0].vy == pytest.approx(expected, rel=2e-3)
    assert racks[1].vy == pytest.approx(-expected, rel=2e-3)
    assert abs(wheel.spin) * 0.5 == pytest.approx(expected, rel=2e-3)


def test_a_rope_of_beads_slides_off_a_rounded_edge() -> None:
    """Without friction what has fallen is what it has gained, along its whole length."""
    world = still_world()
    edge, bead, count, long, hangs = 0.3, 0.01, 31, 3.0, 0.8
    path = edge + bead
    world.add(Circle(edge), kind="static", position=(0, -edge), friction=0.0)
    world.add(Wall((-6, 0), (0, 0)), friction=0.0)

    def place(way: float) -> tuple[float, float]:
        if way < 0:
            return way, bead
        turn = min(way / path, math.pi / 2)
        low = max(way - path * math.pi / 2, 0.0)
        return path * math.sin(turn), path * math.cos(turn) - edge - low

    start = hangs + path * math.pi / 2 - long
    ways = [start + i * long / (count - 1) for i in range(count)]
    beads = [world.add(Particle(bead), mass=1 / count, position=place(way)) for way in ways]
    for one, other in itertools.pairwise(beads):
        world.join(one, other, Distance())
    world.run(30)
    moved = beads[0].x - start
    fallen = sum(place(way)[1] - place(way + moved)[1] for way in ways) / count
    assert moved > 0.4
    assert beads[0].vx == pytest.approx(math.sqrt(2 * G * fallen), rel=1e-2)
