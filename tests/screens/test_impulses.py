"""What is seen of hits: words that stay where they stood, and arrows whose heads are in sight."""

from random import Random

import pytest
from hand import LANDSCAPE, PORTRAIT, lesson, tap, wait

from engine import Vector
from screens.kit import hits, impulses
from screens.kit.bodies import HEAD_ROOM, beside, fitting, leaving
from screens.kit.canvas import Canvas, bar_room
from screens.kit.events import Resize, Tap, Tilt
from screens.kit.geometry import Point, Size
from screens.kit.impulses import LANE
from screens.kit.surface import Surface


def crowd(size: Size, count: int = 20, seed: int = 3):
    """Balls of two masses all over the room, pushed about by a tilt."""
    dice, reactions = Random(seed), lesson("reactions", {"tilt.force": 8.0}, size)
    frame = reactions.view.frame
    while len(reactions.balls) < count:
        if len(reactions.balls) == count // 2:
            tap(reactions, "ball.heavier")
        at = frame.x + frame.width * dice.random(), frame.y + frame.height * dice.random()
        reactions.update(Tap(Point(*at)))
    reactions.update(Tilt(40.0, 20.0))
    return reactions


@pytest.mark.parametrize("size", [PORTRAIT, LANDSCAPE])
def test_words_stay_where_they_stood_until_they_are_gone(size: Size) -> None:
    reactions, standing = crowd(size, count=12), {}
    seen = 0
    for _ in range(90):
        wait(reactions, 1)
        now = {id(mark.hit): mark.place for mark in reactions.marks if mark.place}
        assert len(now) <= impulses.LABELS
        assert all(standing.get(hit, place) == place for hit, place in now.items())
        seen += len(now.keys() - standing.keys())
        standing |= now
        kept = {id(mark.hit) for mark in reactions.marks}
        standing = {hit: place for hit, place in standing.items() if hit in kept}
    assert seen > 5


@pytest.mark.parametrize("size", [PORTRAIT, LANDSCAPE])
def test_words_cover_neither_each_other_nor_the_scale_bar_nor_the_balls_that_met(
    size: Size,
) -> None:
    reactions = crowd(size)
    known = set()
    for _ in range(90):
        wait(reactions, 1)
        view = reactions.view
        said = [mark for mark in reactions.marks if mark.place]
        for i, mark in enumerate(said):
            assert not mark.place.overlaps(bar_room(view.rect))
            assert not any(mark.place.overlaps(other.place) for other in said[:i])
            if id(mark.hit) not in known:
                for ball in reactions.balls:
                    assert not mark.place.inset(1.0).holds(view.to_screen(ball.position))
        known |= {id(mark.hit) for mark in reactions.marks}


def test_words_find_room_for_what_they_say() -> None:
    reactions = crowd(PORTRAIT)
    surface = Surface(720, 1280)
    checked = 0
    for _ in range(60):
        wait(reactions, 1)
        canvas = Canvas(surface, reactions.view.rect, reactions.room)
        for mark in reactions.marks:
            if mark.place:
                needed = canvas.pill_size(mark.words)
                assert needed.width <= mark.place.width
                assert needed.height <= mark.place.height + 1
                checked += 1
    assert checked


def test_words_go_when_the_screen_changes_its_shape() -> None:
    reactions = crowd(PORTRAIT)
    while not any(mark.place for mark in reactions.marks):
        wait(reactions, 1)
    reactions.update(Resize(LANDSCAPE))
    assert reactions.marks
    assert not any(mark.place for mark in reactions.marks)


def test_a_hit_is_remembered_as_long_as_it_is_shown() -> None:
    reactions = crowd(PORTRAIT, count=4)
    while not reactions.marks:
        wait(reactions, 1)
    hit = reactions.marks[0].hit
    reactions.update(Tilt(0.0, 0.0))
    while reactions.world.time - hit.time < hits.FADE:
        assert reactions.marks[0].hit is hit
        wait(reactions, 1)
    assert all(mark.hit is not hit for mark in reactions.marks)


@pytest.mark.parametrize(
    "way", [(60.0, 0.0), (-60.0, 0.0), (0.0, 60.0), (0.0, -60.0), (-40.0, 40.0)]
)
def test_the_head_of_an_arrow_is_in_sight_wherever_the_body_is(way: tuple[float, float]) -> None:
    inertia = lesson("inertia")
    canvas = Canvas(Surface(360, 640), inertia.view.rect, inertia.room)
    within = canvas.rect.inset(HEAD_ROOM - 1e-6)
    for x in (-2.5, -1.9, 0.0, 2.45):
        for y in (-2.7, 0.1, 2.75):
            inertia.body.position = Vector(x, y)
            start, part = leaving(canvas, inertia.body, way, 0.5)
            at = canvas.view.to_screen(start)
            assert within.holds(Point(at.x + part * way[0], at.y - part * way[1]))
            assert part >= 0.3


def test_an_arrow_beside_a_body_keeps_off_it_and_goes_to_the_middle_of_the_room() -> None:
    reactions = lesson("reactions")
    canvas = Canvas(Surface(360, 640), reactions.view.rect, reactions.room)
    start = beside(canvas, Vector(2.7, 1.0), (40.0, 0.0), 0.25)
    assert 0.25 < 1.0 - start.y < 0.5
    tip = canvas.view.to_screen(start).x + 40.0
    assert tip <= canvas.rect.right - HEAD_ROOM
    assert fitting(canvas, start, (40.0, 0.0)) == pytest.approx(1.0, abs=0.1)


def test_both_arrows_of_a_hit_without_room_lie_side_by_side_and_in_sight() -> None:
    """A ball close to the border bounces off an inner wall: neither arrow finds room ahead."""
    reactions = lesson("reactions")
    canvas = Canvas(Surface(360, 640), reactions.view.rect, reactions.room)
    top = reactions.room.top
    near = [beside(canvas, Vector(0.5, top - 0.4), (0.0, way), 0.25) for way in (60.0, -60.0)]
    far = beside(canvas, Vector(0.5, top - 0.4), (0.0, -60.0), 0.25 + LANE / canvas.view.scale)
    assert near[0].x == pytest.approx(near[1].x)
    assert near[0].x - far.x == pytest.approx(LANE / canvas.view.scale)
    within = canvas.rect.inset(HEAD_ROOM - 1e-6)
    for start, way in ((near[0], 60.0), (near[1], -60.0), (far, -60.0)):
        tail = canvas.view.to_screen(start)
        assert within.holds(tail)
        assert within.holds(Point(tail.x, tail.y - way))


def test_arrows_lie_over_other_balls_but_not_over_letters() -> None:
    """In a crowd the head of an arrow and the letter of a ball below it are both seen."""
    surface = Surface(360, 640)
    reactions = lesson("reactions")
    for at in (Point(120, 300), Point(180, 300), Point(232, 300)):
        reactions.update(Tap(at))
    first, second, third = reactions.balls
    first.velocity, second.velocity = (4.0, 0.0), (0.0, 0.0)
    while not reactions.marks:
        wait(reactions, 1)
    third.position = (second.x + 0.9, second.y)
    reactions.draw(surface)
    canvas = Canvas(surface, reactions.view.rect, reactions.room)
    middle = canvas.view.to_screen(third.position)
    rows, columns = slice(int(middle.y) - 12, int(middle.y) + 13), slice(0, int(middle.x) + 14)
    pixels = surface.pixels()[rows, int(middle.x) - 13 : columns.stop]
    red, blue = (pixels >> 16).astype(int), (pixels & 255).astype(int)
    assert ((red > 200) & (blue < 130)).any()  # orange on a ball
    letter = pixels[9:16, 10:17]
    assert ((letter >> 16) < 40).any()
