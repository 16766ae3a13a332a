"""What lands flat on several places at once bounces as a whole and does not begin to turn.

Newton's law of impact (Principia, 1687, scholium to the laws) at each point of contact: all leave
with e times the speed with which they came, which is the motion of what does not turn. So it does
not matter of how many pieces the body, or the ground, is made, or in which order they were added.
"""

import math
from collections.abc import Callable

import pytest

from engine import Box, Capsule, Chain, Circle, Compound, Polygon, Wall, World
from engine.shapes import Shape

G = 9.81

TABLE = Compound(
    [(Box(1.0, 0.1), (0, 0.55)), (Box(0.1, 0.5), (-0.3, 0.25)), (Box(0.1, 0.5), (0.45, 0.25))]
)
ARCH = Polygon.concave([(0, 0), (0.2, 0), (0.2, 0.8), (0.6, 0.8), (0.6, 0), (1, 0), (1, 1), (0, 1)])
BAR_BELL = Compound([(Circle(0.2), (-0.5, 0)), (Circle(0.2), (0.7, 0)), Box(1, 0.1)])
BODIES = [TABLE, ARCH, BAR_BELL, Box(1.2, 0.5), Capsule(1.2, 0.2), Box(1.1, 0.4, rounding=0.1)]


def lowest(shape: Shape) -> float:
    return min(corner.y - piece.radius for piece in shape.pieces for corner in piece.corners)


def wall(world: World) -> None:
    world.add(Wall((-9, 0), (9, 0)), friction=0.5)


def chain(world: World) -> None:
    world.add(Chain([(-9, 0), (0.1, 0), (9, 0)]), friction=0.5)


def planks(world: World) -> None:
    parts = [(Box(0.5, 0.2), (0.5 * i, 0)) for i in range(-4, 5)]
    world.add(Compound(parts), kind="static", position=(0.1, -0.1), friction=0.5)


def pillars(world: World) -> None:
    for x in (0.5, -0.5):
        world.add(Box(0.6, 1), kind="static", position=(x, -0.5), friction=0.5)


@pytest.mark.parametrize("ground", [wall, chain, planks, pillars])
@pytest.mark.parametrize("shape", BODIES)
@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
def test_what_lands_flat_bounces_flat(
    ground: Callable[[World], None], shape: Shape, e: float
) -> None:
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    ground(world)
    body = world.add(
        shape, mass=2.0, position=(0, 0.4 - lowest(shape)), restitution=e, friction=0.5
    )
    fall = math.sqrt(2 * 0.4 * G)
    hits = []
    for _ in range(60):
        hits += world.step()
        assert abs(body.spin) < 1e-3
    first = [hit for hit in hits if hit.time == hits[0].time]
    assert hits[0].time == pytest.approx(fall / G, rel=1e-9)
    assert math.fsum(hit.impulse.y for hit in first) == pytest.approx(2 * (1 + e) * fall, rel=1e-9)
    if e == 1.0:
        energy = body.vy**2 / 2 + G * (body.y + lowest(shape))
        assert energy == pytest.approx(0.4 * G, rel=1e-9)
        assert abs(body.spin) < 1e-9


BAR = Compound([(Box(0.5, 0.2), (0.5 * i, 0)) for i in range(3)])


@pytest.mark.parametrize("ground", [wall, chain, planks])
@pytest.mark.parametrize("shape", [Box(1.5, 0.2), BAR, Capsule(1.2, 0.1)])
@pytest.mark.parametrize("e", [0.5, 1.0])
def test_what_slides_as_it_lands_loses_friction_times_the_impulse(
    ground: Callable[[World], None], shape: Shape, e: float
) -> None:
    """One impact, wherever seams are: P = (1 + e) m v upwards, mu P against the sliding."""
    for x in (-0.9, -0.6, -0.27, 0.0):
        world = World(gravity=(0, -G), integrator="velocity-verlet")
        ground(world)
        body = world.add(
            shape, mass=3.0, position=(x, 1 - lowest(shape)), velocity=(1, 0), restitution=e,
            friction=0.0018,
        )  # fmt: skip
        hits = []
        while not hits:
            hits = world.step()
        (hit,) = hits
        speed = math.sqrt(2 * G)
        assert hit.impulse.y == pytest.approx(3 * (1 + e) * speed, rel=1e-9)
        assert body.vx == pytest.approx(1 - 0.03 * (1 + e) * speed, rel=1e-9)
        after = body.vy + G * (world.time - hit.time)
        assert after == pytest.approx(e * speed, rel=1e-9)


def props(world: World) -> None:
    for x in (-0.8, 0.8):
        world.add(Box(0.8, 1), kind="static", position=(x, -0.5), friction=0.0)


@pytest.mark.parametrize(
    ("shape", "ground"), [(BAR, wall), (Box(1.5, 0.2), planks), (Box(1.5, 0.2), props)]
)
@pytest.mark.parametrize("angle", [0.3, 0.6])
@pytest.mark.parametrize("e", [0.0, 0.3, 0.5, 0.8, 1.0])
def test_a_bar_falls_over_alike_whatever_it_and_the_ground_are_made_of(
    shape: Shape, ground: Callable[[World], None], angle: float, e: float
) -> None:
    """The far end comes down, the near one is kept from being pressed in, at the same instant."""
    ways = []
    for falling, floor in ((shape, ground), (Box(1.5, 0.2), wall)):
        world = World(gravity=(0, -G))
        floor(world)
        bar = world.add(falling, mass=3.0, angle=angle, restitution=e, friction=0.0)
        bar.position = (0, -min(y for line in bar.outlines for _, y in line))
        way = []
        for _ in range(60):
            world.step()
            way.append((bar.y, bar.angle))
        ways.append(way)
    for one, other in zip(*ways, strict=True):
        assert one == pytest.approx(other, abs=5e-3)
