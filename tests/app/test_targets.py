import pytest

from app.targets import NoTarget, resolve, touched
from screens.kit.geometry import Point, Rect, Size
from screens.lesson import Widget


class Screen:
    """A lesson with nothing but widgets."""

    id = "inertia"
    size = Size(360, 640)

    def __init__(self, *widgets):
        self._widgets = widgets

    def widgets(self):
        return self._widgets


CANVAS = Widget("canvas", Rect(0, 100, 360, 400), "")
APPLY = Widget("apply", Rect(10, 520, 100, 40), "Apply force")
STOP = Widget("stop", Rect(120, 520, 100, 40), "Stop", enabled=False)
COVER = Widget("dialog", Rect(0, 0, 360, 640), "")
ACCEPT = Widget("dialog.accept", Rect(200, 400, 80, 40), "Accept")
CANCEL = Widget("dialog.cancel", Rect(100, 400, 80, 40), "Cancel")
SCREEN = Screen(CANVAS, APPLY, STOP)
DIALOG = Screen(CANVAS, APPLY, STOP, COVER, CANCEL, ACCEPT)


def refusal(screen, target):
    with pytest.raises(NoTarget) as caught:
        resolve(screen, target)
    return caught.value.reason, caught.value.sentence, caught.value.help


def test_a_widget_is_touched_in_its_middle():
    assert resolve(SCREEN, "apply") == Point(60, 540)


def test_a_label_does_as_well_whatever_its_case_and_spacing():
    assert resolve(SCREEN, "Apply force") == Point(60, 540)
    assert resolve(SCREEN, " apply  FORCE ") == Point(60, 540)


def test_a_point_is_taken_as_it_is():
    assert resolve(SCREEN, Point(0, 0)) == Point(0, 0)
    assert resolve(DIALOG, Point(359.9, 639.9)) == Point(359.9, 639.9)


@pytest.mark.parametrize("at", [(-0.1, 5), (5, -0.1), (360, 5), (5, 640)])
def test_a_point_outside_the_screen(at):
    reason, sentence, help = refusal(SCREEN, Point(*at))
    assert reason == "outside"
    assert "outside the screen" in sentence
    assert help == "the screen is 360 dp wide and 640 dp high"


def test_a_widget_that_is_not_there_names_the_nearest():
    assert refusal(SCREEN, "aply") == (
        "missing",
        "there is no 'aply' on the screen now",
        "did you mean 'apply'?",
    )


def test_a_widget_of_a_dialog_that_is_not_open():
    reason, _, help = refusal(SCREEN, "force.arrow")
    assert (reason, help) == ("missing", "it is there while a dialog is open: open it first")


def test_a_disabled_widget():
    assert refusal(SCREEN, "stop")[:2] == ("disabled", "'stop' is disabled now")


def test_a_covered_widget_says_how_to_uncover_it():
    assert refusal(DIALOG, "apply") == (
        "covered",
        "'apply' is covered by the open dialog",
        "tap 'dialog.cancel' or 'dialog.accept' first",
    )
    assert resolve(DIALOG, "Accept") == Point(240, 420)


def test_a_partly_covered_widget_is_touched_beside_the_cover():
    screen = Screen(CANVAS, Widget("ball", Rect(150, 270, 60, 60), ""))
    at = resolve(screen, "canvas")
    assert touched(screen.widgets(), at) is CANVAS


def test_of_two_with_the_same_label_the_one_that_can_be_touched_is_meant():
    below = Widget("below", Rect(0, 0, 50, 50), "Go")
    screen = Screen(below, COVER, Widget("above", Rect(0, 0, 50, 50), "Go"))
    assert resolve(screen, "Go") == Point(25, 25)
    both = Screen(below, Widget("other", Rect(60, 0, 50, 50), "Go"))
    assert refusal(both, "Go") == (
        "ambiguous",
        "'Go' could be any of 'below', 'other'",
        "use the id",
    )


def test_a_touch_goes_to_what_was_drawn_last():
    assert touched(DIALOG.widgets(), Point(240, 420)) is ACCEPT
    assert touched(DIALOG.widgets(), Point(60, 540)) is COVER
    assert touched(SCREEN.widgets(), Point(5, 5)) is None
