"""Every argument of every constructor and call refuses what it cannot take, in one sentence.

Each entry is a call with one argument left open, and the kind of value that it takes; everything
that this kind is not is tried. The same table runs under `python -O`, where asserts are gone.
"""

import math
import os
import subprocess
import sys
from collections.abc import Callable
from itertools import count
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from engine import (
    Body,
    Box,
    Capsule,
    Chain,
    Circle,
    Compound,
    Distance,
    Force,
    LinearDrag,
    Particle,
    Pin,
    PointGravity,
    Polygon,
    Pulley,
    QuadraticDrag,
    Rope,
    Slider,
    Spring,
    SpringTo,
    Torque,
    Wall,
    Weld,
    World,
)

NO_NUMBER = [math.nan, math.inf, -math.inf, 10**400, "1", None, True, [1.0], 1j]
NEGATIVE = [-1.0, -1e-300]
NO_POINT = [(math.nan, 0), (0, math.inf), (1,), (1, 2, 3), 3, "ab", (None, 0), ("x", 1)]

KINDS: dict[str, list[Any]] = {
    "number": NO_NUMBER,
    "positive": [*NO_NUMBER, *NEGATIVE, 0, 0.0],
    "not negative": [*NO_NUMBER, *NEGATIVE],
    "fraction": [*NO_NUMBER, -0.1, 1.1],
    "whole": [math.nan, math.inf, "1", None, True, 1.5, -1],
    "point": NO_POINT,
    "truth": [0, 1, None, "yes", 0.0],
    "points": [
        [(0, 0), (math.nan, 1), (1, 0)], [(0, 0), (1, 0)], [(1, 1)] * 4, [], None, 7, "abc",
        [(0, 0), (1, 1), (2, 2)], [(0, 0), (1, 0), (1,)], [(0, 0), (1, 0), 3],
    ],
    "ring": [
        [(0, 0), (2, 2), (2, 0), (0, 2)], [(0, 0), (1, 0)], [(1, 1)] * 4, [], None,
        [(0, 0), (1, 1), (2, 2)], [(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)],
    ],
    "way": [[], [(1, 1)], [(1, 1)] * 5, None, 3, [(0, 0), (math.inf, 1)], "ab"],
    "shape": [None, 3, "circle", Circle, (1, 2)],
    "text": [3, None, b"x", ["x"]],
    "effort": [3, "up", (1,), (1, 2, 3, 4), [1, 2], (1, "x"), True],
    "function": [3, "f", (1, 2), [print], math.nan],
}  # fmt: skip
"""Of each kind, values that it is not."""


def world() -> World:
    room = World(gravity=(0, -9.81))
    room.add(Wall((-5, 0), (5, 0)))
    for x in range(2):
        room.add(Box(1, 1), position=(2 * x, 1))
    return room


def setter(name: str) -> Callable[[Any], Any]:
    return lambda value: setattr(world().body(2), name, value)


def added(name: str) -> Callable[[Any], Any]:
    return lambda value: World().add(Circle(1), **{name: value})


def given_or_not(name: str) -> Callable[[Any], Any]:
    """For what may be None: then another value is tried."""
    return lambda value: added(name)(["none"] if value is None else value)


def joined(make: Callable[[Any], Any]) -> Callable[[Any], Any]:
    def call(value: Any) -> Any:
        room = world()
        return room.join(room.body(2), room.body(3), make(value))

    return call


def exerted(**given: Any) -> Any:
    effort = given.pop("effort", Force(1, 0))
    return world().body(2).exert(effort, **given)


def hung(**given: Any) -> Any:
    room = world()
    return room.join(None, room.body(2), Pin(at=(0, 1)), **given)


def pulled(law: Callable[..., Any]) -> None:
    room = world()
    room.add_law(law)
    room.step()


def fall(**rules: Any) -> None:
    room = World(gravity=(0, -9.81), **rules)
    room.add(Wall((-5, 0), (5, 0)))
    room.add(Box(1, 1), position=(0, 0.5))
    room.step()


CALLS: list[tuple[str, str, Callable[[Any], Any]]] = [
    ("Circle radius", "positive", Circle),
    ("Particle radius", "positive", Particle),
    ("Capsule length", "positive", lambda v: Capsule(v, 1)),
    ("Capsule radius", "positive", lambda v: Capsule(1, v)),
    ("Box width", "positive", lambda v: Box(v, 1)),
    ("Box height", "positive", lambda v: Box(1, v)),
    ("Box rounding", "not negative", lambda v: Box(1, 1, rounding=v)),
    ("Polygon vertices", "points", Polygon),
    ("Polygon rounding", "not negative", lambda v: Polygon([(0, 0), (1, 0), (0, 1)], rounding=v)),
    ("regular sides", "whole", lambda v: Polygon.regular(v, 1)),
    ("regular radius", "positive", lambda v: Polygon.regular(5, v)),
    ("box width", "positive", lambda v: Polygon.box(v, 1)),
    ("concave vertices", "ring", Polygon.concave),
    ("Compound shape", "shape", lambda v: Compound([v])),
    ("Compound offset", "point", lambda v: Compound([(Circle(1), v)])),
    ("Compound angle", "number", lambda v: Compound([(Circle(1), (0, 0), v)])),
    ("Compound mass", "positive", lambda v: Compound([Circle(1)], masses=[v])),
    ("Wall start", "point", lambda v: Wall(v, (9, 9))),
    ("Wall end", "point", lambda v: Wall((9, 9), v)),
    ("Wall one_sided", "truth", lambda v: Wall((0, 0), (1, 0), one_sided=v)),
    ("Chain points", "way", Chain),
    ("Chain loop", "truth", lambda v: Chain([(0, 0), (1, 0), (0, 1)], loop=v)),
    ("Chain one_sided", "truth", lambda v: Chain([(0, 0), (1, 0)], one_sided=v)),
    ("Force x", "number", lambda v: Force(v, 0)),
    ("Force y", "number", lambda v: Force(0, v)),
    ("Torque", "number", Torque),
    ("LinearDrag", "not negative", LinearDrag),
    ("QuadraticDrag", "not negative", QuadraticDrag),
    ("PointGravity at", "point", lambda v: PointGravity(v, 1)),
    ("PointGravity mu", "number", lambda v: PointGravity((0, 0), v)),
    ("PointGravity softening", "not negative", lambda v: PointGravity((0, 0), 1, v)),
    ("SpringTo at", "point", lambda v: SpringTo(v, 1)),
    ("SpringTo stiffness", "not negative", lambda v: SpringTo((0, 0), v)),
    ("SpringTo damping", "not negative", lambda v: SpringTo((0, 0), 1, v)),
    ("World gravity", "point", lambda v: World(gravity=v)),
    ("World substeps", "whole", lambda v: World(substeps=v)),
    ("World integrator", "text", lambda v: World(integrator=v)),
    ("World kernels", "text", lambda v: World(kernels=v)),
    ("World.gravity", "point", lambda v: setattr(world(), "gravity", v)),
    ("step dt", "positive", lambda v: world().step(v)),
    ("run ticks", "whole", lambda v: world().run(v)),
    ("run dt", "positive", lambda v: world().run(1, v)),
    ("run record", "text", lambda v: world().run(1, record=[v])),
    ("add shape", "shape", lambda v: world().add(v)),
    *((f"add {name}", kind, added(name)) for name, kind in [
        ("restitution", "fraction"), ("friction", "not negative"),
        ("rolling_resistance", "not negative"), ("surface_speed", "number"),
        ("gravity_scale", "number"), ("sensor", "truth"), ("category", "whole"),
        ("mask", "whole"),
    ]),
    *((f"add {name}", kind, given_or_not(name)) for name, kind in [
        ("mass", "positive"), ("position", "point"), ("angle", "number"), ("velocity", "point"),
        ("spin", "number"), ("inertia", "positive"), ("static_friction", "not negative"),
    ]),
    *((f"set {name}", kind, setter(name)) for name, kind in [
        ("position", "point"), ("angle", "number"), ("velocity", "point"), ("spin", "number"),
        ("mass", "positive"), ("restitution", "fraction"), ("friction", "not negative"),
        ("rolling_resistance", "not negative"), ("surface_speed", "number"),
        ("gravity_scale", "number"), ("category", "whole"), ("mask", "whole"),
    ]),
    ("exert effort", "shape", lambda v: exerted(effort=v)),
    ("exert duration", "positive", lambda v: exerted(duration=0 if v is None else v)),
    ("exert at", "point", lambda v: exerted(at=v)),
    ("apply_impulse", "point", lambda v: world().body(2).apply_impulse(v)),
    ("to_world", "point", lambda v: world().body(2).to_world(v)),
    ("to_local", "point", lambda v: world().body(2).to_local(v)),
    ("query_point", "point", lambda v: world().query_point(v)),
    ("query_box low", "point", lambda v: world().query_box(v, (9, 9))),
    ("query_box high", "point", lambda v: world().query_box((-9, -9), v)),
    ("cast_ray start", "point", lambda v: world().cast_ray(v, (9, 9))),
    ("cast_ray end", "point", lambda v: world().cast_ray((9, 9), v)),
    ("cast_shape shape", "shape", lambda v: world().cast_shape(v, (0, 0), (1, 0))),
    ("cast_shape start", "point", lambda v: world().cast_shape(Circle(1), v, (9, 9))),
    ("cast_shape angle", "number", lambda v: world().cast_shape(Circle(1), (0, 0), (1, 0), v)),
    ("nearest", "point", lambda v: world().nearest(v)),
    ("Distance length", "positive", joined(lambda v: Distance(length="x" if v is None else v))),
    ("Distance anchor", "point", joined(lambda v: Distance(anchor_a=v))),
    ("Rope length", "positive", joined(lambda v: Rope(length="x" if v is None else v))),
    ("Spring stiffness", "not negative", joined(lambda v: Spring(v, 1.0))),
    ("Spring damping", "not negative", joined(lambda v: Spring(9.0, v))),
    ("Pin at", "point", joined(Pin)),
    ("Slider axis", "point", joined(Slider)),
    ("Weld at", "point", joined(Weld)),
    ("Pulley over", "point", joined(lambda v: Pulley(v, (9, 9)))),
    ("Pulley ratio", "positive", joined(lambda v: Pulley((0, 9), (2, 9), ratio=v))),
    ("body", "shape", lambda v: world().remove(v)),
    ("add name", "text", given_or_not("name")),
    ("set name", "text", setter("name")),
    *((f"{how} {name}", "function", make(name))
      for how, make in (("add", added), ("set", setter)) for name in ("on_move", "on_collision")),
    ("join on_break", "function", lambda v: hung(on_break=v)),
    ("Joint.on_break", "function", lambda v: setattr(hung(), "on_break", v)),
    ("World restitution_rule", "function", lambda v: World(restitution_rule=v)),
    ("World friction_rule", "function", lambda v: World(friction_rule=v)),
    ("World.restitution_rule", "function", lambda v: setattr(world(), "restitution_rule", v)),
    ("World.friction_rule", "function", lambda v: setattr(world(), "friction_rule", v)),
    ("add_law", "function", lambda v: world().add_law(v)),
    ("a law returns", "effort", lambda v: pulled(lambda body, time: v)),
    ("a law returns a force", "number", lambda v: pulled(lambda body, time: (v, 0.0))),
    ("a law returns a torque", "number", lambda v: pulled(lambda body, time: (0.0, 0.0, v))),
    ("a restitution rule returns", "fraction", lambda v: fall(restitution_rule=lambda a, b: v)),
    ("a friction rule returns", "not negative", lambda v: fall(friction_rule=lambda a, b: v)),
]  # fmt: skip


def refusals(call: Callable[[Any], Any], kind: str) -> list[str]:
    """What is wrong with how a call answers to all that its argument is not."""
    wrong = []
    for value in KINDS[kind]:
        try:
            call(value)
        except (ValueError, TypeError, LookupError) as refused:
            sentence = str(refused)
            if not 10 < len(sentence) < 400 or "\n" in sentence or "argument" in sentence:
                wrong.append(f"{value!r}: {sentence!r} is no sentence about it")
        else:
            wrong.append(f"{value!r} was taken")
    return wrong


@pytest.mark.parametrize(("name", "kind", "call"), CALLS, ids=[name for name, _, _ in CALLS])
def test_what_an_argument_is_not_is_refused(
    name: str, kind: str, call: Callable[[Any], Any]
) -> None:
    del name
    assert refusals(call, kind) == []


def test_asserts_have_no_part_in_it() -> None:
    """All of it under `python -O`."""
    code = (
        "from tests.engine.test_bad_input import CALLS, refusals\n"
        "print([(name, wrong) for name, kind, call in CALLS if (wrong := refusals(call, kind))])"
    )
    root = Path(__file__).parents[2]
    done = subprocess.run(
        [sys.executable, "-O", "-c", code],
        env=os.environ | {"PYTHONPATH": str(root)},
        cwd=root,
        text=True,
        capture_output=True,
        timeout=120,
        check=True,
    )
    assert done.stdout == "[]\n"


def test_what_is_normalised_is_normalised_as_documented() -> None:
    """Clockwise or in any order, with duplicates and corners that are none: the same square."""
    square = Polygon([(0, 0), (2, 0), (2, 2), (0, 2)])
    for given in (
        [(0, 0), (0, 2), (2, 2), (2, 0)],
        [(2, 2), (0, 0), (2, 0), (0, 2)],
        [(0, 0), (2, 0), (2, 0), (2, 2), (0, 2), (0, 0)],
        [(0, 0), (1, 0), (2, 0), (2, 2), (1, 2), (0, 2)],
    ):
        assert Polygon(given).area == pytest.approx(4)
        assert sorted(Polygon(given).vertices) == sorted(square.vertices)
    clockwise = Polygon.concave([(0, 0), (0, 3), (1, 3), (1, 1), (2, 1), (2, 0)])
    assert clockwise.area == pytest.approx(4)
    assert Chain([(0, 0), (0, 0), (1, 0)]).points == ((0, 0), (1, 0))


REFUSED: list[tuple[str, Callable[[Body], Any]]] = [
    ("an impulse at no point", lambda body: body.apply_impulse((1, 2), at=(math.nan, 0))),
    ("an impulse at three numbers", lambda body: body.apply_impulse((1, 2), at=(1, 2, 3))),
    ("a mass too small to be divided by", lambda body: setattr(body, "mass", 5e-324)),
    ("a mass with an inertia too small", lambda body: setattr(body, "mass", 1e-101)),
    ("a mass too large", lambda body: setattr(body, "mass", 1e101)),
    ("a category of arrays", lambda body: setattr(body, "category", np.array([1, 2]))),
    ("a mask of a type", lambda body: setattr(body, "mask", int)),
    ("a position of a set", lambda body: setattr(body, "position", {1, 2})),
    ("a velocity of bytes", lambda body: setattr(body, "velocity", b"ab")),
    ("a kind of an array", lambda body: body._world.add(Circle(1), kind=np.array([1, 2]))),
    ("a matrix for a mass", lambda body: setattr(body, "mass", np.eye(2))),
    ("a tick too short", lambda body: body._world.step(5e-324)),
    ("a tick too long", lambda body: body._world.run(2, dt=1e200)),
    ("a state of text", lambda body: body._world.set_state("state")),
    ("a state too large for a float", lambda body: body._world.set_state([[10**400] * 7])),
    ("nearest within an array", lambda body: body._world.nearest((0, 0), within=np.ones(2))),
    ("a torque of None", lambda body: Pin((0, 0), motor_speed=1.0, max_torque=None)),
    ("a ratio of None", lambda body: Pulley((0, 9), (1, 9), ratio=None)),
    ("limits of arrays", lambda body: Pin((0, 0), limits=(np.ones(2), 1))),
    ("an integrator of arrays", lambda body: World(integrator=np.array(["rk4", "x"]))),  # type: ignore[arg-type]
    ("kernels of arrays", lambda body: World(kernels=np.array(["auto", "x"]))),  # type: ignore[arg-type]
    ("more substeps than any", lambda body: setattr(body._world, "substeps", 10**30)),
    ("a record of a number", lambda body: body._world.run(1, record=3)),
    ("a record of None", lambda body: body._world.run(1, record=None)),
    ("collisions that may be", lambda body: body._world.run(1, collisions="yes")),
    ("a body of a list", lambda body: body._world.body([1])),
    ("a body of a body", lambda body: body._world.body(body)),
    ("a joint of text", lambda body: body._world.joint("x")),
    ("tracks of text", lambda body: body._world.run(0).of("box")),
    ("a position without end", lambda body: setattr(body, "position", count())),
    ("a number of more digits than are written", lambda body: setattr(body, "mask", 10**5000)),
    ("a matrix for a force", lambda body: body.exert(np.eye(2))),
    ("functions of an array", lambda body: World.from_dict({}, functions=np.ones(2))),
    ("offsets beyond all sums", lambda body: Compound([Circle(1), (Circle(1), (1e308, 1e308))])),
    (
        "masses beyond all sums",
        lambda body: body._world.add(Compound([Circle(1), (Circle(1), (2, 0))], [1e308, 1e308])),
    ),
]


@pytest.mark.parametrize(("name", "call"), REFUSED, ids=[name for name, _ in REFUSED])
def test_what_is_refused_changes_nothing(name: str, call: Callable[[Body], Any]) -> None:
    """Velocities were changed before the point of attack was looked at, masses before they were
    divided by.
    """
    del name
    world = World(gravity=(0, -9.81))
    body = world.add(Box(1, 2), position=(3, 4), velocity=(1, 2), spin=3)
    world.step()
    before = world.digest()
    with pytest.raises((ValueError, TypeError)) as refused:
        call(body)
    assert 10 < len(str(refused.value)) < 400
    assert "\n" not in str(refused.value)
    assert world.digest() == before


CHANGES: list[tuple[str, Callable[[Body], Any]]] = [
    ("step", lambda body: body._world.step()),
    ("run", lambda body: body._world.run(3)),
    ("add", lambda body: body._world.add(Circle(1))),
    ("remove", lambda body: body._world.remove(body)),
    ("join", lambda body: body._world.join(None, body, Pin(at=(0, 0)))),
    ("velocity", lambda body: setattr(body, "velocity", (1, 1))),
    ("gravity", lambda body: setattr(body._world, "gravity", (1, 1))),
    ("restore", lambda body: body._world.restore(body._world.snapshot())),
    ("exert", lambda body: body.exert(Force(1, 0))),
]


@pytest.mark.parametrize(("name", "change"), CHANGES, ids=[name for name, _ in CHANGES])
@pytest.mark.parametrize("who", ["law", "rule"])
def test_what_is_asked_within_a_step_cannot_change_the_world(
    name: str, change: Callable[[Body], Any], who: str
) -> None:
    """A law that removed a body made the step fail by IndexError; others broke the books."""
    del name
    world = World(gravity=(0, -9.81))
    world.add(Wall((-5, 0), (5, 0)))
    body = world.add(Box(1, 1), position=(0, 0.5))
    asked = []

    def meddle(*_: Any) -> Any:
        asked.append(world.tick)
        change(body)

    if who == "law":
        law = world.add_law(meddle)
    else:
        world.friction_rule = meddle
    before = world.digest()
    with pytest.raises(RuntimeError, match="a law of force or a rule must not change the world"):
        world.step()
    assert asked == [0]
    if who == "law":
        assert world.digest() == before
        law.remove()
    else:
        world.friction_rule = None  # type: ignore[assignment]
    world.step()
    assert world.tick == 1


def test_a_moment_of_another_world_is_refused() -> None:
    """Also one that has no body, but a law of force."""
    other, world = World(), World()
    other.add_law(SpringTo((0, 0), 1.0))
    with pytest.raises(ValueError, match="the snapshot is of another world"):
        world.restore(other.snapshot())
    assert world.force_laws == ()


def test_what_is_too_fast_for_all_squares_is_told_without_a_warning() -> None:
    world = World()
    a, b = world.add(Circle(1)), world.add(Circle(1), position=(1e200, 5))
    a.velocity, b.velocity = (1e200, 0), (-1e200, 0)
    assert world.kinetic_energy == world.ledger().kinetic == math.inf
    b.y = 6
    world.ledger()
    assert world.query_point((0, 0)) == [a]
    assert world.cast_ray((-5, 0), (5, 0)) is not None
