import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.scenario.model import Comparison, ticks


@pytest.mark.parametrize(
    ("seconds", "count"),
    [
        (0, 0),
        (1, 60),
        (0.25, 15),
        (1 / 60, 1),
        (0.008, 0),  # 0.48 of a tick
        (0.009, 1),  # 0.54 of a tick
        (0.025, 2),  # 1.5 ticks: halves go up
        (0.175, 11),  # 10.5 ticks, though 0.175 * 60 < 10.5 in binary
        (0.1, 6),
        (3600, 216_000),
    ],
)
def test_times_are_rounded_to_the_nearest_tick(seconds, count):
    assert ticks(seconds) == count


@given(st.integers(0, 216_000))
def test_whole_ticks_stay_what_they_are(count):
    assert ticks(count / 60) == count


def test_equals_is_exact():
    assert Comparison(equals=0.3).holds(0.3)
    assert not Comparison(equals=0.3).holds(0.1 + 0.2)


def test_near_includes_its_ends():
    near = Comparison(near=2.0, tol=0.5)
    assert [near.holds(v) for v in (1.49, 1.5, 2, 2.5, 2.51)] == [False, True, True, True, False]


def test_above_and_below_exclude_their_ends():
    assert not Comparison(above=1).holds(1)
    assert Comparison(above=1).holds(math.nextafter(1, 2))
    assert not Comparison(below=1).holds(1)
    band = Comparison(above=1, below=2)
    assert [band.holds(v) for v in (1, 1.5, 2)] == [False, True, False]


def test_nothing_holds_for_what_is_not_a_number():
    for comparison in (Comparison(equals=0), Comparison(near=0, tol=9), Comparison(above=-9)):
        assert not comparison.holds(math.nan)
        assert comparison.distance(math.nan) == math.inf


def test_the_distance_says_how_far_a_value_is_from_holding():
    assert Comparison(equals=2).distance(5) == 3
    assert Comparison(near=2, tol=1).distance(5) == 3
    assert Comparison(near=2, tol=1).distance(2.5) == 0
    assert Comparison(above=2).distance(0.5) == 1.5
    assert Comparison(below=2).distance(2.5) == 0.5
    assert Comparison(above=1, below=2).distance(4) == 2


def test_comparisons_in_words():
    assert str(Comparison(equals=1)) == "equal to 1"
    assert str(Comparison(near=2, tol=0.01)) == "near 2 (tol 0.01)"
    assert str(Comparison(above=1, below=2.5)) == "above 1 and below 2.5"
