"""What was drummed on once is struck again: old blows do not count.

Blows to and fro between what is wedged take ever so many to come to an end, so after eight on end a
pair that rests is left to the sweeps of the next part of the tick. The eight were never forgotten:
whatever hit the heap later, even after minutes of rest, was not handed on at its instant, and went
into it as far as it moves within a part.
"""

import pytest

from engine import Box, Circle, Wall, World


def test_a_shot_at_what_was_drummed_on_long_ago_goes_no_deeper() -> None:
    """It is the same as at what was never struck, to the last bit."""
    digests = []
    for blows in (0, 8):
        world = World(gravity=(0, -9.81))
        world.add(Wall((-5, 0), (5, 0)))
        boxes = [
            world.add(Box(1 - 0.2 * i, 0.4), mass=2, position=(0, 0.2 + 0.4 * i)) for i in (0, 1)
        ]
        world.run(2)
        for pair in range(world.tables.counts.pairs[0]):
            world.tables.pairs.bounces[pair] = blows
        world.run(118)
        world.add(Circle(0.1), mass=3, position=(0.05, 3.0), velocity=(0, -60))
        for _ in range(12):
            world.step()
            for box in boxes:
                assert min(y for line in box.outlines for _, y in line) > -0.003
        digests.append(world.digest())
    assert digests[0] == digests[1]


@pytest.mark.parametrize("speed", [20.0, 60.0])
def test_a_blow_goes_through_a_column_at_once(speed: float) -> None:
    """Five boxes of one mass that touch, frictionless and elastic: the last leaves with the speed
    of the ball of that mass that hits the first (Newton's cradle).
    """
    world = World()
    boxes = [
        world.add(Box(0.4, 0.4), mass=1, position=(0.4 * i, 0), restitution=1) for i in range(5)
    ]
    world.add(Circle(0.2), mass=1, position=(-0.5, 0), velocity=(speed, 0), restitution=1)
    world.run(10)
    assert [box.vx for box in boxes] == pytest.approx([0, 0, 0, 0, speed], abs=1e-9 * speed)
