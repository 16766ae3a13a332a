"""Chains of joints: the catenary, and joints together with contacts."""

import math
from collections.abc import Iterator

import numpy as np
import pytest

from engine import Body, Circle, Distance, Joint, Particle, Pin, Polygon, Wall, World

G = 9.81


def hang(world: World, links: int, length: float, span: float) -> tuple[list[Body], list[Joint]]:
    """Beads on massless rods between two points of the world, at first in a V below them."""
    depth = math.sqrt((links * length) ** 2 - span**2) / 2
    beads = []
    for i in range(1, links):
        far = i / links
        y = -2 * depth * min(far, 1 - far)
        beads.append(world.add(Particle(0.01), mass=0.2, position=(far * span, y)))
    ends = [None, *beads, None]
    anchors = [{"anchor_a": (0, 0)}, *[{}] * (links - 2), {"anchor_b": (span, 0)}]
    rods = [
        world.join(a, b, Distance(length=length, **anchor))
        for a, b, anchor in zip(ends, ends[1:], anchors, strict=False)
    ]
    return beads, rods


def test_a_hanging_string_of_beads_is_the_discrete_catenary() -> None:
    """At rest the horizontal tension H is the same in every rod, and the vertical one grows by m g
    from bead to bead: rod i slopes by tan = (i - (n - 1)/2) m g/H, where the rods together span
    the gap: sum of l cos = span (statics; the catenary of Bernoulli, Huygens, Leibniz, 1691).
    """
    world = World(gravity=(0, -G))
    links, length, span = 10, 0.3, 2.0
    beads, rods = hang(world, links, length, span)
    for _ in range(600):  # come to rest: what moves is braked
        world.step()
        for bead in beads:
            bead.velocity = (0.93 * bead.vx, 0.93 * bead.vy)
    weight = 0.2 * G
    low, high = 0.1, 100.0
    for _ in range(100):
        pull = (low + high) / 2
        tans = [(i - (links - 1) / 2) * weight / pull for i in range(links)]
        reach = sum(length / math.sqrt(1 + tan * tan) for tan in tans)
        low, high = (low, pull) if reach > span else (pull, high)
    x = y = 0.0
    for bead, tan in zip(beads, tans, strict=False):
        cos = 1 / math.sqrt(1 + tan * tan)
        x, y = x + length * cos, y + length * tan * cos
        assert bead.position == pytest.approx((x, y), abs=1e-6)
    assert rods[0].force == pytest.approx((-pull, -tans[0] * pull), rel=1e-5)
    assert math.hypot(*rods[-1].force) == pytest.approx(pull * math.hypot(1, tans[-1]), rel=1e-5)


def rods_on_the_floor() -> Iterator[tuple[World, list[Body]]]:
    """Three pinned rods that fall a centimetre on a floor and slide there."""
    world = World(gravity=(0, -G))
    world.add(Wall((-9, 0), (9, 0)), friction=0.4)
    rods = [
        world.add(Polygon.box(0.5, 0.1), mass=1, position=(0.5 * i, 0.06), friction=0.4)
        for i in range(3)
    ]
    for i in (1, 2):
        world.join(rods[i - 1], rods[i], Pin(at=(0.5 * i - 0.25, 0.06)))
    for rod in rods:
        rod.velocity = (1, 0)
    for _ in range(180):
        world.step()
        yield world, rods


def test_a_chain_falls_and_comes_to_rest_on_the_floor() -> None:
    highest = math.inf
    rods: list[Body] = []
    for world, rods in rods_on_the_floor():  # noqa: B007
        energy = world.kinetic_energy + world.potential_energy
        assert energy <= highest + 1e-3
        highest = min(highest, energy)
        for joint in world.joints:
            a, b = joint.anchors
            assert math.dist(a, b) < 1e-4  # in the part of an impact; then 1e-9 again
    assert all(rod.speed < 1e-3 for rod in rods)
    assert all(rod.y == pytest.approx(0.05, abs=1e-3) for rod in rods)


def test_joined_bodies_that_rub_on_others_keep_angular_momentum() -> None:
    """Far from everything: a pair of pinned boxes slides along a third."""
    world = World()
    a = world.add(Polygon.box(1, 1), mass=2, velocity=(0.3, -0.2), friction=0.5)
    b = world.add(Polygon.box(1, 1), mass=1, position=(1.2, 0), velocity=(-0.2, 0), friction=0.5)
    c = world.add(Polygon.box(4, 1), mass=3, position=(0.5, -1.01), velocity=(0, 0.2), friction=0.5)
    world.join(a, b, Pin(at=(0.6, 0.2)))
    momentum, turning = world.momentum, world.angular_momentum
    for _ in range(300):
        world.step()
    assert c.vx != 0
    assert world.momentum == pytest.approx(momentum, abs=1e-13)
    assert world.angular_momentum == pytest.approx(turning, abs=1e-13)


def test_a_ball_rolls_down_a_hinged_ramp() -> None:
    """Contacts press on a joined body: the hinge and the stop carry both weights."""
    world = World(gravity=(0, -G))
    ramp = world.add(Polygon.box(2, 0.1), mass=1, position=(1, 0), friction=0.9)
    hinge = world.join(None, ramp, Pin(at=(0, 0), limits=(-0.2, 0.2)))
    ball = world.add(Circle(0.1), mass=0.5, position=(0.4, 0.16), friction=0.9)
    for _ in range(45):
        world.step()
    assert hinge.coordinate == pytest.approx(-0.2, abs=1e-6)
    start, before = ball.speed, world.time
    for _ in range(15):
        world.step()
    rolling = 2 / 3 * G * math.sin(0.2)
    assert (ball.speed - start) / (world.time - before) == pytest.approx(rolling, rel=1e-2)


@pytest.mark.parametrize("links", [2, 6, 20])
def test_a_hanging_chain_of_rods_swings_in_its_slowest_mode(links: int) -> None:
    """Small swings, with the angles of the rods as coordinates (Lagrange; Goldstein, 6.2):
    M a'' = -g K a, where a rod carries those below it as a whole, so that M_ij = m L^2
    (n - max(i, j) - 1/2) off the diagonal and m L^2 (n - i - 2/3) on it, and K_ii = m L
    (n - i - 1/2), counted from 0 at the top.
    """
    length, small = 0.4, 1e-3
    place = np.arange(links)
    masses = length**2 * (links - np.maximum.outer(place, place) - 0.5)
    masses[place, place] = length**2 * (links - place - 2 / 3)
    stiffness = np.diag(G * length * (links - place - 0.5))
    squares, shapes = np.linalg.eig(np.linalg.solve(masses, stiffness))
    slowest = int(np.argmin(squares.real))
    angles = small * shapes[:, slowest].real / np.abs(shapes[:, slowest].real).max()
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    rods: list[Body] = []
    x = y = 0.0
    for i, angle in enumerate(angles):
        half = (length / 2 * math.sin(angle), -length / 2 * math.cos(angle))
        rod = Polygon.box(length, 1e-4)
        at = (x + half[0], y + half[1])
        rods.append(world.add(rod, mass=1.0, position=at, angle=angle - math.pi / 2))
        world.join(rods[i - 1] if i else None, rods[i], Pin(at=(x, y)))
        x, y = x + 2 * half[0], y + 2 * half[1]
    period = 2 * math.pi / math.sqrt(squares.real[slowest])
    times = []
    before = rods[-1].x
    while len(times) < 3:
        world.step()
        if before < 0 <= rods[-1].x:
            times.append(world.time - rods[-1].x / rods[-1].vx)
        before = rods[-1].x
    assert (times[-1] - times[0]) / 2 == pytest.approx(period, rel=1e-4)


def test_a_long_chain_that_falls_from_the_horizontal_keeps_its_energy() -> None:
    """Twenty rods, for three seconds in which its end whips round at more than 30 rad/s."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    rods: list[Body] = []
    for i in range(20):
        rods.append(world.add(Polygon.box(0.4, 0.1), mass=0.04, position=(0.4 * i + 0.2, 0)))
        rods[i].mask = 0
        world.join(rods[i - 1] if i else None, rods[i], Pin(at=(0.4 * i, 0)))
    start, scale = world.kinetic_energy + world.potential_energy, 20 * 0.04 * G * 4
    fastest = 0.0
    for _ in range(180):
        world.step()
        fastest = max(fastest, *(abs(rod.spin) for rod in rods))
        assert abs(world.kinetic_energy + world.potential_energy - start) < 1e-3 * scale
        for joint in world.joints:
            assert math.dist(*joint.anchors) < 1e-9
    assert fastest > 30


@pytest.mark.parametrize(("links", "start"), [(20, 0.4), (20, 1.1)])
def test_chains_that_whip_for_long_are_never_torn(links: int, start: float) -> None:
    """Their ends turn at hundreds of radians a second for an instant. Where Newton's method found
    no solution for a part, or one bent the other way, joints gaped by up to a millimetre.
    """
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    rods: list[Body] = []
    x, y = 0.4 * math.cos(start), 0.4 * math.sin(start)
    for i in range(links):
        at = ((i + 0.5) * x, (i + 0.5) * y)
        rods.append(world.add(Polygon.box(0.4, 0.1), mass=0.04, position=at, angle=start))
        rods[i].mask = 0
        world.join(rods[i - 1] if i else None, rods[i], Pin(at=(i * x, i * y)))
    fastest = 0.0
    for _ in range(500):
        world.step()
        fastest = max(fastest, *(abs(rod.spin) for rod in rods))
        for joint in world.joints:
            assert math.dist(*joint.anchors) < 1e-8
    assert fastest > 100
