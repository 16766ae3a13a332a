"""A world that is copied, or pickled and loaded, goes on alike, and apart from the first."""

import copy
import math
import pickle
from collections.abc import Callable
from typing import Any

import pytest

from engine import (
    Body,
    Circle,
    Force,
    LinearDrag,
    Pin,
    PointGravity,
    Polygon,
    Removed,
    Sleep,
    Vector,
    Wall,
    World,
    replay,
)
from engine.joint import Joint

COPIES: list[Callable[[Any], Any]] = [
    copy.copy, copy.deepcopy, lambda world: pickle.loads(pickle.dumps(world)),
]  # fmt: skip


def gust(body: Body, time: float) -> tuple[float, float]:
    return math.sin(time), 0.0


def soft(one: float, other: float) -> float:
    return (one + other) / 2.0


def scene() -> World:
    world = World((0, -9.81), LinearDrag(0.1), "velocity-verlet", 4, soft, kernels="interpreted")
    world.add(Wall((-5, 0), (5, 0)), restitution=0.5)
    ball = world.add(Circle(0.5), position=(0, 2), restitution=0.4, name="ball")
    bob = world.add(Polygon.regular(5, 0.3), position=(2, 2), friction=0.3)
    world.join(None, bob, Pin(at=(2, 3)))
    world.add_law(gust, [ball])
    world.add_law(PointGravity((9, 9), 1.0))
    ball.exert(Force(1, 0), duration=1.0)
    world.run(20)
    return world


@pytest.mark.parametrize("how", COPIES)
def test_a_copy_goes_on_alike_and_apart(how: Callable[[Any], Any]) -> None:
    world = scene()
    twin, before = how(world), world.digest()
    assert twin.digest() == before
    assert (twin.kernels, twin.restitution_rule) == ("interpreted", soft)
    twin.run(60)
    assert world.digest() == before
    world.run(60)
    assert twin.digest() == world.digest()


def test_what_is_copied_with_a_world_belongs_to_the_copy() -> None:
    world = scene()
    kept = {
        "world": world, "ball": world.body(2), "pin": world.joints[0], "laws": world.force_laws,
        "moment": world.snapshot(), "hits": world.step(),
    }  # fmt: skip
    for how in COPIES[1:]:
        twin = how(kept)
        assert twin["ball"] is twin["world"].body(2) is not world.body(2)
        assert twin["pin"] is twin["world"].joints[0]
        assert twin["laws"] == twin["world"].force_laws
        twin["world"].restore(twin["moment"])
        assert twin["world"].tick == 20
        assert world.tick == 21
    assert copy.copy(world.body(2)) is world.body(2)


def test_removed_handles_are_not_copied() -> None:
    world = scene()
    ball, pin, law = world.body(2), world.joints[0], world.force_laws[1]
    world.remove(ball)
    pin.remove()
    law.remove()
    for gone in (ball, pin, law):
        with pytest.raises(Removed):
            copy.deepcopy(gone)


def test_two_functions_of_one_name_are_not_saved() -> None:
    """They were saved as one, which then acted in place of both."""

    def wind(strength: float) -> Any:
        return lambda body, time: (strength, 0.0)

    world = World()
    world.add(Circle(1))
    world.add_law(wind(1.0))
    world.to_dict()
    world.add_law(world.force_laws[0].law)
    world.to_dict()
    world.add_law(wind(2.0))
    with pytest.raises(ValueError, match=r"two functions are called .*wind.<locals>.<lambda>"):
        world.to_dict()


def test_the_laws_of_a_world_may_be_read_and_set() -> None:
    """To set the drag of a world did nothing, without a word."""
    told = {"drag": LinearDrag(0.5), "integrator": "rk4", "substeps": 3, "sleeping": Sleep(0.1, 1)}
    usual = {
        "drag": None, "integrator": "semi-implicit-euler", "substeps": 6, "sleeping": False,
    }  # fmt: skip
    made, set_later = World(**told), World()  # type: ignore[arg-type]
    assert {name: getattr(set_later, name) for name in usual} == usual
    with set_later.record() as recording:
        for name, value in told.items():
            setattr(set_later, name, value)
            assert getattr(set_later, name) == getattr(made, name) == value
        for world in (made, set_later):
            world.add(Circle(1), velocity=(3, 0))
            world.step()
    assert made.digest() == set_later.digest() == replay(recording).digest()
    assert replay(recording).laws == made.laws


def test_what_a_world_does_not_have_cannot_be_set() -> None:
    world = World()
    with pytest.raises(AttributeError):
        world.damping = 0.9  # type: ignore[attr-defined]
    body = world.add(Circle(1))
    for handle, name in ((world, "tick"), (body, "shape"), (body, "id"), (body, "lives")):
        with pytest.raises(AttributeError):
            setattr(handle, name, 3)
    joint = world.join(None, body, Pin(at=(0, 0)))
    assert isinstance(joint, Joint)
    with pytest.raises(AttributeError):
        joint.a = body  # type: ignore[misc]


def test_a_world_says_what_is_in_it() -> None:
    assert repr(World()) == "<World: 0 bodies, 0 s>"
    assert repr(scene()) == "<World: 3 bodies, 1 joints, 0.333333 s>"


def test_single_coordinates_may_be_set() -> None:
    world = World()
    body = world.add(Circle(1), position=(1, 2), velocity=(3, 4), spin=5)
    with world.record() as recording:
        body.x, body.vy = 7, -1
        body.y += 1
        body.vx *= 2
    assert (body.position, body.velocity, body.spin) == (Vector(7, 3), Vector(6, -1), 5)
    assert replay(recording).digest() == world.digest()
    with pytest.raises(ValueError):
        body.x = math.nan
    assert body.x == 7
