"""What sticks to the ground does not move; what is left of its motion goes to the ground.

Each body hands its momentum to the next one below, with what it was handed itself, through a
contact between them; so what contacts give a body in a tick is what it gains, though sweeps leave
a little of what loads should bear.
"""

from engine.kernels.books import book_halt
from engine.kernels.sticking import FIXED
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


def book_fixed(t: Tables, count: int, share: float) -> None:
    """Book to the ground, for a share of the part, what it gave to fixed bodies besides loads."""
    bodies = t.bodies
    for row in range(count):
        if is_fixed(t, row):
            t.books.wall_x[0] -= bodies.mass[row] * bodies.left_x[row] * share
            t.books.wall_y[0] -= bodies.mass[row] * bodies.left_y[row] * share


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
