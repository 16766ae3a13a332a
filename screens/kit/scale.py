"""How many pixels a dp has in a picture of a given size. Needs no pygame."""

from screens.kit.geometry import Size

SHORT, LONG = 360.0, 640.0
"""Sides of the reference screen (dp): the phone that the layouts are drawn for."""


def scale_of(width: int, height: int) -> float:
    """Pixels per dp: the reference screen, upright or lying, just fits into the picture."""
    if height >= width:
        return min(width / SHORT, height / LONG)
    return min(width / LONG, height / SHORT)


def dp_size(width: int, height: int) -> Size:
    """The size in dp of a picture of `width` x `height` pixels."""
    scale = scale_of(width, height)
    return Size(width / scale, height / scale)
