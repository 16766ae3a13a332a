"""Queries: closed forms for each shape, and brute force that knows nothing of the method."""

import math
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine import Body, Circle, Particle, Polygon, Vector, Wall, World

ROOT = math.sqrt(0.5)
NAN, INF = math.nan, math.inf


def near(x: float, y: float) -> Any:
    return pytest.approx((x, y), abs=1e-12)


def room() -> tuple[World, Body, Body, Body, Body]:
    """A disc, a turned square (a diamond), a wall and a one-sided wall, on one horizontal line."""
    world = World()
    disc = world.add(Circle(1.0), position=(3, 0), category=1)
    diamond = world.add(Polygon.box(2, 2), position=(8, 0), angle=math.pi / 4, category=2)
    wall = world.add(Wall((12, -1), (12, 3)), category=4)
    gate = world.add(Wall((15, 1), (15, -1), one_sided=True), category=8)
    return world, disc, diamond, wall, gate


def test_a_ray_meets_all_bodies_on_its_way_in_order() -> None:
    world, disc, diamond, wall, gate = room()
    hits = world.cast_ray_through((0, 0), (20, 0))
    assert [hit.body for hit in hits] == [disc, diamond, wall]
    assert [hit.fraction for hit in hits] == pytest.approx([0.1, (8 - 2 * ROOT) / 20, 0.6])
    assert [hit.point.x for hit in hits] == pytest.approx([2, 8 - 2 * ROOT, 12])
    assert hits[0].normal == near(-1, 0)
    assert hits[2].normal == near(-1, 0)
    assert world.cast_ray((0, 0), (20, 0)) == hits[0]
    back = world.cast_ray_through((20, 0), (0, 0))
    assert [hit.body for hit in back] == [gate, wall, diamond, disc]
    assert [20 * hit.fraction for hit in back] == pytest.approx([5, 8, 12 - 2 * ROOT, 16])
    assert back[0].normal == near(1, 0)


def test_a_ray_that_ends_before_or_passes_by_meets_nothing() -> None:
    world, disc, _, _, _ = room()
    assert world.cast_ray((0, 0), (1.999, 0)) is None
    assert world.cast_ray((0, 1.001), (6, 1.001)) is None
    grazing = world.cast_ray((0, 1.0), (6, 1.0))
    assert grazing is not None
    assert grazing.body is disc
    assert grazing.point == near(3, 1)
    assert world.cast_ray((12, 4), (12, 3.5)) is None


def test_a_ray_that_starts_inside_hits_at_once() -> None:
    world, disc, _, _, _ = room()
    hit = world.cast_ray((3.5, 0), (20, 0))
    assert hit is not None
    assert (hit.body, hit.fraction, hit.point) == (disc, 0.0, (3.5, 0))
    assert hit.normal == near(1, 0)
    away = world.cast_ray((3.5, 0), (20, 0), leave_out=[disc])
    assert away is not None
    assert away.point == near(8 - 2 * ROOT, 0)


def test_masks_choose_bodies_by_their_category() -> None:
    world, _, diamond, wall, _ = room()
    assert [hit.body for hit in world.cast_ray_through((0, 0), (20, 0), mask=2 | 4)] == [
        diamond,
        wall,
    ]
    assert world.cast_ray((0, 0), (20, 0), mask=0) is None
    assert world.query_point((3, 0), mask=2) == []
    assert world.query_box((0, -9), (20, 9), mask=6) == [diamond, wall]
    nearest = world.nearest((3, 0), mask=4)
    assert nearest is not None
    assert (nearest.body, nearest.distance) == (wall, 9.0)


def test_a_ray_that_aims_at_a_corner_does_not_slip_through() -> None:
    world = World()
    for i in range(200):
        body = world.add(Polygon.regular(3 + i % 5, 1.0), position=(0.1 * i, 5 * i), angle=0.3 * i)
        corner = body.vertices[i % 3]
        middle = body.position
        start = Vector(3 * corner.x - 2 * middle.x, 3 * corner.y - 2 * middle.y)
        hit = world.cast_ray(start, middle, leave_out=[other for other in world if other != body])
        assert hit is not None
        assert hit.point == pytest.approx(corner, abs=1e-9)


def test_points_inside_and_on_the_surface() -> None:
    world, disc, diamond, wall, _ = room()
    assert world.query_point((4, 0)) == [disc]
    assert world.query_point((4.0001, 0)) == []
    assert world.query_point((8, 1.4142)) == [diamond]
    assert world.query_point((8.72, 0.72)) == []
    assert world.query_point((12, 1)) == [wall]
    over = world.add(Circle(0.5), position=(3, 0.2))
    assert world.query_point((3, 0)) == [disc, over]


def test_boxes_touch_surfaces_not_only_bounding_boxes() -> None:
    world, disc, diamond, _, _ = room()
    assert world.query_box((2, 0.5), (2.13, 1)) == []
    assert world.query_box((2, 0.5), (2.14, 1)) == [disc]
    assert world.query_box((8.75, 0.75), (9, 1)) == []
    assert world.query_box((8.7, 0.7), (9, 1)) == [diamond]
    assert world.query_box((2.9, -0.1), (3.1, 0.1)) == [disc]
    assert world.query_box((-50, -50), (50, 50)) == list(world)
    assert world.query_box((3, 0), (3, 0)) == [disc]


def test_the_nearest_surface() -> None:
    world, disc, diamond, wall, _ = room()
    found = world.nearest((0, 4))
    assert found is not None
    assert (found.body, found.distance) == (disc, 4.0)
    assert found.point == near(3 - 0.6, 0.8)
    assert found.normal == near(-0.6, 0.8)
    inside = world.nearest((8, 0))
    assert inside is not None
    assert inside.body is diamond
    assert inside.distance == pytest.approx(-1.0)
    assert math.dist(inside.point, (8, 0)) == pytest.approx(1.0)
    end = world.nearest((12, 5))
    assert end is not None
    assert (end.body, end.distance, end.point) == (wall, 2.0, (12, 3))
    assert world.nearest((0, 4), within=3.9) is None
    assert world.nearest((0, 4), within=4.1) == found
    assert World().nearest((0, 0)) is None


def test_a_shape_that_is_cast_stops_at_the_first_touch() -> None:
    world, disc, diamond, wall, gate = room()
    ball = world.cast_shape(Circle(0.5), (0, 0), (10, 0))
    assert ball is not None
    assert (ball.body, ball.fraction) == (disc, pytest.approx(0.15))
    assert ball.point == near(2, 0)
    past = world.cast_shape(Circle(0.5), (6, 10), (6, -10), leave_out=[disc])
    assert past is None or past.body is not disc
    flat = world.cast_shape(Polygon.box(1, 1), (10, 2), (14, 2))
    assert flat is not None
    assert (flat.body, flat.fraction) == (wall, pytest.approx(1.5 / 4))
    assert flat.point == near(12, 2)
    assert flat.normal == near(-1, 0)
    edge = world.cast_shape(Polygon.box(1, 1), (10, 3.25), (14, 3.25))
    assert edge is not None
    assert edge.point == near(12, 2.875)
    through = world.cast_shape(Circle(0.5), (13, 0), (18, 0))
    assert through is None
    stopped = world.cast_shape(Circle(0.5), (18, 0), (13, 0))
    assert stopped is not None
    assert (stopped.body, stopped.fraction) == (gate, pytest.approx(0.5))
    tip = world.cast_shape(Polygon.box(1, 1), (8, 5), (8, 0), angle=math.pi / 4)
    assert tip is not None
    assert tip.body is diamond
    assert tip.fraction == pytest.approx((5 - 3 * ROOT) / 5)
    assert tip.point == pytest.approx((8, 2 * ROOT), abs=1e-6)


def test_a_shape_that_touches_at_the_start_is_told_the_way_out() -> None:
    world, disc, _, _, _ = room()
    hit = world.cast_shape(Circle(0.5), (2, 0), (0, 0))
    assert hit is not None
    assert (hit.body, hit.fraction) == (disc, 0.0)
    assert hit.normal == near(-1, 0)


def test_queries_see_bodies_where_they_are_now() -> None:
    world, disc, _, _, _ = room()
    disc.velocity = (0, 60)
    world.step()
    assert world.query_point((3, 1.9)) == [disc]
    assert world.query_point((3, -0.5)) == []


POINTS = st.tuples(st.floats(-6, 6), st.floats(-6, 6))


def box_distance(body: Body, half_x: float, half_y: float) -> Callable[[Any], float]:
    """Signed distance from a box in closed form."""

    def distance(point: Any) -> float:
        local = body.to_local(point)
        x, y = abs(local.x) - half_x, abs(local.y) - half_y
        return math.sqrt(max(x, 0) ** 2 + max(y, 0) ** 2) + min(max(x, y), 0)

    return distance


@given(start=POINTS, end=POINTS, at=POINTS, angle=st.floats(-4, 4), radius=st.floats(0.1, 1.5))
def test_casts_agree_with_marching_along_the_ray(
    start: Any, end: Any, at: Any, angle: float, radius: float
) -> None:
    """Sphere tracing (Hart, 1996): steps as long as the distance from a box never pass it, though
    along a side that the ray nearly follows they take ever so many to get there.
    """
    world = World()
    body = world.add(Polygon.box(3, 1), position=at, angle=angle)
    distance = box_distance(body, 1.5, 0.5)
    nearest = world.nearest(start)
    assert nearest is not None
    assert nearest.distance == pytest.approx(distance(start), abs=1e-12)
    assert distance(nearest.point) == pytest.approx(0.0, abs=1e-12)
    way = math.dist(start, end)
    for thick, hit in (
        (0.0, world.cast_ray(start, end)),
        (radius, world.cast_shape(Circle(radius), start, end)),
        (radius, world.cast_shape(Particle(radius), start, end, angle=1.0)),
    ):
        gone, gap = 0.0, distance(start) - thick
        for _ in range(200):
            if gap < 1e-10 or gone > way:
                break
            gone += gap
            share = gone / way if way > 0 else 1.0
            here = [s + share * (e - s) for s, e in zip(start, end, strict=True)]
            gap = distance(here) - thick
        if hit is not None:
            assert distance(hit.point) <= 1e-9
            if hit.fraction > 0:
                there = [s + hit.fraction * (e - s) for s, e in zip(start, end, strict=True)]
                assert distance(there) - thick == pytest.approx(0.0, abs=1e-9)
                assert gone <= hit.fraction * way + 1e-9
                if gap < 1e-10:
                    assert hit.fraction * way == pytest.approx(gone, abs=1e-3)
        else:
            assert gap > -1e-9  # the end of the way may just touch


def overlap(one: list[Vector], other: list[Vector]) -> bool:
    """Separating axes, spelt out."""

    def axes(hull: list[Vector]) -> Iterator[tuple[float, float]]:
        for i, corner in enumerate(hull):
            yield corner.y - hull[i - 1].y, hull[i - 1].x - corner.x

    for x, y in [*axes(one), *axes(other)]:
        first = [p.x * x + p.y * y for p in one]
        second = [p.x * x + p.y * y for p in other]
        if max(first) < min(second) or max(second) < min(first):
            return False
    return True


@given(
    start=POINTS,
    end=POINTS,
    at=POINTS,
    angle=st.floats(-4, 4),
    turned=st.floats(-4, 4),
    sides=st.integers(3, 7),
)
def test_a_cast_polygon_touches_there_and_not_before(
    start: Any, end: Any, at: Any, angle: float, turned: float, sides: int
) -> None:
    world, shape = World(), Polygon.regular(sides, 0.7)
    body = world.add(Polygon.box(2, 1), position=at, angle=angle)
    ghost = World().add(shape, position=start, angle=turned)

    def overlaps(share: float) -> bool:
        ghost.position = [s + share * (e - s) for s, e in zip(start, end, strict=True)]
        return overlap(list(body.vertices), list(ghost.vertices))

    hit = world.cast_shape(shape, start, end, angle=turned)
    shares = [i / 50 for i in range(51)]
    small = 1e-6 / max(1e-3, math.dist(start, end))
    if hit is None:
        assert not any(overlaps(share) for share in shares)
    elif hit.fraction > 0:
        assert not any(overlaps(share) for share in shares if share < hit.fraction - small)
        assert not overlaps(max(0.0, hit.fraction - small))
        nearest = world.nearest(hit.point)
        assert nearest is not None
        assert abs(nearest.distance) < 1e-9
    else:
        assert overlaps(0.0)


@pytest.mark.parametrize(
    ("ask", "sentence"),
    [
        (lambda w: w.query_point((NAN, 0)), "point.0. must be finite, not nan"),
        (lambda w: w.query_point(3), "point must be a pair of numbers, not 3"),
        (lambda w: w.query_box((1, 0), (0, 1)), "low must not be beyond high"),
        (lambda w: w.query_box((1, 0), (INF, 1)), "high.0. must be finite, not inf"),
        (lambda w: w.cast_ray((0, 0), (0, "1")), "end.1. must be a number, not '1'"),
        (lambda w: w.cast_ray((0, 0, 0), (0, 1)), "start must be a pair of numbers, not 3 of them"),
        (lambda w: w.cast_ray((0, 0), (0, 1), mask=-1), "mask must be at least 0, not -1"),
        (lambda w: w.cast_ray((0, 0), (0, 1), leave_out=3), "leave_out must be a list of bodies"),
        (lambda w: w.cast_ray((0, 0), (0, 1), leave_out=[3]), "a list of bodies, not one of 3"),
        (lambda w: w.cast_shape(3, (0, 0), (0, 1)), "only a shape can be cast, not 3"),
        (lambda w: w.cast_shape(Wall((0, 0), (1, 1)), (0, 0), (0, 1)), "a wall is immovable"),
        (lambda w: w.cast_shape(Circle(1), (0, 0), (0, 1), angle=NAN), "angle must be finite"),
        (lambda w: w.nearest((0, 0), within=-1), "within must not be negative, not -1"),
    ],
)
def test_bad_questions_are_refused(ask: Callable[[World], Any], sentence: str) -> None:
    with pytest.raises((TypeError, ValueError), match=sentence):
        ask(room()[0])


@pytest.mark.parametrize("far", [0.0, 1e3, 1e6])
@pytest.mark.parametrize("size", [1e-3, 1.0])
def test_a_cast_shape_touches_with_its_corner_however_far_from_the_origin(
    far: float, size: float
) -> None:
    """A side that leans by 1e-4 was taken for flat at 1 km: its middle is no point of contact."""
    world = World()
    world.add(Polygon.box(2 * size, 2 * size), kind="static", position=(far, -far))
    lean = 1e-4
    hit = world.cast_shape(Polygon.box(size, size), (far, 3 * size - far), (far, -far), angle=lean)
    assert hit is not None
    corner = size * ROOT * math.sin(math.pi / 4 - lean)  # the left one of the lower two
    rounding = 1e-9 * size + 1e-9 * far / 1e6
    assert hit.point.x - far == pytest.approx(-corner, abs=rounding)
    assert hit.point.y + far == pytest.approx(size, abs=rounding)
