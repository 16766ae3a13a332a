"""How long a part of a tick may be for joints: RATTLE errs with the square of what turns in it.

A pendulum that turns by a through a part gains a^2/12 of its phase, on the mean over a swing; one
that hardly swings, at the circular frequency w, (w h)^2/24. Trees of hinges that turn slowly take
longer parts than the substeps of a tick, all joints shorter ones where something turns fast.
"""

import math

from engine.linkage.throwing import energy
from engine.tables import Tables

SWING = 0.035
"""By so much the only body of a tree turns in a part (rad); those of a tree of n bodies, as their
root mean square, by the fourth root of n times as much, n being `MANY` at most: their phases err to
both sides, so that the error of the whole is that of one of them over the square root of n."""

MANY = 20.0
"""Ends of longer chains whip."""

WHIP = 0.16
"""By so much the fastest of them turns, as long as parts are no shorter than substeps (rad)."""

SNAP = 0.12
"""By so much it turns whatever substeps there are, while nothing but hinges of trees acts (rad),"""

LASH = 0.06
"""and their bodies as their root mean square weighed by their energies: a whip gathers the energy
of a chain in its light end."""

HANG = 0.049
"""By so much of its oscillation (rad) a tree that hangs on a fixed hinge swings in a part."""

WAVE = 1.2
"""By so much of its oscillation (rad) the fastest wave along pulled hinges swings in a part: beyond
2 it would grow without end."""

LONGEST = 6.0
"""Substeps that a part lasts at most,"""

LONGEST_WITH_IMPACTS = 2.0
"""and if something meets in it: what is struck turns faster for the rest of its part."""

MOST_TURN = 0.25
"""By which a joined body turns in a part at most (rad): faster ones get shorter parts."""

SHORTEST = 1.0 / 32.0
"""Share of a substep that a part has at least."""


def part_for_joints(t: Tables, substep: float, left: float, resting: int, longest: float) -> float:
    """Length of the next part (s), of a tick that still lasts for `left` (s), `longest` substeps at
    most.

    A substep at most while anything but hinges of trees acts.
    """
    fastest = 0.0
    for node in range(1, t.braces.sizes[1]):
        spin = t.bodies.spin[t.nodes.body[node]]
        if spin * spin > fastest:
            fastest = spin * spin
    swinging, lashing, whipping, waving = paces(t)
    if whipping > fastest:
        fastest = whipping
    fastest = math.sqrt(fastest)
    waving = math.sqrt(waving) / WAVE
    if fastest / MOST_TURN > waving:
        waving = fastest / MOST_TURN
    if t.braces.sizes[0] == 0 and resting == 0:
        if lashing / LASH > waving:
            waving = lashing / LASH
        if fastest / SNAP > waving:
            waving = fastest / SNAP
    if waving * substep > 1.0:
        return 1.0 / waving if waving * substep * SHORTEST < 1.0 else substep * SHORTEST
    if t.braces.sizes[0] > 0 or resting > 0:
        return substep
    parts = left / (longest * substep)
    for pace in (swinging, fastest / WHIP, waving):
        if pace * left > parts:
            parts = pace * left
    if not parts * substep < left:
        return substep
    return left / math.ceil(parts - 1e-9)


def paces(t: Tables) -> tuple[float, float, float, float]:
    """How many parts a second the swinging of the trees asks for; how fast their energy turns; the
    square of their fastest spin; and their fastest wave, squared (1/s).

    Bodies that turn about the hinge in their centre need no more.
    """
    bones = t.bones
    bodies = t.bodies
    limbs = t.limbs
    trees = t.trees
    for at in range(bones.sizes[10]):
        tree = trees.acting[at]
        trees.worst[tree] = trees.lively[tree] = trees.lash[tree] = 0.0
    fastest = 0.0
    slowest = 0.0
    waving = 0.0
    for at in range(bones.sizes[8]):
        k = bones.acting[at]
        parent = limbs.parent[k]
        spin = 0.0
        square = 0.0
        if limbs.child_x[k] != 0.0 or limbs.child_y[k] != 0.0:
            spin = bodies.spin[bones.body[k]]
            square = spin * spin
        if parent >= bones.sizes[1]:
            pace = hanging_pace(t, k) / HANG
            if pace > slowest:
                slowest = pace
        elif limbs.parent_x[k] != 0.0 or limbs.parent_y[k] != 0.0:
            spin = bodies.spin[bones.body[parent]]
            if spin * spin > square:
                square = spin * spin
        tree = limbs.tree[k]
        row = bones.body[k]
        own = energy(t, row, bodies.vx[row], bodies.vy[row], bodies.spin[row])
        trees.worst[tree] += square
        trees.lively[tree] += own
        trees.lash[tree] += own * square
        wave = wave_at(t, k, parent)
        if wave > waving:
            waving = wave
        if square > fastest:
            fastest = square
    lashing = 0.0
    for at in range(bones.sizes[10]):
        tree = trees.acting[at]
        limbs_of = float(trees.limbs[tree])
        many = limbs_of if limbs_of < MANY else MANY
        pace = math.sqrt(trees.worst[tree] / (limbs_of * math.sqrt(many))) / SWING
        if pace > slowest:
            slowest = pace
        if trees.lash[tree] > lashing * trees.lively[tree]:
            lashing = trees.lash[tree] / trees.lively[tree]
    return slowest, math.sqrt(lashing), fastest, 2.0 * math.sqrt(waving)


def hanging_pace(t: Tables, k: int) -> float:
    """Circular frequency (1/s) of small swings of what hangs on a held parent."""
    row = t.bones.body[k]
    ax = t.bodies.ax[row]
    ay = t.bodies.ay[row]
    length = t.limbs.hangs[k]
    return math.sqrt(math.sqrt(ax * ax + ay * ay) / length) if length > 0.0 else 0.0


def wave_at(t: Tables, k: int, parent: int) -> float:
    """Square of half the squared circular frequency (1/s^4) of bodies that turn to and fro as a
    hinge pulls.

    That is the fastest wave of a chain: each link turns against the next, its centre at rest.
    """
    joint = t.limbs.joint[k]
    bones = t.bones
    x = t.limbs.child_x[k]
    y = t.limbs.child_y[k]
    ease = t.bodies.inverse_inertia[bones.body[k]]
    lever = (x * x + y * y) * (ease * ease)
    if parent < bones.sizes[1]:
        x = t.limbs.parent_x[k]
        y = t.limbs.parent_y[k]
        ease = t.bodies.inverse_inertia[bones.body[parent]]
        other = (x * x + y * y) * (ease * ease)
        if other > lever:
            lever = other
    x = t.joints.end_0[joint]
    y = t.joints.end_1[joint]
    return lever * (x * x + y * y)
