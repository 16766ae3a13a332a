"""How fast joints that gape close: hands tore them, or they found no solution in a part.

That is done without hurry, and without violence. A shallow arc of links closes a gap along itself
only if the links rise many times as fast. To first order, closing gaps at rates r takes the energy
r^T A^-1 r / 2 (`skyline`); where that is more than if all bodies went as fast as gaps close, all
gaps close more slowly.
"""

from engine.linkage.modes import CLOSING, TIGHT, coordinate_row, drives, is_angle, scale_of
from engine.linkage.skyline import solve
from engine.tables import Tables

GENTLE = 0.5
"""Share of that energy that closing gaps may take: the rest is for what they close beyond first
order."""


def note_closings(t: Tables, part: float) -> None:
    """Set by how much each row may close in a part (s), for equations that have been factorised."""
    closes = t.equations.closes
    gapes = False
    for brace in range(t.braces.sizes[0]):
        joint = t.braces.joint[brace]
        first = t.braces.first[brace]
        for row in range(first, first + t.braces.rows[brace]):
            scale = scale_of(t, row, joint)
            closes[row] = CLOSING * scale * part
            if abs(rate_of_closing(t, brace, row, part)) * part > TIGHT * scale:
                gapes = True
    if not gapes:
        return
    closing, turning = rates_of_closing(t, part)
    energy = energy_of_closing(t, part)
    most = GENTLE * energy_of_all(t, closing, turning)
    if energy > most:
        share = most / energy  # not its root: what rises a lot keeps some of that, as it turns
        for row in range(t.braces.sizes[2]):
            closes[row] *= share


def rate_of_closing(t: Tables, brace: int, row: int, part: float) -> float:
    """How fast the gap of a row is to close in a part (s), if nothing hinders it (m/s, rad/s);
    what hands, springs and motors do is not counted.
    """
    joint = t.braces.joint[brace]
    gap = t.equations.start[row]
    if row == coordinate_row(t, brace):
        if drives(t, joint, row):
            return 0.0
        gap = t.joints.astray[joint]
    most = CLOSING * scale_of(t, row, joint)
    rate = gap / part
    if rate > most:
        return most
    return rate if rate > -most else -most


def rates_of_closing(t: Tables, part: float) -> tuple[float, float]:
    """How fast gaps of joints, trees of hinges apart, close in a part (s) at most (m/s, rad/s)."""
    closing = 0.0
    turning = 0.0
    for brace in range(t.braces.sizes[0]):
        first = t.braces.first[brace]
        for row in range(first, first + t.braces.rows[brace]):
            rate = abs(rate_of_closing(t, brace, row, part))
            if is_angle(t, row):
                turning = rate if rate > turning else turning
            else:
                closing = rate if rate > closing else closing
    return closing, turning


def energy_of_closing(t: Tables, part: float) -> float:
    """Twice the energy that closing all gaps at those rates takes, to first order (J)."""
    unknown = t.equations.unknown
    for brace in range(t.braces.sizes[0]):
        first = t.braces.first[brace]
        for row in range(first, first + t.braces.rows[brace]):
            unknown[row] = rate_of_closing(t, brace, row, part)
    solve(t)
    energy = 0.0
    for brace in range(t.braces.sizes[0]):
        first = t.braces.first[brace]
        for row in range(first, first + t.braces.rows[brace]):
            energy += unknown[row] * rate_of_closing(t, brace, row, part)
    return energy


def energy_of_all(t: Tables, closing: float, turning: float) -> float:
    """Twice the energy of all joined bodies if they went as fast as that (m/s, rad/s) (J)."""
    bodies = t.bodies
    energy = 0.0
    for node in range(1, t.braces.sizes[1]):
        row = t.nodes.body[node]
        if bodies.inverse_mass[row] > 0.0:
            reach = bodies.reach[row] * turning
            energy += bodies.mass[row] * (closing * closing + reach * reach)
    return energy
