"""Two bodies that are joined twice: equations that say the same but for rounding are left out.

A pin and a slider at one place agree on two directions, or all but do so where they turn. What was
left of a pivot, a hundred thousand millionth of its equation, was divided by: impulses of 1e11 N s
held each other in balance, and the next part of the tick began with them. Bodies got 6e8 m/s, lost
them again, and the rounding of that was more than all the energy that there was.
"""

import random

import pytest

from engine import Box, Distance, Pin, Rope, Slider, Weld, World


def joined_twice(seed: int) -> World:
    """Two boxes, turned and moving, with two joints between them, the second perhaps added later;
    perhaps on a rope.
    """
    dice = random.Random(seed)
    integrator = dice.choice(["velocity-verlet", "rk4"])
    world = World(gravity=(2, -9), integrator=integrator, kernels="interpreted")
    heavy, angle, spin = dice.choice([1, 20]), dice.uniform(-3, 3), dice.uniform(-3, 3)
    a = world.add(Box(1, 0.5), mass=heavy, angle=angle, spin=spin)
    at, vx = (dice.uniform(-1, 1), dice.uniform(-1, 1)), dice.uniform(-2, 2)
    b = world.add(Box(0.6, 0.4), position=at, velocity=(vx, 0), spin=dice.uniform(-3, 3))
    for count in (5, 3):
        middle = ((a.x + b.x) / 2, (a.y + b.y) / 2)
        ends = {"anchor_a": a.position, "anchor_b": b.position}
        slider = Slider(at=middle, axis=(1, 0.3))
        kinds = [Pin(at=middle), slider, Weld(at=middle), Distance(**ends), Rope(**ends)]
        world.join(a, b, dice.choice(kinds[:count]))
        if count == 5 and dice.random() < 0.5:
            world.run(2)
    if dice.random() < 0.5:
        world.join(None, b, Rope(anchor_a=(0, 2), anchor_b=b.position))
    return world


@pytest.mark.parametrize("seed", [23, 46, 50, 73, 82])
def test_the_books_close(seed: int) -> None:
    world = joined_twice(seed)
    for _ in range(40):
        world.step()
        books = world.ledger()
        through = 1.0 + sum(abs(work) for work in books.work)
        assert abs(books.energy_error) < 1e-10 * through
