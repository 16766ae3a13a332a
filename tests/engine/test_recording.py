"""A recording replays to the last bit, and a replay that goes astray says where."""

import copy
import inspect
import json
from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine import (
    Body,
    Circle,
    Divergence,
    Force,
    Joint,
    Polygon,
    Push,
    Recording,
    Torque,
    Wall,
    World,
    replay,
)
from engine.inputs import is_input

READS = {
    World: {
        "step", "run", "ledger", "state", "record", "snapshot", "to_dict", "from_dict", "digest",
        "body", "row", "is_acting", "ignores", "joint",
        "query_point", "query_box", "cast_ray", "cast_ray_through", "cast_shape", "nearest",
    },
    Body: {"to_world", "to_local", "velocity_at", "name", "on_move", "on_collision"},
    Push: set(),
    Joint: {"on_break"},
}  # fmt: skip
"""What is public and no input: it changes no motion, is a step, or only listens."""


def room() -> World:
    world = World(gravity=(0, -9.81))
    corners = [(0, 0), (6, 0), (6, 6), (0, 6)]
    for i in range(4):
        world.add(Wall(corners[i], corners[(i + 1) % 4]), restitution=0.5, friction=0.3)
    for i in range(5):
        world.add(
            Circle(0.3) if i % 2 else Polygon.box(0.5, 0.4),
            position=(1 + i, 2),
            velocity=(0.5 * i, 0),
            restitution=0.3,
            friction=0.3,
            name=f"n{i}",
        )
    return world


def play(world: World, ticks: int = 90) -> Recording:
    """Do all kinds of things to a room of bodies, and record it."""
    for _ in range(7):
        world.step()
    with world.record() as recording:
        pushes = []
        for tick in range(ticks):
            body = world.body(5 + tick % 4)
            if tick % 17 == 3:
                pushes.append(body.exert(Force(2, 3), at=body.position))
                body.exert(Torque(0.3), duration=0.1)
            elif tick % 17 == 6:
                pushes[-1].change(Force(-1, 4))
            elif tick % 17 == 9:
                pushes.pop().stop()
            elif tick == 21:
                body.position = (x for x in (3, 5))
                body.angle, body.velocity, body.spin = 0.3, (1, 2), -2
            elif tick == 35:
                body.mass, body.restitution, body.friction = 2.0, 0.9, 0.1
                world.gravity = (1, -8)
                body.apply_impulse((0.5, 0.5), at=(3, 3))
            elif tick == 40:
                world.remove(world.body(9))
                world.add(Circle(0.2), position=(3, 5.5), velocity=(0, -3), restitution=0.5)
            world.step(1 / 60 if tick < 70 else 1 / 120)
    return recording


def test_a_replay_ends_where_the_world_did() -> None:
    world = room()
    recording = play(world)
    assert recording.ticks == 90
    again = replay(recording)
    assert again.digest() == world.digest()
    assert again.tick == world.tick
    assert again.time == world.time
    assert [body.name for body in again] == [body.name for body in world]


def test_a_recording_is_saved_as_json() -> None:
    world = room()
    recording = play(world)
    data = json.loads(json.dumps(recording.to_dict(), allow_nan=False))
    loaded = Recording.from_dict(data)
    assert loaded.to_dict() == recording.to_dict()
    assert replay(loaded).digest() == world.digest()
    assert recording.spans == [[1 / 60, 70], [1 / 120, 20]]
    assert [each["tick"] for each in recording.digests] == [53]


def test_inputs_say_what_was_done_and_when() -> None:
    world = room()
    with world.record() as recording:
        world.step()
        world.body(6).exert(Force(1, 2), duration=0.5)
        world.body(6).velocity = (1, 2)
    assert recording.inputs == [
        {
            "tick": 1, "on": {"Body": 6}, "call": "exert",
            "args": [{"Force": {"x": 1.0, "y": 2.0}}], "given": {"duration": 0.5},
        },
        {"tick": 1, "on": {"Body": 6}, "call": "velocity", "args": [[1, 2]], "given": {}},
    ]  # fmt: skip
    world.body(6).velocity = (0, 0)
    assert len(recording.inputs) == 2
    assert replay(recording).body(6).velocity == (1, 2)


def test_what_was_refused_is_no_input() -> None:
    world = room()
    with world.record() as recording:
        with pytest.raises(ValueError):
            world.body(6).mass = -1
        with pytest.raises(LookupError):
            World().remove(world.body(6))
    assert recording.inputs == []


def test_what_callbacks_do_is_on_record() -> None:
    def jump(body: Body, collision: Any) -> None:
        body.velocity = (0, 4)

    world = room()
    world.body(6).on_collision = jump
    with world.record() as recording:
        world.add(Circle(0.2), position=(3, 4), on_move=lambda body: setattr(body, "spin", 1.0))
        for _ in range(80):
            world.step()
    assert {each["call"] for each in recording.inputs} == {"add", "velocity", "spin"}
    again = replay(recording)
    assert again.digest() == world.digest()
    assert again.body(6).on_collision is None


def test_a_restored_world_is_recorded() -> None:
    world = room()
    early = world.snapshot()
    for _ in range(20):
        world.step()
    with world.record() as recording:
        world.step()
        world.restore(early)
        world.remove(world.body(7))
        for _ in range(10):
            world.step()
    assert replay(recording).digest() == world.digest()


Change = Callable[[dict[str, Any]], object]


def nudge(data: dict[str, Any]) -> None:
    entry = next(each for each in data["inputs"] if each["tick"] == 21 and each["args"][0])
    assert entry["on"] == {"Body": 6}
    entry["args"] = [[3, 5.000001]]


def test_a_tampered_input_is_named_by_tick_and_body() -> None:
    world = room()
    data = copy.deepcopy(play(world).to_dict())
    nudge(data)
    with pytest.raises(Divergence, match="n1 ended tick 29 otherwise") as found:
        replay(Recording.from_dict(data))
    assert found.value.tick == 29
    assert found.value.body is not None
    assert found.value.body.id == 6


def test_what_is_done_behind_the_recorder_is_named() -> None:
    world = room()
    with world.record() as recording:
        for tick in range(30):
            world.step()
            if tick == 12:
                world.bodies.vx[world.row(world.body(8))] += 1e-12
    with pytest.raises(Divergence, match="n3 ended tick 14 otherwise"):
        replay(recording)


@given(tick=st.integers(0, 59), row=st.integers(4, 8))
@settings(max_examples=15, derandomize=True)
def test_any_change_of_any_mark_is_found(tick: int, row: int) -> None:
    recording = copy.deepcopy(RECORDED)
    mark = bytearray(recording.marks[tick])
    mark[4 * row] ^= 1
    recording.marks[tick] = bytes(mark)
    with pytest.raises(Divergence) as found:
        replay(recording)
    assert (found.value.tick, found.value.body and found.value.body.id) == (8 + tick, row + 1)


def test_other_differences_are_found() -> None:
    missing = copy.deepcopy(RECORDED)
    missing.marks[3] = missing.marks[3][:-4]
    with pytest.raises(Divergence, match="after tick 11 there are 9 bodies, not 8"):
        replay(missing)
    digest = copy.deepcopy(RECORDED)
    digest.digests[0]["digest"] = "0"
    with pytest.raises(Divergence, match=r"contacts and pushes .* by tick 60"):
        replay(digest)
    end = copy.deepcopy(RECORDED)
    end.end = "0"
    with pytest.raises(Divergence, match=r"contacts and pushes .* at the end"):
        replay(end)


@pytest.mark.parametrize(
    ("sentence", "change"),
    [
        ("format 1, not 0", lambda d: d.update(format=0)),
        ("a recording must have 'spans'", lambda d: d.pop("spans")),
        ("has no 'author'", lambda d: d.update(author="me")),
        ("an input of a recording must have 'call'", lambda d: d["inputs"][0].pop("call")),
        ("inputs of a recording must be a list", lambda d: d.update(inputs=3)),
        ("tick of an input must be at least 0", lambda d: d["inputs"][0].update(tick=-1)),
        ("no input is called 'step'", lambda d: d["inputs"][0].update(call="step")),
        ("no input is called '__class__'", lambda d: d["inputs"][0].update(call="__class__")),
        ("an input was given must be a dict", lambda d: d["inputs"][0].update(given=1.5)),
        ("must have 1 rows, not 0", lambda d: d["inputs"][0].update(call="velocity", args=[])),
        ("tick of a span must be greater", lambda d: d["spans"][0].__setitem__(0, -1)),
        ("ticks of a span must be at least", lambda d: d["spans"][0].__setitem__(1, 0)),
        ("a span .* must have 2", lambda d: d["spans"][0].pop()),
        ("must be a string", lambda d: d["marks"].__setitem__(0, 3)),
        ("must be base64", lambda d: d["marks"].__setitem__(0, "é")),
        ("four bytes a body", lambda d: d["marks"].__setitem__(0, "AAA=")),
        ("cannot have 89 marks", lambda d: d["marks"].pop()),
        ("no input acts on a 'Ghost'", lambda d: d["inputs"][0].update(on={"Ghost": 1})),
        ("a saved world must be a dictionary", lambda d: d.update(start=None)),
    ],
)
def test_what_is_no_recording_is_refused_in_a_sentence(sentence: str, change: Change) -> None:
    data = json.loads(json.dumps(play(room()).to_dict()))
    change(data)
    with pytest.raises((ValueError, TypeError), match=sentence):
        replay(Recording.from_dict(data))


def test_a_world_is_recorded_once_at_a_time() -> None:
    world = room()
    recording = world.record()
    with pytest.raises(ValueError, match="is being recorded already"):
        world.record()
    recording.stop()
    recording.stop()
    world.record().stop()
    with pytest.raises(TypeError, match="only a Recording can be replayed, not 3"):
        replay(3)  # type: ignore[arg-type]


@pytest.mark.parametrize("kind", READS)
def test_all_that_acts_on_a_world_is_an_input(kind: type) -> None:
    """Mark a new method that changes the world with `@noted`, or add it to `READS`."""
    for name, value in vars(kind).items():
        if isinstance(value, property) and value.fset is not None and name not in READS[kind]:
            assert is_input(value.fset), name
        elif inspect.isfunction(value) and not name.startswith("_") and name not in READS[kind]:
            assert is_input(value), name


RECORDED = play(room(), 70)
