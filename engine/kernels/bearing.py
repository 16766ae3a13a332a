"""How one body is borne by others that do not move: loads that balance what forces do to it.

Its contacts with what lies below it bear it, if there are

    sum of J_i^T f_i = -w,  f_i = (normal, tangent),  normal >= 0, |tangent| <= mu normal,

for the points i of these contacts, where w is the impulse and the angular impulse of forces, and of
loads from above, within the tick, and J_i takes the motion of the body to that of point i along
normal and tangent. Of many solutions that of equal springs is taken, f_i = D_i J_i u with a common
u: stiff along the normal, where they only push, soft along the tangent, where they slide once
friction can do no more, so that it does no more than it must. Three piecewise linear equations,
H(u) u = -w with H = sum of J_i^T D_i J_i, are solved by Newton's method. So loads that statics
leave open do not depend on who comes first.

Until a body has been borne, its kick (see `Bodies`) is what forces and loads from above bring it;
from then on it holds u, with angles in reaches.
"""

from engine.tables import RESTING, Tables

PASSES = 8
"""Passes of Newton's method at most: one finds what bears a body, another that it does, if no point
opens or slides."""

EXACT = 1e-12
"""What loads leave of the impulse of forces, as a share of it, counts as none."""

GRIP = 1e-2
"""Stiffness of springs along the tangent, as a share of that along the normal."""

FREE = 1e-14
"""Springs that hold a body where its points let it glide or roll, as a share of these: no force
drives it there, if it is borne at all."""

LEVEL = 1e-6
"""Of two bodies whose weight presses them together by a smaller share of it, none rests on the
other: they stand side by side."""

NEITHER = -1
"""No body: none of the two rests on the other."""


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
    x = y = turn = 0.0
    for i in range(PASSES):
        bodies.kick_x[row] = x
        bodies.kick_y[row] = y
        bodies.kick_spin[row] = turn
        xx, xy, xt, yx, yy, yt, tx, ty, tt = springs(t, row, i == 0)
        rx = xx * x + xy * y + xt * turn + wx
        ry = yx * x + yy * y + yt * turn + wy
        rt = tx * x + ty * y + tt * turn + wt
        if i > 0 and abs(rx) + abs(ry) + abs(rt) <= most:
            return True
        free = FREE * (xx + yy + tt)
        xx += free
        yy += free
        tt += free
        det = xx * (yy * tt - yt * ty) + xy * (yt * tx - yx * tt) + xt * (yx * ty - yy * tx)
        if det == 0.0:
            return False
        x -= (rx * (yy * tt - yt * ty) + ry * (xt * ty - xy * tt) + rt * (xy * yt - xt * yy)) / det
        y -= (rx * (yt * tx - yx * tt) + ry * (xx * tt - xt * tx) + rt * (xt * yx - xx * yt)) / det
        turn -= (rx * (yx * ty - yy * tx) + ry * (xy * tx - xx * ty)) / det
        turn -= rt * (xx * yy - xy * yx) / det
    return False


def springs(
    t: Tables, row: int, stick: bool
) -> tuple[float, float, float, float, float, float, float, float, float]:
    """Sum of J^T D J over the points that bear a body, row by row. D is how they answer u: not at
    all if they open, along the edge of the friction cone if they slide; all `stick` at first.

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
                held = GRIP
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
    rub = GRIP * (nx * y - ny * x + s * turn)
    most = t.pairs.static_friction[pair] * push
    if rub > most:
        rub = most
    elif rub < -most:
        rub = -most
    return push, rub


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
