"""Loads from the top down: what is tried, what stands, and what is left as it was."""

import math
from collections.abc import Callable

import pytest

from engine import Body, Box, Chain, Circle, Compound, Force, Particle, Pin, Wall, World
from engine.kernels import islands

G = 9.81
DT = 1 / 60


def flat(friction: float = 0.5) -> World:
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-50, 0), (50, 0)), friction=friction)
    return world


def box(world: World, x: float, y: float, **more: object) -> Body:
    return world.add(Box(1, 1), position=(x, y), **{"friction": 0.5, **more})  # type: ignore[arg-type]


def steady_pairs(world: World) -> int:
    pairs = world.store.tables.pairs
    used = world.store.tables.counts.pairs[0]
    return sum(pairs.steady[i] for i in range(used) if pairs.state[i] == 1)


def test_what_stands_bears_other_forces_at_once() -> None:
    """Gravity that turns, a push, a body that is taken away: rigid bodies do not spring back."""
    world = flat()
    boxes = [box(world, 0, i + 0.5) for i in range(5)]
    world.run(20)
    at_rest = world.state()
    world.gravity = (0.3 * G, -2 * G)
    world.run(3)
    assert (world.state() == at_rest).all()
    boxes[2].exert(Force(-3 * 0.3 * G, 0))
    world.run(3)
    assert (world.state() == at_rest).all()
    world.remove(boxes[4])
    world.run(3)
    assert (world.state() == at_rest[:-1]).all()
    world.gravity = (0.6 * 2 * G, -2 * G)
    world.run(3)
    assert boxes[3].vx > 0.1


@pytest.fixture
def tries(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many bodies stood in each trial."""
    stood: list[int] = []
    stand = islands.stand

    def counted(*given: object) -> int:
        stood.append(stand(*given))  # type: ignore[arg-type]
        return stood[-1]

    monkeypatch.setattr(islands, "stand", counted)
    return stood


def test_what_stands_is_steady_and_tried_once(tries: list[int]) -> None:
    world = flat()
    boxes = [box(world, 0, i + 0.5) for i in range(3)]
    world.run(20)
    assert tries == [3]
    assert steady_pairs(world) == 3
    assert all(each.velocity == (0, 0) for each in boxes)


def an_overhang(world: World) -> None:
    box(world, 0, 0.5)
    box(world, 0.51, 1.5)


def a_gap(world: World) -> None:
    """One corner is in the air: it lands there, or turns about the other."""
    box(world, 0, 0.5 + 2.1e-5, angle=4e-5)


def deep(world: World) -> None:
    """It has to be pushed out."""
    box(world, 0, 0.498)


def a_belt(world: World) -> None:
    world.add(Box(4, 1), kind="static", position=(9, 0.5), friction=0.5, surface_speed=1.0)
    box(world, 9, 1.5)


def a_platform(world: World) -> None:
    world.add(Box(4, 1), kind="kinematic", position=(9, 0.5), friction=0.5, velocity=(1, 0))
    box(world, 9, 1.5)


def a_hinge(world: World) -> None:
    one, other = box(world, 0, 0.5), box(world, 1, 0.5)
    world.join(one, other, Pin((0.5, 0.5)))


def a_mover(world: World) -> None:
    """One that stands on one that slides."""
    box(world, 0, 0.5, velocity=(1, 0))
    box(world, 0, 1.5)


def a_lean(world: World) -> None:
    """Two boards that hold each other up: neither is below the other."""
    half, lean = 0.6, 0.3
    reach = half * math.sin(lean) + 0.05 * math.cos(lean)
    rise = half * math.cos(lean) + 0.05 * math.sin(lean)
    for side in (1, -1):
        world.add(
            Box(0.1, 2 * half), position=(-side * reach, rise), angle=-side * lean, friction=0.5
        )


def a_clamp(world: World) -> None:
    """A block that fits the slot of a clamp: each lies on the other."""
    jaws = [(Box(3, 0.5), (0, side)) for side in (-0.75, 0.75)]
    clamp = Compound([*jaws, (Box(0.5, 2), (-1.5, 0))])
    world.add(clamp, position=(0, 1 + clamp.centroid.y), friction=0.5)
    box(world, 0.5 - clamp.centroid.x, 1.0)


@pytest.mark.parametrize(
    "build",
    [a_clamp, an_overhang, a_gap, deep, a_belt, a_platform, a_hinge, a_mover, a_lean],
)
def test_what_may_move_takes_its_course_as_ever(
    build: Callable[[World], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A trial that fails leaves no trace: the same bits as without it."""
    ends = []
    for tried in (True, False):
        if not tried:
            monkeypatch.setattr(islands, "is_built", lambda *_: False)
        world = flat()
        build(world)
        world.run(1)
        assert steady_pairs(world) == 0
        world.run(40)
        ends.append(world.digest())
    assert ends[0] == ends[1]


def test_islands_stand_each_by_itself(tries: list[int]) -> None:
    world = flat()
    tower = [box(world, 9, i + 0.5) for i in range(4)]
    an_overhang(world)
    world.run(1)
    assert tries == [4]
    assert [each.y for each in tower] == [0.5, 1.5, 2.5, 3.5]


def test_the_weightless_and_what_floats_are_not_tried_again(tries: list[int]) -> None:
    world = World()
    world.add(Wall((-9, -0.5), (9, -0.5)))
    for x, y in ((0, 0), (1, 0), (0, 9), (1, 9)):
        box(world, x, y)
    world.run(20)
    assert tries == [2]


def test_discs_and_what_glides_stand_and_yield_to_small_forces() -> None:
    """One pin, or none: a = F / m on ice, (2/3) F / m for a disc that rolls."""
    world = flat()
    ice = world.add(Box(4, 1), kind="static", position=(20, 0.5), friction=0.0)
    box(world, 0, 0.5)
    disc = world.add(Circle(0.5), position=(0, 1.5), friction=0.5)
    other = world.add(Circle(0.5), position=(1.0, 0.5), friction=0.5)
    slider = box(world, 20, 1.5)
    bodies = (disc, other, slider)
    before = [body.position for body in bodies]
    world.run(60)
    assert steady_pairs(world) == 5
    for body, place in zip(bodies, before, strict=True):
        assert body.position == pytest.approx(place, abs=1e-13)
    for body in bodies:
        body.exert(Force(0.03, 0))
    world.run(60)
    for body, speed in ((disc, 0.02), (other, 0.02), (slider, 0.03)):
        assert body.vx == pytest.approx(speed, rel=1e-3)
    assert ice.position == (20, 0.5)


def test_a_box_put_on_a_tower_stands_at_once(tries: list[int]) -> None:
    world = flat()
    for i in range(3):
        box(world, 0, i + 0.5)
    world.run(30)
    top = box(world, 0.3, 3.5)
    world.run(5)
    assert tries == [3, 4]
    assert (top.position, top.velocity) == ((0.3, 3.5), (0, 0))
    assert steady_pairs(world) == 4


def test_a_box_put_beyond_the_edge_of_a_tower_topples_and_the_tower_stays() -> None:
    world = flat()
    tower = [box(world, 0, i + 0.5) for i in range(3)]
    world.run(30)
    top = box(world, 0.51, 3.5)
    world.run(60)
    assert top.angle < -0.1
    assert max(abs(each.angle) for each in tower) < 0.02


def test_a_ceiling_and_side_walls_that_touch_bear_nothing() -> None:
    world = flat()
    room = [Wall((-5, 2), (5, 2)), Wall((-0.5, 3), (-0.5, 0)), Wall((0.5, 0), (0.5, 3))]
    sides = [world.add(wall, friction=0.5) for wall in room]
    boxes = [box(world, 0, 0.5), box(world, 0, 1.5)]
    world.run(3)
    assert [each.position for each in boxes] == [(0, 0.5), (0, 1.5)]
    for contact in world.contacts:
        if contact.a in sides:
            assert math.hypot(*contact.impulse) == pytest.approx(0.0, abs=1e-12)


def test_between_two_walls_alone_a_box_falls() -> None:
    """Nothing presses it on them, so no friction holds it."""
    world = World(gravity=(0, -G))
    for wall in (Wall((-0.5, 9), (-0.5, -9)), Wall((0.5, -9), (0.5, 9))):
        world.add(wall, friction=0.9)
    fallen = box(world, 0, 0, friction=0.9)
    world.run(30)
    assert fallen.y < -1.0


def test_a_box_in_a_corner_leans_on_the_wall_that_its_push_presses_it_to() -> None:
    """Floor and wall share a push as equal springs would; together they bear it."""
    world = flat()
    wall = world.add(Wall((0.5, 0), (0.5, 3)), friction=0.5)
    pushed = box(world, 0, 0.5)
    pushed.exert(Force(20, 0))
    world.run(3)
    assert pushed.position == (0, 0.5)
    given = {contact.a: contact.impulse for contact in world.contacts}
    assert sum(impulse.x for impulse in given.values()) / DT == pytest.approx(-20, rel=1e-9)
    assert given[wall].x < 0.0


def test_a_point_that_slides_lets_the_others_hold() -> None:
    """On a slope of 30 degrees the upper edge bears little, and so much less by friction."""
    world = World(gravity=(G * math.sin(0.52), -G * math.cos(0.52)))
    world.add(Wall((-9, 0), (9, 0)), friction=0.7)
    block = box(world, 0, 0.5, friction=0.7)
    world.run(3)
    assert block.position == (0, 0.5)
    contacts = world.store.tables.contacts
    pushes = [contacts.normal_load[row] for row in (0, 1)]
    rubs = [abs(contacts.tangent_load[row]) for row in (0, 1)]
    assert sum(pushes) == pytest.approx(G * math.cos(0.52), rel=1e-9)
    assert sum(rubs) == pytest.approx(G * math.sin(0.52), rel=1e-9)
    assert min(0.7 * push - rub for push, rub in zip(pushes, rubs, strict=True)) == pytest.approx(0)
    assert max(0.7 * push - rub for push, rub in zip(pushes, rubs, strict=True)) > 0.1


def test_what_never_turns_stands_on_two_slopes() -> None:
    """Particles have no equation of rotation. Friction, which could not hold one, needs not."""
    world = World(gravity=(0, -G))
    world.add(Wall((-2, 2), (0, 0)), friction=0.3)
    world.add(Wall((0, 0), (2, 2)), friction=0.3)
    height = 0.3 * math.sqrt(2)
    grain = world.add(Particle(0.3), position=(0, height), friction=0.3)
    world.run(5)
    assert steady_pairs(world) == 2
    assert grain.position == (0, height)


def test_pieces_of_a_body_and_links_of_a_chain_bear_like_whole_ones() -> None:
    world = World(gravity=(0, -G))
    world.add(Chain([(i, 0) for i in range(-5, 6)]), friction=0.5)
    legs = [(Box(0.2, 1), (side, -0.6)) for side in (-1.3, 1.3)]
    table = Compound([(Box(3, 0.2), (0, 0)), *legs])
    height = 1.1 + table.centroid.y  # of its centre of mass above its feet
    body = world.add(table, position=(0.25, height), friction=0.5)
    load = box(world, 0.25, 1.7)
    world.run(5)
    assert (body.velocity, load.velocity) == ((0, 0), (0, 0))
    assert (body.y, load.y) == (height, 1.7)


def test_a_tower_that_is_built_as_another_island_gives_way_counts_no_impulse_twice() -> None:
    """Loads that never came to act have given nothing, though their contacts began."""
    world = flat(0.1)
    slides = box(world, 20, 0.5, friction=0.1)
    world.run(30)
    tower = [box(world, 0, i + 0.5, friction=4.0) for i in range(3)]
    world.gravity = (G * math.sin(0.4), -G * math.cos(0.4))
    world.run(1)
    assert slides.vx > 0.0
    for each in tower:
        given = sum(c.impulse.y for c in world.contacts if c.b is each)
        given -= sum(c.impulse.y for c in world.contacts if c.a is each)
        lost = G * math.cos(0.4) * DT
        assert given - lost == pytest.approx(each.vy, abs=1e-9)
