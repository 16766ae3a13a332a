"""A pair of numbers with a direction."""

from typing import NamedTuple


class Vector(NamedTuple):
    """A vector of the plane: x to the right, y upwards; its unit is that of what it describes."""

    x: float
    y: float
