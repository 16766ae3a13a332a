"""Two points of a joined pair meet at once, and joints hold one of them: it takes no part.

Their equations were singular but for rounding: k12 and k22 of 1e-14 1/kg passed for two points
alike, and an impulse of 1e14 N s threw a bridge of links apart with 4e22 J.
"""

import pytest

from engine.kernels.impulses import split


@pytest.mark.parametrize(("k12", "k22"), [(1.3e-14, -2.7e-14), (1.3e-14, 0.0), (-1e-14, 1e-14)])
def test_what_joints_hold_takes_no_part(k12: float, k22: float) -> None:
    """The other takes all: p = v1/k11."""
    assert split(118.5, k12, k22, 1.5, 0.04) == (0.0, 1.5 / 118.5)


def test_points_that_yield_alike_share_it() -> None:
    """k11 p1 + k12 p2 = v1 and k12 p1 + k22 p2 = v2, by hand: p1 = p2 = 0.2."""
    share, total = split(3.0, 2.0, 3.0, 1.0, 1.0)
    assert (share, total) == pytest.approx((0.5, 0.4))
    assert split(2.0, 2.0, 2.0, 1.0, 1.0) == (0.5, 0.5)
