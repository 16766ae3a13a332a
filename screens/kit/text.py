"""Words as coverage masks, set in the fonts that are shipped (Inter, with tabular figures)."""

from importlib import resources

import numpy as np

from screens.kit.numbers import THIN_SPACE
from screens.kit.raster import Coverage
from screens.kit.sdl import pygame
from screens.kit.theme import MEDIUM, REGULAR, SEMIBOLD, Style

FILES = {REGULAR: "Inter-Regular.ttf", MEDIUM: "Inter-Medium.ttf", SEMIBOLD: "Inter-SemiBold.ttf"}
ASCENT, DESCENT, CAP_HEIGHT = 0.96875, 0.2412109375, 0.7275390625
"""Of Inter, in em."""
FINE = 4
"""Floating letters are set this many times too large, to be placed to a quarter of a pixel."""
FINENESS = ((16, 4), (60, 2))
"""Lines up to an em of so many pixels are set so many times too large and made smaller.

Fonts place letters on whole pixels, which is uneven if they are small.
"""
LONGEST = 500
"""A line is cut after this many characters: a picture of it would be wider than any screen."""
ELLIPSIS = "\u2026"
WHITE = (255, 255, 255)


class Type:
    """The fonts at one scale (pixels per dp).

    Fonts come in whole pixels: a size between two is set in the smaller, so that words never need
    more room than at the reference scale.
    """

    def __init__(self, scale: float) -> None:
        """Open no font yet; each is opened when first used."""
        pygame.font.init()
        self.scale = scale
        self._fonts: dict[tuple[int, int], pygame.font.Font] = {}

    def pixels(self, style: Style) -> int:
        """Height of the em (px)."""
        return max(1, int(style.size * self.scale + 1e-6))

    def font(self, weight: int, pixels: int) -> pygame.font.Font:
        """The font of a weight whose em is `pixels` high."""
        font = self._fonts.get((weight, pixels))
        if font is None:
            file = resources.files("assets") / "fonts" / FILES[weight]
            with resources.as_file(file) as path:
                font = pygame.font.Font(str(path), pixels)
            self._fonts[weight, pixels] = font
        return font

    def width(self, words: str, style: Style) -> float:
        """Width of a single line (px)."""
        fine = self._fineness(style)
        return self.font(style.weight, fine * self.pixels(style)).size(words)[0] / fine

    def _fineness(self, style: Style) -> int:
        """How many times too large a line is set."""
        pixels = self.pixels(style)
        return next((fine for most, fine in FINENESS if pixels <= most), 1)

    def lines(
        self, words: str, style: Style, width: float | None = None, most: int | None = None
    ) -> list[str]:
        """`words` broken into lines of at most `width` px.

        A word that is too wide for a line is broken. Words that would need more than `most` lines
        end with an ellipsis.
        """
        words = words.upper() if style.capitals else words
        broken: list[str] = []
        for paragraph in words.split("\n"):
            plain = printable(paragraph)
            broken += self._wrap(plain, style, width) if width is not None else [plain[:LONGEST]]
        if most is not None and len(broken) > most:
            broken = broken[:most]
            last = broken[-1]
            while last and width is not None and self.width(last + ELLIPSIS, style) > width:
                last = last[:-1].rstrip()
            broken[-1] = last + ELLIPSIS
        return broken

    def _wrap(self, paragraph: str, style: Style, width: float) -> list[str]:
        lines: list[str] = []
        line = ""
        for word in paragraph.split(" "):
            longer = f"{line} {word}" if line else word
            if self.width(longer, style) <= width:
                line = longer
                continue
            if line:
                lines.append(line)
            while len(word) > 1 and self.width(word, style) > width:
                fitting = self._fitting(word, style, width)
                lines.append(word[:fitting])
                word = word[fitting:]
            line = word
        return [*lines, line]

    def _fitting(self, word: str, style: Style, width: float) -> int:
        """How many of a word's characters fit into `width` px, at least one."""
        low, high = 1, min(len(word), LONGEST)
        while low < high:
            middle = (low + high + 1) // 2
            if self.width(word[:middle], style) <= width:
                low = middle
            else:
                high = middle - 1
        return low

    def line(self, words: str, style: Style) -> Coverage:
        """The mask of one line; `line_rise` of its rows are above the baseline."""
        fine = self._fineness(style)
        return _shrunk(self.font(style.weight, fine * self.pixels(style)), words, fine)

    def line_rise(self, style: Style) -> int:
        """How many rows of the mask of a line are above the baseline."""
        fine = self._fineness(style)
        return _rise(self.font(style.weight, fine * self.pixels(style)), fine)

    def rise(self, style: Style) -> int:
        """How many rows of a floating mask are above the baseline."""
        return _rise(self.font(style.weight, FINE * self.pixels(style)), FINE)

    def fine_width(self, words: str, style: Style) -> float:
        """Width of a floating line (px), to a quarter."""
        return (
            self.font(style.weight, FINE * self.pixels(style)).size(printable(words)[:LONGEST])[0]
            / FINE
        )

    def floating(self, words: str, style: Style, right: int, down: int) -> Coverage:
        """The mask of a short line shifted by `right` and `down` quarters of a pixel."""
        font = self.font(style.weight, FINE * self.pixels(style))
        return _shrunk(font, printable(words)[:LONGEST], FINE, right, down)


def printable(words: str) -> str:
    """The words with a space for every character that has no picture."""
    return "".join(c if c.isprintable() or c == THIN_SPACE else " " for c in words)


def _rise(font: pygame.font.Font, fine: int) -> int:
    """Whole pixels above the baseline of words that are set `fine` times too large."""
    return -(-font.get_ascent() // fine)


def _shrunk(
    font: pygame.font.Font, words: str, fine: int, right: int = 0, down: int = 0
) -> Coverage:
    """The mask of words that are set `fine` times too large, moved by such fine pixels."""
    if fine == 1 or not words.strip():
        return _coverage(font, words, fine)
    large = font.render(words, True, WHITE)
    above = _rise(font, fine) * fine - font.get_ascent() + down
    columns = -(-(right + large.get_width()) // fine)
    rows = -(-(above + large.get_height()) // fine)
    room = pygame.Surface((columns * fine, rows * fine), pygame.SRCALPHA, 32)
    room.blit(large, (right, above))
    return _opacity(pygame.transform.smoothscale(room, (columns, rows)))


def _coverage(font: pygame.font.Font, words: str, fine: int) -> Coverage:
    """The mask of a line that is not made smaller, or of nothing but spaces."""
    if words.strip():
        return _opacity(font.render(words, True, WHITE))
    return np.zeros((-(-font.get_height() // fine), max(1, font.size(words)[0] // fine)), np.uint8)


def _opacity(picture: pygame.Surface) -> Coverage:
    """The opacity of a picture as a mask."""
    return np.ascontiguousarray(pygame.surfarray.array_alpha(picture).T, np.uint8)
