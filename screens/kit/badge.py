"""Words on a rounded ground, as one mask that fades as one."""

import numpy as np

from screens.kit.layers import stacked
from screens.kit.raster import FILLED, Box, Coverage, Mask, Slab, cover
from screens.kit.theme import Color


def badge(
    words: Mask,
    column: int,
    row: int,
    ink: Color,
    size: tuple[int, int],
    ground: tuple[Color, float],
) -> Mask:
    """A rounded ground (a colour and its opacity) of a size (width and height, px), words on it.

    The words are a mask, as seen from a column and a row of the ground; what would leave it is cut.
    """
    width, height = size
    below = cover(Slab(0, 0, width, height, min(size) / 2), FILLED, Box(0, 0, width, height))
    over = np.zeros_like(below)
    _copy(words, over, column, row)
    pixels = stacked(((ground[0], below * (ground[1] / 255)), (ink, over / 255)))
    coverage = (pixels >> np.uint32(24)).astype(np.uint8)
    return Mask(coverage, inks=pixels & np.uint32(0xFFFFFF))


def _copy(mask: Mask, onto: Coverage, column: int, row: int) -> None:
    """Copy a mask onto a larger one, as seen from a pixel."""
    height, width = mask.coverage.shape
    left, top = column + mask.left, row + mask.top
    box = Box(left, top, left + width, top + height).meet(Box(0, 0, *onto.shape[::-1]))
    if box.area:
        inner = box.moved(-left, -top)
        part = mask.coverage[inner.top : inner.bottom, inner.left : inner.right]
        onto[box.top : box.bottom, box.left : box.right] = part
