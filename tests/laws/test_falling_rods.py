"""Rods that fall over: chimneys, and pencils with a rough foot.

A rod of length L hinged at its foot falls by w^2 = (3 g/L)(cos(t_0) - cos(t)), t from the vertical,
and its end faster than freely; it breaks by bending, at a third of its height (Varieschi and
Kamiya, Am. J. Phys. 71, 2003). On a rough floor its foot first stands, then slides backwards or, if
mu > 0.371, forwards (Lindner, "Fallende Stäbe"; Cross, Am. J. Phys. 74, 2006).
"""

import math

import pytest

from engine import Body, Box, Pin, Wall, Weld, World

G = 9.81
LENGTH = 2.0


def still_world() -> World:
    return World(gravity=(0, -G), integrator="velocity-verlet")


def test_a_hinged_rod_falls_by_its_energy() -> None:
    world = still_world()
    start = math.pi / 2 - 0.01
    place = (math.cos(start), math.sin(start))
    rod = world.add(Box(LENGTH, 0.001), position=place, angle=start)
    world.join(None, rod, Pin(at=(0, 0)))
    while rod.angle > 0.2:
        world.step()
    spin = math.sqrt(3 * G / LENGTH * (math.sin(start) - math.sin(rod.angle)))
    assert rod.spin == pytest.approx(-spin, rel=5e-5)


@pytest.mark.parametrize("degrees", [20, 50])
def test_the_end_of_a_hinged_rod_overtakes_a_free_fall(degrees: float) -> None:
    """Its acceleration downwards is (3/2) g cos^2, which is more than g below 35.3 degrees."""
    world = still_world()
    start = math.radians(degrees)
    place = (math.cos(start), math.sin(start))
    rod = world.add(Box(LENGTH, 0.001), position=place, angle=start)
    world.join(None, rod, Pin(at=(0, 0)))
    world.step(1e-4)
    end = rod.velocity_at((LENGTH * math.cos(start), LENGTH * math.sin(start)))
    assert end.y / -1e-4 == pytest.approx(1.5 * G * math.cos(start) ** 2, rel=1e-5)


def test_a_falling_chimney_breaks_at_a_third_of_its_height() -> None:
    """The bending moment is (m g cos/4)(x/L)(1 - x/L)^2 L, x from the foot."""
    world = still_world()
    start, count = 1.2, 12
    long = LENGTH / count
    along = (math.cos(start), math.sin(start))
    pieces: list[Body] = []
    for i in range(count):
        at = (i + 0.5) * long
        place = (at * along[0], at * along[1])
        pieces.append(world.add(Box(long, 0.001), mass=1 / count, position=place, angle=start))
    world.join(None, pieces[0], Pin(at=(0, 0)))
    welds = []
    for i in range(1, count):
        at = i * long
        weld = Weld(at=(at * along[0], at * along[1]))
        welds.append(world.join(pieces[i - 1], pieces[i], weld))
    world.run(5)
    angles = [pieces[0].angle]
    world.step()
    middle = (angles[0] + pieces[0].angle) / 2
    shares = [i / count for i in range(1, count)]
    moments = [abs(weld.torque) for weld in welds]
    heaviest = G * math.cos(middle) / 4 * LENGTH
    assert moments == pytest.approx([heaviest * s * (1 - s) ** 2 for s in shares], rel=1e-3)
    assert shares[moments.index(max(moments))] == pytest.approx(1 / 3)


def tipped(mu: float, lean: float, until: float) -> tuple[float, float, float]:
    """Time (s), way of the foot (m) and spin (rad/s) of a rod that leans by `until` (rad), which
    leant by `lean` at rest: Newton's equations with Coulomb's law, in steps of 10 microseconds.
    """
    step, inertia = 1e-5, 1 / 3
    time = spin = foot = speed = 0.0
    slides = 0.0
    while lean < until:
        c, s = math.cos(lean), math.sin(lean)
        if slides == 0.0:
            bends = 0.75 * G * s
            along = bends * c - spin * spin * s
            if abs(along) > mu * (G - bends * s - spin * spin * c):
                slides = math.copysign(1.0, along)
        if slides != 0.0:
            lever = s - slides * mu * c
            press = (G - c * spin * spin) / (1 + s * lever / inertia)
            bends = lever * press / inertia
            speed += (slides * mu * press - c * bends + s * spin * spin) * step
            foot += speed * step
            if speed * slides > 0:
                slides = speed = 0.0
        spin += bends * step
        lean += spin * step
        time += step
    return time, foot, spin


@pytest.mark.parametrize("mu", [0.1, 0.3, 0.36, 0.5, 1.0])
def test_the_foot_of_a_falling_rod_slides_by_coulombs_law(mu: float) -> None:
    world = still_world()
    world.add(Wall((-9, 0), (9, 0)), friction=mu)
    lean, until = 0.1, 1.45
    place = (math.sin(lean), math.cos(lean))
    rod = world.add(
        Box(LENGTH, 1e-6), mass=1.0, position=place, angle=math.pi / 2 - lean, friction=mu
    )
    start = rod.to_world((-1, 0)).x
    before = now = (0.0, 0.0, 0.0, lean)
    while now[3] < until:
        before = now
        world.step()
        foot = rod.to_world((-1, 0)).x - start
        now = (world.time, foot, -rod.spin, math.pi / 2 - rod.angle)
    share = (until - before[3]) / (now[3] - before[3])
    time, foot, spin = (a + share * (b - a) for a, b in zip(before[:3], now[:3], strict=True))
    expected = tipped(mu, lean, until)
    assert time == pytest.approx(expected[0], rel=5e-4)
    assert foot == pytest.approx(expected[1], abs=1.5e-3)
    assert spin == pytest.approx(expected[2], rel=2e-3)
