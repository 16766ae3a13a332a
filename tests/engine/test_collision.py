"""What a step returns: as a list, whenever it is read."""

import pytest

from engine import Circle, Collision, World
from engine.collision import FEW, Collisions


def pairs_that_meet(count: int) -> World:
    """So many pairs of discs, each of which meets head on in the first tick."""
    world = World(gravity=(0, 0))
    for k in range(count):
        for side in (-1.0, 1.0):
            place = {"position": (side * 0.505, 3.0 * k), "velocity": (-side, 0.0)}
            world.add(Circle(0.5), mass=1.0 + k, restitution=1.0, **place)
    return world


@pytest.mark.parametrize("count", [0, 1, FEW, FEW + 1, 40])
def test_it_reads_like_a_list(count: int) -> None:
    """Length, truth, places, slices and sums are those of a list of the same."""
    found = pairs_that_meet(count).step()
    same = list(found)
    assert len(found) == count == len(same)
    assert bool(found) == bool(count)
    assert found == same
    assert same == found
    assert found != [*same, 1]
    assert found[1:] == same[1:]
    assert found + same == same + same
    assert same + found == same + same
    assert repr(found) == repr(same)
    assert all(isinstance(each, Collision) for each in found)
    assert isinstance(found, Collisions)


@pytest.mark.parametrize("count", [FEW, 40])
def test_it_can_be_read_late(count: int) -> None:
    """What happened later, and who has gone since, changes nothing in it."""
    world, other = pairs_that_meet(count), pairs_that_meet(count)
    late, early = world.step(), other.step()
    told = [(hit.a.id, hit.b.id, *hit[2:]) for hit in early]
    world.remove(world.body(2))
    for _ in range(20):
        world.step()
    assert [(hit.a.id, hit.b.id, *hit[2:]) for hit in late] == told
    assert [hit.impulse.x for hit in late] == pytest.approx([2.0 * (1.0 + k) for k in range(count)])


def test_two_steps_compare() -> None:
    """Those of two steps are the same if all in them is, but to nothing else."""
    world = pairs_that_meet(1)
    first, second = world.step(), world.step()
    assert first != second
    assert second == world.step()
    assert first != 1
    with pytest.raises(TypeError):
        hash(first)
