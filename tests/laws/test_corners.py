"""What lands on one corner, and then on another: each is an impact of its own, at its own instant.

A rod that leaves the floor with one end comes down with the other a moment later, often within the
same tick. The instants follow from rigid motion between impulses of eq. (40) of the thesis,
energies from the law of restitution.
"""

import math
import random

import pytest

from engine import Body, Box, Capsule, Polygon, Shape, Wall, World

GRAVITY = 9.81
RODS: list[Shape] = [Box(0.6, 0.1), Box(0.9, 0.3), Capsule(0.5, 0.1), Polygon.regular(3, 0.3)]


def lowest(body: Body) -> float:
    """The height of the lowest point of a body (m)."""
    return min(y for line in body.outlines for _, y in line)


def highest(body: Body) -> float:
    """The height of the highest point of a body (m)."""
    return max(y for line in body.outlines for _, y in line)


@pytest.mark.parametrize("ground", ["wall", "box"])
@pytest.mark.parametrize("gravity", [0.0, -GRAVITY])
@pytest.mark.parametrize("shape", RODS)
def test_a_spinning_rod_never_dips_into_floor_or_ceiling(
    shape: Shape, gravity: float, ground: str
) -> None:
    """It touches them with all its ends, hundreds of times, and keeps its energy to rounding."""
    hits = 0
    for spin in (4.0, -11.0, 29.0):
        world = World(gravity=(0, gravity), integrator="velocity-verlet")
        if ground == "wall":
            world.add(Wall((-90, 0), (90, 0)))
        else:
            world.add(Box(180, 2), kind="static", position=(0, -1))
        world.add(Wall((90, 1.5), (-90, 1.5)))
        rod = world.add(
            shape, mass=2, position=(0, 0.7), velocity=(0.3, -1.7), spin=spin, restitution=1
        )
        energy = world.kinetic_energy + world.potential_energy
        for _ in range(150):
            hits += len(world.step())
            assert lowest(rod) > -1e-9
            assert highest(rod) < 1.5 + 1e-9
        now = world.kinetic_energy + world.potential_energy
        assert now == pytest.approx(energy, rel=1e-12)
    assert hits > 12


@pytest.mark.parametrize("angle", [0.1, -0.2, 0.3])
@pytest.mark.parametrize("speed", [0.5, 2.0, 5.0])
def test_the_other_end_lands_when_rigid_motion_says(angle: float, speed: float) -> None:
    """A box without weight meets the floor with its lower corner, elastically and without friction:
    P = 2 v / (1/m + r^2/I), r being the corner's distance from the centre along the floor. It then
    moves on at -v + P/m and turns at r P / I, until its other corner is on the floor.
    """
    mass, width, height = 3.0, 0.8, 0.1
    world = World()
    world.add(Wall((-9, 0), (9, 0)))
    box = world.add(Box(width, height), mass=mass, angle=angle, velocity=(0, -speed), restitution=1)
    box.position = (0.0, speed / 97.0 - lowest(box))  # it lands after 1/97 s
    side = -math.copysign(1.0, angle)

    def corner(x: float, turned: float) -> tuple[float, float]:
        """Where a lower corner is beside the centre."""
        u, v = x * width / 2, -height / 2
        return (
            u * math.cos(turned) - v * math.sin(turned),
            u * math.sin(turned) + v * math.cos(turned),
        )

    arm, drop = corner(side, angle)
    impulse = 2 * speed / (1 / mass + arm**2 / box.inertia)
    rise, spin = -speed + impulse / mass, arm * impulse / box.inertia
    early, late = 0.0, -2 * angle / spin  # it then lies as before, mirrored

    def gap(time: float) -> float:
        return -drop + rise * time + corner(-side, angle + spin * time)[1]

    for _ in range(60):
        middle = (early + late) / 2
        early, late = (middle, late) if gap(middle) > 0 else (early, middle)
    hits = [hit for _ in range(40) for hit in world.step()]
    assert hits[0].time == pytest.approx(1 / 97.0, abs=1e-12)
    assert hits[0].impulse.y == pytest.approx(impulse, rel=1e-9)
    assert hits[1].time == pytest.approx(1 / 97.0 + early, abs=1e-9)


@pytest.mark.parametrize("restitution", [0.3, 0.5, 1.0])
@pytest.mark.parametrize("angle", [0.2, -0.3, 0.5, -0.8, 1.2])
@pytest.mark.parametrize(("shape", "flat"), [(Box(0.6, 0.1), 0.05), (Capsule(0.5, 0.05), 0.05)])
def test_what_falls_over_slaps_the_floor_and_keeps_the_square_of_its_restitution(
    shape: Shape, flat: float, angle: float, restitution: float
) -> None:
    """A rod that leans with one end on a smooth floor is let go; its other end comes down. The one
    end rests, so both are stopped and the whole motion is mirrored: e^2 of the energy is left.
    """
    world = World(gravity=(0, -GRAVITY), integrator="velocity-verlet")
    world.add(Wall((-5, 0), (5, 0)))
    rod = world.add(shape, mass=2, angle=angle, restitution=restitution)
    rod.position = (0, -lowest(rod))
    fallen = 2 * GRAVITY * (rod.y - flat)
    while not world.step():
        assert world.time < 1.0
    left = world.kinetic_energy + 2 * GRAVITY * (rod.y - flat)
    assert left / fallen == pytest.approx(restitution**2, abs=2e-3)


@pytest.mark.parametrize("angle", [0.3, -0.3, 0.5, -0.5])
def test_a_body_that_is_put_on_its_corner_rests_on_it_at_once(angle: float) -> None:
    """Whichever of its two lower corners it is: no fall of a tick, no impact."""
    world = World(gravity=(0, -GRAVITY), integrator="velocity-verlet")
    world.add(Wall((-5, 0), (5, 0)))
    rod = world.add(Box(0.6, 0.1), mass=2, angle=angle, friction=1.0)
    rod.position = (0, -lowest(rod))
    assert world.step() == []
    assert lowest(rod) > -1e-5
    assert [contact.phase for contact in world.contacts] == ["begin"]


@pytest.mark.parametrize("seed", range(24))
def test_what_comes_down_at_250_metres_a_second_stays_above_the_floor(seed: int) -> None:
    """It strikes the floor with one corner after another, each blow plastic, and moves by half its
    size and more in a part: what turns on a corner without a load to hold it there is in flight
    (w^2 r is more than g), and its next corner has an instant of its own. Else one in nine went
    in, and thin rods through the floor.
    """
    dice = random.Random(seed)
    thin = Box(dice.uniform(1, 2), 0.05)
    shape = dice.choice([thin, Box(0.8, 1.1), Polygon.regular(dice.randint(3, 8), 0.6)])
    world = World(gravity=(0, dice.choice([0.0, -GRAVITY])))
    friction = dice.choice([0.0, 0.5])
    world.add(Wall((-1e4, 0), (1e4, 0)), friction=friction)
    speed, way = dice.uniform(100, 250), dice.uniform(-2.6, -0.5)
    body = world.add(
        shape, position=(0, dice.uniform(1.5, 5)), angle=dice.uniform(0, 6), friction=friction,
        velocity=(speed * math.cos(way), speed * math.sin(way)), spin=dice.uniform(-160, 160),
    )  # fmt: skip
    energy = body.kinetic_energy + GRAVITY * body.mass * body.y
    for _ in range(12):
        world.step()
        assert min(corner.y for corner in body.vertices) > -0.01
    assert body.kinetic_energy < energy
