"""The joints as people use them: what they refuse, say and remember."""

import json
import math
from typing import Any

import pytest

from engine import (
    Circle,
    Distance,
    Joint,
    Particle,
    Pin,
    Polygon,
    Pulley,
    Removed,
    Rope,
    Slider,
    Spring,
    Wall,
    Weld,
    World,
    replay,
)


def two() -> tuple[World, Any, Any]:
    world = World(gravity=(0, -9.81))
    a = world.add(Circle(0.2), position=(0, 0), name="a")
    return world, a, world.add(Polygon.box(0.4, 0.4), position=(1, 0), name="b")


def zoo() -> World:
    """One joint of each kind, with limits and motors, between bodies, walls and the world."""
    world = World(gravity=(0, -9.81))
    floor = world.add(Wall((-9, -3), (9, -3)), friction=0.5)
    before = None
    for i in range(4):
        link = world.add(Polygon.box(0.5, 0.2), mass=0.5, position=(0.5 * i + 0.25, 0))
        limits = (-0.5, 0.8) if i == 3 else None
        speed = 2.0 if i == 2 else None
        pin = Pin(at=(0.5 * i, 0), limits=limits, motor_speed=speed, max_torque=0.5)
        world.join(before, link, pin)
        before = link
    ball = world.add(Circle(0.3), mass=2, position=(-2, -2), friction=0.5)
    box = world.add(Polygon.regular(5, 0.4), position=(-3, -1), friction=0.4)
    world.join(ball, box, Spring(300, 2, length=0.8))
    light = world.add(Particle(0.2), position=(-4, 1))
    world.join(light, world.add(Circle(0.2), position=(-5, 1)), Pulley((-4, 5), (-5, 5)))
    one = world.add(Polygon.box(0.3, 0.3), position=(5, 1))
    other = world.add(Polygon.box(0.3, 0.3), position=(5.3, 1), spin=2)
    world.join(one, other, Weld())
    world.join(other, world.add(Circle(0.2), position=(6, 0)), Rope(length=1.6))
    cart = world.add(Circle(0.2), position=(8, 0))
    world.join(floor, cart, Slider(axis=(1, 1), limits=(-1, 1)), break_force=60)
    world.join(world.body(11), cart, Distance())
    return world


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (lambda: Distance(length=0), "length must be greater than zero, not 0.0"),
        (lambda: Rope(anchor_a=(1, math.nan)), r"anchor_a\[1\] must be finite, not nan"),
        (lambda: Rope(length=-1), "length must be greater than zero, not -1.0"),
        (lambda: Spring(-1), "stiffness must not be negative, not -1.0"),
        (lambda: Spring(1, math.inf), "damping must be finite, not inf"),
        (lambda: Spring(0), "a spring needs a stiffness or a damping, not 0.0 for both"),
        (lambda: Pin(at=None), "at must be a pair of numbers, not None"),
        (lambda: Pin((0, 0), limits=(1, 0)), r"limits must be a pair \(low, high\), not \(1.0, 0"),
        (lambda: Pin((0, 0), limits=(0, math.nan)), r"limits\[1\] must be finite, not nan"),
        (lambda: Pin((0, 0), limits=3), r"limits must be a pair \(low, high\), not 3"),
        (lambda: Pin((0, 0), limits=(1, 2, 3)), "not 3 of them"),
        (lambda: Pin((0, 0), motor_speed=math.inf), "motor_speed must be finite, not inf"),
        (lambda: Pin((0, 0), max_torque=0), "max_torque must be greater than zero, not 0.0"),
        (lambda: Slider(axis=(0, 0)), r"axis must have a direction, not \(0.0, 0.0\)"),
        (lambda: Slider((1, 0), max_force=-1), "max_force must be greater than zero, not -1.0"),
        (lambda: Weld(at=(1,)), "at must be a pair of numbers, not 1 of them"),
        (lambda: Pulley((0, 0), (1, 0), ratio=0), "ratio must be greater than zero, not 0.0"),
        (lambda: Pulley("ab", (1, 0)), "over_a must be a pair of numbers, not 'ab'"),
    ],
)
def test_a_wrong_joint_is_refused_in_one_sentence(make: Any, sentence: str) -> None:
    with pytest.raises((TypeError, ValueError), match=sentence):
        make()


def test_wrong_joining_is_refused_in_one_sentence() -> None:
    world, a, b = two()
    wall = world.add(Wall((0, -1), (1, -1)))
    for args, given, sentence in (
        ((a, a, Weld()), {}, "a cannot be joined with itself"),
        ((None, None, Weld()), {}, "the world cannot be joined with itself"),
        ((a, b, "pin"), {}, "bodies are joined by a Pin, Rope, Spring, ..., not 'pin'"),
        ((a, b, Pin), {}, "bodies are joined by a Pin"),
        ((wall, None, Pin((0, -1))), {}, "one of the two that are joined must be movable"),
        ((None, a, Rope(length=1)), {}, "a Rope with the world needs its anchor_a"),
        ((a, None, Pulley((0, 1), (1, 1))), {}, "a Pulley joins two bodies"),
        ((None, a, Distance(anchor_a=(0, 0))), {}, "a Distance needs a length"),
        ((a, b, Weld()), {"break_force": 0}, "break_force must be greater than zero, not 0.0"),
        ((a, b, Weld()), {"break_torque": math.nan}, "break_torque must be finite, not nan"),
        ((a, b, Weld()), {"collide": 1}, "collide must be True or False, not 1"),
    ):
        with pytest.raises((TypeError, ValueError), match=sentence):
            world.join(*args, **given)
    assert world.joints == ()
    world.remove(a)
    with pytest.raises(Removed, match="a is not in this world"):
        world.join(a, b, Weld())


def test_a_joint_says_what_it_is_and_can_be_changed() -> None:
    world, a, b = two()
    pin = world.join(a, b, Pin(at=(0.5, 0)))
    assert repr(pin) == "<Joint 1, a to b: Pin>"
    assert (pin.kind, pin.limits, pin.motor_speed, pin.broken) == (Pin, None, None, False)
    assert pin.anchors == ((0.5, 0), (0.5, 0))
    pin.limits = (-1, 2)
    pin.motor_speed = 3
    assert (pin.limits, pin.motor_speed) == ((-1, 2), 3)
    world.step()
    assert b.spin - a.spin == pytest.approx(3)
    assert pin.coordinate == pytest.approx(b.angle - a.angle)
    with pytest.raises(ValueError, match="a Pin has no length"):
        _ = pin.length
    rope = world.join(None, a, Rope(anchor_a=(0, 2)))
    assert rope.length == rope.coordinate == math.dist(a.position, (0, 2))
    rope.length = 1.5
    for _ in range(60):
        world.step()
    assert rope.coordinate <= 1.5 + 1e-6
    with pytest.raises(ValueError, match="length must be greater than zero"):
        rope.length = 0
    assert world.joint(1) is pin
    assert world.joints == (pin, rope)
    with pytest.raises(Removed, match="there is no joint 3 in this world"):
        world.joint(3)


def test_joined_bodies_do_not_touch_each_other_unless_told() -> None:
    for collide in (False, True):
        world = World()
        a = world.add(Circle(0.5), position=(0, 0), velocity=(1, 0), restitution=1.0)
        b = world.add(Circle(0.5), position=(1.5, 0))
        rope = world.join(a, b, Rope(length=4), collide=collide)
        hits = sum(len(world.step()) for _ in range(60))
        assert hits == int(collide)
        assert world.ignores(a, b) is not collide
        rope.remove()
        assert not world.ignores(a, b)


def test_what_is_removed_is_refused() -> None:
    world, a, b = two()
    pin = world.join(a, b, Pin(at=(0.5, 0)))
    weld = world.join(None, a, Weld())
    world.remove(b)
    assert world.joints == (weld,)
    with pytest.raises(Removed, match="there is no joint 1 in this world"):
        _ = pin.force
    weld.remove()
    with pytest.raises(Removed, match="there is no joint 2 in this world"):
        weld.remove()
    world.step()
    assert a.vy == pytest.approx(-9.81 / 60)


def test_removing_a_body_leaves_the_other_joints_as_they_were() -> None:
    worlds = []
    for extra in (False, True):
        world = World(gravity=(0, -9.81))
        stray = world.add(Circle(0.1), position=(50, 0)) if extra else None
        rods = [world.add(Polygon.box(1, 0.1), position=(i + 0.5, 0)) for i in range(3)]
        for i, rod in enumerate(rods):
            world.join(rods[i - 1] if i else None, rod, Pin(at=(i, 0)))
        for tick in range(40):
            if tick == 20 and stray is not None:
                world.remove(stray)
            world.step()
        worlds.append([(rod.position, rod.angle, rod.velocity) for rod in rods])
    assert worlds[0] == worlds[1]


def test_a_plank_on_two_nails_holds() -> None:
    """Two pins say the same twice; neither may break down."""
    world = World(gravity=(0, -9.81))
    plank = world.add(Polygon.box(2, 0.1), mass=3)
    pins = [world.join(None, plank, Pin(at=(x, 0))) for x in (-0.8, 0.8)]
    for _ in range(60):
        world.step()
    assert plank.position == pytest.approx((0, 0), abs=1e-9)
    assert sum(pin.force.y for pin in pins) == pytest.approx(3 * 9.81)


def test_a_closed_ring_holds() -> None:
    world = World()
    ring = [
        world.add(Circle(0.2), position=(math.cos(i), math.sin(i)), velocity=(0, int(i == 0)))
        for i in (2 * math.pi * k / 8 for k in range(8))
    ]
    for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
        world.join(a, b, Distance())
    for _ in range(120):
        world.step()
    for joint in world.joints:
        assert joint.coordinate == pytest.approx(joint.length, abs=1e-8)
    assert world.momentum == pytest.approx((0, 1), abs=1e-12)


def test_a_wild_spin_stays_finite() -> None:
    world = World()
    a = world.add(Polygon.box(1, 0.1), spin=400)
    b = world.add(Polygon.box(1, 0.1), position=(1, 0), spin=-300)
    world.join(a, b, Pin(at=(0.5, 0)))
    energy = world.kinetic_energy
    for _ in range(120):
        world.step()
        assert world.kinetic_energy < 2 * energy
    assert world.momentum == pytest.approx((0, 0), abs=1e-6)


def test_joints_break_and_call_back_after_the_step() -> None:
    world = zoo()
    told: list[tuple[Joint, int]] = []
    for joint in world.joints:
        joint.on_break = lambda broken: told.append((broken, world.tick))
    for _ in range(120):
        world.step()
    broken = [joint for joint in world.joints if joint.broken]
    assert broken
    assert [joint for joint, _ in told] == broken
    assert all(joint.kind is Slider for joint in broken)


def test_a_snapshot_with_joints_goes_on_bit_for_bit() -> None:
    world = zoo()
    for _ in range(30):
        world.step()
    saved, data = world.snapshot(), json.loads(json.dumps(world.to_dict()))
    pin = world.joints[1]
    for _ in range(30):
        world.step()
    digest = world.digest()
    pin.remove()
    world.remove(world.body(3))
    world.step()
    world.restore(saved)
    assert world.joints[1] is pin
    loaded = World.from_dict(data)
    for other in (world, loaded):
        for _ in range(30):
            other.step()
        assert other.digest() == digest
    assert [joint.kind for joint in loaded.joints] == [joint.kind for joint in world.joints]
    assert loaded.to_dict() == world.to_dict()


def test_the_digest_tells_worlds_with_different_joints_apart() -> None:
    digests = set()
    for stiffness in (10, 20):
        world, a, b = two()
        world.join(a, b, Spring(stiffness))
        digests.add(world.digest())
    world, _, _ = two()
    assert len(digests | {world.digest()}) == 3


def test_joints_are_recorded_and_replayed() -> None:
    world, a, b = two()
    with world.record() as recording:
        pin = world.join(None, a, Pin(at=(0, 1), limits=(-1, 1)))
        rope = world.join(a, b, Rope(length=2), collide=True)
        world.step()
        pin.motor_speed = 2.0
        rope.length = 0.9
        for _ in range(20):
            world.step()
        rope.remove()
        world.step()
    assert replay(recording).digest() == world.digest()


def test_a_joint_that_was_removed_does_not_come_back_with_an_older_moment() -> None:
    """Where no step lies between its removal and the return to a moment without joints."""
    world = World(gravity=(0, -9.81))
    body = world.add(Circle(0.5), position=(0, 0))
    moment = world.snapshot()
    joint = world.join(None, body, Pin(at=(0, 0)))
    world.step()
    joint.remove()
    world.restore(moment)
    world.step()
    assert body.vy == pytest.approx(-9.81 / 60)


def test_springs_and_motors_may_be_set_anew() -> None:
    world = World(gravity=(0, -10), integrator="velocity-verlet")
    body = world.add(Circle(0.5), mass=2.0, position=(0, -1))
    wheel = world.add(Circle(0.5), mass=2.0, position=(5, 0))
    spring = world.join(None, body, Spring(100.0, 50.0, anchor_a=(0, 0), length=1.0))
    axle = world.join(None, wheel, Pin(at=(5, 0), motor_speed=100.0))
    rail = world.join(None, world.add(Circle(0.5), position=(9, 0)), Slider((1, 0)))
    with world.record() as recording:
        assert (spring.stiffness, spring.damping) == (100.0, 50.0)
        assert (axle.max_torque, rail.max_force) == (math.inf, math.inf)
        spring.stiffness, spring.damping, axle.max_torque, rail.max_force = 200.0, 60.0, 0.5, 3
        assert (axle.max_torque, rail.max_force) == (0.5, 3.0)
        world.run(600)
    assert body.y == pytest.approx(-1.1)  # m g / k
    assert axle.torque == pytest.approx(0.5)
    assert replay(recording).digest() == world.digest()
    before = world.digest()
    for joint, name, value in (
        (spring, "stiffness", -1), (spring, "damping", math.nan), (spring, "max_torque", 1),
        (axle, "max_torque", 0), (axle, "max_force", 1), (rail, "max_force", None),
    ):  # fmt: skip
        with pytest.raises((TypeError, ValueError), match=name):
            setattr(joint, name, value)
    spring.damping = 0
    with pytest.raises(ValueError, match="a spring needs a stiffness or a damping"):
        spring.stiffness = 0
    spring.damping = 60.0
    assert world.digest() == before
