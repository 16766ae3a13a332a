"""Chains that stand for curves: a bowl, a half-pipe, a loop, a cycloid.

Where a chain turns towards a disc by little, it is taken for the curve that it was drawn for, which
bends within a corner. What bears there bears along some direction between the normals of the two
links (the normal cone of the corner: Moreau, "Unilateral contact and dry friction in finite freedom
dynamics", 1988), and of these the curve takes the one that does no work: what rides on it is
turned and not braked. The work of normals is summed over a part, and given back at its end; see
`riding`.
"""

from engine.kernels.touches import number_of_tick
from engine.manifolds.link import is_link
from engine.tables import Tables

BENT = 0.1
"""Sine of the angle up to which a corner is one of a curve."""

STRAIGHT = 1e-9
"""Sine of the angle up to which links go straight on."""


def link_of(t: Tables, pair: int) -> int:
    """The link of a pair of one and a disc about its centre, if it is of a curve; else -1."""
    pieces = t.pieces
    link = t.pairs.piece_a[pair]
    disc = t.pairs.piece_b[pair]
    if not is_link(pieces, link):
        link, disc = disc, link
    if not is_link(pieces, link) or pieces.corners[disc] != 1 or pieces.swing[disc] > 0.0:
        return -1
    before = bend(t, link, pieces.before[link])
    after = -bend(t, link, pieces.after[link])
    first = pieces.first[link]
    x = t.bodies.x[pieces.body[disc]] - t.corners.world_x[first]
    y = t.bodies.y[pieces.body[disc]] - t.corners.world_y[first]
    if x * t.corners.world_normal_x[first] + y * t.corners.world_normal_y[first] < 0.0:
        before = -before
        after = -after
    if STRAIGHT < before < BENT or STRAIGHT < after < BENT:
        return link
    return -1


def bend(t: Tables, link: int, neighbour: int) -> float:
    """Sine of the angle from a neighbour of a link, as the link names it, to the link."""
    if neighbour == 0:
        return 0.0
    first = t.pieces.first[link]
    other = t.pieces.first[t.bodies.first_piece[t.pieces.body[link]] + neighbour - 1]
    normal_x = t.corners.world_normal_x
    normal_y = t.corners.world_normal_y
    return normal_y[other] * normal_x[first] - normal_x[other] * normal_y[first]


def disc_of(t: Tables, pair: int) -> int:
    """Which body of a pair with a link is not the chain."""
    a = t.pairs.a[pair]
    return t.pairs.b[pair] if is_link(t.pieces, t.pairs.piece_a[pair]) else a


def note_blow(t: Tables, pair: int, lost: float) -> None:
    """Note what an impact along the normal took (J) of what came along a curve: it touched another
    link in this tick, and turned by no more than a corner may.
    """
    if t.progress.linked[0] == 0 or t.progress.straight[0] == 1:  # then no tick begins the sum anew
        return
    link = link_of(t, pair)
    if link < 0:
        return
    bodies = t.bodies
    body = disc_of(t, pair)
    squared = bodies.vx[body] * bodies.vx[body] + bodies.vy[body] * bodies.vy[body]
    if lost > BENT * BENT * bodies.mass[body] * squared / 2.0:
        return
    first = bodies.first_link[body]
    for k in range(first, first + bodies.links[body]):
        other = t.links.pair[k]
        if other == pair or t.pairs.touched[other] != number_of_tick(t):
            continue
        beside = link_of(t, other)
        if beside >= 0 and go_on(t, link, beside):
            bodies.bent[body] -= lost
            return


def go_on(t: Tables, one: int, other: int) -> bool:
    """Whether two links of curves are of one, and lead almost the same way: what is fast passes
    some of them in a part.
    """
    if t.pieces.body[one] != t.pieces.body[other]:
        return False
    name = other - t.bodies.first_piece[t.pieces.body[other]] + 1
    return abs(bend(t, one, name)) < BENT
