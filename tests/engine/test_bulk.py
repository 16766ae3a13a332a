"""Many ticks and many bodies in one call."""

import math
from typing import Any

import numpy as np
import pytest

from engine import Body, Circle, LinearDrag, Particle, Polygon, Wall, World


def room(**given: Any) -> World:
    world = World(gravity=(0, -9.81), **given)
    world.add(Wall((-9, 0), (9, 1)), restitution=0.5, friction=0.4)
    for i in range(6):
        shape = (Circle(0.3), Particle(0.3), Polygon.box(0.5, 0.4))[i % 3]
        world.add(shape, position=(i - 3, 2 + 0.1 * i), velocity=(0.2 * i, 0), restitution=0.5)
    return world


def test_a_run_has_the_bits_of_as_many_steps() -> None:
    one, many = room(drag=LinearDrag(0.1)), room(drag=LinearDrag(0.1))
    tracks = many.run(
        90, record=("x", "y", "angle", "vx", "vy", "spin", "force_y"), collisions=True
    )
    times, seen, happened = [one.time], [[body.y for body in one]], []
    for _ in range(90):
        happened += [(hit.a.id, hit.b.id, hit.time, hit.impulse) for hit in one.step()]
        times.append(one.time)
        seen.append([body.y for body in one])
    assert one.digest() == many.digest()
    assert tracks.times.tolist() == times
    assert tracks["y"].tolist() == seen
    assert tracks["force_y"][-1].tolist() == [body.force.y for body in one]
    assert list(tracks) == ["x", "y", "angle", "vx", "vy", "spin", "force_y"]
    assert tracks.collision_count == len(tracks.collisions) > 5
    assert [(hit.a.id, hit.b.id, hit.time, hit.impulse) for hit in tracks.collisions] == happened
    assert tracks.of(3)["x"].tolist() == tracks["x"][:, 2].tolist()
    assert (tracks["x"][:, 0] == 0.0).all()
    assert (tracks["y"][:, 0] == 0.5).all()


def test_a_run_of_no_ticks_tells_the_start() -> None:
    tracks = room().run(0)
    assert tracks.times.tolist() == [0.0]
    assert tracks["x"].shape == (1, 7)
    assert tracks.collisions == ()


def test_bodies_that_come_and_go_within_a_run() -> None:
    world = room()

    def leave(body: Body, collision: Any) -> None:
        body._world.add(Circle(0.1), position=(0, 50))
        body._world.remove(body)

    world.body(4).on_collision = leave
    tracks = world.run(80)
    y = tracks.of(4)["y"]
    gone = np.flatnonzero(np.isnan(y))
    assert 0 < gone[0] < 80
    assert np.isnan(y[gone[0] :]).all()
    assert np.isfinite(tracks.of(5)["y"]).all()
    assert tracks.ids.tolist() == [1, 2, 3, 4, 5, 6, 7]
    assert tracks.of(5)["y"][-1] == world.body(5).y


def test_what_a_run_refuses() -> None:
    world = room()
    with pytest.raises(ValueError, match=r"record knows x, y, angle.*, not 'mass'"):
        world.run(3, record=("x", "mass"))
    with pytest.raises(ValueError, match="ticks must be at least 0, not -1"):
        world.run(-1)
    with pytest.raises(TypeError, match=r"ticks must be a whole number, not 1.5"):
        world.run(1.5)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="dt must be greater than zero"):
        world.run(1, dt=0)
    with pytest.raises(KeyError, match="'spin' was not recorded, only x"):
        world.run(1, record="x")["spin"]
    with pytest.raises(LookupError, match="no body 99 in these tracks"):
        world.run(1).of(99)


def test_the_state_of_all_bodies_is_one_array() -> None:
    world = room()
    world.run(20, record=())
    state = world.state()
    assert state.shape == (7, 7)
    for row, body in zip(state, world, strict=True):
        moving = (body.id, *body.position, body.angle, *body.velocity, body.spin)
        assert tuple(row) == moving
    state[0] = 5
    assert world.body(1).position == (0, 0.5)


def test_states_are_put_back() -> None:
    world, other = room(), room()
    other.run(30, record=())
    state = other.state()
    world.set_state(state[::-1])
    assert world.state().tolist() == state.tolist()
    world.set_state([[3, 1, 2, 0.5, 0, 0, 0]])
    assert world.body(3).position == (1, 2)
    assert world.body(4).position == other.body(4).position


@pytest.mark.parametrize(
    ("state", "sentence"),
    [
        ([[1, 0, 0.6, 0, 0, 0, 0]], "a wall is immovable: wall 1 takes no state"),
        ([[3, 0, 0, 0, 0, 0, 2]], r"particle 3 cannot have spin 2.0"),
        ([[2, 0, 0, 0, 0, 0, math.nan]], "a state must be finite"),
        ([[2, 0, 0, 0, 0, 0]], r"not the shape \(1, 6\)"),
        ([2], r"not the shape \(1,\)"),
        ([[2, 0, 0, 0, 0, 0, 0]] * 2, "each body once"),
    ],
)
def test_a_wrong_state_is_refused_and_changes_nothing(state: Any, sentence: str) -> None:
    world = room()
    before = world.digest()
    with pytest.raises(ValueError, match=sentence):
        world.set_state(state)
    with pytest.raises(LookupError, match="there is no body"):
        world.set_state([[2.5, 0, 0, 0, 0, 0, 0]])
    assert world.digest() == before
