"""What is built in equilibrium stands from its first tick on: loads are found from the top down.

An island that was just put there at rest is looked at body by body, each once all that rests on it
has been seen to (shock propagation: Guendelman, Bridson and Fedkiw, "Nonconvex rigid bodies with
stacking", SIGGRAPH 2003). What lies below a body counts as immovable, and bears it if there are

    sum of J_i^T f_i = -w,  f_i = (normal, tangent),  normal >= 0, |tangent| <= mu normal,

for the points i of its contacts, where w is the impulse and angular impulse of forces and of loads
from above within the tick, and J_i takes the motion of the body to that of point i along the normal
and the tangent. Of many solutions the one of equal springs is taken, f_i = J_i u with a common u,
as far as they neither pull nor slide: Newton's method for three piecewise linear equations. The
reactions become loads of what is below. If two pins then hold each body of the island (see
`sticking`), it does not move, and is steady at once; else the tick takes its course. So do discs,
arches, and what only leans on each other.
"""

from engine.kernels.following import find_points, follow, has_drifted
from engine.kernels.resting import OVERLAP, TOUCHING
from engine.kernels.steady import LONG
from engine.kernels.sticking import APART, HELD, cluster_of, island_of, place_of
from engine.kernels.touches import number_of_tick
from engine.tables import RESTING, Tables

PASSES = 8
"""Passes of Newton's method at most: one finds what bears a body, another that it does, if no point
opens or slides."""

EXACT = 1e-10
"""What loads leave of the impulse of forces, as a share of it, counts as none."""

SINGULAR = 1e-10
"""Least determinant of springs that hold a body, as a share of the cube of their trace."""

LEVEL = 1e-6
"""Of two bodies whose weight presses them together by a smaller share of it, none rests on the
other: they stand side by side."""

NEITHER = -1
"""No body: none of the two rests on the other."""

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

    Islands are known (see `islands.connect`); `Bodies.stirred` is 1 for those that are not listed,
    and is 0 afterwards for those that stand. Returns how many bodies do.
    """
    choose(t, count, resting, dt, anew)
    see_to_all(t, resting, queue_tops(t, count, resting))
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


def upper(t: Tables, pair: int) -> int:
    """Which of a pair rests on the other: the one that forces press on it, or `NEITHER`."""
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    if bodies.inverse_mass[a] == 0.0:
        return b
    if bodies.inverse_mass[b] == 0.0:
        return a
    x = bodies.ax[a] + bodies.ax[b]
    y = bodies.ay[a] + bodies.ay[b]
    along = x * t.pairs.normal_x[pair] + y * t.pairs.normal_y[pair]
    if abs(along) <= LEVEL * (abs(x) + abs(y)):
        return NEITHER
    return a if along > 0.0 else b


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


def see_to_all(t: Tables, resting: int, queued: int) -> None:
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
        if not (bear(t, row) and is_pinned(t, row)):
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


def bears(t: Tables, pair: int, row: int) -> bool:
    """Whether a body rests on the other of a pair."""
    return t.pairs.state[pair] == RESTING and upper(t, pair) == row


def bear(t: Tables, row: int) -> bool:
    """Find the common u of the points that bear a body, and put it in place of its kick; return
    whether there is one.
    """
    bodies = t.bodies
    mass = bodies.mass[row]
    wx = mass * bodies.kick_x[row]
    wy = mass * bodies.kick_y[row]
    wt = 0.0
    if bodies.inverse_inertia[row] > 0.0:
        wt = bodies.inertia[row] * bodies.kick_spin[row] / bodies.reach[row]
    most = EXACT * (abs(wx) + abs(wy) + abs(wt))
    for i in range(PASSES):
        xx, xy, xt, yx, yy, yt, tx, ty, tt = springs(t, row, i == 0)
        x = bodies.kick_x[row]
        y = bodies.kick_y[row]
        turn = bodies.kick_spin[row]
        left = abs(xx * x + xy * y + xt * turn + wx)
        left += abs(yx * x + yy * y + yt * turn + wy)
        left += abs(tx * x + ty * y + tt * turn + wt)
        if i > 0 and left <= most:
            return True
        trace = xx + yy + tt
        det = xx * (yy * tt - yt * ty) + xy * (yt * tx - yx * tt) + xt * (yx * ty - yy * tx)
        if abs(det) <= SINGULAR * trace * trace * trace:
            return False
        x = wx * (yy * tt - yt * ty) + wy * (xt * ty - xy * tt) + wt * (xy * yt - xt * yy)
        y = wx * (yt * tx - yx * tt) + wy * (xx * tt - xt * tx) + wt * (xt * yx - xx * yt)
        turn = wx * (yx * ty - yy * tx) + wy * (xy * tx - xx * ty) + wt * (xx * yy - xy * yx)
        bodies.kick_x[row] = -x / det
        bodies.kick_y[row] = -y / det
        bodies.kick_spin[row] = -turn / det
    return False


def springs(
    t: Tables, row: int, stick: bool
) -> tuple[float, float, float, float, float, float, float, float, float]:
    """Sum of J^T D J over the points that bear a body, row by row, D being how they yield to u: not
    at all if they open, along the edge of the friction cone if they slide; all `stick` at first.

    Angles are counted in reaches; a body that never turns is held by itself.
    """
    bodies = t.bodies
    pairs = t.pairs
    xx = xy = xt = yx = yy = yt = tx = ty = tt = 0.0
    if bodies.inverse_inertia[row] == 0.0:
        tt = 1.0
    first = bodies.first_link[row]
    for link in range(first, first + bodies.links[row]):
        pair = t.links.pair[link]
        if bears(t, pair, row):
            for point in range(2 * pair, 2 * pair + pairs.points[pair]):
                nx, ny, n, s = directions(t, pair, point, row)
                ax = nx
                ay = ny
                at = n
                held = 1.0
                if not stick:
                    push, rub = share_of(t, pair, point, row)
                    if push == 0.0:
                        continue
                    most = pairs.static_friction[pair] * push
                    if abs(rub) == most:
                        held = 0.0
                        ax -= rub / push * ny
                        ay += rub / push * nx
                        at += rub / push * s
                xx += ax * nx + held * ny * ny
                xy += ax * ny - held * ny * nx
                xt += ax * n - held * ny * s
                yx += ay * nx - held * nx * ny
                yy += ay * ny + held * nx * nx
                yt += ay * n + held * nx * s
                tx += at * nx - held * s * ny
                ty += at * ny + held * s * nx
                tt += at * n + held * s * s
    return xx, xy, xt, yx, yy, yt, tx, ty, tt


def directions(t: Tables, pair: int, point: int, row: int) -> tuple[float, float, float, float]:
    """The normal towards a body of a pair, and the lever arms along it and along the tangent, in
    reaches of the body.
    """
    bodies = t.bodies
    nx = t.pairs.normal_x[pair]
    ny = t.pairs.normal_y[pair]
    scale = 1.0 / bodies.reach[row] if bodies.inverse_inertia[row] > 0.0 else 0.0
    if row == t.pairs.b[pair]:
        n = t.contacts.normal_arm_b[point]
        s = t.contacts.tangent_arm_b[point]
        return nx, ny, n * scale, s * scale
    n = t.contacts.normal_arm_a[point]
    s = t.contacts.tangent_arm_a[point]
    return -nx, -ny, -n * scale, -s * scale


def share_of(t: Tables, pair: int, point: int, row: int) -> tuple[float, float]:
    """What a point gives the upper body of a pair along the normal and the tangent (N s)."""
    bodies = t.bodies
    nx, ny, n, s = directions(t, pair, point, row)
    x = bodies.kick_x[row]
    y = bodies.kick_y[row]
    turn = bodies.kick_spin[row]
    push = nx * x + ny * y + n * turn
    if push <= 0.0:
        return 0.0, 0.0
    rub = nx * y - ny * x + s * turn
    most = t.pairs.static_friction[pair] * push
    if rub > most:
        rub = most
    elif rub < -most:
        rub = -most
    return push, rub


def is_pinned(t: Tables, row: int) -> bool:
    """Whether two pins, apart from each other, hold a body on what bears it; see `sticking`."""
    pairs = t.pairs
    pinned = False
    pin_x = 0.0
    pin_y = 0.0
    least = APART * t.bodies.reach[row]
    first = t.bodies.first_link[row]
    for link in range(first, first + t.bodies.links[row]):
        pair = t.links.pair[link]
        if not bears(t, pair, row):
            continue
        push, rub = share_of(t, pair, 2 * pair, row)
        other, more = 0.0, 0.0
        if pairs.points[pair] == 2:
            other, more = share_of(t, pair, 2 * pair + 1, row)
        if abs(rub + more) >= HELD * pairs.static_friction[pair] * (push + other):
            continue
        for point in range(2 * pair, 2 * pair + pairs.points[pair]):
            if (push if point == 2 * pair else other) > 0.0:
                x, y = place_of(t, pair, point)
                if pinned and (x - pin_x) * (x - pin_x) + (y - pin_y) * (y - pin_y) > least * least:
                    return True
                if not pinned:
                    pinned = True
                    pin_x = x
                    pin_y = y
    return False


def hand_down(t: Tables, pair: int, row: int) -> int:
    """Let what bears a body in a pair bear its load; return its row."""
    bodies = t.bodies
    below = t.pairs.a[pair] + t.pairs.b[pair] - row
    for point in range(2 * pair, 2 * pair + t.pairs.points[pair]):
        push, rub = share_of(t, pair, point, row)
        nx, ny, n, s = directions(t, pair, point, below)
        bodies.kick_x[below] += bodies.inverse_mass[below] * (push * nx - rub * ny)
        bodies.kick_y[below] += bodies.inverse_mass[below] * (push * ny + rub * nx)
        turn = bodies.inverse_inertia[below] * bodies.reach[below] * (push * n + rub * s)
        bodies.kick_spin[below] += turn
    return below


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
