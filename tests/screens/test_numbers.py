"""Numbers on the screen."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from screens.kit.numbers import number, quantity
from screens.kit.page import chosen


@pytest.mark.parametrize(
    ("value", "unit", "digits", "words"),
    [
        (1.5, "m/s", 2, "1.50\u2009m/s"),
        (-1.5, "m/s", 1, "\u22121.5\u2009m/s"),
        (0.0, "N", 1, "0.0\u2009N"),
        (-0.0, "N", 1, "0.0\u2009N"),
        (-0.04, "N", 1, "0.0\u2009N"),
        (-0.06, "N", 1, "\u22120.1\u2009N"),
        (30, "°", 1, "30.0°"),
        (-0.4, "", 0, "0"),
        (1e6, "J", 0, "1000000\u2009J"),
        (math.nan, "s", 2, "–\u2009s"),
        (-math.inf, "m", 2, "\u2212∞\u2009m"),
    ],
)
def test_examples(value, unit, digits, words):
    assert quantity(value, unit, digits) == words


@given(st.floats(-1e9, 1e9), st.integers(0, 6))
def test_what_is_read_back_is_the_rounded_number(value, digits):
    words = number(value, digits)
    assert float(words.replace("\u2212", "-")) == pytest.approx(
        value, abs=0.5001 * 10**-digits + 4e-16 * abs(value)
    )
    assert "-" not in words
    assert words.strip("\u22120.") or "\u2212" not in words


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (2.0, "2.0"),
        (31.875, "31.875"),
        (1 / 3, "0.333"),
        (0.0, "0.0"),
        (0.001, "0.001"),
        (0.0004, "0.0004"),
        (0.513 * 0.001, "0.00051"),
        (0.501 * 0.01, "0.00501"),
    ],
)
def test_a_chosen_number_is_shown_as_it_is(value, words):
    """A mass of 0.513 kg at 0.001 m/s^2 needs half a thousandth of a newton, not a whole one."""
    assert chosen(value, "") == words
