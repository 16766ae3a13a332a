"""Sine and cosine of many angles, side by side: sums and products only, which a processor computes
of several at once. They are those of the library but for a unit in the last place.

An angle less a whole number n of half turns is at most a quarter turn (in three steps, of which the
first two are exact: Cody and Waite, "Software Manual for the Elementary Functions", 1980); there
Taylor's series are exact to rounding, and an odd n changes both signs.
"""

MANY_TURNS = 1e6
"""Up to this angle (rad) n times the first two pieces of pi is exact."""

WHOLE = 6755399441055744.0
"""Adding 1.5 * 2^52 and taking it away again rounds to a whole number."""

HALF_TURNS = 0.3183098861837907
"""1/pi (1/rad)"""

PI_0 = 3.1415926534682512
"""pi to 33 bits,"""

PI_1 = 1.2154201012607932e-10
"""what is left of it to 33 bits,"""

PI_2 = 4.044532497591901e-21
"""and what is left of that (rad)."""


def turned(angle: float) -> tuple[float, float]:
    """Cosine and sine of an angle (rad) of less than `MANY_TURNS`."""
    half_turns = (angle * HALF_TURNS + WHOLE) - WHOLE
    rest = ((angle - half_turns * PI_0) - half_turns * PI_1) - half_turns * PI_2
    turns = (half_turns * 0.5 + WHOLE) - WHOLE
    sign = 1.0 - 4.0 * abs(half_turns * 0.5 - turns)
    s = rest * rest
    cos = 1.0 + s * (
        -1.0 / 2.0
        + s * (1.0 / 24.0
        + s * (-1.0 / 720.0
        + s * (1.0 / 40320.0
        + s * (-1.0 / 3628800.0
        + s * (1.0 / 479001600.0
        + s * (-1.0 / 87178291200.0
        + s * (1.0 / 20922789888000.0
        + s * (-1.0 / 6402373705728000.0
        + s * (1.0 / 2432902008176640000.0)))))))))
    )  # fmt: skip
    sin = rest * (1.0 + s * (
        -1.0 / 6.0
        + s * (1.0 / 120.0
        + s * (-1.0 / 5040.0
        + s * (1.0 / 362880.0
        + s * (-1.0 / 39916800.0
        + s * (1.0 / 6227020800.0
        + s * (-1.0 / 1307674368000.0
        + s * (1.0 / 355687428096000.0
        + s * (-1.0 / 121645100408832000.0
        + s * (1.0 / 51090942171709440000.0)))))))))
    ))  # fmt: skip
    return sign * cos, sign * sin
