"""Phases of a tick, and why kernels hand back: what Python must know without loading them."""

WAITING, PAIRING, MOVING = 0, 1, 2
"""Phases: between two ticks; pairs are to be found; bodies move."""

DONE, CROWDED, ESCAPED = 0, 1, 2
"""Why `travel` returns: the tick is over; the table of impacts is full; a body left its box."""

FULL, UNMIXED, LOST, LOOSE = 10, 11, 12, 13
"""Why `tick.run` returns, besides `DONE` and `CROWDED`: there are more pairs than room;
coefficients of pairs are asked for; a body left the range of numbers; joints are to be put in
order."""
