"""The pixels below a surface: masks become sprites of a colour, sprites are stamped.

Both are kept, within bounds, and used again; of what fades only the masks.
"""

from collections.abc import Callable, Hashable, Iterator
from contextlib import contextmanager
from typing import Final

import numpy as np
from numpy.typing import NDArray

from screens.kit import theme
from screens.kit.cache import Cache
from screens.kit.discs import Coat, Discs
from screens.kit.raster import Box, Coverage, Look, Mask, Shape, bounding_box, cover
from screens.kit.sdl import pygame
from screens.kit.theme import Color

LARGEST = 8192
"""Of a picture's sides (px)."""
SPRITES = 8 << 20
"""Bytes that drawn shapes and words may take."""
MASKS = 2 << 20
"""Bytes that coverage masks may take."""
OVERHEAD = 500
"""Bytes that holding a value takes beyond its pixels."""
LAYOUT: Final = "RGBX"
SPRITE: Final = "RGBA"
"""Order of bytes of pictures and sprites, as pygame is told. What it takes for red is our blue:
only so it paints on memory that is not its own."""
STRIP = 64
"""Height of the sprite that darkens a picture, strip by strip (px)."""


class Picture:
    """A picture of `width` x `height` pixels without transparency, black at first."""

    def __init__(self, width: int, height: int, like: "Picture | None" = None) -> None:
        """Make a picture; it shares masks and sprites with `like`.

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
        self._clip = Box(0, 0, width, height)
        """What may be painted."""
        self._begin(np.zeros((height, width), np.uint32))

    def pixels(self) -> NDArray[np.uint32]:
        """The picture as it is now, shape (height, width), each 0x00RRGGBB, C-contiguous.

        Whoever gets the array owns it: what is painted later is painted on another one.
        """
        if not CLEAR:
            np.bitwise_and(self._pixels, np.uint32(0xFFFFFF), out=self._pixels)
        self._is_given = True
        return self._pixels

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
        self._surface.set_clip((box.left, box.top, *box.extent))

    def _begin(self, pixels: NDArray[np.uint32]) -> None:
        """Go on painting on these pixels."""
        self._pixels = pixels
        self._surface = pygame.image.frombuffer(pixels.data, (self.width, self.height), LAYOUT)
        self._is_given = False
        self._set_clip(self._clip)

    def _ready(self) -> pygame.Surface:
        """What to paint on: never what somebody else owns by now."""
        if self._is_given:
            self._begin(self._pixels.copy())
        return self._surface

    def fill(self, color: Color, box: Box | None = None) -> None:
        """Paint a rectangle, or all that may be painted."""
        inner = box.meet(self._clip) if box is not None else self._clip
        if inner.area:
            red, green, blue = color
            self._ready().fill((blue, green, red), (inner.left, inner.top, *inner.extent))

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
            coverage = cover(shape, look, seen.moved(-column, -row))
            self._ready().blit(_sprite(coverage, color, _level(alpha)), (seen.left, seen.top))
            return
        mask = Mask(cover(shape, look, box), box.left, box.top)
        self.stamp(key, color, alpha, column, row, lambda: mask)

    def disc(self, x: float, y: float, radius: float, coat: Coat) -> None:
        """Paint a disc given in pixels, whose radius is at most `discs.LARGEST`."""
        columns, rows = self._discs.axis(x, radius), self._discs.axis(y, radius)
        seen = Box(columns.first, rows.first, columns.end, rows.end).meet(self._clip)
        if seen.area:
            sprite = self._discs.sprite(columns, rows, radius, coat)
            self._ready().blit(_picture(sprite), (columns.first, rows.first))

    def stamp(
        self,
        key: Hashable,
        color: Color,
        alpha: float,
        column: int,
        row: int,
        make: Callable[[], Mask],
    ) -> None:
        """Paint a mask in a colour, as seen from a pixel; it is made if none is held as `key`."""
        if alpha > 0 and not self._restamp(key, color, alpha, column, row):
            mask = make()
            self._masks.keep(key, mask, mask.coverage.size + OVERHEAD)
            self._blit(mask, key, color, alpha, column, row)

    def _restamp(self, key: Hashable, color: Color, alpha: float, column: int, row: int) -> bool:
        """Paint what was stamped by this key before, if it is still held."""
        held = self._sprites.find((key, color)) if alpha >= 1 else None
        if held is not None:
            sprite, left, top = held
            self._ready().blit(sprite, (column + left, row + top))
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
        coverage, left, top = mask
        sprite = _sprite(coverage, color, _level(alpha))
        if alpha >= 1:
            size = 4 * coverage.size + OVERHEAD
            self._sprites.keep((key, color), (sprite, left, top), size)
        self._ready().blit(sprite, (column + left, row + top))

    def show(self, layer: "Picture") -> None:
        """Show a finished layer of the same size."""
        if self._clip.extent == (self.width, self.height):
            self._begin(layer._pixels.copy())
        elif self._clip.area:
            left, top, right, bottom = self._clip
            self._ready()
            self._pixels[top:bottom, left:right] = layer._pixels[top:bottom, left:right]


def _level(alpha: float) -> int:
    """Opacity in 0..256."""
    return round(min(max(alpha, 0.0), 1.0) * 256)


def _sprite(coverage: Coverage, color: Color, level: int) -> pygame.Surface:
    """A picture of one colour whose opacity is the coverage, times `level` / 256."""
    pixels = coverage.astype(np.uint32)
    if level < 256:
        pixels *= np.uint32(level)
        pixels += np.uint32(128)
        pixels >>= np.uint32(8)
    pixels <<= np.uint32(24)
    pixels |= np.uint32(color[0] << 16 | color[1] << 8 | color[2])
    return _picture(pixels)


def _picture(pixels: NDArray[np.uint32]) -> pygame.Surface:
    """Pixels (0xAARRGGBB) as something to blit."""
    height, width = pixels.shape
    return pygame.image.frombuffer(pixels.data, (width, height), SPRITE)


def _is_clear() -> bool:
    """Whether blits keep the unused byte of pixels at zero; not all processors need do so."""
    opacities = np.arange(256, dtype=np.uint32)[None, :] << np.uint32(24)
    pixels = np.zeros_like(opacities)
    picture = pygame.image.frombuffer(pixels.data, (256, 1), LAYOUT)
    picture.blit(_picture(opacities), (0, 0))
    return not pixels.any()


CLEAR = _is_clear()
"""Otherwise it is cleared when a picture is done."""
