"""The memory that pictures are painted on, used again when nobody holds what was painted.

A frame of a film is, but for a few shapes, the page below it. A sheet remembers which page it began
with and where it was painted on since, so that only there the page is laid anew.
"""

from collections import deque
from collections.abc import Callable
from typing import Final

import numpy as np
from numpy.typing import NDArray

from screens.kit.sdl import pygame
from screens.kit.theme import Color

Pixels = NDArray[np.uint32]
"""Shape (height, width), each 0x00RRGGBB, C-contiguous."""

NewPixels = Callable[[tuple[int, int]], Pixels]
"""Gives pixels of a shape with anything in them, in memory that others may see."""

LAYOUT: Final = "RGBX"
"""Order of bytes, as pygame is told. What it takes for red is our blue: only so it paints on memory
that is not its own."""
IDLE = 32 << 20
"""Bytes of sheets that wait to be used again."""
PIECES = 400
"""A sheet that was painted on in more places than this is laid with the whole page."""


def private_pixels(shape: tuple[int, int]) -> Pixels:
    """Pixels with anything in them, in memory of our own."""
    return np.empty(shape, np.uint32)


class Page:
    """What many frames begin with; it never changes."""

    def __init__(self, pixels: Pixels) -> None:
        """Nobody writes on these pixels any more."""
        self.pixels = pixels
        self.token = object()
        """Tells pages apart, and does not keep them alive."""


class Sheet:
    """Pixels to paint on, and where they were painted on since they were laid with a page."""

    def __init__(self, pixels: Pixels) -> None:
        """Paint on these pixels."""
        self.pixels = pixels
        self.token: object = None
        """Of the page that it was laid with."""
        self.painted: list[pygame.Rect] = []
        height, width = pixels.shape
        self.surface = pygame.image.frombuffer(pixels.data, (width, height), LAYOUT)
        """The same pixels, as what pygame paints on."""

    def stamp(self, sprite: pygame.Surface, left: int, top: int) -> None:
        """Paint a sprite, where the clip allows."""
        self.painted.append(self.surface.blit(sprite, (left, top)))

    def fill(self, color: Color, place: tuple[int, int, int, int]) -> None:
        """Paint a rectangle (left, top, width, height), where the clip allows."""
        red, green, blue = color
        self.painted.append(self.surface.fill((blue, green, red), place))

    def shows_page(self, place: tuple[int, int, int, int]) -> bool:
        """Whether nothing was painted in a rectangle (left, top, width, height) over the page."""
        if self.token is None or len(self.painted) > PIECES:
            return False
        return pygame.Rect(place).collidelist(self.painted) < 0

    def lay(self, page: Page) -> None:
        """Make it look like a page."""
        pixels, below = self.pixels, page.pixels
        if self.token is page.token and len(self.painted) <= PIECES:
            last = pygame.Rect(0, 0, 0, 0)
            for place in self.painted:
                if not last.contains(place):
                    left, top, width, height = last = place
                    right, bottom = left + width, top + height
                    pixels[top:bottom, left:right] = below[top:bottom, left:right]
        else:
            np.copyto(pixels, below)
            self.token = page.token
        self.painted = []


class _Loan:
    """What keeps a sheet out of use: an array that is made of it, as long as anybody holds it."""

    def __init__(self, sheet: Sheet, idle: deque[Sheet]) -> None:
        interface = dict(sheet.pixels.__array_interface__)
        interface["data"] = (interface["data"][0], True)  # to be read only
        self.__array_interface__ = interface
        self._sheet = sheet
        self._idle = idle

    def __del__(self) -> None:
        self._idle.append(self._sheet)


class Sheets:
    """All sheets of one picture."""

    def __init__(self, height: int, width: int, new_pixels: NewPixels = private_pixels) -> None:
        """None yet; all will be of this shape (px)."""
        self.shape = (height, width)
        self._new_pixels = new_pixels
        # Whoever is the last to hold a frame gives its sheet back, in any thread.
        self._idle: deque[Sheet] = deque(maxlen=IDLE // (4 * height * width))

    def lend(self, sheet: Sheet) -> Pixels:
        """The pixels of a sheet, to be read; it is not painted on while they are held."""
        return np.asarray(_Loan(sheet, self._idle))

    def blank(self) -> Sheet:
        """A black sheet."""
        sheet = Sheet(self._new_pixels(self.shape))
        sheet.pixels[:] = 0
        return sheet

    def copy(self, like: Sheet) -> Sheet:
        """A sheet that looks like another, of which it is not known what is painted on it."""
        sheet = Sheet(self._new_pixels(self.shape))
        np.copyto(sheet.pixels, like.pixels)
        return sheet

    def laid(self, page: Page) -> Sheet:
        """A sheet that looks like a page, one that did before if there is any."""
        try:
            sheet = self._idle.pop()
        except IndexError:
            sheet = Sheet(self._new_pixels(self.shape))
        sheet.lay(page)
        return sheet
