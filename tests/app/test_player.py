import pytest
from fake_lesson import FakeLesson, at, scenario

from app.player import LONGEST, Player, ScenarioFailed
from app.scenario.mistakes import Place
from app.scenario.model import (
    Caption,
    Comparison,
    Drag,
    Expect,
    Marker,
    Repeat,
    Run,
    Tap,
    Tilt,
    Until,
    Wait,
)
from screens.kit import events
from screens.kit.geometry import Point

HERE = Place("push.yaml", 7, 5, 5, "  - until: {probe: body.speed}")


def play(*steps, lesson=None):
    lesson = lesson or FakeLesson()
    player = Player(scenario(*steps), lesson)
    done = []
    for doing in player.play():
        done.append(doing)
        if isinstance(doing, events.Event):
            lesson.update(doing)
    return player, lesson, done


def until(probe, within=1.0, **comparison):
    return Until(HERE, probe, Comparison(**comparison), within)


def expect(probe, **comparison):
    return Expect(HERE, probe, Comparison(**comparison))


def test_a_tap_takes_no_time_so_a_push_of_one_second_is_one_second():
    _, lesson, done = play(Tap(HERE, "push"), Wait(HERE, 1.0))
    assert done[0] == events.Tap(at(25, 25))
    assert done[1:] == [events.Tick()] * 60
    assert lesson.body.speed == pytest.approx(2.0, rel=1e-12)  # v = F t / m


def test_a_wait_is_rounded_to_ticks():
    _, lesson, _ = play(Wait(HERE, 0.008), Wait(HERE, 0.009))
    assert lesson.world.tick == 1


def test_until_holds_at_once_or_at_the_first_tick_it_does():
    player, lesson, _ = play(until("body.x", equals=0))
    assert lesson.world.tick == 0
    _, lesson, _ = play(Tap(HERE, "push"), until("body.speed", above=0.99, within=5))
    assert lesson.world.tick == 30  # v = 2 t passes 0.99 at t = 0.495 s, between ticks 29 and 30
    assert player.checks[0].passed


def test_until_that_never_holds_says_the_last_and_the_nearest_value():
    with pytest.raises(ScenarioFailed) as failed:
        play(Tap(HERE, "push"), until("body.speed", below=-1, within=2))
    text = str(failed.value)
    assert text.startswith("push.yaml:7:5: error[until-failed]: body.speed did not come")
    assert "it is 4 now" in text
    assert "nearest at t = 0.000 s with 0" in text


def test_until_of_a_number_that_is_not_there():
    with pytest.raises(ScenarioFailed, match="it had no value"):
        play(until("nothing", above=0))


def test_failed_expectations_are_collected_and_the_film_goes_on():
    player, lesson, _ = play(
        expect("body.speed", equals=1),
        expect("body.speed", equals=0),
        expect("particle.3.x", equals=0),
        Wait(HERE, 1),
    )
    assert lesson.world.tick == 60
    first, second = player.failures()
    assert (
        first.sentence == "body.speed should be equal to 1, but it is 0, off by 1, at t = 0.000 s"
    )
    assert second.sentence.endswith("but it has no value at t = 0.000 s")
    assert [check.passed for check in player.checks] == [False, True, False]


def test_a_near_miss_is_told_from_a_hit():
    player, _, _ = play(
        Tap(HERE, "push"), Wait(HERE, 0.1), expect("body.speed", near=0.2 + 1e-10, tol=1e-13)
    )
    (failure,) = player.failures()
    assert "but it is 0.2, off by 1e-10, at t = 0.100 s" in failure.sentence


def test_what_cannot_be_tapped_stops_the_run_with_its_place():
    with pytest.raises(ScenarioFailed, match=r"push.yaml:7:5: error\[no-target\]: 'dead' is disab"):
        play(Tap(HERE, "dead"))


def test_a_drag_is_a_straight_line_of_as_many_moves_as_ticks():
    _, lesson, done = play(Drag(HERE, Point(0, 0), Point(40, 20), 0.0666))
    down = Point(0, 0)
    line = [events.Drag(down, Point(10.0 * n, 5.0 * n)) for n in range(5)]
    moves = [doing for doing in done if isinstance(doing, events.Drag)]
    assert moves == line
    assert done[-1] == events.Release(Point(40, 20))
    assert lesson.world.tick == 4


def test_a_tilt_is_linear_from_where_it_was():
    _, lesson, done = play(
        Tilt(HERE, Point(10, 0), 0.0, ()), Tilt(HERE, Point(20, -10), 1.0, ()), Wait(HERE, 0.5)
    )
    tilts = [(d.roll, d.pitch) for d in done if isinstance(d, events.Tilt)]
    assert tilts[0] == (10, 0)
    assert (pytest.approx(15), pytest.approx(-5)) in tilts
    assert lesson.tilt == (20, -10)
    assert lesson.world.tick == 90


def test_a_tilt_along_a_curve():
    curve = ((0.0, 5.0, 0.0), (0.5, 15.0, 0.0), (1.0, 15.0, 30.0))
    _, lesson, done = play(Tilt(HERE, None, 1.0, curve))
    tilts = [(d.roll, d.pitch) for d in done if isinstance(d, events.Tilt)]
    assert tilts[0] == (5, 0)
    assert tilts[30] == (15, 0)
    assert tilts[45] == (pytest.approx(15), pytest.approx(15))
    assert lesson.tilt == (15, 30)
    assert lesson.world.tick == 60


def test_repeat_and_run_do_their_steps():
    steps = (Marker(HERE, "again"), Wait(HERE, 1 / 60))
    _, lesson, done = play(Repeat(HERE, 3, steps), Run(HERE, "other.yaml", steps))
    assert [type(doing).__name__ for doing in done] == ["Marker", "Tick"] * 4
    assert lesson.world.tick == 4


def test_captions_are_passed_on():
    caption = Caption(HERE, "Look.")
    assert play(caption)[2] == [caption]


def test_an_hour_is_the_longest():
    class Frozen(FakeLesson):
        def update(self, event):
            pass

    steps = (Wait(HERE, 3600.0), until("body.x", above=1, within=1))
    with pytest.raises(ScenarioFailed, match=r"too-long.*longer than 1 h"):
        play(*steps, lesson=Frozen())
    assert LONGEST == 216_000
