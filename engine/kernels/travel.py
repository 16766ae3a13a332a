"""One tick, cut into parts: free flight and impacts in one, resting contacts in several.

While nothing rests, the tick is one part. Else parts have the length of a substep. A part ends
early when two bodies come to rest on each other, or when a body leaves the box for which the list
of pairs holds.
"""

from engine.kernels.aftermath import await_corners, look_at_struck
from engine.kernels.agenda import TOGETHER, dequeue, empty, next_to_meet
from engine.kernels.books import book_lead, book_part
from engine.kernels.contacts import relax
from engine.kernels.escaping import has_escaped
from engine.kernels.fields import lead_of_euler
from engine.kernels.gathering import gather
from engine.kernels.islands import (
    end_steadily,
    wait_steadily,
)
from engine.kernels.lever_arms import correct_arms
from engine.kernels.meeting import (
    find_meetings,
    foresee_meetings,
    measure_rims,
)
from engine.kernels.moments import forget_ways
from engine.kernels.owing import let_owe
from engine.kernels.pose import advance_all, drift_all
from engine.kernels.resting import (
    count_holds,
    hold,
    settle,
    whirls,
)
from engine.kernels.riding import note_rides
from engine.kernels.rousing import pair_waits, rouse
from engine.kernels.sensing import sense_all
from engine.kernels.simultaneous import strike_gathered
from engine.kernels.status import CROWDED, DONE, ESCAPED
from engine.kernels.steady import MOVING
from engine.kernels.touches import collect, take_back_all, touch
from engine.linkage.limb_sweeps import book_even
from engine.linkage.pace import (
    LONGEST,
    LONGEST_WITH_IMPACTS,
    SHORTEST,
    let_pace_go,
    part_for_joints,
)
from engine.linkage.positions import retract
from engine.linkage.tally import (
    clear_sums,
    is_joined,
    joints_act,
    joints_that_act,
    mean_forces,
)
from engine.tables import FREE, IMPACTS_AT_ONCE, NEVER, RESTING, Tables


def begin(t: Tables, count: int, pair_count: int, shortest: float) -> None:
    """Start a tick: find what rests; let the others move with their integrator's lead.

    In a tick without forces that is no more than to see that nothing rests, once all fly straight.
    """
    bodies = t.bodies
    if t.progress.straight[0] == 1:
        return
    clear_sums(t)
    for row in range(count):
        bodies.clock[row] = 0.0
        bodies.bent[row] = 0.0
    forget_ways(bodies, count)
    resting = settle(t, count, pair_count, shortest)
    forced = t.books.forced[0] == 1
    if not forced and resting == 0 and not joints_act(t):
        t.progress.straight[0] = 1
        for pair in range(pair_count):
            t.pairs.clear[pair] = 0.0
    for row in range(count):
        bodies.path_x[row] = bodies.ax[row]
        bodies.path_y[row] = bodies.ay[row]
        bodies.path_spin[row] = bodies.aspin[row]
        if bodies.held[row] > 0:
            bodies.lead_x[row] = bodies.lead_y[row] = bodies.lead_spin[row] = 0.0
        elif forced:
            book_lead(t, row, bodies.lead_x[row], bodies.lead_y[row], bodies.lead_spin[row])
            bodies.vx[row] += bodies.lead_x[row]
            bodies.vy[row] += bodies.lead_y[row]
            bodies.spin[row] += bodies.lead_spin[row]


def end(t: Tables, count: int, pair_count: int, integrator: int, dt: float, substep: float) -> None:
    """End a tick: take the lead back.

    The lead of the two Euler methods is a property of a flight, not of a tick: one that ends in
    rest keeps the velocity of the position, and one that begins gets its lead.
    """
    bodies = t.bodies
    struck = t.pairs.struck
    for pair in range(pair_count):
        struck[pair] -= dt
        if struck[pair] < -dt:
            t.pairs.bounces[pair] = 0
    mean_forces(t, dt)
    let_pace_go(t, dt, substep)
    if t.books.forced[0] == 0:
        return
    lead = lead_of_euler(integrator, dt)
    for row in range(count):
        if bodies.inverse_mass[row] > 0.0:
            if lead != 0.0:
                flies = lead if bodies.held[row] == 0 else 0.0
                bodies.lead_x[row] = bodies.ax[row] * flies
                bodies.lead_y[row] = bodies.ay[row] * flies
                bodies.lead_spin[row] = bodies.aspin[row] * flies
            book_lead(t, row, -bodies.lead_x[row], -bodies.lead_y[row], -bodies.lead_spin[row])
            bodies.vx[row] -= bodies.lead_x[row]
            bodies.vy[row] -= bodies.lead_y[row]
            bodies.spin[row] -= bodies.lead_spin[row]


def travel(
    t: Tables, count: int, pair_count: int, now: float, dt: float, substep: float, limit: int
) -> tuple[int, float]:
    """Move all bodies from `now` to `dt`, both since the tick began (s).

    Returns `DONE`, `CROWDED` or `ESCAPED`, and the time reached. After `limit` impacts in one tick
    the others are taken as plastic, after twice as many as done: a ball that is squeezed between a
    hammer and an anvil bounces without end.
    """
    steady = 0
    steadiness = MOVING
    untouched = False
    while now < dt:
        t.progress.roused[0] = 0
        resting = 0 if untouched else settle(t, count, pair_count, substep)
        if t.progress.roused[0] > 0 and steady > 0:
            steady = end_steadily(t, count, steady, steadiness, dt, now, False)
            resting = settle(t, count, pair_count, substep)
        if resting > 0 and t.progress.straight[0] == 1:
            t.progress.straight[0] = 0
            forget_ways(t.bodies, count)
        if now == 0.0 and resting > 0 and t.progress.stalled[0] == 0:  # once a tick
            resting, steady, steadiness = wait_steadily(t, count, resting, dt)
        part, held = plan(t, count, resting, dt - now, substep, now, LONGEST)
        joined = joints_that_act(t)
        first = t.impacts.written[0]
        straight = t.progress.straight[0] == 1
        queued = queue_meetings(t, count, pair_count, held, part, straight)
        longest = LONGEST_WITH_IMPACTS * substep
        if queued > 0 and joined > 0 and part > longest * (1.0 + 1e-9):
            empty(t, queued)
            part, held = plan(t, count, resting, dt - now, substep, now, LONGEST_WITH_IMPACTS)
            measure_rims(t, count, part)
            queued = find_meetings(t, pair_count, part)
        status = DONE
        reached = part
        clear = queued == 0 and steady == 0
        if queued > 0:
            loaded = held + joined
            status, reached, queued = meet_in_order(
                t, queued, loaded, loaded > 0 or steady > 0, now, part, dt, substep, limit
            )
            empty(t, queued)
        t.progress.stalled[0] = t.progress.stalled[0] + 1 if reached == 0.0 else 0
        if t.progress.sensing[0] > 0:
            sense_all(t, pair_count, reached)
        if straight:
            drift_all(t.bodies, count, reached)
        else:
            advance_all(t.bodies, count, reached, now == 0.0 and reached == dt)
        if held > 0:
            end_contacts(t, held, count, first, now, part, reached)
        untouched = let_owe(t, pair_count, held, part, clear and part < dt - now)
        if not untouched and (held > 0 or joined > 0):
            relax(t, held, count, part, reached / part, False)
        now = dt if reached >= part and part == dt - now else now + reached
        ends = status != DONE or now == dt
        if steady > 0 and (ends or t.progress.roused[0] > 0):
            steady = end_steadily(t, count, steady, steadiness, dt, now, ends)
        if status != DONE and now < dt:
            return status, now
    list_settled(t, count, pair_count)
    return DONE, dt


def queue_meetings(
    t: Tables, count: int, pair_count: int, held: int, part: float, straight: bool
) -> int:
    """Queue all pairs that meet in a part of the tick (s); return how many."""
    if straight:
        return foresee_meetings(t, pair_count, part)
    measure_rims(t, count, part)
    queued = find_meetings(t, pair_count, part)
    return await_corners(t, held, part, queued)


def end_contacts(
    t: Tables, held: int, count: int, first: int, now: float, part: float, reached: float
) -> None:
    """Book what resting contacts did in a part (s) that ended when `reached`, and correct it by
    what impacts, from row `first` on, and an early end change; see `correct_arms`.
    """
    book_part(t, held, count, part, reached, t.impacts.written[0] > first)
    note_rides(t, held, reached / part)
    book_even(t, reached / part, reached)
    if reached < part:
        take_back_all(t, held, 1.0 - reached / part)
    correct_arms(t, held, count, first, now, part, reached)


def list_settled(t: Tables, count: int, pair_count: int) -> None:
    """List the pairs that rest when a tick is over, and count for each body those it is held by."""
    settled = 0
    for pair in range(pair_count):
        if t.pairs.state[pair] == RESTING:
            t.pairs.resting[settled] = pair
            settled += 1
    if settled > 0 or t.progress.straight[0] == 0:
        count_holds(t, count, settled)


def plan(
    t: Tables, count: int, resting: int, left: float, substep: float, now: float, longest: float
) -> tuple[float, int]:
    """Choose the length of the next part of the tick, which began `now` seconds ago and lasts for
    as many as are `left`, and bend the paths of what is held; with joints, a part lasts for
    `longest` substeps (s) at most.

    Returns the length (s), and the number of pairs that rest in it.
    """
    part = left
    if resting == 0 and not joints_act(t):
        return part, 0
    shortest = part_for_joints(t, substep, part, resting, longest)
    if shortest < part * (1.0 - 1e-9):
        part = shortest
    t.progress.final[0] = 1 if part <= substep * SHORTEST else 0
    held = hold(t, count, resting, now, part, substep, False)
    while t.bones.sizes[5] > 0 and t.progress.final[0] == 0:
        part /= 2.0
        retract(t)
        t.progress.final[0] = 1 if part <= substep * SHORTEST else 0
        held = hold(t, count, held, now, part, substep, True)
    return part, held


def meet_in_order(
    t: Tables,
    queued: int,
    held: int,
    loaded: bool,
    now: float,
    part: float,
    dt: float,
    substep: float,
    limit: int,
) -> tuple[int, float, int]:
    """Let all impacts of a part happen in order of time.

    Args:
        t: the tables.
        queued: number of pairs that will meet.
        held: number of contacts and joints that act for the whole part,
        loaded: and whether there are such, those that wait counted.
        now: when the part began, since the tick began (s).
        part: its length (s).
        dt: that of the tick (s).
        substep: that of a substep (s).
        limit: number of impacts in a tick from which on they are plastic.

    Returns the status, the time reached, and how many meetings are left in the queue.
    """
    pairs = t.pairs
    written = t.impacts.written
    reached = 0.0
    cut = False
    ending = DONE
    while queued > 0:
        pair = next_to_meet(t, queued)
        time = pairs.meeting[pair]
        if cut and time > reached + TOGETHER:
            return ending, reached, queued
        reached = time
        if written[0] >= IMPACTS_AT_ONCE:
            return CROWDED, time, queued
        queued = dequeue(t, 0, queued)
        pairs.meeting[pair] = NEVER
        number = 1
        t.hits.gathered[0] = pair
        if written[1] < limit:
            number, queued = gather(t, pair, now, time, queued)
        bare = part - time if held > 0 else 0.0  # else the part ends as something comes to rest
        rests = meet(t, number, now, time, bare, dt, substep, limit)
        for k in range(number):
            if pair_waits(t, t.hits.gathered[k]):
                rouse(t, t.hits.gathered[k])
        if t.progress.roused[0] > 0:
            cut = True  # but first, what waits hands the blow on to what it rests on
        elif rests and held == 0 and time < part:
            return DONE, time, queued
        left = dt - now - time
        for k in range(number):
            struck = t.hits.gathered[k]
            a = pairs.a[struck]
            b = pairs.b[struck]
            if has_escaped(t, a, left) or has_escaped(t, b, left):
                ending = ESCAPED
                # Contacts act for a whole part; cut it only if a body might leave its box within.
                within = part - time
                if not loaded or has_escaped(t, a, within) or has_escaped(t, b, within):
                    cut = True
        if is_joined(t, pair):
            written[1] += joints_that_act(t) // 8  # joints make it dear: give up sooner
        strict = written[1] < 2 * limit
        queued = look_at_struck(t, number, time, part, queued, strict)
    if cut:
        return ending, reached, queued
    return ending, part, queued


def meet(
    t: Tables,
    number: int,
    now: float,
    time: float,
    bare: float,
    dt: float,
    substep: float,
    limit: int,
) -> bool:
    """Let the pairs that were gathered meet at `time` of their part; return whether one of them
    rests from then on. For the others see `meet_in_order`.

    What comes to rest bears nothing as long as it is `bare` (s), until its part is over. What
    whirls would be entered meanwhile: it flies on, however softly it was struck.
    """
    pairs = t.pairs
    written = t.impacts.written
    hits = t.hits
    written[1] += number
    if written[1] > 2 * limit:
        for k in range(number):
            hold_on(t, hits.gathered[k])
        return True
    strike_gathered(t, number, now, time, substep, 0.0, written[1] > limit)
    rests = False
    for k in range(number):
        pair = hits.gathered[k]
        if pairs.state[pair] == RESTING and written[1] < limit and whirls(t, pair, bare):
            pairs.state[pair] = FREE
        if pairs.state[pair] == RESTING:
            rests = True
        elif hits.rested[k] == 1:
            collect(t, pair, (now + time) / dt if pair_waits(t, pair) else 1.0)
    return rests


def hold_on(t: Tables, pair: int) -> None:
    """Let a pair rest without a blow: it has had more than enough of them."""
    touch(t, pair)
    if t.pairs.state[pair] != RESTING:
        t.pairs.points[pair] = 0
    t.pairs.state[pair] = RESTING
