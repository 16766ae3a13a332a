"""Arrows: where they leave a body, and one round scale for all of them."""

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from screens.kit import arrows
from screens.kit.geometry import Point

SQUARE = [Point(-2, -1), Point(2, -1), Point(2, 1), Point(-2, 1)]
finite = st.floats(-100, 100)


def test_a_ray_leaves_a_circle_at_its_radius():
    assert arrows.leave_circle(Point(1, 2), 5, Point(3, 4)) == pytest.approx((4, 6))
    assert arrows.leave_circle(Point(1, 2), 5, Point(0, 0)) == (1, 2)


@given(st.floats(0, 2 * math.pi))
def test_a_ray_leaves_a_rectangle_on_its_outline(angle):
    x, y = arrows.leave_polygon(Point(0, 0), SQUARE, Point(math.cos(angle), math.sin(angle)))
    assert max(abs(x) / 2, abs(y)) == pytest.approx(1)
    assert math.cos(angle) * y == pytest.approx(math.sin(angle) * x, abs=1e-9)


def test_the_parts_of_an_arrow_stand_square():
    arrow = arrows.shape(Point(0, 0), Point(100, 0), 4)
    assert arrow is not None
    assert arrow.neck == (88, 0)
    assert sorted(arrow.wings) == [(88, -6), (88, 6)]


@given(finite, finite, st.floats(0.5, 10))
def test_an_arrow_always_keeps_a_shaft(x, y, width):
    length = math.sqrt(x * x + y * y)
    assume(length > 1e-3)
    arrow = arrows.shape(Point(0, 0), Point(x, y), width)
    assert arrow is not None
    head = math.dist(arrow.neck, arrow.tip)
    assert head <= length / arrows.SHORTEST * (1 + 1e-9)
    assert arrow.width <= width


def test_no_length_no_arrow():
    assert arrows.shape(Point(1, 1), Point(1, 1), 4) is None
    assert arrows.shape(Point(1, 1), Point(math.nan, 1), 4) is None
