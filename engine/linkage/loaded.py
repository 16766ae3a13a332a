"""Contacts through which light joined bodies bear heavy ones: solved together with the joints.

A sweep stops at a contact what its own two bodies bring; joints then bring more of what is joined
to them, and so on: a leg of a table takes as many turns as the top is heavier. So the contacts of
such a structure are solved with all that joints answer at once: a unit impulse at one point changes
the speed at another by A = J (M^-1 - M^-1 G^T (G M^-1 G^T)^-1 G M^-1) J^T (Jacobians J of the
contacts and G of the joints, inverse masses M^-1; the Delassus operator of contacts on a mechanism:
Brogliato, "Nonsmooth Mechanics", 2016, section 5.2), and impulses have their bounds (Signorini,
Coulomb; `kernels.complementarity`). Trees of hinges go their own way (`limb_sweeps`).
"""

from engine.kernels.complementarity import coupling, solve_bounded
from engine.linkage.impulses import lend
from engine.linkage.skyline import solve_between
from engine.linkage.tally import find_heaviest, has_braces, node_of
from engine.tables import MOST_HITS, Tables

HEAVY = 10.0
"""A structure is solved like that where it, or what lies on it, is so many times as heavy as what
bears it there: sweeps do for others."""

FIRM = 0.2
"""Share of what free bodies would yield from which on down what joins them is met."""

ROUNDS = 3
"""So often friction is found anew, from what presses, and the other way round."""

PASSES = 24
"""So often at most points are passed over in each of these."""

ENOUGH = 1e-4
"""No speed changes by more in the last of them, in reaches of the smaller body a second (1/s)."""

UNBOUNDED = 1e300
"""More than any impulse (N s)."""


def note_loaded(t: Tables, resting: int) -> int:
    """Note for each resting pair which structure it bears with a much lighter body; return the
    number of such pairs.
    """
    t.braces.sizes[8] = 0
    if t.braces.sizes[0] == 0:
        return 0
    find_heaviest(t)
    loaded = 0
    for k in range(resting):
        pair = t.pairs.resting[k]
        t.pairs.bears[pair] = structure_of(t, t.pairs.a[pair], t.pairs.b[pair])
        if t.pairs.bears[pair] >= 0:
            loaded += 1
    t.braces.sizes[8] = loaded
    return loaded


def structure_of(t: Tables, a: int, b: int) -> int:
    """The structure that bears a heavy load where two bodies touch, or is borne there: of the
    joined one, or the lighter, if that is far too light for the load; -1 if it is not.
    """
    bodies = t.bodies
    bears = a
    other = b
    if not has_braces(t, a) or (has_braces(t, b) and bodies.mass[b] < bodies.mass[a]):
        bears = b
        other = a
    if not has_braces(t, bears):
        return -1
    structure = t.nodes.structure[node_of(t, bears)]
    most = HEAVY * bodies.mass[bears]
    heavy = bodies.inverse_mass[other] > 0.0 and bodies.mass[other] > most
    return structure if heavy or t.structures.heaviest[structure] > most else -1


def bear_loads(t: Tables, resting: int, share: float, fresh: bool) -> None:
    """Solve the contacts of each loaded structure together, as if its joints answered by `share` of
    what they lend; velocities obey the joints, and the present matrix is theirs.

    Joints then have to answer. What they do not know yet, as limits and motors that change their
    minds, is left to the sweeps that follow.
    """
    pairs = t.pairs
    for k in range(resting):
        structure = pairs.bears[pairs.resting[k]]
        if structure >= 0 and is_first(t, k, structure):
            points = list_points(t, k, resting, structure)
            couple_through_joints(t, points, structure, share)
            if not bears_much(t, points):
                continue
            if fresh:
                stiffen(t, points)
            want(t, points)
            find_loads(t, points)
            give_loads(t, points)


def is_first(t: Tables, k: int, structure: int) -> bool:
    """Whether no pair that is listed before place `k` bears the same structure."""
    for before in range(k):  # noqa: SIM110, a loop that can be compiled
        if t.pairs.bears[t.pairs.resting[before]] == structure:
            return False
    return True


def list_points(t: Tables, k: int, resting: int, structure: int) -> int:
    """List the points of pairs, from place `k` on, that bear a structure; return their number.

    Each is two of the `Unknowns`: the impulses along the normals, then those along the tangents.
    Those for which there is no room are left to the sweeps.
    """
    pairs = t.pairs
    contacts = t.contacts
    unknowns = t.unknowns
    points = 0
    for at in range(k, resting):
        pair = pairs.resting[at]
        if pairs.bears[pair] != structure or 2 * (points + pairs.points[pair]) > MOST_HITS:
            continue
        for row in range(2 * pair, 2 * pair + pairs.points[pair]):
            unknowns.contact[points] = row
            points += 1
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
    return points


def couple_through_joints(t: Tables, points: int, structure: int, share: float) -> None:
    """Find how impulses change speeds, where joints answer by `share` of what they lend."""
    count = 2 * points
    entry = t.delassus.coupling
    for unknown in range(count):
        lend_answer(t, unknown, structure)
        for other in range(unknown, count):
            changes = coupling(t, other, unknown) + share * lent_along(t, other, structure)
            entry[unknown * count + other] = changes
            entry[other * count + unknown] = changes


def lend_answer(t: Tables, unknown: int, structure: int) -> None:
    """Let the joints of a structure lend what they answer to a unit impulse."""
    unknowns = t.unknowns
    nodes = t.nodes
    arms = t.arms
    bodies = t.bodies
    a = unknowns.a[unknown]
    b = unknowns.b[unknown]
    x = unknowns.along_x[unknown]
    y = unknowns.along_y[unknown]
    turn_a = bodies.inverse_inertia[a] * unknowns.arm_a[unknown]
    turn_b = bodies.inverse_inertia[b] * unknowns.arm_b[unknown]
    first = t.structures.first[structure]
    end = t.structures.end[structure]
    for row in range(first, end):
        rate = 0.0
        for arm in range(2 * row, 2 * row + 2):
            node = arms.node[arm]
            nodes.lent_x[node] = nodes.lent_y[node] = nodes.lent_spin[node] = 0.0
            if node == 0:
                continue
            body = nodes.body[node]
            along = arms.x[arm] * x + arms.y[arm] * y
            if body == a:
                rate -= bodies.inverse_mass[a] * along + turn_a * arms.turn[arm]
            elif body == b:
                rate += bodies.inverse_mass[b] * along + turn_b * arms.turn[arm]
        t.equations.unknown[row] = -rate
    solve_between(t, first, end)
    for row in range(first, end):
        lend(t, row, t.equations.unknown[row])


def lent_along(t: Tables, unknown: int, structure: int) -> float:
    """How fast what joints lent opens a point, along its direction (m/s)."""
    unknowns = t.unknowns
    x = unknowns.along_x[unknown]
    y = unknowns.along_y[unknown]
    opens = of_body(t, unknowns.b[unknown], structure, x, y, unknowns.arm_b[unknown])
    return opens - of_body(t, unknowns.a[unknown], structure, x, y, unknowns.arm_a[unknown])


def of_body(t: Tables, row: int, structure: int, x: float, y: float, arm: float) -> float:
    """What one body adds to that; 0 if it is none of the structure."""
    nodes = t.nodes
    node = node_of(t, row) if has_braces(t, row) else 0
    if nodes.structure[node] != structure:
        return 0.0
    return nodes.lent_x[node] * x + nodes.lent_y[node] * y + nodes.lent_spin[node] * arm


def bears_much(t: Tables, points: int) -> bool:
    """Whether a contact meets much more mass than that of its two bodies."""
    for point in range(points):
        yields = t.delassus.coupling[2 * points * point + point]
        if t.contacts.normal_mass[t.unknowns.contact[point]] * yields < FIRM:
            return True
    return False


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


def want(t: Tables, points: int) -> None:
    """Say by how much all impulses, those that act included, are to change speeds, and to how much
    the springs of contacts yield.
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
    for unknown in range(count):
        for other in range(count):
            changed = coupling[unknown * count + other] * unknowns.value[other]
            unknowns.wanted[unknown] += changed
    for point in range(points):
        row = unknowns.contact[point]
        acts = contacts.hardness[row] > 0.0
        unknowns.least[point] = 0.0 if acts else unknowns.value[point]
        unknowns.most[point] = UNBOUNDED if acts else unknowns.value[point]
        if acts:
            coupling[point * count + point] += contacts.softness[row] / contacts.hardness[row]


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
    for _ in range(ROUNDS):
        smallest = UNBOUNDED
        for point in range(points):
            pair = unknowns.contact[point] // 2
            slips = pairs.slid[pair] != 0.0 and pairs.static_friction[pair] > pairs.friction[pair]
            grip = pairs.friction[pair] if slips else pairs.static_friction[pair]
            unknowns.most[points + point] = grip * unknowns.value[point]
            unknowns.least[points + point] = -grip * unknowns.value[point]
            if pairs.size[pair] < smallest:
                smallest = pairs.size[pair]
        solve_bounded(t, 2 * points, ENOUGH * smallest, PASSES)


def give_loads(t: Tables, points: int) -> None:
    """Give the impulses that were found, in place of those that acted."""
    unknowns = t.unknowns
    contacts = t.contacts
    for point in range(points):
        row = unknowns.contact[point]
        give(t, point, unknowns.value[point] - contacts.normal_impulse[row])
        contacts.normal_impulse[row] = unknowns.value[point]
        along = points + point
        give(t, along, unknowns.value[along] - contacts.tangent_impulse[row])
        contacts.tangent_impulse[row] = unknowns.value[along]


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
