"""Motors that other joints leave no way: they stall, and do against these all that they can.

A lever that a motor turns until a rope is taut has no way left: the equation of the motor says
nothing that those of hinge and rope do not say. Whichever of them is eliminated last has no pivot
(`skyline`) and is not heeded: the motor would do nothing, or stretch the rope. Ropes and rods give
way to nothing, but motors do: what is left of them is their greatest effort, against which the
others hold. A motor without bounds that pulls at what cannot move contradicts it; either gives way.
"""

from engine.linkage.impulses import add, bounds_left
from engine.linkage.modes import BOUNDLESS, TIGHT, coordinate_row, scale_of
from engine.tables import Tables
from engine.tables.linkage import AT_HIGH, AT_LOW, DRIVEN, FIXED, STRAINED

SHARED = 1e-6
"""A motor has to do with an equation without pivot if that contains more of its own."""


def stall(t: Tables, part: float, share: float, spent: bool) -> bool:
    """Let one motor stall, if there is one that has to; return whether there was.

    All equations with a pivot are solved, and `unknown` says how fast the others ought to go on
    (m/s or rad/s); for `share` and `spent` see `impulses.take`.
    """
    equations = t.equations
    for brace in range(t.braces.sizes[0]):
        joint = t.braces.joint[brace]
        first = t.braces.first[brace]
        coordinate = coordinate_row(t, brace)
        for row in range(first, first + t.braces.rows[brace]):
            if equations.solved[row] == 0 or equations.inverse_pivot[row] > 0.0:
                continue
            ahead = -equations.unknown[row]
            if abs(ahead) * part <= TIGHT * scale_of(t, row, joint):
                continue
            if row == coordinate and t.joints.mode[joint] not in (FIXED, AT_LOW, AT_HIGH, DRIVEN):
                continue
            if row == coordinate and t.joints.mode[joint] == DRIVEN:
                if t.joints.effort[joint] < BOUNDLESS:
                    strain(t, brace, row, ahead, share, spent)
                    return True
            elif strain_weakest(t, row, ahead, share, spent):
                return True
    return False


def strain(t: Tables, brace: int, row: int, ahead: float, share: float, spent: bool) -> None:
    """Let the motor of a row do all that it can, as that is `ahead` of where it ought to be."""
    least, most = bounds_left(t, brace, row, share, spent)
    add(t, row, (least if ahead > 0.0 else most) - t.equations.impulse[row])
    t.joints.mode[t.braces.joint[brace]] = STRAINED


def strain_weakest(t: Tables, row: int, ahead: float, share: float, spent: bool) -> bool:
    """Let that motor do so that is the first to be overstrained if a row without pivot, which is
    `ahead`, is pulled back; return whether there is one.
    """
    decompose(t, row)
    weakest = -1
    endured = 0.0
    for brace in range(t.braces.sizes[0]):
        joint = t.braces.joint[brace]
        driven = coordinate_row(t, brace)
        if driven < 0 or driven >= row or t.joints.mode[joint] != DRIVEN:
            continue
        lever = abs(t.equations.unknown[driven]) * scale_of(t, driven, joint)
        effort = t.joints.effort[joint]
        if lever > SHARED * scale_of(t, row, joint) and effort < BOUNDLESS:
            bears = effort / abs(t.equations.unknown[driven])
            if weakest < 0 or bears < endured:
                weakest = brace
                endured = bears
    if weakest < 0:
        return False
    driven = coordinate_row(t, weakest)
    behind = -ahead if t.equations.unknown[driven] > 0.0 else ahead
    strain(t, weakest, driven, behind, share, spent)
    return True


def decompose(t: Tables, row: int) -> None:
    """Write into `unknown` how much of each row before it a row without pivot consists of."""
    entry = t.profile.entry
    equations = t.equations
    unknown = equations.unknown
    for other in range(row):
        unknown[other] = 0.0
    for other in range(equations.first[row], row):
        unknown[other] = entry[equations.base[row] + other]
    for other in range(row - 1, -1, -1):
        value = unknown[other]
        if value != 0.0:
            base = equations.base[other]
            for k in range(equations.first[other], other):
                unknown[k] -= entry[base + k] * value
