"""The world as people use it: adding, removing, reading, refusing, snapshots, callbacks."""

import math
import subprocess
import sys
from typing import Any

import numpy as np
import pytest

from engine import (
    Body,
    Circle,
    Collision,
    Diverged,
    Force,
    LinearDrag,
    Particle,
    Pin,
    Polygon,
    QuadraticDrag,
    Torque,
    Vector,
    Wall,
    World,
)

NAN, INF = math.nan, math.inf


def chaotic() -> World:
    """A dozen shapes that tumble in a closed room."""
    world = World(gravity=(0.5, -9.81), integrator="velocity-verlet")
    corners = [(0, 0), (6, 0.5), (6, 6), (0, 6)]
    for i in range(4):
        world.add(Wall(corners[i], corners[(i + 1) % 4]), restitution=0.6, friction=0.2)
    kinds = [Circle(0.3), Particle(0.25), Polygon.box(0.7, 0.5), Polygon.regular(5, 0.4)]
    for i in range(12):
        world.add(
            kinds[i % 4],
            mass=0.5 + 0.25 * i,
            position=(0.9 + 1.3 * (i % 4), 1.3 + 1.5 * (i // 4)),
            angle=0.3 * i,
            velocity=(math.sin(i) * 3, math.cos(3 * i)),
            restitution=0.1 * (i % 10),
            friction=0.05 * i,
        )
    return world


def test_bodies_are_listed_in_order_of_ids_which_are_never_reused() -> None:
    world = World()
    a, b, c = (world.add(Circle(1), position=(5 * i, 0), name=f"n{i}") for i in range(3))
    assert [body.id for body in world] == [a.id, b.id, c.id]
    world.remove(b)
    d = world.add(Circle(1), position=(50, 0))
    assert d.id > c.id
    assert list(world) == [a, c, d]
    assert len(world) == 3
    assert world.body(c.id) is c
    assert c.position == (10, 0)
    assert c.name == "n2"


def test_a_removed_body_is_refused() -> None:
    world = World()
    body = world.add(Circle(1), name="puck")
    push = body.exert(Force(1, 0))
    world.remove(body)
    assert not push.active
    for use in (lambda: body.x, lambda: world.remove(body), lambda: body.exert(Force(1, 0))):
        with pytest.raises(LookupError, match="puck is not in this world"):
            use()
    with pytest.raises(LookupError):
        world.body(body.id)
    with pytest.raises(LookupError):
        World().remove(body)
    world.step()


def test_removing_a_body_leaves_the_others_as_they_were() -> None:
    world = chaotic()
    for _ in range(60):
        world.step()
    bodies = list(world)
    keep = [(body.position, body.velocity, body.spin) for body in bodies if body is not bodies[6]]
    world.remove(bodies[6])
    assert [(body.position, body.velocity, body.spin) for body in world] == keep
    for _ in range(60):
        world.step()


def test_books() -> None:
    world = World(gravity=(0, -10))
    body = world.add(Circle(1), mass=2, position=(3, 4), velocity=(1, 2), spin=3)
    world.add(Wall((-9, -9), (9, -9)))
    assert body.momentum == (2, 4)
    assert body.inertia == 1
    assert body.angular_momentum == 3 * 4 - 4 * 2 + 3
    assert body.kinetic_energy == 5 + 4.5
    assert world.momentum == (2, 4)
    assert world.angular_momentum == body.angular_momentum
    assert world.kinetic_energy == 9.5
    assert world.potential_energy == 80


def test_sixty_ticks_are_one_second() -> None:
    world = World()
    for _ in range(600):
        world.step()
    assert world.time == pytest.approx(10, abs=1e-12)
    assert world.tick == 600
    world.step(0.5)
    assert world.time == pytest.approx(10.5, abs=1e-12)


def test_impulse_at_a_point() -> None:
    world = World()
    body = world.add(Circle(1), mass=2)
    body.apply_impulse((4, 0))
    assert body.velocity == (2, 0)
    body.apply_impulse((0, 2), at=(1, 0))
    assert body.velocity == (2, 1)
    assert body.spin == pytest.approx(2)


def test_every_point_of_a_body_moves_as_its_place_says() -> None:
    """v + w x r (rigid bodies, any textbook); and where it will be a moment later."""
    world = World()
    rod = world.add(Polygon.box(2, 0.1), position=(3, 1), velocity=(0.5, -1), spin=2)
    assert rod.velocity_at((4, 1)) == (0.5, 1.0)
    assert rod.velocity_at((3, 2)) == (-1.5, -1.0)
    tip = rod.to_world((1, 0))
    speed = rod.velocity_at(tip)
    world.step(1e-6)
    moved = rod.to_world((1, 0))
    assert (moved.x - tip.x) / 1e-6 == pytest.approx(speed.x, abs=1e-5)
    assert (moved.y - tip.y) / 1e-6 == pytest.approx(speed.y, abs=1e-5)
    assert world.add(Wall((0, 0), (1, 0))).velocity_at((1, 0)) == (0, 0)
    with pytest.raises(TypeError, match="point must be a pair of numbers, not 3"):
        rod.velocity_at(3)


def test_mass_scales_inertia() -> None:
    body = World().add(Polygon.box(1, 1), inertia=3.0)
    body.mass = 2.0
    assert body.inertia == 6.0


def test_world_vertices() -> None:
    body = World().add(Polygon.box(2, 2), position=(5, 5), angle=math.pi / 2)
    assert sorted(round(v.x, 9) for v in body.vertices) == [4, 4, 6, 6]
    assert body.to_local(body.to_world((1, 2))) == pytest.approx((1, 2))


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"mass": 0}, "mass must be greater than zero, not 0"),
        ({"mass": -1}, "mass"),
        ({"mass": NAN}, "mass must be finite, not nan"),
        ({"mass": INF}, "mass must be finite, not inf"),
        ({"mass": "2"}, "mass must be a number"),
        ({"inertia": 0}, "inertia"),
        ({"position": (NAN, 0)}, "position"),
        ({"position": (1, 2, 3)}, "position"),
        ({"velocity": (0, INF)}, "velocity"),
        ({"angle": NAN}, "angle"),
        ({"spin": INF}, "spin"),
        ({"restitution": 1.5}, "restitution must be between 0 and 1, not 1.5"),
        ({"restitution": -0.1}, "restitution"),
        ({"restitution": NAN}, "restitution"),
        ({"friction": -1}, "friction must not be negative, not -1"),
        ({"friction": NAN}, "friction"),
    ],
)
def test_bad_bodies(given: dict[str, Any], says: str) -> None:
    world = World()
    with pytest.raises((ValueError, TypeError), match=says):
        world.add(Circle(1), **given)
    assert len(world) == 0


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("mass", 0),
        ("position", (NAN, 0)),
        ("velocity", (0, INF)),
        ("angle", NAN),
        ("spin", "fast"),
        ("restitution", 2),
        ("friction", -1),
    ],
)
def test_bad_changes(name: str, value: Any) -> None:
    body = World().add(Circle(1))
    before = getattr(body, name)
    with pytest.raises((ValueError, TypeError), match=name):
        setattr(body, name, value)
    assert getattr(body, name) == before


@pytest.mark.parametrize("given", [{"mass": 1}, {"velocity": (0, 0)}, {"angle": 0}, {"spin": 1}])
def test_walls_take_no_motion(given: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match="a wall is immovable"):
        World().add(Wall((0, 0), (1, 0)), **given)


def test_walls_are_immovable() -> None:
    wall = World().add(Wall((0, 0), (2, 0)), name="floor")
    for name, value in (("position", (1, 1)), ("velocity", (1, 0)), ("mass", 3), ("angle", 1)):
        with pytest.raises(ValueError, match="floor"):
            setattr(wall, name, value)
    with pytest.raises(ValueError, match="floor"):
        wall.exert(Force(1, 0))
    assert wall.is_wall
    assert wall.position == (1, 0)
    assert wall.momentum == (0, 0)


def test_particles_never_rotate() -> None:
    world = World()
    with pytest.raises(ValueError, match="never rotates"):
        world.add(Particle(1), spin=1)
    body = world.add(Particle(1))
    with pytest.raises(ValueError, match="never rotates"):
        body.spin = 2
    body.exert(Torque(5))
    body.exert(Force(1, 0), at=(0, 1))
    world.step()
    assert body.spin == 0
    assert body.angle == 0


@pytest.mark.parametrize("dt", [0, -1, NAN, INF, "1"])
def test_bad_ticks(dt: Any) -> None:
    with pytest.raises((ValueError, TypeError), match="dt must be"):
        World().step(dt)


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"gravity": (0, NAN)}, "gravity"),
        ({"gravity": 9.81}, "gravity"),
        ({"drag": 3}, "drag"),
        ({"integrator": "euler"}, "integrator must be one of .* not 'euler'"),
        ({"substeps": 0}, "substeps must be at least 1, not 0"),
        ({"kernels": "fast"}, "kernels must be one of"),
    ],
)
def test_bad_worlds(given: dict[str, Any], says: str) -> None:
    with pytest.raises((ValueError, TypeError), match=says):
        World(**given)


@pytest.mark.parametrize("make", [LinearDrag, QuadraticDrag])
def test_bad_drag(make: Any) -> None:
    for value in (-1, NAN, "x"):
        with pytest.raises((ValueError, TypeError), match="drag k"):
            make(value)


def test_bad_pushes() -> None:
    body = World().add(Circle(1))
    for make in (lambda: Force(NAN, 0), lambda: Force(0, INF), lambda: Torque(NAN)):
        with pytest.raises(ValueError, match="must be finite"):
            make()
    for duration in (0, -1, NAN, INF):
        with pytest.raises(ValueError, match="duration"):
            body.exert(Force(1, 0), duration=duration)
    with pytest.raises(ValueError, match="no point of attack"):
        body.exert(Torque(1), at=(0, 0))
    with pytest.raises(TypeError, match="only a Force or a Torque"):
        body.exert((1, 0))  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="impulse"):
        body.apply_impulse((NAN, 0))
    with pytest.raises(TypeError, match="needs a shape, such as a Circle"):
        World().add("circle")  # type: ignore[arg-type]
    push = body.exert(Force(1, 0))
    with pytest.raises(TypeError, match=r"only a Force or a Torque .*, not 3"):
        push.change(3)  # type: ignore[arg-type]
    push.stop()
    with pytest.raises(ValueError, match="is over"):
        push.change(Force(2, 0))


def test_a_world_that_diverges_names_tick_and_body() -> None:
    world = World()
    world.add(Circle(1), name="calm")
    wild = world.add(Circle(1), position=(9, 0), name="wild")
    for _ in range(3):
        world.step()
    wild.exert(Force(1e200, 0))
    with pytest.raises(Diverged, match="wild left the range of numbers in tick 4"):
        world.step()


def test_the_first_tick_in_which_a_world_diverges_is_tick_one() -> None:
    world = World()
    world.add(Circle(1), name="wild").exert(Force(1e200, 0))
    with pytest.raises(Diverged, match=r"in tick 1$"):
        world.step()


def test_what_names_no_push_is_refused_in_a_sentence() -> None:
    world = World()
    push = world.add(Circle(1)).exert(Force(1, 0))
    for wrong in (np.array([1, 2]), [push.id], push, "1", None, True):
        for ask in (world.stop, world.is_acting, lambda id: world.change_push(id, 1, 0, 0)):
            with pytest.raises(TypeError, match="a push is named by a number, its id, not by"):
                ask(wrong)
    world.stop(push.id + 1)
    assert push.active
    world.stop(push.id)
    assert not push.active


def test_a_huge_force_does_not_pass_unnoticed() -> None:
    world = World()
    body = world.add(Circle(1))
    body.exert(Force(1e12, 0), duration=1 / 60)
    world.add(Wall((1e6, -1e6), (1e6, 1e6)))
    world.step()
    assert body.x < 1e6


def test_a_restored_world_continues_as_if_never_interrupted() -> None:
    world = chaotic()
    world_push = next(body for body in world if not body.is_wall).exert(Force(3, 0), duration=1.7)
    for _ in range(60):
        world.step()
    saved, digest = world.snapshot(), world.digest()
    first = [world.step() for _ in range(90)]
    end = world.digest()
    for _ in range(2):
        world.restore(saved)
        assert world.digest() == digest
        assert world_push.active
        second = [world.step() for _ in range(90)]
        assert world.digest() == end
        assert second == first


def test_restore_brings_gravity_and_rules_back() -> None:
    """What was set after the snapshot went on to act: the ball fell upwards, and did not bounce."""
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    world.add(Wall((-5, 0), (5, 0)), restitution=1.0)
    world.add(Circle(0.5), position=(0, 1.5))
    saved = world.snapshot()
    world.gravity = (0, 20)
    world.restitution_rule = min
    world.restore(saved)
    assert world.gravity == (0, -9.81)
    for _ in range(60):
        world.step()
    assert world.kinetic_energy + world.potential_energy == pytest.approx(9.81 * 1.5, rel=1e-12)


def test_restore_brings_bodies_back() -> None:
    world = World()
    a, b = world.add(Circle(1)), world.add(Circle(1), position=(5, 0))
    saved = world.snapshot()
    world.remove(a)
    c = world.add(Circle(1), position=(9, 9))
    world.restore(saved)
    assert list(world) == [a, b]
    with pytest.raises(LookupError):
        _ = c.x
    with pytest.raises(ValueError, match="another world"):
        World().restore(saved)
    with pytest.raises(TypeError, match="only a Snapshot"):
        world.restore(3)  # type: ignore[arg-type]


CODE = """
import sys; sys.path.insert(0, {folder!r})
from test_world import chaotic
world = chaotic()
for _ in range(120): world.step()
print(world.digest())
assert "numba" not in sys.modules and "pygame" not in sys.modules
"""


@pytest.mark.parametrize("seed", ["0", "123"])
def test_digest_does_not_depend_on_the_process(seed: str) -> None:
    from pathlib import Path

    world = chaotic()
    for body in world:
        body.name = "other"
    for _ in range(120):
        world.step()
    run = subprocess.run(
        [sys.executable, "-O", "-c", CODE.format(folder=str(Path(__file__).parent))],
        capture_output=True,
        text=True,
        check=True,
        env={"PYTHONHASHSEED": seed, "TZ": "Asia/Tokyo", "LC_ALL": "C"},
    )
    assert run.stdout.strip() == world.digest()


def test_digest_tells_worlds_apart() -> None:
    a, b = chaotic(), chaotic()
    assert a.digest() == b.digest()
    body = list(b)[7]
    body.velocity = (body.vx + 1e-15, math.nextafter(body.vy, 10))
    assert a.digest() != b.digest()


def test_callbacks_run_after_the_step_in_order() -> None:
    world = World()
    calls: list[str] = []
    a = world.add(Circle(0.5), velocity=(8, 0), restitution=1, name="a")
    b = world.add(Circle(0.5), position=(1.05, 0), name="b")
    c = world.add(Circle(0.5), position=(9, 0), name="c")
    for body in (c, b, a):
        body.on_move = lambda body: calls.append(f"{body.name} moved")

    def hit(body: Body, collision: Collision) -> None:
        calls.append(f"{body.name} hit")
        if body is b:
            world.remove(a)
            world.add(Circle(0.1), position=(20, 20))

    a.on_collision = b.on_collision = hit
    (collision,) = world.step()
    assert calls == ["a moved", "b moved", "a hit", "b hit"]
    assert collision.a is a
    assert len(world) == 3
    world.step()


def test_the_first_example_of_the_design() -> None:
    world = World(gravity=(0.0, -9.81))
    floor = world.add(Wall((0, 0), (10, 0)))
    puck = world.add(
        Polygon.regular(6, radius=0.5),
        mass=2.0,
        position=(5, 3),
        angle=0.1,
        velocity=(1, 0),
        restitution=0.8,
        friction=0.3,
        name="puck",
    )
    push = puck.exert(Force(3, 0), duration=0.5)
    collisions = [c for _ in range(60) for c in world.step()]
    assert not push.active
    assert collisions
    for collision in collisions:
        assert (collision.a, collision.b) == (floor, puck)
        assert collision.normal == pytest.approx((0, 1), abs=1e-12)
        assert collision.impulse.y > 0
        assert isinstance(collision.point, Vector)


@pytest.mark.parametrize(
    ("shape", "mass"), [(Circle(1e-320), 1.0), (Circle(1e160), 1.0), (Circle(1.0), 1e-200)]
)
def test_masses_beyond_what_can_be_computed_are_refused(shape: Circle, mass: float) -> None:
    with pytest.raises(ValueError, match="beyond what can be computed"):
        World().add(shape, mass=mass)


@pytest.mark.parametrize("stranger", [5, None, "ball"])
def test_what_is_no_body_is_refused(stranger: Any) -> None:
    world = World()
    ball = world.add(Circle(1))
    for call in (lambda: world.remove(stranger), lambda: world.ignore(ball, stranger)):
        with pytest.raises(TypeError, match="it takes a body of this world, not"):
            call()
    with pytest.raises(TypeError, match="it takes a body of this world, not 5"):
        world.join(ball, 5, Pin((0, 0)))  # type: ignore[arg-type]


def test_a_name_is_text() -> None:
    with pytest.raises(TypeError, match="name must be text, not 5"):
        World().add(Circle(1), name=5)  # type: ignore[arg-type]
