"""Sine, cosine and exponential by sums and products only: the same bits on every machine.

Those of C libraries differ in the last bit between systems, and between processors. These err by no
more than two units in the last place. The argument is reduced in steps of which the first are
exact (Cody and Waite, "Software Manual for the Elementary Functions", 1980) to where Taylor's
series are exact to rounding.
"""

import math

FULL_TURN = 2.0 * math.pi

MANY_TURNS = 1e6
"""Up to this angle (rad) the number of quarter turns times the first two pieces is exact."""

WHOLE = 6755399441055744.0
"""Adding 1.5 * 2^52 and taking it away again rounds to a whole number."""

QUARTERS = 0.6366197723675814
"""2/pi (1/rad)"""

QUARTER_0 = 1.5707963267341256
"""pi/2 to 33 bits,"""

QUARTER_1 = 6.077100506303966e-11
"""what is left of it to 33 bits,"""

QUARTER_2 = 2.0222662487959506e-21
"""and what is left of that (rad)."""

DOUBLINGS = 1.4426950408889634
"""1/ln 2"""

LN2_0 = 0.6931471804855391
"""ln 2 to 33 bits,"""

LN2_1 = 7.440617110012397e-11
"""and what is left of it."""

NOTHING = -746.0
"""e to the power of less is zero."""


def cos_sin(angle: float) -> tuple[float, float]:
    """Cosine and sine of any angle (rad)."""
    if abs(angle) < MANY_TURNS:
        return turned(angle)
    rest = abs(angle) % FULL_TURN  # exact, and 2 pi errs less than the angle does
    return turned(rest if angle > 0.0 else -rest)


def turned(angle: float) -> tuple[float, float]:
    """The same for an angle of less than `MANY_TURNS`, without branches: a processor does several
    side by side.
    """
    quarters = (angle * QUARTERS + WHOLE) - WHOLE
    rest = ((angle - quarters * QUARTER_0) - quarters * QUARTER_1) - quarters * QUARTER_2
    s = rest * rest
    cos = 1.0 + s * (
        -1.0 / 2.0
        + s * (1.0 / 24.0
        + s * (-1.0 / 720.0
        + s * (1.0 / 40320.0
        + s * (-1.0 / 3628800.0
        + s * (1.0 / 479001600.0
        + s * (-1.0 / 87178291200.0
        + s * (1.0 / 20922789888000.0)))))))
    )  # fmt: skip
    sin = rest + rest * (s * (
        -1.0 / 6.0
        + s * (1.0 / 120.0
        + s * (-1.0 / 5040.0
        + s * (1.0 / 362880.0
        + s * (-1.0 / 39916800.0
        + s * (1.0 / 6227020800.0
        + s * (-1.0 / 1307674368000.0
        + s * (1.0 / 355687428096000.0)))))))
    ))  # fmt: skip
    quarter = quarters - 4.0 * ((quarters * 0.25 + WHOLE) - WHOLE)  # -2, -1, 0, 1 or 2
    even = abs(abs(quarter) - 1.0) > 0.5
    x = cos if even else sin
    y = sin if even else cos
    return (x if abs(quarter + 0.5) < 1.0 else -x), (y if abs(quarter - 0.5) < 1.0 else -y)


def exponential(x: float) -> float:
    """Euler's number to the power of one that is not positive."""
    if x < NOTHING:
        return 0.0
    doublings = (x * DOUBLINGS + WHOLE) - WHOLE
    r = (x - doublings * LN2_0) - doublings * LN2_1
    power = 1.0 + (r + r * r * (
        1.0 / 2.0
        + r * (1.0 / 6.0
        + r * (1.0 / 24.0
        + r * (1.0 / 120.0
        + r * (1.0 / 720.0
        + r * (1.0 / 5040.0
        + r * (1.0 / 40320.0
        + r * (1.0 / 362880.0
        + r * (1.0 / 3628800.0
        + r * (1.0 / 39916800.0
        + r * (1.0 / 479001600.0
        + r * (1.0 / 6227020800.0)))))))))))
    ))  # fmt: skip
    return math.ldexp(power, int(doublings))
