"""Bodies made of pieces: outside they are as smooth as one piece, and as solid."""

import math
import random

import pytest

from engine import Body, Box, Capsule, Circle, Compound, Polygon, Shape, Wall, World

SLIDERS: list[Shape] = [
    Box(1.0, 0.5),
    Polygon([(-0.5, -0.25), (0.5, -0.25), (-0.5, 0.3)]),
    Polygon.regular(6, 0.25 / math.cos(math.pi / 6)),
    Box(0.6, 0.3, rounding=0.1),
    Capsule(0.8, 0.25),
    Circle(0.25),
]
ROW = Compound([(Box(1, 1), (i, 0)) for i in range(16)])
"""Sixteen cubes that are one body."""
COMB = Polygon.concave(
    [(0, 0)]
    + [p for i in range(8) for p in ((2 * i + 1, -1.0), (2 * i + 2, -0.2))]
    + [(16, 1), (0, 1)]
)
"""A beam with teeth below; its upper side is one side of several pieces."""


def height_of(shape: Shape) -> float:
    """How far the lowest point is below the centre (m)."""
    world = World()
    body = world.add(shape)
    return -min(y for line in body.outlines for _, y in line)


def on(floor: Shape, shape: Shape, friction: float = 0.0) -> tuple[World, Body]:
    """Put a shape on the left end of a floor, whose upper side is then at nought."""
    world = World(gravity=(0, -9.81))
    base = world.add(floor, kind="static", friction=friction)
    low = min(x for line in base.outlines for x, _ in line)
    top = max(y for line in base.outlines for _, y in line)
    base.position = (base.x - low, base.y - top)
    return world, world.add(
        shape, position=(0.6, height_of(shape)), velocity=(4, 0), friction=friction
    )


@pytest.mark.parametrize("shape", SLIDERS)
@pytest.mark.parametrize("floor", [ROW, COMB])
def test_a_body_slides_over_seams_without_a_hitch(floor: Shape, shape: Shape) -> None:
    """Newton's first law: no force along the floor, no change; nothing is felt at a seam."""
    world, body = on(floor, shape)
    rests = body.y
    while body.x < 15.0:
        assert world.step() == []
        assert body.vx == pytest.approx(4.0, abs=1e-9)
        assert body.y == pytest.approx(rests, abs=1e-4)
        assert body.angle == pytest.approx(0.0, abs=1e-4)


@pytest.mark.parametrize("floor", [ROW, Box(16, 1)])
def test_bodies_made_of_pieces_slide_too(floor: Shape) -> None:
    """The same where the one on top has seams, or both have."""
    world, body = on(floor, Compound([(Box(0.5, 0.2), (0.5 * i, 0)) for i in range(4)]))
    body.position = (1.2, 0.1)
    while body.x < 14.5:
        assert world.step() == []
        assert body.vx == pytest.approx(4.0, abs=1e-5)
        assert body.angle == pytest.approx(0.0, abs=1e-4)


CART = Compound(
    [(Box(0.5, 0.2), (0.5 * i - 3.75, 0.0)) for i in range(16)]
    + [(Box(0.2, 1.0), (-4.1, 0.4)), (Box(0.2, 1.0), (4.1, 0.4))]
)
"""Sixteen planks and two walls, on no wheels at all."""


def loaded(shape: Shape, mass: float, friction: float) -> tuple[World, Body, Body]:
    """A cart of so much mass on a smooth road, and a load of 1 kg that slides along it at 3 m/s."""
    world = World(gravity=(0, -9.81))
    world.add(Wall((-30, 0), (30, 0)), friction=0.0)
    cart = world.add(CART, mass=mass, friction=friction)
    cart.position = (0.0, -min(y for line in cart.outlines for _, y in line))
    load = world.add(shape, mass=1.0, friction=friction, rolling_resistance=friction)
    load.position = (-3.2, 0.2 + height_of(shape))
    load.velocity = (3, 0)
    return world, cart, load


@pytest.mark.parametrize("shape", SLIDERS)
def test_a_load_slides_along_its_cart_and_neither_notices_the_planks(shape: Shape) -> None:
    """Newton's first law on a smooth cart: both keep their speeds from wall to wall."""
    world, cart, load = loaded(shape, 50.0, 0.0)
    while load.x < 3.2:
        assert world.step() == []
        assert load.vx == pytest.approx(3.0, abs=1e-4)
        assert cart.vx == pytest.approx(0.0, abs=1e-5)
        assert load.angle == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize("shape", SLIDERS)
def test_a_load_and_its_rough_cart_end_with_one_velocity(shape: Shape) -> None:
    """Momentum: m v / (m + M), once friction has stopped the sliding and the rolling."""
    world, cart, load = loaded(shape, 5.0, 0.4)
    world.run(240)
    assert load.vx == pytest.approx(0.5, abs=1e-3)
    assert cart.vx == pytest.approx(0.5, abs=1e-3)


@pytest.mark.parametrize("floor", [ROW, COMB])
def test_a_ball_rolls_over_seams_and_keeps_its_speed(floor: Shape) -> None:
    """To 1e-9 from seam to seam, once it rolls."""
    world, ball = on(floor, Circle(0.25), friction=0.5)
    ball.spin = -16.0
    for _ in range(30):
        world.step()
    speed, spin = ball.vx, ball.spin
    while ball.x < 15.0:
        assert world.step() == []
        assert ball.vx == pytest.approx(speed, abs=1e-9)
        assert ball.spin == pytest.approx(spin, abs=1e-8)


def hills() -> Polygon:
    """A strip of land with bends up and down."""
    land = [(x, 0.6 * math.sin(0.9 * x)) for x in range(13)]
    return Polygon.concave([*land, (12, -2), (0, -2)])


@pytest.mark.parametrize("shape", SLIDERS)
@pytest.mark.parametrize("angle", [0.0, 0.4])
@pytest.mark.parametrize("speed", [3.0, 1000.0])
def test_what_is_made_of_pieces_is_solid(shape: Shape, angle: float, speed: float) -> None:
    """Elastic bodies fall on all places of a hilly land: none comes through, no energy is lost."""
    world = World()
    land = world.add(hills(), kind="static")
    outline = [(p.x, p.y) for p in land.vertices]
    dice = random.Random(1)
    bodies = [
        world.add(
            shape, position=(x + dice.uniform(-0.2, 0.2), 2.5), velocity=(0, -speed), angle=angle,
            restitution=1, category=2, mask=1,
        )
        for x in range(-5, 6)
    ]  # fmt: skip
    energy = world.kinetic_energy
    for _ in range(round(3 / speed * 60) + 1):
        world.step()
    for body in bodies:
        assert not inside(outline, body.position)
    assert sum(body.vy > 0 for body in bodies) > 4
    assert world.kinetic_energy == pytest.approx(energy, rel=1e-9)


def inside(outline: list[tuple[float, float]], at: tuple[float, float]) -> bool:
    """Whether a point is in a polygon: a ray then crosses the outline an odd number of times."""
    odd = False
    for i, (x, y) in enumerate(outline):
        u, v = outline[i - 1]
        if (y > at[1]) != (v > at[1]) and at[0] < x + (at[1] - y) * (u - x) / (v - y):
            odd = not odd
    return odd


@pytest.mark.parametrize("shape", SLIDERS)
def test_land_of_pieces_brakes_and_holds_like_one(shape: Shape) -> None:
    """What slides down into a valley of pieces comes to rest on top of it."""
    world = World(gravity=(0, -9.81))
    land = world.add(hills(), kind="static", friction=0.4)
    outline = [(p.x, p.y) for p in land.vertices]
    body = world.add(shape, position=(-2.2, 2.4), friction=0.4, rolling_resistance=0.05)
    for _ in range(360):
        world.step()
        assert not inside(outline, body.position)
    assert body.speed < 0.05


def test_an_outer_edge_is_an_edge() -> None:
    """A side that is partly covered stops what comes against the rest of it: m v (1 + e)."""
    world = World()
    step = Compound([(Box(2, 2), (0, 0)), (Box(2, 1), (2, -0.5))])
    base = world.add(step, kind="static")
    ball = world.add(
        Box(0.4, 0.4), position=(base.x + 1.5, base.y + 0.9), velocity=(-3, 0), restitution=1
    )
    hits = [hit for _ in range(60) for hit in world.step()]
    assert [hit.impulse.x for hit in hits] == pytest.approx([6.0])
    assert ball.vx == pytest.approx(3.0)


def test_pieces_keep_their_seams_in_saved_worlds() -> None:
    world, _ = on(ROW, SLIDERS[0])
    again = World.from_dict(world.to_dict())
    for each in (world, again):
        each.run(60)
    assert world.digest() == again.digest()
    assert list(again.tables.pieces.seams[:3]) == [1, 1, 1]
