"""What sticks to the ground does not move; what is left of its motion goes to the ground.

Each body hands its momentum to the next one below, with what it was handed itself, through a
contact between them; so what contacts give a body in a tick is what it gains, though sweeps leave
a little of what loads should bear.
"""

from engine.kernels.books import book_halt
from engine.kernels.moments import book_lost, place_in_part, turn_by_contact
from engine.kernels.rousing import PRESENT
from engine.kernels.sticking import FIXED
from engine.kernels.touches import impulses_at
from engine.tables import Tables


def halt_fixed(t: Tables, count: int, resting: int) -> None:
    """Halt all bodies that contacts fix to the ground."""
    bodies = t.bodies
    moving = 0
    for row in range(count):
        bodies.shift_x[row] = 0.0
        bodies.shift_y[row] = 0.0
        moves = bodies.vx[row] != 0.0 or bodies.vy[row] != 0.0 or bodies.spin[row] != 0.0
        if moves and is_fixed(t, row):
            book_halt(t, row)
            bodies.shift_x[row] = bodies.mass[row] * bodies.vx[row]
            bodies.shift_y[row] = bodies.mass[row] * bodies.vy[row]
            bodies.vx[row] = 0.0
            bodies.vy[row] = 0.0
            bodies.spin[row] = 0.0
            moving += 1
    if moving > 0:
        hand_down(t, count, resting)


def book_fixed(t: Tables, count: int, share: float, lasted: float) -> bool:
    """Book to the ground, for a share of the part, which lasted so long (s), what it gave to fixed
    bodies besides loads; return whether others take part.

    It takes the angular impulse of whatever acts on what sticks to it, as that does not turn.
    """
    bodies = t.bodies
    loose = False
    turn = 0.0
    for row in range(count):
        if is_fixed(t, row):
            t.books.wall_x[0] -= bodies.mass[row] * bodies.left_x[row] * share
            t.books.wall_y[0] -= bodies.mass[row] * bodies.left_y[row] * share
            x = bodies.from_x[row] + bodies.x[row]
            y = bodies.from_y[row] + bodies.y[row]
            turn += (x * bodies.force_y[row] - y * bodies.force_x[row]) / 2.0
            if bodies.inverse_inertia[row] > 0.0:
                turn += bodies.torque[row]
        elif bodies.held[row] > 0 and bodies.inverse_mass[row] > 0.0:
            loose = True
    t.books.wall_turn[0] -= turn * lasted
    return loose


def book_turns_by_ground(t: Tables, resting: int, share: float, lasted: float) -> None:
    """Book the angular impulses that bodies which are not fixed got from those that are, and from
    the ground, where they got them, in a share of a steady part, which lasted so long (s).
    """
    for k in range(resting):
        pair = t.pairs.resting[k]
        a = t.pairs.a[pair]
        b = t.pairs.b[pair]
        book_grounded(t, pair, a, is_ground(t, b), share, lasted)
        book_grounded(t, pair, b, is_ground(t, a), share, lasted)


def book_grounded(
    t: Tables, pair: int, row: int, by_ground: bool, share: float, lasted: float
) -> None:
    """Book what a body that is no ground gets in a resting contact, if it gets it from ground, and
    what of it is lost.
    """
    if is_ground(t, row):
        return
    turn = turn_by_contact(t, pair, row, False) * share
    book_lost(t, row, turn)
    if by_ground:
        push, rub = impulses_at(t, pair, t.pairs.acting[pair])
        sign = share if row == t.pairs.b[pair] else -share
        jx = sign * (push * t.pairs.normal_x[pair] - rub * t.pairs.normal_y[pair])
        jy = sign * (push * t.pairs.normal_y[pair] + rub * t.pairs.normal_x[pair])
        x, y = place_in_part(t.bodies, row, lasted)
        t.books.wall_turn[0] += x * jy - y * jx + turn


def book_shift_by_ground(t: Tables, a: int, b: int, turn: float) -> None:
    """Book an angular impulse (N m s) that is taken from two bodies that act on each other, as they
    are not where that was planned, if one of them is ground that may move from now on.
    """
    inverse_mass = t.bodies.inverse_mass
    if inverse_mass[a] > 0.0 and inverse_mass[b] > 0.0 and is_ground(t, a) != is_ground(t, b):
        t.books.wall_turn[0] -= turn


def is_ground(t: Tables, row: int) -> bool:
    """Whether nothing moves a body in the present part: it is immovable, or waits and is fixed."""
    bodies = t.bodies
    if bodies.inverse_mass[row] == 0.0:
        return True
    return bodies.waits[row] != PRESENT and bodies.stuck[row] == FIXED


def hand_on(t: Tables, count: int, resting: int, share: float) -> None:
    """Hand to the ground what loads did not bear in a share of a steady part."""
    bodies = t.bodies
    for row in range(count):
        bodies.shift_x[row] = 0.0
        bodies.shift_y[row] = 0.0
        if is_fixed(t, row):
            bodies.shift_x[row] = bodies.mass[row] * bodies.left_x[row] * share
            bodies.shift_y[row] = bodies.mass[row] * bodies.left_y[row] * share
    hand_down(t, count, resting)


def is_fixed(t: Tables, row: int) -> bool:
    """Whether contacts fix a body to the ground."""
    bodies = t.bodies
    return bodies.stuck[row] == FIXED and bodies.inverse_mass[row] > 0.0 and bodies.held[row] > 0


def hand_down(t: Tables, count: int, resting: int) -> None:
    """Hand the momenta in `Bodies.shift_x` and `shift_y` to the ground (N s)."""
    bodies = t.bodies
    pairs = t.pairs
    for level in range(find_supports(t, count, resting), 0, -1):
        for row in range(count):
            if bodies.cluster[row] == level:
                pair = bodies.stirred[row]
                below = pairs.a[pair] + pairs.b[pair] - row
                x = bodies.shift_x[row]
                y = bodies.shift_y[row]
                bodies.shift_x[below] += x
                bodies.shift_y[below] += y
                pairs.given_x[pair] += x if pairs.a[pair] == row else -x
                pairs.given_y[pair] += y if pairs.a[pair] == row else -y


def find_supports(t: Tables, count: int, resting: int) -> int:
    """Find for each body how many contacts lie between it and the ground (in `Bodies.cluster`), and
    which of its pairs leads there (in `Bodies.stirred`); return the greatest number.
    """
    bodies = t.bodies
    level = bodies.cluster
    for row in range(count):
        ground = bodies.stuck[row] == FIXED and bodies.inverse_mass[row] == 0.0
        level[row] = 0 if ground else count + 1
    deepest = 0
    grows = True
    while grows:
        grows = False
        for k in range(resting):
            pair = t.pairs.resting[k]
            a = t.pairs.a[pair]
            b = t.pairs.b[pair]
            above = a if level[a] > level[b] else b
            below = a + b - above
            if bodies.stuck[above] == FIXED and level[above] > level[below] + 1:
                level[above] = level[below] + 1
                bodies.stirred[above] = pair
                grows = True
                if level[above] > deepest:
                    deepest = level[above]
    return deepest
