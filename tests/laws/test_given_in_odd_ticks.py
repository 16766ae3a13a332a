"""Contacts give what bodies gain, and books close, in ticks that are out of the ordinary."""

import itertools
import math

import pytest

from engine import (
    Body,
    Box,
    Capsule,
    Chain,
    Circle,
    Compound,
    Pin,
    Polygon,
    QuadraticDrag,
    Wall,
    World,
)

DT = 1 / 60
MM = 1e-3


def lacks(world: World, ticks: int, gravity: float) -> float:
    """The most that bodies gained in a tick beside what contacts, joints and forces gave (N s)."""
    bodies = [body for body in world if body.is_dynamic]
    most = 0.0
    for _ in range(ticks):
        before = {body: body.momentum for body in bodies}
        world.step(DT)
        given: dict[Body | None, list[float]] = {
            body: [0.0, body.mass * gravity * DT] for body in bodies
        }
        acted = [(contact.a, contact.b, contact.impulse) for contact in world.contacts]
        forces = [(joint.a, joint.b, joint.force) for joint in world.joints]
        for a, b, x, y in [
            *((a, b, j.x, j.y) for a, b, j in acted),
            *((a, b, f.x * DT, f.y * DT) for a, b, f in forces),
        ]:
            for body, sign in ((a, -1), (b, 1)):
                if body in given:
                    given[body][0] += sign * x
                    given[body][1] += sign * y
        for body in bodies:
            gained = body.momentum
            x = gained.x - before[body].x - given[body][0]
            y = gained.y - before[body].y - given[body][1]
            most = max(most, math.hypot(x, y))
    return most


def bowl(size: float) -> Chain:
    return Chain([(x * size, y * size) for x, y in [(-12, 2), (-6, 0), (0, 0.1), (6, 0), (12, 2)]])


def test_discs_that_are_deep_in_each_other_and_turn_on_each_other() -> None:
    """Their normal turns by a lot before it is used to relax: the impulse stood along the old."""
    world = World(gravity=(0, -9.81), integrator="rk4", substeps=2)
    world.add(bowl(MM))
    world.add(Circle(0.129 * MM), position=(0.0357 * MM, 2.9 * MM), friction=0.8)
    world.add(Circle(0.354 * MM), position=(0.0, 4.1 * MM), friction=0.8)
    assert lacks(world, 8, -9.81) < 1e-12


def test_blows_at_the_very_start_of_a_tick_in_which_others_wait() -> None:
    """Parts of no duration end before an island begins to wait: it did so anew, and forgot what had
    been noted of them.
    """
    world = World(gravity=(0, -9.81), integrator="velocity-verlet", substeps=1)
    world.add(bowl(MM), friction=0.3)
    world.add(Box(0.8 * MM, 0.25 * MM), position=(1.0 * MM, 0.3 * MM))
    a = world.add(Capsule(0.55 * MM, 0.12 * MM), position=(1.8 * MM, 0.3 * MM))
    b = world.add(Box(0.8 * MM, 0.25 * MM), position=(2.6 * MM, 0.3 * MM))
    world.join(a, b, Pin((2.2 * MM, 0.3 * MM)), collide=True)
    square = Polygon.regular(4, 0.7660842432936892 * MM)
    world.add(square, position=(4.0 * MM, 0.5 * MM), friction=0.8)
    size = 0.5501168124855467 * MM
    ends = [(Circle(0.4 * size), (x * size, 0)) for x in (-1, 1)]
    bell = Compound([*ends, Box(2 * size, 0.3 * size)])
    world.add(bell, position=(4.711122256450309 * MM, 0.5 * MM))
    assert lacks(world, 4, -9.81) < 1e-12


def test_a_floor_that_begins_to_turn_works_through_rolling_resistance_too() -> None:
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    floor = world.add(Box(24, 1), kind="kinematic", position=(0, -0.5))
    world.add(Box(1.5, 0.64), position=(1.2, 0.5), rolling_resistance=0.02)
    for _ in range(40):
        world.step(DT)
    floor.spin = 1.0
    for _ in range(10):
        world.step(DT)
    books = world.ledger()
    assert books.work.walls > 0.1
    assert books.energy_error == pytest.approx(0.0, abs=1e-12)


def test_a_body_that_is_struck_on_a_floor_that_turns() -> None:
    """Its arms are corrected for the way that the blow adds: what turns the floor is its work."""
    world = World(gravity=(0, -9.81), integrator="velocity-verlet")
    world.add(Box(4, 0.2), kind="kinematic", spin=0.5, friction=0.5)
    world.add(Box(1, 0.5), position=(0.5, 0.35), friction=0.5)
    world.add(Circle(0.2), position=(0.6, 1.2), velocity=(0, -2), restitution=0.5)
    for _ in range(30):
        world.step(DT)
        assert world.ledger().energy_error == pytest.approx(0.0, abs=1e-12)


def test_buried_discs_that_bounce_off_and_come_to_rest_again_within_a_part() -> None:
    """They get a point to relax by, of which the books took off what an earlier one had given."""
    world = World(gravity=(0, -9.81), integrator="velocity-verlet", substeps=1)
    world.add(Wall((-2, 0), (2, 0)), restitution=0.1)
    for radius in (0.3, 0.2):
        world.add(Circle(radius), position=(0, 0.5), velocity=(0, -5), restitution=0.1)
    for _ in range(5):
        world.step(DT)
        assert world.ledger().energy_error == pytest.approx(0.0, abs=1e-12)


def test_a_contact_that_bounces_off_and_comes_to_rest_again_within_a_part() -> None:
    """It has no points then; of what it was to give, more was taken for given than was."""
    world = World(gravity=(0, -0.981), integrator="rk4", substeps=1)
    world.add(Wall((-1.2, 0), (1.2, 0)), restitution=0.3)
    world.add(Polygon.regular(4, 0.017962433419505024), position=(0.12, 0.05), friction=0.5)
    world.add(
        Polygon.regular(3, 0.05936179635720206), position=(0.12, 0.17), restitution=0.2,
        friction=0.8980123923788823, rolling_resistance=0.002,
    )  # fmt: skip
    r, s = 0.07097938173339198, 0.028391752693356795
    angle = Polygon.concave([(0, 0), (r, 0), (r, s), (s, s), (s, r), (0, r)])
    world.add(angle, position=(0.12, 0.29), friction=0.5)
    assert lacks(world, 40, -0.981) < 1e-12


def test_links_that_meet_face_to_face_across_their_hinge_are_not_driven_apart() -> None:
    """What stops one corner drives the other: the equations of both have no answer, or any."""
    world = World(
        gravity=(0, -9.81), integrator="velocity-verlet", substeps=2, drag=QuadraticDrag(0.1)
    )
    world.add(Wall((-4, 0), (4, 0)), friction=1.0, restitution=0.3)
    links = [
        world.add(Box(0.8, 0.25), position=(0.8 * i, 0.2), friction=f, restitution=e)
        for i, (f, e) in enumerate(
            [(0.0, 0.0), (0.669234631882315, 0.2), (0.7760101371266445, 1.0)]
        )
    ]
    for a, b in itertools.pairwise(links):
        world.join(a, b, Pin((b.x - 0.4, 0.2)), collide=True)
    hits = [hit for _ in range(20) for hit in world.step(1 / 30)]
    assert max(math.hypot(*hit.impulse) for hit in hits) < 3.0
    books = world.ledger()
    assert books.energy_error == pytest.approx(0.0, abs=1e-12)
