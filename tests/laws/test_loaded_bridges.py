"""Bridges of links, heavy and light, that something heavy falls on: nothing gains energy.

Equations of joints were solved from the impulses of the part before, which throw a light link
between heavy ones so far that another solution was found, turned over once or twice: bridges gained
1e5 J, or diverged. And contacts pressed on joints that had found no solution and let go, or each
undid what the other had done, and more; impacts took for real what joints lent within a part.
"""

import pytest

from engine import Body, Box, Capsule, Circle, Pin, Rope, World

G = 9.81
STEP = 0.08


@pytest.mark.parametrize("load", [2.0, 20.0, 200.0])
@pytest.mark.parametrize(
    "masses", [(0.01, 4.66, 0.0012, 1.0), (1.0, 1.0, 1.0, 1.0, 1.0), (0.002, 1.0, 0.002, 1.0)]
)
def test_a_heavy_body_on_a_bridge(masses: tuple[float, ...], load: float) -> None:
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    left = -STEP * (len(masses) - 1) / 2
    links = [
        world.add(
            Capsule(0.055, 0.012) if mass < 0.1 else Box(0.08, 0.025),
            mass=mass, position=(left + STEP * i, 0.3),
        )
        for i, mass in enumerate(masses)
    ]  # fmt: skip
    for i in range(len(links) - 1):
        world.join(links[i], links[i + 1], Pin((left + STEP * (i + 0.5), 0.3)))
    world.join(None, links[0], Pin((left - STEP / 2, 0.3)))
    world.join(None, links[-1], Rope(anchor_a=(left + STEP * (len(masses) + 0.5), 0.4)))
    world.add(Box(0.06, 0.06), mass=load, position=(0.01, 0.36))
    for _ in range(40):
        world.step()
        ledger = world.ledger()
        fallen = ledger.work.gravity
        assert ledger.kinetic <= 1.02 * fallen + 1e-6
    assert ledger.energy_error == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(
    ("links", "restitution", "where", "speed"),
    [(3, 0.9, 0.4, 3), (5, 0.9, 0.3, 3), (3, 0.0, 0.7, 3), (3, 0.5, 0.6, 3), (4, 0.9, 0.5, 0)],
)
def test_a_heavy_ball_falls_on_a_taut_bridge(
    links: int, restitution: float, where: float, speed: float
) -> None:
    """A ball a thousand times as heavy as a link: gravity alone does work. It stretches joints,
    which close again, so that it is lifted where it came from, but no faster than they close: two
    reaches of a link a second. Energy grew by up to 63 times what lifts the ball by a metre.
    """
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    length = 0.5
    before: Body | None = None
    for i in range(links):
        link = world.add(
            Box(length, 0.1), mass=0.1, position=((i + 0.5) * length, 0), restitution=restitution
        )
        world.join(before, link, Pin(at=(i * length, 0)))
        before = link
    world.join(None, before, Pin(at=(links * length, 0)))
    ball = world.add(
        Circle(0.2),
        mass=100,
        position=(where * links * length, 0.6),
        velocity=(0, -speed),
        restitution=restitution,
        friction=0.3,
    )
    first = before_tick = world.kinetic_energy + world.potential_energy
    for _ in range(150):
        world.step()
        energy = world.kinetic_energy + world.potential_energy
        assert energy < before_tick + ball.mass * G * length / 60
        assert energy <= first + 1e-6
        before_tick = energy
    assert world.ledger().energy_error == pytest.approx(0.0, abs=1e-6)
