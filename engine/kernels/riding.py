"""What rides on a curve goes along it, and normals do no work on it; see `curves`."""

import math

from engine.kernels.books import work_of
from engine.kernels.curves import disc_of, link_of
from engine.kernels.handing import WITHIN, find_heir
from engine.kernels.moments import turn_of
from engine.kernels.pose import place_pair
from engine.kernels.rousing import PRESENT
from engine.kernels.searching import lowest_gap
from engine.linkage.tally import is_joined
from engine.manifolds.any_pair import touching_points
from engine.tables import Tables

REGAINED = 0.02
"""Share of its speed that a body may be given back in a part, at most: what comes to rest does."""


def note_rides(t: Tables, resting: int, share: float) -> None:
    """Note what rides on curves in a part that is over, and the work of normals, of which a `share`
    was given; to be called where that is booked.
    """
    t.progress.riding[0] = 0
    if t.progress.linked[0] == 0:
        return
    for k in range(resting):
        pair = t.pairs.resting[k]
        points = t.pairs.acting[pair]
        if points > 0 and link_of(t, pair) >= 0 and not is_joined(t, pair):
            body = disc_of(t, pair)
            t.bodies.rides[body] += 1
            t.progress.riding[0] += 1
            t.bodies.bent[body] += share * work_of_normals(t, pair, points, False)


def work_of_normals(t: Tables, pair: int, points: int, relaxing: bool) -> float:
    """The work of so many points along the normal, at mean velocities; see `book_contacts` (J)."""
    bodies = t.bodies
    contacts = t.contacts
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    opening = (bodies.mean_x[b] - bodies.mean_x[a]) * t.pairs.normal_x[pair]
    opening += (bodies.mean_y[b] - bodies.mean_y[a]) * t.pairs.normal_y[pair]
    work = 0.0
    for row in range(2 * pair, 2 * pair + points):
        normal = contacts.normal_impulse[row]
        if relaxing:
            normal -= contacts.booked_normal[row]
        turning = bodies.mean_spin[b] * contacts.normal_arm_b[row]
        turning -= bodies.mean_spin[a] * contacts.normal_arm_a[row]
        work += normal * (opening + turning)
    return work


def follow_curves(t: Tables, resting: int) -> None:
    """Let what rides on a curve go along it, at the end of a part, as fast as if nothing but forces
    and friction had done work.
    """
    if t.progress.riding[0] == 0:
        return
    for k in range(resting):
        pair = t.pairs.resting[k]
        if link_of(t, pair) < 0 or is_joined(t, pair):
            continue
        body = disc_of(t, pair)
        t.bodies.bent[body] += work_of_normals(t, pair, t.pairs.points[pair], True)
    for k in range(resting):
        pair = t.pairs.resting[k]
        if link_of(t, pair) < 0 or is_joined(t, pair):
            continue
        body = disc_of(t, pair)
        alone = t.bodies.rides[body] == t.bodies.held[body]
        if t.bodies.rides[body] > 0 and alone and t.bodies.waits[body] == PRESENT:
            go_along(t, pair, body)
        t.bodies.rides[body] = 0
        t.bodies.bent[body] = 0.0


def go_along(t: Tables, pair: int, body: int) -> None:
    """The same for one body that rides on a pair's link, or on one that bears it by now; if it has
    just left, for its flight.
    """
    bodies = t.bodies
    pair, nx, ny = normal_at_end(t, pair, body)
    leaves = bodies.vx[body] * nx + bodies.vy[body] * ny
    along = bodies.vy[body] * nx - bodies.vx[body] * ny
    squared = along * along - 2.0 * bodies.bent[body] * bodies.inverse_mass[body]
    kept = leaves
    if leaves <= t.pairs.carried[pair]:  # or it would be pulled
        squared += leaves * leaves
        kept = 0.0
    most = (1.0 + REGAINED) * abs(along)
    goes = math.sqrt(squared) if squared > 0.0 else 0.0
    if goes > most:
        goes = most
    if along < 0.0:
        goes = -goes
    x = (kept - leaves) * nx - (goes - along) * ny
    y = (kept - leaves) * ny + (goes - along) * nx
    turn(t, pair, body, x, y)


def normal_at_end(t: Tables, pair: int, body: int) -> tuple[int, float, float]:
    """The pair of the link on which a body rides as the part ends, and the unit normal to the body;
    across its way if it flies.
    """
    bodies = t.bodies
    place_pair(t, pair, 0.0)
    points = touching_points(t, pair)
    heir = pair
    if points == 0 or lowest_gap(t, points) > WITHIN * t.pairs.size[pair]:
        heir = find_heir(t, pair, 0.0)
    if heir < 0:
        speed = math.sqrt(bodies.vx[body] * bodies.vx[body] + bodies.vy[body] * bodies.vy[body])
        if speed == 0.0:
            return pair, 0.0, 1.0
        return pair, -bodies.vy[body] / speed, bodies.vx[body] / speed
    if heir != pair:
        place_pair(t, heir, 0.0)
        touching_points(t, heir)
    out = 1.0 if t.pairs.b[pair] == body else -1.0
    return heir, out * t.touch.normal_x[0], out * t.touch.normal_y[0]


def turn(t: Tables, pair: int, body: int, x: float, y: float) -> None:
    """Let a link change the velocity of what rides on it (m/s) by what acts through its centre."""
    bodies = t.bodies
    t.books.contact_heat[0] -= work_of(bodies, body, x, y, 0.0)
    t.books.wall_turn[0] += turn_of(bodies, body, x, y, 0.0)
    jx = bodies.mass[body] * x
    jy = bodies.mass[body] * y
    t.books.wall_x[0] += jx
    t.books.wall_y[0] += jy
    out = 1.0 if t.pairs.b[pair] == body else -1.0
    t.pairs.given_x[pair] += out * jx
    t.pairs.given_y[pair] += out * jy
    bodies.vx[body] += x
    bodies.vy[body] += y
