"""Joined bodies that touch others: what hinges and contacts carry together, and that they rest."""

import math
from collections import Counter

import pytest

from engine import Body, Circle, Pin, Polygon, Wall, World

G = 9.81


def floor_world(friction: float = 0.5) -> World:
    """A floor under gravity."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-20, 0), (20, 0)), friction=friction)
    return world


def energy(world: World) -> float:
    """Kinetic and potential (J)."""
    return world.kinetic_energy + world.potential_energy


def widest_gap(world: World) -> float:
    """Of all joints (m)."""
    return max(math.dist(*joint.anchors) for joint in world.joints)


@pytest.mark.parametrize("degrees", [40, 60])
def test_two_rods_that_lean_on_each_other_thrust_on_their_hinge_as_statics_say(
    degrees: float,
) -> None:
    """An arch of three hinges: moments about a foot give the thrust, H h = m g a, everywhere.

    The feet are corners that friction holds; a is how far the centre of a rod is from its foot, h
    how high the crown is above it (Coulomb, 1776).
    """
    world = floor_world(friction=0.9)
    length, thickness, mass = 2.0, 0.1, 3.0
    tilt = math.radians(degrees)
    cos, sin = math.cos(tilt), math.sin(tilt)
    way = length / 2 * cos - thickness / 2 * sin
    rise = length / 2 * sin + thickness / 2 * cos
    rods = [
        world.add(
            Polygon.box(length, thickness),
            mass=mass,
            position=(-side * length / 2 * cos, rise),
            angle=side * tilt,
            friction=0.9,
        )
        for side in (1, -1)
    ]
    crown = world.join(*rods, Pin(at=(0, rise + length / 2 * sin)))
    for _ in range(120):
        world.step()
    thrust = mass * G * way / (rise + length / 2 * sin)
    assert crown.force.x == pytest.approx(thrust, rel=2e-3)
    assert crown.force.y == pytest.approx(0.0, abs=2e-3 * thrust)
    for contact in world.contacts:
        assert contact.impulse.y * 60 == pytest.approx(mass * G, rel=2e-3)
        assert abs(contact.impulse.x) * 60 == pytest.approx(thrust, rel=2e-3)
    assert max(rod.speed for rod in rods) == 0.0


def test_a_hinged_pair_of_boxes_stays_where_it_lies_for_a_minute() -> None:
    world = floor_world()
    boxes = [world.add(Polygon.box(1, 0.4), mass=1, position=(x, 0.2)) for x in (-0.5, 0.5)]
    world.join(*boxes, Pin(at=(0, 0.2)))
    for _ in range(120):
        world.step()
    lie = [(*box.position, box.angle) for box in boxes]
    for _ in range(3480):
        world.step()
    for box, place in zip(boxes, lie, strict=True):
        assert (*box.position, box.angle) == pytest.approx(place, abs=1e-12)
    assert max(box.speed + abs(box.spin) for box in boxes) < 1e-12
    assert lie[0][1] == pytest.approx(0.2, abs=1e-3)


def doll(world: World, x: float, y: float) -> list[Body]:
    """A trunk with a head, two arms and two legs of two parts each."""
    parts = {
        "trunk": (0.0, 0.9, 0.4, 0.6),
        "head": (0.0, 1.35, 0.2, 0.3),
        "left arm": (-0.4, 1.1, 0.4, 0.1),
        "left hand": (-0.8, 1.1, 0.4, 0.1),
        "right arm": (0.4, 1.1, 0.4, 0.1),
        "right hand": (0.8, 1.1, 0.4, 0.1),
        "left thigh": (-0.12, 0.4, 0.12, 0.4),
        "left shin": (-0.12, 0.0, 0.12, 0.4),
        "right thigh": (0.12, 0.4, 0.12, 0.4),
        "right shin": (0.12, 0.0, 0.12, 0.4),
    }
    pins = (
        ("trunk", "head", 0.0, 1.2), ("trunk", "left arm", -0.2, 1.1),
        ("left arm", "left hand", -0.6, 1.1), ("trunk", "right arm", 0.2, 1.1),
        ("right arm", "right hand", 0.6, 1.1), ("trunk", "left thigh", -0.12, 0.6),
        ("left thigh", "left shin", -0.12, 0.2), ("trunk", "right thigh", 0.12, 0.6),
        ("right thigh", "right shin", 0.12, 0.2),
    )  # fmt: skip
    bodies = {
        name: world.add(
            Polygon.box(width, height),
            mass=width * height,
            position=(x + at_x, y + at_y),
            friction=0.2,
            name=name,
        )
        for name, (at_x, at_y, width, height) in parts.items()
    }
    for a, b, at_x, at_y in pins:
        world.join(bodies[a], bodies[b], Pin(at=(x + at_x, y + at_y)))
    return list(bodies.values())


@pytest.mark.parametrize("height", [0.82, 0.9, 0.98])
def test_a_doll_falls_and_comes_to_rest(height: float) -> None:
    """Only gravity drives it: it gains no energy, but for 0.5 % where limbs that jam are
    pushed out of each other, and in the end nothing moves at all.
    """
    world = floor_world(friction=0.2)
    bodies = doll(world, 0.0, height)
    first = highest = energy(world)
    for _ in range(240):
        blows = Counter((hit.a.id, hit.b.id) for hit in world.step())
        assert max(blows.values(), default=0) < 25  # what is wedged is not struck without end
        now = energy(world)
        assert now <= highest + 0.005 * first
        highest = min(highest, now)
        assert widest_gap(world) < 1e-4
    assert max(body.speed + abs(body.spin) for body in bodies) == 0.0


def test_a_hinge_that_holds_a_disc_within_the_floor_wins_and_nothing_moves() -> None:
    """A hinge and a contact that contradict each other: the one is rigid, the other yields, and the
    hinge bears what both weight and floor push with.
    """
    world = floor_world()
    disc = world.add(Circle(0.1), mass=1, position=(0, 0.098))
    hinge = world.join(None, disc, Pin(at=(0, 0.098)))
    for _ in range(240):
        world.step()
        assert world.kinetic_energy < 1e-9
    assert widest_gap(world) < 1e-9
    (contact,) = world.contacts
    assert contact.impulse.y > 0
    assert hinge.force.y + contact.impulse.y * 60 == pytest.approx(G, rel=1e-6)
