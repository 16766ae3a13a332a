from fractions import Fraction

from app.scenario.limits import Scale, excess, pictures
from app.scenario.mistakes import Place
from app.scenario.model import Comparison as C
from app.scenario.model import Drag, Repeat, Screenshot, Speed, Tilt, Until, Wait
from screens.kit.geometry import Point

HERE = Place("f", 1, 1)


def at(line):
    return Place("f", line, 1)


def weigh(*steps):
    return Scale().weigh(steps, Fraction(1))


def test_time_adds_up_exactly():
    load = weigh(
        *[Wait(HERE, 0.1)] * 10,
        Drag(HERE, "a", "b", 0.5),
        Tilt(HERE, Point(1, 2), 0.25, ()),
        Until(HERE, "time", C(above=1), 10),
    )
    assert load.steps == 13
    assert load.simulated == Fraction(7, 4)


def test_slow_motion_makes_the_film_longer_and_not_the_time():
    load = weigh(Wait(HERE, 1), Speed(HERE, 0.25), Wait(HERE, 1), Speed(HERE, 2), Wait(HERE, 1))
    assert load.simulated == 3
    assert load.film == 1 + 4 + Fraction(1, 2)


def test_a_repetition_keeps_the_speed_that_its_first_round_ended_with():
    load = weigh(Repeat(HERE, 3, (Wait(HERE, 1), Speed(HERE, 0.5))))
    assert load.film == 1 + 2 + 2
    assert load.steps == 6


def test_repetitions_are_counted_without_being_carried_out():
    inner = Repeat(HERE, 10**30, (Wait(HERE, 1),))
    assert weigh(Repeat(HERE, 10**30, (inner,))).steps == 10**60


def test_the_step_that_goes_over_a_limit_is_named_once_for_each_limit():
    steps = (
        Wait(at(1), 1800),
        Wait(at(2), 1800),
        Wait(at(3), 1),
        Repeat(at(4), 10_000, (Wait(at(5), 0),)),
        Wait(at(6), 1),
    )
    told = [(m.place.line, m.code) for m in excess(steps)]
    assert told == [
        (3, "too-long"),
        (4, "too-many-steps"),
    ]


def test_exactly_the_limits_are_allowed():
    assert list(excess((Repeat(HERE, 10_000, (Wait(HERE, 0.36),)),))) == []


def test_pictures_of_a_repetition_come_twice():
    shot = Screenshot(HERE, "a.png")
    assert list(pictures((shot, Repeat(HERE, 5, (shot,))))) == [shot] * 3
