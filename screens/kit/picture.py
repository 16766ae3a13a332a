"""The pixels below a surface: masks become sprites of a colour, sprites are stamped.

Both are kept, within bounds, and used again; of what fades only the masks.
"""

from collections.abc import Callable, Hashable, Iterator
from contextlib import contextmanager
from typing import Final

import numpy as np
from numpy.typing import NDArray

from screens.kit import sheets, theme
from screens.kit.cache import Cache
from screens.kit.discs import Coat, Discs
from screens.kit.raster import Box, Look, Mask, Shape, bounding_box, cover
from screens.kit.sdl import pygame
from screens.kit.sheets import NewPixels, Page, Pixels, Sheet, Sheets
from screens.kit.theme import Color

LARGEST = 8192
"""Of a picture's sides (px)."""
SPRITES = 8 << 20
"""Bytes that drawn shapes and words may take."""
MASKS = 2 << 20
"""Bytes that coverage masks may take."""
PATCHES = 4 << 20
"""Bytes that pieces of pictures may take which lie on a page."""
OVERHEAD = 500
"""Bytes that holding a value takes beyond its pixels."""
SPRITE: Final = "RGBA"
"""Order of bytes of sprites, as pygame is told; see `sheets.LAYOUT`."""
STRIP = 64
"""Height of the sprite that darkens a picture, strip by strip (px)."""


class Picture:
    """A picture of `width` x `height` pixels without transparency, black at first."""

    def __init__(
        self, width: int, height: int, new_pixels: NewPixels, like: "Picture | None" = None
    ) -> None:
        """Make a picture on memory from `new_pixels`; it shares masks and sprites with `like`.

        Raises:
            ValueError: for sides that are not 1..8192 pixels.
        """
        if not (1 <= width <= LARGEST and 1 <= height <= LARGEST):
            raise ValueError(
                f"a picture must have sides of 1 to {LARGEST} pixels, not {width} x {height}"
            )
        self.width = width
        self.height = height
        self._masks: Cache[Mask] = like._masks if like else Cache(MASKS)
        self._sprites: Cache[tuple[pygame.Surface, int, int]]
        self._sprites = like._sprites if like else Cache(SPRITES)
        self._discs: Discs = like._discs if like else Discs()
        self._patches: Cache[Pixels] = Cache(PATCHES)
        self._clip = Box(0, 0, width, height)
        """What may be painted."""
        self._sheets = Sheets(height, width, new_pixels)
        self._lent: Pixels | None = None
        """What was handed out of the sheet in hand."""
        self._page: Page | None = None
        self._begin(self._sheets.blank())

    def pixels(self) -> Pixels:
        """The picture as it is now, read-only.

        As long as anybody holds the array, nothing is painted on it any more.
        """
        if self._lent is None:
            if not CLEAR:
                pixels = self._sheet.pixels
                np.bitwise_and(pixels, np.uint32(0xFFFFFF), out=pixels)
            self._lent = self._sheets.lend(self._sheet)
        return self._lent

    @contextmanager
    def clip(self, box: Box) -> Iterator[None]:
        """Paint only inside `box`, and inside the clip around it."""
        before = self._clip
        self._set_clip(box.meet(before))
        try:
            yield
        finally:
            self._set_clip(before)

    def _set_clip(self, box: Box) -> None:
        self._clip = box
        self._sheet.surface.set_clip((box.left, box.top, *box.extent))

    def _begin(self, sheet: Sheet) -> None:
        """Go on painting on this sheet."""
        self._sheet = sheet
        self._lent = self._page = None
        self._set_clip(self._clip)

    def _ready(self) -> Sheet:
        """What to paint on: never what somebody else may hold by now."""
        if self._lent is not None:
            self._begin(self._sheets.copy(self._sheet))
        return self._sheet

    def fill(self, color: Color, box: Box | None = None) -> None:
        """Paint a rectangle, or all that may be painted."""
        inner = box.meet(self._clip) if box is not None else self._clip
        if inner.area:
            self._ready().fill(color, (inner.left, inner.top, *inner.extent))

    def darken(self, alpha: float) -> None:
        """Lay black of this opacity over everything."""
        strip = Mask(np.full((STRIP, self.width), 255, np.uint8))
        for top in range(0, self.height, STRIP):
            self.stamp(("scrim", self.width), theme.BLACK, alpha, 0, top, lambda: strip)

    def paint(
        self, shape: Shape, look: Look, color: Color, alpha: float, column: int = 0, row: int = 0
    ) -> None:
        """Paint a shape given in pixels, as seen from a pixel of the picture.

        One that lies outside costs nothing; one that was painted before costs little.
        """
        key = (type(shape), shape, look)
        if alpha <= 0 or self._restamp(key, color, alpha, column, row):
            return
        box = bounding_box(shape)
        if box is None:
            return
        seen = box.moved(column, row).meet(self._clip)
        if not seen.area:
            return
        if box.area > self.width * self.height:
            mask = Mask(cover(shape, look, seen.moved(-column, -row)))
            self._ready().stamp(_sprite(mask, color, _level(alpha)), seen.left, seen.top)
            return
        mask = Mask(cover(shape, look, box), box.left, box.top)
        self.stamp(key, color, alpha, column, row, lambda: mask)

    def disc(self, x: float, y: float, radius: float, coat: Coat) -> None:
        """Paint a disc given in pixels, whose radius is at most `discs.LARGEST`."""
        columns, rows = self._discs.axis(x, radius), self._discs.axis(y, radius)
        left, top, right, bottom = self._clip
        is_seen = columns.first < right and columns.end > left
        if is_seen and rows.first < bottom and rows.end > top:
            sprite = self._discs.sprite(columns, rows, radius, coat)
            self._ready().stamp(_picture(sprite), columns.first, rows.first)

    def stamp(
        self,
        key: Hashable,
        color: Color,
        alpha: float,
        column: int,
        row: int,
        make: Callable[[], Mask],
    ) -> None:
        """Paint a mask in a colour, as seen from a pixel; it is made if none is held as `key`.

        A mask that has colours of its own is painted in these.
        """
        if alpha > 0 and not self._restamp(key, color, alpha, column, row):
            mask = make()
            self._masks.keep(key, mask, mask.size + OVERHEAD)
            self._blit(mask, key, color, alpha, column, row)

    def _restamp(self, key: Hashable, color: Color, alpha: float, column: int, row: int) -> bool:
        """Paint what was stamped by this key before, if it is still held."""
        held = self._sprites.find((key, color)) if alpha >= 1 else None
        if held is not None:
            sprite, left, top = held
            self._ready().stamp(sprite, column + left, row + top)
            return True
        mask = self._masks.find(key)
        if mask is None:
            return False
        self._blit(mask, key, color, alpha, column, row)
        return True

    def _blit(
        self, mask: Mask, key: Hashable, color: Color, alpha: float, column: int, row: int
    ) -> None:
        """Paint a mask in a colour; sprites that fade are not worth to be kept."""
        sprite = _sprite(mask, color, _level(alpha))
        if alpha >= 1:
            size = 4 * mask.coverage.size + OVERHEAD
            self._sprites.keep((key, color), (sprite, mask.left, mask.top), size)
        self._ready().stamp(sprite, column + mask.left, row + mask.top)

    def page(self) -> Page:
        """The picture as it is now, to be shown by others of the same size."""
        if self._page is None:
            self._page = Page(self.pixels())
        return self._page

    def show(self, page: Page) -> None:
        """Show a page, all of it that may be painted."""
        if self._clip.extent == (self.width, self.height):
            self._begin(self._next(page))
        elif self._clip.area:
            left, top, right, bottom = self._clip
            sheet = self._ready()
            sheet.pixels[top:bottom, left:right] = page.pixels[top:bottom, left:right]
            sheet.painted.append(pygame.Rect(left, top, *self._clip.extent))

    def patch(self, key: Hashable, box: Box, paint: Callable[[], None]) -> None:
        """Paint inside `box` what looks the same whenever it lies on the same page.

        `paint` is called once for each page and `key`, and whenever something else lies below it.
        """
        box = box.meet(Box(0, 0, self.width, self.height))
        sheet, (left, top, right, bottom) = self._ready(), box
        if self._clip.meet(box) != box or not sheet.shows_page((left, top, *box.extent)):
            with self.clip(box):
                paint()
            return
        place = slice(top, bottom), slice(left, right)
        patch = self._patches.find((sheet.token, key))
        if patch is not None:
            sheet.pixels[place] = patch
            sheet.painted.append(pygame.Rect(left, top, *box.extent))
            return
        with self.clip(box):
            paint()
        patch = sheet.pixels[place].copy()
        self._patches.keep((sheet.token, key), patch, patch.nbytes + OVERHEAD)

    def _next(self, page: Page) -> Sheet:
        """A sheet that looks like a page: the one in hand, unless somebody may hold it."""
        if self._lent is not None:
            self._lent = None  # which gives the sheet back, if nobody else holds it
            return self._sheets.laid(page)
        self._sheet.lay(page)
        return self._sheet


def _level(alpha: float) -> int:
    """Opacity in 0..256."""
    return round(min(max(alpha, 0.0), 1.0) * 256)


def _sprite(mask: Mask, color: Color, level: int) -> pygame.Surface:
    """One colour, or those of the mask, with its coverage x `level` / 256 as opacity."""
    pixels = mask.coverage * np.uint32(level << 16)
    if level < 256:
        pixels += np.uint32(128 << 16)
        pixels &= np.uint32(0xFF000000)
    one = np.uint32(color[0] << 16 | color[1] << 8 | color[2])
    pixels |= one if mask.inks is None else mask.inks
    return _picture(pixels)


def _picture(pixels: NDArray[np.uint32]) -> pygame.Surface:
    """Pixels (0xAARRGGBB) as something to blit."""
    height, width = pixels.shape
    return pygame.image.frombuffer(pixels.data, (width, height), SPRITE)


def _is_clear() -> bool:
    """Whether blits keep the unused byte of pixels at zero; not all processors need do so."""
    opacities = np.arange(256, dtype=np.uint32)[None, :] << np.uint32(24)
    pixels = np.zeros_like(opacities)
    picture = pygame.image.frombuffer(pixels.data, (256, 1), sheets.LAYOUT)
    picture.blit(_picture(opacities), (0, 0))
    return not pixels.any()


CLEAR = _is_clear()
"""Otherwise it is cleared when a picture is done."""
