"""Where trees of hinged bodies will be at the end of a part of a tick, and how far hinges gape."""

from engine.kernels.elementary import cos_sin
from engine.linkage.limbs import find_worst
from engine.tables import Tables

NEAR = 0.3
"""Up to this angle (rad) the series of sine and cosine below are exact to rounding."""


def bend(t: Tables) -> None:
    """Find by how much bones move and turn from where they are placed to the end of the part."""
    bones = t.bones
    far = False
    if bones.sizes[10] == bones.sizes[3]:
        for bone in range(bones.sizes[2]):  # side by side, if all of them act
            far = bend_bone(t, bone) or far
    else:
        for at in range(bones.sizes[11]):
            far = bend_bone(t, bones.acting[at]) or far
    if far:
        for at in range(bones.sizes[11]):
            bone = bones.acting[at]
            angle = bones.lasts[bone] * (bones.spin[bone] + bones.lent_spin[bone])
            cos, bones.turn_sin[bone] = cos_sin(angle)
            bones.turn_less[bone] = cos - 1.0


def bend_bone(t: Tables, bone: int) -> bool:
    """Do so for one bone, its angle by a series; return whether that is too far for it."""
    bones = t.bones
    lasts = bones.lasts[bone]
    bones.way_x[bone] = lasts * (bones.vx[bone] + bones.lent_x[bone])
    bones.way_y[bone] = lasts * (bones.vy[bone] + bones.lent_y[bone])
    angle = lasts * (bones.spin[bone] + bones.lent_spin[bone])
    s = angle * angle
    bones.turn_sin[bone] = angle * (
        1.0
        + s
        * (
            -1.0 / 6.0
            + s * (1.0 / 120.0 + s * (-1.0 / 5040.0 + s * (1.0 / 362880.0 - s / 39916800.0)))
        )
    )
    bones.turn_less[bone] = s * (
        -0.5
        + s
        * (
            1.0 / 24.0
            + s * (-1.0 / 720.0 + s * (1.0 / 40320.0 + s * (-1.0 / 3628800.0 + s / 479001600.0)))
        )
    )
    return s > NEAR * NEAR


def measure_limbs(t: Tables, aiming: bool) -> None:
    """Find by how much hinges will gape at the end of the part (s); aim at where they will be."""
    bones = t.bones
    for run in range(bones.sizes[12]):
        first = bones.run_first[run]
        end = bones.run_end[run]
        find_gaps(t, first, end, bones.run_lead[run])
        if aiming:
            aim_at_ends(t, first, end, bones.run_lead[run])
    find_worst(t)


def find_gaps(t: Tables, first: int, end: int, lead: int) -> None:
    """Do so for a run of them, from row `first` to before `end`; parents are `lead` rows behind."""
    bones = t.bones
    limbs = t.limbs
    for k in range(first, end):
        parent = k + lead
        sin = bones.turn_sin[k]
        less = bones.turn_less[k]
        x = limbs.tip_x[k]
        y = limbs.tip_y[k]
        gap_x = limbs.gap_x[k] + (bones.way_x[k] - bones.way_x[parent]) + (less * x - sin * y)
        gap_y = limbs.gap_y[k] + (bones.way_y[k] - bones.way_y[parent]) + (sin * x + less * y)
        sin = bones.turn_sin[parent]
        less = bones.turn_less[parent]
        x = limbs.base_x[k]
        y = limbs.base_y[k]
        gap_x -= less * x - sin * y
        gap_y -= sin * x + less * y
        limbs.rate_x[k] = -gap_x / bones.lasts[k]
        limbs.rate_y[k] = -gap_y / bones.lasts[k]
        limbs.miss[k] = (gap_x * gap_x + gap_y * gap_y) * limbs.scale[k]


def aim_at_ends(t: Tables, first: int, end: int, lead: int) -> None:
    """Want velocities of the points where a run of hinges will be at the end of the part."""
    bones = t.bones
    limbs = t.limbs
    for k in range(first, end):
        parent = k + lead
        sin = bones.turn_sin[k]
        less = bones.turn_less[k]
        x = limbs.tip_x[k]
        y = limbs.tip_y[k]
        limbs.reach_x[k] = x + (less * x - sin * y)
        limbs.reach_y[k] = y + (sin * x + less * y)
        sin = bones.turn_sin[parent]
        less = bones.turn_less[parent]
        x = limbs.base_x[k]
        y = limbs.base_y[k]
        limbs.span_x[k] = x + (less * x - sin * y)
        limbs.span_y[k] = y + (sin * x + less * y)
