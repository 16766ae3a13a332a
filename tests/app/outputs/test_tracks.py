import csv
from collections.abc import Callable
from pathlib import Path

import pytest

from app.frames import Film, Frame, Moment
from app.outputs import open_sink
from app.outputs.tracks import HEADER
from engine import Force, Particle, Wall, World

Write = Callable[..., Path]


@pytest.fixture
def world() -> World:
    world = World()
    world.add(Wall((0, -9), (9, -9)))
    puck = world.add(Particle(0.5), mass=2.0, position=(-0.0, 1), velocity=(0.1, 0), name="puck, A")
    puck.exert(Force(3, 0))
    world.add(Particle(0.5), position=(5, 5))
    return world


def rows(path: Path) -> list[list[str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.reader(file))


def test_a_row_per_moving_body_and_tick(tmp_path: Path, film: Film, world: World) -> None:
    sink = open_sink(tmp_path / "film.csv", film)
    expected = []
    for _ in range(3):
        sink.moment(Moment(world.time, world, []))
        for body in world:
            if not body.is_wall:
                expected.append([world.time, body.x, body.y, body.vx, body.force.x])
        world.step()
    sink.close()
    header, *found = rows(tmp_path / "film.csv")
    assert tuple(header) == HEADER
    assert [[float(row[i]) for i in (0, 2, 3, 5, 8)] for row in found] == expected
    assert [row[1] for row in found[:1]] == ["puck, A"]
    assert float(found[2][8]) == 3.0
    assert "-0.0" not in {cell for row in found for cell in row}
    assert b"\r" not in (tmp_path / "film.csv").read_bytes()


def test_a_world_that_stands_still_is_written_once(
    tmp_path: Path, film: Film, world: World
) -> None:
    sink = open_sink(tmp_path / "film.csv", film)
    for _ in range(4):
        sink.moment(Moment(world.time, world, []))
    world.step()
    sink.moment(Moment(world.time, world, []))
    sink.close()
    assert len(rows(tmp_path / "film.csv")) == 1 + 2 * 2


def test_bodies_without_a_name_go_by_their_number(
    tmp_path: Path, film: Film, pictures: list[object]
) -> None:
    class Body:
        is_wall, id, name = False, 7, None
        x = y = angle = vx = vy = spin = torque = -0.0
        force = type("Vector", (), {"x": 0.1, "y": -0.0})

    class Room(list[Body]):
        tick = 0

    sink = open_sink(tmp_path / "film.csv", film)
    sink.frame(Frame(0, pictures[0]))  # type: ignore[arg-type]
    sink.moment(Moment(0.0, Room([Body()]), []))  # type: ignore[arg-type]
    sink.close()
    zeros = ["0.0"] * 6
    assert rows(tmp_path / "film.csv")[1] == ["0.0", "body.7", *zeros, "0.1", "0.0", "0.0"]
