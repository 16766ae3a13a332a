"""Hinges that are solved once between two parts of a tick.

What they exert at the end of a part only makes velocities obey them, at the same poses and by the
same arms as what they exert at the start of the next, which makes up for what is missing: both can
be found as one (RATTLE then is SHAKE: Leimkuhler & Skeel, J. Comput. Phys. 112, 1994). Velocities
have to obey where somebody asks for them: at the end of a tick, and where contacts act or begin.
"""

from engine.kernels.resting import TOUCHING
from engine.tables import FREE, Tables


def let_owe(t: Tables, pair_count: int, held: int, part: float, may: bool) -> bool:
    """Let trees of hinges that nothing touches, or is about to, owe what they exert at the end of a
    part (s), if they `may`: it has not been the last of the tick, and nothing has met in it.

    Returns whether nothing else acts and all of them do, where `held` contacts rest.
    """
    trees = t.trees
    t.progress.owed[0] = 0.0
    for at in range(t.bones.sizes[10]):
        trees.owes[trees.acting[at]] = 1 if may and trees.evenly[trees.acting[at]] == 0 else 0
    if not may or t.bones.sizes[10] == 0:
        return False
    pairs = t.pairs
    for pair in range(pair_count):
        if pairs.state[pair] != FREE or not pairs.apart[pair] > TOUCHING * pairs.size[pair]:
            settle_debt(t, pairs.a[pair])
            settle_debt(t, pairs.b[pair])
    owing = 0
    for at in range(t.bones.sizes[10]):
        owing += trees.owes[trees.acting[at]]
    if owing == 0:
        return False
    t.progress.owed[0] = part
    return held == 0 and owing == t.bones.sizes[10] and t.braces.sizes[0] == 0


def settle_debt(t: Tables, row: int) -> None:
    """Let the tree of a body, if it belongs to one, owe nothing."""
    bone = t.bodies.bone[row] - 1
    if bone >= 0:
        t.trees.owes[t.bones.tree[bone]] = 0
