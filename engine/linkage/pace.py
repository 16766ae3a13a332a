"""How long a part of a tick may be for joints: RATTLE errs with the square of what turns in it.

A pendulum that turns by a through a part gains a^2/12 of its phase, on the mean over a swing; one
that hardly swings, at the circular frequency w, (w h)^2/24. Trees of hinges that turn slowly take
longer parts than the substeps of a tick, all joints shorter ones where something turns fast.

In parts of one length RATTLE keeps, to all times, an energy that differs from the true one by the
square of that length; where lengths follow speeds it does not, and energy drifts (Hairer, Lubich &
Wanner, *Geometric Numerical Integration*, 2006, IX and VIII.1). So what trees of few limbs ask for
is held: their parts are as short as the fastest motion of the last seconds wants them.
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

FEW = 12
"""Trees of no more limbs hold their pace. Longer chains whip now and then, for milliseconds: held,
that would cost several times as much."""

HELD = 20.0
"""How long a pace is held (s): longer than what swings fast, now and then, is slow."""

HELD_SNAP = 0.2
"""By so much the fastest body of a tree that holds its pace turns in a part (rad),"""

HELD_LASH = 0.1
"""and its bodies as their root mean square weighed by their energies: more than where parts follow
speeds, as errors that do not add up may be larger."""

SPARE = 1.25
"""A pace is held on if one this many times less would do: else it would change to and fro."""

ROUNDING = 1e-6
"""Parts of a tick are as many as this much less would ask for."""


def part_for_joints(t: Tables, substep: float, left: float, resting: int, longest: float) -> float:
    """Length of the next part (s), of a tick that still lasts for `left` (s), `longest` substeps at
    most.

    A substep at most while anything but hinges of trees acts.
    """
    alone = t.braces.sizes[0] == 0 and resting == 0
    few, many = count_trees(t)
    held = 0.0
    swinging = lashing = whipping = waving = 0.0
    if few > 0:
        swinging, lashing, whipping, waving = paces(t, True)
        if alone:
            held = hold_pace(t, substep, swinging, lashing, whipping, waving)
            whipping = waving = 0.0
        swinging = lashing = 0.0
    if many > 0:
        swinging, lashing, whip, wave = paces(t, False)
        whipping = whip if whip > whipping else whipping
        waving = wave if wave > waving else waving
    for node in range(1, t.braces.sizes[1]):
        spin = t.bodies.spin[t.nodes.body[node]]
        if spin > whipping or -spin > whipping:
            whipping = abs(spin)
    if whipping / MOST_TURN > waving:
        waving = whipping / MOST_TURN
    if alone:
        if lashing / LASH > waving:
            waving = lashing / LASH
        if whipping / SNAP > waving:
            waving = whipping / SNAP
    part = part_at(substep, left, longest, alone, waving, swinging, whipping)
    if held * part > 1.0 + ROUNDING:
        part = left / math.ceil(held * left - ROUNDING)
    return part


def part_at(
    substep: float,
    left: float,
    longest: float,
    alone: bool,
    waving: float,
    swinging: float,
    whipping: float,
) -> float:
    """Length of a part (s) at a pace that must be (1/s), in spite of substeps, another that is
    wanted, and the fastest spin; see `part_for_joints`.
    """
    if waving * substep > 1.0:
        return 1.0 / waving if waving * substep * SHORTEST < 1.0 else substep * SHORTEST
    if not alone:
        return substep
    parts = left / (longest * substep)
    for pace in (swinging, whipping / WHIP, waving):
        if pace * left > parts:
            parts = pace * left
    if not parts * substep < left:
        return substep
    return left / math.ceil(parts - 1e-9)


def count_trees(t: Tables) -> tuple[int, int]:
    """How many trees that act have few limbs, and how many have more; forget how they turn."""
    trees = t.trees
    few = 0
    for at in range(t.bones.sizes[10]):
        tree = trees.acting[at]
        trees.worst[tree] = trees.lively[tree] = trees.lash[tree] = 0.0
        few += 1 if trees.limbs[tree] <= FEW else 0
    return few, t.bones.sizes[10] - few


def hold_pace(
    t: Tables, substep: float, swinging: float, lashing: float, whipping: float, waving: float
) -> float:
    """How many parts a second trees of few limbs take: as many as they have asked for lately.

    Args:
        t: the tables.
        substep: its length (s).
        swinging: parts a second that their swinging asks for,
        lashing: how fast their energy turns,
        whipping: their fastest spin (1/s),
        waving: and parts a second that waves ask for.
    """
    state = t.state
    pace = waving
    if lashing / HELD_LASH > pace:
        pace = lashing / HELD_LASH
    if whipping / HELD_SNAP > pace:
        pace = whipping / HELD_SNAP
    if pace * substep < 1.0:
        if whipping / WHIP > swinging:
            swinging = whipping / WHIP
        if swinging > pace:
            pace = swinging if swinging * substep < 1.0 else 1.0 / substep
    if pace > state.asked[0]:
        state.asked[0] = pace
    if pace > state.pace[0] * (1.0 + ROUNDING):
        state.pace[0] = whole_pace(pace, substep)
        state.paced[0] = 0.0
    return state.pace[0]


def whole_pace(pace: float, substep: float) -> float:
    """The next higher of the few paces (1/s) that are held: so that they change seldom."""
    parts = 1.0
    if pace * substep > 1.0:
        while parts < pace * substep and parts * SHORTEST < 1.0:
            parts *= 2.0
        return parts / substep
    while parts < LONGEST and (parts + 1.0) * pace * substep <= 1.0:
        parts += 1.0
    return 1.0 / (parts * substep)


def let_pace_go(t: Tables, dt: float, substep: float) -> None:
    """At the end of a tick (s), hold a pace no longer that has not been needed for long."""
    state = t.state
    if state.pace[0] == 0.0:
        return
    state.paced[0] += dt
    if state.paced[0] > HELD:
        enough = whole_pace(SPARE * state.asked[0], substep)
        if enough < state.pace[0]:
            state.pace[0] = enough
        state.paced[0] = state.asked[0] = 0.0


def paces(t: Tables, few: bool) -> tuple[float, float, float, float]:
    """How many parts a second the swinging of trees with `few` limbs, or of the others, asks for;
    how fast their energy turns; their fastest spin; and the pace that their fastest wave asks for
    (1/s).

    Bodies that turn about the hinge in their centre need no more.
    """
    bones = t.bones
    bodies = t.bodies
    limbs = t.limbs
    trees = t.trees
    fastest = 0.0
    slowest = 0.0
    waving = 0.0
    for at in range(bones.sizes[8]):
        k = bones.acting[at]
        tree = limbs.tree[k]
        if (trees.limbs[tree] <= FEW) != few:
            continue
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
        if (trees.limbs[tree] <= FEW) != few:
            continue
        limbs_of = float(trees.limbs[tree])
        many = limbs_of if limbs_of < MANY else MANY
        pace = math.sqrt(trees.worst[tree] / (limbs_of * math.sqrt(many))) / SWING
        if pace > slowest:
            slowest = pace
        if trees.lash[tree] > lashing * trees.lively[tree]:
            lashing = trees.lash[tree] / trees.lively[tree]
    fastest = math.sqrt(fastest)
    return slowest, math.sqrt(lashing), fastest, math.sqrt(2.0 * math.sqrt(waving)) / WAVE


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
