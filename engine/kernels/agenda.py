"""Which pairs meet in the present part of a tick: a queue that hands out the next to come first.

It is a binary heap (Williams, 1964) by the time of meeting in the column `Pairs.queue`;
`Pairs.queued` says where a pair stands in it, so that one whose time has changed finds its place.
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


def rise(t: Tables, place: int) -> int:
    """Move the pair at a place up as far as it meets earlier than others; return its place."""
    pairs = t.pairs
    pair = pairs.queue[place]
    time = pairs.meeting[pair]
    while place > 0:
        above = (place - 1) // 2
        other = pairs.queue[above]
        if pairs.meeting[other] <= time:
            break
        pairs.queue[place] = other
        pairs.queued[other] = place + 1
        place = above
    pairs.queue[place] = pair
    pairs.queued[pair] = place + 1
    return place


def sink(t: Tables, place: int, queued: int) -> None:
    """Move the pair at a place down as far as it meets later than others."""
    pairs = t.pairs
    pair = pairs.queue[place]
    time = pairs.meeting[pair]
    below = 2 * place + 1
    while below < queued:
        if below + 1 < queued:
            left = pairs.meeting[pairs.queue[below]]
            if pairs.meeting[pairs.queue[below + 1]] < left:
                below += 1
        other = pairs.queue[below]
        if pairs.meeting[other] >= time:
            break
        pairs.queue[place] = other
        pairs.queued[other] = place + 1
        place = below
        below = 2 * place + 1
    pairs.queue[place] = pair
    pairs.queued[pair] = place + 1


def next_to_meet(t: Tables, queued: int) -> int:
    """Place of the pair that meets first; of those at once, the fastest, then the first listed.

    Goes from the top down to whatever is not later, from left to right.
    """
    pairs = t.pairs
    best = pairs.queue[0]
    until = pairs.meeting[best] + TOGETHER
    place = 1
    while place > 0:
        if place < queued and pairs.meeting[pairs.queue[place]] <= until:
            pair = pairs.queue[place]
            faster = pairs.speed[pair] - pairs.speed[best]
            if faster > 0.0 or (faster == 0.0 and pair < best):
                best = pair
            place = 2 * place + 1
        else:
            while place > 0 and place % 2 == 0:  # from the right one of two to what is above
                place = (place - 1) // 2
            if place > 0:
                place += 1
    return pairs.queued[best] - 1


def empty(t: Tables, queued: int) -> None:
    """Take out all pairs."""
    pairs = t.pairs
    for place in range(queued):
        pair = pairs.queue[place]
        pairs.queued[pair] = 0
        pairs.meeting[pair] = NEVER
