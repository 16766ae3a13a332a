"""The books of angular momentum about the origin: what every cause gave to it; see `books`.

Angular momentum is the sum of m (x x v) + I w. An impulse J at p gives p x J:

- a force that is constant through a tick gives x x F, integrated over the tick. A body keeps the
  time integral of its position (its *absement*), to which every flight from impact to impact adds;
- what acts evenly all through a part of a tick, as contacts do, gives as much as one impulse in the
  middle of the part, where the body would be if only impacts changed its velocity: as m a is the
  sum F of all that acts, the way that they bend its path by, a s^2/2, has no moment. That is where
  the forces of the part are booked as well, but for the way by which they alone would bend it;
- two bodies that exchange an impulse at one common point, or along one line, get nothing together,
  and nothing is booked. If an engine breaks that law, its books do not close.

What would turn a particle about its centre, which never spins, is lost; it is booked as such.
"""

from engine.kernels.rousing import PRESENT
from engine.tables import Bodies, Tables


def forget_ways(bodies: Bodies, count: int) -> None:
    """Begin to integrate ways over time."""
    for row in range(count):
        bodies.start_x[row] = bodies.x[row]
        bodies.start_y[row] = bodies.y[row]
        bodies.absement_x[row] = 0.0
        bodies.absement_y[row] = 0.0


def forget_bend(bodies: Bodies, row: int, lasted: float) -> None:
    """Leave out of the absement by how much the path was bent in a part that lasted so long (s) and
    is over.
    """
    x = bodies.path_x[row]
    y = bodies.path_y[row]
    if x != 0.0 or y != 0.0:
        cube = lasted * lasted * lasted / 6.0
        bodies.absement_x[row] -= x * cube
        bodies.absement_y[row] -= y * cube


def place_in_part(bodies: Bodies, row: int, lasted: float) -> tuple[float, float]:
    """Where what acts on a body evenly, all through a part that lasted so long (s), acts as if at
    once (m), once its bend is forgotten; where it is, if that was no time.
    """
    if lasted <= 0.0:
        return bodies.x[row], bodies.y[row]
    per = 1.0 / lasted
    x = (bodies.absement_x[row] - bodies.from_absement_x[row]) * per
    y = (bodies.absement_y[row] - bodies.from_absement_y[row]) * per
    return bodies.start_x[row] + x, bodies.start_y[row] + y


def turn_of(bodies: Bodies, row: int, x: float, y: float, spin: float) -> float:
    """Angular momentum (N m s) that a change of velocity (m/s) and spin (rad/s) brings."""
    turn = bodies.mass[row] * (bodies.x[row] * y - bodies.y[row] * x)
    if bodies.inverse_inertia[row] > 0.0:
        turn += bodies.inertia[row] * spin
    return turn


def is_particle(bodies: Bodies, row: int) -> bool:
    """Whether a body moves, but never turns."""
    return bodies.inverse_inertia[row] == 0.0 and bodies.inverse_mass[row] > 0.0


def book_lost(t: Tables, row: int, turn: float) -> None:
    """Book an angular impulse about the centre of a body (N m s), if that never turns."""
    if is_particle(t.bodies, row):
        t.books.particle_turn[0] -= turn


def book_lost_in_impact(t: Tables, pair: int, x: float, y: float, jx: float, jy: float) -> None:
    """Book what an impulse (N s), given to b at (x, y), does not turn."""
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    book_lost(t, a, (y - bodies.here_y[a]) * jx - (x - bodies.here_x[a]) * jy)
    book_lost(t, b, (x - bodies.here_x[b]) * jy - (y - bodies.here_y[b]) * jx)


def book_lost_in_rest(t: Tables, resting: int, share: float, relaxing: bool) -> None:
    """The same of a share of the impulses of resting contacts; see `books.book_contacts`."""
    for k in range(resting):
        pair = t.pairs.resting[k]
        for row in (t.pairs.a[pair], t.pairs.b[pair]):
            if is_particle(t.bodies, row) and (relaxing or t.bodies.waits[row] == PRESENT):
                t.books.particle_turn[0] -= share * turn_by_contact(t, pair, row, relaxing)


def book_turn_by_wall(
    t: Tables, row: int, jx: float, jy: float, turn: float, lasted: float, relaxing: bool
) -> None:
    """Book the angular impulse by an impulse (N s), and an angular one about its centre (N m s),
    that an immovable body gave a body in a resting contact; for what waits see `halting`, for the
    others `books.book_contacts`.
    """
    if relaxing or t.bodies.waits[row] == PRESENT:
        x, y = place_in_part(t.bodies, row, lasted)
        t.books.wall_turn[0] += x * jy - y * jx + turn


def turn_by_contact(t: Tables, pair: int, row: int, relaxing: bool) -> float:
    """Angular impulse about the centre of a body by a resting contact (N m s); `relaxing`, only
    what it changed by since the part.
    """
    contacts = t.contacts
    turn = t.pairs.rolling_torque[pair] * t.pairs.part[pair]
    points = t.pairs.acting[pair]
    if relaxing:
        turn -= t.pairs.booked_rolling[pair]
        points = t.pairs.points[pair]
    first = row == t.pairs.a[pair]
    for point in range(2 * pair, 2 * pair + points):
        normal = contacts.normal_impulse[point]
        tangent = contacts.tangent_impulse[point]
        if relaxing:
            normal -= contacts.booked_normal[point]
            tangent -= contacts.booked_tangent[point]
        if first:
            turn += normal * contacts.normal_arm_a[point]
            turn += tangent * contacts.tangent_arm_a[point]
        else:
            turn += normal * contacts.normal_arm_b[point]
            turn += tangent * contacts.tangent_arm_b[point]
    return -turn if first else turn


def book_turn_by_push(t: Tables, row: int, dt: float) -> None:
    """Book the angular impulses of pushes and fields on a body in a tick (s)."""
    bodies = t.bodies
    x = bodies.start_x[row] * dt + bodies.absement_x[row]
    y = bodies.start_y[row] * dt + bodies.absement_y[row]
    push = bodies.push_torque[row] * dt
    field = bodies.torque[row] * dt - push
    t.books.push_turn[0] += x * bodies.push_y[row] - y * bodies.push_x[row] + push
    t.books.field_turn[0] += x * bodies.field_y[row] - y * bodies.field_x[row] + field
    book_lost(t, row, push + field)
