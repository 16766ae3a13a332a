"""The pixels below a surface: masks become sprites of a colour, sprites are stamped.

Masks, sprites and static layers are kept, within bounds, and used again.
"""

import math
from collections.abc import Hashable, Iterator
from contextlib import contextmanager
from typing import Final

import numpy as np
from numpy.typing import NDArray

from screens.kit.cache import Cache
from screens.kit.discs import Coat, Discs
from screens.kit.raster import Box, Coverage, Look, Shape, bounding_box, cover
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
        self._masks: Cache[Coverage] = like._masks if like else Cache(MASKS)
        self._sprites: Cache[pygame.Surface] = like._sprites if like else Cache(SPRITES)
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
        strip = np.full((STRIP, self.width), 255, np.uint8)
        for top in range(0, self.height, STRIP):
            if not self.restamp("scrim", (0, 0, 0), alpha, 0, top):
                self.stamp("scrim", strip, (0, 0, 0), alpha, 0, top)

    def paint(
        self, shape: Shape, look: Look, color: Color, alpha: float, fleeting: bool = False
    ) -> None:
        """Paint a shape given in pixels; one that lies outside costs nothing.

        Of a `fleeting` one, whose opacity changes from frame to frame, only the mask is kept.
        """
        box = bounding_box(shape)
        if box is None or alpha <= 0:
            return
        seen = box.meet(self._clip)
        if not seen.area:
            return
        if box.area > self.width * self.height:
            sprite = _sprite(cover(shape, look, seen), color, _level(alpha))
            self._ready().blit(sprite, (seen.left, seen.top))
            return
        home = shape.moved(-box.left, -box.top)
        key = (type(home), home, look)
        if not fleeting and self.restamp(key, color, alpha, box.left, box.top):
            return
        mask = self._masks.find(key)
        if mask is None:
            mask = cover(home, look, Box(0, 0, *box.extent))
        self.stamp(key, mask, color, alpha, box.left, box.top, fleeting)

    def disc(self, x: float, y: float, radius: float, coat: Coat) -> None:
        """Paint a disc given in pixels, whose radius is at most `discs.LARGEST`."""
        box = Box(
            math.floor(x - radius - 0.5),
            math.floor(y - radius - 0.5),
            math.ceil(x + radius + 0.5),
            math.ceil(y + radius + 0.5),
        )
        if box.meet(self._clip).area:
            sprite = _picture(self._discs.sprite(x, y, radius, coat, box))
            self._ready().blit(sprite, (box.left, box.top))

    def mask(self, key: Hashable) -> Coverage | None:
        """The mask that was stamped under this key, if it is still held."""
        return self._masks.find(key)

    def restamp(self, key: Hashable, color: Color, alpha: float, left: int, top: int) -> bool:
        """Paint what was stamped under this key in this colour, if it is still held."""
        sprite = self._sprites.find((key, color, _level(alpha)))
        if sprite is None:
            return False
        self._ready().blit(sprite, (left, top))
        return True

    def stamp(
        self,
        key: Hashable,
        mask: Coverage,
        color: Color,
        alpha: float,
        left: int,
        top: int,
        fleeting: bool = False,
    ) -> None:
        """Paint a mask in a colour, and keep both under `key`; of what is `fleeting` the mask only.

        They are kept apart, as colours fade more often than shapes change.
        """
        level = _level(alpha)
        self._masks.keep(key, mask, mask.size + OVERHEAD)
        sprite = _sprite(mask, color, level)
        if not fleeting:
            self._sprites.keep((key, color, level), sprite, 4 * mask.size + OVERHEAD)
        self._ready().blit(sprite, (left, top))

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
    opacity = coverage.astype(np.uint32)
    if level < 256:
        opacity *= np.uint32(level)
        opacity += np.uint32(128)
        opacity >>= np.uint32(8)
    opacity <<= np.uint32(24)
    opacity |= np.uint32(color[0] << 16 | color[1] << 8 | color[2])
    return _picture(opacity)


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
