"""Which bodies contacts fix to the ground: those that cannot move, and no others."""

import math

import pytest

from engine import Body, Circle, Force, Polygon, Wall, World
from engine.kernels.sticking import FIXED

G = 9.81


def flat(friction: float = 0.5) -> World:
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-20, 0), (20, 0)), friction=friction)
    return world


def box(world: World, x: float, y: float, friction: float = 0.5) -> Body:
    return world.add(Polygon.box(1, 1), position=(x, y), friction=friction)


def is_fixed(body: Body) -> bool:
    store = body._world.store
    return store.tables.bodies.stuck[store.rows[body.id]] == FIXED


def rest(world: World, ticks: int = 120) -> None:
    for _ in range(ticks):
        world.step()


def test_what_stands_on_the_ground_does_not_move_at_all() -> None:
    """Newton's first law, to the last bit."""
    world = flat()
    boxes = [box(world, 0, i + 0.5) for i in range(3)]
    rest(world, 240)
    places = [(*body.position, body.angle) for body in boxes]
    rest(world, 600)
    assert all(is_fixed(body) for body in boxes)
    assert [(*body.position, body.angle) for body in boxes] == places
    assert all(body.velocity == (0, 0) and body.spin == 0 for body in boxes)
    assert world.kinetic_energy == 0


@pytest.mark.parametrize("speed", [1e-6, 1e-4, 1e-2])
def test_a_disc_that_rolls_slowly_rolls_on(speed: float) -> None:
    """One pin lets it roll: v = omega r stays as it is, however slow."""
    world = flat()
    disc = world.add(Circle(0.5), position=(0, 0.5), friction=0.5)
    disc.velocity = (speed, 0)
    disc.spin = -speed / 0.5
    box(world, 3, 0.5)
    rest(world, 300)
    assert not is_fixed(disc)
    assert disc.vx == pytest.approx(speed, rel=1e-5)
    assert disc.x == pytest.approx(5 * speed, rel=1e-5)


@pytest.mark.parametrize("speed", [1e-6, 1e-4])
def test_what_glides_without_friction_glides_on(speed: float) -> None:
    world = flat(0.0)
    body = box(world, 0, 0.5, 0.0)
    rest(world)
    body.velocity = (speed, 0)
    start = body.x
    rest(world, 300)
    assert not is_fixed(body)
    assert body.vx == pytest.approx(speed, rel=1e-9)
    assert body.x - start == pytest.approx(5 * speed, rel=1e-6)


@pytest.mark.parametrize("steeper", [0.998, 1.002])
def test_what_was_at_rest_slides_if_forces_exceed_friction_a_little(steeper: float) -> None:
    """Coulomb: it stays below tan a = mu, and above slides by a = g (sin a - mu cos a)."""
    angle = math.atan(0.5 * steeper)
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-20, 0), (60, 0)), friction=0.5)
    body = box(world, 0, 0.5)
    rest(world)
    world.gravity = (G * math.sin(angle), -G * math.cos(angle))
    rest(world, 300)
    if steeper < 1:
        assert is_fixed(body)
    else:
        a = G * (math.sin(angle) - 0.5 * math.cos(angle))
        assert body.vx == pytest.approx(5 * a, rel=0.01)


def test_a_disc_in_a_groove_is_fixed_by_its_two_pins() -> None:
    world = World(gravity=(0, -G))
    world.add(Wall((-2, 2), (0, 0)), friction=0.9)
    world.add(Wall((0, 0), (2, 2)), friction=0.9)
    disc = world.add(Circle(0.3), position=(0, 0.3 * math.sqrt(2)), friction=0.9)
    rest(world)
    assert is_fixed(disc)


def test_two_boards_that_lean_against_each_other_are_a_triangle() -> None:
    """A house of cards: a pin each on the ground, one between them."""
    world = flat(0.9)
    half, lean = 0.6, 0.3
    reach = half * math.sin(lean) + 0.05 * math.cos(lean)
    rise = half * math.cos(lean) + 0.05 * math.sin(lean)
    boards = [
        world.add(
            Polygon.box(0.1, 2 * half),
            position=(-side * reach, rise),
            angle=-side * lean,
            friction=0.9,
        )
        for side in (1, -1)
    ]
    rest(world, 300)
    assert all(is_fixed(board) for board in boards)
    assert all(board.velocity == (0, 0) for board in boards)
    assert boards[0].angle == pytest.approx(-lean, abs=1e-2)


def test_bodies_that_float_stick_to_nothing() -> None:
    """Pressed together and drifting, they drift on (no ground, no fixing)."""
    world = World()
    left, right = box(world, 0, 0), box(world, 1, 0)
    left.exert(Force(3, 0))
    right.exert(Force(-3, 0))
    for body in (left, right):
        body.velocity = (0, 1e-4)
    rest(world, 300)
    assert not is_fixed(left)
    assert left.vy == pytest.approx(1e-4, rel=1e-9)


def test_what_pushes_too_hard_moves_a_fixed_body_in_the_same_tick() -> None:
    """F > mu m g gives a = F / m - mu g, with no delay."""
    world = flat(0.5)
    body = box(world, 0, 0.5)
    rest(world)
    assert is_fixed(body)
    body.exert(Force(2 * G, 0))
    rest(world, 60)
    assert body.vx == pytest.approx(2 * G - 0.5 * G, rel=1e-3)


def test_a_change_of_friction_is_felt_in_the_same_tick() -> None:
    """On a slope of 20 degrees: held by mu = 0.5, let go by mu = 0.1 with a = g (sin - mu cos)."""
    angle = math.radians(20)
    world = World(gravity=(G * math.sin(angle), -G * math.cos(angle)), integrator="velocity-verlet")
    ground = world.add(Wall((-20, 0), (60, 0)), friction=0.5)
    body = box(world, 0, 0.5)
    rest(world)
    assert is_fixed(body)
    body.friction = ground.friction = 0.1
    rest(world, 60)
    assert body.vx == pytest.approx(G * (math.sin(angle) - 0.1 * math.cos(angle)), rel=1e-3)


def test_a_box_taken_away_lets_those_above_fall() -> None:
    world = flat()
    boxes = [box(world, 0, i + 0.5) for i in range(3)]
    rest(world)
    world.remove(boxes[0])
    top = boxes[2].y
    rest(world, 12)
    assert top - boxes[2].y == pytest.approx(G * 0.2**2 / 2, rel=0.02)


def test_a_pyramid_halts_and_its_books_close() -> None:
    world = flat(0.6)
    for row in range(5):
        for i in range(5 - row):
            box(world, 1.05 * (i - (5 - row) / 2), row + 0.5, 0.6)
    rest(world, 300)
    assert world.kinetic_energy == 0
    book = world.ledger()
    assert abs(book.energy_error) < 1e-9
