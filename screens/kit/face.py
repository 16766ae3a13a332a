"""One font at one size: lines of words as coverage masks.

Fonts place letters on whole pixels, which is uneven if they are small. So words are set several
times too large and made smaller.
"""

import re

import numpy as np

from screens.kit.cache import Cache
from screens.kit.raster import Coverage, Mask
from screens.kit.sdl import pygame

PARTS = re.compile("[0-9]|[^0-9]+")
"""What lines are put together from: figures, which Inter does not kern, and what is between."""
KEPT = 1 << 18
"""Bytes that the parts of one face may take."""
OVERHEAD = 300
"""Bytes that holding a part takes beyond its mask."""
WHITE = (255, 255, 255)


class Face:
    """A font whose em is `pixels` high, set `fine` times too large and made smaller."""

    def __init__(self, font: pygame.font.Font, pixels: int, fine: int) -> None:
        """`font` is that of `fine` times the size."""
        self.pixels = pixels
        """Height of the em (px)."""
        self.fine = fine
        """Words can be placed to such parts of a pixel."""
        self._font = font
        self._rise = -(-font.get_ascent() // fine)
        """How many rows of a mask are above the baseline."""
        self._above = self._rise * fine - font.get_ascent()
        self._widths: Cache[int] = Cache(KEPT)
        self._parts: Cache[Coverage] = Cache(KEPT)

    def width(self, words: str) -> float:
        """Width of a single line (px)."""
        return sum(map(self._width, PARTS.findall(words))) / self.fine

    def line(self, words: str) -> Mask:
        """The mask of a single line, seen from where its baseline begins.

        A number that changes costs little: the font sets only parts that are new.
        """
        parts = PARTS.findall(words)
        if len(parts) < 2:
            return Mask(self._part(words, 0), 0, -self._rise)
        placed, start, wide, high = [], 0, 0, 0
        for part in parts:
            left, right = divmod(start, self.fine)
            cover = self._part(part, right)
            placed.append((left, cover))
            high, wide = max(high, cover.shape[0]), max(wide, left + cover.shape[1])
            start += self._width(part)
        line = np.zeros((high, wide), np.uint8)
        for left, cover in placed:
            rows, columns = cover.shape
            room = line[:rows, left : left + columns]
            np.maximum(room, cover, out=room)
        return Mask(line, 0, -self._rise)

    def mask(self, words: str, right: int = 0, down: int = 0) -> Mask:
        """The same, but set as a whole and moved by such fine parts of a pixel."""
        return Mask(self._cover(words, right, down), 0, -self._rise)

    def _cover(self, words: str, right: int, down: int) -> Coverage:
        font, fine = self._font, self.fine
        if not words.strip():
            columns = max(1, font.size(words)[0] // fine)
            return np.zeros((-(-font.get_height() // fine), columns), np.uint8)
        large = font.render(words, True, WHITE)
        if fine == 1:
            return _opacity(large)
        above = self._above + down
        columns = -(-(right + large.get_width()) // fine)
        rows = -(-(above + large.get_height()) // fine)
        room = pygame.Surface((columns * fine, rows * fine), pygame.SRCALPHA, 32)
        room.blit(large, (right, above))
        return _opacity(pygame.transform.smoothscale(room, (columns, rows)))

    def _part(self, words: str, right: int) -> Coverage:
        """How much a part of a line covers, kept."""
        cover = self._parts.find((words, right))
        if cover is None:
            cover = self._cover(words, right, 0)
            self._parts.keep((words, right), cover, cover.size + OVERHEAD + 2 * len(words))
        return cover

    def _width(self, words: str) -> int:
        """Width of a part of a line (fine px)."""
        width = self._widths.find(words)
        if width is None:
            width = self._font.size(words)[0]
            self._widths.keep(words, width, OVERHEAD + 2 * len(words))
        return width


def _opacity(picture: pygame.Surface) -> Coverage:
    """The opacity of a picture as a mask."""
    return np.ascontiguousarray(pygame.surfarray.array_alpha(picture).T, np.uint8)
