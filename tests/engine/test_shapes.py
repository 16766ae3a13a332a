"""Shapes: geometry, moments of inertia, and what is refused."""

import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine import Circle, Particle, Polygon, Wall


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
