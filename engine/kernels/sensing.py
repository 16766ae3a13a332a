"""Sensors: they notice what overlaps them, and act on nothing.

What counts is where bodies stand when a tick is over. What came and went within the tick is noticed
as well, unless an impact in the very same part of the tick bent its path.
"""

from engine.kernels.searching import gap_at
from engine.kernels.touches import number_of_tick, touch
from engine.tables import SENSING, Tables


def sense_passing(t: Tables, pair_count: int, part: float) -> None:
    """Notice which sensors and bodies meet within a part of the tick (s)."""
    for pair in range(pair_count):
        if t.pairs.state[pair] == SENSING:
            sense(t, pair, part)


def sense(t: Tables, pair: int, part: float) -> None:
    """Notice whether the surfaces of a sensor and a body meet within a part of the tick (s).

    Steps are as long as the gap allows (conservative advancement), along the paths that both have
    when the part begins. Who touched in the tick before is looked at when the tick ends.
    """
    pairs = t.pairs
    if pairs.touched[pair] >= number_of_tick(t) - 1:
        return
    fastest = (t.bodies.way[pairs.a[pair]] + t.bodies.way[pairs.b[pair]]) / part
    gap = gap_at(t, pair, 0.0)
    if gap > fastest * part:
        return
    inner = t.pieces.inner[pairs.piece_a[pair]] + t.pieces.inner[pairs.piece_b[pair]]
    least = 0.25 * inner / fastest if fastest > 0.0 else part
    if least < part / 64.0:
        least = part / 64.0
    time = 0.0
    while gap > 0.0 and time < part:
        step = gap / fastest if gap > least * fastest else least
        time = time + step if time + step < part else part
        gap = gap_at(t, pair, time)
    if gap <= 0.0:
        touch(t, pair)


def sense_at_end(t: Tables, pair_count: int) -> None:
    """Note which sensors overlap with bodies where these stand when the tick is over."""
    for pair in range(pair_count):
        if t.pairs.state[pair] == SENSING and gap_at(t, pair, 0.0) <= 0.0:
            touch(t, pair)
