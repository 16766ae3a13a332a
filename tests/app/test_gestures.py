import pytest

from app.gestures import gesture, typed
from app.scenario import model
from app.scenario.mistakes import Place
from app.targets import NoTarget
from screens.kit.events import Drag, Key, Release, Tap
from screens.kit.geometry import Point, Rect, Size
from screens.lesson import Widget

HERE = Place("f", 1, 1)


class Screen:
    size = Size(360, 640)

    def __init__(self, *widgets):
        self._widgets = widgets

    def widgets(self):
        return self._widgets


FIELD = Widget("mass.field", Rect(0, 0, 40, 40), "")
SCREEN = Screen(FIELD)


def test_a_tap_takes_no_time():
    (touch,) = gesture(SCREEN, model.Tap(HERE, Point(3, 4)))
    assert touch == ((Tap(Point(3, 4)),), False)


def test_a_drag_moves_once_a_tick_in_equal_parts_and_ends_with_the_finger_going_up():
    step = model.Drag(HERE, Point(0, 0), Point(30, 60), over=0.05)  # 3 ticks
    down, up = Point(0, 0), Point(30, 60)
    assert list(gesture(SCREEN, step)) == [
        ((Drag(down, down),), False),
        ((Drag(down, Point(10, 20)),), True),
        ((Drag(down, Point(20, 40)),), True),
        ((Drag(down, up), Release(up)), True),
    ]


def test_a_drag_of_no_time_happens_at_once():
    step = model.Drag(HERE, Point(0, 0), Point(30, 60), over=0)
    touches = list(gesture(SCREEN, step))
    assert not any(touch.after_tick for touch in touches)
    assert [e for touch in touches for e in touch.events][-1] == Release(Point(30, 60))


def test_a_number_is_typed_into_its_field():
    (touch,) = gesture(SCREEN, model.Fill(HERE, {"mass": 2.5}))
    keys = [Key("2"), Key("."), Key("5"), Key("enter")]
    assert touch == ((Tap(Point(20, 20)), *keys), False)


def test_without_a_dialog_there_is_nothing_to_fill():
    with pytest.raises(NoTarget) as caught:
        list(gesture(Screen(), model.Fill(HERE, {"mass": 2})))
    assert caught.value.sentence == "no dialog with fields is open"


def test_a_field_that_the_dialog_has_not():
    with pytest.raises(NoTarget) as caught:
        list(gesture(SCREEN, model.Fill(HERE, {"colour": 2})))
    assert caught.value.help == "it has: mass"


@pytest.mark.parametrize(
    ("value", "text"), [(2, "2"), (0.1, "0.1"), (-1.25, "-1.25"), (1e-7, "0.0000001"), (-0.0, "0")]
)
def test_numbers_are_typed_without_exponents(value, text):
    assert typed(value) == text
