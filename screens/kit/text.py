"""Words in the fonts that are shipped (Inter, with tabular figures), broken into lines."""

from importlib import resources

from screens.kit.face import Face
from screens.kit.numbers import THIN_SPACE
from screens.kit.sdl import pygame
from screens.kit.theme import MEDIUM, REGULAR, SEMIBOLD, Style

FILES = {REGULAR: "Inter-Regular.ttf", MEDIUM: "Inter-Medium.ttf", SEMIBOLD: "Inter-SemiBold.ttf"}
ASCENT, DESCENT, CAP_HEIGHT = 0.96875, 0.2412109375, 0.7275390625
"""Of Inter, in em."""
FINE = 4
"""Floating letters are placed to a quarter of a pixel."""
FINENESS = ((16, 4), (60, 2))
"""Lines up to an em of so many pixels are set so many times too large and made smaller."""
LONGEST = 500
"""A line is cut after this many characters: a picture of it would be wider than any screen."""
ELLIPSIS = "\u2026"


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
        self._faces: dict[tuple[Style, int], Face] = {}

    def font(self, weight: int, pixels: int) -> pygame.font.Font:
        """The font of a weight whose em is `pixels` high."""
        font = self._fonts.get((weight, pixels))
        if font is None:
            file = resources.files("assets") / "fonts" / FILES[weight]
            with resources.as_file(file) as path:
                font = pygame.font.Font(str(path), pixels)
            self._fonts[weight, pixels] = font
        return font

    def face(self, style: Style, fine: int = 0) -> Face:
        """What words of a style are set with; `fine` times too large, if it is given."""
        face = self._faces.get((style, fine))
        if face is None:
            pixels = max(1, int(style.size * self.scale + 1e-6))
            times = fine or next((times for most, times in FINENESS if pixels <= most), 1)
            face = Face(self.font(style.weight, times * pixels), pixels, times)
            self._faces[style, fine] = face
        return face

    def width(self, words: str, style: Style) -> float:
        """Width of a single line (px)."""
        return self.face(style).width(words)

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


def printable(words: str) -> str:
    """The words with a space for every character that has no picture."""
    if words.replace(THIN_SPACE, "").isprintable():
        return words
    return "".join(c if c.isprintable() or c == THIN_SPACE else " " for c in words)
