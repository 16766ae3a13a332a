"""Joints that gape close again: a rigid link is as long afterwards as it was before.

A shallow arc of links closes a gap along itself only if the links rise many times as fast. That was
taken for a throw, so that joints kept their gaps for ever: bridges of light links stayed up to
22 cm longer once something heavy had fallen on them, even when nothing lay on them any more.
"""

import math

import pytest

from engine import Body, Box, Circle, Pin, World

G = 9.81
LENGTH = 0.5


def build_bridge(
    world: World, links: int, mass: float, slack: float, restitution: float
) -> tuple[list[Body], float]:
    """A bridge of links on a circular arc, `slack` times as long as its span, which is returned."""
    span = links * LENGTH / slack
    low, high = 0.0, 3.0
    for _ in range(60 if slack > 1.0 else 0):
        half = (low + high) / 2
        reach = sum(math.cos(slope(half, i, links)) for i in range(links)) * LENGTH
        low, high = (half, high) if reach > span else (low, half)
    x = y = 0.0
    built: list[Body] = []
    for i in range(links):
        angle = slope(low, i, links)
        step = (LENGTH * math.cos(angle), LENGTH * math.sin(angle))
        link = world.add(
            Box(LENGTH, 0.1),
            mass=mass,
            position=(x + step[0] / 2, y + step[1] / 2),
            angle=angle,
            restitution=restitution,
        )
        world.join(built[-1] if built else None, link, Pin(at=(x, y)))
        built.append(link)
        x, y = x + step[0], y + step[1]
    world.join(None, built[-1], Pin(at=(x, y)))
    return built, span


def slope(half: float, link: int, links: int) -> float:
    """Of a link of an arc that turns by twice `half` (rad)."""
    return half * (2 * (link + 0.5) / links - 1)


def widest_gap(links: list[Body], span: float) -> float:
    """Between neighbouring ends of links and fixed points (m)."""
    ends = [(0.0, 0.0)]
    for link in links:
        x, y = (LENGTH / 2 * math.cos(link.angle), LENGTH / 2 * math.sin(link.angle))
        ends += [(link.x - x, link.y - y), (link.x + x, link.y + y)]
    ends.append((span, 0.0))
    return max(math.dist(ends[i], ends[i + 1]) for i in range(0, len(ends), 2))


def energy_of(world: World) -> float:
    """Of motion and height together (J)."""
    return world.kinetic_energy + world.potential_energy


@pytest.mark.parametrize("restitution", [0.0, 0.9])
@pytest.mark.parametrize(("mass", "load"), [(1.0, 10.0), (0.1, 10.0), (0.01, 1.0)])
def test_bridges_are_as_long_again_as_they_were(
    mass: float, load: float, restitution: float
) -> None:
    """What does no work but gravity: closing gaps lifts nothing above where it came from."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    links, span = build_bridge(world, 6, mass, 1.2, restitution)
    world.add(
        Circle(0.2), mass=load, position=(0.4 * span, 0.7), velocity=(0, -4.0),
        restitution=restitution,
    )  # fmt: skip
    before = energy_of(world)
    gaps = []
    for _ in range(360):
        world.step()
        gaps.append(widest_gap(links, span))
        assert energy_of(world) <= before + 1e-9
    assert max(gaps) > 1e-6  # else nothing is shown here
    assert sum(gap > 1e-6 for gap in gaps) < 60
    assert gaps[-1] < 1e-8


@pytest.mark.parametrize(
    ("links", "slack", "share"), [(6, 1.2, 0.99), (15, 1.2, 0.9), (8, 1.05, 0.6)]
)
@pytest.mark.parametrize("gravity", [0.0, G])
def test_arcs_that_are_pulled_flat_close_without_violence(
    links: int, slack: float, share: float, gravity: float
) -> None:
    """A hand moves the pier of an arc outwards by a share of what the arc is too long: links that
    are long enough close all gaps, and go little faster than gaps close (2 reaches a second).
    Nearly flat arcs keep a millimetre; they kept up to 34 cm.
    """
    world = World(gravity=(0, -gravity), integrator="velocity-verlet")
    built, span = build_bridge(world, links, 1.0, slack, 0.0)
    world.joints[-1].remove()
    pier = world.add(Circle(0.02), kind="kinematic", position=(span, 0))
    world.join(built[-1], pier, Pin(at=(span, 0)))
    world.run(5)
    span += share * (links * LENGTH - span)
    pier.position = (span, 0)
    fastest = links * math.hypot(LENGTH, 0.1) ** 2 / 2
    for _ in range(360):
        world.step()
        assert world.kinetic_energy < 6.0 * fastest
    assert widest_gap(built, span) < 0.002
