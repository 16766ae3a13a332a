"""Points of resting contacts follow their bodies as geometry would find them."""

import pytest

from engine import Circle, Polygon, Wall, World
from engine.kernels.following import find_points, follow, weigh_if_racing
from engine.kernels.pose import place
from engine.manifolds.any_pair import gap_between
from engine.tables import RESTING


@pytest.mark.parametrize("spin", [0.0, 0.4])
def test_gaps_are_those_of_the_geometry(spin: float) -> None:
    world = World(gravity=(0, -9.81))
    world.add(Wall((-20, 0), (20, 0)), friction=0.4)
    world.add(Polygon.box(4, 1), position=(0, 0.5), friction=0.2, velocity=(2, 0))
    world.add(Polygon.box(1, 1), position=(0.3, 1.5), friction=0.2, spin=spin)
    world.add(Circle(0.4), position=(-1.2, 1.4), friction=0.2, velocity=(1, 0))
    looked = 0
    for _ in range(60):
        world.step()
        t = world.tables
        for pair in range(t.counts.pairs[0]):
            if t.pairs.state[pair] != RESTING or t.pairs.points[pair] == 0:
                continue
            for row in (t.pairs.a[pair], t.pairs.b[pair]):
                place(t.bodies, t.corners, row, 0.0)
            points = range(2 * pair, 2 * pair + t.pairs.points[pair])
            followed = min(t.contacts.gap[i] for i in points)
            assert followed == pytest.approx(gap_between(t, pair), abs=1e-5)
            looked += 1
    assert looked > 60


def test_both_bodies_of_a_contact_have_the_same_point() -> None:
    """Else their impulses would be no pair, and angular momentum would not be kept."""
    world = World()
    world.add(Polygon.box(1, 1), velocity=(1, 0.1), spin=0.2, friction=0.5)
    world.add(Polygon.box(1, 2), position=(1.3, 0.3), mass=3, friction=0.5)
    looked = 0
    for _ in range(200):
        world.step()
        t = world.tables
        if t.pairs.state[0] != RESTING or t.pairs.points[0] == 0:
            continue
        nx, ny = t.pairs.normal_x[0], t.pairs.normal_y[0]
        x, y = t.bodies.x[1] - t.bodies.x[0], t.bodies.y[1] - t.bodies.y[0]
        for i in range(t.pairs.points[0]):
            along_n = t.contacts.tangent_arm_a[i] - t.contacts.tangent_arm_b[i]
            along_t = t.contacts.normal_arm_b[i] - t.contacts.normal_arm_a[i]
            assert along_n == pytest.approx(x * nx + y * ny, abs=1e-14)
            assert along_t == pytest.approx(y * nx - x * ny, abs=1e-14)
        looked += 1
    assert looked > 3


def test_masses_follow_bodies_that_race_over_each_other() -> None:
    """With the effective mass of a short lever at a long one sweeps take too much of the velocity,
    and diverge: a heap of bodies of a millimetre, which fall that far in a part of a tick, left the
    range of numbers.
    """
    world = World(gravity=(0, -9.81))
    world.add(Wall((-20, 0), (20, 0)))
    world.add(Polygon.box(1, 1), position=(0, 0.5), mass=2.0)
    world.add(Polygon.box(1, 1), position=(0.1, 1.5), mass=3.0)
    world.run(10)
    t = world.tables
    pair = next(i for i in range(t.counts.pairs[0]) if (t.pairs.a[i], t.pairs.b[i]) == (1, 2))
    t.bodies.middle_x[2] += 0.9
    follow(t, pair, 0.0)
    weigh_if_racing(t, pair)
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        arm_a, arm_b = t.contacts.normal_arm_a[row], t.contacts.normal_arm_b[row]
        turning = arm_a * arm_a * t.bodies.inverse_inertia[1]
        turning += arm_b * arm_b * t.bodies.inverse_inertia[2]
        mass = 1.0 / (1.0 / 2.0 + 1.0 / 3.0 + turning)
        assert t.contacts.normal_mass[row] == pytest.approx(mass, rel=1e-12)


def test_a_new_point_bears_no_load_of_one_that_stood_in_its_row() -> None:
    """Loads go with their points, as impulses do. A steady contact that found a second point gave
    it what another contact had once borne in that row: a restored world went another way.
    """
    world = World(gravity=(0, -9.81))
    world.add(Wall((-5, 0), (5, 0)))
    world.add(Polygon.box(1, 1), position=(0, 0.5))
    world.run(10)
    t = world.tables
    assert t.pairs.points[0] == 2
    features = [t.contacts.feature[0], t.contacts.feature[1]]
    t.contacts.normal_load[0], t.contacts.normal_load[1] = 3.0, 5.0
    t.contacts.tangent_load[0], t.contacts.tangent_load[1] = 1.0, 2.0
    t.contacts.feature[0], t.contacts.feature[1] = features[1], -1  # nothing like the second
    find_points(t, 0, 0.0)
    found = {t.contacts.feature[row]: row for row in range(2)}
    known, new = found[features[1]], found[features[0]]
    assert (t.contacts.normal_load[known], t.contacts.tangent_load[known]) == (3.0, 1.0)
    assert (t.contacts.normal_load[new], t.contacts.tangent_load[new]) == (0.0, 0.0)
