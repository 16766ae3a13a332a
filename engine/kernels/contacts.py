"""Bodies that rest on each other: soft contacts, warm-started, several parts to a tick.

The method is that of Box2D v3 (Erin Catto, "Solver2D", 2024): sequential impulses against a contact
that behaves like a stiff, strongly damped spring while positions are corrected, then a pass without
the spring that takes back the velocity which the correction lent. Impulses start from those of the
part before. Each is exchanged at one common point while the bodies stand in the middle of the part
of the tick (or, when relaxing, at its end), so that angular momentum is kept to rounding.
"""

from engine.kernels.books import book_relax, note_part
from engine.kernels.crowds import sweep_until_calm, warm_start_crowd
from engine.kernels.following import (
    TUMBLING,
    follow,
    has_swerved,
    turning,
    weigh_if_racing,
)
from engine.kernels.gaining import only_forces_drive, sweep_on
from engine.kernels.handing import find_last_points
from engine.kernels.impacts import settling_speed
from engine.kernels.packing import load_points, pack, pack_again, unload
from engine.kernels.riding import follow_curves
from engine.kernels.sweeps import QUIET, WILD, warm_start
from engine.kernels.swinging import obey, swing
from engine.kernels.touches import collect
from engine.linkage.limb_groups import (
    EASING,
    EVENLY,
    PRESSING,
    calm_groups,
    only_trees_touch,
    sweep_groups,
)
from engine.linkage.limb_motion import bind_limbs
from engine.linkage.limb_sweeps import sweep_all
from engine.linkage.limb_velocities import ease_limbs
from engine.linkage.loaded import JAMS, bear_loads, list_loaded
from engine.linkage.modes import CLOSING, HOLDS
from engine.linkage.positions import (
    bind,
    brace,
    hold_less,
    keep_impulses,
)
from engine.linkage.tally import is_joined, joints_act
from engine.linkage.throwing import drive_each_other
from engine.linkage.velocities import ease, keep_ends, prepare_ease
from engine.tables import RESTING, Tables

CALM = 0.02
"""A sweep that changes no contact's velocity by more is the last, in reaches of the smaller body a
second (1/s): at rest one sweep is enough."""

MOST_SWEEPS = 8
"""Sweeps that a part has at most, and twice as many where heavy bodies rest on light ones."""

HEAVY = 10.0
"""So many times as heavy: the weight of one shakes the other between two contacts."""

VIOLENT = 1e4
"""Where forces or contacts change a velocity by more within a part, in reaches a second (1/s),"""

PATIENT_SWEEPS = 3000
"""a part has so many sweeps at most: what they leave is a share of that change."""

STEADY_SWEEPS = 16
"""Sweeps of a steady part at most, and twice as many to relax."""

STILL = 1e-5
"""A sweep of a steady part that changes no velocity by more is the last, in the same unit."""

BARELY = 1e-9
"""Bodies that moved less since the middle of the part, in reaches of the smaller one, relax where
they were: what they still exchange is as little."""

WILD_SWEEPS = 4
"""Sweeps after which contacts that are still wild are left as they are, as bodies tumble; not where
joints act that are no hinges of trees, whose strain would grow."""

CROWD = 64
"""Contacts from which on they are taken in turns and side by side; see `packing` and `crowds`."""

CROWD_SWEEPS = 2
"""Sweeps of a crowd that correct overlaps, at most, unless heavy bodies rest on light ones: those
that relax matter more. Else high heaps would boil without end. A crowd that is not calm by then is
restless: it relaxes no further than to be calm, and its overlaps are corrected more slowly in the
next part."""

FINE = 1e-5
"""As `CALM`, to relax: sweeps without the spring also calm what rocks as a whole, of which each
takes little."""


def kick(t: Tables, resting: int, count: int, part: float) -> None:
    """Find what velocities the bodies have at the end of the part (s); bend their paths to it."""
    if resting == 0 and t.braces.sizes[0] == 0:
        swing(t, count, part)
        return
    bodies = t.bodies
    violent = is_violent(t, resting)
    calm = False
    for row in range(count):
        if bodies.held[row] > 0:
            ax = bodies.ax[row]
            ay = bodies.ay[row]
            bodies.kick_x[row] = bodies.vx[row] + ax * part
            bodies.kick_y[row] = bodies.vy[row] + ay * part
            bodies.kick_spin[row] = bodies.spin[row] + bodies.aspin[row] * part
            if (abs(ax) + abs(ay)) * part > VIOLENT * bodies.reach[row]:
                violent = True
    brace(t, part)
    if violent:
        harden(t, resting)
    crowded = is_crowd(t, resting, violent)
    if crowded:
        if t.lanes.sizes[2] == 0:
            pack(t, resting, count)
        warm_start_crowd(t)
    else:
        t.lanes.sizes[2] = 0
        warm_start(t, resting)
    t.progress.sweeps[0] = 2 * MOST_SWEEPS if is_uneven(t, resting) else MOST_SWEEPS
    gives_up = not violent and not crowded and t.braces.sizes[0] == 0
    t.state.restless[0] = 0
    most = PATIENT_SWEEPS if violent else t.progress.sweeps[0]
    if crowded:
        calm = sweep_until_calm(t, CROWD_SWEEPS if most == MOST_SWEEPS else most, CALM, 0)
        t.state.restless[0] = 0 if calm else 1
    elif only_trees_touch(t):
        early = WILD_SWEEPS if gives_up else most + 1
        few = PRESSING if most == MOST_SWEEPS else most
        sweep_groups(t, resting, most, few, CALM, CALM, early, True)
    else:
        calm = press(t, resting, count, part, most, gives_up)
    if not calm and not joints_act(t) and only_forces_drive(t, count):
        sweep_on(t, resting, count, part, CALM, crowded)
    bind_limbs(t, part)
    keep_impulses(t, part)
    for row in range(count):
        if bodies.held[row] > 0:
            bodies.path_x[row] = (bodies.kick_x[row] - bodies.vx[row]) / part
            bodies.path_y[row] = (bodies.kick_y[row] - bodies.vy[row]) / part
            bodies.path_spin[row] = (bodies.kick_spin[row] - bodies.spin[row]) / part
            note_part(bodies, row)


def press(t: Tables, resting: int, count: int, part: float, most: int, gives_up: bool) -> bool:
    """Sweep over contacts, `most` times at most, and let joints hold at the end of the part (s)
    each time; for the wild that are left as they are see `has_settled`. Returns whether contacts
    became calm.

    Where contacts and joints drive each other, joints hold to first order only, and keep their gaps
    in this part if that does not help.
    """
    free = list_loaded(t, resting)
    calm, failed = press_and_bind(t, free, resting, part, most, gives_up)
    if t.braces.sizes[0] == 0 or resting == 0 or not only_forces_drive(t, count):
        return calm
    while t.braces.sizes[7] != HOLDS and (failed > CLOSING or drive_each_other(t, count, part)):
        hold_less(t)
        calm, failed = press_and_bind(t, resting, resting, part, most, gives_up)
    return calm


def press_and_bind(
    t: Tables, free: int, resting: int, part: float, most: int, gives_up: bool
) -> tuple[bool, float]:
    """The same, whatever energy that takes; return also how fast joints failed it before the last
    sweep (1/s). Pairs from place `free` on bear loads together with joints.

    Where joints find no solution, contacts are swept again without: what held them was not there.
    """
    swept = 0
    failed = 0.0
    while swept < most:
        swept += 1
        bound = t.braces.sizes[7] == 0
        found = sweep_all(t, free, CALM, swept % 2 == 0)
        failed = bind(t, part)
        if free < resting and t.braces.sizes[7] == 0:
            borne = bear_loads(t, free, resting, CALM, True, swept == 1)
            failed = bind(t, part)
            found = borne if borne > found else found
        if found == JAMS or (bound and t.braces.sizes[7] > 0):
            swept = 0
            free = resting
        elif has_settled(found, gives_up and swept == WILD_SWEEPS) and (
            resting == 0 or failed <= CALM
        ):
            return found == QUIET, failed
    return False, failed


def is_crowd(t: Tables, resting: int, violent: bool) -> bool:
    """Whether so many rest that sweeps take them as a crowd; not where joints or violence act."""
    return resting >= CROWD and not violent and not joints_act(t)


def has_settled(found: int, last: bool) -> bool:
    """Whether what a sweep found ends the sweeps: quiet, or still wild in the last for the wild."""
    return found == WILD if last else found == QUIET


def is_violent(t: Tables, resting: int) -> bool:
    """Whether a contact carried more in its last part than forces of everyday life make it.

    What joints hold may stop at once where it jams, and the limb that it jams be light.
    """
    pairs = t.pairs
    for k in range(resting):
        pair = pairs.resting[k]
        if not is_joined(t, pair) and pairs.carried[pair] > VIOLENT * pairs.size[pair]:
            return True
    return False


def harden(t: Tables, resting: int) -> None:
    """Take all springs for rigid: loads that are immense go through contacts that cannot know."""
    contacts = t.contacts
    for k in range(resting):
        pair = t.pairs.resting[k]
        for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
            contacts.hardness[row] = contacts.normal_mass[row]
            contacts.softness[row] = 0.0


def relax(t: Tables, resting: int, count: int, part: float, done: float, steady: bool) -> bool:
    """Take back, at the end of a part (s), the velocity that correcting overlaps has lent.

    `done` is the share of the part after which it ended. Returns whether contacts are still.
    """
    if resting == 0 and t.braces.sizes[0] == 0:
        obey(t, part, done)
        return False
    bodies = t.bodies
    for row in range(count):
        if bodies.held[row] > 0:
            bodies.kick_x[row] = bodies.vx[row]
            bodies.kick_y[row] = bodies.vy[row]
            bodies.kick_spin[row] = bodies.spin[row]
            bodies.middle_x[row] = bodies.x[row]
            bodies.middle_y[row] = bodies.y[row]
            bodies.middle_angle[row] = bodies.angle[row]
    packed = t.lanes.sizes[2] == 1 and not steady
    left = follow_to_end(t, resting, part, packed)
    prepare_ease(t, part, done)
    still = False
    if steady:
        still = calm_groups(t, left, 2 * STEADY_SWEEPS, STILL)
    else:
        calm_down(t, left, count)
    ease_limbs(t, False)
    keep_ends(t, part, done, steady)
    t.lanes.sizes[2] = 0
    book_relax(t, left, count)
    for row in range(count):
        if bodies.held[row] > 0:
            bodies.vx[row] = bodies.kick_x[row]
            bodies.vy[row] = bodies.kick_y[row]
            bodies.spin[row] = bodies.kick_spin[row]
            bodies.path_x[row] = bodies.ax[row]
            bodies.path_y[row] = bodies.ay[row]
            bodies.path_spin[row] = bodies.aspin[row]
    if not steady:
        follow_curves(t, left)
    return still


def follow_to_end(t: Tables, resting: int, part: float, packed: bool) -> int:
    """Measure contacts where their bodies are at the end of a part (s), and ready them to relax;
    return how many still rest.
    """
    left = 0
    for k in range(resting):
        pair = t.pairs.resting[k]
        row = t.pairs.lane[pair] if packed else -1
        if t.pairs.state[pair] == RESTING and turning(t, pair, part) <= TUMBLING:
            follow(t, pair, BARELY)
            if has_swerved(t, pair):
                collect(t, pair, 1.0)  # along the normal as it was
                find_last_points(t, pair)
                collect(t, pair, -1.0)
            remember(t, pair)  # of the points that relax: what let go in the part may have new ones
            weigh_if_racing(t, pair)
            stiffen(t, pair, part)
            if row >= 0:
                load_points(t, pair, row)
            t.pairs.resting[left] = pair
            left += 1
        elif row >= 0:
            unload(t, row)
        t.pairs.acting[pair] = 0
    return left


def calm_down(t: Tables, left: int, count: int) -> None:
    """Sweep over contacts that are ready to relax until no point approaches."""
    violent = is_violent(t, left)
    polish = CALM if violent or t.state.restless[0] == 1 else FINE
    crowded = is_crowd(t, left, violent)
    gives_up = not violent and not crowded and t.braces.sizes[0] == 0
    most = PATIENT_SWEEPS if violent else t.progress.sweeps[0]
    if crowded:
        pack_again(t, left, count)
        sweep_until_calm(t, most, polish, 1)
    elif only_trees_touch(t):
        early = WILD_SWEEPS if gives_up else most + 1
        few = EASING if most == MOST_SWEEPS else most
        sweep_groups(t, left, most, few, polish, EVENLY, early, False)
    else:
        free = list_loaded(t, left)
        for i in range(1, most + 1):
            found = sweep_all(t, free, polish, i % 2 == 1)
            failed = ease(t, found == QUIET)
            if free < left:
                borne = bear_loads(t, free, left, polish, False, False)
                failed = ease(t, borne == QUIET and found == QUIET)
                found = borne if borne > found else found
                free = left if found == JAMS else free
            if has_settled(found, gives_up and i == WILD_SWEEPS) and (left == 0 or failed <= CALM):
                return


def is_uneven(t: Tables, resting: int) -> bool:
    """Whether bodies of very different mass rest on each other."""
    inverse_mass = t.bodies.inverse_mass
    for k in range(resting):
        pair = t.pairs.resting[k]
        a = inverse_mass[t.pairs.a[pair]]
        b = inverse_mass[t.pairs.b[pair]]
        if a > HEAVY * b > 0.0 or b > HEAVY * a > 0.0:
            return True
    return False


def stiffen(t: Tables, pair: int, part: float) -> None:
    """Let no point of a contact approach further; what gapes may close within a part (s), unless
    it bears a steady load. What will bounce there is left to the part in which it lands.
    """
    contacts = t.contacts
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        gap = contacts.gap[row]
        bears = t.pairs.steady[pair] == 1 and contacts.normal_load[row] > 0.0
        bounces = not bears and t.pairs.restitution[pair] > 0.0 and falls(t, pair, row, part)
        contacts.target[row] = 2.0 * gap / part if gap > 0.0 and not bears else 0.0
        contacts.hardness[row] = 0.0 if bounces else contacts.normal_mass[row]
        contacts.softness[row] = 0.0


def falls(t: Tables, pair: int, row: int, part: float) -> bool:
    """Whether a point that bore nothing in a part (s) closes faster than forces explain."""
    if t.contacts.normal_impulse[row] > 0.0:
        return False
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    closing = (bodies.kick_x[a] - bodies.kick_x[b]) * t.pairs.normal_x[pair]
    closing += (bodies.kick_y[a] - bodies.kick_y[b]) * t.pairs.normal_y[pair]
    closing += bodies.kick_spin[a] * t.contacts.normal_arm_a[row]
    closing -= bodies.kick_spin[b] * t.contacts.normal_arm_b[row]
    return closing > settling_speed(t, pair, part)


def remember(t: Tables, pair: int) -> None:
    """Note the change of normal velocity that the contact brought about (m/s), and its impulses."""
    contacts = t.contacts
    t.pairs.booked_rolling[pair] = t.pairs.rolling_torque[pair] * t.pairs.part[pair]
    carried = 0.0
    for row in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        contacts.booked_normal[row] = contacts.normal_impulse[row]
        contacts.booked_tangent[row] = contacts.tangent_impulse[row]
        change = contacts.normal_impulse[row] / contacts.normal_mass[row]
        if change > carried:
            carried = change
    t.pairs.carried[pair] = carried
