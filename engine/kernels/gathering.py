"""Which impacts of one instant belong together: those on the same bodies that move.

Only what approaches at that instant does. A row of balls that touch hands an impact on from one to
the next, as these do not approach before they are hit; what is plastic hands it to and fro without
end, and is then struck together.
"""

from engine.kernels.agenda import dequeue
from engine.linkage.tally import is_joined
from engine.tables import IMPACTS_AT_ONCE, MOST_HITS, NEVER, RESTING, Tables

TO_AND_FRO = 5
"""After so many blows at one instant a pair is struck together with those that had such as well."""


def gather(t: Tables, pair: int, now: float, time: float, queued: int) -> tuple[int, int]:
    """List in `Hits` a pair that meets at `time` of the part (s), which began `now` seconds after
    the tick, those that meet at the same instant on bodies that move with it, which are taken out
    of the queue, and what else of the ground a body rests on that the ground strikes: it is not to
    be pressed in there. A pair that is struck again and again at this very instant is listed with
    what rests on its bodies and is so too.

    Of the pieces of the same two bodies one pair stands for all. Joined bodies are struck one after
    another, as all that is joined to them answers. Returns the number of pairs, and that of those
    that are left in the queue.
    """
    hits = t.hits
    hits.gathered[0] = pair
    number = 1
    if is_joined(t, pair):
        return number, queued
    again = t.pairs.struck[pair] == now + time and t.pairs.bounces[pair] >= TO_AND_FRO
    others = queued > 0 and t.pairs.meeting[t.pairs.queue[0]] == time
    most = IMPACTS_AT_ONCE - t.impacts.written[0]
    if most > MOST_HITS // 2:
        most = MOST_HITS // 2
    at = 0
    while at < number:
        one = hits.gathered[at]
        a = t.pairs.a[one]
        b = t.pairs.b[one]
        grounded = is_ground(t, a) or is_ground(t, b)
        for body in (a, b):
            if is_ground(t, body) or not (
                others or again or (grounded and t.bodies.held[body] > 0)
            ):
                continue
            first = t.bodies.first_link[body]
            for link in range(first, first + t.bodies.links[body]):
                other = t.links.pair[link]
                meets = t.pairs.queued[other] > 0 and t.pairs.meeting[other] == time
                if not meets and not (
                    (grounded and rests_on_ground(t, other))
                    or (again and rests_struck(t, other, now + time))
                ):
                    continue
                if number < most and not is_joined(t, other) and not is_listed(t, other, number):
                    if meets:
                        queued = dequeue(t, t.pairs.queued[other] - 1, queued)
                        t.pairs.meeting[other] = NEVER
                    hits.gathered[number] = other
                    number += 1
        at += 1
    return number, queued


def is_ground(t: Tables, body: int) -> bool:
    """Whether a body is immovable."""
    return t.bodies.inverse_mass[body] == 0.0 and t.bodies.inverse_inertia[body] == 0.0


def rests_on_ground(t: Tables, pair: int) -> bool:
    """Whether the bodies of a pair rest on each other, and one is immovable."""
    if t.pairs.state[pair] != RESTING:
        return False
    return is_ground(t, t.pairs.a[pair]) or is_ground(t, t.pairs.b[pair])


def rests_struck(t: Tables, pair: int, time: float) -> bool:
    """Whether the bodies of a pair rest on each other and were struck so often at a time (s)."""
    if t.pairs.state[pair] != RESTING or t.pairs.struck[pair] != time:
        return False
    return t.pairs.bounces[pair] >= TO_AND_FRO - 1


def is_listed(t: Tables, pair: int, number: int) -> bool:
    """Whether a pair of the same two bodies is among the `number` that are listed."""
    pairs = t.pairs
    for k in range(number):
        listed = t.hits.gathered[k]
        if pairs.a[listed] == pairs.a[pair] and pairs.b[listed] == pairs.b[pair]:
            return True
    return False
