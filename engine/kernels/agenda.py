"""Which pairs meet in the present part of a tick: a queue that hands out the next to come first.

It is a binary heap (Williams, 1964) by the time of meeting in the column `Pairs.queue`;
`Pairs.queued` says where a pair stands in it, so that one whose time has changed finds its place.

What meets at once is given one time, that of the first (`Progress.together`), and stands in order
of speed: thousands of impacts at one instant are not looked through for each of them.
"""

from engine.tables import NEVER, Tables

TOGETHER = 1e-12
"""Meetings closer in time than this happen at once (s): the fastest is then first."""


def enqueue(t: Tables, pair: int, queued: int) -> int:
    """Give a pair its place by the time at which it meets, or none; return the queue's length."""
    pairs = t.pairs
    place = pairs.queued[pair] - 1
    if pairs.meeting[pair] == NEVER:
        return queued if place < 0 else dequeue(t, place, queued)
    together = t.progress.together[0]
    if together < pairs.meeting[pair] <= together + TOGETHER:
        pairs.meeting[pair] = together
    if place < 0:
        place = queued
        queued += 1
        pairs.queue[place] = pair
        pairs.queued[pair] = place + 1
    sink(t, rise(t, place), queued)
    return queued


def dequeue(t: Tables, place: int, queued: int) -> int:
    """Take out the pair at a place; return the queue's length."""
    pairs = t.pairs
    queued -= 1
    last = pairs.queue[queued]
    pairs.queued[pairs.queue[place]] = 0
    if place < queued:
        pairs.queue[place] = last
        pairs.queued[last] = place + 1
        sink(t, rise(t, place), queued)
    return queued


def is_next(t: Tables, pair: int, other: int) -> bool:
    """Whether a pair comes before another: the earlier, then the faster, then the first listed."""
    pairs = t.pairs
    sooner = pairs.meeting[other] - pairs.meeting[pair]
    if sooner != 0.0:
        return sooner > 0.0
    faster = pairs.speed[pair] - pairs.speed[other]
    return faster > 0.0 or (faster == 0.0 and pair < other)


def rise(t: Tables, place: int) -> int:
    """Move the pair at a place up as far as it comes before others; return its place."""
    pairs = t.pairs
    pair = pairs.queue[place]
    while place > 0:
        above = (place - 1) // 2
        other = pairs.queue[above]
        if not is_next(t, pair, other):
            break
        pairs.queue[place] = other
        pairs.queued[other] = place + 1
        place = above
    pairs.queue[place] = pair
    pairs.queued[pair] = place + 1
    return place


def sink(t: Tables, place: int, queued: int) -> None:
    """Move the pair at a place down as far as it comes after others."""
    pairs = t.pairs
    pair = pairs.queue[place]
    below = 2 * place + 1
    while below < queued:
        if below + 1 < queued and is_next(t, pairs.queue[below + 1], pairs.queue[below]):
            below += 1
        other = pairs.queue[below]
        if is_next(t, pair, other):
            break
        pairs.queue[place] = other
        pairs.queued[other] = place + 1
        place = below
        below = 2 * place + 1
    pairs.queue[place] = pair
    pairs.queued[pair] = place + 1


def next_to_meet(t: Tables, queued: int) -> int:
    """The pair that meets first, at the top; of those at once, the fastest, then the first listed.

    It has the time of the first of these.
    """
    first = t.pairs.meeting[t.pairs.queue[0]]
    if t.progress.together[0] != first:
        t.progress.together[0] = first
        bring_together(t, first, queued)
    return t.pairs.queue[0]


def bring_together(t: Tables, first: float, queued: int) -> None:
    """Give all that meet at once the time of the `first` of them (s).

    Goes from the top down to whatever is not later, from left to right; what is above is in order.
    """
    pairs = t.pairs
    place = 1
    while place > 0:
        if place < queued and pairs.meeting[pairs.queue[place]] <= first + TOGETHER:
            pairs.meeting[pairs.queue[place]] = first
            rise(t, place)
            place = 2 * place + 1
        else:
            while place > 0 and place % 2 == 0:  # from the right one of two to what is above
                place = (place - 1) // 2
            if place > 0:
                place += 1


def empty(t: Tables, queued: int) -> None:
    """Take out all pairs."""
    pairs = t.pairs
    for place in range(queued):
        pair = pairs.queue[place]
        pairs.queued[pair] = 0
        pairs.meeting[pair] = NEVER
    t.progress.together[0] = 0.0
