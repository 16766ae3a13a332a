"""What somebody sees who tries the engine at Python's prompt: short lines, and hints."""

import copy
import math
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import engine
from engine import (
    Body,
    Box,
    Chain,
    Circle,
    Compound,
    Distance,
    Joint,
    Pin,
    PointGravity,
    Polygon,
    Removed,
    Spring,
    Tracks,
    Wall,
    World,
)

ELL = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 3), (0, 3)]


def two() -> tuple[World, Body, Body, Joint]:
    world = World()
    a, b = world.add(Circle(1), name="a"), world.add(Box(1, 1), position=(3, 0), name="b")
    return world, a, b, world.join(a, b, Pin(at=(1, 0)))


def test_everything_says_in_a_line_what_it_is() -> None:
    world, a, _, pin = two()
    tracks = world.run(10, record=("x", "vy"))
    with world.record() as recording:
        a.velocity = (1, 0)
        world.step()
    assert repr(world.snapshot()) == "<Snapshot: 2 bodies, after tick 11>"
    assert repr(tracks) == "<Tracks: 10 ticks of 2 bodies, x, vy>"
    assert repr(recording) == "<Recording: 1 ticks, 1 inputs>"
    assert repr(pin) == "<Joint 1, a to b: Pin>"
    pin.remove()
    assert repr(pin) == "<Joint 1, a to b: removed>"


@pytest.mark.parametrize(
    ("shape", "says"),
    [
        (Circle(1), "<Body 1 'it': Circle(radius=1.0)>"),
        (Polygon.regular(6, 1), "<Body 1 'it': Polygon of 6 vertices>"),
        (Polygon.concave(ELL), "<Body 1 'it': Concave of 6 vertices>"),
        (Compound([Box(1, 1), Circle(1)]), "<Body 1 'it': Compound of 2 parts>"),
        (Wall((0, 0), (1, 0)), "<Body 1 'it': Wall from (0.0, 0.0) to (1.0, 0.0)>"),
        (Chain([(0, 0), (1, 0), (1, 1)]), "<Body 1 'it': Chain of 3 points>"),
    ],
)
def test_a_body_says_what_shape_it_has(shape: Any, says: str) -> None:
    body = World().add(shape, name="it")
    assert repr(body) == says
    body._world.remove(body)
    assert repr(body) == says


@pytest.mark.parametrize("shape", [Polygon.regular(5, 1), Polygon.concave(ELL), Box(1, 2)])
def test_a_shape_says_what_makes_it_anew(shape: Any) -> None:
    again = eval(repr(shape), vars(engine))
    assert type(again) is type(shape)
    for one, other in zip(again.vertices, shape.vertices, strict=True):
        assert math.dist(one, other) < 1e-12


def wrong(ask: Callable[[World, Body, Body, Joint], Any], error: type[Exception]) -> str:
    with pytest.raises(error) as raised:
        ask(*two())
    return str(raised.value)


def test_what_others_write_is_refused_with_a_hint() -> None:
    said = wrong(lambda w, a, b, j: w.add(Circle(1), mass=math.inf), ValueError)
    assert said == 'mass must be finite, not inf: give kind="kinematic" or "static" instead'
    said = wrong(lambda w, a, b, j: w.add(Circle(1), inertia=math.inf), ValueError)
    assert said == "inertia must be finite, not inf: give fixed_rotation=True instead"
    said = wrong(lambda w, a, b, j: w.remove(j), TypeError)  # type: ignore[arg-type]
    assert said.endswith("which has a remove() of its own")
    law = PointGravity((0, 0), 1)
    said = wrong(lambda w, a, b, j: w.remove(w.add_law(law)), TypeError)  # type: ignore[arg-type]
    assert said.endswith("which has a remove() of its own")
    said = wrong(lambda w, a, b, j: two()[0].remove(a), Removed)
    assert said == "a is not in this world but in another"
    said = wrong(lambda w, a, b, j: setattr(j, "stiffness", 3), ValueError)
    assert said == "a Pin has no stiffness"
    said = wrong(lambda w, a, b, j: setattr(j, "damping", 3), ValueError)
    assert said == "a Pin has no damping"
    said = wrong(lambda w, a, b, j: Polygon(ELL), ValueError)
    assert said.endswith("is no corner of it: Polygon.concave takes others")
    at = Distance(anchor_a=(1, 1), anchor_b=(1, 1))
    said = wrong(lambda w, a, b, j: w.join(a, b, at), ValueError)
    assert said == "a Distance needs a length, as both ends are at (1.0, 1.0)"


def test_tracks_are_a_mapping_of_arrays() -> None:
    world, a, _, _ = two()
    tracks = world.run(5, record=("x", "y"))
    assert {name: column.shape for name, column in dict(tracks).items()} == {
        "x": (6, 2), "y": (6, 2),
    }  # fmt: skip
    assert "x" in tracks
    assert list(tracks.of(a)) == ["x", "y"]
    assert isinstance(tracks, Tracks)


def test_what_a_world_returns_can_be_pickled_and_copied() -> None:
    world, a, b, _ = two()
    world.join(a, b, Spring(10))
    tracks = world.run(5, collisions=True)
    for each in (tracks, world.ledger(), world.contacts, world.step(), a.shape):
        copy.deepcopy(each)
        assert repr(pickle.loads(pickle.dumps(each))) == repr(each)


def test_the_package_names_what_is_public_and_says_that_it_is_typed() -> None:
    assert dir(engine) == sorted(engine.__all__)
    assert engine.__file__ is not None
    assert (Path(engine.__file__).parent / "py.typed").exists()
