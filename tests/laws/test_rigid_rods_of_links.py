"""Links in one line that are pushed along it move on as a rod.

The jolt with which hinges spread the push was expected again in the next part of the tick. That
led so far away that the equations found another solution: links folded up, with ten thousand
joules from nowhere, and the tick was cut into thousands of parts.
"""

import pytest

from engine import Box, Capsule, Pin, World

PUSH = 0.83
MASSES = (1.0, 0.002, 1.0, 0.002, 1.0)


@pytest.mark.parametrize("substeps", [1, 4, 6])
@pytest.mark.parametrize("aside", [0.0, 0.0186])
def test_a_push_along_a_line_of_links_is_shared(substeps: int, aside: float) -> None:
    world = World(integrator="velocity-verlet", substeps=substeps)
    shapes = [Box(0.08, 0.025), Capsule(0.055, 0.012)]
    links = [
        world.add(shapes[i % 2], mass=mass, position=(0.08 * i, 0.0))
        for i, mass in enumerate(MASSES)
    ]
    links[2].velocity = (-PUSH, aside)
    for i in range(4):
        world.join(links[i], links[i + 1], Pin((0.08 * i + 0.04, 0.0)))
    world.step()
    energy = world.kinetic_energy
    shared = -PUSH / sum(MASSES)
    for link in links:
        assert link.vx == pytest.approx(shared, rel=0.02)
    for _ in range(30):
        world.step()
        assert world.kinetic_energy <= energy * 1.0001
    momentum = sum(link.mass * link.vx for link in links)
    assert momentum == pytest.approx(-PUSH, rel=1e-12)
