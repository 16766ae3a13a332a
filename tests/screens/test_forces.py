"""The second law through events alone; expected numbers are F = m a, v = a t, t = sqrt(2 s / a)."""

import math

import pytest
from hand import LANDSCAPE, PORTRAIT, drag, feed, fill, ids, lesson, rect, tap, wait
from hypothesis import given, settings
from hypothesis import strategies as st

from screens.forces import CART, HEAD, LANES, RIGHT, TRACK
from screens.kit import arrows, theme
from screens.kit.canvas import Canvas
from screens.kit.cart_dialog import ACCELERATION, MASS
from screens.kit.events import Key
from screens.kit.geometry import Point, Size
from screens.kit.surface import Surface


def prepared(mass_a: float, rate_a: float, mass_b: float, rate_b: float):
    return lesson(
        "forces",
        {
            "cart.a.mass": mass_a,
            "cart.a.acceleration": rate_a,
            "cart.b.mass": mass_b,
            "cart.b.acceleration": rate_b,
        },
    )


@given(
    mass=st.floats(*MASS),
    rate=st.floats(0.2, ACCELERATION[1]),
)
@settings(max_examples=25, deadline=None)
def test_force_speed_and_time_of_the_run(mass: float, rate: float) -> None:
    forces = prepared(mass, rate, 1.0, 1.0)
    lasts = math.sqrt(2.0 * TRACK / rate)
    tap(forces, "forces.apply")
    early = int(lasts * 60) // 2
    wait(forces, early)
    probes = forces.probes()
    assert probes["cart.a.force"] == pytest.approx(mass * rate, rel=1e-12)
    assert probes["cart.a.vx"] == pytest.approx(rate * early / 60, abs=1e-9)
    assert "cart.a.finish_time" not in probes
    wait(forces, int(lasts * 60) - early + 2)
    probes = forces.probes()
    assert probes["cart.a.finish_time"] == pytest.approx(lasts, abs=1e-9)
    assert probes["cart.a.vx"] == pytest.approx(math.sqrt(2.0 * rate * TRACK), abs=1e-9)


def test_the_push_ends_at_the_mark_and_the_cart_coasts_on() -> None:
    forces = prepared(1.0, 2.0, 2.0, 0.0)
    tap(forces, "forces.apply")
    wait(forces, 180)
    probes = forces.probes()
    assert probes["cart.a.vx"] == pytest.approx(4.0, abs=1e-9)
    assert probes["cart.a.x"] == pytest.approx(TRACK + 4.0 * 1.0, abs=1e-9)
    assert probes["cart.b.x"] == 0.0
    assert "cart.b.finish_time" not in probes


def test_twice_the_mass_needs_twice_the_force_for_the_same_motion() -> None:
    forces = prepared(1.0, 2.0, 2.0, 2.0)
    tap(forces, "forces.apply")
    wait(forces, 90)
    probes = forces.probes()
    assert probes["cart.b.force"] == 2.0 * probes["cart.a.force"]
    assert probes["cart.b.x"] == probes["cart.a.x"]


def test_carts_wait_for_the_forces_and_reset_puts_them_back() -> None:
    forces = prepared(1.0, 2.0, 2.0, 1.0)
    wait(forces, 60)
    assert forces.probes()["cart.a.x"] == 0.0
    tap(forces, "forces.apply")
    wait(forces, 150)
    assert forces.probes()["cart.a.finish_time"] > 0.0
    tap(forces, "forces.reset")
    wait(forces, 30)
    probes = forces.probes()
    assert (probes["cart.a.x"], probes["cart.a.vx"], probes["cart.b.x"]) == (0.0, 0.0, 0.0)
    assert "cart.a.finish_time" not in probes
    tap(forces, "forces.apply")
    wait(forces, 150)
    assert forces.probes()["cart.a.finish_time"] == pytest.approx(2.0, abs=1e-9)


def test_the_forces_can_be_applied_once_until_reset() -> None:
    forces = prepared(1.0, 2.0, 2.0, 1.0)
    enabled = []
    for id in ("forces.apply", "forces.reset"):
        enabled += [w.enabled for w in forces.widgets() if w.id == "forces.apply"]
        tap(forces, id)
    enabled += [w.enabled for w in forces.widgets() if w.id == "forces.apply"]
    assert enabled == [True, False, True]


@pytest.mark.parametrize("size", [PORTRAIT, LANDSCAPE])
def test_fields_take_what_is_typed(size) -> None:
    forces = lesson("forces", {}, size)
    tap(forces, "cart.b")
    fill(forces, "mass", "2.75")
    fill(forces, "acceleration", "1,2")
    tap(forces, "dialog.accept")
    probes = forces.probes()
    assert (probes["cart.b.mass"], probes["cart.b.acceleration"]) == (2.75, 1.2)
    assert probes["cart.b.force"] == pytest.approx(3.3, rel=1e-12)


def test_sliders_go_in_tenths_from_end_to_end() -> None:
    forces = lesson("forces", {})
    tap(forces, "cart.a")
    track = rect(forces, "mass")
    drag(forces, "mass", Point(track.right + 50, track.center.y))
    assert forces.dialog.mass == MASS[1]
    drag(forces, "mass", Point(track.x - 50, track.center.y + 90))
    assert forces.dialog.mass == MASS[0]
    drag(forces, "acceleration", Point(track.center.x, 0))
    assert forces.dialog.acceleration == 2.5
    assert round(forces.dialog.mass * 10) == forces.dialog.mass * 10


def test_what_is_out_of_range_is_moved_into_it_and_what_is_no_number_is_refused() -> None:
    forces = lesson("forces", {"cart.a.mass": 1.0})
    tap(forces, "cart.a")
    fill(forces, "mass", "25")
    assert (forces.dialog.mass, forces.dialog.entries["mass"].refusal) == (10.0, "range")
    fill(forces, "mass", "3.3.3")
    assert (forces.dialog.mass, forces.dialog.entries["mass"].refusal) == (10.0, "number")
    fill(forces, "mass", "4")
    assert (forces.dialog.mass, forces.dialog.entries["mass"].refusal) == (4.0, "")


def test_keys_edit_the_text_and_what_is_no_part_of_a_number_is_ignored() -> None:
    forces = lesson("forces", {"cart.a.mass": 1.0})
    tap(forces, "cart.a")
    tap(forces, "mass.field")
    entry = forces.dialog.entries["mass"]
    assert (entry.text, entry.selected) == ("1.0", True)
    feed(forces, *(Key(key) for key in ("3", "x", ".", "5", "7", "backspace")))
    assert entry.text == "3.5"
    feed(forces, Key("escape"))
    assert (entry.text, forces.dialog.mass) == (None, 1.0)


def test_accept_takes_what_is_being_typed_but_stays_open_to_say_what_is_wrong() -> None:
    forces = lesson("forces", {"cart.a.mass": 1.0})
    tap(forces, "cart.a")
    tap(forces, "mass.field")
    feed(forces, Key("9"), Key("9"))
    tap(forces, "dialog.accept")
    assert "dialog.accept" in ids(forces)
    tap(forces, "dialog.accept")
    assert forces.probes()["cart.a.mass"] == 10.0


def test_cancel_keeps_the_run_and_accept_begins_anew() -> None:
    forces = prepared(1.0, 2.0, 2.0, 1.0)
    tap(forces, "forces.apply")
    wait(forces, 30)
    tap(forces, "cart.a")
    digest = forces.world.digest()
    wait(forces, 60)
    fill(forces, "mass", "5")
    tap(forces, "dialog.cancel")
    assert forces.world.digest() == digest
    wait(forces, 1)
    assert forces.probes()["cart.a.vx"] == pytest.approx(2.0 * 31 / 60, abs=1e-12)
    tap(forces, "cart.a")
    fill(forces, "mass", "5")
    tap(forces, "dialog.accept")
    probes = forces.probes()
    assert (probes["cart.a.x"], probes["cart.b.x"], probes["cart.a.force"]) == (0.0, 0.0, 10.0)
    wait(forces, 10)
    assert forces.probes()["cart.a.x"] == 0.0


def test_the_head_of_a_velocity_is_in_sight_until_the_cart_leaves(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The arrow keeps its length and slides back over the cart, as far as its rear."""
    drawn: list[tuple[float, float]] = []

    def note(canvas: Canvas, at, reach, kind, alpha=1.0) -> Point:
        if kind is arrows.VELOCITY:
            drawn.append((at[0], at[0] + reach[0] / canvas.view.scale))
        return Point(0.0, 0.0)

    monkeypatch.setattr(Canvas, "arrow", note)
    forces = prepared(1.0, 2.0, 2.0, 1.0)
    surface = Surface(360, 640)
    tap(forces, "forces.apply")
    slid = 0
    for _ in range(180):
        wait(forces, 1)
        drawn.clear()
        forces.draw(surface)
        x, speed = forces.probes()["cart.a.x"], forces.probes()["cart.a.vx"]
        if len(drawn) < 2:
            break
        tail, tip = drawn[0]
        assert tip - tail == pytest.approx(
            speed * (drawn[1][1] - drawn[1][0]) / forces.probes()["cart.b.vx"]
        )
        assert x - CART / 2 - 1e-9 <= tail <= x + CART / 2 + 1e-9
        if x + CART / 2 < RIGHT - 0.2:
            assert tip < RIGHT
            slid += tail < x + CART / 2 - 1e-9
    assert slid > 0


def test_a_field_that_is_only_looked_at_keeps_its_value() -> None:
    """It shows 1.235; to accept that would change what an author has chosen."""
    forces = prepared(1.23456, 2.0, 1.0, 1.0)
    tap(forces, "cart.a")
    tap(forces, "mass.field")
    tap(forces, "dialog.accept")
    assert forces.probes()["cart.a.mass"] == 1.23456


@pytest.mark.parametrize("size", [PORTRAIT, LANDSCAPE])
def test_small_numbers_fit_into_their_field(size) -> None:
    forces = lesson("forces", {"cart.a.acceleration": 0.00123}, size)
    tap(forces, "cart.a")
    place, surface = forces.dialog.field("acceleration"), Surface(int(size.width), int(size.height))
    shown, unit = forces.dialog.entries["acceleration"].shown, forces.words("unit.acceleration")
    assert shown == "0.00123"
    words = surface.measure(shown, theme.VALUE).width + surface.measure(unit, theme.BODY).width
    assert words + 19 <= place.width  # with the borders and the gaps


@pytest.mark.parametrize("size", [PORTRAIT, LANDSCAPE, Size(1440, 360), Size(360, 1440)])
def test_a_cart_stands_below_the_words_of_its_lane(size) -> None:
    """In a picture of 4 to 1 it was higher than the lane."""
    forces = lesson("forces", {}, size)
    for name, y in LANES.items():
        top = forces.view(name).to_screen((0.0, y + CART / 2)).y
        assert top >= forces.lane(name).y + HEAD - 1e-9
