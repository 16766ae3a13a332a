"""The queue of meetings hands out the earliest, whatever was put in, changed and taken out."""

from hypothesis import given
from hypothesis import strategies as st

from engine.kernels.agenda import TOGETHER, dequeue, empty, enqueue, next_to_meet
from engine.tables import NEVER, Tables, new_tables

ROOM = 40
times = st.sampled_from([0.0, 0.5, 0.5 + TOGETHER / 4, NEVER]) | st.floats(0.0, 1.0)
changes = st.lists(st.tuples(st.integers(0, ROOM - 1), times, st.integers(0, 3)), max_size=120)


def should_be_next(t: Tables, waiting: set[int]) -> int:
    """What a look at all of them finds."""
    start = min(t.pairs.meeting[pair] for pair in waiting)
    at_once = [pair for pair in waiting if t.pairs.meeting[pair] <= start + TOGETHER]
    return min(at_once, key=lambda pair: (-t.pairs.speed[pair], pair))


@given(changes=changes)
def test_the_next_to_meet_is_the_earliest_then_the_fastest_then_the_first(
    changes: list[tuple[int, float, int]],
) -> None:
    t = new_tables()
    queued, waiting = 0, set[int]()
    for i, (pair, time, speed) in enumerate(changes):
        t.pairs.meeting[pair], t.pairs.speed[pair] = time, float(speed)
        queued = enqueue(t, pair, queued)
        waiting = waiting | {pair} if time < NEVER else waiting - {pair}
        assert queued == len(waiting)
        if waiting:
            first = should_be_next(t, waiting)
            earliest = min(t.pairs.meeting[each] for each in waiting)
            assert next_to_meet(t, queued) == t.pairs.queue[0] == first
            assert t.pairs.meeting[first] == earliest
            if i % 3 == 0:
                waiting.remove(first)
                queued = dequeue(t, 0, queued)
    empty(t, queued)
    assert not any(t.pairs.queued[:ROOM])
