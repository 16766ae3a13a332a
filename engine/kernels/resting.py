"""Which pairs rest on each other, and when they stop to.

A pair rests if it touches and would be back, if it left with its present speed, before a substep
is over: what forces do within a substep explains its motion. Nothing else decides between rest and
impact; there is no speed below which bodies do not bounce.
"""

from engine.kernels.aftermath import BLOWS
from engine.kernels.agenda import dequeue, enqueue, next_to_meet
from engine.kernels.circles import stillness, wall_of
from engine.kernels.contacts import CROWD, kick
from engine.kernels.following import (
    TUMBLING,
    find_points_once,
    follow,
    has_drifted,
    its_normal_turns,
    note_opening,
    turning,
)
from engine.kernels.gathering import gather
from engine.kernels.handing import hand_on, leave_to_bearing
from engine.kernels.impacts import settling_speed, stays
from engine.kernels.meeting import notice_passing, slides_over
from engine.kernels.packing import clear_lane, is_packed, load_points
from engine.kernels.parting import is_parting
from engine.kernels.pose import place_pair
from engine.kernels.rousing import rouse
from engine.kernels.rubbing import note_sliding
from engine.kernels.searching import fastest_within, inner_of_both, is_part, lowest_gap
from engine.kernels.simultaneous import strike_gathered
from engine.kernels.sleeping import wake
from engine.kernels.spring import (
    DAMPING,
    RESTLESS,
    frequency,
    set_spring,
    softness,
    softness_left,
)
from engine.kernels.steady import let_go
from engine.kernels.touches import OVERLAP, collect_last_part, leave, touch
from engine.linkage.tally import is_joined, joints_act
from engine.manifolds.any_pair import touching_points
from engine.tables import FREE, IMPACTS_AT_ONCE, LATER, NEVER, RESTING, Tables

TOUCHING = 1e-5
"""Gap at which a still pair comes to rest, as a share of the smaller body's reach."""

KEEPING = 5e-3
"""Gap beyond which a resting pair has parted, in the same unit; what overlaps by more, and neither
parts nor closes by a reach a second, rests: no bounce takes it out."""

JAMMED = 0.1
"""Share of its softness that a contact of joined bodies keeps under any load: where joints do not
let it open, it would grow stiffer with its load, and its load with its stiffness, without end."""

WHIRLING = 0.1
"""What turns by more within a part (rad), on a corner that nothing holds down, does not rest; what
turns by less sinks by a share of its square, once its other corner has been seen to (see
`aftermath`)."""

STALLS = 20
"""Parts without duration after which pairs are held: joints may take back at once what lets go."""

HOLDS, PARTED, SLAPS, LANDS = range(4)
"""What a resting pair does when a part begins: it goes on to rest; it has let go; a point of it
that carries nothing is hit faster than forces explain; one will be so later in the part."""


def settle(t: Tables, count: int, pair_count: int, shortest: float) -> int:
    """List the pairs that rest at the start of a part, but for those that wait; count for each body
    those it is held by.

    Args:
        t: the tables; clocks stand at zero.
        count: number of bodies.
        pair_count: number of pairs.
        shortest: flight that counts as none (s).
    """
    pairs = t.pairs
    one_sided = t.progress.one_sided[0] > 0
    waits = t.bodies.waits
    resting = 0
    for pair in range(pair_count):
        if pairs.state[pair] == FREE and pairs.apart[pair] > TOUCHING * pairs.size[pair]:
            continue
        if one_sided:
            notice_passing(t, pair)
        if pairs.state[pair] == FREE and nearly_touch(t, pair) and comes_to_rest(t, pair, shortest):
            touch(t, pair)
            if t.bodies.asleep[pairs.a[pair]] != t.bodies.asleep[pairs.b[pair]]:
                wake(t, pairs.a[pair])
                wake(t, pairs.b[pair])
            pairs.state[pair] = RESTING
            pairs.carried[pair] = 0.0
            pairs.steady[pair] = 0
            pairs.points[pair] = 0
            t.progress.begins[0] = 1
            rouse(t, pair)
        if pairs.state[pair] == RESTING and waits[pairs.a[pair]] + waits[pairs.b[pair]] == 0:
            pairs.resting[resting] = pair
            resting += 1
    t.lanes.sizes[2] = 0
    if resting >= CROWD and not joints_act(t):
        t.lanes.sizes[2] = 1 if is_packed(t, resting) else 0
    if resting > 0 or t.progress.straight[0] == 0:
        count_holds(t, count, resting)
    return resting


def count_holds(t: Tables, count: int, resting: int) -> None:
    """Count for each body the resting contacts that hold it."""
    held = t.bodies.held
    joined = t.bodies.joined
    for row in range(count):
        if t.bodies.waits[row] == 0:
            held[row] = joined[row]
    for k in range(resting):
        pair = t.pairs.resting[k]
        held[t.pairs.a[pair]] += 1
        held[t.pairs.b[pair]] += 1


def nearly_touch(t: Tables, pair: int) -> bool:
    """Whether the bounding circles of a pair, or circle and wall line, nearly touch."""
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    slack = TOUCHING * t.pairs.size[pair]
    wall = wall_of(t, pair)
    if wall < 0:
        x = bodies.x[b] - bodies.x[a]
        y = bodies.y[b] - bodies.y[a]
        reach = bodies.reach[a] + bodies.reach[b] + slack
        return x * x + y * y <= reach * reach
    body = a + b - t.pieces.body[wall]
    first = t.pieces.first[wall]
    above = t.corners.world_normal_x[first] * (
        bodies.x[body] - t.corners.world_x[first]
    ) + t.corners.world_normal_y[first] * (bodies.y[body] - t.corners.world_y[first])
    reach = bodies.reach[body] + t.pieces.radius[wall] + slack
    return -reach <= above <= reach


def comes_to_rest(t: Tables, pair: int, shortest: float) -> bool:
    """Whether a free pair that nearly touches rests from now on."""
    size = t.pairs.size[pair]
    place_pair(t, pair, 0.0)
    points = touching_points(t, pair)
    gap = lowest_gap(t, points)
    if points == 0 or gap > TOUCHING * size:
        return False
    speed = fastest_within(t, pair, points, 0.0, gap + 1e-8 * size)
    fastest = size if gap < -KEEPING * size else stillness(t, pair)
    if gap < -OVERLAP * size and -size < speed <= fastest:
        return True
    if stays(t, pair, speed if speed > 0.0 else -speed, shortest, True):
        return True
    return speed > 0.0 and slides_over(t, pair, speed, shortest)


def hold(
    t: Tables, count: int, resting: int, now: float, part: float, substep: float, anew: bool
) -> int:
    """Solve the resting contacts for a part of the tick (s); return how many pairs still rest.

    Contacts that close faster than forces explain are struck first: a box that rocks on a corner
    slaps the floor with the other. `anew`, that was done for a longer part, which is not taken.
    """
    for again in (anew, True):
        if resting > 0:
            place_middle(t, count, part / 2.0, again)
            if not again:
                resting = leave_to_bearing(t, resting, part)
        resting, queued = ready_all(t, resting, part, substep, again)
        if queued == 0:
            break
        strike_slaps(t, queued, now, part, substep)
    count_holds(t, count, resting)
    for row in range(count):
        if t.bodies.held[row] == 0:
            t.bodies.path_x[row] = t.bodies.ax[row]
            t.bodies.path_y[row] = t.bodies.ay[row]
            t.bodies.path_spin[row] = t.bodies.aspin[row]
    if resting > 0 or joints_act(t):
        kick(t, resting, count, part)
    return resting


def strike_slaps(t: Tables, queued: int, now: float, part: float, substep: float) -> None:
    """Strike the pairs in the queue, at the start of a part (s)."""
    bodies = t.bodies
    while queued > 0:
        pair = next_to_meet(t, queued)
        queued = dequeue(t, 0, queued)
        t.pairs.meeting[pair] = NEVER
        number, queued = gather(t, pair, now, 0.0, queued)
        strike_gathered(t, number, now, 0.0, substep, part, False)
        for k in range(number):
            struck = t.hits.gathered[k]
            for body in (t.pairs.a[struck], t.pairs.b[struck]):
                bodies.stirred[body] = 1
                bodies.placed[body] = 0


def ready_all(t: Tables, resting: int, part: float, substep: float, again: bool) -> tuple[int, int]:
    """Measure and ready the resting contacts for a part of the tick (s), and queue what slaps.

    `again`, only those of bodies that were struck. Returns how many pairs still rest, and how many
    are to be struck.
    """
    pairs = t.pairs
    stirred = t.bodies.stirred
    inverse_mass = t.bodies.inverse_mass
    omega = frequency(substep)
    damping = DAMPING * RESTLESS if t.state.restless[0] == 1 else DAMPING
    softly, yielding = softness(part, omega, damping)
    firmly, bearing = softness(part, 2.0 * omega, damping)
    some = again and not joints_act(t)
    packed = t.lanes.sizes[2] == 1
    kept = 0
    queued = 0
    for k in range(resting):
        pair = pairs.resting[k]
        pairs.acting[pair] = 0
        if pairs.state[pair] != RESTING:
            if packed:
                clear_lane(t, pairs.lane[pair])
            continue
        a = pairs.a[pair]
        b = pairs.b[pair]
        if some and stirred[a] == 0 and stirred[b] == 0:
            if packed:
                pairs.acting[pair] = pairs.points[pair]
            pairs.resting[kept] = pair
            kept += 1
            continue
        if not again:
            collect_last_part(t, pair)
        if pairs.steady[pair] == 1:
            let_go(t, pair, substep)
        if pairs.points[pair] > 0:
            note_opening(t, pair)
            follow(t, pair, 0.0)
        if has_drifted(t, pair):
            before = pairs.points[pair]
            find_points_once(t, pair, part / 2.0)
            if pairs.points[pair] == 0 and is_part(t, pair):
                pair = hand_on(t, pair, before, part)
                packed = packed and t.lanes.sizes[2] == 1
        if inverse_mass[a] == 0.0 or inverse_mass[b] == 0.0:
            does = prepare(t, pair, part, 2.0 * omega, firmly, bearing)
        else:
            does = prepare(t, pair, part, omega, softly, yielding)
        if does == PARTED and t.progress.stalled[0] < STALLS:
            leave(t, pair)
            pairs.state[pair] = FREE
            pairs.apart[pair] = 0.0
            if packed:
                clear_lane(t, pairs.lane[pair])
            continue
        touch(t, pair)
        pairs.meeting[pair] = LATER if does == LANDS else NEVER
        if does == SLAPS and not again and t.impacts.written[0] + queued < IMPACTS_AT_ONCE:
            pairs.meeting[pair] = 0.0
            queued = enqueue(t, pair, queued)
        if packed:
            load_points(t, pair, pairs.lane[pair])
        pairs.resting[kept] = pair
        kept += 1
    return kept, queued


def place_middle(t: Tables, count: int, half: float, again: bool) -> None:
    """Note where bodies that rest are in the middle of the part, contacts apart.

    `again`, because some were struck; else none counts as struck from now on.
    """
    bodies = t.bodies
    for row in range(count):
        if bodies.held[row] > 0:
            bodies.placed[row] = 0
            bodies.path_x[row] = 0.0
            bodies.path_y[row] = 0.0
            bodies.path_spin[row] = 0.0
            bodies.middle_x[row] = bodies.x[row] + bodies.vx[row] * half
            bodies.middle_y[row] = bodies.y[row] + bodies.vy[row] * half
            bodies.middle_angle[row] = bodies.angle[row] + bodies.spin[row] * half
            if not again or bodies.inverse_mass[row] == 0.0:
                bodies.stirred[row] = 0
            if not again:
                bodies.rides[row] = 0


def prepare(
    t: Tables,
    pair: int,
    part: float,
    omega: float,
    rate: float,
    yielding: float,
) -> int:
    """Ready a measured contact for a part (s); return what it does: see `HOLDS` and its like.

    Points that will land bear nothing before they do.

    Args:
        t: the tables.
        pair: which pair.
        part: how long the contact is to act (s).
        omega: circular frequency of its spring (1/s).
        rate: at which its overlaps are corrected (1/s).
        yielding: share of the impulse that its spring drops.
    """
    bodies = t.bodies
    contacts = t.contacts
    pairs = t.pairs
    a = pairs.a[pair]
    b = pairs.b[pair]
    nx = pairs.normal_x[pair]
    ny = pairs.normal_y[pair]
    size = pairs.size[pair]
    joined = is_joined(t, pair)
    left = softness_left(t, pair, omega)
    if joined and left < JAMMED:
        left = JAMMED
    soft = yielding * left
    explained = settling_speed(t, pair, part)
    note_sliding(t, pair)
    share = part / pairs.part[pair] if pairs.part[pair] > 0.0 else 0.0
    if share > 1.0:  # what stopped a motion in a short part is no load that lasts
        share = 1.0
    pairs.part[pair] = part
    opening = (bodies.vx[b] - bodies.vx[a]) * nx + (bodies.vy[b] - bodies.vy[a]) * ny
    spin_a = bodies.spin[a]
    spin_b = bodies.spin[b]
    lowest = 1e300
    fastest = -1e300
    parting = is_parting(t, pair)
    if parting:
        t.state.deep[0] = 2
    turns = its_normal_turns(t, pair)
    does = HOLDS
    for row in range(2 * pair, 2 * pair + pairs.points[pair]):
        gap = contacts.gap[row]
        closing = (
            spin_a * contacts.normal_arm_a[row] - spin_b * contacts.normal_arm_b[row] - opening
        )
        if gap < lowest:
            lowest = gap
        if closing > fastest:
            fastest = closing
        # Points that carry have the velocity that the last part left them: what is wrong with it
        # is the error of the solver, which the next sweep mends.
        lands = False
        if contacts.normal_impulse[row] == 0.0 and closing > explained:
            way = closing * part / 2.0  # gaps are those of the middle of the part
            more = explained * part / 2.0 if pairs.restitution[pair] > 0.0 else 0.0
            if gap <= way and (joined or gap <= TOUCHING * size - way):
                does = SLAPS
                pairs.speed[pair] = closing
            elif gap <= way + more:
                lands = True
                if does == HOLDS:
                    does = LANDS
        contacts.normal_impulse[row] *= share
        contacts.tangent_impulse[row] *= share
        opened = contacts.target[row]
        curls = -closing - opened if turns and opened < NEVER else 0.0
        set_spring(t, pair, row, part, rate, soft, parting, curls)
        if lands:
            contacts.hardness[row] = 0.0
    if turning(t, pair, part) > TUMBLING:
        return PARTED
    way = abs(opening) * part  # the normal may be that of the far side, if they were seen so deep
    if abs(opening) > size and not joined and plunges(t, pair, way, part, explained):
        return PARTED
    if lowest > KEEPING * size or (lowest > -OVERLAP * size and fastest < -explained):
        return PARTED
    return does


def plunges(t: Tables, pair: int, way: float, part: float, explained: float) -> bool:
    """Whether a pair whose centres move to each other by a `way` (m) in a part (s) sinks in as it
    turns on a corner that nothing holds down: what forces and loads have `explained` (m/s) is less
    than w^2 r does. Its other corners are to be met at their own instants.
    """
    turn = turning(t, pair, part)
    if turn * turn * t.pairs.size[pair] <= explained * part:
        return False
    return whirls(t, pair, part) or way > inner_of_both(t, pair)


def whirls(t: Tables, pair: int, lasts: float) -> bool:
    """Whether a pair turns so far on each other within `lasts` seconds that it is in flight between
    the blows of its corners. What is driven together again by every one of many blows does not
    leave: a face that turns into a disc as fast as the disc gives way has it slide along.
    """
    return t.pairs.bounces[pair] < BLOWS and turning(t, pair, lasts) > WHIRLING
