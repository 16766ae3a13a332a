"""Several colours, one over the other, as one picture that lets through what is below it."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from screens.kit.theme import Color


def stacked(layers: Sequence[tuple[Color, NDArray[Any]]]) -> NDArray[np.uint32]:
    """What layers show together, the lowest first: each 0xAARRGGBB, not multiplied by its opacity.

    A layer is a colour and how much of each place it covers (0..1), in arrays of one shape.
    """
    shape = layers[0][1].shape
    opacity = np.zeros(shape)
    channels = [np.zeros(shape) for _ in range(3)]
    for color, cover in layers:
        opacity += cover - opacity * cover
        for channel, value in zip(channels, color, strict=True):
            channel += (value - channel) * cover
    pixels = _byte(255.0 * opacity) << np.uint32(24)
    full = np.maximum(opacity, 1e-9)
    for channel, shift in zip(channels, (16, 8, 0), strict=True):
        pixels |= _byte(channel / full) << np.uint32(shift)
    return pixels


def _byte(values: NDArray[Any]) -> NDArray[np.uint32]:
    """Values of 0..255, rounded."""
    return (values + 0.5).astype(np.uint32)
