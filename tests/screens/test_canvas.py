"""Canvas: metres become dp, and labels keep off what is drawn."""

import math

import numpy as np
import pytest

from engine import Circle, Particle, Polygon, Wall, World
from screens.kit import arrows, theme
from screens.kit.canvas import Canvas, bar_room, letter_color
from screens.kit.geometry import Point, Rect
from screens.kit.surface import Surface
from screens.kit.view import Room

RECT = Rect(12, 120, 336, 336)
ROOM = Room(0, 0, 6, 6)
METRE = 56.0
"""(dp)"""


@pytest.fixture
def canvas() -> Canvas:
    return Canvas(Surface(360, 640), RECT, ROOM)


@pytest.fixture
def world() -> World:
    return World()


def blue(canvas: Canvas) -> np.ndarray:
    return canvas.surface.pixels() & 255


def at(canvas: Canvas, x: float, y: float) -> int:
    place = canvas.view.to_screen((x, y))
    return int(blue(canvas)[int(place.y), int(place.x)])


@pytest.mark.parametrize("shape", [Particle(0.5), Circle(0.5), Polygon.box(1, 1)])
def test_a_body_is_drawn_where_it_is(canvas, world, shape):
    body = world.add(shape, mass=1, position=(2, 4.5))
    canvas.body(body, theme.WHITE)
    rows, columns = np.nonzero(blue(canvas) > 127)
    assert columns.min() == pytest.approx(RECT.x + 1.5 * METRE, abs=1)
    assert columns.max() + 1 == pytest.approx(RECT.x + 2.5 * METRE, abs=1)
    assert rows.min() == pytest.approx(RECT.y + 1.0 * METRE, abs=1)
    assert rows.max() + 1 == pytest.approx(RECT.y + 2.0 * METRE, abs=1)


def test_a_pale_body_keeps_a_full_outline(canvas, world):
    canvas.body(world.add(Particle(0.5), mass=1, position=(3, 3)), theme.WHITE, opacity=0.3)
    assert at(canvas, 3, 3) == pytest.approx(77, abs=3)
    assert blue(canvas).max() == 255


def test_a_circle_that_spins_shows_it_and_a_particle_does_not(world):
    def picture(shape, angle):
        canvas = Canvas(Surface(360, 640), RECT, ROOM)
        body = world.add(shape, mass=1, position=(3, 3), angle=angle)
        canvas.body(body, theme.WHITE, opacity=0.4)
        return canvas

    up = picture(Circle(0.5), math.pi / 2)
    assert at(up, 3, 3.35) > at(up, 3.35, 3)
    still = picture(Particle(0.5), 0.0)
    assert at(still, 3, 3.35) == at(still, 3.35, 3)


def test_nothing_leaves_the_canvas(canvas, world):
    canvas.body(world.add(Circle(1), mass=1, position=(0, 0)), theme.WHITE)
    canvas.body(world.add(Polygon.box(2, 2), mass=1, position=(6, 6)), theme.WHITE)
    canvas.wall(Wall((-1, 3), (7, 3)))
    canvas.arrow((3, 3), (300, 300), arrows.FORCE)
    canvas.trail([(-0.01, 1), (6.01, 1)])
    rows, columns = np.nonzero(blue(canvas))
    assert columns.min() >= RECT.x
    assert columns.max() < RECT.right
    assert rows.min() >= RECT.y
    assert rows.max() < RECT.bottom


def test_arrows_point_up_when_the_vector_does(canvas):
    tip = canvas.arrow((3, 3), (30, 40), arrows.VELOCITY)
    start = canvas.view.to_screen((3, 3))
    assert tip == (start.x + 30, start.y - 40)


def test_the_outline_is_left_in_the_direction_asked(canvas, world):
    box = world.add(Polygon.box(2, 1), mass=1, position=(3, 3))
    assert canvas.edge(box, (1, 0)) == pytest.approx((4, 3))
    ball = world.add(Particle(0.5), mass=1, position=(1, 1))
    assert canvas.edge(ball, (0, -2)) == pytest.approx((1, 0.5))


def test_labels_keep_off_bodies_walls_arrows_and_each_other(canvas, world):
    drawn = []
    for i in range(12):
        body = world.add(Particle(0.27), mass=1, position=(0.6 + 0.9 * (i % 6), 2 + 2 * (i // 6)))
        canvas.body(body, theme.TEAL, letter="ABCDEFGHIJKL"[i])
        center = canvas.view.to_screen(body.position)
        drawn.append((center, 0.25 * METRE))
    canvas.wall(Wall((1, 5), (4, 5.5)))
    canvas.arrow((3, 3), (60, 25), arrows.FORCE)
    places = []
    for i in range(4):
        place = canvas.label(f"A ⇄ B {i}.13 N·s each", Point(170, 260 + 10 * i), theme.ORANGE)
        if place is not None:
            places.append(place)
    assert len(places) >= 2
    for i, place in enumerate(places):
        for center, radius in drawn:
            x = min(max(center.x, place.x), place.right)
            y = min(max(center.y, place.y), place.bottom)
            assert math.dist(center, (x, y)) >= 0.95 * radius
        assert not any(place.overlaps(other) for other in places[:i])


def test_a_label_without_room_is_not_drawn(canvas):
    canvas.labels.block(RECT)
    assert canvas.label("A", Point(150, 250), theme.ORANGE) is None
    assert not blue(canvas).any()


def test_grid_lines_are_whole_pixels_half_a_metre_apart():
    canvas = Canvas(Surface(720, 1280), RECT, ROOM)
    canvas.background(0.5, bar=False)
    row = blue(canvas)[int(2 * (RECT.y + 0.3 * METRE))]
    lines = np.flatnonzero(row == theme.GRID[2])
    assert np.diff(lines)[::2].tolist() == [1] * (len(lines) // 2)
    assert set(np.diff(lines[::2]).tolist()) == {int(METRE)}


def test_the_scale_bar_has_the_length_it_names():
    canvas = Canvas(Surface(360, 640), RECT, ROOM)
    canvas.scale_bar()
    row = blue(canvas)[int(RECT.bottom - 10) - 1]
    lit = np.flatnonzero(row)
    assert lit.max() - lit.min() + 1 == METRE
    assert bar_room(RECT).holds(Point(float(lit.min()), RECT.bottom - 11))


def relative_luminance(color):
    """As WCAG 2.2 defines it."""
    parts = [part / 255 for part in color]
    linear = [p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def test_letters_are_readable_on_every_body():
    """WCAG 2.2, 1.4.3: a contrast of at least 4.5 to 1."""
    for color in theme.BODY_COLORS:
        for percent in range(30, 96):
            ground = relative_luminance(theme.mix(color, percent / 100, theme.CANVAS))
            ink = relative_luminance(letter_color(color, percent / 100))
            lighter, darker = max(ground, ink), min(ground, ink)
            assert (lighter + 0.05) / (darker + 0.05) >= 4.5, (color, percent)
