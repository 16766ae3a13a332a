"""Kinds of bodies as people use them: what they take and refuse, moved by hand, saved."""

import json
import math
from typing import Any

import pytest

from engine import Circle, Force, Particle, Polygon, Torque, Wall, World


def test_kinds_say_what_they_are() -> None:
    world = World()
    bodies = [world.add(Circle(1), position=(5 * i, 0), kind=kind) for i, kind in
              enumerate((None, "dynamic", "kinematic", "static"))]  # fmt: skip
    assert [body.kind for body in bodies] == ["dynamic", "dynamic", "kinematic", "static"]
    assert [body.is_dynamic for body in bodies] == [True, True, False, False]
    assert world.add(Wall((0, 5), (1, 5))).kind == "static"
    moving = bodies[2]
    moving.velocity, moving.spin = (3, 0), 1.0
    assert (moving.mass, moving.inertia) == (math.inf, math.inf)
    assert (moving.momentum, moving.angular_momentum, moving.kinetic_energy) == ((0, 0), 0, 0)
    assert world.momentum == (0, 0)
    assert world.kinetic_energy == 0
    assert world.potential_energy == 0


def test_a_static_body_put_elsewhere_is_solid_there() -> None:
    world = World(gravity=(0, -10))
    block = world.add(Polygon.box(2, 1), kind="static", position=(0, -0.5))
    ball = world.add(Circle(0.5), position=(0, 0.5))
    for _ in range(30):
        world.step()
    assert ball.y == pytest.approx(0.5, abs=1e-2)
    block.position = (0, -3)
    block.angle = math.pi / 2
    for _ in range(120):
        world.step()
    assert ball.y == pytest.approx(-1.5, abs=1e-2)
    assert block.to_world((1, 0)) == pytest.approx((0, -2))
    assert world.query_point((0, -2.01)) == [block]
    assert world.query_point((0.9, -3)) == []
    state = world.state()
    state[0, 1] = 5.0
    world.set_state(state)
    assert world.query_point((5, -2.01)) == [block]
    for _ in range(60):
        world.step()
    assert ball.y < -3
    state = world.state()
    state[0, 4] = 1.0
    with pytest.raises(ValueError, match="polygon 1 is static: it takes no velocity"):
        world.set_state(state)


def test_they_are_saved_and_restored() -> None:
    world = World(gravity=(0, -10))
    world.add(Polygon.box(8, 1), kind="static", angle=0.1)
    paddle = world.add(Polygon.box(2, 0.2), kind="kinematic", position=(0, 2), spin=2.0)
    for i in range(3):
        world.add(Circle(0.3), position=(0.5 * i - 1, 4 + i), restitution=0.5, friction=0.3)
    for _ in range(60):
        world.step()
    saved, loaded = world.snapshot(), World.from_dict(json.loads(json.dumps(world.to_dict())))
    for _ in range(60):
        world.step()
        loaded.step()
    assert loaded.digest() == world.digest()
    assert [body.kind for body in loaded] == [body.kind for body in world]
    end = world.digest()
    world.restore(saved)
    for _ in range(60):
        world.step()
    assert world.digest() == end
    world.remove(paddle)
    world.step()


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ({"kind": "heavy"}, "kind must be one of dynamic, kinematic, static, not 'heavy'"),
        ({"kind": 1}, "kind must be one of dynamic, kinematic, static, not 1"),
        (
            {"kind": "kinematic", "mass": 2},
            "a kinematic body has infinite mass: it takes no mass",
        ),
        ({"kind": "static", "inertia": 2}, "a static body has infinite mass: it takes no inertia"),
        ({"kind": "static", "velocity": (1, 0)}, "a static body does not move: it takes no veloc"),
        ({"kind": "static", "spin": 1}, "a static body does not move: it takes no spin 1"),
        ({"kind": "kinematic", "velocity": (math.nan, 0)}, "velocity.0. must be finite"),
    ],
)
def test_what_a_new_body_of_a_kind_does_not_take(given: dict[str, Any], sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        World().add(Circle(1), **given)


@pytest.mark.parametrize("kind", ["kinematic", "static"])
def test_what_no_force_moves_takes_none(kind: str) -> None:
    world = World()
    body = world.add(Circle(1), kind=kind, name="it")
    refused = [
        lambda: body.exert(Force(1, 0)),
        lambda: body.exert(Torque(1)),
        lambda: body.apply_impulse((1, 0)),
        lambda: setattr(body, "mass", 2.0),
        lambda: setattr(body, "gravity_scale", 2.0),
    ]
    for action in refused:
        with pytest.raises(ValueError, match=f"it is {kind}: it takes no"):
            action()
    if kind == "static":
        for name, value in (("velocity", (1, 0)), ("spin", 1.0)):
            with pytest.raises(ValueError, match=f"it is static: it takes no {name}"):
                setattr(body, name, value)


def test_walls_and_particles_stay_what_they_are() -> None:
    world = World()
    with pytest.raises(ValueError, match="a wall is immovable: it takes no kind 'kinematic'"):
        world.add(Wall((0, 0), (1, 0)), kind="kinematic")
    world.add(Wall((0, 0), (1, 0)), kind="static")
    with pytest.raises(ValueError, match="a particle never rotates"):
        world.add(Particle(1), kind="kinematic", spin=1.0)
    moving = world.add(Particle(1), kind="kinematic")
    with pytest.raises(ValueError, match="a particle never rotates"):
        moving.spin = 1.0
