"""Shapes: geometry, moments of inertia, and what is refused."""

import math
from collections.abc import Callable
from itertools import count, pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine import Body, Box, Capsule, Chain, Circle, Compound, Particle, Polygon, Wall, World
from engine.shapes import outlines
from engine.shapes.moments import cross


@pytest.mark.parametrize(
    ("sides", "expected"), [(3, 0.25), (4, 1 / 3), (5, 0.3848362), (6, 5 / 12)]
)
def test_regular_polygons_have_the_tabulated_inertia(sides: int, expected: float) -> None:
    """I / (m R^2), physics.md; in general (2 + cos(2 pi / n)) / 6."""
    shape = Polygon.regular(sides, radius=2.0)
    assert shape.inertia(3.0) == pytest.approx(3.0 * 4.0 * expected, rel=1e-7)
    general = (2 + math.cos(2 * math.pi / sides)) / 6
    assert shape.inertia(1.0) == pytest.approx(4 * general, rel=1e-12)


def test_box_circle_and_particle() -> None:
    assert Polygon.box(2, 3).inertia(6) == pytest.approx(6 * (4 + 9) / 12)
    assert Polygon.box(2, 3).area == pytest.approx(6)
    assert Circle(2).inertia(3) == pytest.approx(6)
    assert Circle(2).area == pytest.approx(4 * math.pi)
    assert Particle(2).inertia(3) == math.inf


def test_vertices_are_moved_to_the_centroid() -> None:
    shape = Polygon([(10, 10), (13, 10), (10, 13)])
    assert shape.centroid == pytest.approx((11, 11))
    assert sum(v.x for v in shape.vertices) == pytest.approx(0)


@given(order=st.permutations([(0, 0), (4, 0), (5, 2), (3, 4), (0, 3)]))
def test_any_order_of_vertices_is_accepted(order: list[tuple[float, float]]) -> None:
    shape = Polygon(order)
    assert shape.area == pytest.approx(15.5)
    turns = [
        (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x)
        for a, b, c in zip(
            shape.vertices,
            shape.vertices[1:] + shape.vertices[:1],
            shape.vertices[2:] + shape.vertices[:2],
            strict=True,
        )
    ]
    assert min(turns) > 0


def test_duplicates_and_points_on_a_side_are_dropped() -> None:
    shape = Polygon([(0, 0), (1, 0), (2, 0), (2, 2), (2, 2), (0, 2)])
    assert len(shape.vertices) == 4


def test_wall_normal_points_left() -> None:
    assert Wall((0, 0), (10, 0)).normal == (0, 1)
    assert Wall((0, 0), (10, 0)).middle == (5, 0)


NAN, INF = math.nan, math.inf


@pytest.mark.parametrize("radius", [0, -1, NAN, INF, "1", None, True])
@pytest.mark.parametrize("kind", [Circle, Particle])
def test_bad_radius(kind: type, radius: Any) -> None:
    with pytest.raises((ValueError, TypeError), match="radius must be"):
        kind(radius)


@pytest.mark.parametrize(
    ("vertices", "says"),
    [
        ([(0, 0), (1, 0)], "at least 3 different vertices, not 2"),
        ([(0, 0), (1, 0), (1, 0), (0, 0)], "at least 3 different vertices, not 2"),
        ([(0, 0), (1, 1), (2, 2)], "on one line"),
        ([(0, 0), (4, 0), (4, 4), (2, 1), (0, 4)], "convex"),
        ([(0, 0), (1, 0), (0, NAN)], r"vertices\[2\]\[1\] must be finite, not nan"),
        ([(0, 0), (1, 0), (INF, 1)], r"vertices\[2\]\[0\] must be finite, not inf"),
        ([(0, 0), (1, 0), (0, 1, 2)], "pair of numbers, not 3"),
        ([(0, 0), (1, 0), 7], "pair of numbers, not 7"),
    ],
)
def test_bad_polygons(vertices: list[Any], says: str) -> None:
    with pytest.raises((ValueError, TypeError), match=says):
        Polygon(vertices)


@pytest.mark.parametrize(("sides", "radius"), [(2, 1), (5.5, 1), ("5", 1), (5, 0), (5, NAN)])
def test_bad_regular_polygons(sides: Any, radius: Any) -> None:
    with pytest.raises((ValueError, TypeError), match=r"sides|radius"):
        Polygon.regular(sides, radius)


@pytest.mark.parametrize(
    ("start", "end"), [((1, 2), (1, 2)), ((NAN, 0), (1, 1)), ((0, 0), (INF, 1)), (3, (1, 1))]
)
def test_bad_walls(start: Any, end: Any) -> None:
    with pytest.raises((ValueError, TypeError), match=r"wall|start|end"):
        Wall(start, end)


@pytest.mark.parametrize("vertices", [None, 3, "abc"])
def test_vertices_that_are_no_list_are_named(vertices: Any) -> None:
    with pytest.raises(TypeError, match=f"vertices must be pairs of numbers, not {vertices!r}"):
        Polygon(vertices)


def sampled(shape: Any, spacing: float) -> tuple[float, float, float, float]:
    """Area, centroid and moment of inertia for 1 kg by a fine grid of points: no formula at all."""
    reach = max(math.dist(p, (0, 0)) for line in outlines(shape) for p in line)
    steps = np.arange(-reach, reach, spacing) + spacing / 2
    x, y = (grid.ravel() for grid in np.meshgrid(steps, steps))
    inside = np.zeros(len(x), bool)
    for piece in shape.pieces:
        near = np.full(len(x), np.inf)
        within = np.full(len(x), len(piece.corners) > 2)
        for i, start in enumerate(piece.corners):
            end = piece.corners[(i + 1) % len(piece.corners)]
            way = np.array([end.x - start.x, end.y - start.y])
            along = (x - start.x) * way[0] + (y - start.y) * way[1]
            share = np.clip(along / (way @ way), 0, 1) if way.any() else np.zeros(len(x))
            distance = (x - start.x - share * way[0]) ** 2 + (y - start.y - share * way[1]) ** 2
            near = np.minimum(near, distance)
            within &= way[0] * (y - start.y) - way[1] * (x - start.x) >= 0
        inside |= within | (near <= piece.radius**2)
    x, y = x[inside], y[inside]
    return len(x) * spacing**2, x.mean(), y.mean(), (x * x + y * y).mean()


MOVABLE = [
    Box(1.2, 0.7),
    Box(1.0, 0.5, rounding=0.3),
    Capsule(1.0, 0.4),
    Polygon([(0, 0), (3, 0), (0, 1)], rounding=0.25),
    Polygon.regular(5, 1.0, rounding=0.1),
    Polygon.concave([(0, 0), (2, 0), (2, 1), (1, 1), (1, 3), (0, 3)]),
    Polygon.concave([(0, 0), (3, 2), (0, 1), (-3, 2)]),
    Compound([(Circle(0.5), (-1, 0.2)), (Polygon.box(1, 2), (0.7, 0), 0.6)]),
    Compound([Compound([(Capsule(1, 0.2), (0, 2), 1.0)]), (Box(1, 1, 0.1), (0, -2))]),
]


@pytest.mark.parametrize("shape", MOVABLE)
def test_area_centroid_and_inertia_are_those_of_the_points_inside(shape: Any) -> None:
    area, x, y, turning = sampled(shape, 0.004)
    assert shape.area == pytest.approx(area, rel=3e-3)
    assert (x, y) == pytest.approx((0, 0), abs=3e-3)
    assert shape.inertia(1.0) == pytest.approx(turning, rel=4e-3)


def test_capsules_and_rounded_boxes_agree() -> None:
    """A box without height, rounded, is a capsule."""
    thin = Box(2.0, 1e-12, rounding=0.5)
    assert thin.area == pytest.approx(Capsule(2.0, 0.5).area)
    assert thin.inertia(1.0) == pytest.approx(Capsule(2.0, 0.5).inertia(1.0))
    assert Box(2, 3).inertia(6) == Polygon.box(2, 3).inertia(6)
    assert Box(2, 3, 0.1).inertia(6) == pytest.approx(Polygon.box(2, 3, 0.1).inertia(6))


def test_masses_of_parts_may_be_given() -> None:
    """Two points of 1 kg and 3 kg: the centre divides the way 3 to 1; Steiner's theorem."""
    parts = [(Circle(0.1), (0, 0)), (Circle(0.1), (4, 0))]
    shape = Compound(parts, masses=[1, 3])
    assert shape.centroid == pytest.approx((3, 0))
    assert shape.inertia(4.0) == pytest.approx(1 * 9 + 3 * 1 + 4 * 0.1**2 / 2)
    assert Compound(parts).centroid == pytest.approx((2, 0))


@given(
    radii=st.lists(st.floats(0.3, 3.0), min_size=4, max_size=40),
    start=st.floats(0, 6),
    clockwise=st.booleans(),
)
def test_a_star_is_divided_into_convex_parts_without_loss(
    radii: list[float], start: float, clockwise: bool
) -> None:
    turn = math.tau / len(radii)
    star = [
        (r * math.cos(start + i * turn), r * math.sin(start + i * turn))
        for i, r in enumerate(radii)
    ]
    shape = Polygon.concave(star[::-1] if clockwise else star)
    areas = []
    for part in shape.parts:
        n = len(part)
        turns = [cross(part[i], part[(i + 1) % n], part[(i + 2) % n]) for i in range(n)]
        assert min(turns) > 0
        areas.append(sum(cross(part[0], b, c) for b, c in pairwise(part[1:])) / 2)
    assert math.fsum(areas) == pytest.approx(shape.area)
    assert len(shape.parts) < len(radii)


def test_a_convex_polygon_is_one_part_of_a_concave_one() -> None:
    assert len(Polygon.concave([(0, 0), (2, 0), (2, 2), (1, 2), (0, 2)]).parts) == 1
    assert len(Polygon.concave([(0, 0), (2, 0), (2, 1), (1, 1), (1, 3), (0, 3)]).parts) == 2


def test_many_vertices() -> None:
    assert Polygon.regular(4096, 1.0).area == pytest.approx(math.pi, rel=1e-5)
    with pytest.raises(ValueError, match="sides must be at most 4096, not 1000000"):
        Polygon.regular(10**6, 1.0)
    with pytest.raises(ValueError, match="vertices must be at most 4096, but there are more"):
        Polygon((math.cos(i), math.sin(i)) for i in count())
    gear = [(math.cos(i / 80) * (1 + i % 2), math.sin(i / 80) * (1 + i % 2)) for i in range(400)]
    assert len(Polygon.concave(gear).parts) < 400


def test_chains_drop_points_that_repeat() -> None:
    chain = Chain([(0, 0), (0, 0), (1, 0), (1, 1), (0, 0)], loop=True)
    assert chain.points == ((0, 0), (1, 0), (1, 1))
    assert [(piece.before, piece.after) for piece in chain.pieces] == [(3, 2), (1, 3), (2, 1)]
    open_chain = Chain([(0, 0), (1, 0), (1, 1)])
    assert [(piece.before, piece.after) for piece in open_chain.pieces] == [(0, 2), (1, 0)]


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: Box(0, 1), "width must be greater than zero, not 0.0"),
        (lambda: Box(1, NAN), "height must be finite, not nan"),
        (lambda: Box(1, 1, -0.1), "rounding must not be negative, not -0.1"),
        (lambda: Polygon.box(1, 1, rounding=INF), "rounding must be finite, not inf"),
        (lambda: Capsule(-1, 1), "length must be greater than zero, not -1.0"),
        (lambda: Capsule(1, "x"), "radius must be a number, not 'x'"),
        (lambda: Chain([(0, 0)]), "a chain needs at least 2 different points, not 1"),
        (lambda: Chain([(0, 0), (1, 0)], loop=True), "at least 3 different points, not 2"),
        (lambda: Chain([(0, 0), (0, 0)]), "at least 2 different points, not 1"),
        (lambda: Chain(None), "points must be pairs of numbers, not None"),
        (lambda: Chain([(0, 0), (1, NAN)]), r"points\[1\]\[1\] must be finite, not nan"),
        (lambda: Chain([(0, 0), (1, 0)], one_sided=3), "one_sided must be True or False, not 3"),
        (lambda: Chain([(0, 0), (1, 0)], loop="no"), "loop must be True or False, not 'no'"),
        (lambda: Wall((0, 0), (1, 0), one_sided=None), "one_sided must be True or False"),
        (lambda: Compound([]), "a compound needs at least one part"),
        (lambda: Compound(Circle(1)), "parts must be a sequence, not Circle"),
        (lambda: Compound([Particle(1)]), r"parts\[0\] must be a Circle, .* not Particle"),
        (lambda: Compound([(Circle(1), (0, NAN))]), r"parts\[0\] offset\[1\] must be finite"),
        (lambda: Compound([(Circle(1), (0, 0), INF)]), r"parts\[0\] angle must be finite"),
        (lambda: Compound([Circle(1)], masses=[0]), r"masses\[0\] must be greater than zero"),
        (lambda: Compound([Circle(1)], masses=[1, 2]), "masses must be 1, one a part, not 2"),
        (lambda: Polygon.concave([(0, 0), (1, 0)]), "at least 3 different vertices, not 2"),
        (lambda: Polygon.concave([(0, 0), (1, 1), (2, 2)]), "lie on one line"),
        (lambda: Polygon.concave([(0, 0), (2, 2), (2, 0), (0, 2)]), "must not cross or touch"),
        (lambda: Polygon.concave([(0, 0), (4, 0), (4, 2), (2, 0), (0, 2)]), "cross or touch"),
        (lambda: Polygon.concave([(0, 0), (2, 0), (1, 0), (1, 1)]), "fold back|cross or touch"),
        (lambda: Compound([Circle(1e-200)]), "an area that can be computed, not 0.0"),
        (lambda: World().add(Capsule(1e-200, 1e-200)), "beyond what can be computed"),
        (lambda: World().add(Capsule(1e200, 1e200)), "beyond what can be computed"),
        (lambda: World().add(Box(1e-200, 1e-200)), "beyond what can be computed"),
        (lambda: Polygon.box(1e-200, 1e-200), "area that can be computed|at least 3|one line"),
        (lambda: Polygon.concave("abc"), "vertices must be pairs of numbers, not 'abc'"),
        (lambda: Polygon(None), "vertices must be pairs of numbers, not None"),
        (lambda: Polygon.concave([(0, i) for i in range(2000)]), "must be at most 1000"),
    ],
)
def test_bad_shapes(make: Callable[[], Any], says: str) -> None:
    with pytest.raises((ValueError, TypeError), match=says):
        make()


def test_outlines_go_round_and_vertices_stand_in_the_world() -> None:
    world = World()
    capsule = world.add(Capsule(2, 0.5), position=(1, 1), angle=math.pi / 2)
    (line,) = capsule.outlines
    assert max(y for _, y in line) == pytest.approx(2.5)
    assert min(x for x, _ in line) == pytest.approx(0.5)
    assert capsule.vertices == ()
    concave = world.add(Polygon.concave([(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (0, 2)]))
    assert len(concave.vertices) == 6
    assert concave.outlines == (concave.vertices,)
    pair = world.add(Compound([(Circle(1), (-2, 0)), (Box(1, 1), (2, 0))]), position=(0, 5))
    assert len(pair.outlines) == 2
    ring = world.add(Chain([(0, 0), (1, 0), (1, 1)], loop=True))
    assert ring.outlines == (((0, 0), (1, 0), (1, 1), (0, 0)),)
    assert ring.vertices == ((0, 0), (1, 0), (1, 1))
    assert ring.is_wall
    assert ring.position == (0.5, 0.5)


def test_a_body_of_many_pieces_may_be_removed_saved_and_put_back() -> None:
    """Rows of pieces, corners and pairs follow when a body before them leaves."""

    def fill(world: World) -> Body:
        world.add(Chain([(-3, 3), (-3, 0), (3, 0), (3, 3)]), friction=0.5)
        first = world.add(Compound([(Circle(0.2), (-0.4, 0)), Box(0.8, 0.1)]), position=(0, 2))
        world.add(Chain([(-1, 0.2), (0, 0.4), (1, 0.2)]), friction=0.5)
        star = [
            (math.cos(i * 0.6283) * (1 + i % 2) / 3, math.sin(i * 0.6283) * (1 + i % 2) / 3)
            for i in range(10)
        ]
        world.add(Polygon.concave(star), position=(1.5, 1), friction=0.5)
        world.add(Capsule(0.5, 0.2), position=(-1.5, 1), friction=0.5)
        return first

    world = World(gravity=(0, -9.81))
    first = fill(world)
    for _ in range(40):
        world.step()
    saved, data = world.snapshot(), world.to_dict()
    first_ends = []
    for _ in range(2):
        world.remove(first)
        for _ in range(40):
            world.step()
        first_ends.append(world.digest())
        world.restore(saved)
    other = World.from_dict(data)
    other.remove(other.body(first.id))
    for _ in range(40):
        other.step()
    assert first_ends == [other.digest()] * 2


def test_what_is_computed_of_alike_shapes_is_computed_once() -> None:
    assert Polygon.box(1, 2) is Polygon.box(1.0, 2)
    assert Polygon.regular(5, 1) is Polygon.regular(5, 1.0)
    assert Box(1, 2).pieces is Box(1.0, 2).pieces
    assert Circle(0.5).pieces is Circle(0.5).pieces
    assert Box(1, 2).pieces != Box(2, 1).pieces
    assert Polygon.box(1, 2, rounding=0.1) != Polygon.box(1, 2)


def test_a_subclass_gets_shapes_of_its_own() -> None:
    class Plate(Polygon):
        pass

    assert type(Plate.box(1, 2)) is Plate
    assert type(Polygon.box(1, 2)) is Polygon


def test_zero_has_one_sign_so_that_shapes_do_not_depend_on_which_was_first() -> None:
    assert repr(Box(1, 1, rounding=-0.0)) == repr(Box(1, 1))
    assert math.copysign(1.0, Polygon.box(3, 4, rounding=-0.0).rounding) == 1.0
    assert math.copysign(1.0, Box(3, 4, rounding=-0.0).pieces[0].radius) == 1.0
