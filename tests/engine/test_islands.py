"""Islands that rest take a tick at once, while others take it in parts."""

import numpy as np
import pytest

from engine import Body, Circle, Pin, Polygon, Wall, World
from engine.kernels import travel

G = 9.81
DT = 1 / 60


def two_places(restless: bool = False) -> tuple[World, list[Body], Body]:
    """A stack of three boxes, and far away a box that slides ever on, if asked for."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-99, 0), (999, 0)), friction=0.5)
    stack = [world.add(Polygon.box(1, 1), position=(0, 0.5 + i), friction=0.5) for i in range(3)]
    away = (20, 0.5) if restless else (900, 50)
    glider = world.add(
        Polygon.box(1, 1), position=away, velocity=(9 if restless else 0, 0), friction=0.0
    )
    return world, stack, glider


def steady_pairs(world: World) -> int:
    """How many contacts bear their loads for whole ticks."""
    tables = world.store.tables
    used = world.store.tables.counts.pairs[0]
    return int(np.sum(np.asarray(tables.pairs.steady)[:used]))


def test_what_moves_elsewhere_does_not_keep_a_stack_from_being_steady() -> None:
    world, stack, glider = two_places(restless=True)
    world.join(None, world.add(Circle(0.2), position=(50, 5)), Pin(at=(48, 5)))
    for _ in range(120):
        world.step(DT)
    assert steady_pairs(world) == 3
    assert all(box.speed == 0.0 and box.spin == 0.0 for box in stack)
    assert glider.vx == pytest.approx(9.0, abs=1e-12)


def test_what_hits_a_waiting_stack_hits_it_at_the_same_instant_whatever_moves_elsewhere() -> None:
    ways = []
    for restless in (False, True):
        world, stack, _ = two_places(restless)
        for _ in range(60):
            world.step(DT)
        assert steady_pairs(world) == 3
        world.add(Circle(0.2), mass=1.0, position=(-3, 2.5), velocity=(15, 0), restitution=0.3)
        way = []
        for _ in range(90):
            world.step(DT)
            way += [box.x for box in stack]
        ways.append(way)
    assert max(abs(a - b) for a, b in zip(*ways, strict=True)) < 1e-3
    assert max(abs(x) for x in ways[0]) > 0.01


def test_books_close_and_contacts_give_what_bodies_gain_while_some_wait() -> None:
    world, stack, _ = two_places(restless=True)
    for i in range(4):
        world.add(
            Circle(0.3), mass=2.0, position=(-6 - 4 * i, 1.5), velocity=(7, 3), restitution=0.4
        )
    bodies = [body for body in world if body.is_dynamic]
    for _ in range(200):
        before = {body: body.momentum for body in bodies}
        world.step(DT)
        given = {body: [body.force.x * DT, body.force.y * DT] for body in world}
        for contact in world.contacts:
            for body, sign in ((contact.a, -1), (contact.b, 1)):
                given[body][0] += sign * contact.impulse.x
                given[body][1] += sign * contact.impulse.y
        for body in bodies:
            assert given[body][0] == pytest.approx(body.momentum.x - before[body].x, abs=1e-9)
            assert given[body][1] == pytest.approx(body.momentum.y - before[body].y, abs=1e-9)
    books = world.ledger()
    assert books.energy_error == pytest.approx(0.0, abs=1e-9)
    assert books.momentum_error == pytest.approx((0.0, 0.0), abs=1e-9)
    assert any(box.x != 0.0 for box in stack)


def test_a_waiting_world_continues_from_a_snapshot_bit_for_bit() -> None:
    world, _, _ = two_places(restless=True)
    for _ in range(100):
        world.step(DT)
    saved = world.snapshot()
    other = World.from_dict(world.to_dict())
    digests = []
    for each in (world, world, other):
        if each is world:
            world.restore(saved)
        for _ in range(50):
            each.step(DT)
        digests.append(each.digest())
    assert digests[0] == digests[1] == digests[2]


def test_hinged_bodies_that_wait_continue_from_a_snapshot_bit_for_bit() -> None:
    """Their first tick needs masses that no part has gathered yet."""
    world, _, _ = two_places(restless=True)
    rods = [world.add(Polygon.box(1, 0.2), position=(-5 + i, 0.1), friction=0.5) for i in range(3)]
    for i in range(2):
        world.join(rods[i], rods[i + 1], Pin(at=(-4.5 + i, 0.1)))
    for _ in range(120):
        world.step(DT)
    assert steady_pairs(world) == 6
    other = World.from_dict(world.to_dict())
    for _ in range(30):
        world.step(DT)
        other.step(DT)
        assert other.digest() == world.digest()


def test_a_body_that_is_taken_from_under_a_stack_lets_it_fall() -> None:
    world, stack, _ = two_places(restless=True)
    for _ in range(60):
        world.step(DT)
    world.remove(stack[0])
    for _ in range(60):
        world.step(DT)
    assert stack[1].y == pytest.approx(0.5, abs=5e-3)


def test_the_tick_is_taken_at_once_where_all_rests(monkeypatch: pytest.MonkeyPatch) -> None:
    """While the stack waits alone, the rest of the world flies through a single part."""
    world, _, _ = two_places()
    for _ in range(60):
        world.step(DT)
    parts: list[int] = []
    settle = travel.settle

    def counted(*given: object) -> int:
        parts.append(1)
        return settle(*given)  # type: ignore[arg-type]

    monkeypatch.setattr(travel, "settle", counted)
    world.step(DT)
    assert len(parts) == 2  # as the tick begins, and in its only part


@pytest.mark.parametrize("height", [8.0, 8.1, 8.4])
def test_what_waits_hands_a_blow_on_to_the_floor_at_once(height: float) -> None:
    """A plastic blow on a disc at rest: it sank by a fifth of its radius, and the books broke."""
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-9, 0), (9, 0)))
    lying = world.add(Circle(0.5), position=(0, 0.5))
    world.add(Circle(0.5), position=(0, height))
    deepest = 0.0
    for _ in range(100):
        world.step(DT)
        deepest = min(deepest, lying.y - 0.5)
    assert world.kinetic_energy < 0.01
    assert deepest > -1e-3
    assert world.ledger().energy_error == pytest.approx(0.0, abs=1e-10)
