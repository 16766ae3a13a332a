"""Groups of joined bodies that touch each other, and sweeps that each of them has for itself."""

from engine import Box, Pin, Wall, World
from engine.linkage.limb_groups import NONE, group_at, sort_pairs
from engine.linkage.limb_sweeps import find_even


def pair_of_boxes(world: World, x: float, y: float) -> None:
    """Two boxes of 1 m x 0.4 m, hinged end to end."""
    boxes = [world.add(Box(1, 0.4), mass=1, position=(x + side, y)) for side in (-0.5, 0.5)]
    world.join(*boxes, Pin(at=(x, y)))


def lying() -> World:
    """Two pairs one on the other, one by itself, one in the air; and a box that nothing joins."""
    world = World(gravity=(0, -9.81))
    world.add(Wall((-20, 0), (20, 0)))
    pair_of_boxes(world, 0, 0.2)
    pair_of_boxes(world, 0.3, 0.6)
    pair_of_boxes(world, 6, 0.2)
    pair_of_boxes(world, 12, 8)
    world.add(Box(1, 1), mass=1, position=(-5, 0.5))
    for _ in range(10):
        world.step()
    return world


def test_what_touches_is_a_group_and_the_ground_joins_none() -> None:
    world = lying()
    t = world.tables
    resting = [pair for pair in range(t.counts.pairs[0]) if t.pairs.state[pair] == 1]
    for k, pair in enumerate(resting):
        t.pairs.resting[k] = pair
    sort_pairs(t, len(resting))
    assert [t.trees.group[tree] for tree in range(5)] == [0, 0, 2, 3, 4]
    assert [group_at(t, row) for row in range(10)] == [NONE, 0, 0, 0, 0, 2, 2, 3, 3, 4]
    assert (t.trees.next[0], t.trees.next[1]) == (1, NONE)
    listed = [t.pairs.grouped[k] for k in range(len(resting))]
    assert sorted(listed) == resting
    groups = [group_at(t, t.pairs.b[pair]) for pair in listed]
    assert groups == sorted(groups)
    for group in set(groups):
        members = [pair for pair in listed if group_at(t, t.pairs.b[pair]) == group]
        assert members == sorted(members)
        assert t.trees.pairs[group] == len(members)


def test_hinges_act_evenly_where_contacts_act_on_their_tree() -> None:
    world = lying()
    assert find_even(world.tables) == 3
    assert [world.tables.trees.evenly[tree] for tree in range(4)] == [1, 1, 1, 0]


def test_a_group_does_not_feel_that_others_are_there() -> None:
    """The boxes that lie apart move, bit for bit, as if they were alone with the ground."""
    together = lying()
    alone = World(gravity=(0, -9.81))
    alone.add(Wall((-20, 0), (20, 0)))
    pair_of_boxes(alone, 6, 0.2)
    for _ in range(10):
        alone.step()
    for body, other in zip(list(alone)[1:], list(together)[5:7], strict=True):
        assert (*body.position, body.angle) == (*other.position, other.angle)
