"""Round corners: bodies touch at their true distance, and roll over their edges."""

import math

import pytest

from engine import Box, Capsule, Circle, Compound, Polygon, Wall, World


@pytest.mark.parametrize("offset", [0.0, 0.7, 1.05, 1.2])
def test_two_capsules_meet_at_their_true_distance(offset: float) -> None:
    """Ends are half discs: past each other's straight part they meet at sqrt(4 r^2 - d^2)."""
    world = World()
    a = world.add(Capsule(1.0, 0.25), position=(0, 0), velocity=(0, 3.0))
    world.add(Capsule(1.0, 0.25), position=(offset, 2.0), velocity=(0, -2.0))
    beyond = max(0.0, offset - 1.0)
    apart = math.sqrt(0.25 - beyond * beyond)
    hits = []
    while not hits:
        hits = world.step()
    assert hits[0].time == pytest.approx((2.0 - apart) / 5.0, abs=1e-9)
    assert hits[0].normal == pytest.approx((beyond / 0.5, apart / 0.5), abs=1e-6)
    assert hits[0].a is a


@pytest.mark.parametrize("angle", [0.0, 0.3, 1.2])
def test_a_capsule_falls_like_its_lower_end(angle: float) -> None:
    """Eq. 40 of the thesis with the arm of the end that touches."""
    world = World()
    world.add(Wall((-5, 0), (5, 0)))
    body = world.add(
        Capsule(1.0, 0.2), mass=2.0, position=(0, 3), velocity=(0, -4), angle=angle, restitution=1
    )
    hits = []
    while not hits:
        hits = world.step()
    lowest = 0.5 * math.sin(angle) + 0.2
    assert hits[0].time == pytest.approx((3.0 - lowest) / 4.0, abs=1e-9)
    arm = -0.5 * math.cos(angle) if angle else 0.0
    impulse = 2.0 * 4.0 / (1.0 / 2.0 + arm * arm / body.inertia)
    assert hits[0].impulse == pytest.approx((0.0, impulse), rel=1e-6, abs=1e-6)


def test_a_rounded_square_rolls_like_a_ball_on_its_corner() -> None:
    """While only a corner touches, its arc of radius r rolls: the centre of the arc stays at r."""
    world = World(gravity=(0, -9.81))
    world.add(Wall((-5, 0), (5, 0)), friction=1.0)
    shape = Box(0.6, 0.6, rounding=0.2)
    turn = 0.35
    at = (0.0, 0.2 + 0.3 * math.sqrt(2) * math.sin(math.pi / 4 + turn))
    body = world.add(shape, position=at, angle=-turn, friction=1.0, spin=-1.0)
    body.velocity = (at[1], 0.3 * math.sqrt(2) * math.cos(math.pi / 4 + turn) * -1.0)
    world.step()
    for _ in range(12):
        world.step()
        corners = [body.to_world(corner) for corner in shape.vertices]
        assert min(y for _, y in corners) == pytest.approx(0.2, abs=2e-4)


@pytest.mark.parametrize(
    "shape", [Capsule(1.0, 0.2), Box(1.0, 0.2, rounding=0.1), Polygon.box(1.0, 0.2, rounding=0.1)]
)
def test_rounded_bodies_stack(shape: Capsule | Box | Polygon) -> None:
    """Flat on each other they touch at two points, so that a tower stands."""
    world = World(gravity=(0, -9.81))
    world.add(Wall((-5, 0), (5, 0)), friction=0.5)
    tower = [world.add(shape, position=(0, 0.2 + 0.4 * i), friction=0.5) for i in range(5)]
    for _ in range(300):
        world.step()
    for i, body in enumerate(tower):
        assert body.position == pytest.approx((0, 0.2 + 0.4 * i), abs=3e-3)
        assert body.speed < 1e-3
        assert body.angle == pytest.approx(0.0, abs=1e-3)


def test_a_bar_bell_balances_on_its_discs() -> None:
    """A compound falls on both discs at once and stays level; momentum and energy as for one body:
    m g h is what the floor takes.
    """
    shape = Compound([(Circle(0.3), (-1, 0)), (Circle(0.3), (1, 0)), (Box(2.0, 0.1), (0, 0))])
    world = World(gravity=(0, -9.81))
    world.add(Wall((-5, 0), (5, 0)), friction=0.5)
    bell = world.add(shape, mass=3.0, position=(0, 1.3), friction=0.5)
    for _ in range(240):
        world.step()
    assert bell.position == pytest.approx((0, 0.3), abs=1e-3)
    assert bell.angle == pytest.approx(0, abs=1e-6)
    assert bell.speed < 1e-3


@pytest.mark.parametrize("integrator", ["velocity-verlet", "semi-implicit-euler"])
def test_a_compound_of_two_halves_moves_like_the_whole(integrator: str) -> None:
    """The same mass, centre and moment of inertia: the same impacts, here of a rod on a table."""
    ends = []
    for shape in (
        Box(2.0, 0.5),
        Compound([(Box(1.0, 0.5), (-0.5, 0)), (Box(1.0, 0.5), (0.5, 0))]),
        Polygon.concave([(-1, -0.25), (1, -0.25), (1, 0.25), (-1, 0.25)]),
    ):
        world = World(gravity=(0, -9.81), integrator=integrator)
        world.add(Wall((-5, 0), (5, 0)))
        body = world.add(shape, mass=2.0, position=(0, 2), angle=0.4, restitution=0.8)
        for _ in range(40):
            world.step()
        ends.append((body.x, body.y, body.angle, body.vx, body.vy, body.spin))
    assert ends[1] == pytest.approx(ends[0], abs=1e-9)
    assert ends[2] == pytest.approx(ends[0], abs=1e-9)
