"""Resting contacts of a crowd, packed for sweeps that solve eight side by side; see `crowds`.

A contact goes to the first block with room that comes after all blocks with earlier contacts of its
two bodies. So whatever depends on each other is solved in the order of the list, and a sweep gives
the same as one contact after another. As long as the list is the same in a tick, contacts stay in
their lanes.
"""

from engine.tables import LANES, Tables

STREAMS = 4
"""Into so many parts the list of pairs is divided, from which they are taken in turns. Neighbours
in the list mostly share a body, so that they would need blocks of their own; those of different
quarters hardly ever do. And what leans is found from four places at once."""


SPARE = 2
"""So many times more blocks may there be than full ones would do: whatever a world has room for,
as one that is restored may have room for less. Where contacts of one body need more, some are left.
"""


def pack(t: Tables, resting: int, count: int) -> None:
    """Pack the pairs that rest; those that cannot be packed come to stand first in their list."""
    bodies = t.bodies
    lanes = t.lanes
    pairs = t.pairs
    for row in range(count):
        bodies.block[row] = 0
    for k in range(resting):
        lanes.listed[k] = pairs.resting[k]
    lanes.sizes[0] = 0
    room = SPARE * resting // LANES
    opened_1 = 0  # all blocks before it are full, or for other numbers of points
    opened_2 = 0
    left = 0
    length = (resting + STREAMS - 1) // STREAMS
    for turn in range(length * STREAMS):
        k = turn % STREAMS * length + turn // STREAMS
        if k >= resting:
            continue
        pair = pairs.resting[k]
        points = 2 if pairs.points[pair] > 1 else 1
        block = opened_1 if points == 1 else opened_2
        if not is_plain(t, pair):
            block = room
        if bodies.inverse_mass[pairs.a[pair]] > 0.0 and bodies.block[pairs.a[pair]] > block:
            block = bodies.block[pairs.a[pair]]
        if bodies.inverse_mass[pairs.b[pair]] > 0.0 and bodies.block[pairs.b[pair]] > block:
            block = bodies.block[pairs.b[pair]]
        block = next_open(t, block, points)
        if block >= room:
            pairs.lane[pair] = -1
            pairs.queue[left] = pair  # nothing is queued yet
            left += 1
            continue
        if block == lanes.sizes[0]:
            open_block(t, block, points)
        bodies.block[pairs.a[pair]] = block + 1
        bodies.block[pairs.b[pair]] = block + 1
        row = block * LANES + lanes.filled[block]
        lanes.filled[block] += 1
        pairs.lane[pair] = row
        load_pair(t, pair, row)
        load_points(t, pair, row)
        if points == 1:
            opened_1 = next_open(t, opened_1, 1)
        else:
            opened_2 = next_open(t, opened_2, 2)
    lanes.sizes[1] = left
    lanes.sizes[2] = 1
    lanes.sizes[3] = resting if left == 0 else 0
    if left > 0:
        put_first(t, resting, left)


def is_plain(t: Tables, pair: int) -> bool:
    """Whether a contact does no more than to press and to rub with one friction."""
    pairs = t.pairs
    rolls = pairs.rolling_resistance[pair] == 0.0 and pairs.rolling_torque[pair] == 0.0
    return rolls and pairs.static_friction[pair] <= pairs.friction[pair]


def put_first(t: Tables, resting: int, left: int) -> None:
    """Let the pairs that were left come first in the list, then the others in their order."""
    pairs = t.pairs
    to = resting - 1
    for k in range(resting - 1, -1, -1):
        pair = pairs.resting[k]
        if pairs.lane[pair] >= 0:
            pairs.resting[to] = pair
            to -= 1
    for k in range(left):
        pairs.resting[k] = pairs.queue[k]


def next_open(t: Tables, block: int, points: int) -> int:
    """The first block, from the given one on, with room for a pair with so many points."""
    lanes = t.lanes
    while block < lanes.sizes[0] and (
        lanes.filled[block] == LANES or lanes.points[block] != points
    ):
        block += 1
    return block


def open_block(t: Tables, block: int, points: int) -> None:
    """Begin a block for pairs with so many points; its lanes bear nothing."""
    t.lanes.filled[block] = 0
    t.lanes.points[block] = points
    t.lanes.sizes[0] = block + 1
    for row in range(block * LANES, block * LANES + LANES):
        t.lanes.mass_a[row] = t.lanes.mass_b[row] = 0.0
        t.lanes.turn_a[row] = t.lanes.turn_b[row] = 0.0
        clear_lane(t, row)


def clear_point_0(t: Tables, row: int) -> None:
    """Let the first point of a lane bear nothing."""
    lanes = t.lanes
    lanes.hardness_0[row] = lanes.softness_0[row] = lanes.tangent_mass_0[row] = 0.0
    lanes.normal_impulse_0[row] = lanes.tangent_impulse_0[row] = 0.0


def clear_point_1(t: Tables, row: int) -> None:
    """Let the second point of a lane bear nothing."""
    lanes = t.lanes
    lanes.hardness_1[row] = lanes.softness_1[row] = lanes.tangent_mass_1[row] = 0.0
    lanes.normal_impulse_1[row] = lanes.tangent_impulse_1[row] = 0.0


def load_pair(t: Tables, pair: int, row: int) -> None:
    """Write to a lane what belongs to a pair as a whole."""
    lanes = t.lanes
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    lanes.pair[row] = pair
    lanes.a[row] = a
    lanes.b[row] = b
    lanes.mass_a[row] = t.bodies.inverse_mass[a]
    lanes.mass_b[row] = t.bodies.inverse_mass[b]
    lanes.turn_a[row] = t.bodies.inverse_inertia[a]
    lanes.turn_b[row] = t.bodies.inverse_inertia[b]
    lanes.size[row] = t.pairs.size[pair]
    lanes.static_friction[row] = t.pairs.static_friction[pair]


def load_points(t: Tables, pair: int, row: int) -> None:
    """Write to a lane the points of a pair, which act from now on."""
    t.pairs.acting[pair] = t.pairs.points[pair]
    t.lanes.normal_x[row] = t.pairs.normal_x[pair]
    t.lanes.normal_y[row] = t.pairs.normal_y[pair]
    t.lanes.belt_speed[row] = t.pairs.belt_speed[pair]
    points = t.pairs.points[pair]
    if points > 0:
        load_point_0(t, 2 * pair, row)
    else:
        clear_point_0(t, row)
    if t.lanes.points[row // LANES] == 1:
        if points > 1:
            t.lanes.sizes[2] = 0  # it needs a lane of another block
    elif points > 1:
        load_point_1(t, 2 * pair + 1, row)
    else:
        clear_point_1(t, row)


def load_point_0(t: Tables, at: int, row: int) -> None:
    """Write the first point of a lane, which is row `at` of `Contacts`."""
    lanes = t.lanes
    contacts = t.contacts
    lanes.normal_arm_a_0[row] = contacts.normal_arm_a[at]
    lanes.normal_arm_b_0[row] = contacts.normal_arm_b[at]
    lanes.tangent_arm_a_0[row] = contacts.tangent_arm_a[at]
    lanes.tangent_arm_b_0[row] = contacts.tangent_arm_b[at]
    lanes.tangent_mass_0[row] = contacts.tangent_mass[at]
    lanes.target_0[row] = contacts.target[at]
    lanes.hardness_0[row] = contacts.hardness[at]
    lanes.softness_0[row] = contacts.softness[at]
    lanes.normal_impulse_0[row] = contacts.normal_impulse[at]
    lanes.tangent_impulse_0[row] = contacts.tangent_impulse[at]


def load_point_1(t: Tables, at: int, row: int) -> None:
    """Write the second point of a lane, which is row `at` of `Contacts`."""
    lanes = t.lanes
    contacts = t.contacts
    lanes.normal_arm_a_1[row] = contacts.normal_arm_a[at]
    lanes.normal_arm_b_1[row] = contacts.normal_arm_b[at]
    lanes.tangent_arm_a_1[row] = contacts.tangent_arm_a[at]
    lanes.tangent_arm_b_1[row] = contacts.tangent_arm_b[at]
    lanes.tangent_mass_1[row] = contacts.tangent_mass[at]
    lanes.target_1[row] = contacts.target[at]
    lanes.hardness_1[row] = contacts.hardness[at]
    lanes.softness_1[row] = contacts.softness[at]
    lanes.normal_impulse_1[row] = contacts.normal_impulse[at]
    lanes.tangent_impulse_1[row] = contacts.tangent_impulse[at]


def is_packed(t: Tables, resting: int) -> bool:
    """Whether the pairs that rest are those that are packed, in the same order, and all are."""
    lanes = t.lanes
    if lanes.sizes[3] != resting:
        return False
    for k in range(resting):  # noqa: SIM110, a loop that can be compiled
        if lanes.listed[k] != t.pairs.resting[k]:
            return False
    return True


def unload(t: Tables, row: int) -> None:
    """Let a lane keep its impulses as they are."""
    lanes = t.lanes
    lanes.hardness_0[row] = lanes.softness_0[row] = lanes.tangent_mass_0[row] = 0.0
    lanes.hardness_1[row] = lanes.softness_1[row] = lanes.tangent_mass_1[row] = 0.0


def clear_lane(t: Tables, row: int) -> None:
    """Let a lane bear nothing."""
    clear_point_0(t, row)
    clear_point_1(t, row)


def pack_again(t: Tables, left: int, count: int) -> None:
    """See that those pairs are packed that are left at the end of a part, of which each was loaded
    again or unloaded.
    """
    if t.lanes.sizes[2] == 0:
        pack(t, left, count)
        for k in range(left):
            t.pairs.acting[t.pairs.resting[k]] = 0
    apart = 0
    while apart < left and t.pairs.lane[t.pairs.resting[apart]] < 0:
        apart += 1
    t.lanes.sizes[1] = apart


def unpack(t: Tables) -> None:
    """Write the impulses back to `Contacts`."""
    lanes = t.lanes
    contacts = t.contacts
    for block in range(lanes.sizes[0]):
        first = block * LANES
        both = lanes.points[block] == 2
        for row in range(first, first + lanes.filled[block]):
            at = 2 * lanes.pair[row]
            contacts.normal_impulse[at] = lanes.normal_impulse_0[row]
            contacts.tangent_impulse[at] = lanes.tangent_impulse_0[row]
            if both:
                contacts.normal_impulse[at + 1] = lanes.normal_impulse_1[row]
                contacts.tangent_impulse[at + 1] = lanes.tangent_impulse_1[row]
