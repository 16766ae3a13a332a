"""What waits, as its island rests steadily, and what rouses it; see `islands`."""

from engine.tables import Tables

PRESENT, STEADILY, ROUSED = 0, 1, 2
"""How a body waits: not at all; as part of a steady island; as part of one that is to end that."""

SOME, ALL = 1, 2
"""What was roused: islands of which a body is marked; whatever waits (see `Progress.roused`)."""


def pair_waits(t: Tables, pair: int) -> bool:
    """Whether a body of a pair waits."""
    return t.bodies.waits[t.pairs.a[pair]] + t.bodies.waits[t.pairs.b[pair]] > 0


def rouse(t: Tables, pair: int) -> None:
    """Rouse those of a pair that wait, and with them their islands."""
    rouse_body(t, t.pairs.a[pair])
    rouse_body(t, t.pairs.b[pair])


def rouse_body(t: Tables, row: int) -> None:
    """Rouse a body, if it waits."""
    if t.bodies.waits[row] == STEADILY:
        t.bodies.waits[row] = ROUSED
        if t.progress.roused[0] == 0:
            t.progress.roused[0] = SOME
