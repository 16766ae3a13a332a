"""The books of random worlds of all shapes and joints: whatever happens, they close.

Where a light joined body bore a heavy one, friction was bounded by what had pressed before the last
solution. What no longer pressed at all kept some: it was not given again in the next part, but
taken back there, and up to 5e-4 of the energy was nobody's. What a round piece of an immovable body
gives about the origin was not corrected where parts of a tick ended early.
"""

import random
from typing import Any

import pytest

from engine import (
    Body,
    Box,
    Capsule,
    Chain,
    Circle,
    Compound,
    Distance,
    Ledger,
    Pin,
    Polygon,
    Rope,
    Slider,
    Spring,
    Weld,
    World,
)

L_SHAPE = [(0, 0), (1, 0), (1, 0.3), (0.3, 0.3), (0.3, 1), (0, 1)]


def throw_in(world: World, dice: random.Random) -> Body:
    """Add a body of a random shape and material, somewhere in the room."""
    shapes = [
        Box(dice.uniform(0.2, 1), dice.uniform(0.2, 1)),
        Circle(0.3),
        Capsule(0.5, 0.2),
        Polygon.regular(5, 0.4),
        Polygon.concave(L_SHAPE),
        Compound([Circle(0.2), Box(0.2, 0.8)]),
    ]
    fixed = dice.random() < 0.15
    return world.add(
        dice.choice(shapes),
        kind="static" if fixed else None,
        mass=None if fixed else dice.choice([0.1, 1, 20]),
        position=(dice.uniform(-3, 3), dice.uniform(0.5, 7)),
        angle=dice.uniform(-3, 3),
        velocity=None if fixed else (dice.uniform(-5, 5), 0),
        friction=dice.random(),
        static_friction=dice.choice([None, 2.0]),
        rolling_resistance=dice.choice([0.0, 0.05]),
        restitution=dice.choice([0, 0, 0.5]),
    )


def join_some(world: World, bodies: list[Body], dice: random.Random) -> None:
    """Join up to six pairs, where one of the two is."""
    for _ in range(dice.randint(1, 6)):
        a, b = dice.sample([*bodies, None], 2)
        if not any(body is not None and body.is_dynamic for body in (a, b)):
            continue
        near = a or b or bodies[0]
        at = (near.x + dice.uniform(-0.3, 0.3), near.y + dice.uniform(-0.3, 0.3))
        nail = (0, 6) if a is None else a.position
        kinds: list[Any] = [
            Pin(at=at),
            Pin(at=at, limits=(-0.5, 0.5), motor_speed=1, max_torque=20),
            Weld(at=at),
            Slider(axis=(1, 0.3), at=at),
            Distance(anchor_a=nail, anchor_b=at),
            Rope(anchor_a=nail, anchor_b=at),
            Spring(50, 2, anchor_a=nail, anchor_b=at),
        ]
        world.join(a, b, dice.choice(kinds))


def throughput(books: Ledger) -> float:
    """Of energy (J)."""
    return 1.0 + books.kinetic + abs(books.work.total) + abs(books.dissipated.total)


@pytest.mark.parametrize("seed", range(80))
def test_the_books_of_a_jumble_close(seed: int) -> None:
    dice = random.Random(seed)
    world = World(gravity=(0, -9.81), kernels="compiled", sleeping=dice.random() < 0.3)
    world.add(
        Chain([(-4, 8), (-4, 0), (4, 0), (4, 8)]),
        friction=dice.random(),
        restitution=dice.random() / 2,
    )
    join_some(world, [throw_in(world, dice) for _ in range(dice.randint(5, 14))], dice)
    for _ in range(4):
        world.run(60)
        books = world.ledger()
        most = 1e-9 * throughput(books)
        assert abs(books.energy_error) < most
        assert max(abs(lacking) for lacking in books.momentum_error) < most
        assert abs(books.angular_momentum_error) < most
