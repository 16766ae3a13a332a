"""Scenes of the textbooks: ladders, pencils, belts, capstans, trusses, Kapitza's pendulum.

Each against its closed form, or against its own equation of Lagrange, integrated by Runge and
Kutta's method in far shorter steps.
"""

import itertools
import math
from collections.abc import Callable

import pytest

from engine import (
    Box,
    Capsule,
    Circle,
    Distance,
    Force,
    Particle,
    Pin,
    Slider,
    Wall,
    Weld,
    World,
)

G = 9.81
LENGTH = 2.0


def still_world(gravity: float = G) -> World:
    return World(gravity=(0, -gravity), integrator="velocity-verlet")


def runge_kutta(
    bend: Callable[[float, float], float], angle: float, spin: float, lasts: float, step: float
) -> tuple[float, float]:
    """Solve angle'' = bend(angle, angle') from an angle (rad) and a spin (rad/s)."""
    for _ in range(round(lasts / step)):
        k1, l1 = spin, bend(angle, spin)
        k2, l2 = spin + step / 2 * l1, bend(angle + step / 2 * k1, spin + step / 2 * l1)
        k3, l3 = spin + step / 2 * l2, bend(angle + step / 2 * k2, spin + step / 2 * l2)
        k4, l4 = spin + step * l3, bend(angle + step * k3, spin + step * l3)
        angle += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        spin += step / 6 * (l1 + 2 * l2 + 2 * l3 + l4)
    return angle, spin


def on_ice(angle: float, spin: float) -> float:
    """Angular acceleration of a rod whose foot slides on a floor without friction."""
    half, inertia = LENGTH / 2, LENGTH**2 / 12
    pull = -half * math.cos(angle) * (G - half * math.sin(angle) * spin**2)
    return pull / (inertia + (half * math.cos(angle)) ** 2)


@pytest.mark.parametrize("start", [0.9, 1.4])
def test_a_ladder_leaves_its_wall_at_two_thirds_of_its_height(start: float) -> None:
    """Without friction it falls by theta'' = -(3 g / 2 L) cos(theta) until its top has come down to
    2/3; from then on its foot slides with the speed that it has, and it falls as on ice.
    """
    world = still_world()
    world.add(Wall((0, 0), (90, 0)))
    world.add(Wall((0, 9), (0, 0)))
    thin = 1e-6
    ladder = world.add(
        Capsule(LENGTH, thin), inertia=LENGTH**2 / 12, angle=-start,
        position=(math.cos(start) + thin, math.sin(start) + thin),
    )  # fmt: skip
    while ladder.angle < -0.1:
        world.step()
    leaves = math.asin(2 / 3 * math.sin(start))
    spin = -math.sqrt(3 * G / LENGTH * (math.sin(start) - math.sin(leaves)))
    angle, step = start, 1e-4
    turns, falls = 0.0, 0
    while angle > leaves:
        angle, turns = runge_kutta(
            lambda now, _: -1.5 * G / LENGTH * math.cos(now), angle, turns, step, step
        )
        falls += 1
    angle, turns = runge_kutta(on_ice, angle, turns, world.time - falls * step, step)
    assert ladder.vx == pytest.approx(-LENGTH / 2 * math.sin(leaves) * spin, rel=3e-4)
    assert -ladder.angle == pytest.approx(angle, abs=1e-3)
    assert -ladder.spin == pytest.approx(turns, rel=1e-3)


@pytest.mark.parametrize("start", [0.7, 1.5])
def test_a_pencil_falls_on_ice_with_its_centre_straight_down(start: float) -> None:
    """No force acts along the floor."""
    world = still_world()
    world.add(Wall((-9, 0), (9, 0)))
    pencil = world.add(
        Capsule(LENGTH, 1e-6), inertia=LENGTH**2 / 12, angle=start,
        position=(0, math.sin(start) + 1e-6),
    )  # fmt: skip
    while pencil.angle > 0.1:
        world.step()
    angle, spin = runge_kutta(on_ice, start, 0.0, world.time, 1e-4)
    assert pencil.x == 0.0
    assert pencil.angle == pytest.approx(angle, abs=1e-3)
    assert pencil.spin == pytest.approx(spin, rel=1e-3)


def test_a_beam_on_opposed_belts_swings_by_their_friction() -> None:
    """Timoshenko, "Vibration Problems in Engineering", 1928: two belts, or rollers, that run to
    each other share the weight by the law of the lever, and pull with mu N: x'' = -(mu g / a) x, a
    being half their distance, however fast they run.
    """
    world = still_world()
    for side in (-1, 1):
        world.add(
            Circle(0.3), kind="static", position=(side, -0.3), friction=0.3,
            surface_speed=side * 6.0,
        )  # fmt: skip
    beam = world.add(Box(6, 1e-3), position=(0.3, 5e-4), friction=0.3)
    rate = math.sqrt(0.3 * G)
    for _ in range(600):
        world.step()
        assert beam.x == pytest.approx(0.3 * math.cos(rate * world.time), abs=1e-3)


@pytest.mark.parametrize(("share", "holds"), [(0.98, True), (1.02, False)])
def test_a_rope_around_a_capstan_holds_e_to_the_mu_phi(share: float, holds: bool) -> None:
    """Euler, 1775. Of n beads, each bears what turns the string by d: T'/T = (cos(d/2) + mu
    sin(d/2)) / (cos(d/2) - mu sin(d/2)), half of that at the ends, which goes to e^(mu d).
    """
    mu, beads, tension = 0.3, 40, 10.0
    world = still_world(0.0)
    world.add(Circle(1.0), kind="static", friction=mu)
    turn = math.pi / (beads - 1)
    row = [
        world.add(
            Particle(0.02), mass=0.01, friction=mu,
            position=(-1.02 * math.cos(i * turn), 1.02 * math.sin(i * turn)),
        )
        for i in range(beads)
    ]  # fmt: skip
    for one, other in itertools.pairwise(row):
        world.join(one, other, Distance())
    c, s = math.cos(turn / 2), mu * math.sin(turn / 2)
    most = ((c + s) / (c - s)) ** (beads - 1)
    assert most == pytest.approx(math.exp(mu * math.pi), rel=2e-3)
    row[0].exert(Force(0, -tension))
    row[-1].exert(Force(0, -tension * most * share))
    for _ in range(60):
        world.step()
    assert (row[-1].speed < 0.1) == holds
    assert holds or row[-1].speed > 1.0


def test_the_bars_of_a_truss_bear_what_the_method_of_joints_says() -> None:
    """A Warren truss of two panels with a load P at the middle of its lower chord."""
    load, high = 1000.0, math.sqrt(3)
    world = still_world()
    places = {"A": (0.0, 0.0), "B": (2.0, 0.0), "C": (4.0, 0.0), "D": (1.0, high), "E": (3.0, high)}
    knots = {
        name: world.add(
            Particle(0.05), position=at, mass=load / G if name == "B" else 1e-3,
            gravity_scale=1.0 if name == "B" else 0.0,
        )
        for name, at in places.items()
    }  # fmt: skip
    pin = world.join(None, knots["A"], Pin(at=(0, 0)))
    roller = world.join(None, knots["C"], Slider(axis=(1, 0)))
    bars = {
        "AB": load / 2 / high, "BC": load / 2 / high, "DE": -load / high, "AD": -load / high,
        "CE": -load / high, "BD": load / high, "BE": load / high,
    }  # fmt: skip
    made = {bar: world.join(knots[bar[0]], knots[bar[1]], Distance()) for bar in bars}
    for _ in range(30):
        world.step()
    for bar, tension in bars.items():
        (x, y), (to_x, to_y) = places[bar[0]], places[bar[1]]
        pull = made[bar].force
        along = (pull.x * (x - to_x) + pull.y * (y - to_y)) / math.hypot(x - to_x, y - to_y)
        assert along == pytest.approx(tension, rel=1e-9)
    assert pin.force.y == pytest.approx(load / 2, rel=1e-9)
    assert roller.force.y == pytest.approx(load / 2, rel=1e-9)


def test_a_cantilever_breaks_at_its_root_under_the_load_of_statics() -> None:
    """The moment at the root of a beam of length L is m g L/2 + F L."""
    world = still_world()
    strength, pieces = 200.0, 5
    before = None
    welds = []
    for i in range(pieces):
        piece = world.add(Box(1, 0.2), position=(i + 0.5, 0), mask=0)
        welds.append(
            world.join(before, piece, Weld(at=(i, 0)), break_torque=None if i else strength)
        )
        before = piece
    assert before is not None
    load = (strength - pieces * G * pieces / 2) / pieces
    push = before.exert(Force(0, 0), at=(pieces, 0))
    for share in (0.5, 0.9, 0.999, 1.001):
        push.change(Force(0, -load * share))
        world.step()
        assert welds[0].broken == (share > 1)
    assert not any(weld.broken for weld in welds[1:])


@pytest.mark.parametrize(("share", "stands"), [(0.9, False), (1.2, True)])
def test_a_pendulum_stands_on_its_head_while_its_pivot_shakes(share: float, stands: bool) -> None:
    """Kapitza, 1951: upside down it is stable if a w > sqrt(2 g l), for small a/l."""
    length, rate, lean = 50.0, 10.0, 0.1
    wide = share * math.sqrt(2 * G * length) / rate
    world = still_world()
    pivot = world.add(Circle(0.01), kind="kinematic")
    bob = world.add(Particle(0.02), position=(length * math.sin(lean), length * math.cos(lean)))
    world.join(pivot, bob, Distance())
    most = 0.0
    for tick in range(1500):
        way = math.cos(rate * (tick + 1) / 60) - math.cos(rate * tick / 60)
        pivot.velocity = (0, wide * way * 60)
        world.step()
        most = max(most, abs(math.atan2(bob.x, bob.y - pivot.y)))
    assert (most < 1.5 * lean) == stands
    assert stands or most > 1.0
