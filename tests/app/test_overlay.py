"""What is drawn over a lesson: where it is, when it goes, and that the canvas stays free of it."""

import numpy as np
import pytest

from app.overlay import FADE, Overlay
from screens.kit.events import Drag, Release, Tap
from screens.kit.geometry import Point
from screens.kit.layout import layout
from screens.kit.surface import Surface
from screens.kit.words import load_words

MIDDLE = Point(180, 300)


class Empty:
    id = "reactions"


@pytest.fixture
def overlay():
    return Overlay(load_words())


def drawn(overlay, seconds=0.0, size=(360, 640)):
    """Which pixels the overlay touches, at scale 1."""
    surface = Surface(*size)
    overlay.draw(surface, Empty(), seconds)
    return surface.pixels() != 0


def test_it_draws_nothing_if_nothing_happened(overlay):
    assert not drawn(overlay).any()


@pytest.mark.parametrize("size", [(360, 640), (640, 360), (500, 500), (800, 360)])
@pytest.mark.parametrize("caption", ["Short.", "A force of 3 N acts on 2 kg. " * 4, "word " * 60])
def test_a_caption_stays_off_the_canvas_and_the_buttons(overlay, caption, size):
    overlay.caption = caption
    surface = Surface(*size)
    rows, columns = np.nonzero(drawn(overlay, size=size))
    box = layout(surface.size)
    scale = surface.scale
    assert rows.size
    for part in (box.canvas, box.readouts, box.controls, box.nav):
        inside = (rows >= part.y * scale + 1) & (rows < part.bottom * scale - 1)
        inside &= (columns >= part.x * scale + 1) & (columns < part.right * scale - 1)
        assert not inside.any(), part


@pytest.mark.parametrize("size", [(360, 640), (640, 360), (500, 500), (800, 360)])
@pytest.mark.parametrize(
    "caption",
    [
        "\n".join(f"Line {number} of a caption" for number in range(1, 11)),
        "W" * 20 + ("\n" + "W" * 20) * 13,
        "W " * 150,
        "W" * 300,
        "a\n" * 149 + "a",
    ],
    ids=["ten lines", "many wide lines", "wide letters", "one word", "a letter a line"],
)
def test_no_line_of_a_caption_is_cut_off(overlay, caption, size):
    """Below the last line there is the same dark edge as above the first."""
    overlay.caption = caption
    letters = bright(overlay, size)
    rows = np.flatnonzero(letters.any(axis=1))
    box = np.flatnonzero(drawn(overlay, size=size).any(axis=1))
    assert rows[0] - box[0] > 3
    assert box[-1] - rows[-1] > 3


def bright(overlay, size):
    """Which pixels are those of letters, at scale 1."""
    surface = Surface(*size)
    overlay.draw(surface, Empty(), 0.0)
    pixels = surface.pixels()
    return np.minimum(pixels & 0xFF, pixels >> 16) > 150


def test_captions_can_be_hidden(overlay):
    overlay.caption = "Look."
    overlay.shows_captions = False
    assert not drawn(overlay).any()


def test_a_ripple_grows_around_the_finger_and_is_gone_after_its_time(overlay):
    overlay.mark(Tap(MIDDLE), 1.0)
    widths = []
    for seconds in (1.0, 1.1, 1.3):
        rows, columns = np.nonzero(drawn(overlay, seconds))
        assert rows.mean() == pytest.approx(MIDDLE.y - 0.5, abs=0.5)
        assert columns.mean() == pytest.approx(MIDDLE.x - 0.5, abs=0.5)
        widths.append(np.ptp(columns))
    assert widths == sorted(widths)
    assert not drawn(overlay, 1.0 + FADE).any()


def test_marks_of_fingers_can_be_hidden(overlay):
    overlay.mark(Tap(MIDDLE), 0.0)
    overlay.shows_taps = False
    assert not drawn(overlay).any()


def test_a_drag_leaves_a_trail_that_fades(overlay):
    for step in range(7):
        overlay.mark(Drag(MIDDLE, Point(180 + 10 * step, 300)), step / 60)
    pulled = drawn(overlay, 0.1)
    assert pulled[300, 200]
    assert pulled[300, 240]
    overlay.mark(Release(Point(240, 300)), 0.1)
    assert drawn(overlay, 0.2)[300, 200]
    assert not drawn(overlay, 0.1 + FADE).any()


def test_it_says_whether_it_moves(overlay):
    assert not overlay.is_moving(0.0)
    overlay.mark(Tap(MIDDLE), 1.0)
    assert overlay.is_moving(1.2)
    assert not overlay.is_moving(3.0)


def test_drawing_changes_nothing(overlay):
    overlay.mark(Tap(MIDDLE), 0.0)
    overlay.caption = "Look."
    assert (drawn(overlay, 0.2) == drawn(overlay, 0.2)).all()
