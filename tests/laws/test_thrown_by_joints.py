"""Light links between heavy ones that swing, and bridges of them that are pulled taut: no solution
of their equations throws them.

Links hang on fixed points and gravity alone does work: energy stays as it is, but for what ends
when they are pulled straight. Chains of three links gained 400 times what they can fall by, or
diverged; a whip turned a light link through a whole turn in a part of a tick, for which a pivot of
the equations had changed its sign; bridges that had opened where they were taut were thrown as
hinges closed.
"""

import math

import pytest

from engine import Body, Box, Pin, Wall, World

G = 9.81
LENGTH = 0.5


def hang(angles: list[float], masses: list[float], bridge: bool) -> tuple[World, list[Body]]:
    """Links that hang on a fixed point, as `bridge` on two, at rest; they touch nothing."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    links: list[Body] = []
    before = None
    x = y = 0.0
    for angle, mass in zip(angles, masses, strict=True):
        way = (LENGTH * math.cos(angle), LENGTH * math.sin(angle))
        before, last = (
            world.add(
                Box(LENGTH, 0.1), mass=mass, angle=angle, mask=0,
                position=(x + way[0] / 2, y + way[1] / 2),
            ),
            before,
        )  # fmt: skip
        world.join(last, before, Pin(at=(x, y)))
        links.append(before)
        x, y = x + way[0], y + way[1]
    if bridge:
        world.join(None, before, Pin(at=(x, y)))
    return world, links


def gained(world: World, links: list[Body], ticks: int) -> float:
    """The most energy that is gained, as a share of what lifts all links by half their length."""
    scale = sum(link.mass for link in links) * G * LENGTH * len(links) / 2
    first = world.kinetic_energy + world.potential_energy
    most = 0.0
    for _ in range(ticks):
        world.step()
        most = max(most, world.kinetic_energy + world.potential_energy - first)
    assert world.ledger().energy_error == pytest.approx(0.0, abs=1e-9)
    return most / scale


CHAINS = [
    ([1.5, 0.3, 1.3], [0.01, 0.01, 0.5]),
    ([-2.5, 1.3, -2.6, -2.1, 2.2], [0.01, 0.01, 0.5, 0.5, 0.5]),
    ([-1.0, -0.9, -0.2, 1.6, -2.7, -0.9], [0.1, 0.01, 0.01, 0.01, 0.1, 0.5]),
    ([-2.4, -0.7, -2.2], [0.01, 0.01, 0.5]),
]


@pytest.mark.parametrize(("angles", "masses"), CHAINS)
def test_a_chain_with_light_links_gains_no_energy(angles: list[float], masses: list[float]) -> None:
    world, links = hang(angles, masses, bridge=False)
    assert gained(world, links, 170) < 5e-3


@pytest.mark.parametrize(
    ("angles", "masses"),
    [
        ([-1.6, 1.6, 2.9], [0.01, 0.01, 0.5]),
        ([-2.6, -2.9, 1.8, 2.5, -1.3], [0.01, 0.01, 0.5, 0.5, 0.01]),
        ([0.6, 1.4, -2.1, -1.8, -1.6], [0.01, 0.01, 0.01, 0.1, 0.5]),
    ],
)
def test_nor_while_other_links_lie_on_a_floor(angles: list[float], masses: list[float]) -> None:
    """What lies elsewhere does not matter: contacts leave the parts of a tick no shorter."""
    world, links = hang(angles, masses, bridge=False)
    world.add(Wall((50, 0), (60, 0)))
    planks = [world.add(Box(1, 0.2), mass=1, position=(54.5 + i, 0.1)) for i in (0, 1)]
    world.join(*planks, Pin(at=(55, 0.1)))
    assert gained(world, links, 200) < 5e-3


@pytest.mark.parametrize(
    ("angles", "masses"),
    [
        ([0.8, 0.5, -0.4, -0.6, -0.2], [0.1, 0.5, 0.5, 0.01, 0.01]),
        ([-0.8, -0.2, -0.7], [0.01, 0.01, 0.5]),
        ([-0.3, -0.2, -0.6, -0.9], [0.01, 0.01, 0.5, 0.01]),
    ],
)
def test_a_bridge_that_swings_taut_gains_no_energy(
    angles: list[float], masses: list[float]
) -> None:
    world, links = hang(angles, masses, bridge=True)
    assert gained(world, links, 200) < 1e-3
