"""Functions that people hand in may fail: the world is then as it was, or where the tick ended."""

from collections.abc import Callable
from typing import Any

import pytest

from engine import Body, Box, Circle, Pin, Wall, World


class Mistake(Exception):
    """What fails in a function of somebody's own."""


def fail(*_: Any) -> Any:
    raise Mistake


def room(**given: Any) -> World:
    world = World(gravity=(0, -9.81), **given)
    world.add(Wall((-5, 0), (5, 0)), restitution=0.5, friction=0.3)
    for x in range(3):
        world.add(Box(0.5, 0.5), position=(x, 0.3), velocity=(0, -2), restitution=0.4, friction=0.3)
    return world


@pytest.mark.parametrize("name", ["on_move", "on_collision"])
def test_a_callback_that_fails_fails_the_step_after_the_tick_is_over(name: str) -> None:
    """The world is where it would be without, and goes on to the same bits."""
    world, undisturbed = room(), room()
    setattr(world.body(3), name, fail)
    with pytest.raises(Mistake):
        world.run(30)
    undisturbed.run(world.tick)
    assert world.tick > 0
    assert world.digest() == undisturbed.digest()
    setattr(world.body(3), name, None)
    world.run(30)
    undisturbed.run(30)
    assert world.digest() == undisturbed.digest()


@pytest.mark.parametrize("integrator", ["semi-implicit-euler", "velocity-verlet", "rk4"])
@pytest.mark.parametrize("bad", [fail, lambda body, time: (float("nan"), 0), lambda *_: "up"])
def test_a_law_that_fails_leaves_the_world_as_it_was(
    integrator: str, bad: Callable[..., Any]
) -> None:
    """Also where it fails only when it is asked for the end of the tick."""
    world, undisturbed = room(integrator=integrator), room(integrator=integrator)
    calls = 0

    def law(body: Body, time: float) -> Any:
        nonlocal calls
        calls += 1
        return bad(body, time) if calls in (5, 22) else (0.1, 0.2)

    world.add_law(law)
    undisturbed.add_law(lambda body, time: (0.1, 0.2))
    failed = 0
    while world.tick < 40:
        before = world.digest()
        try:
            world.step()
        except (Mistake, ValueError, TypeError):
            failed += 1
            assert world.digest() == before
    assert failed == 2
    undisturbed.run(40)
    assert world.digest() == undisturbed.digest()


@pytest.mark.parametrize("bad", [fail, lambda a, b: float("nan"), lambda a, b: "much"])
@pytest.mark.parametrize("name", ["restitution_rule", "friction_rule"])
def test_a_rule_that_fails_is_asked_again(name: str, bad: Callable[..., Any]) -> None:
    """No pair keeps coefficients by a rule that was not asked to the end."""
    asked = 0

    def rule(a: float, b: float) -> Any:
        nonlocal asked
        asked += 1
        return bad(a, b) if asked == 3 else 0.25

    world, undisturbed = room(**{name: rule}), room(**{name: lambda a, b: 0.25})
    with pytest.raises((Mistake, ValueError, TypeError)):
        world.step()
    world.run(60)
    undisturbed.run(60)
    for one, other in zip(world, undisturbed, strict=True):
        assert one.position == pytest.approx(other.position, abs=1e-9)
    pairs = world.tables.pairs
    column = pairs.restitution if name == "restitution_rule" else pairs.friction
    assert {column[i] for i in range(world.tables.counts.pairs[0])} == {0.25}


def test_a_callback_may_remove_add_and_step() -> None:
    """It is called when the tick is over: the world is whole and all may be done to it."""
    world = room()
    seen: list[str] = []

    def met(body: Body, collision: Any) -> None:
        seen.append(body.name)
        world.remove(body)
        world.add(Circle(0.1), position=(0, 5), name="spawned")
        world.step()

    for body in list(world)[1:]:
        body.on_collision = met
    world.run(30)
    assert len(seen) == 3
    assert sum(body.name == "spawned" for body in world) == 3


@pytest.mark.parametrize("name", ["on_move", "on_collision"])
def test_a_body_that_is_refused_for_its_callback_leaves_the_world_as_it_was(name: str) -> None:
    """Not even an id is used up."""
    world = room()
    before = world.to_dict()
    with pytest.raises(TypeError):
        world.add(Circle(1), material="ice", **{name: "no function"})
    assert world.to_dict() == before
    assert world.add(Circle(1)).id == room().add(Circle(1)).id


def test_a_joint_that_is_refused_for_its_callback_leaves_the_world_as_it_was() -> None:
    world = room()
    before = world.to_dict()
    with pytest.raises(TypeError):
        world.join(world.body(2), world.body(3), Pin(at=(0, 0)), on_break="no function")  # type: ignore[arg-type]
    assert world.to_dict() == before
    assert world.joints == ()
