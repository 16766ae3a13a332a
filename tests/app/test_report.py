import json
from types import SimpleNamespace

import pytest
from fake_lesson import FakeLesson

from app.frames import Moment
from app.json_text import document
from app.player import Check
from app.report import Collisions, Output, Report
from app.scenario.mistakes import Place
from app.scenario.model import Caption, Comparison, Expect, Marker, Scenario, Until
from engine import Circle, World

HERE = Place("folder/push.yaml", 7, 5)


@pytest.fixture
def report():
    return Report(
        Scenario("p.yaml", 1, "inertia", "Push", "A push.", 7, "en", (720, 1280), 30, (), {}, ())
    )


def read(report, checks=(), outputs=()):
    return json.loads("".join(document(report.document(checks, outputs))))


def hit(n=0):
    body = SimpleNamespace(name=f"body {n % 3}")
    wall = SimpleNamespace(name="wall")
    return SimpleNamespace(
        a=wall, b=body, point=(1.0, n), normal=(0.0, 1.0), impulse=(0.0, 2.5),
        speed=1.25, restitution=0.5, time=n / 60,
    )  # fmt: skip


def test_the_header_says_what_was_made(report):
    report.frames = 31
    said = read(report)
    assert said["title"] == "Push"
    assert said["alt"] == "A push."
    assert (said["seed"], said["size"], said["fps"]) == (7, [720, 1280], 30)
    assert said["frames"] == 31
    assert said["duration"] == 31 / 30
    assert said["versions"]["scenario"] == 1


def test_the_world_is_digested_once_a_second_and_at_the_end(report):
    lesson = FakeLesson()
    lesson.body.velocity = (1, 0)
    report.moment(Moment(0.0, lesson.world, ()))
    for _ in range(90):
        lesson.world.step(1 / 60)
        report.moment(Moment(lesson.world.time, lesson.world, ()))
    said = read(report)
    assert [row["t"] for row in said["digests"]] == [0.0, pytest.approx(1.0)]
    assert len({row["digest"] for row in said["digests"]} | {said["digest"]}) == 3
    assert said["digest"] == lesson.world.digest()


def test_a_collision_is_told_with_the_impulse_that_b_received(report):
    report.moment(Moment(0.0, World(), [hit(6)]))
    assert read(report)["collisions"] == [
        {
            "t": 0.1, "a": "wall", "b": "body 0", "point": [1.0, 6.0], "normal": [0.0, 1.0],
            "impulse": [0.0, 2.5], "speed": 1.25, "restitution": 0.5,
        }
    ]  # fmt: skip


def test_many_collisions_take_little_memory():
    collisions = Collisions()
    for n in range(10_000):
        collisions.add(hit(n))
    held = collisions._numbers.itemsize * len(collisions._numbers)
    held += collisions._bodies.itemsize * len(collisions._bodies)
    assert held <= 100 * len(collisions) == 1_000_000
    assert next(iter(collisions))["b"] == "body 0"


def test_cues_have_film_time_and_world_time(report):
    report.heed(Marker(HERE, "now"), 2.0, 1.5)
    report.heed(Caption(HERE, "Look."), 2.5, 1.5)
    said = read(report)
    assert said["markers"] == [{"film": 2.0, "t": 1.5, "name": "now"}]
    assert said["captions"] == [{"film": 2.5, "t": 1.5, "text": "Look."}]


def test_checks_say_what_was_wanted_and_what_was_there(report):
    near = Expect(HERE, "body.speed", Comparison(near=1.5, tol=0.1))
    until = Until(HERE, "time", Comparison(above=1.0), 5.0)
    said = read(report, [Check(near, 1.7, 2.0, False), Check(until, 1.01, 1.01, True)])
    assert said["expects"] == [
        {
            "probe": "body.speed", "wanted": {"near": 1.5, "tol": 0.1}, "actual": 1.7,
            "passed": False, "t": 2.0, "file": "push.yaml", "line": 7,
        }
    ]  # fmt: skip
    assert [row["probe"] for row in said["untils"]] == ["time"]


def test_outputs_are_listed_with_their_hashes(report):
    film = Output("push.mp4", "mp4", 1000, "ab" * 32, frames=61, fps=60)
    said = read(report, outputs=[film, Output("push.csv", "csv", 10, "cd" * 32)])
    assert said["outputs"][0] == {
        "path": "push.mp4", "kind": "mp4", "bytes": 1000, "sha256": "ab" * 32,
        "frames": 61, "duration": 61 / 60,
    }  # fmt: skip
    assert "frames" not in said["outputs"][1]


def test_the_last_digest_is_of_the_world_as_it_was_told_last(report):
    world = World()
    world.add(Circle(0.1), mass=1.0)
    report.moment(Moment(0.0, world, ()))
    assert read(report)["digest"] == world.digest()
