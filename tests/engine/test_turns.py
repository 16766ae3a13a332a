"""Sine and cosine by sums and products, against those of the library."""

import math

from hypothesis import given
from hypothesis import strategies as st

from engine.kernels.turns import MANY_TURNS, turned


@given(st.floats(-MANY_TURNS, MANY_TURNS))
def test_they_are_those_of_the_library(angle: float) -> None:
    cos, sin = turned(angle)
    assert abs(cos - math.cos(angle)) < 5e-16
    assert abs(sin - math.sin(angle)) < 5e-16


def test_no_turn_is_exact() -> None:
    assert turned(0.0) == (1.0, 0.0)
