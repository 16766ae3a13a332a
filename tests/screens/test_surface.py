"""Surface: shapes where they ought to be, words that are measured as they are drawn."""

import math
import subprocess
import sys

import numpy as np
import pytest
import truth
from hypothesis import given, settings
from hypothesis import strategies as st

from screens.kit import theme
from screens.kit.geometry import Point, Rect
from screens.kit.surface import Surface

WIDTH, HEIGHT = 360, 640
"""Scale 1: a dp is a pixel, so truths in pixels can be compared."""


def black() -> Surface:
    return Surface(WIDTH, HEIGHT)


def regular(sides: int, cx: float, cy: float, radius: float, turn: float):
    angles = [turn + 2 * math.pi * i / sides for i in range(sides)]
    return [(cx + radius * math.cos(a), cy + radius * math.sin(a)) for a in angles]


def ink(surface: Surface) -> tuple[float, float, float]:
    """Total brightness and its centre (px)."""
    blue = (surface.pixels() & 255).astype(float)
    total = blue.sum()
    rows, columns = np.indices(blue.shape)
    return total, ((columns + 0.5) * blue).sum() / total, ((rows + 0.5) * blue).sum() / total


class TestShapes:
    def test_circles_are_close_to_the_sampled_truth(self):
        errors = []
        for i in range(40):
            cx, cy = 60 + 0.37 * i, 50 + 0.23 * i
            radius = 8 + 0.71 * i
            surface = black()
            surface.circle((cx, cy), radius, theme.WHITE)
            part = surface.pixels()[:128, :128]
            errors.append(truth.edge_error(part, truth.disc(128, 128, cx, cy, radius)))
        assert np.mean(errors) <= 6
        assert max(errors) <= 9

    def test_polygons_are_close_to_the_sampled_truth(self):
        errors = []
        for i in range(40):
            corners = regular(3 + i % 5, 60 + 0.37 * i, 60 + 0.23 * i, 15 + 0.7 * i, 0.17 * i)
            surface = black()
            surface.polygon(corners, theme.WHITE)
            part = surface.pixels()[:128, :128]
            errors.append(truth.edge_error(part, truth.hull(128, 128, corners)))
        assert np.mean(errors) <= 8

    def test_corners_may_come_in_either_order(self):
        corners = regular(5, 60.3, 60.7, 30, 0.2)
        one, two = black(), black()
        one.polygon(corners, theme.TEAL, outline=theme.WHITE)
        two.polygon(corners[::-1], theme.TEAL, outline=theme.WHITE)
        assert np.abs((one.pixels() & 255).astype(int) - (two.pixels() & 255)).max() <= 1

    @pytest.mark.parametrize("shape", ["circle", "polygon", "arrow", "capsule", "letter"])
    def test_a_slow_body_moves_smoothly(self, shape):
        places = []
        for i in range(30):
            surface, x = black(), 100 + 0.1 * i
            if shape == "circle":
                surface.circle((x, 80), 15, theme.WHITE, 0.8, outline=theme.WHITE)
            elif shape == "polygon":
                surface.polygon(regular(5, x, 80, 20, 0.4), theme.WHITE)
            elif shape == "arrow":
                surface.arrow((x, 80), (x + 40, 95), theme.WHITE)
            elif shape == "capsule":
                surface.capsule((x, 80), (x + 30, 85), 4, theme.WHITE)
            else:
                surface.letter("A", (x, 80), theme.LETTER, theme.WHITE)
            places.append(ink(surface)[1])
        steps = np.diff(places)
        coarsest = 0.3 if shape == "letter" else 0.15
        assert (steps >= -0.02).all()
        assert steps.max() < coarsest
        assert places[-1] - places[0] == pytest.approx(2.9, abs=0.15)

    def test_the_outline_ends_where_the_body_ends(self):
        surface = black()
        surface.circle((100, 100), 20, None, outline=theme.WHITE, outline_width=3)
        row = surface.pixels()[100] & 255
        assert row[:79].max() == 0
        assert row[81:83].min() == 255
        assert row[85:115].max() == 0

    def test_a_line_thinner_than_a_pixel_is_paler(self):
        surface = black()
        surface.line((10, 50.5), (60, 50.5), 0.5, theme.WHITE)
        assert (surface.pixels()[50, 20] & 255) == pytest.approx(128, abs=3)

    def test_dashes_and_gaps_have_their_lengths(self):
        surface = black()
        surface.line((10, 50), (40, 50), 2, theme.WHITE, dash=(4, 6))
        lit = np.flatnonzero((surface.pixels()[50] & 255) > 128)
        assert lit.tolist() == [*range(10, 14), *range(20, 24), *range(30, 34)]

    def test_half_opaque_is_half_way(self):
        surface = black()
        surface.fill((100, 100, 100))
        surface.rect(Rect(10, 10, 20, 20), (200, 200, 200), alpha=0.5)
        assert (surface.pixels()[20, 20] & 255) == pytest.approx(150, abs=2)

    def test_a_sharp_rectangle_fills_its_pixels_alone(self):
        surface = black()
        surface.rect(Rect(10, 20, 5, 6), theme.WHITE)
        rows, columns = np.nonzero(surface.pixels())
        assert (rows.min(), rows.max(), columns.min(), columns.max()) == (20, 25, 10, 14)

    def test_a_hollow_head_is_hollow_and_a_solid_one_solid(self):
        solid, hollow = black(), black()
        solid.arrow((50, 50), (150, 50), theme.WHITE, width=8)
        hollow.arrow((50, 50), (150, 50), theme.WHITE, width=8, head="hollow")
        inside = (50, 133)
        assert (solid.pixels()[inside] & 255) == 255
        assert (hollow.pixels()[inside] & 255) == 0
        assert (hollow.pixels()[50, 90] & 255) == 255

    def test_short_arrows_shrink_and_arrows_without_length_are_not_drawn(self):
        surface = black()
        surface.arrow((50, 50), (50, 50), theme.WHITE)
        assert not surface.pixels().any()
        surface.arrow((50, 50), (56, 50), theme.WHITE)
        _, columns = np.nonzero((surface.pixels() & 255) > 20)
        assert columns.min() >= 48
        assert columns.max() <= 57


class TestOutside:
    @pytest.mark.parametrize("far", [1e3, 1e9, 1e300, math.inf, math.nan, -1e9])
    def test_what_is_far_away_is_not_drawn(self, far):
        surface = black()
        surface.circle((far, 50), 20, theme.WHITE, outline=theme.TEAL)
        surface.polygon([(far, 0), (far + 10, 0), (far, 10)], theme.WHITE, outline=theme.TEAL)
        surface.capsule((far, 0), (far, 10), 4, theme.WHITE)
        surface.arrow((far, 0), (far, 10), theme.WHITE)
        surface.letter("A", (far, 10), theme.LETTER, theme.WHITE)
        surface.text("A", (10, far), theme.LETTER, theme.WHITE, align="center")
        surface.rect(Rect(far, 0, 10, 10), theme.WHITE, radius=3)
        assert not surface.pixels().any()

    def test_a_circle_larger_than_the_picture_covers_it(self):
        surface = black()
        surface.circle((0, 0), 1e9, theme.WHITE)
        assert (surface.pixels() == 0xFFFFFF).all()

    def test_a_shape_across_the_border_is_the_same_as_inside(self):
        inside, across = black(), black()
        inside.circle((50, 50), 20, theme.WHITE)
        across.circle((0, 50), 20, theme.WHITE)
        assert (across.pixels()[:, :30] == inside.pixels()[:, 50:80]).all()

    def test_nothing_is_painted_outside_a_clip_or_the_clip_around_it(self):
        surface = black()
        with surface.clip(Rect(10, 10, 50, 50)), surface.clip(Rect(30, 30, 100, 100)):
            surface.fill(theme.WHITE)
        rows, columns = np.nonzero(surface.pixels())
        assert (rows.min(), rows.max(), columns.min(), columns.max()) == (30, 59, 30, 59)
        surface.fill(theme.WHITE)
        assert surface.pixels().all()

    @pytest.mark.parametrize("size", [(0, 10), (10, -1), (9000, 10)])
    def test_sizes_that_no_picture_has_are_refused(self, size):
        with pytest.raises(ValueError, match="sides of 1 to 8192 pixels"):
            Surface(*size)


class TestBadges:
    """Words on a rounded ground."""

    GROUND = (0x20, 0x20, 0x20), 0.92
    RECT = Rect(20, 30, 90, 22)

    def draw(self, alpha: float, words: str = "0.52 N", below: int = 200) -> np.ndarray:
        surface = black()
        surface.fill((below, below, below))
        surface.badge(words, self.RECT, theme.VECTOR, theme.ORANGE, self.GROUND, alpha)
        return surface.pixels().view(np.uint8).reshape(HEIGHT, WIDTH, 4).astype(int)

    def test_it_looks_like_words_over_a_rectangle(self):
        surface = black()
        surface.fill((200, 200, 200))
        surface.rect(self.RECT, *self.GROUND, radius=11)
        at, style = self.RECT.center, theme.VECTOR
        surface.text("0.52 N", at, style, theme.ORANGE, align="center", valign="middle")
        apart = surface.pixels().view(np.uint8).reshape(HEIGHT, WIDTH, 4).astype(int)
        assert np.abs(self.draw(1.0) - apart).max() <= 2

    def test_words_and_ground_fade_as_one(self):
        """Half of it shows half of what it is, and half of what is below."""
        expected = (self.draw(1.0) + 200.0) / 2
        assert np.abs(self.draw(0.5) - expected)[..., :3].max() <= 2
        assert (self.draw(0.0)[..., :3] == 200).all()

    def test_colours_do_not_mix_up(self):
        surface = black()
        for color in (theme.ORANGE, theme.TEAL, theme.ORANGE):
            surface.badge("N", self.RECT, theme.VECTOR, color, self.GROUND)
            red, blue = (int(surface.pixels().max() >> 16), int((surface.pixels() & 255).max()))
            assert (red > blue) == (color == theme.ORANGE)

    def test_words_that_are_too_long_stay_on_it(self):
        lit = (self.draw(1.0, "far too many words for such a label")[..., :3] != 200).any(axis=2)
        rows, columns = np.nonzero(lit)
        assert (columns.min(), columns.max()) == (20, 109)
        assert (rows.min(), rows.max()) == (30, 51)

    def test_without_room_there_is_none(self):
        surface = black()
        surface.badge("N", Rect(20, 30, 0, 22), theme.VECTOR, theme.ORANGE, self.GROUND)
        surface.badge("", self.RECT._replace(x=1e9), theme.VECTOR, theme.ORANGE, self.GROUND)
        assert not surface.pixels().any()


class TestPictures:
    def test_pixels_are_an_own_copy_of_red_green_and_blue(self):
        surface = black()
        surface.fill((0x12, 0x34, 0x56))
        pixels = surface.pixels()
        assert pixels.shape == (HEIGHT, WIDTH)
        assert pixels.dtype == np.uint32
        assert pixels.flags["C_CONTIGUOUS"]
        assert (pixels == 0x123456).all()
        surface.fill(theme.BLACK)
        assert (pixels == 0x123456).all()
        assert not surface.pixels().any()

    def test_pixels_stay_as_they_are_whatever_is_drawn_next(self):
        surface = black()
        drawings = (
            lambda: surface.circle((50, 50), 20, theme.TEAL),
            lambda: surface.arrow((50, 50), (90, 70), theme.TEAL),
            lambda: surface.text("Speed", (20, 30), theme.VALUE, theme.TEXT),
            lambda: surface.static("page", lambda layer: layer.fill(theme.CANVAS)),
            lambda: surface.scrim(0.5),
        )
        for draw in drawings:
            before = surface.pixels()
            kept = before.copy()
            draw()
            assert (before == kept).all()
            assert not (surface.pixels() == kept).all()
            assert not (surface.pixels() >> 24).any()

    def test_the_static_picture_is_painted_once(self):
        surface, calls = black(), []

        def paint(layer: Surface) -> None:
            calls.append(1)
            layer.fill(theme.CANVAS)
            layer.circle((50.3, 60.2), 20, theme.TEAL, 0.5)

        for _ in range(3):
            surface.circle((100, 100), 30, theme.ORANGE)
            surface.static("key", paint)
        direct = black()
        paint(direct)
        assert len(calls) == 2
        assert (surface.pixels() == direct.pixels()).all()
        surface.static("other", paint)
        assert len(calls) == 3

    def test_the_static_picture_comes_back_wherever_something_was_drawn(self):
        def paint(layer: Surface) -> None:
            layer.fill(theme.CANVAS)
            layer.text("Inertia", (16, 16), theme.TITLE, theme.TEXT)

        surface, direct = black(), black()
        paint(direct)
        for i in range(12):
            surface.static("key", paint)
            assert (surface.pixels() == direct.pixels()).all()
            for k in range(i * 12):
                surface.circle((7.3 * i, 5.1 * k), 10, theme.TEAL, 0.5)
            surface.text("Speed", (100, 20 + 13 * i), theme.LABEL, theme.TEXT)
            surface.arrow((100, 100), (200 + i, 300), theme.YELLOW)
            with surface.clip(Rect(50, 50, 100, 100)):
                surface.rect(Rect(0, 0, 360, 70), theme.ORANGE, alpha=0.5)
                if i % 4 == 0:
                    surface.static("key", paint)
            if i % 3 == 0:
                surface.scrim(0.5)
            if i % 5 == 0:
                surface.fill(theme.PURPLE)

    def test_a_scrim_darkens_everything_alike(self):
        surface = black()
        surface.fill((100, 200, 50))
        surface.scrim(0.5)
        pixels = surface.pixels()
        assert (pixels == pixels[0, 0]).all()
        assert (pixels[0, 0] >> 8 & 255) == pytest.approx(100, abs=2)

    def test_what_was_drawn_before_leaves_no_trace(self):
        """A picture does not depend on what the caches hold."""

        def scene(surface: Surface) -> bytes:
            surface.fill(theme.SURFACE)
            for i in range(30):
                surface.circle((50.37 * (i % 6), 40.21 * i), 15, theme.TEAL, i / 30)
                surface.text(f"{i} m/s", (20, 20 * i), theme.VALUE, theme.TEXT)
            surface.arrow((20, 20), (200.5, 300.25), theme.YELLOW, head="hollow")
            return surface.pixels().tobytes()

        fresh = scene(black())
        used = black()
        for i in range(400):
            used.circle((i / 7, i / 3), 15, theme.PURPLE, i / 400)
        assert scene(used) == fresh
        assert scene(used) == fresh

    def test_drawing_needs_no_home_no_display_and_prints_nothing(self):
        program = (
            "from screens.kit.surface import Surface; from screens.kit import theme;"
            "import sys; s = Surface(72, 128); s.text('A', (9, 9), theme.TITLE, theme.TEXT);"
            "pg = sys.modules['pygame']; assert s.pixels().any();"
            "assert not pg.get_init() and not pg.display.get_init() and not pg.mixer.get_init()"
        )
        done = subprocess.run(
            [sys.executable, "-c", program], capture_output=True, text=True, env={}, check=False
        )
        assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


class TestWords:
    @pytest.mark.parametrize("size", [(360, 640), (720, 1280), (500, 900), (1280, 720)])
    def test_words_are_drawn_inside_the_room_they_are_said_to_take(self, size):
        surface = Surface(*size)
        for align in ("left", "center", "right"):
            surface.fill(theme.BLACK)
            room = surface.text("Ågjp (fly)", (120, 60), theme.TITLE, theme.WHITE, align=align)
            assert room.width == pytest.approx(surface.measure("Ågjp (fly)", theme.TITLE).width)
            rows, columns = np.nonzero(surface.pixels())
            scale = surface.scale
            assert columns.min() >= room.x * scale - 2
            assert columns.max() <= room.right * scale + 2
            assert rows.min() >= room.y * scale - 1
            assert rows.max() <= room.bottom * scale + 1

    def test_capitals_stand_in_the_middle(self):
        surface = Surface(720, 1280)
        surface.text("H", (100, 50), theme.BUTTON_TEXT, theme.WHITE, valign="middle")
        rows, _ = np.nonzero((surface.pixels() & 255) > 100)
        assert (rows.min() + rows.max() + 1) / 2 == pytest.approx(100, abs=1)

    def test_letters_are_centred_both_ways(self):
        surface = Surface(720, 1280)
        surface.letter("H", (100.3, 50.2), theme.LETTER, theme.WHITE)
        _, x, y = ink(surface)
        assert x == pytest.approx(200.6, abs=0.5)
        assert y == pytest.approx(100.4, abs=0.6)

    @settings(max_examples=60, deadline=None)
    @given(
        st.text(alphabet="abcdefg WXYZ é,.−½\n", max_size=80),
        st.floats(min_value=40, max_value=200),
    )
    def test_wrapped_lines_fit_and_keep_all_words(self, words, width):
        surface = black()
        lines = surface.type.lines(words, theme.EXPLANATION, width)
        assert "".join("".join(lines).split()) == "".join(words.split())
        assert all(surface.type.width(line, theme.EXPLANATION) <= width for line in lines)
        size = surface.measure(words, theme.EXPLANATION, width=width)
        assert size.width <= width
        assert size.height == len(lines) * theme.EXPLANATION.line_height

    def test_too_many_lines_end_with_an_ellipsis(self):
        surface = black()
        lines = surface.type.lines("one two three four five six", theme.LAW, 60, 2)
        assert len(lines) == 2
        assert lines[-1].endswith("…")
        assert surface.type.width(lines[-1], theme.LAW) <= 60

    def test_labels_are_capitals(self):
        surface = black()
        assert surface.type.lines("Speed", theme.LABEL) == ["SPEED"]

    @pytest.mark.parametrize("words", ["", " ", "\n", "\x00", "\t", "a\nb", "x" * 5000])
    def test_odd_words_are_drawn_without_complaint(self, words):
        surface = black()
        surface.text(words, (10, 10), theme.LAW, theme.TEXT)
        surface.text(words, (10, 10), theme.LAW, theme.TEXT, width=100, lines=3)
        surface.letter(words.strip()[:3], Point(10, 10), theme.LETTER, theme.TEXT)

    def test_words_scale_with_the_picture(self):
        one = Surface(360, 640).measure("A body keeps its velocity", theme.LAW)
        six = Surface(2160, 3840).measure("A body keeps its velocity", theme.LAW)
        assert one.height == six.height
        assert one.width == pytest.approx(six.width, rel=0.08)
