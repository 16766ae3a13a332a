"""Contacts as people read them after a step: begin, stay, end; sensors."""

import json
import math
from typing import Any

import pytest

from engine import Box, Capsule, Circle, Pin, Polygon, Wall, World


def phases(world: World, ticks: int) -> list[list[tuple[str, str, str]]]:
    """Names and phases of the contacts of each tick."""
    told = []
    for _ in range(ticks):
        world.step()
        told.append([(c.a.name, c.b.name, c.phase) for c in world.contacts])
    return told


def test_a_bounce_begins_and_ends() -> None:
    world = World()
    world.add(Circle(0.5), velocity=(6, 0), name="a")
    world.add(Circle(0.5), position=(1.25, 0), name="b", restitution=1.0)
    told = phases(world, 6)
    assert told == [[], [], [("a", "b", "begin")], [("a", "b", "end")], [], []]
    assert world.contacts == []


def test_what_rests_stays_until_it_leaves() -> None:
    world = World(gravity=(0, -10))
    world.add(Wall((-2, 0), (2, 0)), name="floor")
    box = world.add(Polygon.box(1, 1), position=(0, 0.7), name="box")
    told = [each[0][2] if each else None for each in phases(world, 60)]
    first = told.index("begin")
    assert told[:first] == [None] * first
    assert set(told[first + 1 :]) == {"stay"}
    box.velocity = (0, 5)
    told = [each[0][2] if each else None for each in phases(world, 5)]
    assert told == ["end", None, None, None, None]


def test_a_contact_says_where_and_how_much() -> None:
    world = World()
    floor = world.add(Wall((-2, 0), (2, 0)))
    ball = world.add(Circle(0.5), mass=2.0, position=(0.25, 0.55), velocity=(0, -6))
    world.step()
    (contact,) = world.contacts
    assert (contact.a, contact.b, contact.phase) == (floor, ball, "begin")
    assert contact.points[0] == pytest.approx((0.25, 0.0), abs=1e-9)
    assert contact.normal == pytest.approx((0, 1))
    assert contact.impulse == pytest.approx((0, 12))
    assert not contact.sensor


def test_two_bounces_in_two_ticks_are_one_contact_that_stays() -> None:
    """A fast ball between close walls hits one of them every tick."""
    world = World()
    for x in (0.0, 1.5):
        world.add(Wall((x, -1), (x, 1)), restitution=1.0)
    world.add(Circle(0.5), position=(0.75, 0), velocity=(120, 0))
    told = [{phase for _, _, phase in each} for each in phases(world, 4)]
    assert told == [{"begin"}, {"stay"}, {"stay"}, {"stay"}]


def test_bodies_put_elsewhere_or_filtered_end_their_contacts() -> None:
    world = World(gravity=(0, -10))
    world.add(Wall((-9, 0), (9, 0)), name="floor")
    boxes = [world.add(Polygon.box(1, 1), position=(3 * i, 0.5), name=f"{i}") for i in range(3)]
    phases(world, 10)
    boxes[0].position = (0, 50)
    boxes[1].mask = 2
    world.remove(boxes[2])
    assert phases(world, 2) == [[("floor", "0", "end"), ("floor", "1", "end")], []]


def test_fast_bodies_that_leave_their_boxes_are_told_of() -> None:
    """Shot at, they fly off far within the tick: begin, with the impulse, then end."""
    world = World()
    world.add(Circle(0.5), mass=1000.0, velocity=(600, 0), name="a", restitution=1.0)
    world.add(Circle(0.5), position=(3, 0), name="b")
    for i in range(10):
        world.add(Circle(0.5), position=(20 + 3 * i, 0), name=f"c{i}")
    world.step()
    (contact,) = [c for c in world.contacts if c.a.name == "a" and c.b.name == "b"]
    assert contact.phase == "begin"
    assert contact.impulse.x > 1000
    world.step()
    assert ("a", "b", "end") in [(c.a.name, c.b.name, c.phase) for c in world.contacts]


def sensor_room(**given: Any) -> World:
    world = World()
    world.add(Polygon.box(2, 2), kind="static", sensor=True, name="gate", **given)
    return world


def test_a_sensor_notices_what_overlaps_it_and_acts_on_nothing() -> None:
    world = sensor_room()
    ball = world.add(Circle(0.5), position=(-4.05, 0), velocity=(6, 0), name="ball")
    told = phases(world, 90)
    inside = [tick for tick, each in enumerate(told, 1) if each and each[0][2] != "end"]
    # The surface meets the gate after 2.55 m, 25.5 ticks, and leaves it after 5.55 m.
    assert (inside[0], inside[-1]) == (26, 55)
    assert told[25] == [("gate", "ball", "begin")]
    assert told[55] == [("gate", "ball", "end")]
    assert {each[0][2] for each in told[26:55]} == {"stay"}
    assert ball.velocity == (6, 0)
    assert ball.x == pytest.approx(4.95)


def test_a_sensor_notices_what_comes_and_goes_within_a_tick() -> None:
    world = sensor_room()
    world.add(Circle(0.1), position=(-4, 0.3), velocity=(900, 0), name="bullet")
    assert phases(world, 3) == [
        [("gate", "bullet", "begin")],
        [("gate", "bullet", "end")],
        [],
    ]


def test_a_thin_sensor_is_a_light_barrier() -> None:
    world = World()
    world.add(Wall((0, -1), (0, 1), one_sided=True), sensor=True, name="barrier")
    world.add(Circle(0.05), position=(-1.02, 0), velocity=(60, 0), name="a")
    world.add(Circle(0.05), position=(1.02, 0.5), velocity=(-60, 0), name="b")
    told = [name for each in phases(world, 4) for _, name, phase in each if phase == "begin"]
    assert sorted(told) == ["a", "b"]


def test_sensors_fall_and_may_be_carried_about() -> None:
    world = World(gravity=(0, -10), integrator="velocity-verlet")
    world.add(Wall((-5, 0), (5, 0)), name="floor")
    falling = world.add(Circle(0.5), position=(0, 2), sensor=True, name="ghost")
    told = phases(world, 60)
    assert falling.y == pytest.approx(2 - 5)
    assert [each[0][2] for each in told if each][::999] == ["begin"]
    assert falling.is_sensor
    assert world.query_point(falling.position) == []
    assert world.cast_ray((-5, falling.y), (5, falling.y)) is None


def test_contacts_are_saved_and_restored() -> None:
    world = World(gravity=(0, -10))
    world.add(Wall((-9, 0), (9, 0)))
    world.add(Polygon.box(1, 1), position=(0, 0.5))
    world.add(Circle(0.5), kind="static", position=(0.5, 0.5), sensor=True)
    for _ in range(10):
        world.step()
    saved, loaded = world.snapshot(), World.from_dict(json.loads(json.dumps(world.to_dict())))
    told = phases(world, 3)
    assert phases(loaded, 3) == told
    world.restore(saved)
    assert phases(world, 3) == told
    plain = World()
    plain.add(Circle(1))
    other = World()
    other.add(Circle(1), sensor=True)
    assert plain.digest() != other.digest()


def test_a_sensor_is_true_or_false() -> None:
    with pytest.raises(TypeError, match="sensor must be True or False, not 1"):
        World().add(Circle(1), sensor=1)  # type: ignore[arg-type]


def test_links_that_jam_where_they_meet_begin_to_touch() -> None:
    """Joints left nothing to be exchanged: they came to rest unnoted, and stayed without having
    begun.
    """
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    world.add(Wall((-12, 0), (12, 0)))
    rod = world.add(Capsule(0.55, 0.12), position=(0, 0.4), friction=0)
    box = world.add(Box(0.8, 0.25), position=(0.8, 0.4), velocity=(0, -2), friction=0)
    world.join(None, rod, Pin((-0.4, 0.4)))
    world.join(rod, box, Pin((0.4, 0.4)), collide=True)
    touching: set[tuple[int, int]] = set()
    for _ in range(12):
        world.step()
        phases = {(contact.a.id, contact.b.id): contact.phase for contact in world.contacts}
        assert {pair for pair, phase in phases.items() if phase != "begin"} == touching
        for contact in world.contacts:
            assert contact.phase == "end" or math.hypot(*contact.normal) == pytest.approx(1.0)
        touching = {pair for pair, phase in phases.items() if phase != "end"}
    assert (rod.id, box.id) in touching
