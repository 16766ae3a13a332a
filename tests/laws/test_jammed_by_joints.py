"""What joints hold in each other presses no harder than its contacts are soft.

A spring that yields the less the more it bears, in a gap that can never open, bore more from part
to part without end; when such a jam came loose, it threw all that hung on it.
"""

import pytest

from engine import Box, Pin, World

G = 9.81


def test_a_beam_pinned_into_a_floor_presses_on_it_with_a_force_that_ends() -> None:
    """It is 5 cm deep. The force grows to what the softest spring of a joined contact bears, and
    the pin takes all of it but the weight: statics.
    """
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    floor = world.add(Box(2, 1), kind="static", position=(0, -0.5), friction=0.4)
    beam = world.add(Box(1, 0.4), mass=1, position=(0, 0.15), friction=0.4)
    pin = world.join(None, beam, Pin(at=(0, 0.15)))
    forces = []
    for _ in range(4):
        world.run(120)
        (contact,) = (each for each in world.contacts if floor in (each.a, each.b))
        forces.append(abs(contact.impulse.y) * 60)
    assert forces[-1] == pytest.approx(forces[-2], rel=1e-3)
    assert forces[-1] < 30_000
    assert pin.force.y == pytest.approx(G - forces[-1], rel=1e-6)
