"""The first law through events alone; expected numbers are v = F t / m and s = F t^2 / 2 m."""

import math

import pytest
from hand import LANDSCAPE, PORTRAIT, drag, feed, ids, lesson, rect, tap, wait

from screens.kit.dial import HUB, RIM, STRONGEST
from screens.kit.events import Drag, Key, Resize, Tap
from screens.kit.geometry import Point

PUSH = {"body.sides": 5, "body.mass": 2.0, "force.x": 3.0, "force.y": 0.0}
PER_NEWTON = (RIM - HUB) / STRONGEST
"""Of the arrow in the dialog (dp/N)."""


def test_a_body_at_rest_stays_at_rest() -> None:
    inertia = lesson("inertia")
    wait(inertia, 600)
    assert inertia.probes()["body.speed"] == 0.0
    assert (inertia.probes()["body.x"], inertia.probes()["body.y"]) == (0.0, 0.0)


def test_the_force_changes_the_velocity_and_without_it_the_velocity_stays() -> None:
    inertia = lesson("inertia", PUSH)
    tap(inertia, "force.toggle")
    assert inertia.probes()["force.applied"] == 1.0
    wait(inertia, 60)
    pushed = inertia.probes()
    assert pushed["body.vx"] == pytest.approx(1.5, abs=1e-12)
    assert pushed["body.x"] == pytest.approx(0.75, abs=1e-12)
    tap(inertia, "force.toggle")
    wait(inertia, 30)
    coasting = inertia.probes()
    assert coasting["force.applied"] == 0.0
    assert coasting["body.vx"] == pushed["body.vx"]
    assert coasting["body.x"] == pytest.approx(1.5, abs=1e-12)
    assert coasting["momentum.x"] == pytest.approx(3.0, abs=1e-12)


def test_the_toggle_says_what_the_next_tap_does() -> None:
    inertia = lesson("inertia")
    labels = []
    for _ in range(3):
        labels += [w.label for w in inertia.widgets() if w.id == "force.toggle"]
        tap(inertia, "force.toggle")
    assert labels == ["Apply force", "Stop force", "Apply force"]


def test_walls_give_back_the_impulse_that_the_body_loses() -> None:
    inertia = lesson("inertia", {**PUSH, "body.restitution": 0.5, "body.friction": 0.0})
    tap(inertia, "force.toggle")
    wait(inertia, 60)
    tap(inertia, "force.toggle")
    before = inertia.probes()["momentum.x"]
    hits = wait(inertia, 120)
    assert inertia.probes()["collisions"] == len(hits) > 0
    given = sum(hit.impulse.x if hit.b.name == "body" else -hit.impulse.x for hit in hits)
    assert inertia.probes()["momentum.x"] - before == pytest.approx(given, abs=1e-12)
    assert {body.name for hit in hits for body in (hit.a, hit.b)} == {"body", "wall.right"}


@pytest.mark.parametrize("size", [PORTRAIT, LANDSCAPE])
def test_turning_the_arrow_sets_direction_and_strength(size) -> None:
    inertia = lesson("inertia", PUSH, size)
    tap(inertia, "force.change")
    tip = rect(inertia, "force.arrow").center
    center = Point(tip.x - HUB - 3.0 * PER_NEWTON, tip.y)
    drag(inertia, "force.arrow", Point(center.x, center.y - HUB - 4.5 * PER_NEWTON))
    tap(inertia, "dialog.accept")
    assert inertia.probes()["force.x"] == 0.0
    assert inertia.probes()["force.y"] == pytest.approx(4.5, abs=1e-12)
    tap(inertia, "force.toggle")
    wait(inertia, 30)
    assert inertia.probes()["body.vy"] == pytest.approx(4.5 * 0.5 / 2.0, abs=1e-12)
    assert inertia.probes()["body.vx"] == 0.0


def test_the_arrow_ends_at_the_rim_and_may_shrink_to_nothing() -> None:
    inertia = lesson("inertia", PUSH)
    tap(inertia, "force.change")
    center = Point(rect(inertia, "force.arrow").center.x - HUB - 3.0 * PER_NEWTON, 306)
    drag(inertia, "force.arrow", Point(359, 1))
    assert inertia.dialog.strength == pytest.approx(STRONGEST)
    drag(inertia, "force.arrow", center)
    assert inertia.dialog.force == (0.0, 0.0)
    tip = rect(inertia, "force.arrow").center
    assert math.dist(tip, center) == pytest.approx(HUB)
    drag(inertia, "force.arrow", Point(center.x - HUB - 2 * PER_NEWTON, center.y))
    assert inertia.dialog.force == (-2.0, 0.0)


def test_cancel_and_escape_leave_the_force_as_it_was() -> None:
    inertia = lesson("inertia", PUSH)
    for leave in (lambda: tap(inertia, "dialog.cancel"), lambda: feed(inertia, Key("escape"))):
        tap(inertia, "force.change")
        drag(inertia, "force.arrow", Point(100, 200))
        leave()
        assert (inertia.probes()["force.x"], inertia.probes()["force.y"]) == (3.0, 0.0)
        assert "dialog.accept" not in ids(inertia)


def test_a_new_force_acts_at_once_if_one_acts_already() -> None:
    inertia = lesson("inertia", PUSH)
    tap(inertia, "force.toggle")
    wait(inertia, 30)
    tap(inertia, "force.change")
    drag(inertia, "force.arrow", Point(90, 306))
    tap(inertia, "dialog.accept")
    assert inertia.probes()["force.x"] == pytest.approx(-4.0)
    wait(inertia, 30)
    assert inertia.probes()["body.vx"] == pytest.approx((3.0 - 4.0) * 0.5 / 2.0, abs=1e-12)


def test_time_stands_still_while_the_dialog_is_open() -> None:
    inertia = lesson("inertia", PUSH)
    tap(inertia, "force.toggle")
    wait(inertia, 10)
    tap(inertia, "body")
    before = inertia.world.digest(), inertia.probes()
    assert wait(inertia, 60) == []
    assert (inertia.world.digest(), inertia.probes()) == before


def test_the_dialog_covers_the_buttons() -> None:
    inertia = lesson("inertia")
    tap(inertia, "force.change")
    for covered in ("force.toggle", "nav.forces", "body"):
        end = rect(inertia, covered).right - 4, rect(inertia, covered).center.y
        inertia.update(Tap(Point(*end)))
        assert inertia.probes()["force.applied"] == 0.0
        assert "dialog.accept" in ids(inertia)


def test_sides_restitution_and_friction_come_from_the_dice_unless_they_are_set() -> None:
    seen = {len(lesson("inertia", seed=seed).body.shape.vertices) for seed in range(20)}
    assert seen == {5, 6}
    rolled = [lesson("inertia", seed=seed).probes() for seed in range(20)]
    for name in ("body.restitution", "body.friction"):
        values = {probes[name] for probes in rolled}
        assert len(values) == 20
        assert all(0.0 <= value < 1.0 for value in values)
    chosen = lesson("inertia", {"body.friction": 0.25}, seed=3).probes()
    assert chosen["body.friction"] == 0.25
    assert chosen["body.restitution"] == rolled[3]["body.restitution"]


def test_after_a_resize_the_room_is_the_same_and_the_dialog_still_works() -> None:
    inertia = lesson("inertia", PUSH)
    room = inertia.room
    tap(inertia, "force.change")
    feed(inertia, Resize(LANDSCAPE))
    assert inertia.room == room
    tip = rect(inertia, "force.arrow").center
    feed(inertia, Drag(tip, tip), Drag(tip, Point(tip.x - 15.0, tip.y)))
    assert inertia.dialog.force == (2.0, 0.0)
    feed(inertia, Tap(rect(inertia, "dialog.accept").center))
    assert inertia.probes()["force.x"] == 2.0


def test_the_dial_shows_a_force_that_is_stronger_than_its_own() -> None:
    """Both parts of a force may be 6 N, together 8.5 N: the arrow ends between half and full."""
    inertia = lesson("inertia", {"force.x": 6.0, "force.y": 6.0})
    tap(inertia, "force.change")
    dial = inertia.dialog
    tip = dial.tip
    reach = math.dist(tip, dial.center)
    assert (reach - HUB) / (RIM - HUB) == pytest.approx(math.sqrt(72.0) / 9.0)
    drag(inertia, "force.arrow", tip)
    assert dial.strength == pytest.approx(8.5)
