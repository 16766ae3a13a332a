"""Laws of force as people use them: adding, removing, refusing, coming back."""

import json
import math
from typing import Any

import pytest

from engine import (
    Body,
    Circle,
    Force,
    PointGravity,
    Polygon,
    Recording,
    Removed,
    SpringTo,
    Torque,
    Wall,
    World,
    replay,
)

NAN, INF = math.nan, math.inf


def room() -> tuple[World, Body, Body]:
    world = World(integrator="velocity-verlet")
    return world, world.add(Circle(0.2)), world.add(Circle(0.2), position=(3.0, 1.0))


def test_a_law_acts_on_all_bodies_or_on_named_ones() -> None:
    world, a, b = room()
    world.add_law(SpringTo((1, 0), 2.0), [b])
    world.step()
    assert a.force == (0.0, 0.0)
    assert b.force.x == pytest.approx(-4.0, rel=1e-3)
    everywhere = world.add_law(SpringTo((1, 0), 2.0))
    world.step()
    assert a.force.x == pytest.approx(2.0, rel=1e-3)
    assert b.force.x == pytest.approx(-8.0, rel=1e-2)
    late = world.add(Polygon.box(1, 1), position=(-3.0, 0.0))
    world.step()
    assert late.force.x == pytest.approx(8.0, rel=1e-2)
    everywhere.remove()
    everywhere.remove()
    assert not everywhere.active
    world.step()
    assert late.force == (0.0, 0.0)
    assert len(world.force_laws) == 1


@pytest.mark.parametrize(
    ("answer", "force", "torque"),
    [
        (Force(1, 2), (1, 2), 0),
        (Torque(3), (0, 0), 3),
        ((1, 2), (1, 2), 0),
        ((1, 2, 3), (1, 2), 3),
        (None, (0, 0), 0),
    ],
)
def test_what_a_function_may_return(answer: Any, force: Any, torque: float) -> None:
    world, a, _ = room()
    world.add_law(lambda body, time: answer)
    world.step()
    assert a.force == force
    assert a.torque == torque


@pytest.mark.parametrize("answer", [(1,), (1, 2, 3, 4), (NAN, 0), (0, INF), ("a", 1), 7, "ab"])
def test_what_a_function_may_not_return(answer: Any) -> None:
    world, a, _ = room()
    world.add_law(lambda body, time: answer)
    with pytest.raises((TypeError, ValueError), match=r"must (return|be)"):
        world.step()
    assert world.tick == 0
    assert a.position == (0.0, 0.0)


def test_a_function_is_asked_for_the_start_and_the_end_of_the_tick() -> None:
    world, a, _ = room()
    a.velocity = (6.0, 0.0)
    asked: list[tuple[float, float]] = []
    world.add_law(lambda body, time: asked.append((time, body.x)), [a])
    world.step(0.5)
    assert asked == [(0.0, 0.0), (0.5, 3.0)]
    assert a.x == 3.0


def test_a_function_that_fails_leaves_the_bodies_where_they_were() -> None:
    world, a, _ = room()
    a.velocity = (6.0, 0.0)
    push = a.exert(Force(1.0, 0.0), duration=1.0)

    def fails_at_the_end(body: Body, time: float) -> None:
        if time > 0.0:
            raise RuntimeError("no force today")

    law = world.add_law(fails_at_the_end)
    with pytest.raises(RuntimeError, match="no force today"):
        world.step(0.5)
    assert (a.position, a.velocity, world.tick) == ((0.0, 0.0), (6.0, 0.0), 0)
    law.remove()
    while push.active:
        world.step(0.3)
    assert a.vx == pytest.approx(7.0, rel=1e-12)


def test_a_timed_push_beside_a_function_still_delivers_force_times_duration() -> None:
    world, a, _ = room()
    push = a.exert(Force(3.0, 0.0), duration=0.7)
    world.add_law(lambda body, time: (0.0, 1.0))
    while push.active:
        world.step(0.11)
    assert a.vx == pytest.approx(2.1, rel=1e-12)
    assert a.vy == pytest.approx(world.time, rel=1e-12)


def laws_of_many_kinds(world: World) -> list[Body]:
    bodies = [
        world.add(Circle(0.2), mass=1.0 + i, position=(math.cos(i) * 3, math.sin(i) * 3))
        for i in range(6)
    ]
    world.add_law(PointGravity((0, 0), 3.0, softening=0.2))
    world.add_law(SpringTo((0, 1), 2.0, damping=0.1), [bodies[4], bodies[1]])
    world.add_law(SpringTo((0, -1), 1.0), [bodies[1]])
    return bodies


def test_snapshot_and_restore_bring_laws_back() -> None:
    world = World(integrator="rk4")
    bodies = laws_of_many_kinds(world)
    world.add_law(lambda body, time: (math.sin(time), 0.0))
    for _ in range(20):
        world.step()
    saved = world.snapshot()
    for _ in range(20):
        world.step()
    expected = world.digest()
    for law in world.force_laws:
        law.remove()
    world.remove(bodies[1])
    world.step()
    world.restore(saved)
    assert len(world.force_laws) == 4
    for _ in range(20):
        world.step()
    assert world.digest() == expected


def test_laws_tell_worlds_apart() -> None:
    worlds = [World(), World(), World()]
    bodies = [world.add(Circle(1)) for world in worlds]
    worlds[1].add_law(SpringTo((0, 0), 1.0))
    worlds[2].add_law(SpringTo((0, 0), 1.0), [bodies[2]])
    assert len({world.digest() for world in worlds}) == 3


def test_removing_bodies_keeps_laws_on_the_right_ones() -> None:
    world = World()
    bodies = laws_of_many_kinds(world)
    world.force_laws[0].remove()
    world.remove(bodies[0])
    world.remove(bodies[1])
    world.step()
    assert bodies[4].force != (0.0, 0.0)
    assert all(bodies[i].force == (0.0, 0.0) for i in (2, 3, 5))


def swirl(body: Body, time: float) -> Force:
    """A law that a saved world names."""
    return Force(-body.y, body.x)


def test_a_saved_world_keeps_its_laws() -> None:
    world = World(integrator="rk4")
    bodies = laws_of_many_kinds(world)
    world.add_law(swirl, [bodies[2], bodies[4]])
    world.remove(bodies[4])
    world.step()
    data = json.loads(json.dumps(world.to_dict()))
    loaded = World.from_dict(data, functions={f"{__name__}.swirl": swirl})
    for _ in range(10):
        world.step()
        loaded.step()
    assert loaded.digest() == world.digest()
    assert [law.id for law in loaded.force_laws] == [1, 2, 3, 4]
    assert loaded.add_law(swirl).id == world.add_law(swirl).id
    data["force_laws"][1]["bodies"] = [99]
    with pytest.raises(ValueError, match=r"law 2 acts on bodies .99., but not all"):
        World.from_dict(data, functions={f"{__name__}.swirl": swirl})


def test_laws_are_inputs_of_a_recording() -> None:
    world = World()
    body = world.add(Circle(0.2), position=(2.0, 0.0))
    with world.record() as recording:
        law = world.add_law(SpringTo((0, 0), 3.0), [body])
        world.step()
        world.add_law(swirl)
        body.gravity_scale = 0.5
        world.step()
        law.remove()
        world.step()
    again = Recording.from_dict(json.loads(json.dumps(recording.to_dict())))
    end = replay(again, functions={f"{__name__}.swirl": swirl})
    assert end.digest() == world.digest()


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (lambda: PointGravity((NAN, 0), 1), "at.0. must be finite, not nan"),
        (lambda: PointGravity((0, 0), INF), "mu must be finite, not inf"),
        (lambda: PointGravity((0, 0), "5"), "mu must be a number, not '5'"),
        (lambda: PointGravity((0, 0), 1, softening=-1), "softening must not be negative"),
        (lambda: SpringTo(5, 1), "at must be a pair of numbers, not 5"),
        (lambda: SpringTo((0, 0), -2), "stiffness must not be negative, not -2"),
        (lambda: SpringTo((0, 0), 1, damping=NAN), "damping must be finite, not nan"),
        (lambda: World().add_law(5), "a law is a PointGravity, a SpringTo or a function, not 5"),
        (lambda: World().add_law(SpringTo), "a law is a PointGravity"),
        (lambda: World().add_law(SpringTo((0, 0), 1), 3), "bodies must be a list of bodies"),
        (lambda: World().add_law(SpringTo((0, 0), 1), [3]), "a law acts on bodies, not on 3"),
        (lambda: World().add(Circle(1), gravity_scale=NAN), "gravity_scale must be finite"),
    ],
)
def test_bad_input_is_refused_in_a_sentence(make: Any, sentence: str) -> None:
    with pytest.raises((TypeError, ValueError), match=sentence):
        make()


def test_walls_and_strangers_take_no_law() -> None:
    world, _, _ = room()
    wall = world.add(Wall((0, -1), (1, -1)))
    with pytest.raises(ValueError, match="wall 3 is static: it takes no law of force"):
        world.add_law(SpringTo((0, 0), 1), [wall])
    with pytest.raises(Removed, match="circle 1 is not in this world"):
        world.add_law(SpringTo((0, 0), 1), [World().add(Circle(1))])
    with pytest.raises(ValueError, match="wall 3 takes no gravity_scale"):
        wall.gravity_scale = 2.0
