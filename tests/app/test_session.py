import pytest
from fake_lesson import Collector, FakeLesson, FakeSurface, at

from app.camera import Camera, NothingFilmed
from app.overlay import Overlay
from app.scenario.mistakes import Place
from app.scenario.model import Hide, Marker, Show, Speed
from app.session import Session
from screens.kit.events import Tap, Tick
from screens.kit.words import load_words

HERE = Place("test")


@pytest.fixture
def run():
    def play(source, fps=60):
        lesson, collector, heard, waits = FakeLesson(), Collector(), [], []
        surface = FakeSurface()
        camera = Camera(surface, Overlay(load_words()), [collector], fps)
        session = Session(lesson, camera, [collector.moment], heard.append, lambda: waits.append(1))
        session.run(source)
        collector.heard, collector.waits, collector.draws = heard, waits, surface.draws
        return collector

    return play


def test_each_tick_is_one_moment_and_the_start_is_one_too(run):
    made = run([Tick()] * 3)
    assert made.moments == [(tick / 60, tick) for tick in range(4)]
    assert made.shown == [0, 1, 2, 3]
    assert len(made.waits) == 3


def test_what_takes_no_time_is_in_the_frame_of_its_instant(run):
    made = run([Tap(at(10, 10)), Tick(), Tap(at(10, 10)), Tick()])
    assert made.frames == [(0, 0), (1, 1), (2, 2)]
    assert [tick for _, tick in made.moments] == [0, 1, 2]


def test_a_world_that_stands_still_is_told_of_once(run):
    lesson = FakeLesson()
    lesson.update = lambda event: None  # a dialog is open: time does not reach the world
    collector = Collector()
    camera = Camera(FakeSurface(), Overlay(load_words()), [collector], 60)
    Session(lesson, camera, [collector.moment], lambda cue: None).run([Tick()] * 5)
    assert collector.moments == [(0.0, 0)]
    assert len(collector.frames) == 6


def test_what_is_hidden_is_not_filmed_but_happens(run):
    made = run([Tick(), Hide(HERE, "film"), *[Tick()] * 5, Show(HERE, "film"), Tick()])
    assert made.frames == [(0, 0), (1, 6), (2, 7)]
    assert len(made.moments) == 8


def test_a_film_that_is_hidden_from_the_first_frame_is_refused(run):
    with pytest.raises(NothingFilmed, match="no frames"):
        run([Hide(HERE, "film"), Tick()])


def test_who_wants_the_numbers_alone_may_hide_everything():
    collector = Collector()
    camera = Camera(FakeSurface(), Overlay(load_words()), [], 60)
    session = Session(FakeLesson(), camera, [collector.moment], lambda cue: None)
    session.run([Hide(HERE, "film"), Tick()])
    assert len(collector.moments) == 2
    assert camera.clock.frames == 0


def test_slow_motion_draws_each_state_once(run):
    made = run([Speed(HERE, 0.25), Tick(), Tick()])
    assert made.shown == [0] * 4 + [1] * 4 + [2]
    assert made.draws == 3
    assert [tick for _, tick in made.moments] == [0, 1, 2]


def test_ripples_move_in_slow_motion(run):
    assert run([Speed(HERE, 0.25), Tap(at(80, 80)), Tick()]).draws == 5


def test_cues_are_heeded_in_order(run):
    cues = [Marker(HERE, "one"), Tick(), Marker(HERE, "two")]
    assert [cue.name for cue in run(cues).heard] == ["one", "two"]


def test_without_films_frames_are_counted_but_not_drawn():
    surface, counts = FakeSurface(), []
    camera = Camera(surface, Overlay(load_words()), [], 30, counts.append)
    Session(FakeLesson(), camera, [], lambda cue: None).run([Tick()] * 4)
    assert counts == [1, 2, 3]
    assert surface.draws == 0
