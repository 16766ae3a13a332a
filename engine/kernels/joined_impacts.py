"""Impacts on bodies that joints hold: all that is joined to them answers at once.

What a unit impulse changes, joints included, stands where the inverse masses of free bodies would.
"""

from engine.kernels.circles import stillness
from engine.kernels.exchange import gives_energy
from engine.kernels.impulses import (
    approach,
    change_of,
    closing_speed,
    give,
    report,
    response,
    slip,
    split,
)
from engine.kernels.rubbing import belt_speed
from engine.linkage.answers import Changes, amends, answer, lightness, prepare_answers, react
from engine.tables import Tables

YIELDS = 0.05
"""Share of the speed of free bodies that joined ones change by at least, if they yield at all, and
nothing that is heavier is joined to them (see `lightness`): the impulse that is lacking is found by
division by it, and bodies that are jammed hardly move."""

JAMMED = 0.01
"""Share by which joints must let two points be stopped at once: to within a part, velocities are
not quite such as joints allow, and what is amiss would be divided by it."""

WEDGED = 0.8
"""Where joints turn a larger share of a push along the surface into one across it, friction of an
impact would make bodies meet again at once, without end: none acts."""


def amends_of_pair(t: Tables, pair: int, time: float) -> Changes:
    """By how much velocities of both would change if they obeyed their joints at `time` of the part
    (s); all that is joined to them is placed where it is then.
    """
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    prepare_answers(t, a, b, time)
    return amends(t, a, b, time)


def strays(t: Tables, pair: int, x: float, y: float, amiss: Changes) -> float:
    """By how much they approach faster along the normal at (x, y) than if they obeyed their joints,
    which takes `amiss` (m/s); 0 if they do not.
    """
    opens = closing(t, pair, x, y, t.touch.normal_x[0], t.touch.normal_y[0], amiss)
    return opens if opens > 0.0 else 0.0


def approach_allowed(t: Tables, pair: int, point: int, amiss: Changes) -> float:
    """Speed along the normal at which they approach at a point of `Touch`, as far as joints allow
    it (m/s).
    """
    return approach(t, pair, point) - strays(t, pair, t.touch.x[point], t.touch.y[point], amiss)


def exchange_with_joints(
    t: Tables,
    pair: int,
    one: int,
    other: int,
    bounce: float,
    now: float,
    time: float,
    amiss: Changes,
) -> None:
    """Give both bodies their impulses, like `impacts.exchange`; `amiss` is what `amends_of_pair`
    says.

    Impacts that took the speed by which velocities are amiss for real would gain energy, as no
    impulse changes it. What they approach slower by, as they will be held, is not waited for.
    """
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    x = t.touch.x[one]
    y = t.touch.y[one]
    nx = t.touch.normal_x[0]
    ny = t.touch.normal_y[0]
    speed = approach_allowed(t, pair, one, amiss)
    free = response(t, pair, x, y, nx, ny)
    least = YIELDS * lightness(t, a, b)
    yields = closing(t, pair, x, y, nx, ny, push(t, pair, x, y, nx, ny))
    jammed = t.bodies.joined[a] == t.bodies.joined[b] or t.bodies.inverse_mass[a] == 0.0
    if yields < least * free and (jammed or t.bodies.inverse_mass[b] == 0.0):
        return  # they cannot approach: the joints will stop at the end of the part what does so
    total = bounce * speed / yields
    if other >= 0:
        share, both = share_with_joints(t, pair, one, other, bounce, yields, amiss)
        at_x = x + share * (t.touch.x[other] - x)
        at_y = y + share * (t.touch.y[other] - y)
        mean = closing_speed(t, pair, at_x, at_y, nx, ny) - strays(t, pair, at_x, at_y, amiss)
        there = closing(t, pair, at_x, at_y, nx, ny, push(t, pair, at_x, at_y, nx, ny))
        if not gives_energy(both, mean, there):
            x = at_x
            y = at_y
            total = both
            speed = mean
            yields = there
            free = response(t, pair, x, y, nx, ny)
    if total <= 0.0 or speed <= stillness(t, pair):
        return  # what approaches only seems to, as velocities are amiss
    t.books.restitution_heat[0] += total * (speed - total * yields / 2.0)
    t.books.joint_work[0] += total * total * (free - yields) / 2.0
    t.books.joint_work[0] -= total * strays(t, pair, x, y, amiss)
    give_with_joints(t, pair, x, y, total * nx, total * ny, time)
    belt = belt_speed(t, pair, nx, ny)
    astray = closing(t, pair, x, y, -ny, nx, amiss)
    sliding = slip(t, pair, x, y) + astray + belt
    pressing = yields
    free = response(t, pair, x, y, -ny, nx)
    by = push(t, pair, x, y, -ny, nx)
    yields = closing(t, pair, x, y, -ny, nx, by)
    along = 0.0
    wedged = closing(t, pair, x, y, nx, ny, by)
    if yields > least * free and abs(wedged) < WEDGED * pressing:
        along = -sliding / yields
    most = t.pairs.friction[pair] * total
    if along > most:
        along = most
    elif along < -most:
        along = -most
    t.books.friction_heat[0] -= along * (sliding + along * yields / 2.0)
    t.books.wall_work[0] -= along * belt
    t.books.joint_work[0] += along * (along * (free - yields) / 2.0 - astray)
    if along != 0.0:
        give_with_joints(t, pair, x, y, -along * ny, along * nx, time)
    report(t, pair, x, y, total, along, speed, now + time)


def push(t: Tables, pair: int, x: float, y: float, jx: float, jy: float) -> Changes:
    """Changes of velocity by an impulse (N s) at (x, y), given to b and its opposite to a, joints
    included.
    """
    return answer(t, t.pairs.a[pair], t.pairs.b[pair], changes_by(t, pair, x, y, jx, jy))


def changes_by(t: Tables, pair: int, x: float, y: float, jx: float, jy: float) -> Changes:
    """The same if both were free."""
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    turn_a = (x - bodies.here_x[a]) * jy - (y - bodies.here_y[a]) * jx
    turn_b = (x - bodies.here_x[b]) * jy - (y - bodies.here_y[b]) * jx
    return (
        -bodies.inverse_mass[a] * jx,
        -bodies.inverse_mass[a] * jy,
        -bodies.inverse_inertia[a] * turn_a,
        bodies.inverse_mass[b] * jx,
        bodies.inverse_mass[b] * jy,
        bodies.inverse_inertia[b] * turn_b,
    )


def closing(
    t: Tables, pair: int, x: float, y: float, along_x: float, along_y: float, by: Changes
) -> float:
    """By how much changes of velocity make b leave a along a unit vector, at (x, y) (m/s)."""
    bodies = t.bodies
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    vx = by[3] - by[5] * (y - bodies.here_y[b]) - by[0] + by[2] * (y - bodies.here_y[a])
    vy = by[4] + by[5] * (x - bodies.here_x[b]) - by[1] - by[2] * (x - bodies.here_x[a])
    return vx * along_x + vy * along_y


def give_with_joints(
    t: Tables, pair: int, x: float, y: float, jx: float, jy: float, time: float
) -> None:
    """Give the impulse (N s) at (x, y) to b and its opposite to a; let the joints answer."""
    give(t, pair, x, y, jx, jy)
    react(t, t.pairs.a[pair], t.pairs.b[pair], time, changes_by(t, pair, x, y, jx, jy))


def share_with_joints(
    t: Tables, pair: int, one: int, other: int, bounce: float, k11: float, amiss: Changes
) -> tuple[float, float]:
    """Solve for both points at once, like `share_of_two`, joints included."""
    x = t.touch.x[other]
    y = t.touch.y[other]
    nx = t.touch.normal_x[0]
    ny = t.touch.normal_y[0]
    by = push(t, pair, x, y, nx, ny)
    k22 = closing(t, pair, x, y, nx, ny, by)
    v1 = change_of(approach_allowed(t, pair, one, amiss), bounce)
    if k22 < YIELDS * lightness(t, t.pairs.a[pair], t.pairs.b[pair]) * response(
        t, pair, x, y, nx, ny
    ):
        return 0.0, v1 / k11  # joints hold the other
    k12 = closing(t, pair, t.touch.x[one], t.touch.y[one], nx, ny, by)
    v2 = change_of(approach_allowed(t, pair, other, amiss), bounce)
    return split(k11, k12, k22, v1, v2, JAMMED)
