"""Sleep: who falls asleep, what wakes whom, and how little it changes."""

import json
import math
from collections.abc import Callable
from typing import Any

import pytest

from engine import Body, Circle, Force, Polygon, Sleep, SpringTo, Wall, Weld, World


def run(world: World, seconds: float) -> None:
    for _ in range(round(60 * seconds)):
        world.step()


def stack(sleeping: Any = True, boxes: int = 3) -> tuple[World, list[Body]]:
    world = World(gravity=(0, -9.81), integrator="velocity-verlet", sleeping=sleeping)
    floor = world.add(Wall((-20, 0), (20, 0)), friction=0.5, name="floor")
    return world, [floor] + [
        world.add(Polygon.box(1, 1), position=(0, 0.5 + i), friction=0.5) for i in range(boxes)
    ]


def asleep(world: World) -> list[bool]:
    return [body.is_asleep for body in world if body.is_dynamic]


def test_what_rests_falls_asleep_and_is_wrong_by_no_more_than_the_bound() -> None:
    """At most `speed` times the time that it slept, against the same world that stays awake."""
    rule = Sleep(speed=0.02, time=0.25)
    world, bodies = stack(rule)
    awake, others = stack(False)
    run(world, 2.0)
    run(awake, 2.0)
    assert asleep(world) == [True] * 3
    assert asleep(awake) == [False] * 3
    slept_since = world.time
    for _ in range(10):
        run(world, 0.5)
        run(awake, 0.5)
        bound = rule.speed * (world.time - slept_since + 2.0)
        for body, other in zip(bodies[1:], others[1:], strict=True):
            assert math.dist(body.position, other.position) < bound
            assert abs(body.speed - other.speed) < rule.speed
    assert asleep(world) == [True] * 3
    assert all(body.kind == "dynamic" for body in bodies[1:])
    assert [body.mass for body in bodies[1:]] == [1.0] * 3


def test_nothing_sleeps_unless_asked_for() -> None:
    world, _ = stack(False)
    run(world, 2.0)
    assert not any(asleep(world))


def test_an_island_sleeps_only_as_a_whole() -> None:
    world, bodies = stack()
    apart = world.add(Polygon.box(1, 1), position=(9, 0.5))
    push = bodies[3].exert(Force(0.01, 0))
    run(world, 2.0)
    assert asleep(world) == [False] * 3 + [True]
    push.stop()
    run(world, 1.0)
    assert asleep(world) == [True] * 4
    bodies[1].wake()
    assert asleep(world) == [False] * 3 + [True]
    assert apart.is_asleep


def test_what_drifts_or_rides_does_not_sleep() -> None:
    world = World(gravity=(0, -10), sleeping=Sleep(speed=0.1, time=0.2))
    drifting = world.add(Circle(0.5), position=(0, 50), velocity=(0.01, 0), gravity_scale=0.0)
    lift = world.add(Polygon.box(2, 1), kind="kinematic", velocity=(0, 0.05), friction=1.0)
    riding = world.add(Polygon.box(1, 1), position=(0, 1), friction=1.0)
    run(world, 3.0)
    assert not drifting.is_asleep
    assert drifting.x == pytest.approx(0.03)
    assert not riding.is_asleep
    lift.velocity = (0, 0)
    run(world, 2.0)
    assert riding.is_asleep
    lift.velocity = (0, 0.05)
    assert not riding.is_asleep


def test_joined_bodies_do_not_sleep() -> None:
    world, bodies = stack()
    run(world, 2.0)
    joint = world.join(bodies[1], bodies[2], Weld(at=(0, 1)))
    assert asleep(world) == [False] * 3
    run(world, 2.0)
    assert asleep(world) == [False] * 3
    joint.remove()
    run(world, 2.0)
    assert asleep(world) == [True] * 3


def test_a_pushed_body_stays_awake_and_so_does_one_under_a_function() -> None:
    world, bodies = stack(boxes=1)
    push = bodies[1].exert(Force(0.1, 0))
    run(world, 2.0)
    assert not bodies[1].is_asleep
    push.stop()
    law = world.add_law(lambda body, time: None)
    run(world, 2.0)
    assert not bodies[1].is_asleep
    law.remove()
    run(world, 2.0)
    assert bodies[1].is_asleep


WAKERS: list[Callable[[World, list[Body]], Any]] = [
    lambda world, bodies: bodies[3].exert(Force(1, 0), duration=0.1),
    lambda world, bodies: bodies[1].apply_impulse((0.1, 0)),
    lambda world, bodies: setattr(bodies[2], "velocity", (0.1, 0)),
    lambda world, bodies: setattr(bodies[2], "spin", 0.1),
    lambda world, bodies: setattr(bodies[1], "position", (0, 0.5)),
    lambda world, bodies: setattr(bodies[3], "mass", 2.0),
    lambda world, bodies: setattr(bodies[1], "friction", 0.1),
    lambda world, bodies: setattr(bodies[0], "mask", 2),
    lambda world, bodies: setattr(world, "gravity", (0, -1)),
    lambda world, bodies: world.remove(bodies[0]),
    lambda world, bodies: world.add_law(SpringTo((0, 9), 1.0)),
    lambda world, bodies: world.ignore(bodies[0], bodies[1]),
    lambda world, bodies: world.set_state(world.state()),
    lambda world, bodies: bodies[3].wake(),
]


@pytest.mark.parametrize("waker", WAKERS)
def test_all_that_people_do_wakes_a_whole_island(
    waker: Callable[[World, list[Body]], Any],
) -> None:
    world, bodies = stack()
    run(world, 2.0)
    assert asleep(world) == [True] * 3
    waker(world, bodies)
    assert asleep(world) == [False] * 3
    world.step()


def test_what_loses_its_floor_falls() -> None:
    world, bodies = stack()
    run(world, 2.0)
    world.remove(bodies[0])
    run(world, 1.0)
    for i, body in enumerate(bodies[1:]):
        assert body.y == pytest.approx(0.5 + i - 9.81 / 2, abs=1e-2)


def test_a_blow_wakes_before_it_falls_and_moves_what_slept() -> None:
    """The ball gives the sleeping box what it would give one that is awake (eq. 40)."""
    ends = []
    for sleeping in (True, False):
        world, bodies = stack(sleeping, boxes=1)
        world.add(Polygon.box(1, 1), position=(1.0, 0.5), friction=0.5)
        run(world, 2.0)
        assert any(asleep(world)) == sleeping
        ball = world.add(
            Circle(0.3), mass=2.0, position=(-7.3, 0.45), velocity=(8, 0), restitution=0.5,
            gravity_scale=0.0,
        )  # fmt: skip
        run(world, 0.5)
        assert any(asleep(world)) == sleeping
        run(world, 0.5)
        assert not any(asleep(world))
        ends.append([ball.velocity, bodies[1].velocity, bodies[1].position])
    for slept, woke in zip(*ends, strict=True):
        assert slept == pytest.approx(woke, abs=2e-2)


def test_a_new_body_leaves_others_asleep_until_it_comes() -> None:
    world, _ = stack()
    run(world, 2.0)
    world.add(Circle(0.3), position=(0, 6))
    world.add(Polygon.box(1, 1), position=(9, 0.5))
    run(world, 0.5)
    assert asleep(world)[:3] == [True] * 3
    run(world, 0.4)
    assert asleep(world)[:3] == [False] * 3


def test_sleepers_still_touch() -> None:
    world, _ = stack(boxes=2)
    run(world, 2.0)
    assert [(c.a.name, c.phase, c.impulse, len(c.points)) for c in world.contacts] == [
        ("floor", "stay", (0, 0), 2),
        ("polygon 2", "stay", (0, 0), 2),
    ]


def test_sleep_is_saved_and_restored() -> None:
    world, bodies = stack()
    run(world, 2.0)
    saved, loaded = world.snapshot(), World.from_dict(json.loads(json.dumps(world.to_dict())))
    for each in (world, loaded):
        each.add(Circle(0.3), position=(0, 6))
        run(each, 1.5)
    assert loaded.digest() == world.digest()
    end = world.digest()
    world.restore(saved)
    assert asleep(world) == [True] * 3
    world.add(Circle(0.3), position=(0, 6))
    run(world, 1.5)
    assert {body.id for body in world} == {1, 2, 3, 4, 5}
    assert world.digest() == end
    del bodies


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (lambda: Sleep(speed=0), "sleep speed must be greater than zero, not 0"),
        (lambda: Sleep(time=math.nan), "sleep time must be finite, not nan"),
        (lambda: World(sleeping=1), "sleeping must be True, False or a Sleep, not 1"),
        (lambda: World(sleeping="yes"), "sleeping must be True, False or a Sleep, not 'yes'"),
    ],
)
def test_bad_input_is_refused(make: Callable[[], Any], sentence: str) -> None:
    with pytest.raises((TypeError, ValueError), match=sentence):
        make()
