"""What has a fixed rotation moves as a mass point does, and lands on its corners as a body."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine import Body, Box, Capsule, Chain, Circle, Force, Particle, Polygon, Torque, Wall, World


def test_nothing_turns_it() -> None:
    world = World(gravity=(0, -9.81))
    world.add(Wall((-9, -1), (9, 1)), friction=0.5)
    hero = world.add(
        Box(0.5, 1.8), mass=2.0, position=(0, 3), angle=0.1, friction=0.5, fixed_rotation=True
    )
    hero.exert(Torque(50))
    hero.exert(Force(3, 0), at=(0, 9))
    hero.apply_impulse((1, 1), at=(5, 5))
    world.run(240)
    assert (hero.angle, hero.spin, hero.fixed_rotation) == (0.1, 0.0, True)
    assert hero.kinetic_energy == pytest.approx(hero.mass * hero.speed**2 / 2)
    hero.angle = 0.3
    world.run(10)
    assert hero.angle == 0.3


def test_struck_off_its_centre_it_leaves_as_a_mass_point() -> None:
    """v' = (1 + e) m v / (m + M), wherever it is struck: nothing of it turns."""
    world = World()
    target = world.add(Box(1, 4), mass=3.0, position=(2, 0), fixed_rotation=True)
    world.add(Circle(0.2), mass=1.0, position=(0, 1.7), velocity=(8, 0), restitution=0.5)
    world.run(60)
    assert target.velocity == pytest.approx((1.5 * 8 / 4, 0), abs=1e-12)


def test_it_stands_where_others_would_fall_over() -> None:
    """A box that overhangs by three quarters, on a slope that friction holds."""
    world = World(gravity=(0, -9.81))
    world.add(Box(2, 1), kind="static", position=(0, -0.5), friction=0.9)
    box = world.add(Box(2, 0.5), position=(1.5, 0.25), friction=0.9, fixed_rotation=True)
    world.run(120)
    assert box.position == pytest.approx((1.5, 0.25), abs=1e-3)
    assert box.speed == 0.0


def test_what_it_refuses() -> None:
    world = World()
    body = world.add(Box(1, 1), fixed_rotation=True)
    assert body.inertia == math.inf
    body.mass = 7.0
    assert (body.mass, body.inertia) == (7.0, math.inf)
    before = world.digest()
    for name, value in (("spin", 1.0), ("inertia", 2.0)):
        with pytest.raises(ValueError, match=r"box 1 never rotates, so its .* cannot be"):
            setattr(body, name, value)
    state = world.state()
    state[0, -1] = 3.0
    with pytest.raises(ValueError, match=r"box 1 cannot have spin 3\.0"):
        world.set_state(state)
    for given_too in ({"spin": 1.0}, {"inertia": 1.0}, {"kind": "kinematic"}, {"kind": "static"}):
        with pytest.raises(ValueError, match="fixed"):
            world.add(Box(1, 1), fixed_rotation=True, **given_too)
    with pytest.raises(ValueError, match="inertia must be finite"):
        world.add(Box(1, 1), inertia=math.inf)
    assert world.digest() == before


def test_inertia_may_be_set() -> None:
    world = World()
    body, point = world.add(Circle(1), mass=2.0), world.add(Particle(1), position=(9, 9))
    body.inertia = 5.0
    body.exert(Torque(10), duration=0.5)
    world.run(60)
    assert body.spin == pytest.approx(1.0, abs=1e-12)
    assert not body.fixed_rotation
    assert point.fixed_rotation
    with pytest.raises(ValueError, match="a particle never rotates"):
        point.inertia = 1.0


SHAPES = [Box(0.6, 0.9), Circle(0.4), Capsule(0.5, 0.2), Polygon.regular(5, 0.4)]


@settings(max_examples=25, deadline=None)
@given(
    st.lists(
        st.tuples(
            st.sampled_from(SHAPES), st.booleans(), st.floats(-2, 2), st.floats(-1, 1),
            st.sampled_from([0.1, 1.0, 10.0]), st.sampled_from([0.0, 0.5]),
        ),
        min_size=1, max_size=6,
    )
)  # fmt: skip
def test_among_others_the_books_close(given_bodies: list[tuple[object, ...]]) -> None:
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    world.add(Chain([(-4, 9), (-4, 0), (4, 0), (4, 9)]), friction=0.4)
    fixed: list[Body] = []
    for i, (shape, turns, x, angle, mass, e) in enumerate(given_bodies):
        body = world.add(
            shape, position=(x, 1 + i), angle=angle, mass=mass, restitution=e, friction=0.4,
            fixed_rotation=not turns,
        )  # type: ignore[arg-type]  # fmt: skip
        fixed += [] if turns else [body]
    angles = [body.angle for body in fixed]
    start = world.ledger()
    world.run(90)
    change = world.ledger().since(start)
    assert abs(change.energy_error) < 1e-9 * (1 + abs(change.work.total) + start.kinetic)
    assert [body.angle for body in fixed] == angles
    assert all(body.y > -0.01 for body in fixed)
