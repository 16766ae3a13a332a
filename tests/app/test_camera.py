from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.camera import FilmClock


def film(fps, speeds):
    """Run a clock through ticks at these speeds; the state that each frame shows."""
    clock = FilmClock(fps)
    shown = []
    for state, speed in enumerate(speeds):
        clock.play_at(speed)
        shown += [state] * len(clock.tick())
    shown += [len(speeds)] * len(clock.finish())
    assert clock.frames == len(shown)
    return shown


@pytest.mark.parametrize("fps", [60, 30, 20, 15, 12, 10])
def test_at_true_speed_a_frame_is_due_every_so_many_ticks(fps):
    every = 60 // fps
    assert film(fps, [1] * 120) == list(range(0, 121, every))


def test_the_last_state_is_shown_even_between_two_frames():
    assert film(10, [1] * 7) == [0, 6, 7]


def test_no_tick_at_all_is_one_frame():
    assert film(30, []) == [0]


def test_slow_motion_repeats_frames():
    assert film(60, [0.25] * 2) == [0, 0, 0, 0, 1, 1, 1, 1, 2]


def test_quick_motion_leaves_ticks_out():
    assert film(60, [3] * 7) == [0, 3, 6, 7]


def test_a_speed_that_no_binary_fraction_hits_does_not_drift():
    # 0.1 of true speed for an hour: exactly ten frames a tick, to the last one.
    clock = FilmClock(60)
    clock.play_at(0.1)
    assert all(len(clock.tick()) == 10 for _ in range(20_000))
    assert clock.now == Fraction(200_000, 60)


@given(
    st.sampled_from([60, 30, 20, 15, 12, 10]),
    st.lists(st.sampled_from([0.05, 0.3, 0.7, 1, 1.5, 7, 20]), max_size=60),
)
def test_every_frame_shows_the_latest_state_that_began_by_then(fps, speeds):
    begins = [Fraction(0)]
    for speed in speeds:
        begins.append(begins[-1] + 1 / (60 * Fraction(str(speed))))
    shown = film(fps, speeds)
    for index, state in enumerate(shown[:-1]):
        latest = max(n for n, begin in enumerate(begins) if begin <= Fraction(index, fps))
        assert state == latest
    assert shown[-1] == len(speeds)
    assert 0 <= Fraction(len(shown) - 1, fps) - begins[-1] < Fraction(1, fps)
