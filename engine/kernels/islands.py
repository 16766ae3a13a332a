"""Islands that rest take a tick at once, whatever others do.

An island is what resting contacts and joints connect; what never moves connects nothing. While one
is in turmoil, and needs the tick in short parts, those that are steady (see `steady`) *wait*: their
bodies follow the paths that were found for them as the tick began, through all of these parts. As
soon as something hits an island that waits, or comes to rest on it, that island ends what it began,
wherever it is, and takes part in the rest of the tick.

A body that waits has a negative number in `Bodies.held`, so that what looks for held bodies finds
those that take part.
"""

from engine.kernels.books import book_part
from engine.kernels.contacts import relax
from engine.kernels.halting import book_fixed, book_turns_by_ground, hand_on
from engine.kernels.lever_arms import correct_arms
from engine.kernels.resting import place_middle
from engine.kernels.rousing import ALL, PRESENT, ROUSED, STEADILY, pair_waits
from engine.kernels.standing import is_built, moves, stand, take_back_new
from engine.kernels.steady import (
    BALANCED,
    BEARING,
    LONG,
    MOVING,
    RELYING,
    TRUSTED,
    balance,
    is_loose,
    is_unsteady,
    put_off,
    relies,
    strays,
    watch,
)
from engine.kernels.sticking import cluster_of, connect, island_of
from engine.kernels.touches import collect, touch
from engine.linkage.acting import list_acting
from engine.linkage.limb_impulses import forget_jolts
from engine.linkage.limb_sweeps import book_even
from engine.tables import RESTING, Tables

STIRRED = 0.25
"""Share of what one sweep may change of what is steady that tells who is not."""


def turn_to(t: Tables, count: int, waits: int) -> None:
    """Let bodies that wait as said be those that kernels work on, and no others."""
    bodies = t.bodies
    for row in range(count):
        held = bodies.held[row]
        acts = bodies.waits[row] == waits or bodies.inverse_mass[row] == 0.0
        if (held > 0 and not acts) or (held < 0 and acts):
            bodies.held[row] = -held
    list_acting(t, waits)


def wait_steadily(t: Tables, count: int, resting: int, dt: float) -> tuple[int, int, int]:
    """Let steady islands take the whole tick (s) at once.

    To be called when a tick begins, once pairs that rest are listed, `resting` in number. Returns
    how many of them are left in the list, how many wait, and how steadily.
    """
    pairs = t.pairs
    islands = find_steady(t, count, resting, dt)
    if islands == 0:
        return resting, 0, MOVING
    waiting = 0
    for k in range(resting):
        pairs.waiting[k] = pairs.resting[k]
        if pair_waits(t, pairs.resting[k]):
            pairs.resting[waiting] = pairs.resting[k]
            waiting += 1
    turn_to(t, count, STEADILY)
    steadiness = RELYING
    loose = t.state.trusted[0] > 0 and is_loose(t, count)
    if loose:
        place_middle(t, count, dt / 2.0, False)
    if not relies(t, count, waiting, dt, loose):
        if not loose:
            place_middle(t, count, dt / 2.0, False)
        steadiness = balance(t, count, waiting, dt)
    if steadiness == MOVING:
        if islands > 1:
            put_off_strays(t, count)
        if bear_anew(t, count, waiting, dt):
            steadiness = balance(t, count, waiting, dt)
    if steadiness == MOVING:
        take_back_new(t, waiting)
        waiting = 0
        end_waiting(t, count, STEADILY)
    left = 0
    for k in range(resting):
        if not pair_waits(t, pairs.waiting[k]):
            pairs.grouped[left] = pairs.waiting[k]
            left += 1
    for k in range(waiting):
        pairs.waiting[k] = pairs.resting[k]
    for k in range(left):
        pairs.resting[k] = pairs.grouped[k]
    turn_to(t, count, PRESENT)
    return left, waiting, steadiness


def find_steady(t: Tables, count: int, resting: int, dt: float) -> int:
    """Find steady islands of bodies that rest, and let their bodies wait; return their number. What
    was just built in equilibrium is steady too (see `standing`).

    Counts for how many ticks (s) bodies have been calm: to be called once a tick.
    """
    bodies = t.bodies
    calm = 0
    for row in range(count):
        bodies.stirred[row] = 1
        if bodies.held[row] == 0:
            bodies.calm[row] = 0
        else:
            watch(t, row, dt)
            if bodies.calm[row] >= LONG and bodies.inverse_mass[row] > 0.0:
                calm += 1
    built = t.progress.begins[0] == 1 and is_built(t, resting)
    if (calm == 0 and not built) or t.braces.sizes[0] > 0:
        return 0
    connect(t, count, resting)
    if built and stand(t, count, resting, dt, False) + calm == 0:
        return 0
    for k in range(resting):
        bodies.stirred[island_of(t, t.pairs.resting[k])] = 0
    for row in range(count):
        if bodies.inverse_mass[row] > 0.0 and bodies.calm[row] < LONG:
            bodies.stirred[cluster_of(t, row)] = 1
    for k in range(resting):
        pair = t.pairs.resting[k]
        island = island_of(t, pair)
        if bodies.stirred[island] == 0 and is_unsteady(t, pair):
            bodies.stirred[island] = 1
    islands = 0
    for row in range(count):
        if bodies.inverse_mass[row] > 0.0 and bodies.stirred[cluster_of(t, row)] == 0:
            bodies.waits[row] = STEADILY
            if bodies.cluster[row] == row:
                islands += 1
    return islands


def bear_anew(t: Tables, count: int, waiting: int, dt: float) -> bool:
    """Find loads that bear other forces than before in a tick (s); return whether all that waits
    can bear them, and stands.
    """
    bodies = t.bodies
    for row in range(count):
        if bodies.waits[row] == STEADILY and (bodies.joined[row] == 1 or moves(t, row)):
            return False
    stand(t, count, waiting, dt, True)
    for row in range(count):
        if bodies.waits[row] == STEADILY and bodies.stirred[cluster_of(t, row)] == 1:
            return False
    return True


def put_off_strays(t: Tables, count: int) -> None:
    """Put off those that one sweep showed to be unsteady."""
    for row in range(count):
        if t.bodies.held[row] > 0 and strays(t, row, STIRRED * BEARING):
            put_off(t, row)


def end_waiting(t: Tables, count: int, waits: int) -> None:
    """Let all that waits as said take part again."""
    bodies = t.bodies
    for row in range(count):
        if bodies.waits[row] == waits:
            bodies.waits[row] = PRESENT
        if bodies.held[row] < 0:
            bodies.held[row] = -bodies.held[row]


def list_roused(t: Tables, count: int, waiting: int, everyone: bool) -> int:
    """List the pairs of islands that wait and of which a body is roused, or of `everyone`, and keep
    the others in the list of those that wait, `waiting` in number; return how many were roused.
    """
    bodies = t.bodies
    pairs = t.pairs
    for k in range(waiting):
        pairs.resting[k] = pairs.waiting[k]
    connect(t, count, waiting)
    for row in range(count):
        bodies.stirred[row] = 0
    for row in range(count):
        if bodies.waits[row] == ROUSED or (everyone and bodies.waits[row] == STEADILY):
            bodies.stirred[cluster_of(t, row)] = 1
    for row in range(count):
        if bodies.waits[row] == STEADILY and bodies.stirred[cluster_of(t, row)] == 1:
            bodies.waits[row] = ROUSED
    roused = 0
    left = 0
    for k in range(waiting):
        pair = pairs.waiting[k]
        if bodies.stirred[island_of(t, pair)] == 1:
            pairs.resting[roused] = pair
            roused += 1
        else:
            pairs.waiting[left] = pair
            left += 1
    return roused


def end_steadily(
    t: Tables, count: int, waiting: int, steadiness: int, dt: float, now: float, everyone: bool
) -> int:
    """End what steady islands that were roused, or `everyone`, began for a tick of `dt` seconds,
    `now` after it began; return how many pairs still wait.

    Args:
        t: the tables.
        count: number of bodies.
        waiting: number of pairs that wait.
        steadiness: how steadily; see `steady`.
        dt: length of the tick (s).
        now: how much of it has passed (s).
        everyone: whether all that waits ends that, roused or not.
    """
    share = now / dt
    hit = t.progress.roused[0] > 0
    left = waiting
    waiting = list_roused(t, count, waiting, everyone or t.progress.roused[0] == ALL)
    left -= waiting
    turn_to(t, count, ROUSED)
    for at in range(t.bones.sizes[9]):
        forget_jolts(t, t.bones.acting[at])
    book_part(t, waiting, count, dt, now, hit)
    book_even(t, share, now)
    loose = book_fixed(t, count, share, now)
    if loose:
        book_turns_by_ground(t, waiting, share, now)
    if now < dt:
        hand_on(t, count, waiting, share)
        for k in range(waiting):  # what let go has been given its share
            if t.pairs.state[t.pairs.resting[k]] == RESTING:
                touch(t, t.pairs.resting[k])
                collect(t, t.pairs.resting[k], share - 1.0)
        correct_arms(t, waiting, count, t.impacts.written[0], 0.0, dt, now)
    if steadiness != RELYING or now < dt:
        still = relax(t, waiting, count, dt, share, True)
        balanced = still and steadiness == BALANCED and now == dt
        t.state.trusted[0] = TRUSTED if balanced else 0
    end_waiting(t, count, ROUSED)
    turn_to(t, count, PRESENT)
    return left
