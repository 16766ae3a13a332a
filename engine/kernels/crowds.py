"""Sweeps over the resting contacts of a crowd, eight side by side.

What a sweep needs of a contact is packed into columns, in blocks of contacts none of which moves
the same body (as in Box2D v3: Erin Catto, "SIMD Matters", 2024). All contacts of a block are solved
by the same instructions, without branches, so that a processor does several at once; see `packing`.
"""

from engine.kernels.packing import unpack
from engine.kernels.sweeps import QUIET, STIRRED, sweep, warm_start
from engine.tables import LANES, Tables


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
        if lanes.points[block] == 1:
            solve_one(t, block * LANES, calm)
        else:
            solve_two(t, block * LANES, calm)
        scatter(t, block)
    for lane in range(LANES):
        if lanes.excess[lane] > 0.0:
            found = STIRRED
    return found


def sweep_until_calm(t: Tables, most: int, calm: float, turn: int) -> bool:
    """Sweep to and fro over what is packed, `most` times at most, until one changes no normal
    velocity by more than `calm` (1/s); sweep number i begins with the last if i + `turn` is even.

    Returns whether one did so; impulses are written back.
    """
    found = STIRRED
    for i in range(1, most + 1):
        found = sweep_crowd(t, calm, (i + turn) % 2 == 0)
        if found == QUIET:
            break
    unpack(t)
    return found == QUIET


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


def solve_one(t: Tables, first: int, calm: float) -> None:
    """Solve the pairs with one point of a block from row `first` on: along the normal, then against
    the sliding.

    It says for one lane what a processor does for several, so it has no branches.
    """
    lanes = t.lanes
    for lane in range(LANES):
        row = first + lane
        nx = lanes.normal_x[row]
        ny = lanes.normal_y[row]
        mass_a = lanes.mass_a[row]
        mass_b = lanes.mass_b[row]
        turn_a = lanes.turn_a[row]
        turn_b = lanes.turn_b[row]
        vx = lanes.vx_b[lane] - lanes.vx_a[lane]
        vy = lanes.vy_b[lane] - lanes.vy_a[lane]
        spin_a = lanes.spin_a[lane]
        spin_b = lanes.spin_b[lane]
        sliding = vy * nx - vx * ny + lanes.belt_speed[row]

        arm_a = lanes.normal_arm_a_0[row]
        arm_b = lanes.normal_arm_b_0[row]
        hardness = lanes.hardness_0[row]
        before = lanes.normal_impulse_0[row]
        speed = vx * nx + vy * ny + spin_b * arm_b - spin_a * arm_a + lanes.target_0[row]
        after = before - hardness * speed - lanes.softness_0[row] * before
        after = after if after > 0.0 else 0.0
        lanes.normal_impulse_0[row] = after
        push = after - before
        spin_a -= turn_a * arm_a * push
        spin_b += turn_b * arm_b * push
        excess = abs(push) - calm * lanes.size[row] * hardness
        worst = lanes.excess[lane]
        lanes.excess[lane] = excess if excess > worst else worst

        most = lanes.static_friction[row] * after
        arm_a = lanes.tangent_arm_a_0[row]
        arm_b = lanes.tangent_arm_b_0[row]
        before = lanes.tangent_impulse_0[row]
        after = before - lanes.tangent_mass_0[row] * (sliding + spin_b * arm_b - spin_a * arm_a)
        after = after if after < most else most
        after = after if after > -most else -most
        lanes.tangent_impulse_0[row] = after
        rub = after - before

        x = push * nx - rub * ny
        y = push * ny + rub * nx
        lanes.vx_a[lane] -= mass_a * x
        lanes.vy_a[lane] -= mass_a * y
        lanes.spin_a[lane] = spin_a - turn_a * arm_a * rub
        lanes.vx_b[lane] += mass_b * x
        lanes.vy_b[lane] += mass_b * y
        lanes.spin_b[lane] = spin_b + turn_b * arm_b * rub


def solve_two(t: Tables, first: int, calm: float) -> None:
    """The same for pairs with two points: both along the normal, then both against the sliding."""
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
