"""The third law through events alone; expected numbers are closed forms of impacts in a line."""

import math

import pytest
from hand import LANDSCAPE, PORTRAIT, lesson, rect, tap, wait

from screens.kit.events import Tap, Tilt
from screens.kit.geometry import Size
from screens.kit.scale import dp_size
from screens.reactions import LETTERS

ELASTIC = {"particle.restitution": 1.0}


def place(reactions, x: float, y: float) -> None:
    reactions.update(Tap(reactions.view.to_screen((x, y))))


def test_a_tap_adds_a_ball_at_rest_where_it_was() -> None:
    reactions = lesson("reactions", {"particle.mass": 2.0})
    place(reactions, 0.5, -0.25)
    probes = reactions.probes()
    assert probes["particles.count"] == 1.0
    assert probes["particle.1.x"] == pytest.approx(0.5, abs=1e-12)
    assert probes["particle.1.y"] == pytest.approx(-0.25, abs=1e-12)
    assert (probes["particle.1.speed"], probes["particle.1.mass"]) == (0.0, 2.0)
    wait(reactions, 60)
    assert reactions.probes()["particle.1.speed"] == 0.0


@pytest.mark.parametrize(("roll", "pitch"), [(30.0, 0.0), (0.0, 30.0), (-20.0, 45.0)])
def test_tilt_exerts_the_same_force_on_light_and_heavy(roll: float, pitch: float) -> None:
    reactions = lesson("reactions", {"tilt.force": 0.5})
    place(reactions, -0.2, 0.0)
    tap(reactions, "ball.heavier")
    place(reactions, 0.7, 0.0)
    reactions.update(Tilt(roll, pitch))
    wait(reactions, 30)
    probes = reactions.probes()
    force = 0.5 * math.sin(math.radians(roll)), -0.5 * math.sin(math.radians(pitch))
    for number, mass in ((1, 1.0), (2, 2.0)):
        assert probes[f"particle.{number}.mass"] == mass
        for axis, component in zip("xy", force, strict=True):
            moved = probes[f"particle.{number}.v{axis}"]
            assert moved == pytest.approx(component / mass * 0.5, abs=1e-12)
    assert (probes["force.x"], probes["force.y"]) == pytest.approx(force, abs=1e-12)
    assert (probes["tilt.x"], probes["tilt.y"]) == (roll, pitch)


def test_tilt_pushes_later_balls_too_and_level_again_they_coast() -> None:
    reactions = lesson("reactions", {"tilt.force": 1.0})
    reactions.update(Tilt(90.0, 0.0))
    place(reactions, -2.0, 0.0)
    wait(reactions, 30)
    reactions.update(Tilt(0.0, 0.0))
    before = reactions.probes()["particle.1.vx"]
    wait(reactions, 30)
    assert reactions.probes()["particle.1.vx"] == before == pytest.approx(0.5, abs=1e-12)


def head_on(mass_taps: int, settings) -> tuple[object, list[object]]:
    """Ball 1 is set in motion by a tilt, then ball 2 is put into its way."""
    reactions = lesson("reactions", settings)
    place(reactions, -2.0, 0.0)
    reactions.update(Tilt(90.0, 0.0))
    wait(reactions, 30)
    reactions.update(Tilt(0.0, 0.0))
    for _ in range(mass_taps):
        tap(reactions, "ball.heavier")
    place(reactions, 0.0, 0.0)
    return reactions, []


def test_equal_masses_swap_their_velocities() -> None:
    reactions, _ = head_on(0, ELASTIC)
    before = reactions.probes()["particle.1.vx"]
    hits = wait(reactions, 90)
    probes = reactions.probes()
    assert len(hits) == 1 == probes["collisions"]
    assert probes["particle.1.vx"] == pytest.approx(0.0, abs=1e-9)
    assert probes["particle.2.vx"] == pytest.approx(before, abs=1e-9)


def test_heavy_meets_light_as_the_formula_says() -> None:
    # v1' = (m1 u1 - e m2 u1) / (m1 + m2) for a target at rest; m2 = 4 m1
    reactions, _ = head_on(2, {"particle.restitution": 0.5})
    before = reactions.probes()["particle.1.vx"]
    hits = wait(reactions, 80)
    probes = reactions.probes()
    assert probes["particle.1.vx"] == pytest.approx((1.0 - 0.5 * 4.0) / 5.0 * before, abs=1e-9)
    assert probes["particle.2.vx"] == pytest.approx(1.5 / 5.0 * before, abs=1e-9)
    (hit,) = hits
    gained = {
        "particle.1": probes["particle.1.vx"] - before,
        "particle.2": 4.0 * probes["particle.2.vx"],
    }
    assert sum(gained.values()) == pytest.approx(0.0, abs=1e-9)
    assert hit.impulse.x == pytest.approx(gained[hit.b.name], abs=1e-9)


def test_a_tap_beside_the_border_is_moved_inwards() -> None:
    reactions = lesson("reactions")
    place(reactions, -2.99, 3.2)
    probes = reactions.probes()
    assert probes["particle.1.x"] == pytest.approx(-2.75)
    assert probes["particle.1.y"] == pytest.approx(3.0)


def test_a_tap_on_a_ball_or_an_inner_wall_is_refused_and_says_so() -> None:
    reactions = lesson("reactions")
    place(reactions, 0.0, 0.0)
    for x, y in ((0.3, 0.3), (1.35, -1.5)):
        place(reactions, x, y)
        assert reactions.refusal is not None
        assert reactions.probes()["particles.count"] == 1.0
    wait(reactions, 120)
    assert reactions.refusal is None


def test_there_are_as_many_balls_as_letters() -> None:
    reactions = lesson("reactions", {"particle.radius": 0.1})
    for number in range(30):
        place(reactions, -2.8 + 0.5 * (number % 6), -0.6 + 0.25 * (number // 6))
    assert reactions.probes()["particles.count"] == len(LETTERS)


def test_heavier_and_lighter_balls_up_to_a_limit() -> None:
    reactions = lesson("reactions")
    for _ in range(9):
        tap(reactions, "ball.heavier")
    assert reactions.probes()["ball.mass"] == 16.0
    for _ in range(9):
        tap(reactions, "ball.lighter")
    assert reactions.probes()["ball.mass"] == 0.125
    assert [w.enabled for w in reactions.widgets() if w.id == "ball.lighter"] == [False]


def test_what_bounces_on_faintly_is_not_the_last_hit_while_a_stronger_one_is_written_out() -> None:
    reactions = lesson("reactions", {"particle.restitution": 0.1})
    place(reactions, 2.0, 0.0)
    reactions.update(Tilt(90.0, 0.0))
    while reactions.probes()["collisions"] < 3:
        wait(reactions, 1)
    written = [mark.hit for mark in reactions.marks if mark.place]
    assert written != [mark.hit for mark in reactions.marks]
    assert reactions.last_hit is written[-1]


def test_clear_takes_all_away_and_begins_anew() -> None:
    reactions, _ = head_on(0, ELASTIC)
    wait(reactions, 90)
    tap(reactions, "clear")
    probes = reactions.probes()
    assert (probes["particles.count"], probes["collisions"], probes["kinetic_energy"]) == (0, 0, 0)
    assert "particle.1.x" not in probes
    reactions.update(Tilt(10.0, 0.0))
    place(reactions, 0.0, 0.0)
    wait(reactions, 10)
    assert reactions.probes()["particle.1.speed"] > 0.0


def test_restitution_comes_from_the_dice_unless_it_is_set() -> None:
    reactions = lesson("reactions")
    for x in (-2.0, 0.0, 2.0):
        place(reactions, x, 0.0)
    probes = reactions.probes()
    assert len({probes[f"particle.{number}.restitution"] for number in (1, 2, 3)}) == 3
    chosen = lesson("reactions", ELASTIC)
    place(chosen, 0.0, 0.0)
    assert chosen.probes()["particle.1.restitution"] == 1.0


@pytest.mark.parametrize("size", [PORTRAIT, LANDSCAPE])
def test_a_straight_way_leads_across_the_room_along_both_axes(size: Size) -> None:
    for roll, pitch, x, y in ((90, 0, -9, 0), (0, -90, 0, -9)):
        reactions = lesson("reactions", {**ELASTIC, "particle.radius": 0.5}, size)
        room = reactions.room
        place(reactions, max(x, room.left + 0.5), max(y, room.bottom + 0.5))
        assert reactions.probes()["particles.count"] == 1.0
        reactions.update(Tilt(roll, pitch))
        hits = []
        while not hits:
            hits = wait(reactions, 1)
        assert {body.name for body in (hits[0].a, hits[0].b)} == {
            "particle.1",
            "wall.right" if roll else "wall.top",
        }


def test_the_room_does_not_depend_on_how_fine_the_picture_is() -> None:
    small, large = (
        lesson("reactions", size=dp_size(360, 640)),
        lesson("reactions", size=dp_size(2160, 3840)),
    )
    assert small.room == large.room
    for reactions in (small, large):
        reactions.update(Tap(rect(reactions, "canvas").center))
    assert small.world.digest() == large.world.digest()
