"""What is put at rest stays at rest: towers, heavy on light, and worlds that should never burst."""

import math

import pytest

from engine import Body, Force, Polygon, Wall, World

G = 9.81


def ground(friction: float = 0.5, width: float = 50.0) -> World:
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-width, 0), (width, 0)), friction=friction)
    return world


def tower(world: World, height: int, size: float = 1.0, apart: float = 0.0) -> list[Body]:
    """Boxes on each other, or so much apart (sizes) that they fall on each other."""
    return [
        world.add(
            Polygon.box(size, size),
            position=(0, size * (i + 0.5 + (i + 1) * apart)),
            friction=0.5,
        )
        for i in range(height)
    ]


@pytest.mark.parametrize("height", [10, 20])
def test_towers_that_land_come_to_rest(height: int) -> None:
    """They stand for a minute; after ten seconds at most nothing moves."""
    world = ground()
    boxes = tower(world, height, apart=1e-4)
    for tick in range(3600):
        world.step()
        if tick >= 600:
            assert max(box.speed for box in boxes) < 1e-12
    for i, box in enumerate(boxes):
        assert box.x == pytest.approx(0, abs=2e-3)
        assert box.y == pytest.approx(i + 0.5, abs=1e-3 * height)


def test_five_boxes_that_land_sag_by_less_than_a_millimetre() -> None:
    world = ground()
    boxes = tower(world, 5, apart=1e-4)
    for _ in range(300):
        world.step()
    assert 4.5 - 1e-3 < boxes[-1].y < 4.5


@pytest.mark.parametrize("apart", [0.0, 1e-4])
def test_a_hundred_times_heavier_box_stands_on_a_light_one(apart: float) -> None:
    world = ground()
    light, heavy = tower(world, 2, apart=apart)
    heavy.mass = 100
    for _ in range(600):
        world.step()
    assert heavy.y == pytest.approx(1.5, abs=1e-2)
    assert light.y == pytest.approx(0.5, abs=5e-3)
    assert max(heavy.speed, light.speed) < 1e-12


@pytest.mark.parametrize("apart", [0.0, 1e-4])
@pytest.mark.parametrize("size", [1e-3, 1e3])
def test_bodies_of_any_size_stack(size: float, apart: float) -> None:
    """A stack of three, as large as a grain or a mountain, falls no further than it should."""
    world = ground(width=50 * size)
    boxes = tower(world, 3, size, apart)
    for _ in range(240):
        world.step()
    for i, box in enumerate(boxes):
        assert box.y == pytest.approx(size * (i + 0.5), abs=0.02 * size)
        assert abs(box.angle) < 0.02


def test_an_immense_force_makes_no_nonsense() -> None:
    """1e12 N on a box that stands among others: v = F t / m, nothing else, and no NaN."""
    world = ground()
    boxes = tower(world, 3)
    boxes[2].exert(Force(0, 1e12), duration=1 / 60)
    for _ in range(30):
        world.step()
    assert boxes[2].vy == pytest.approx(1e12 / 60, rel=1e-9)
    for box in boxes[:2]:
        assert math.isfinite(box.x)
        assert math.isfinite(box.y)
        assert box.speed < 1.0
