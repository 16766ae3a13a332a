"""Places are right for screens of all shapes: nothing overlaps, is outside or too small."""

from itertools import combinations

import pytest
from hand import LANDSCAPE, PORTRAIT, lesson, tap
from hypothesis import given
from hypothesis import strategies as st

from screens.kit.geometry import Point, Rect, Size
from screens.kit.layout import SCREENS, TOUCH, columns, layout, rows
from screens.kit.scale import dp_size
from screens.kit.view import Room, View
from screens.kit.widgets import MODAL

OPENS = {"inertia": "force.change", "forces": "cart.b", "reactions": None}

pictures = st.builds(dp_size, st.integers(64, 8192), st.integers(64, 8192))


def inside(rect: Rect, screen: Rect) -> bool:
    near = 1e-6
    return (
        rect.x >= -near
        and rect.y >= -near
        and rect.right <= screen.width + near
        and rect.bottom <= screen.height + near
    )


def apart(a: Rect, b: Rect) -> bool:
    return not a.inset(1e-6).overlaps(b.inset(1e-6))


@given(size=pictures)
def test_parts_of_a_screen_lie_inside_it_and_apart(size: Size) -> None:
    area = layout(size)
    parts = [area.words, area.canvas, area.readouts, area.controls, area.nav]
    assert all(part.width > 0 and part.height > 0 for part in parts)
    assert all(inside(part, area.screen) for part in parts)
    assert all(apart(a, b) for a, b in combinations(parts, 2))


@pytest.mark.parametrize("id", SCREENS)
@given(size=pictures)
def test_widgets_lie_inside_the_screen_apart_and_are_large_enough(id: str, size: Size) -> None:
    shown = lesson(id, size=size)
    check(shown.widgets(), Rect(0, 0, *size))
    if OPENS[id]:
        tap(shown, OPENS[id])
        widgets = shown.widgets()
        opened = [widget.id for widget in widgets].index(MODAL)
        assert widgets[opened].rect == Rect(0, 0, *size)
        check(widgets[opened + 1 :], Rect(0, 0, *size))
        assert all(inside(shown.dialog.panel, widget.rect) for widget in [widgets[opened]])


def check(widgets, screen: Rect) -> None:
    assert len({widget.id for widget in widgets}) == len(widgets)
    for widget in widgets:
        assert inside(widget.rect, screen)
        if widget.id != "body":
            assert min(widget.rect.width, widget.rect.height) >= TOUCH - 1e-6
    assert all(apart(a.rect, b.rect) for a, b in combinations(widgets, 2))


def test_the_canvas_has_half_the_height_upright_and_two_thirds_of_the_width_across() -> None:
    for id in ("inertia", "reactions"):
        assert lesson(id, size=PORTRAIT).view.frame.height >= 320
        assert lesson(id, size=LANDSCAPE).view.frame.width >= 640 * 2 / 3
    for size in (PORTRAIT, LANDSCAPE):
        lanes = [lesson("forces", size=size).lane(lane) for lane in "ab"]
        assert sum(lane.height for lane in lanes) >= size.height / 2


def test_rooms_fill_the_canvas_of_the_reference_screens() -> None:
    for size in (PORTRAIT, LANDSCAPE):
        for id in ("inertia", "reactions"):
            frame, canvas = lesson(id, size=size).view.frame, layout(size).canvas
            assert (frame.width, frame.height) == pytest.approx((canvas.width, canvas.height))


def test_columns_and_rows_share_evenly() -> None:
    assert columns(Rect(0, 0, 110, 40), 3, 10) == [
        Rect(0, 0, 30, 40),
        Rect(40, 0, 30, 40),
        Rect(80, 0, 30, 40),
    ]
    assert rows(Rect(5, 0, 10, 50), 2, 10) == [Rect(5, 0, 10, 20), Rect(5, 30, 10, 20)]


@given(x=st.floats(-9, 9), y=st.floats(-9, 9), wide=st.floats(10, 500), high=st.floats(10, 500))
def test_a_view_maps_to_the_screen_and_back(x: float, y: float, wide: float, high: float) -> None:
    view = View(Rect(7, 11, wide, high), Room(-3, -1, 3, 4))
    assert view.to_world(view.to_screen((x, y))) == pytest.approx((x, y), abs=1e-9)
    top_left = view.to_screen((-3, 4))
    assert top_left == pytest.approx((view.frame.x, view.frame.y))
    assert view.to_screen((0.0, 1.5)) == pytest.approx(Point(7 + wide / 2, 11 + high / 2))


@given(size=pictures)
def test_rooms_fill_their_canvas_on_screens_of_all_shapes(size: Size) -> None:
    for id in ("inertia", "reactions"):
        frame, canvas = lesson(id, size=size).view.frame, layout(size).canvas
        spare = (canvas.width - frame.width, canvas.height - frame.height)
        assert min(spare) == pytest.approx(0.0, abs=1e-6)
        assert max(spare) <= 0.01 * lesson(id, size=size).view.scale + 1e-6


@given(size=pictures)
def test_dialogs_leave_the_words_in_sight(size: Size) -> None:
    """A caption stands where the words are, so it is never over a dialog."""
    for id in ("inertia", "forces"):
        shown = lesson(id, size=size)
        tap(shown, OPENS[id])
        assert not shown.dialog.panel.overlaps(layout(size).words)
        assert inside(shown.dialog.panel, Rect(0, 0, *size))
