"""A world becomes JSON and back without losing a bit; what is no saved world is refused."""

import copy
import json
import math
import subprocess
import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine import Chain, Circle, Force, LinearDrag, Particle, Pin, Polygon, Torque, Wall, World
from engine.plain import Decoder, encode
from engine.portable import AT_MOST, COUNTS, DERIVED, HELD, ROWS_OF, TABLES
from engine.saving import KINDS
from engine.tables import allocate, arrays
from engine.vector import Vector

Change = Callable[[dict[str, Any]], object]


def heap(seed: int = 0, **given: Any) -> World:
    """A few bodies of all kinds that fall on a floor, are pushed, and come to rest."""
    world = World(gravity=(0.1, -9.81), **given)
    world.add(Wall((-5, 0), (5, 0)), friction=0.5, restitution=0.4, name="floor")
    world.add(Wall((4, -1), (4, 9), one_sided=True))
    kinds = [Circle(0.3), Particle(0.25), Polygon.box(0.7, 0.5), Polygon.regular(5, 0.4)]
    for i in range(8):
        world.add(
            kinds[(i + seed) % 4],
            mass=0.5 + 0.1 * i,
            position=(-2 + 0.8 * (i % 4), 0.6 + (i // 4)),
            velocity=(math.sin(seed + i), 0),
            restitution=0.1 * (i % 4),
            friction=0.3,
        )
    world.body(3).exert(Force(1, 2), duration=0.33, at=(0.1, 0.2))
    world.body(5).exert(Torque(0.5))
    return world


@given(seed=st.integers(0, 99), ticks=st.integers(0, 90))
@settings(max_examples=4, derandomize=True)
def test_a_saved_world_goes_on_bit_for_bit(seed: int, ticks: int) -> None:
    world = heap(seed, drag=LinearDrag(0.1), integrator="velocity-verlet")
    for _ in range(ticks):
        world.step()
    if ticks % 2:
        world.remove(world.body(4))
    loaded = World.from_dict(json.loads(json.dumps(world.to_dict(), allow_nan=False)))
    assert loaded.digest() == world.digest()
    assert loaded.to_dict() == world.to_dict()
    for each in (world, loaded):
        for _ in range(100):
            each.step()
    assert loaded.digest() == world.digest()
    assert loaded.time == world.time


def test_another_process_goes_on_bit_for_bit() -> None:
    world = heap()
    for _ in range(50):
        world.step()
    code = (
        "import json, sys; from engine import World\n"
        "world = World.from_dict(json.load(sys.stdin))\n"
        "for _ in range(100): world.step()\n"
        "print(world.digest())"
    )
    there = subprocess.run(
        [sys.executable, "-c", code],
        input=json.dumps(world.to_dict()),
        capture_output=True,
        text=True,
        check=True,
    )
    for _ in range(100):
        world.step()
    assert there.stdout.strip() == world.digest()


def test_bodies_keep_their_ids_names_and_shapes() -> None:
    world = heap()
    world.remove(world.body(6))
    loaded = World.from_dict(world.to_dict())
    assert [(body.id, body.name, body.shape) for body in loaded] == [
        (body.id, body.name, body.shape) for body in world
    ]
    new = (world.add(Circle(1)), loaded.add(Circle(1)))
    assert new[0].id == new[1].id
    assert loaded.body(1).is_wall


def test_every_table_and_column_of_the_world_is_saved() -> None:
    """Whoever adds a table or a column of whole numbers says here what they may hold."""
    world = heap()
    world.step()
    saved = world.to_dict()["tables"]
    assert list(saved) == list(TABLES)
    # Empty between steps, or made from others.
    passing = {"links", "lanes", "touch", "hits", "impacts", "counts", "fields"}
    passing |= {"unknowns", "delassus", "found", "grid", "progress", "tracks"}
    passing |= {"braces", "nodes", "equations", "arms", "couplings", "profile", "structures"}
    passing |= {"limbs", "bones", "trees"}
    assert set(saved) | passing == {*world.tables._fields}
    known = {*ROWS_OF, *AT_MOST, *COUNTS, *DERIVED}
    for name, kind in TABLES.items():
        assert {f"{name}.{field}" for field in kind._fields} - set(DERIVED) == {
            f"{name}.{field}" for field in saved[name]
        }
        for field, column in zip(kind._fields, arrays(allocate(kind, 1)), strict=True):
            assert column.dtype.kind == "f" or f"{name}.{field}" in known


def loudest(a: float, b: float) -> float:
    """A rule for restitution."""
    return max(a, b) / 2


def test_a_world_that_was_saved_before_paces_were_held_is_loaded() -> None:
    world = World(gravity=(0, -9.81))
    rod = world.add(Polygon.box(1, 0.1), position=(0.5, 0))
    world.join(None, rod, Pin(at=(0, 0)))
    world.run(60)
    data = world.to_dict()
    for name in HELD:
        del data["tables"]["state"][name]
    older = World.from_dict(data)
    older.run(60)
    assert 0.0 < older.tables.state.pace[0] <= world.tables.state.pace[0]


def test_rules_are_saved_by_name_and_handed_in_again() -> None:
    world = World(restitution_rule=loudest)
    data = json.loads(json.dumps(world.to_dict()))
    name = f"{__name__}.loudest"
    with pytest.raises(LookupError, match=r"function .*loudest' was not saved: hand it in"):
        World.from_dict(data)
    assert World.from_dict(data, functions={name: loudest}).restitution_rule is loudest


WRONG: list[tuple[str, Change]] = [
    ("format 1, not 2", lambda d: d.update(format=2)),
    ("must have 'tables'", lambda d: d.pop("tables")),
    ("has no 'colour'", lambda d: d.update(colour="red")),
    ("has no 'taste'", lambda d: d["tables"]["bodies"].update(taste=[])),
    ("bodies of a saved world must have 'vx'", lambda d: d["tables"]["bodies"].pop("vx")),
    ("bodies.x .* a number, not 'far'", lambda d: d["tables"]["bodies"]["x"].__setitem__(0, "far")),
    ("bodies.x .* finite, not nan", lambda d: d["tables"]["bodies"]["x"].__setitem__(0, math.nan)),
    (
        "bodies.first .* number, not 0.5",
        lambda d: d["tables"]["bodies"]["first"].__setitem__(0, 0.5),
    ),
    ("bodies.first .* cannot be -1", lambda d: d["tables"]["bodies"]["first"].__setitem__(0, -1)),
    ("bodies.first .* at most", lambda d: d["tables"]["bodies"]["first"].__setitem__(0, 10**6)),
    ("bodies.mass .* negative", lambda d: d["tables"]["bodies"]["mass"].__setitem__(3, -1.0)),
    ("corners that are there", lambda d: d["tables"]["bodies"]["corners"].__setitem__(3, 10**6)),
    ("pairs.b .* at most", lambda d: d["tables"]["pairs"]["b"].__setitem__(0, 999)),
    ("pushes.row .* at most", lambda d: d["tables"]["pushes"]["row"].__setitem__(0, 999)),
    ("bodies.y .* rows", lambda d: d["tables"]["bodies"]["y"].pop()),
    ("bodies.y must be|bodies.y of .* a list", lambda d: d["tables"]["bodies"].update(y=3)),
    ("order, none twice", lambda d: d["tables"]["bodies"]["id"].__setitem__(1, 1)),
    ("ids of its bodies", lambda d: d["handles"].pop()),
    ("a saved body must have a name", lambda d: d["handles"][0].update(name=3)),
    (
        "radius must be greater",
        lambda d: d["handles"][2].update(shape={"Circle": {"radius": -1.0}}),
    ),
    ("a saved Circle must have", lambda d: d["handles"][2].update(shape={"Circle": {"r": 1.0}})),
    ("cannot be a 'Sphere'", lambda d: d["handles"][2].update(shape={"Sphere": {"radius": 1.0}})),
    ("next_body", lambda d: d["tables"]["state"].update(next_body=[2])),
    ("state.tick .* cannot be -1", lambda d: d["tables"]["state"].update(tick=[-1])),
    ("state.dt .* rows|one row of state", lambda d: d["tables"]["state"].update(dt=[])),
    ("integrator 7", lambda d: d["laws"].update(integrator=7)),
    ("drag", lambda d: d["laws"].update(linear_drag=-1.0)),
    ("one law of drag", lambda d: d["laws"].update(linear_drag=1.0, quadratic_drag=1.0)),
    ("substeps", lambda d: d["laws"].update(substeps=10**30)),
    ("gravity_x .* finite, not 1000", lambda d: d["laws"].update(gravity_x=10**400)),
    ("corners that are there", lambda d: d["tables"]["bodies"]["corners"].__setitem__(3, 3)),
    ("pieces that are there", lambda d: d["tables"]["bodies"]["first_piece"].__setitem__(3, 0)),
    ("bodies whose they are", lambda d: d["tables"]["pieces"]["body"].__setitem__(3, 0)),
    ("links of its chain", lambda d: d["tables"]["pieces"]["after"].__setitem__(0, 9)),
    ("inverse_mass .* its mass", lambda d: d["tables"]["bodies"]["mass"].__setitem__(3, 7.0)),
    (
        "must have the shape that is in its rows",
        lambda d: d["handles"][-1].update(shape={"Circle": {"radius": 77.0}}),
    ),
]


@pytest.mark.parametrize(("sentence", "change"), WRONG, ids=[each[0] for each in WRONG])
def test_what_is_no_saved_world_is_refused_in_a_sentence(sentence: str, change: Change) -> None:
    world = heap()
    for _ in range(30):
        world.step()
    data = json.loads(json.dumps(world.to_dict()))
    change(data)
    with pytest.raises((ValueError, TypeError), match=sentence) as refused:
        World.from_dict(data)
    assert "\n" not in str(refused.value)


def test_data_of_another_kind_is_refused() -> None:
    for data in (None, [], "world", 3):
        with pytest.raises(TypeError, match="a saved world must be a dictionary"):
            World.from_dict(data)  # type: ignore[arg-type]


def test_values_come_back_as_they_were() -> None:
    decode = Decoder(KINDS)
    tilted = Polygon([(0.1, 0.2), (3.3, 0.1), (1.7, 2.9)])
    for value in (
        None, True, 3, 0.1, "word", math.inf, Vector(0.1, 0.2), Force(1, 2), tilted,
        Wall((0, 0), (0.1, 0.3), one_sided=True), (1.0, (2, "x")),
    ):  # fmt: skip
        back = decode(json.loads(json.dumps(encode(value), allow_nan=False)))
        assert back == value
        assert type(back) is type(value)
    again = decode(copy.deepcopy(encode(tilted)))
    assert (again.area, again.centroid, again.gyration) == (
        tilted.area, tilted.centroid, tilted.gyration,
    )  # fmt: skip
    assert encode(np.float64(0.5)) == 0.5
    assert encode(np.arange(2)) == [0, 1]
    with pytest.raises(ValueError, match="NaN"):
        encode(math.nan)
    with pytest.raises(TypeError, match="cannot be saved"):
        encode(object())


@pytest.mark.parametrize("loop", [False, True])
def test_a_world_of_one_chain_is_saved(loop: bool) -> None:
    """Its last link was taken for one that is not there, where no other body came after it."""
    world = World()
    world.add(Chain([(0, 0), (4, 0), (4, 4), (0, 4)], loop=loop))
    assert World.from_dict(json.loads(json.dumps(world.to_dict()))).digest() == world.digest()
