"""What the kinds of vector look like, and where their arrows start and end. Needs no pygame."""

import math
from collections.abc import Sequence
from typing import Literal, NamedTuple

from screens.kit import theme
from screens.kit.geometry import Point
from screens.kit.theme import Color

Head = Literal["solid", "hollow"]
HEAD_LENGTH, HEAD_WIDTH = 3.0, 3.0
"""Of an arrow's head, in widths of its shaft."""
SHORTEST = 1.4
"""An arrow shorter than this many heads shrinks as a whole, so that it keeps a shaft."""


class Kind(NamedTuple):
    """One sort of vector: colour and head both tell it apart."""

    color: Color
    head: Head


FORCE = Kind(theme.ORANGE, "solid")
REACTION = Kind(theme.ORANGE, "hollow")
VELOCITY = Kind(theme.YELLOW, "hollow")


class Arrow(NamedTuple):
    """The outline of an arrow, ready to be drawn."""

    tail: Point
    neck: Point
    """Where the shaft meets the head."""
    tip: Point
    width: float
    """Of the shaft."""
    wings: tuple[Point, Point]
    """The back corners of the head."""


def has_length(tail: Point, tip: Point) -> bool:
    """Whether an arrow from one point to another can be drawn."""
    dx, dy = tip.x - tail.x, tip.y - tail.y
    return 1e-6 < math.sqrt(dx * dx + dy * dy) < math.inf


def shape(tail: Point, tip: Point, width: float) -> Arrow | None:
    """The arrow from `tail` to `tip` with a shaft of `width`; None if it has no length.

    Lengths are in dp or in pixels, as given.
    """
    if not has_length(tail, tip):
        return None
    dx, dy = tip.x - tail.x, tip.y - tail.y
    length = math.sqrt(dx * dx + dy * dy)
    width *= min(1.0, length / (SHORTEST * HEAD_LENGTH * width))
    ux, uy = dx / length, dy / length
    neck = Point(tip.x - ux * HEAD_LENGTH * width, tip.y - uy * HEAD_LENGTH * width)
    half = HEAD_WIDTH * width / 2
    wings = (
        Point(neck.x - uy * half, neck.y + ux * half),
        Point(neck.x + uy * half, neck.y - ux * half),
    )
    return Arrow(tail, neck, tip, width, wings)


def leave_circle(center: Point, radius: float, toward: Point) -> Point:
    """Where a ray from the centre of a circle in the direction `toward` leaves it."""
    length = math.sqrt(toward.x * toward.x + toward.y * toward.y)
    if length == 0.0:
        return center
    return Point(center.x + toward.x / length * radius, center.y + toward.y / length * radius)


def leave_polygon(center: Point, corners: Sequence[Point], toward: Point) -> Point:
    """Where a ray from a point inside a convex polygon in the direction `toward` leaves it."""
    nearest = math.inf
    for i in range(len(corners)):
        a, b = corners[i - 1], corners[i]
        sx, sy = b.x - a.x, b.y - a.y
        cross = toward.x * sy - toward.y * sx
        if cross == 0.0:
            continue
        along = ((a.x - center.x) * sy - (a.y - center.y) * sx) / cross
        if 0.0 <= along < nearest:
            nearest = along
    if nearest == math.inf:
        return center
    return Point(center.x + toward.x * nearest, center.y + toward.y * nearest)
