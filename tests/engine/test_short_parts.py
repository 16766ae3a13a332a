"""What a hinge exerts in a part of a tick that lasts for a nanosecond is no force that lasts.

Impacts end parts of a tick wherever they happen, and what was left of a tick was so short that
stopping what opened a hinge took 2 MN: the next part began with that force, and jammed links were
thrown with 50 times what they could fall by.
"""

from engine import Body, Box, Pin, Wall, World


def test_links_that_slide_go_on_from_what_contacts_and_hinges_gave() -> None:
    """Friction only takes energy, whatever the third hinge exerted for a nanosecond."""
    world = World(gravity=(0, -9.81), integrator="velocity-verlet", kernels="interpreted")
    world.add(Wall((-5, 0), (15, 0)), friction=0.2)
    links: list[Body] = []
    for i in range(6):
        links.append(world.add(Box(1, 0.2), mass=1, position=(i, 0.1), velocity=(2, 0)))
        links[i].friction = 0.2
        if i > 0:
            world.join(links[i - 1], links[i], Pin(at=(i - 0.5, 0.1)))
    for _ in range(5):
        world.step()
    joints = world.tables.joints
    joints.end_1[2] = 1e8
    joints.part[2] = 1e-9
    for _ in range(4):
        before = world.kinetic_energy
        world.step()
        assert world.kinetic_energy < before
