"""Chains of walls: inside, they are as smooth as one wall; at their corners they are solid."""

import math

import pytest

from engine import Body, Box, Capsule, Chain, Circle, Compound, Polygon, Shape, Wall, World

SLIDERS: list[Shape] = [
    Box(1.0, 0.5),
    Box(0.6, 0.3, rounding=0.1),
    Capsule(0.8, 0.25),
    Polygon.regular(6, 0.25 / math.cos(math.pi / 6)),
    Circle(0.25),
]


def on_floor(shape: Shape, chain: Chain | Wall, friction: float = 0.0) -> tuple[World, Body]:
    world = World(gravity=(0, -9.81))
    world.add(chain, friction=friction)
    return world, world.add(shape, position=(0.3, 0.25), velocity=(4, 0), friction=friction)


@pytest.mark.parametrize("link", [1.0, 0.3])
@pytest.mark.parametrize("shape", SLIDERS)
def test_a_body_slides_over_twenty_walls_without_a_hitch(shape: Shape, link: float) -> None:
    """Newton's first law: no force along the floor, no change; and no hit is felt at a joint."""
    walls = Chain([(i * link - 1.0, 0.0) for i in range(21)])
    world, body = on_floor(shape, walls)
    while body.x < 20 * link - 2.0:
        assert world.step() == []
        assert body.vx == pytest.approx(4.0, abs=1e-9)
        assert body.y == pytest.approx(0.25, abs=5e-5)
        assert body.angle == pytest.approx(0.0, abs=1e-4)


@pytest.mark.parametrize("shape", SLIDERS[:3])
def test_a_chain_brakes_like_one_wall(shape: Shape) -> None:
    """Coulomb: v^2 / (2 mu g)."""
    ways = []
    for floor in (Chain([(i * 0.4 - 1.0, 0.0) for i in range(21)]), Wall((-1, 0), (7, 0))):
        world, body = on_floor(shape, floor, friction=0.5)
        for _ in range(90):
            world.step()
        ways.append(body.x - 0.3)
    assert ways[0] == pytest.approx(ways[1], rel=2e-4)
    assert ways[0] == pytest.approx(16 / (2 * 0.5 * 9.81), rel=1e-3)


def test_a_ball_rolls_over_joints_as_over_one_wall() -> None:
    world, ball = on_floor(Circle(0.25), Chain([(i - 1.0, 0.0) for i in range(21)]), friction=0.5)
    ball.spin = -4 / 0.25
    for _ in range(200):
        assert world.step() == []
    assert ball.vx == pytest.approx(4.0, rel=1e-4)
    assert ball.spin == pytest.approx(-ball.vx / 0.25, rel=1e-4)


@pytest.mark.parametrize("shape", SLIDERS)
def test_an_incline_of_walls_is_an_incline(shape: Shape) -> None:
    """a = g sin(theta), whatever the joints."""
    theta = 0.3
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    down = (math.cos(theta), -math.sin(theta))
    world.add(Chain([((i - 2) * 0.7 * down[0], (i - 2) * 0.7 * down[1]) for i in range(40)]))
    up = (0.25 * math.sin(theta), 0.25 * math.cos(theta))
    body = world.add(shape, position=up, angle=-theta)
    for _ in range(120):
        world.step()
    assert body.speed == pytest.approx(9.81 * math.sin(theta) * 2.0, rel=1e-6)


@pytest.mark.parametrize("shape", SLIDERS)
@pytest.mark.parametrize("speed", [3.0, 30.0, 300.0])
def test_a_concave_corner_stops(shape: Shape, speed: float) -> None:
    """Plastic: what comes along the floor stays at the wall, at once."""
    world = World(gravity=(0, -9.81))
    world.add(Chain([(-9, 0), (0, 0), (3, 0), (3, 9)]))
    body = world.add(shape, position=(0, 0.25), velocity=(speed, 0))
    hits = []
    while not hits and world.tick < 120:
        hits = world.step()
    assert hits[0].normal == pytest.approx((-1, 0), abs=1e-6)
    for _ in range(60):
        world.step()
        assert max(x for line in body.outlines for x, _ in line) < 3.0 + 2e-3


@pytest.mark.parametrize("shape", SLIDERS)
def test_the_edge_of_a_table_is_not_hit_from_within(shape: Shape) -> None:
    """What slides off a table sinks in a little as it rests; the side of the table lets it go."""
    world = World(gravity=(0, -9.81))
    world.add(Chain([(-2, 0), (2, 0), (2, -3)]))
    body = world.add(shape, position=(0.3, 0.25), velocity=(4, 0))
    while body.x < 1.9:
        world.step()
    assert body.vx == pytest.approx(4.0, abs=1e-5)
    for _ in range(20):
        world.step()
    assert body.vx > 3.9


@pytest.mark.parametrize("shape", SLIDERS)
@pytest.mark.parametrize("angle", [0.0, 0.4])
@pytest.mark.parametrize("speed", [2.0, 1000.0])
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_chains_are_solid_from_both_sides_at_joints_too(
    shape: Shape, angle: float, speed: float, side: float
) -> None:
    world = World()
    world.add(Chain([(-4, 1), (-2, -1), (0, 0), (2, -1), (4, 1)]))
    bodies = [
        world.add(
            shape,
            position=(x, 3 * side),
            velocity=(0, -side * speed),
            angle=angle,
            restitution=1,
            category=2,
            mask=1,
        )
        for x in (-3.1, -2.0, -0.9, 0.0, 1.4, 2.0)
    ]
    energy = world.kinetic_energy
    for _ in range(round(3 / speed * 60) + 1):
        world.step()
    for body in bodies:
        across = abs(body.x)
        height = across - 3.0 if across > 2.0 else -across / 2.0
        assert across > 4.0 or (body.y - height) * side > 0.2
    assert world.kinetic_energy == pytest.approx(energy, rel=1e-9)


def test_a_loop_holds_what_is_inside() -> None:
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    ring = [(3 * math.cos(i * math.tau / 24), 3 * math.sin(i * math.tau / 24)) for i in range(24)]
    world.add(Chain(ring, loop=True), restitution=1.0)
    places = [(0, -1.5), (-1.2, 0.3), (0.6, 0.3), (-0.5, 1.6), (1, 1.7)]
    bodies = [
        world.add(shape, position=at, velocity=(7, 3 + at[0]), restitution=1)
        for shape, at in zip(SLIDERS, places, strict=True)
    ]
    energy = world.kinetic_energy + world.potential_energy
    for _ in range(300):
        world.step()
    assert all(math.dist(body.position, (0, 0)) < 3.0 for body in bodies)
    assert world.kinetic_energy + world.potential_energy == pytest.approx(energy, rel=1e-9)


@pytest.mark.parametrize("shape", SLIDERS)
def test_a_one_sided_chain_lets_in_and_not_out(shape: Shape) -> None:
    """Left of its way is its positive side."""
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    world.add(Chain([(-5, 0.5), (-1, 0), (0, 0), (1, 0), (5, 0.5)], one_sided=True))
    body = world.add(shape, position=(0.1, -2), velocity=(0.3, 9.5), restitution=0.3)
    while body.y < 1:
        assert world.step() == []
    for _ in range(300):
        world.step()
    assert body.y > 0.2


@pytest.mark.parametrize(
    "shape",
    [
        Compound([(Circle(0.2), (0, -0.8)), (Circle(0.2), (0, 0.8)), (Box(0.1, 1.6), (0, 0))]),
        Polygon([(-0.5, -0.6), (0.5, -0.6), (0.1, 0.6)]),
        Box(0.3, 1.4),
    ],
)
@pytest.mark.parametrize("drift", [-0.6, 0.45, 1.0])
@pytest.mark.parametrize("link", [0.37, 8.0])
def test_what_comes_from_behind_a_one_sided_chain_feels_nothing(
    shape: Shape, drift: float, link: float
) -> None:
    """Newton's first law, for every piece of a body and over every joint of the chain."""
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    half = math.ceil(4 / link)
    world.add(Chain([(i * link + 0.1, 0) for i in range(-half, half + 1)], one_sided=True))
    body = world.add(
        shape, position=(0, -2), velocity=(drift, 8.0), spin=0.3, friction=0.5, restitution=0.5
    )
    for tick in range(1, 49):  # until its lowest point is above the chain
        assert world.step() == []
        at = tick / 60
        assert body.position == pytest.approx(
            (drift * at, -2 + 8 * at - 9.81 * at**2 / 2), abs=1e-12
        )
        assert body.spin == 0.3


@pytest.mark.parametrize(
    ("link", "drift", "rise", "angle"),
    [
        (0.37, -0.35, 0.5, 2.9),
        (1.5, 0.25, 0.4, -0.9),
        (0.8, -0.25, 0.8, 1.0),
        (1.5, 0.28, 0.7, -1.3),
    ],
)
@pytest.mark.parametrize("low", [-0.2, -0.6])
def test_what_drifts_through_a_one_sided_chain_passes_its_joints(
    link: float, drift: float, rise: float, angle: float, low: float
) -> None:
    """Newton's first law, while its tail comes through one link and its flank through the next."""
    world = World()
    half = math.ceil(6 / link)
    world.add(Chain([(i * link + 0.1, 0) for i in range(-half, half + 1)], one_sided=True))
    body = world.add(
        Polygon([(-0.8, low), (0.8, low), (0.1, 0.6)]), position=(0, -1.2), angle=angle,
        velocity=(drift, rise),
    )  # fmt: skip
    for _ in range(math.ceil(144 / rise)):
        assert world.step() == []
        assert body.velocity == (drift, rise)
