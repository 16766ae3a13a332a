"""Rooms in metres, and where they lie on the screen."""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from engine import Vector
from screens.kit.geometry import Point, Rect, Size


class Room(NamedTuple):
    """An upright rectangle of the world (m, +y up)."""

    left: float
    bottom: float
    right: float
    top: float

    @property
    def width(self) -> float:
        """From left to right (m)."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """From bottom to top (m)."""
        return self.top - self.bottom


UPRIGHT, ACROSS = Room(-3.0, -3.25, 3.0, 3.25), Room(-3.75, -3.0, 3.75, 3.0)
"""Rooms of upright and of other screens, if they are shaped like the reference screens."""
STEP = 0.01
"""Rooms grow in steps of this (m), to each side half of it."""


def room_of(screen: Size, canvas: Rect) -> Room:
    """The room that fills a canvas (dp), its middle at the origin.

    It is that of a reference screen, and longer or wider where the canvas has more to show.
    """
    least = UPRIGHT if screen.height >= screen.width else ACROSS
    scale = View(canvas, least).scale
    half_width, half_height = (
        max(shortest, math.floor(length / scale / STEP + 1e-6) * STEP) / 2
        for length, shortest in ((canvas.width, least.width), (canvas.height, least.height))
    )
    return Room(-half_width, -half_height, half_width, half_height)


@dataclass(frozen=True)
class View:
    """A room seen through a rectangle of the screen: as large as fits, in the middle."""

    rect: Rect
    room: Room

    @cached_property
    def scale(self) -> float:
        """How long a metre is (dp)."""
        return min(self.rect.width / self.room.width, self.rect.height / self.room.height)

    @property
    def frame(self) -> Rect:
        """The part of the rectangle that shows the room (dp)."""
        width, height = self.room.width * self.scale, self.room.height * self.scale
        middle = self.rect.center
        return Rect(middle.x - width / 2, middle.y - height / 2, width, height)

    @cached_property
    def _middles(self) -> tuple[float, float, float, float]:
        """The middle of the rectangle (x, y, dp) and that of the room (x, y, m)."""
        room = self.room
        return *self.rect.center, (room.left + room.right) / 2, (room.bottom + room.top) / 2

    def to_screen(self, at: tuple[float, float]) -> Point:
        """Where a place of the world (m) is on the screen (dp)."""
        x, y, room_x, room_y = self._middles
        scale = self.scale
        return Point(x + (at[0] - room_x) * scale, y - (at[1] - room_y) * scale)

    def to_world(self, at: Point) -> Vector:
        """Which place of the world (m) is seen at a point of the screen (dp)."""
        x, y, room_x, room_y = self._middles
        scale = self.scale
        return Vector(room_x + (at.x - x) / scale, room_y - (at.y - y) / scale)
