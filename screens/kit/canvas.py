"""A window on the world: bodies, vectors and labels, given in metres, drawn in dp."""

import math
from collections.abc import Sequence
from contextlib import AbstractContextManager, nullcontext
from functools import lru_cache
from typing import TYPE_CHECKING

from engine import Body, Chain, Circle, Particle, Polygon, Wall
from screens.kit import arrows, theme
from screens.kit.arrows import Kind
from screens.kit.geometry import Point, Rect, Size
from screens.kit.labels import Labels
from screens.kit.numbers import quantity
from screens.kit.theme import Color
from screens.kit.view import Room, View

if TYPE_CHECKING:
    from screens.kit.surface import Surface

SPIN_MARK = 0.5
"""Where the mark of a spinning circle starts, in radii from its centre."""
PILL = theme.PILL, 0.92
"""Colour and opacity of the ground of labels."""
PILL_PADDING = Size(10, 4)
BORDER = 1.0
SCALE_BAR = Point(12, 10)
"""Distance of the scale bar from the left and the lower side."""
ROUND_LENGTHS = (1, 2, 5)


class Canvas:
    """Draws a `room` of the world into `rect` of a surface; nothing leaves the rectangle.

    What is drawn blocks its place for labels: draw bodies and arrows first, then labels.
    """

    def __init__(self, surface: "Surface", rect: Rect, room: Room) -> None:
        """Look at `room` (m) through `rect` (dp)."""
        self.surface = surface
        self.rect = rect
        self.view = View(rect, room)
        self.labels = Labels(rect.inset(GAP_TO_BORDER))

    def background(self, grid: float = 0.5, bar: bool = True) -> None:
        """The empty canvas: a grid whose cells are `grid` metres, a border, a scale bar.

        A room that does not fill it has a border of its own.
        """
        surface, rect, room = self.surface, self.rect, self.view.frame
        surface.rect(rect, theme.CANVAS, radius=theme.RADIUS)
        with surface.clip(rect.inset(BORDER)), surface.clip(room):
            self._grid(grid)
        if max(rect.width - room.width, rect.height - room.height) > BORDER:
            surface.rect(room, None, outline=theme.HAIRLINE, outline_width=self._whole(BORDER))
        surface.rect(
            rect,
            None,
            radius=theme.RADIUS,
            outline=theme.HAIRLINE,
            outline_width=self._whole(BORDER),
        )
        if bar:
            self.scale_bar()

    def scale_bar(self) -> None:
        """A bar of a round length, labelled, in the lower left corner."""
        surface, rect = self.surface, self.rect
        length = _round_length(0.22 * rect.width / self.view.scale)
        line = self._whole(1.0)
        left = surface.snap(rect.x + SCALE_BAR.x)
        right = surface.snap(left + length * self.view.scale)
        bottom = surface.snap(rect.bottom - SCALE_BAR.y)
        for bar in (
            Rect(left, bottom - line, right - left, line),
            Rect(left, bottom - 4, line, 4),
            Rect(right - line, bottom - 4, line, 4),
        ):
            surface.rect(bar, theme.OUTLINE)
        words = quantity(length * 100, "cm") if length < 1 else quantity(length, "m")
        middle = ((left + right) / 2, bottom - 6)
        surface.text(
            words, middle, theme.SMALL, theme.TEXT_MEDIUM, align="center", valign="baseline"
        )

    def body(
        self,
        body: Body,
        color: Color,
        opacity: float = 1,
        letter: str = "",
        over: Sequence[Rect] = (),
    ) -> None:
        """A body, pale by `opacity` but with a full outline, and a letter on it.

        A circle that can spin has a mark that turns with it. A pale body lets nothing show through
        of what is drawn already in the rectangles `over` which it lies (dp).
        """
        shape = body.shape
        if isinstance(shape, Wall | Chain):
            for link in shape.pieces:
                self.wall(Wall(link.corners[0], link.corners[1]), color)
            return
        center = self.view.to_screen(body.position)
        if not isinstance(shape, Circle | Particle):
            ground = theme.CANVAS if over else None
            parts = [
                [self.view.to_screen(body.to_world(point)) for point in piece.outline]
                for piece in shape.pieces
            ]
            with self._within(*(corner for part in parts for corner in part)):
                for corners in parts:
                    self._polygon(corners, color, opacity, ground)
            self.letter(letter, center, color, opacity)
            return
        radius = shape.radius * self.view.scale
        x, y = center
        left, top, right, bottom = x - radius, y - radius, x + radius, y + radius
        conceals = any(
            at_x < right and at_x + width > left and at_y < bottom and at_y + height > top
            for at_x, at_y, width, height in over
        )
        ground = theme.CANVAS if conceals else None
        with self._within((left, top), (right, bottom)):
            self.surface.circle(center, radius, color, opacity, outline=color, ground=ground)
            if isinstance(shape, Circle):
                self._spin_mark(center, radius, body.angle, color)
        self.letter(letter, center, color, opacity)
        self.labels.block_circle(center, radius)

    def letter(self, letter: str, center: Point, color: Color, opacity: float) -> None:
        """A letter on a body of a colour and an opacity whose centre is there (dp)."""
        if letter:
            (x, y), reach = center, theme.LETTER.size * len(letter)
            with self._within((x - reach, y - reach), (x + reach, y + reach)):
                ink = letter_color(color, opacity)
                self.surface.letter(letter, center, theme.LETTER, ink)

    def wall(self, wall: Wall, color: Color = theme.WALL) -> None:
        """A wall, as a thick line with round ends."""
        a = self.view.to_screen(wall.start)
        b = self.view.to_screen(wall.end)
        with self.surface.clip(self.rect):
            self.surface.capsule(a, b, theme.WALL_WIDTH, color)
        self.block_wall(wall)

    def block_wall(self, wall: Wall) -> None:
        """Keep labels off a wall that is drawn already."""
        ends = self.view.to_screen(wall.start), self.view.to_screen(wall.end)
        self.labels.block_line(*ends, theme.WALL_WIDTH)

    def arrow(
        self, at: tuple[float, float], reach: tuple[float, float], kind: Kind, alpha: float = 1
    ) -> Point:
        """A vector whose tail is at a place of the world (m); `reach` is its length (dp, +y up).

        Returns where its tip lies (dp).
        """
        tail = self.view.to_screen(at)
        tip = Point(tail.x + reach[0], tail.y - reach[1])
        with self._within(tail, tip):
            self.surface.arrow(tail, tip, kind.color, theme.ARROW_WIDTH, kind.head, alpha)
        self.labels.block_line(tail, tip, arrows.HEAD_WIDTH * theme.ARROW_WIDTH)
        return tip

    def edge(self, body: Body, toward: tuple[float, float]) -> tuple[float, float]:
        """Where the outline of a body (m) is met on the way from its centre along `toward`."""
        center, way = Point(body.x, body.y), Point(*toward)
        if isinstance(body.shape, Polygon):
            return arrows.leave_polygon(center, [Point(v.x, v.y) for v in body.vertices], way)
        if isinstance(body.shape, Circle | Particle):
            return arrows.leave_circle(center, body.shape.radius, way)
        return center

    def trail(
        self, points: Sequence[tuple[float, float]], color: Color = theme.TEAL, radius: float = 1.75
    ) -> None:
        """Places a body was at (m), oldest first, as dots that fade with age."""
        with self.surface.clip(self.rect):
            for i, (x, y) in enumerate(points):
                alpha = 0.1 + 0.6 * (i + 1) / len(points)
                self.surface.circle(self.view.to_screen((x, y)), radius, color, alpha)

    def pill_size(self, words: str) -> Size:
        """The size of a pill with these words."""
        room = self.surface.measure(words, theme.VECTOR)
        return Size(room.width + 2 * PILL_PADDING.width, room.height + 2 * PILL_PADDING.height)

    def pill(self, words: str, rect: Rect, color: Color, alpha: float = 1) -> None:
        """Words on a dark rounded ground that fills `rect`."""
        self.surface.badge(words, rect, theme.VECTOR, color, PILL, alpha)

    def label(
        self,
        words: str,
        anchor: Point,
        color: Color,
        alpha: float = 1,
        gap: float = 6,
        ahead: Point | None = None,
    ) -> Rect | None:
        """A pill at a free place near `anchor` (dp), in the direction `ahead` of it if possible.

        None, and nothing drawn, if there is none.
        """
        place = self.labels.place(self.pill_size(words), anchor, gap, ahead)
        if place is not None:
            self.pill(words, place, color, alpha)
        return place

    def _within(self, *points: tuple[float, float]) -> AbstractContextManager[None]:
        """Clip to the canvas, if what is drawn between these points may leave it."""
        left, top, width, height = self.rect
        right, bottom = left + width - 1, top + height - 1
        for x, y in points:
            if not (left + 1 < x < right and top + 1 < y < bottom):
                return self.surface.clip(self.rect)
        return NOTHING

    def _spin_mark(self, center: Point, radius: float, angle: float, color: Color) -> None:
        x, y = math.cos(angle) * radius, -math.sin(angle) * radius
        near = Point(center.x + SPIN_MARK * x, center.y + SPIN_MARK * y)
        far = Point(center.x + 0.92 * x, center.y + 0.92 * y)
        self.surface.capsule(near, far, theme.OUTLINE_WIDTH, color)

    def _polygon(
        self, corners: list[Point], color: Color, opacity: float, ground: Color | None
    ) -> None:
        if ground is not None:
            self.surface.polygon(corners, ground)
        self.surface.polygon(corners, color, opacity, outline=color)
        xs, ys = [p.x for p in corners], [p.y for p in corners]
        self.labels.block(Rect(min(xs), min(ys), max(xs) - min(xs), max(ys) - min(ys)))

    def _grid(self, cell: float) -> None:
        """Hairlines on whole pixels at every multiple of `cell` metres that can be seen."""
        surface, rect, view = self.surface, self.rect, self.view
        line = self._whole(1.0)
        left, bottom = view.to_world(Point(rect.x, rect.bottom))
        right, top = view.to_world(Point(rect.right, rect.y))
        for i in range(math.ceil(left / cell), math.floor(right / cell) + 1):
            x = surface.snap(view.to_screen((i * cell, 0)).x - line / 2)
            surface.rect(Rect(x, rect.y, line, rect.height), theme.GRID)
        for i in range(math.ceil(bottom / cell), math.floor(top / cell) + 1):
            y = surface.snap(view.to_screen((0, i * cell)).y - line / 2)
            surface.rect(Rect(rect.x, y, rect.width, line), theme.GRID)

    def _whole(self, width: float) -> float:
        """A line width (dp) of whole pixels, at least one."""
        return max(1, round(width * self.surface.scale)) / self.surface.scale


def bar_room(rect: Rect) -> Rect:
    """Where the scale bar of a canvas stands (dp)."""
    return Rect(rect.x + 8, rect.bottom - 28, 0.22 * rect.width + 4, 24)


NOTHING: AbstractContextManager[None] = nullcontext()
GAP_TO_BORDER = 4.0
"""Labels keep this far from the border of the canvas (dp)."""


@lru_cache(maxsize=256)
def letter_color(color: Color, opacity: float) -> Color:
    """Dark or light, whichever reads better on a body of this colour and opacity."""
    ground = theme.luminance(theme.mix(color, opacity, theme.CANVAS))
    return theme.BLACK if ground > 0.21 else theme.WHITE


def _round_length(most: float) -> float:
    """The greatest of 1, 2, 5, 10, ... (and their tenths) that is at most `most` metres."""
    power = 10.0 ** math.floor(math.log10(most))
    return max(step * power for step in ROUND_LENGTHS if step * power <= most * (1 + 1e-12))
