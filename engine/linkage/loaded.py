"""Contacts through which light joined bodies bear heavy ones: solved together with the joints.

A sweep stops at a contact what its own two bodies bring; joints then bring more of what is joined
to them, and so on: a leg of a table takes as many turns as the top is heavier. So the contacts of
such a structure are solved with all that joints answer at once (`delassus`), and impulses have
their bounds (Signorini, Coulomb; `kernels.complementarity`). Trees of hinges go their own way
(`limb_sweeps`), but for carts on light wheels (`order.is_cart`).
"""

from engine.kernels.complementarity import UNBOUNDED, change_within, solve_bounded
from engine.kernels.rubbing import resist_rolling
from engine.kernels.sweeps import LESS_CALM, QUIET, STIRRED
from engine.linkage.delassus import (
    answer,
    be_still,
    couple_through_joints,
    node_in,
    shake,
    shake_node,
)
from engine.linkage.impulses import add
from engine.linkage.moments import book_braces
from engine.linkage.positions import deliver
from engine.linkage.tally import has_braces, node_of
from engine.tables import MOST_HITS, Tables

HEAVY = 10.0
"""A structure is solved like that where it, or what lies on it, is so many times as heavy as what
bears it there: sweeps do for others."""

ROUNDS = 3
"""So often friction is found anew, from what presses, and the other way round."""

PASSES = 24
"""So often at most points are passed over in each of these."""

ENOUGH = 1e-4
"""No speed changes by more in the last of them, in reaches of the smaller body a second (1/s)."""


HELD = 1e-3
"""What yields less than this share of what the heaviest body of its structure alone would is held
by the joints, as a weld to what moves by itself: no impulse stops it, nor is one sought that could.
"""


OVERCOME = 100.0
"""No contact gets an impulse by which the heaviest of all bodies would change its speed so many
times as much as what is to be stopped: what is squeezed between two that do not yield cannot obey
both."""

JAMS = 3
"""What `bear_loads` finds, beside what a sweep does: no impulses that do so, or immense ones."""


def list_loaded(t: Tables, resting: int) -> int:
    """Note for each resting pair which structure it bears by a much lighter body; list those that
    do last, and return the number of the others.
    """
    if t.braces.sizes[0] == 0:
        return resting
    pairs = t.pairs
    free = 0
    loaded = 0
    for k in range(resting):
        pair = pairs.resting[k]
        pairs.bears[pair] = structure_of(t, pairs.a[pair], pairs.b[pair])
        if pairs.bears[pair] < 0:
            pairs.resting[free] = pair
            free += 1
        else:
            pairs.grouped[loaded] = pair
            loaded += 1
    for k in range(loaded):
        pairs.resting[free + k] = pairs.grouped[k]
    return free


def structure_of(t: Tables, a: int, b: int) -> int:
    """The structure that bears a heavy load where two bodies touch, or is borne there: of the
    joined one, or the lighter, if that is far too light for the load; -1 if it is not. Bodies of
    one structure bear nothing but each other.
    """
    bodies = t.bodies
    of_a = t.nodes.structure[node_of(t, a)] if has_braces(t, a) else -1
    of_b = t.nodes.structure[node_of(t, b)] if has_braces(t, b) else -1
    if of_a == of_b:
        return -1
    bears = a
    other = b
    structure = of_a
    if of_a < 0 or (of_b >= 0 and bodies.mass[b] < bodies.mass[a]):
        bears = b
        other = a
        structure = of_b
    most = HEAVY * bodies.mass[bears]
    heavy = bodies.inverse_mass[other] > 0.0 and bodies.mass[other] > most
    return structure if heavy or t.structures.heaviest[structure] > most else -1


def bear_loads(t: Tables, free: int, resting: int, calm: float, within: bool, fresh: bool) -> int:
    """Solve the contacts of each loaded structure together with its joints, whose velocities obey.

    Args:
        t: the tables.
        free: place of the first pair that bears a structure,
        resting: and of the end of the list.
        calm: change of a velocity that does not count (reaches a second).
        within: whether contacts act in a part, at whose start joints answer, or at its end, at
            which they are left to answer by themselves.
        fresh: whether this is the first time in the part.

    Returns how velocities changed, as `sweep` does, or `JAMS`. What joints do not know yet, as
    limits and motors that change their minds, is left to what follows.
    """
    pairs = t.pairs
    found = QUIET
    for k in range(free, resting):
        structure = pairs.bears[pairs.resting[k]]
        if is_first(t, free, k, structure):
            points = list_points(t, k, resting, structure)
            couple_through_joints(t, points, structure)
            if fresh:
                stiffen(t, points)
            fastest = want(t, points, structure)
            find_loads(t, points)
            if is_jammed(t, points, structure, fastest):
                return JAMS
            if give_loads(t, points, structure, calm):
                found = STIRRED
            if brake_rolling(t, points, structure, calm):
                found = STIRRED
            if within:
                answer_loads(t, structure)
    return found


def is_first(t: Tables, free: int, k: int, structure: int) -> bool:
    """Whether no pair that is listed before place `k` bears the same structure."""
    for before in range(free, k):  # noqa: SIM110, a loop that can be compiled
        if t.pairs.bears[t.pairs.resting[before]] == structure:
            return False
    return True


def list_points(t: Tables, k: int, resting: int, structure: int) -> int:
    """List the points of pairs, from place `k` on, that bear a structure; return their number.

    Each is two of the `Unknowns`: the impulses along the normals, then those along the tangents.
    Those for which there is no room are left as they are.
    """
    pairs = t.pairs
    points = 0
    for at in range(k, resting):
        pair = pairs.resting[at]
        if pairs.bears[pair] == structure and 2 * (points + pairs.points[pair]) <= MOST_HITS:
            for row in range(2 * pair, 2 * pair + pairs.points[pair]):
                t.unknowns.contact[points] = row
                points += 1
    aim_points(t, points)
    return points


def aim_points(t: Tables, points: int) -> None:
    """Say of the impulses of listed points along what and with which levers they act, and how large
    they are.
    """
    pairs = t.pairs
    contacts = t.contacts
    unknowns = t.unknowns
    for point in range(points):
        row = unknowns.contact[point]
        pair = row // 2
        x = pairs.normal_x[pair]
        y = pairs.normal_y[pair]
        unknowns.along_x[point] = x
        unknowns.along_y[point] = y
        unknowns.arm_a[point] = contacts.normal_arm_a[row]
        unknowns.arm_b[point] = contacts.normal_arm_b[row]
        unknowns.value[point] = contacts.normal_impulse[row]
        along = points + point
        unknowns.along_x[along] = -y
        unknowns.along_y[along] = x
        unknowns.arm_a[along] = contacts.tangent_arm_a[row]
        unknowns.arm_b[along] = contacts.tangent_arm_b[row]
        unknowns.value[along] = contacts.tangent_impulse[row]
        for unknown in (point, along):
            unknowns.a[unknown] = pairs.a[pair]
            unknowns.b[unknown] = pairs.b[pair]


def answer_loads(t: Tables, structure: int) -> None:
    """Let joints answer, at the start of a part, to what contacts changed (`give_loads`)."""
    answer(t, structure)
    for row in range(t.braces.sizes[2]):
        t.equations.total[row] = 0.0
    for row in range(t.structures.first[structure], t.structures.end[structure]):
        add(t, row, t.equations.unknown[row])
    book_braces(t, 0.0, False)
    deliver(t)


def stiffen(t: Tables, points: int) -> None:
    """Make springs of contacts as stiff as what they bear is heavy: they were made for the two
    bodies alone.
    """
    contacts = t.contacts
    for point in range(points):
        row = t.unknowns.contact[point]
        if contacts.softness[row] > 0.0:
            yields = t.delassus.coupling[2 * points * point + point]
            contacts.softness[row] *= contacts.normal_mass[row] * yields
            contacts.hardness[row] = contacts.normal_mass[row] * (1.0 - contacts.softness[row])


def want(t: Tables, points: int, structure: int) -> float:
    """Say by how much all impulses, those that act included, are to change speeds, and how much
    the springs of contacts yield; what hardly yields at all is no harder than `HELD`. Returns by
    how much the speed at a point is to change at most (m/s).
    """
    unknowns = t.unknowns
    contacts = t.contacts
    coupling = t.delassus.coupling
    count = 2 * points
    for point in range(points):
        row = unknowns.contact[point]
        unknowns.wanted[point] = -opening(t, point) - contacts.target[row]
        along = points + point
        unknowns.wanted[along] = -opening(t, along) - t.pairs.belt_speed[row // 2]
    fastest = 0.0
    for unknown in range(count):
        speed = abs(unknowns.wanted[unknown])
        fastest = speed if speed > fastest else fastest
        for other in range(count):
            changed = coupling[unknown * count + other] * unknowns.value[other]
            unknowns.wanted[unknown] += changed
    least = HELD / t.structures.heaviest[structure]
    for unknown in range(count):
        if coupling[unknown * count + unknown] < least:
            coupling[unknown * count + unknown] = least
    for point in range(points):
        row = unknowns.contact[point]
        acts = contacts.hardness[row] > 0.0
        unknowns.least[point] = 0.0 if acts else unknowns.value[point]
        unknowns.most[point] = UNBOUNDED if acts else unknowns.value[point]
        if acts:
            coupling[point * count + point] += contacts.softness[row] / contacts.hardness[row]
    return fastest


def is_jammed(t: Tables, points: int, structure: int, fastest: float) -> bool:
    """Whether a contact would get more than `OVERCOME` allows, where speeds are to change by
    `fastest` (m/s).
    """
    unknowns = t.unknowns
    heaviest = t.structures.heaviest[structure]
    for point in range(points):
        for body in (unknowns.a[point], unknowns.b[point]):
            if t.bodies.inverse_mass[body] > 0.0 and t.bodies.mass[body] > heaviest:
                heaviest = t.bodies.mass[body]
    for point in range(points):
        row = unknowns.contact[point]
        least = ENOUGH * t.pairs.size[row // 2]
        change = abs(unknowns.value[point] - t.contacts.normal_impulse[row])
        if change > OVERCOME * heaviest * (fastest + least):
            return True
    return False


def opening(t: Tables, unknown: int) -> float:
    """How fast bodies open, or slide, at a point at the end of the part (m/s)."""
    unknowns = t.unknowns
    bodies = t.bodies
    a = unknowns.a[unknown]
    b = unknowns.b[unknown]
    opens = (bodies.kick_x[b] - bodies.kick_x[a]) * unknowns.along_x[unknown]
    opens += (bodies.kick_y[b] - bodies.kick_y[a]) * unknowns.along_y[unknown]
    opens += bodies.kick_spin[b] * unknowns.arm_b[unknown]
    return opens - bodies.kick_spin[a] * unknowns.arm_a[unknown]


def find_loads(t: Tables, points: int) -> None:
    """Find the impulses: what presses, within the friction that it has."""
    pairs = t.pairs
    unknowns = t.unknowns
    smallest = UNBOUNDED
    for point in range(points):
        size = pairs.size[unknowns.contact[point] // 2]
        smallest = size if size < smallest else smallest
    for _ in range(ROUNDS):
        bound_friction(t, points)
        solve_bounded(t, 2 * points, ENOUGH * smallest, PASSES)
    bound_friction(t, points)
    for along in range(points, 2 * points):
        change_within(t, along, unknowns.value[along])


def bound_friction(t: Tables, points: int) -> None:
    """Bound friction by what presses (Coulomb)."""
    pairs = t.pairs
    unknowns = t.unknowns
    for point in range(points):
        pair = unknowns.contact[point] // 2
        slips = pairs.slid[pair] != 0.0 and pairs.static_friction[pair] > pairs.friction[pair]
        grip = pairs.friction[pair] if slips else pairs.static_friction[pair]
        unknowns.most[points + point] = grip * unknowns.value[point]
        unknowns.least[points + point] = -grip * unknowns.value[point]


def give_loads(t: Tables, points: int, structure: int, calm: float) -> bool:
    """Give the impulses that were found, in place of those that acted; return whether that changed
    a velocity by more than `calm` (reaches a second). They act evenly: half of them changes the
    mean velocities of nodes.
    """
    unknowns = t.unknowns
    contacts = t.contacts
    stirred = False
    be_still(t)
    for point in range(points):
        row = unknowns.contact[point]
        along = points + point
        push = unknowns.value[point] - contacts.normal_impulse[row]
        rub = unknowns.value[along] - contacts.tangent_impulse[row]
        give(t, point, push)
        give(t, along, rub)
        shake(t, point, structure, push / 2.0)
        shake(t, along, structure, rub / 2.0)
        contacts.normal_impulse[row] = unknowns.value[point]
        contacts.tangent_impulse[row] = unknowns.value[along]
        enough = calm * t.pairs.size[row // 2] * contacts.normal_mass[row]
        stirred = stirred or abs(push) > enough or abs(rub) > LESS_CALM * enough
    return stirred


def brake_rolling(t: Tables, points: int, structure: int, calm: float) -> bool:
    """Let each contact resist the rolling as if nothing else did; return whether that changed a
    spin by more than `calm` (1/s).
    """
    bodies = t.bodies
    stirred = False
    for point in range(points):
        pair = t.unknowns.contact[point] // 2
        a = t.pairs.a[pair]
        b = t.pairs.b[pair]
        turns = bodies.inverse_inertia[a] + bodies.inverse_inertia[b]
        first = t.unknowns.contact[point] == 2 * pair
        if first and t.pairs.rolling_resistance[pair] > 0.0 and turns > 0.0:
            change = resist_rolling(t, pair, bodies.kick_spin[b] - bodies.kick_spin[a], turns)
            bodies.kick_spin[a] -= bodies.inverse_inertia[a] * change
            bodies.kick_spin[b] += bodies.inverse_inertia[b] * change
            shake_node(t, node_in(t, a, structure), 0.0, 0.0, -change / 2.0)
            shake_node(t, node_in(t, b, structure), 0.0, 0.0, change / 2.0)
            stirred = stirred or abs(change) * turns > LESS_CALM * calm
    return stirred


def give(t: Tables, unknown: int, change: float) -> None:
    """Let an impulse act."""
    unknowns = t.unknowns
    bodies = t.bodies
    a = unknowns.a[unknown]
    b = unknowns.b[unknown]
    x = unknowns.along_x[unknown] * change
    y = unknowns.along_y[unknown] * change
    bodies.kick_x[a] -= bodies.inverse_mass[a] * x
    bodies.kick_y[a] -= bodies.inverse_mass[a] * y
    bodies.kick_spin[a] -= bodies.inverse_inertia[a] * unknowns.arm_a[unknown] * change
    bodies.kick_x[b] += bodies.inverse_mass[b] * x
    bodies.kick_y[b] += bodies.inverse_mass[b] * y
    bodies.kick_spin[b] += bodies.inverse_inertia[b] * unknowns.arm_b[unknown] * change
