"""Sequential impulses: one resting contact after another is solved as if it were the only one.

Each sweep brings the impulses nearer to those that suit all (projected Gauss-Seidel: Erin Catto,
"Iterative dynamics with temporal coherence", 2005). They start from those of the part before.
"""

from engine.kernels.rubbing import resist_rolling, resist_rolling_gripped
from engine.tables import Tables

QUIET, STIRRED, WILD = 0, 1, 2
"""What a sweep found: no change that counts, some, at least one that is wild."""

LESS_CALM = 10.0
"""Friction may still change velocities by so many times as much as what acts along normals: heaps
at rest pass ever less of it on, for long."""

WILDLY = 0.2
"""A change of a contact's velocity by more is wild, in reaches of the smaller body a second."""


def warm_start(t: Tables, resting: int) -> None:
    """Apply the impulses of the part before."""
    bodies = t.bodies
    contacts = t.contacts
    pairs = t.pairs
    kick_x = bodies.kick_x
    kick_y = bodies.kick_y
    kick_spin = bodies.kick_spin
    for k in range(resting):
        pair = pairs.resting[k]
        push = 0.0
        rub = 0.0
        turn_a = 0.0
        turn_b = 0.0
        pairs.acting[pair] = pairs.points[pair]
        for row in range(2 * pair, 2 * pair + pairs.points[pair]):
            normal = contacts.normal_impulse[row]
            tangent = contacts.tangent_impulse[row]
            push += normal
            rub += tangent
            turn_a += normal * contacts.normal_arm_a[row] + tangent * contacts.tangent_arm_a[row]
            turn_b += normal * contacts.normal_arm_b[row] + tangent * contacts.tangent_arm_b[row]
        if push == 0.0:
            pairs.rolling_torque[pair] = 0.0
        else:
            nx = pairs.normal_x[pair]
            ny = pairs.normal_y[pair]
            x = push * nx - rub * ny
            y = push * ny + rub * nx
            a = pairs.a[pair]
            b = pairs.b[pair]
            kick_x[a] -= bodies.inverse_mass[a] * x
            kick_y[a] -= bodies.inverse_mass[a] * y
            kick_x[b] += bodies.inverse_mass[b] * x
            kick_y[b] += bodies.inverse_mass[b] * y
            rolling = pairs.rolling_torque[pair]
            if rolling != 0.0:
                turn_a += rolling * pairs.part[pair]
                turn_b += rolling * pairs.part[pair]
            kick_spin[a] -= bodies.inverse_inertia[a] * turn_a
            kick_spin[b] += bodies.inverse_inertia[b] * turn_b


def sweep(t: Tables, resting: int, calm: float, backwards: bool) -> int:
    """Solve each resting pair once, along the normal, then against the sliding and the rolling.

    What slides is braked by kinetic friction; if that stops it, static friction may hold it. Sweeps
    go to and fro in turn: what comes first gives way more than what comes last, and heaps would
    lean.

    Args:
        t: the tables.
        resting: number of pairs.
        calm: change of a velocity that does not count (reaches a second).
        backwards: whether to begin with the last pair.

    Returns how velocities changed: `QUIET`, `STIRRED` or, along a normal, `WILD`. What friction
    changes is not borne along normals before the next sweep, or a column would lean back instead.
    """
    bodies = t.bodies
    pairs = t.pairs
    kick_x = bodies.kick_x
    kick_y = bodies.kick_y
    kick_spin = bodies.kick_spin
    normal_arm_a = t.contacts.normal_arm_a
    normal_arm_b = t.contacts.normal_arm_b
    tangent_arm_a = t.contacts.tangent_arm_a
    tangent_arm_b = t.contacts.tangent_arm_b
    normal_impulse = t.contacts.normal_impulse
    tangent_impulse = t.contacts.tangent_impulse
    target = t.contacts.target
    hardness = t.contacts.hardness
    softness = t.contacts.softness
    tangent_mass = t.contacts.tangent_mass
    found = QUIET
    wilder = WILDLY / calm
    onwards = -1 if backwards else 1
    k = resting if backwards else -1
    for _ in range(resting):
        k += onwards
        pair = pairs.resting[k]
        a = pairs.a[pair]
        b = pairs.b[pair]
        nx = pairs.normal_x[pair]
        ny = pairs.normal_y[pair]
        grip = pairs.static_friction[pair]
        friction = pairs.friction[pair]
        still = calm * pairs.size[pair]
        mass_a = bodies.inverse_mass[a]
        mass_b = bodies.inverse_mass[b]
        mass = mass_a + mass_b
        turn_a = bodies.inverse_inertia[a]
        turn_b = bodies.inverse_inertia[b]
        vx = kick_x[b] - kick_x[a]
        vy = kick_y[b] - kick_y[a]
        spin_a = kick_spin[a]
        spin_b = kick_spin[b]
        arm_a = 0.0
        arm_b = 0.0
        opening = vx * nx + vy * ny
        sliding = vy * nx - vx * ny
        push = 0.0
        rub = 0.0
        first = 2 * pair
        end = first + pairs.points[pair]
        for row in range(first, end):
            arm_a = normal_arm_a[row]
            arm_b = normal_arm_b[row]
            before = normal_impulse[row]
            speed = opening + spin_b * arm_b - spin_a * arm_a + target[row]
            after = before - hardness[row] * speed - softness[row] * before
            if after < 0.0:
                after = 0.0
            normal_impulse[row] = after
            change = after - before
            push += change
            opening += mass * change
            spin_a -= turn_a * arm_a * change
            spin_b += turn_b * arm_b * change
            most = still * hardness[row]
            if change > most or -change > most:
                if found == QUIET:
                    found = STIRRED
                if change > wilder * most or -change > wilder * most:
                    found = WILD
        turns = turn_a + turn_b
        rolls = pairs.rolling_resistance[pair] > 0.0 and turns > 0.0
        rolled = 0.0
        if grip > 0.0:
            sliding += pairs.belt_speed[pair]
            if rolls and end == first + 1:
                arm_a = tangent_arm_a[first]
                arm_b = tangent_arm_b[first]
                slip = sliding + spin_b * arm_b - spin_a * arm_a
                rolled = resist_rolling_gripped(t, pair, spin_b - spin_a, slip)
                spin_a -= turn_a * rolled
                spin_b += turn_b * rolled
            slips = grip > friction and pairs.slid[pair] != 0.0
            if slips:
                grip = friction
            for row in range(first, end):
                arm_a = tangent_arm_a[row]
                arm_b = tangent_arm_b[row]
                before = tangent_impulse[row]
                after = before - tangent_mass[row] * (sliding + spin_b * arm_b - spin_a * arm_a)
                most = grip * normal_impulse[row]
                if after > most:
                    after = most
                elif after < -most:
                    after = -most
                else:
                    slips = False
                tangent_impulse[row] = after
                change = after - before
                rub += change
                sliding += mass * change
                spin_a -= turn_a * arm_a * change
                spin_b += turn_b * arm_b * change
                most = LESS_CALM * still * tangent_mass[row]
                if found == QUIET and (change > most or -change > most):
                    found = STIRRED
            if slips and pairs.slid[pair] * (sliding + spin_b * arm_b - spin_a * arm_a) < 0.0:
                pairs.slid[pair] = 0.0  # it came to a stop, and would turn back
                if found == QUIET:
                    found = STIRRED
        if rolls:
            change = resist_rolling(t, pair, spin_b - spin_a, turns)
            spin_a -= turn_a * change
            spin_b += turn_b * change
            rolled = (rolled + change) * turns
            if found == QUIET and (rolled > LESS_CALM * calm or -rolled > LESS_CALM * calm):
                found = STIRRED
        x = push * nx - rub * ny
        y = push * ny + rub * nx
        kick_x[a] -= mass_a * x
        kick_y[a] -= mass_a * y
        kick_spin[a] = spin_a
        kick_x[b] += mass_b * x
        kick_y[b] += mass_b * y
        kick_spin[b] = spin_b
    return found
