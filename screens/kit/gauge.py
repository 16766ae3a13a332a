"""The gauge that shows how the device is tilted and what that exerts."""

import math
from typing import TYPE_CHECKING

from engine import Vector
from screens.kit import page, theme
from screens.kit.events import Tilt
from screens.kit.geometry import Point, Rect
from screens.kit.hits import size
from screens.kit.numbers import quantity
from screens.kit.words import Words

if TYPE_CHECKING:
    from screens.kit.surface import Surface

HEIGHT = 40.0
"""Of the gauge (dp)."""
FULL = 45.0
"""Tilt that brings the point to the rim (degrees)."""
POINT = 5.0
"""Radius of the point that rolls (dp)."""
TILT = theme.Style(12, theme.MEDIUM, 16)
"""How the angles are set."""


def draw_ground(surface: "Surface", place: Rect) -> None:
    """The rim and the axes, which stay as they are."""
    radius = HEIGHT / 2
    center = Point(place.x + radius, place.y + radius)
    surface.circle(center, radius, None, outline=theme.OUTLINE, outline_width=1)
    for x, y in ((radius, 0.0), (0.0, radius)):
        ends = Point(center.x - x, center.y - y), Point(center.x + x, center.y + y)
        surface.line(*ends, 1, theme.HAIRLINE)


def draw(surface: "Surface", place: Rect, tilt: Tilt, force: Vector, words: Words) -> None:
    """A point that rolls to where the tilt pushes; beside it the angles and the force (N)."""
    radius = HEIGHT / 2
    center = Point(place.x + radius, place.y + radius)
    x, y = tilt.roll / FULL, tilt.pitch / FULL
    reach = (radius - POINT - 1) / max(1.0, math.sqrt(x * x + y * y))
    surface.circle((center.x + x * reach, center.y + y * reach), POINT, theme.PURPLE)
    degree = words("unit.degree")
    roll, pitch = quantity(tilt.roll, degree), quantity(tilt.pitch, degree)
    angles = words("reactions.tilt", roll=roll, pitch=pitch)
    left = center.x + radius + 8
    surface.text(angles, (left, place.y + 3), TILT, theme.TEXT)
    shown = page.measured(size(force), words("unit.N"), 2)
    exerted = words("reactions.force", force=shown)
    surface.text(exerted, (left, place.y + 21), theme.SMALL, theme.TEXT_MEDIUM)
