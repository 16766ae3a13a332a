"""No impact gives energy: nor where one corner touches and opens while another bounces.

Both were struck at once; the corner that opened, and that the blow on the other drove back, was
stopped. Each impulse does its mean speed times it as work (Brogliato, "Nonsmooth Mechanics", 2016,
section 4.3), and where nothing was lost at the corner that bounced, what stopped the other was a
gain: a light box between heavy ones had its speed doubled again and again at one instant.
"""

import pytest

from engine import Box, Circle, Wall, World


@pytest.mark.parametrize("ball", [False, True])
@pytest.mark.parametrize("opening", [0.0, 0.05, 0.2, 0.8])
@pytest.mark.parametrize("restitution", [0.5, 0.9, 1.0])
def test_a_plank_that_lands_on_one_corner_while_the_other_opens(
    opening: float, restitution: float, ball: bool
) -> None:
    """Elastic, it keeps its energy; else it loses some, whatever else strikes it at the instant."""
    world = World(gravity=(0, 0))
    world.add(Wall((-5, 0), (5, 0)), restitution=restitution)
    left, right = -1.0, opening  # speeds of the corners (m/s)
    world.add(
        Box(1, 0.1), mass=1, position=(0, 0.05), velocity=(0, (left + right) / 2),
        spin=right - left, restitution=restitution,
    )  # fmt: skip
    if ball:
        world.add(Circle(0.1), position=(0.45, 0.2), velocity=(0, -1), restitution=restitution)
    before = world.kinetic_energy
    world.step(1 / 600)
    if restitution == 1.0:
        assert world.kinetic_energy == pytest.approx(before, rel=1e-14)
    else:
        assert world.kinetic_energy < before
    assert world.ledger().energy_error == pytest.approx(0.0, abs=1e-14)
