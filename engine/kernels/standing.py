"""What is built in equilibrium stands from its first tick on: loads are found from the top down.

Where bodies that do not move begin to touch, their island is looked at body by body, each once all
that rests on it has been seen to (shock propagation: Guendelman, Bridson and Fedkiw, "Nonconvex
rigid bodies with stacking", SIGGRAPH 2003). What lies below a body counts as immovable and bears it
(see `bearing`); the reactions become loads of what is below. If each body of the island is borne,
forces move none of them, and all are steady at once; what two pins hold cannot move at all (see
`sticking`). Else the tick takes its course: for what topples or slides, for arches, and what only
leans on each other. The same loads are looked for when those of what is steady no longer bear the
forces.
"""

from engine.kernels.bearing import NEITHER, bear, bears, hand_down, share_of, upper
from engine.kernels.following import find_points, follow, has_drifted
from engine.kernels.resting import TOUCHING
from engine.kernels.steady import LONG
from engine.kernels.sticking import cluster_of, island_of
from engine.kernels.touches import OVERLAP, number_of_tick
from engine.tables import Tables

TAKEN = -1
"""Instead of a number of burdens: this body has been seen to."""


def is_built(t: Tables, resting: int) -> bool:
    """Whether two bodies that do not move began to touch with this tick."""
    pairs = t.pairs
    now = number_of_tick(t)
    for k in range(resting):
        pair = pairs.resting[k]
        if pairs.touched[pair] == now and not (moves(t, pairs.a[pair]) or moves(t, pairs.b[pair])):
            return True
    return False


def moves(t: Tables, row: int) -> bool:
    """Whether a body has any velocity."""
    bodies = t.bodies
    return bodies.vx[row] != 0.0 or bodies.vy[row] != 0.0 or bodies.spin[row] != 0.0


def stand(t: Tables, count: int, resting: int, dt: float, anew: bool) -> int:
    """Let islands that are new, or all that are listed, `anew`, be steady in a tick of `dt` seconds
    if they are in equilibrium.

    Islands are known (see `sticking.connect`); `Bodies.stirred` is 1 for those that are not listed,
    and is 0 afterwards for those that stand. Returns how many bodies do.
    """
    choose(t, count, resting, dt, anew)
    see_to_all(t, queue_tops(t, count, resting))
    bodies = t.bodies
    for row in range(count):
        if bodies.inverse_mass[row] > 0.0 and bodies.burdens[row] != TAKEN:
            bodies.stirred[cluster_of(t, row)] = 1
    standing = 0
    for row in range(count):
        if bodies.inverse_mass[row] > 0.0 and bodies.stirred[cluster_of(t, row)] == 0:
            bodies.calm[row] = LONG
            standing += 1
    if standing > 0:
        t.state.trusted[0] = 0
        for k in range(resting):
            if bodies.stirred[island_of(t, t.pairs.resting[k])] == 0:
                load(t, t.pairs.resting[k], dt)
    return standing


def choose(t: Tables, count: int, resting: int, dt: float, anew: bool) -> None:
    """Choose islands of bodies that touch and do not move, and let forces kick all that rests;
    `Bodies.stirred` is then 0 for the chosen ones. See `stand`.
    """
    bodies = t.bodies
    now = number_of_tick(t)
    for k in range(resting):
        if anew or t.pairs.touched[t.pairs.resting[k]] == now:
            bodies.stirred[island_of(t, t.pairs.resting[k])] = 0
    for row in range(count):
        if bodies.held[row] > 0:
            bodies.middle_x[row] = bodies.x[row]
            bodies.middle_y[row] = bodies.y[row]
            bodies.middle_angle[row] = bodies.angle[row]
            bodies.kick_x[row] = bodies.ax[row] * dt
            bodies.kick_y[row] = bodies.ay[row] * dt
            bodies.kick_spin[row] = bodies.aspin[row] * dt
        if bodies.inverse_mass[row] > 0.0 and (bodies.joined[row] == 1 or moves(t, row)):
            bodies.stirred[cluster_of(t, row)] = 1
    for k in range(resting):
        island = island_of(t, t.pairs.resting[k])
        if bodies.stirred[island] == 0 and not lies_close(t, t.pairs.resting[k]):
            bodies.stirred[island] = 1


def lies_close(t: Tables, pair: int) -> bool:
    """Whether all points of a contact touch, and neither it nor what is below it runs; what was
    steady gapes and overlaps as it may.
    """
    follow(t, pair, 0.0)
    if has_drifted(t, pair):
        find_points(t, pair, 0.0)
    pairs = t.pairs
    if pairs.points[pair] == 0 or pairs.belt_speed[pair] != 0.0:
        return False
    size = pairs.size[pair]
    for row in range(2 * pair, 2 * pair + pairs.points[pair]):
        gap = t.contacts.gap[row]
        bore = pairs.steady[pair] == 1 and (gap < 0.0 or t.contacts.normal_load[row] > 0.0)
        if not bore and (gap > TOUCHING * size or gap < -OVERLAP * size):
            return False
    return not (moves(t, pairs.a[pair]) or moves(t, pairs.b[pair]))


def queue_tops(t: Tables, count: int, resting: int) -> int:
    """Count the burdens of all bodies of chosen islands, and queue those that have none; return
    their number. What nothing bears never gets its turn.
    """
    bodies = t.bodies
    pairs = t.pairs
    burdens = bodies.burdens
    for row in range(count):
        burdens[row] = resting + 1
    for k in range(resting):
        pairs.grouped[k] = NEITHER
        if bodies.stirred[island_of(t, pairs.resting[k])] == 0:
            row = upper(t, pairs.resting[k])
            if row != NEITHER:
                burdens[row] = 0
                pairs.grouped[k] = row
    for k in range(resting):
        row = pairs.grouped[k]
        if row != NEITHER:
            pair = pairs.resting[k]
            burdens[pairs.a[pair] + pairs.b[pair] - row] += 1
    queued = 0
    for k in range(resting):
        row = pairs.grouped[k]
        if row != NEITHER and burdens[row] == 0:
            burdens[row] = TAKEN
            pairs.queue[queued] = row  # nothing else is queued yet
            queued += 1
    return queued


def see_to_all(t: Tables, queued: int) -> None:
    """Bear one body after the other, each when all that rests on it is borne; islands of which one
    is not borne are no longer chosen.
    """
    pairs = t.pairs
    done = 0
    while done < queued:
        row = pairs.queue[done]
        done += 1
        island = cluster_of(t, row)
        if t.bodies.stirred[island] == 1:
            continue
        if not bear(t, row):
            t.bodies.stirred[island] = 1
            continue
        first = t.bodies.first_link[row]
        for link in range(first, first + t.bodies.links[row]):
            pair = t.links.pair[link]
            if bears(t, pair, row):
                below = hand_down(t, pair, row)
                t.bodies.burdens[below] -= 1
                if t.bodies.burdens[below] == 0 and t.bodies.inverse_mass[below] > 0.0:
                    t.bodies.burdens[below] = TAKEN
                    pairs.queue[queued] = below
                    queued += 1


def load(t: Tables, pair: int, dt: float) -> None:
    """Let a contact of what stands bear its load all through a tick of `dt` seconds."""
    pairs = t.pairs
    row = upper(t, pair)
    pairs.steady[pair] = 1
    pairs.part[pair] = dt
    pairs.rolling_torque[pair] = 0.0
    for body in (pairs.a[pair], pairs.b[pair]):
        if t.bodies.inverse_mass[body] == 0.0:
            t.bodies.calm[body] = LONG
    for point in range(2 * pair, 2 * pair + pairs.points[pair]):
        push, rub = 0.0, 0.0
        if row != NEITHER:
            push, rub = share_of(t, pair, point, row)
        t.contacts.normal_load[point] = push / dt
        t.contacts.tangent_load[point] = rub / dt


def take_back_new(t: Tables, resting: int) -> None:
    """Let contacts that began in this tick have given nothing: their loads did not come to act."""
    now = number_of_tick(t)
    for k in range(resting):
        pair = t.pairs.resting[k]
        if t.pairs.touched[pair] == now:
            for point in range(2 * pair, 2 * pair + t.pairs.points[pair]):
                t.contacts.normal_impulse[point] = 0.0
                t.contacts.tangent_impulse[point] = 0.0
