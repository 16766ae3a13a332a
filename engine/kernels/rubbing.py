"""What bodies do to each other along their surfaces, besides Coulomb's kinetic friction.

Static friction holds what rests up to a greater force than the one that brakes what slides, and
what kinetic friction has brought to a stop.
Rolling resistance (Coulomb, 1785): the normal force N acts ahead of the point of contact by a lever
arm b, so that a torque b N opposes the rolling. The surface of a conveyor moves along the edge of a
body that need not move itself. Two materials may have coefficients of their own.
"""

import math

from engine.settings import AS_FRICTION
from engine.tables import Tables

FULLY = 1.0 - 1e-6
"""Share of what friction can do that counts as all: the rest is rounding."""


def mix(t: Tables, pair: int) -> None:
    """Give a pair its coefficients.

    The larger restitution, the geometric mean of frictions, the larger rolling resistance. Rules of
    the world's own, which are Python, are asked afterwards.
    """
    bodies = t.bodies
    pairs = t.pairs
    a = pairs.a[pair]
    b = pairs.b[pair]
    one = bodies.restitution[a]
    other = bodies.restitution[b]
    pairs.restitution[pair] = one if one > other else other
    pairs.friction[pair] = math.sqrt(bodies.friction[a] * bodies.friction[b])
    grip = pairs.friction[pair]
    if bodies.static_friction[a] != AS_FRICTION or bodies.static_friction[b] != AS_FRICTION:
        grip = math.sqrt(static_friction(t, a) * static_friction(t, b))
    pairs.static_friction[pair] = grip
    one = bodies.rolling_resistance[a]
    other = bodies.rolling_resistance[b]
    pairs.rolling_resistance[pair] = one if one > other else other
    finish_mixing(t, pair)


def static_friction(t: Tables, row: int) -> float:
    """Of a body: its own, or that of what slides."""
    own = t.bodies.static_friction[row]
    return t.bodies.friction[row] if own == AS_FRICTION else own


def finish_mixing(t: Tables, pair: int) -> None:
    """Let materials that know each other have their own coefficients; note the speed of belts."""
    pairs = t.pairs
    low = t.bodies.material[pairs.a[pair]]
    high = t.bodies.material[pairs.b[pair]]
    if low > high:
        other = low
        low = high
        high = other
    if low > 0:
        for row in range(t.counts.materials[0]):
            if t.materials.a[row] == low and t.materials.b[row] == high:
                use_material(t, pair, row)
    pairs.belt_speed[pair] = belt_speed(t, pair, pairs.normal_x[pair], pairs.normal_y[pair])


def use_material(t: Tables, pair: int, row: int) -> None:
    """Give a pair the coefficients that two materials have in a row of `Materials`."""
    pairs = t.pairs
    known = t.materials
    if known.restitution[row] >= 0.0:
        pairs.restitution[pair] = known.restitution[row]
    if known.friction[row] >= 0.0:
        pairs.friction[pair] = known.friction[row]
        pairs.static_friction[pair] = known.friction[row]
    if known.static_friction[row] >= 0.0:
        pairs.static_friction[pair] = known.static_friction[row]
    if known.rolling_resistance[row] >= 0.0:
        pairs.rolling_resistance[pair] = known.rolling_resistance[row]
    if pairs.static_friction[pair] < pairs.friction[pair]:
        pairs.static_friction[pair] = pairs.friction[pair]


def belt_speed(t: Tables, pair: int, normal_x: float, normal_y: float) -> float:
    """Speed of the surface of b past that of a along the tangent of a contact (m/s), bodies still.

    The tangent is the unit normal, from a to b, turned left.
    """
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    if t.bodies.surface_speed[a] == 0.0 and t.bodies.surface_speed[b] == 0.0:
        return 0.0
    of_a = surface_speed(t, a, t.pairs.piece_a[pair], normal_x, normal_y, 1.0)
    of_b = surface_speed(t, b, t.pairs.piece_b[pair], normal_x, normal_y, -1.0)
    return of_b - of_a


def surface_speed(
    t: Tables, row: int, piece: int, normal_x: float, normal_y: float, out: float
) -> float:
    """Speed of a body's surface along the tangent of a contact (m/s), if the body stands still.

    `out` is 1 if the normal points out of the body, -1 if it points into it.
    """
    speed = t.bodies.surface_speed[row]
    if t.pieces.corners[piece] == 2 and t.pieces.radius[piece] == 0.0:
        first = t.pieces.first[piece]  # its side has its normal to the right of start -> end
        x = t.corners.world_normal_x[first]
        y = t.corners.world_normal_y[first]
        return speed * (x * normal_x + y * normal_y)
    return out * speed


def note_sliding(t: Tables, pair: int) -> None:
    """Note how fast a pair slides as a part begins, and that it does: whatever points it has were
    borne by all the kinetic, or all the static, friction there is. A pair that is new slides if
    that is faster than forces explain; see `Pairs.slid`.
    """
    pairs = t.pairs
    contacts = t.contacts
    pairs.slid[pair] = 0.0
    friction = pairs.friction[pair]
    grip = pairs.static_friction[pair]
    if grip <= friction:
        return
    bears = False
    for row in range(2 * pair, 2 * pair + pairs.points[pair]):
        push = contacts.normal_impulse[row]
        if push > 0.0:
            bears = True
            rub = abs(contacts.tangent_impulse[row])
            brake = friction * push
            if rub < FULLY * brake or (FULLY * rub > brake and rub < FULLY * grip * push):
                return
    slip = slip_of(t, pair) + pairs.belt_speed[pair]
    if bears or outruns_forces(t, pair, slip):
        pairs.slid[pair] = slip


def slip_of(t: Tables, pair: int) -> float:
    """Speed of b past a at the first point of a contact (m/s), belts apart."""
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    slip = (bodies.vy[b] - bodies.vy[a]) * t.pairs.normal_x[pair]
    slip -= (bodies.vx[b] - bodies.vx[a]) * t.pairs.normal_y[pair]
    slip += bodies.spin[b] * t.contacts.tangent_arm_b[2 * pair]
    return slip - bodies.spin[a] * t.contacts.tangent_arm_a[2 * pair]


def outruns_forces(t: Tables, pair: int, speed: float) -> bool:
    """Whether bodies slide on each other at a speed (m/s) that forces do not give within a part.

    What is slower than that rests, or is about to.
    """
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    fall = abs(bodies.ax[a]) + abs(bodies.ay[a]) + abs(bodies.ax[b]) + abs(bodies.ay[b])
    return abs(speed) > fall * t.pairs.part[pair]


def resist_rolling(t: Tables, pair: int, spinning: float, turn: float) -> float:
    """Change the angular impulse that a contact gives to b against the rolling (N m s); return it.

    Args:
        t: the tables.
        pair: which pair.
        spinning: spin of b less that of a (rad/s).
        turn: sum of their inverse moments of inertia (1/(kg m^2)).
    """
    pairs = t.pairs
    part = pairs.part[pair]
    load = 0.0
    for row in range(2 * pair, 2 * pair + pairs.points[pair]):
        load += t.contacts.normal_impulse[row]
    most = pairs.rolling_resistance[pair] * load
    before = pairs.rolling_torque[pair] * part
    after = before - spinning / turn
    if after > most:
        after = most
    elif after < -most:
        after = -most
    pairs.rolling_torque[pair] = after / part
    return after - before


def resist_rolling_gripped(t: Tables, pair: int, spinning: float, slip: float) -> float:
    """The same for a contact of one point, as if friction then took all of its `slip` (m/s).

    If friction can, both together are solved exactly, in one step; if it cannot, it does all that
    it can, whatever resists the rolling, which is then solved for that.
    """
    inverse_inertia = t.bodies.inverse_inertia
    row = 2 * pair
    turn_a = inverse_inertia[t.pairs.a[pair]]
    turn_b = inverse_inertia[t.pairs.b[pair]]
    cross = turn_a * t.contacts.tangent_arm_a[row] + turn_b * t.contacts.tangent_arm_b[row]
    shared = cross * t.contacts.tangent_mass[row]
    return resist_rolling(t, pair, spinning - shared * slip, turn_a + turn_b - shared * cross)
