"""Sweeps over the resting contacts of a crowd, eight side by side.

What a sweep needs of a contact is packed into columns, in blocks of contacts none of which moves
the same body (as in Box2D v3: Erin Catto, "SIMD Matters", 2024). All contacts of a block are solved
by the same instructions, without branches, so that a processor does several at once.

A contact goes to the first block with room that comes after all blocks with earlier contacts of its
two bodies. So whatever depends on each other is solved in the order of the list, and a sweep gives
the same as one contact after another.
"""

from engine.kernels.sweeps import QUIET, STIRRED, sweep, warm_start
from engine.tables import LANES, Tables


def pack(t: Tables, resting: int, count: int) -> None:
    """Pack the pairs that rest; those that cannot be packed come to stand first in their list."""
    bodies = t.bodies
    lanes = t.lanes
    pairs = t.pairs
    for row in range(count):
        bodies.block[row] = 0
    lanes.sizes[0] = 0
    room = 2 * t.progress.room[0] // LANES
    opened = 0  # all blocks before it are full
    left = 0
    for k in range(resting):
        pair = pairs.resting[k]
        block = opened
        if not is_plain(t, pair):
            block = room
        if bodies.inverse_mass[pairs.a[pair]] > 0.0 and bodies.block[pairs.a[pair]] > block:
            block = bodies.block[pairs.a[pair]]
        if bodies.inverse_mass[pairs.b[pair]] > 0.0 and bodies.block[pairs.b[pair]] > block:
            block = bodies.block[pairs.b[pair]]
        while block < lanes.sizes[0] and lanes.filled[block] == LANES:
            block += 1
        if block >= room:
            pairs.lane[pair] = -1
            pairs.queue[left] = pair  # nothing is queued yet
            left += 1
            continue
        if block == lanes.sizes[0]:
            open_block(t, block)
        bodies.block[pairs.a[pair]] = block + 1
        bodies.block[pairs.b[pair]] = block + 1
        row = block * LANES + lanes.filled[block]
        lanes.filled[block] += 1
        pairs.lane[pair] = row
        pairs.acting[pair] = pairs.points[pair]
        load_pair(t, pair, row)
        load_points(t, pair, row)
        while opened < lanes.sizes[0] and lanes.filled[opened] == LANES:
            opened += 1
    lanes.sizes[1] = left
    lanes.sizes[2] = 1
    if left > 0:
        put_first(t, resting, left)


def is_plain(t: Tables, pair: int) -> bool:
    """Whether a contact does no more than to press and to rub with one friction."""
    pairs = t.pairs
    rolls = pairs.rolling_resistance[pair] == 0.0 and pairs.rolling_torque[pair] == 0.0
    return rolls and pairs.static_friction[pair] <= pairs.friction[pair]


def put_first(t: Tables, resting: int, left: int) -> None:
    """Let the pairs that were left come first in the list, in their order, then the others."""
    pairs = t.pairs
    found = left - 1
    to = resting - 1
    for k in range(resting - 1, -1, -1):
        pair = pairs.resting[k]
        if found >= 0 and pairs.queue[found] == pair:
            found -= 1
        else:
            pairs.resting[to] = pair
            to -= 1
    for k in range(left):
        pairs.resting[k] = pairs.queue[k]


def open_block(t: Tables, block: int) -> None:
    """Begin a block; its lanes bear nothing."""
    t.lanes.filled[block] = 0
    t.lanes.sizes[0] = block + 1
    for row in range(block * LANES, block * LANES + LANES):
        t.lanes.mass_a[row] = t.lanes.mass_b[row] = 0.0
        t.lanes.turn_a[row] = t.lanes.turn_b[row] = 0.0
        clear_point_0(t, row)
        clear_point_1(t, row)


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
    """Write to a lane the points of a pair."""
    t.lanes.normal_x[row] = t.pairs.normal_x[pair]
    t.lanes.normal_y[row] = t.pairs.normal_y[pair]
    t.lanes.belt_speed[row] = t.pairs.belt_speed[pair]
    points = t.pairs.points[pair]
    if points > 0:
        load_point_0(t, 2 * pair, row)
    else:
        clear_point_0(t, row)
    if points > 1:
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


def load_again(t: Tables, pair: int) -> None:
    """Write to its lane, if it has one, what became of a pair in the part that is over."""
    if t.lanes.sizes[2] == 1 and t.pairs.lane[pair] >= 0:
        load_points(t, pair, t.pairs.lane[pair])


def unload(t: Tables, pair: int) -> None:
    """Let the lane of a pair, if it has one, keep its impulses as they are."""
    lanes = t.lanes
    if lanes.sizes[2] == 1 and t.pairs.lane[pair] >= 0:
        row = t.pairs.lane[pair]
        lanes.hardness_0[row] = lanes.softness_0[row] = lanes.tangent_mass_0[row] = 0.0
        lanes.hardness_1[row] = lanes.softness_1[row] = lanes.tangent_mass_1[row] = 0.0


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
        for row in range(first, first + lanes.filled[block]):
            at = 2 * lanes.pair[row]
            contacts.normal_impulse[at] = lanes.normal_impulse_0[row]
            contacts.tangent_impulse[at] = lanes.tangent_impulse_0[row]
            contacts.normal_impulse[at + 1] = lanes.normal_impulse_1[row]
            contacts.tangent_impulse[at + 1] = lanes.tangent_impulse_1[row]


def warm_start_crowd(t: Tables) -> None:
    """Apply the impulses of the part before; see `sweeps.warm_start`."""
    if t.lanes.sizes[1] > 0:
        warm_start(t, t.lanes.sizes[1])
    for block in range(t.lanes.sizes[0]):
        gather(t, block)
        give(t, block * LANES)
        scatter(t, block)


def give(t: Tables, first: int) -> None:
    """Give the impulses of a block from row `first` on to its bodies."""
    lanes = t.lanes
    for lane in range(LANES):
        row = first + lane
        nx = lanes.normal_x[row]
        ny = lanes.normal_y[row]
        push_0 = lanes.normal_impulse_0[row]
        push_1 = lanes.normal_impulse_1[row]
        rub_0 = lanes.tangent_impulse_0[row]
        rub_1 = lanes.tangent_impulse_1[row]
        push = push_0 + push_1
        rub = rub_0 + rub_1
        x = push * nx - rub * ny
        y = push * ny + rub * nx
        turn = push_0 * lanes.normal_arm_a_0[row] + rub_0 * lanes.tangent_arm_a_0[row]
        turn += push_1 * lanes.normal_arm_a_1[row] + rub_1 * lanes.tangent_arm_a_1[row]
        lanes.vx_a[lane] -= lanes.mass_a[row] * x
        lanes.vy_a[lane] -= lanes.mass_a[row] * y
        lanes.spin_a[lane] -= lanes.turn_a[row] * turn
        turn = push_0 * lanes.normal_arm_b_0[row] + rub_0 * lanes.tangent_arm_b_0[row]
        turn += push_1 * lanes.normal_arm_b_1[row] + rub_1 * lanes.tangent_arm_b_1[row]
        lanes.vx_b[lane] += lanes.mass_b[row] * x
        lanes.vy_b[lane] += lanes.mass_b[row] * y
        lanes.spin_b[lane] += lanes.turn_b[row] * turn


def sweep_crowd(t: Tables, calm: float, backwards: bool) -> int:
    """Solve each packed pair once, and those that are not packed; see `sweeps.sweep`.

    Returns whether a normal velocity changed by more than `calm` (reaches a second): `QUIET` or
    `STIRRED`.
    """
    lanes = t.lanes
    found = QUIET
    if lanes.sizes[1] > 0 and sweep(t, lanes.sizes[1], calm, backwards) != QUIET:
        found = STIRRED
    for lane in range(LANES):
        lanes.excess[lane] = 0.0
    blocks = lanes.sizes[0]
    onwards = -1 if backwards else 1
    block = blocks if backwards else -1
    for _ in range(blocks):
        block += onwards
        gather(t, block)
        solve(t, block * LANES, calm)
        scatter(t, block)
    for lane in range(LANES):
        if lanes.excess[lane] > 0.0:
            found = STIRRED
    return found


def sweep_until_calm(t: Tables, most: int, calm: float, turn: int) -> int:
    """Sweep to and fro over what is packed, `most` times at most, until one changes no normal
    velocity by more than `calm` (1/s); sweep number i begins with the last if i + `turn` is even.

    Returns how many sweeps it took; impulses are written back.
    """
    sweeps = 0
    for i in range(1, most + 1):
        sweeps = i
        if sweep_crowd(t, calm, (i + turn) % 2 == 0) == QUIET:
            break
    unpack(t)
    return sweeps


def gather(t: Tables, block: int) -> None:
    """Read the velocities of the bodies of a block."""
    lanes = t.lanes
    kick_x = t.bodies.kick_x
    kick_y = t.bodies.kick_y
    kick_spin = t.bodies.kick_spin
    first = block * LANES
    for lane in range(lanes.filled[block]):
        a = lanes.a[first + lane]
        b = lanes.b[first + lane]
        lanes.vx_a[lane] = kick_x[a]
        lanes.vy_a[lane] = kick_y[a]
        lanes.spin_a[lane] = kick_spin[a]
        lanes.vx_b[lane] = kick_x[b]
        lanes.vy_b[lane] = kick_y[b]
        lanes.spin_b[lane] = kick_spin[b]


def scatter(t: Tables, block: int) -> None:
    """Write them back."""
    lanes = t.lanes
    kick_x = t.bodies.kick_x
    kick_y = t.bodies.kick_y
    kick_spin = t.bodies.kick_spin
    first = block * LANES
    for lane in range(lanes.filled[block]):
        a = lanes.a[first + lane]
        b = lanes.b[first + lane]
        kick_x[a] = lanes.vx_a[lane]
        kick_y[a] = lanes.vy_a[lane]
        kick_spin[a] = lanes.spin_a[lane]
        kick_x[b] = lanes.vx_b[lane]
        kick_y[b] = lanes.vy_b[lane]
        kick_spin[b] = lanes.spin_b[lane]


def solve(t: Tables, first: int, calm: float) -> None:
    """Solve the pairs of a block from row `first` on: along the normal, then against the sliding.

    It says for one lane what a processor does for several, so it has no branches.
    """
    lanes = t.lanes
    for lane in range(LANES):
        row = first + lane
        nx = lanes.normal_x[row]
        ny = lanes.normal_y[row]
        mass_a = lanes.mass_a[row]
        mass_b = lanes.mass_b[row]
        mass = mass_a + mass_b
        turn_a = lanes.turn_a[row]
        turn_b = lanes.turn_b[row]
        still = calm * lanes.size[row]
        vx = lanes.vx_b[lane] - lanes.vx_a[lane]
        vy = lanes.vy_b[lane] - lanes.vy_a[lane]
        spin_a = lanes.spin_a[lane]
        spin_b = lanes.spin_b[lane]
        opening = vx * nx + vy * ny
        sliding = vy * nx - vx * ny + lanes.belt_speed[row]

        arm_a = lanes.normal_arm_a_0[row]
        arm_b = lanes.normal_arm_b_0[row]
        hardness = lanes.hardness_0[row]
        before = lanes.normal_impulse_0[row]
        speed = opening + spin_b * arm_b - spin_a * arm_a + lanes.target_0[row]
        push_0 = before - hardness * speed - lanes.softness_0[row] * before
        push_0 = push_0 if push_0 > 0.0 else 0.0
        change = push_0 - before
        push = change
        opening += mass * change
        spin_a -= turn_a * arm_a * change
        spin_b += turn_b * arm_b * change
        excess = abs(change) - still * hardness
        worst = lanes.excess[lane]
        worst = excess if excess > worst else worst

        arm_a = lanes.normal_arm_a_1[row]
        arm_b = lanes.normal_arm_b_1[row]
        hardness = lanes.hardness_1[row]
        before = lanes.normal_impulse_1[row]
        speed = opening + spin_b * arm_b - spin_a * arm_a + lanes.target_1[row]
        push_1 = before - hardness * speed - lanes.softness_1[row] * before
        push_1 = push_1 if push_1 > 0.0 else 0.0
        change = push_1 - before
        push += change
        spin_a -= turn_a * arm_a * change
        spin_b += turn_b * arm_b * change
        excess = abs(change) - still * hardness
        lanes.excess[lane] = excess if excess > worst else worst

        grip = lanes.static_friction[row]
        arm_a = lanes.tangent_arm_a_0[row]
        arm_b = lanes.tangent_arm_b_0[row]
        before = lanes.tangent_impulse_0[row]
        after = before - lanes.tangent_mass_0[row] * (sliding + spin_b * arm_b - spin_a * arm_a)
        most = grip * push_0
        after = after if after < most else most
        after = after if after > -most else -most
        lanes.tangent_impulse_0[row] = after
        change = after - before
        rub = change
        sliding += mass * change
        spin_a -= turn_a * arm_a * change
        spin_b += turn_b * arm_b * change

        arm_a = lanes.tangent_arm_a_1[row]
        arm_b = lanes.tangent_arm_b_1[row]
        before = lanes.tangent_impulse_1[row]
        after = before - lanes.tangent_mass_1[row] * (sliding + spin_b * arm_b - spin_a * arm_a)
        most = grip * push_1
        after = after if after < most else most
        after = after if after > -most else -most
        lanes.tangent_impulse_1[row] = after
        change = after - before
        rub += change
        spin_a -= turn_a * arm_a * change
        spin_b += turn_b * arm_b * change

        lanes.normal_impulse_0[row] = push_0
        lanes.normal_impulse_1[row] = push_1
        x = push * nx - rub * ny
        y = push * ny + rub * nx
        lanes.vx_a[lane] -= mass_a * x
        lanes.vy_a[lane] -= mass_a * y
        lanes.spin_a[lane] = spin_a
        lanes.vx_b[lane] += mass_b * x
        lanes.vy_b[lane] += mass_b * y
        lanes.spin_b[lane] = spin_b
