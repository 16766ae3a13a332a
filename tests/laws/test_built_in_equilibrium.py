"""What is built in static equilibrium does not move at all, from its first tick on."""

import math
import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

from engine import Body, Box, Circle, Force, Polygon, Torque, Wall, World

G = 9.81
DT = 1 / 60


def flat(friction: float = 0.5, integrator: str = "velocity-verlet") -> World:
    world = World(gravity=(0, -G), integrator=integrator)
    world.add(Wall((-1000, 0), (1000, 0)), friction=friction)
    return world


def block(world: World, x: float, y: float, width: float = 1.0, height: float = 1.0) -> Body:
    mass = width * height
    return world.add(Box(width, height), mass=mass, position=(x, y), friction=0.5)


def poses(world: World) -> list[tuple[float, float, float]]:
    return [(*body.position, body.angle) for body in world]


def has_moved(world: World, ticks: int = 30) -> bool:
    """Whether anything is elsewhere, by as little as a bit, after one of so many ticks."""
    before = poses(world)
    for _ in range(ticks):
        assert world.step() == []
        if poses(world) != before:
            return True
    return False


def bears(world: World, body: Body) -> float:
    """With which force contacts lift a body in the last tick, its own weight apart (N)."""
    up = sum(contact.impulse.y for contact in world.contacts if contact.b is body)
    return (up - sum(contact.impulse.y for contact in world.contacts if contact.a is body)) / DT


def test_a_tower_of_twenty_does_not_sink() -> None:
    """Rigid bodies in equilibrium stay (Newton I); each bears the weight of those above it."""
    world = flat()
    boxes = [block(world, 0.01 * (i % 3), i + 0.5) for i in range(20)]
    assert not has_moved(world)
    for i, box in enumerate(boxes):
        under = next(contact for contact in world.contacts if contact.b is box)
        assert under.impulse.y / DT == pytest.approx((20 - i) * G, rel=1e-9)
        assert under.impulse.x == pytest.approx(0.0, abs=1e-9)
    assert world.kinetic_energy == 0.0


@pytest.mark.parametrize("base", [4, 12])
def test_a_pyramid_does_not_sink_and_the_ground_bears_its_weight(base: int) -> None:
    world = flat()
    boxes = [
        block(world, 1.05 * (i - (base - row) / 2), row + 0.5)
        for row in range(base)
        for i in range(base - row)
    ]
    assert not has_moved(world)
    ground = next(iter(world))
    borne = sum(contact.impulse.y for contact in world.contacts if contact.a is ground)
    assert borne / DT == pytest.approx(len(boxes) * G, rel=1e-9)
    for box in boxes:
        assert bears(world, box) == pytest.approx(G, rel=1e-9)


@pytest.mark.parametrize("share", [0.5, 0.999999, 1.000001, 1.1])
def test_the_harmonic_stack_stands_just_inside_its_limit_and_falls_just_outside(
    share: float,
) -> None:
    """The block k from the top may overhang by 1/(2 k) of its length, and no further (Paterson and
    Zwick, "Overhang", American Mathematical Monthly 116, 2009).
    """
    world = flat()
    count, length = 6, 2.0
    x = 0.0
    for k in range(count, 0, -1):
        block(world, x, 0.2 * (count - k) + 0.1, length, 0.2)
        x += share * length / (2 * (k - 1)) if k > 1 else 0.0
    assert has_moved(world) is (share > 1.0)


@pytest.mark.parametrize("share", [0.5, 0.999999, 1.001, 1.5])
def test_a_block_stands_on_a_slope_below_the_angle_of_friction_and_slides_above(
    share: float,
) -> None:
    """tan = mu; a = g (sin - mu cos) from the first tick on."""
    mu = 0.4
    angle = math.atan(share * mu)
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    cos, sin = math.cos(angle), math.sin(angle)
    world.add(Wall((50 * cos, 50 * sin), (-50 * cos, -50 * sin)), friction=mu)
    box = world.add(Box(1, 1), position=(-sin / 2, cos / 2), angle=angle, friction=mu)
    start = box.position
    world.step()
    a = G * (sin - mu * cos)
    speed = a * DT if share > 1.0 else 0.0
    assert box.speed == pytest.approx(speed, rel=1e-3, abs=1e-12)
    for _ in range(29):
        world.step()
    way = (start.x - box.x) * cos + (start.y - box.y) * sin
    assert way == pytest.approx(a * 0.5**2 / 2 if share > 1.0 else 0.0, rel=1e-3, abs=1e-5)
    assert (box.position == start) is (share < 1.0)


@pytest.mark.parametrize("share", [0.9999, 1.01])
def test_a_tall_box_tips_where_its_weight_leaves_its_foot(share: float) -> None:
    """On a slope it stands if tan < width / height."""
    width, height = 0.3, 1.0
    angle = math.atan(share * width / height)
    cos, sin = math.cos(angle), math.sin(angle)
    world = World(gravity=(0, -G))
    world.add(Wall((50 * cos, 50 * sin), (-50 * cos, -50 * sin)), friction=1.0)
    place = (-sin * height / 2, cos * height / 2)
    world.add(Box(width, height), position=place, angle=angle, friction=1.0)
    assert has_moved(world) is (share > 1.0)


def test_trestles_share_a_beam_by_the_law_of_the_lever() -> None:
    """R_left (b + c) = W c; a load beside the middle of the beam adds its own share."""
    world = flat()
    left, right = block(world, -2, 0.5, 0.2), block(world, 2, 0.5, 0.2)
    beam = world.add(Box(6, 0.2), mass=3.0, position=(0.2, 1.1), friction=0.5)
    load = world.add(Box(0.5, 0.5), mass=10.0, position=(1.0, 1.45), friction=0.5)
    assert not has_moved(world)
    on_right = next(c for c in world.contacts if {c.a, c.b} == {right, beam})
    on_left = next(c for c in world.contacts if {c.a, c.b} == {left, beam})
    push = abs(on_right.impulse.y) / DT
    assert push + abs(on_left.impulse.y) / DT == pytest.approx(13 * G, rel=1e-9)
    # The feet are 0.2 m wide: a reaction acts somewhere on them.
    least, most = ((3 * 2.2 + 10 * 3.0 + 13 * d) / 4.0 * G for d in (-0.1, 0.1))
    assert least - 1e-9 < push < most + 1e-9
    assert bears(world, load) == pytest.approx(10 * G, rel=1e-9)


def test_heavy_stands_on_light() -> None:
    """Whatever the ratio of masses, the load of the lower contact is their weight."""
    world = flat()
    light = world.add(Box(1, 1), mass=0.1, position=(0, 0.5), friction=0.5)
    world.add(Box(1, 1), mass=1000.0, position=(0.2, 1.5), friction=0.5)
    assert not has_moved(world)
    under = next(contact for contact in world.contacts if contact.b is light)
    assert under.impulse.y / DT == pytest.approx(1000.1 * G, rel=1e-9)


@pytest.mark.parametrize(("push", "stands"), [(4.9, True), (4.91, False)])
def test_friction_holds_what_is_pushed_as_far_as_mu_n(push: float, stands: bool) -> None:
    """F < mu m g, here 4.905 N."""
    world = flat()
    box = block(world, 0, 0.5)
    box.exert(Force(push, 0))
    assert has_moved(world) is not stands


@pytest.mark.parametrize(("torque", "stands"), [(4.9, True), (4.91, False)])
def test_a_torque_tips_a_box_beyond_the_moment_of_its_weight(torque: float, stands: bool) -> None:
    """T < m g w / 2, here 4.905 N m."""
    world = flat()
    block(world, 0, 0.5).exert(Torque(torque))
    assert has_moved(world) is not stands


@given(seed=some.integers(0, 2**32))
@settings(max_examples=60, deadline=None)
def test_a_stack_stands_if_and_only_if_each_part_of_it_weighs_on_its_support(seed: int) -> None:
    """The centre of mass of all above a joint lies within the joint (statics of rigid bodies)."""
    dice = random.Random(seed)
    kinds = ("velocity-verlet", "semi-implicit-euler", "rk4", "explicit-euler")
    world = flat(integrator=dice.choice(kinds))
    x = y = below = 0.0
    stack: list[tuple[float, float, float]] = []  # centre, width, mass
    joints: list[tuple[float, float]] = []
    for i in range(dice.randint(1, 8)):
        width, height, mass = dice.uniform(0.5, 2), dice.uniform(0.2, 1), 10 ** dice.uniform(-1, 1)
        if i > 0:
            x += dice.uniform(-0.3, 0.3) * (width + below)
        ends = (x - width / 2, x + width / 2)
        if i > 0:
            before = stack[-1]
            ends = (max(ends[0], before[0] - below / 2), min(ends[1], before[0] + below / 2))
        world.add(Box(width, height), mass=mass, position=(x, y + height / 2), friction=0.5)
        stack.append((x, width, mass))
        joints.append(ends)
        y, below = y + height, width
    margin = math.inf
    for i, (low, high) in enumerate(joints):
        mass = sum(m for _, _, m in stack[i:])
        centre = sum(at * m for at, _, m in stack[i:]) / mass
        margin = min(margin, centre - low, high - centre)
    if abs(margin) > 1e-9:
        assert has_moved(world, 3) is (margin < 0)


def test_the_order_in_which_bodies_are_added_changes_no_load() -> None:
    """Loads that statics leaves open are those of equal springs, whoever came first."""
    places = [(1.05 * (i - (6 - row) / 2), row + 0.5) for row in range(6) for i in range(6 - row)]
    found = []
    for seed in range(3):
        random.Random(seed).shuffle(places)
        world = flat()
        for place in places:
            block(world, *place)
        assert not has_moved(world, 3)
        found.append(
            sorted(
                (*contact.a.position, *contact.b.position, abs(contact.impulse.y))
                if contact.a.y < contact.b.y
                else (*contact.b.position, *contact.a.position, abs(contact.impulse.y))
                for contact in world.contacts
            )
        )
    for others in found[1:]:
        for one, other in zip(found[0], others, strict=True):
            assert one == pytest.approx(other, abs=1e-9)


def test_contacts_begin_with_the_first_tick_and_give_what_gravity_takes() -> None:
    world = flat()
    boxes = [block(world, 0, i + 0.5) for i in range(3)]
    for phase in ("begin", "stay"):
        world.step()
        assert {contact.phase for contact in world.contacts} == {phase}
        for box in boxes:
            assert bears(world, box) == pytest.approx(G, rel=1e-9)
    book = world.ledger()
    assert book.energy_error == 0.0
    assert book.momentum_error == pytest.approx((0.0, 0.0), abs=1e-12)


@pytest.mark.parametrize("height", [1e-3, 1e-2])
def test_what_hits_a_tower_in_its_first_tick_hits_it_in_time(height: float) -> None:
    """After (-v + sqrt(v^2 + 2 g h)) / g; contacts give each body what it gains."""
    world = flat()
    boxes = [block(world, 0, i + 0.5) for i in range(5)]
    ball = world.add(Circle(0.2), mass=0.5, position=(0.1, 5.2 + height), velocity=(0, -2.0))
    hit, *_ = world.step()
    assert hit.time == pytest.approx((math.sqrt(4 + 2 * G * height) - 2) / G, abs=1e-9)
    for body, before in ((ball, -2.0), *((box, 0.0) for box in boxes)):
        lifted = bears(world, body) - body.mass * G
        assert lifted * DT == pytest.approx(body.mass * (body.vy - before), abs=1e-9)
    assert world.ledger().energy_error == pytest.approx(0.0, abs=1e-10)


def test_a_tower_that_stands_goes_on_from_a_snapshot_bit_for_bit() -> None:
    world = flat()
    boxes = [block(world, 0.1 * i, i + 0.5) for i in range(4)]
    world.step()
    saved = world.snapshot()
    other = World.from_dict(world.to_dict())
    ends = []
    for each in (world, world, other):
        if each is world:
            world.restore(saved)
        each.body(boxes[3].id).exert(Force(9, 0), duration=0.3)
        for _ in range(40):
            each.step()
        ends.append(each.digest())
    assert ends[0] == ends[1] == ends[2]
    assert boxes[3].x > 0.3


def test_a_house_without_mortar_stands() -> None:
    """Bricks side by side and in layers, a lintel over a door, a roof: nothing needs its sides."""
    world = flat(0.7)
    for row in range(4):
        for i in (0, 1, 4, 5) if row < 3 else (0, 5):
            world.add(Box(1, 0.5), position=(i, 0.25 + 0.5 * row), friction=0.7)
    world.add(Box(4, 0.5), mass=4.0, position=(2.5, 1.75), friction=0.7)
    roof = Polygon([(-3, 0), (3, 0), (0.5, 1)])
    world.add(roof, position=(2.5, 2.0 - min(y for _, y in roof.vertices)), friction=0.7)
    assert not has_moved(world)
