"""What rests and does not move needs no substeps: forces alone are balanced, once a tick at most.

Impulses that stop what still moves must not be taken for loads that last, or heaps would rock
themselves up. So the sweep starts from the loads of the last part and balances the accelerations;
what velocity the bodies have is left to the pass without springs at the end of the part. Contacts
are rigid meanwhile: overlaps stay as they are.

Bodies that stick to the ground do not move at all (see `sticking`). Once sweeps have settled, the
loads go on to bear the forces as they are for some ticks, until they no longer do,
or somebody acts on the world.
"""

from engine.kernels.books import note_part
from engine.kernels.contacts import STEADY_SWEEPS, STILL, stiffen
from engine.kernels.following import find_points, follow, has_drifted
from engine.kernels.halting import halt_fixed
from engine.kernels.rubbing import slip_of
from engine.kernels.sticking import FIXED, HELD, find_fixed
from engine.kernels.sweeps import QUIET, warm_start
from engine.kernels.touches import impulses_of, touch
from engine.linkage.limb_groups import calm_groups
from engine.linkage.limb_guesses import keep_limb_impulses
from engine.linkage.limb_sweeps import bear_evenly, keep_loads, sweep_all
from engine.tables import Tables

MOVING, UNEVEN, BALANCED, RELYING = 0, 1, 2, 3
"""How forces are borne in a tick: not steadily; steadily, but sweeps have not come to their end;
they have; by the loads of the last tick."""

SLOW = 1e-3
"""Bodies that move slower are calm, in reaches of each a second (1/s)."""

FAST = 4e-3
"""Bodies that move faster are no longer calm, in the same unit."""

EVEN = 0.1
"""Share that counts of what changes a disc's velocity: discs may roll, if they do it evenly."""

ROLLING = 1.0
"""Discs that roll faster are not calm: they may soon leave what they rest on, in reaches a second
(1/s)."""

SLIDING = 1e-4
"""What slides faster is braked by friction, so is not steady, in the same unit."""

RESISTED = 1e-6
"""What rolls faster against resistance is not steady either (rad/s)."""

LONG = 12
"""Ticks for which all that rests must have been calm to be steady: what swings stands still too,
where it turns."""

LATER = 4
"""What is not steady, though it has been calm, is not tried again for so many ticks."""

BEARING = 1e-3
"""If one sweep changes no velocity by more, loads bear the forces, in reaches a second (1/s)."""

TRUSTED = 8
"""Ticks for which loads that balance the forces are relied on."""

EXACTLY = 5e-6
"""What forces may change a velocity by in a tick more than when they were balanced, while loads are
relied on, in the same unit."""


def is_unsteady(t: Tables, pair: int) -> bool:
    """Whether a contact is new, so that it has no points or has borne nothing yet; runs, rolls
    against resistance, slides on for more than a part, or is one with something immovable that
    moves.
    """
    pairs = t.pairs
    if pairs.points[pair] == 0 or pairs.part[pair] == 0.0 or pairs.belt_speed[pair] != 0.0:
        return True
    bodies = t.bodies
    a = pairs.a[pair]
    b = pairs.b[pair]
    if bodies.calm[a] < LONG or bodies.calm[b] < LONG:
        return True
    if pairs.rolling_resistance[pair] > 0.0 and abs(bodies.spin[b] - bodies.spin[a]) > RESISTED:
        return True
    if carries_away(t, a) or carries_away(t, b):
        return True
    return is_braked(t, pair) and not is_stopped(t, pair)


def carries_away(t: Tables, row: int) -> bool:
    """Whether a body is immovable and moves, however slowly: what it pushes slides on."""
    bodies = t.bodies
    if bodies.inverse_mass[row] > 0.0:
        return False
    return bodies.vx[row] != 0.0 or bodies.vy[row] != 0.0 or bodies.spin[row] != 0.0


def is_braked(t: Tables, pair: int) -> bool:
    """Whether a contact slides and friction can do no more against it."""
    if abs(slip_of(t, pair)) <= SLIDING * t.pairs.size[pair]:
        return False
    push, rub = impulses_of(t, pair)
    return push > 0.0 and abs(rub) >= HELD * t.pairs.static_friction[pair] * push


def is_stopped(t: Tables, pair: int) -> bool:
    """Whether as much friction as in the last part would stop the sliding of a contact."""
    _, rub = impulses_of(t, pair)
    return abs(slip_of(t, pair)) * t.contacts.tangent_mass[2 * pair] <= abs(rub)


def slides_on(t: Tables, resting: int) -> bool:
    """Whether something slides that others do not fix, so that it is braked; it is put off.

    What creeps over one neighbour, while the ground holds it by others, is at its end.
    """
    bodies = t.bodies
    slides = False
    for k in range(resting):
        pair = t.pairs.resting[k]
        a = t.pairs.a[pair]
        b = t.pairs.b[pair]
        if bodies.stuck[a] + bodies.stuck[b] < FIXED + FIXED and is_braked(t, pair):
            put_off(t, a)
            put_off(t, b)
            slides = True
    return slides


def put_off(t: Tables, row: int) -> None:
    """Let a body that was not steady, though it has been calm, not be tried for some ticks."""
    if t.bodies.inverse_mass[row] > 0.0:
        t.bodies.calm[row] = LONG - LATER


def watch(t: Tables, row: int, dt: float) -> None:
    """Count for how many ticks (of `dt` seconds) a body has been calm.

    What moves, though it has no velocity, is being pushed out of an overlap.
    """
    bodies = t.bodies
    reach = bodies.reach[row]
    vx = bodies.vx[row]
    vy = bodies.vy[row]
    spin = bodies.spin[row] * reach
    x = bodies.x[row] - bodies.last_x[row]
    y = bodies.y[row] - bodies.last_y[row]
    turn = (bodies.angle[row] - bodies.last_angle[row]) * reach
    speed = abs(vx) + abs(vy) + abs(spin)
    moved = (abs(x) + abs(y) + abs(turn)) / dt
    if bodies.pieces[row] == 1 and t.pieces.swing[bodies.first_piece[row]] == 0.0:
        if speed <= ROLLING * reach:
            change = abs(vx - bodies.last_vx[row]) + abs(vy - bodies.last_vy[row])
            speed = EVEN * change
        moved = EVEN * (abs(x / dt - vx) + abs(y / dt - vy) + abs(turn / dt - spin))
    bodies.last_x[row] = bodies.x[row]
    bodies.last_y[row] = bodies.y[row]
    bodies.last_angle[row] = bodies.angle[row]
    bodies.last_vx[row] = vx
    bodies.last_vy[row] = vy
    if moved > speed:
        speed = moved
    if speed <= SLOW * reach or (speed <= FAST * reach and bodies.calm[row] >= LONG):
        bodies.calm[row] += 1
    else:
        bodies.calm[row] = 0


def is_loose(t: Tables, count: int) -> bool:
    """Whether something that rests steadily moves all the same: it may roll, or creep."""
    bodies = t.bodies
    for row in range(count):
        if bodies.held[row] > 0 and bodies.inverse_mass[row] > 0.0 and bodies.stuck[row] != FIXED:
            return True
    return False


def relies(t: Tables, count: int, resting: int, part: float, loose: bool) -> bool:
    """Bear the forces for a part of the tick (s) by the loads of the last one, if they still do; at
    where bodies that are `loose` will be in its middle.
    """
    state = t.state
    if state.trusted[0] == 0:
        return False
    state.trusted[0] -= 1
    bodies = t.bodies
    for k in range(resting):
        if t.pairs.steady[t.pairs.resting[k]] == 0:
            return False
        take_up(t, t.pairs.resting[k], part)
        if loose:
            follow(t, t.pairs.resting[k], 0.0)
    push_all(t, count, part)
    warm_start(t, resting)
    bear_evenly(t, part)
    for row in range(count):
        if bodies.held[row] > 0 and strays(t, row, EXACTLY):
            return False
    for k in range(resting):
        touch(t, t.pairs.resting[k])
    keep_limb_impulses(t, part)
    bend(t, count, part)
    return True


def strays(t: Tables, row: int, most: float) -> bool:
    """Whether loads leave a body another change of velocity than when forces were last balanced, by
    more than `most` (reaches a second).
    """
    bodies = t.bodies
    reach = bodies.reach[row]
    more = abs(bodies.kick_x[row] - bodies.left_x[row])
    more += abs(bodies.kick_y[row] - bodies.left_y[row])
    more += abs(bodies.kick_spin[row] - bodies.left_spin[row]) * reach
    return more > most * reach


def balance(t: Tables, count: int, resting: int, part: float) -> int:
    """Bear the forces for a part of the tick (s) and bend the paths of what rests accordingly.

    Bodies are noted at their middle poses. Returns `MOVING` if one sweep does not nearly do it;
    else the loads are still good to start from: `UNEVEN` or `BALANCED`.
    """
    contacts = t.contacts
    for k in range(resting):
        pair = t.pairs.resting[k]
        take_up(t, pair, part)
        follow(t, pair, 0.0)
        if has_drifted(t, pair):
            find_points(t, pair, part / 2.0)
        stiffen(t, pair, part)
        foresee(t, pair)
    push_all(t, count, part)
    warm_start(t, resting)
    bear_evenly(t, part)
    for row in range(count):
        if t.bodies.held[row] > 0:
            t.bodies.left_x[row] = t.bodies.kick_x[row]
            t.bodies.left_y[row] = t.bodies.kick_y[row]
            t.bodies.left_spin[row] = t.bodies.kick_spin[row]
    found = MOVING
    if sweep_all(t, resting, BEARING, False) == QUIET:
        found = BALANCED if calm_groups(t, resting, STEADY_SWEEPS, STILL) else UNEVEN
    keep_loads(t, part)
    for k in range(resting):
        pair = t.pairs.resting[k]
        for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
            contacts.normal_load[row] = contacts.normal_impulse[row] / part
            contacts.tangent_load[row] = contacts.tangent_impulse[row] / part
    if found == MOVING:
        return found
    find_fixed(t, count, resting)
    if slides_on(t, resting):
        return MOVING
    for k in range(resting):
        touch(t, t.pairs.resting[k])
    keep_limb_impulses(t, part)
    halt_fixed(t, count, resting)
    bend(t, count, part)
    return found


def push_all(t: Tables, count: int, part: float) -> None:
    """Kick what rests by the forces of a part of the tick (s)."""
    bodies = t.bodies
    for row in range(count):
        if bodies.held[row] > 0:
            bodies.kick_x[row] = bodies.ax[row] * part
            bodies.kick_y[row] = bodies.ay[row] * part
            bodies.kick_spin[row] = bodies.aspin[row] * part


def bend(t: Tables, count: int, part: float) -> None:
    """Bend the paths of what rests by what forces and loads kick it in a part of the tick (s); what
    is fixed stays.
    """
    bodies = t.bodies
    for row in range(count):
        if bodies.held[row] > 0:
            note_part(bodies, row)
            bodies.left_x[row] = bodies.kick_x[row]
            bodies.left_y[row] = bodies.kick_y[row]
            bodies.left_spin[row] = bodies.kick_spin[row]
            if bodies.stuck[row] == FIXED:
                bodies.path_x[row] = 0.0
                bodies.path_y[row] = 0.0
                bodies.path_spin[row] = 0.0
            else:
                bodies.path_x[row] = bodies.kick_x[row] / part
                bodies.path_y[row] = bodies.kick_y[row] / part
                bodies.path_spin[row] = bodies.kick_spin[row] / part
            bodies.kick_x[row] = bodies.vx[row] + bodies.path_x[row] * part
            bodies.kick_y[row] = bodies.vy[row] + bodies.path_y[row] * part
            bodies.kick_spin[row] = bodies.spin[row] + bodies.path_spin[row] * part


def foresee(t: Tables, pair: int) -> None:
    """Count with how fast what gapes already closes: only accelerations are balanced."""
    bodies = t.bodies
    contacts = t.contacts
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        if contacts.target[row] > 0.0:
            vx = bodies.vx[b] - bodies.vx[a]
            vy = bodies.vy[b] - bodies.vy[a]
            opening = vx * t.pairs.normal_x[pair] + vy * t.pairs.normal_y[pair]
            opening += bodies.spin[b] * contacts.normal_arm_b[row]
            contacts.target[row] += opening - bodies.spin[a] * contacts.normal_arm_a[row]


def take_up(t: Tables, pair: int, part: float) -> None:
    """Let a contact start a steady part (s) from the load of its last part."""
    contacts = t.contacts
    before = t.pairs.part[pair]
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        if t.pairs.steady[pair] == 0:
            contacts.normal_load[row] = contacts.normal_impulse[row] / before
            contacts.tangent_load[row] = contacts.tangent_impulse[row] / before
        contacts.normal_impulse[row] = contacts.normal_load[row] * part
        contacts.tangent_impulse[row] = contacts.tangent_load[row] * part
    if t.pairs.steady[pair] == 0:
        t.pairs.carried[pair] *= part / before
    t.pairs.steady[pair] = 1
    t.pairs.slid[pair] = 0.0
    t.pairs.part[pair] = part


def let_go(t: Tables, pair: int, substep: float) -> None:
    """Let a contact that was steady go on as if it had borne its load for a substep (s)."""
    contacts = t.contacts
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        contacts.normal_impulse[row] = contacts.normal_load[row] * substep
        contacts.tangent_impulse[row] = contacts.tangent_load[row] * substep
    t.pairs.carried[pair] *= substep / t.pairs.part[pair]
    t.pairs.part[pair] = substep
    t.pairs.steady[pair] = 0
