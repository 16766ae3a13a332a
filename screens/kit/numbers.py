"""Numbers as people read them: fixed digits, a real minus sign, no negative zero."""

import math

MINUS = "\u2212"
THIN_SPACE = "\u2009"
INFINITY = "\u221e"
UNKNOWN = "\u2013"
MOST_DIGITS, MOST_OF_SMALL = 3, 5
"""Decimals that a chosen number is shown with at most; one below 0.1 needs more."""
TIGHT_UNITS = ("°", "%")
"""Units that stand directly at the number."""


def number(value: float, digits: int = 0) -> str:
    """`value` rounded to `digits` decimals, with U+2212 as its sign; zero has no sign."""
    if math.isnan(value):
        return UNKNOWN
    if math.isinf(value):
        return INFINITY if value > 0 else MINUS + INFINITY
    words = f"{abs(value):.{digits}f}"
    is_zero = not words.strip("0.")
    return words if value >= 0 or is_zero else MINUS + words


def quantity(value: float, unit: str, digits: int = 0) -> str:
    """`number` and its unit, a thin space between: `quantity(-1.5, "m/s", 2)` is `−1.50 m/s`."""
    if not unit:
        return number(value, digits)
    gap = "" if unit in TIGHT_UNITS else THIN_SPACE
    return number(value, digits) + gap + unit


def digits_of(value: float) -> int:
    """With how many decimals a chosen number is shown: one, or as many as it has, up to a limit."""
    digits, most = 1, MOST_DIGITS if abs(value) >= 0.1 else MOST_OF_SMALL
    while digits < most and abs(round(value, digits) - value) > 1e-9:
        digits += 1
    return digits
