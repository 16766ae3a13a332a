"""How long a part of a tick may be for joints: RATTLE errs with the square of what turns in it.

A pendulum that turns by a through a part gains a^2/12 of its phase, on the mean over a swing; one
that hardly swings, at the circular frequency w, (w h)^2/24. Trees of hinges that turn slowly take
longer parts than the substeps of a tick, all joints shorter ones where something turns fast.
"""

import math

from engine.tables import Tables

SWING = 0.035
"""By so much the bodies of a tree turn in a part, as their root mean square (rad)."""

WHIP = 0.08
"""By so much the fastest of them turns, as long as parts are no shorter than substeps (rad)."""

HANG = 0.049
"""By so much of its oscillation (rad) a tree that hangs on a fixed hinge swings in a part."""

LONGEST = 2.0
"""Substeps that a part lasts at most."""

MOST_TURN = 0.25
"""By which a joined body turns in a part at most (rad): faster ones get shorter parts."""

SHORTEST = 1.0 / 32.0
"""Share of a substep that a part has at least."""


def part_for_joints(t: Tables, substep: float, left: float, resting: int) -> float:
    """Length of the next part (s), of a tick that still lasts for `left` (s).

    A substep while anything but hinges of trees acts.
    """
    fastest = 0.0
    for node in range(1, t.braces.sizes[1]):
        spin = t.bodies.spin[t.nodes.body[node]]
        if spin * spin > fastest:
            fastest = spin * spin
    swinging, whipping = paces(t)
    if whipping > fastest:
        fastest = whipping
    fastest = math.sqrt(fastest)
    part = substep
    if fastest * substep > MOST_TURN:
        share = MOST_TURN / (fastest * substep)
        return substep * (share if share > SHORTEST else SHORTEST)
    if t.braces.sizes[0] == 0 and resting == 0:
        most = left / (LONGEST * substep)
        if swinging * left > most:
            most = swinging * left
        if whipping * left * left > WHIP * WHIP * most * most:
            most = fastest * left / WHIP
        parts = math.ceil(most - 1e-9)
        if left > parts * substep:
            part = left / parts
    return part


def paces(t: Tables) -> tuple[float, float]:
    """How many parts a second the swinging of the trees asks for; the square of their fastest spin.

    Bodies that turn about the hinge in their centre need no more.
    """
    bones = t.bones
    bodies = t.bodies
    limbs = t.limbs
    trees = t.trees
    for tree in range(bones.sizes[3]):
        trees.worst[tree] = 0.0
    fastest = 0.0
    slowest = 0.0
    for k in range(bones.sizes[0]):
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
        trees.worst[limbs.tree[k]] += square
        if square > fastest:
            fastest = square
    for tree in range(bones.sizes[3]):
        pace = math.sqrt(trees.worst[tree] / trees.limbs[tree]) / SWING
        if pace > slowest:
            slowest = pace
    return slowest, fastest


def hanging_pace(t: Tables, k: int) -> float:
    """Circular frequency (1/s) of small swings of what hangs on a held parent."""
    row = t.bones.body[k]
    ax = t.bodies.ax[row]
    ay = t.bodies.ay[row]
    length = t.limbs.hangs[k]
    return math.sqrt(math.sqrt(ax * ax + ay * ay) / length) if length > 0.0 else 0.0
