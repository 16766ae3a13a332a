"""What rests in one place is let touch: it comes apart, without energy, and rests again.

A contact that begins between bodies that both rest steadily has borne no load that could be relied
on: one was divided by how long it had been borne, which was not at all.
"""

from collections.abc import Callable

import pytest

from engine import Body, Box, Circle, Distance, Shape, Wall, World


def unjoin(world: World, a: Body, b: Body) -> None:
    for joint in world.joints:
        joint.remove()


def heed(world: World, a: Body, b: Body) -> None:
    world.heed(a, b)


def unmask(world: World, a: Body, b: Body) -> None:
    b.mask = 0xFFFFFFFF


def ungroup(world: World, a: Body, b: Body) -> None:
    b.group = 0


@pytest.mark.parametrize("kernels", ["interpreted", "compiled"])
@pytest.mark.parametrize("let", [unjoin, heed, unmask, ungroup])
@pytest.mark.parametrize("shape", [Circle(0.3), Box(0.6, 0.6)])
@pytest.mark.parametrize("apart", [0.1, 0.55])
def test_bodies_that_rest_in_one_place_come_apart(
    apart: float, shape: Shape, let: Callable[[World, Body, Body], None], kernels: str
) -> None:
    world = World(gravity=(0, -9.81), kernels=kernels)
    world.add(Wall((-4, 0), (4, 0)), friction=0.0)
    given = {"unmask": {"mask": 1, "category": 2}, "ungroup": {"group": 3}}.get(let.__name__, {})
    a = world.add(shape, position=(0, 0.3), **given)
    b = world.add(shape, position=(apart, 0.3), **given)
    if let is unjoin:
        world.join(a, b, Distance())
    if let is heed:
        world.ignore(a, b)
    for _ in range(60):
        world.step()
    assert b.x - a.x == pytest.approx(apart, abs=1e-9)
    let(world, a, b)
    if let is unmask:
        a.mask = 0xFFFFFFFF
    for _ in range(120):
        world.step()
        assert world.kinetic_energy < 1e-3
    assert b.x - a.x == pytest.approx(0.6, abs=0.02)
    assert (a.x + b.x) / 2.0 == pytest.approx(apart / 2.0, abs=1e-9)
    assert a.y == pytest.approx(0.3, abs=1e-3)
