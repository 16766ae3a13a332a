"""The spring of a resting contact: how stiff it is, and how far a load presses it."""

import math

from engine.tables import Tables

DAMPING = 10.0
"""Damping ratio of the spring: overlaps creep apart and never swing."""

RESTLESS = 4.0
"""So many times more is it damped in a crowd that is restless. Sweeps are too few to take back at
once all that correcting overlaps has lent, and so a heap of 500 bodies could drive itself."""

PUSH = 0.25
"""Fastest correction of an overlap by a spring, in reaches of the smaller body a second (1/s)."""

SWING = 0.25
"""Part of a swing of the spring that a substep lasts, at most."""

MOST_HERTZ = 90.0
"""Frequency of the spring (1/s), for substeps that are short enough to follow it."""

SAG = 2e-3
"""Greatest overlap by the softness of the spring, in reaches of the smaller body: where a load
would press deeper, the spring is made stiffer."""


def frequency(substep: float) -> float:
    """Circular frequency of the spring (1/s) in a world of such substeps (s)."""
    hertz = SWING / substep
    if hertz > MOST_HERTZ:
        hertz = MOST_HERTZ
    return 2.0 * math.pi * hertz


def softness(part: float, omega: float, damping: float) -> tuple[float, float]:
    """Rate (1/s) at which overlaps are corrected, and share of the impulse that the spring drops.

    What is left of one is the share of the full mass with which it acts.
    """
    damped = 2.0 * damping + part * omega
    return omega / damped, 1.0 / (1.0 + part * omega * damped)


def load_on(t: Tables, pair: int) -> float:
    """The load of a contact: what it carried in its last part, or what forces press on it now
    (m/s^2).
    """
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    nx = t.pairs.normal_x[pair]
    ny = t.pairs.normal_y[pair]
    load = (bodies.ax[a] - bodies.ax[b]) * nx + (bodies.ay[a] - bodies.ay[b]) * ny
    if t.pairs.part[pair] > 0.0 and t.pairs.carried[pair] > load * t.pairs.part[pair]:
        load = t.pairs.carried[pair] / t.pairs.part[pair]
    return load


def softness_left(t: Tables, pair: int, omega: float) -> float:
    """Share of its softness that a contact may have under its load, 0..1.

    A spring of circular frequency w yields to a load (m/s^2) by load / w^2.
    """
    load = load_on(t, pair)
    most = SAG * t.pairs.size[pair] * omega * omega
    return 1.0 if load <= most else most / load


def sag(t: Tables, pair: int) -> float:
    """Overlap by which the spring of a contact may yield to its load, if it bears any (m)."""
    return SAG * t.pairs.size[pair] if load_on(t, pair) > 0.0 else 0.0


def set_spring(
    t: Tables,
    pair: int,
    row: int,
    part: float,
    rate: float,
    soft: float,
    parting: bool,
    curls: float,
) -> None:
    """Let one point of a contact act for a part (s) as a spring, or rigidly if it gapes or is
    `parting`; see `resting.prepare`.

    Where the surface `curls` away from a straight path, or towards it if negative, by so much speed
    until the middle of the part (m/s), the bodies leave each other as fast as they approached, so
    that on the whole they keep their distance; what that lends is relaxed at the end.
    """
    contacts = t.contacts
    gap = contacts.gap[row] - curls * part / 4.0  # without what it curls, in half the part
    if gap > 0.0 or parting:  # may close until the end of the part, but no faster
        contacts.target[row] = (2.0 * gap / part if gap > 0.0 else 0.0) + curls
        contacts.hardness[row] = contacts.normal_mass[row]
        contacts.softness[row] = 0.0
        return
    bias = rate * gap
    fastest = -PUSH * t.pairs.size[pair]
    contacts.target[row] = (bias if bias > fastest else fastest) + curls
    contacts.hardness[row] = contacts.normal_mass[row] * (1.0 - soft)
    contacts.softness[row] = soft
