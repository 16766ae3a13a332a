"""A picture that is addressed in dp. Pixels exist only here and below."""

import math
from collections.abc import Callable, Hashable, Iterator, Sequence
from contextlib import contextmanager
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from screens.kit import arrows
from screens.kit.badge import badge
from screens.kit.cache import Cache
from screens.kit.discs import LARGEST, Coat
from screens.kit.geometry import Point, Rect, Size
from screens.kit.picture import Picture
from screens.kit.raster import FILLED, ArrowShape, Bar, Box, Disc, Hull, Look, Shape, Slab, Stroke
from screens.kit.scale import scale_of
from screens.kit.sheets import NewPixels, private_pixels
from screens.kit.text import ASCENT, CAP_HEIGHT, DESCENT, FINE, LONGEST, Type, printable
from screens.kit.theme import Color, Style

Place = tuple[float, float]
"""x and y (dp)."""
Align = Literal["left", "center", "right"]
Valign = Literal["top", "middle", "baseline"]

HALVES, FINEST = 2, 64
"""Fading arrows start at such parts of a dp, or at whole pixels if those are smaller, and their
reach is rounded to such parts of a pixel."""
FAR = 1e5
"""Nothing small that is farther away than this can be seen (px)."""
LAYERS = 2
"""How many static pictures are kept."""


class Surface:
    """A picture of `width` x `height` pixels, drawn on in dp with anti-aliased edges.

    Shapes are placed to fractions of a pixel, words to whole ones. Opacities (`alpha`) are 0..1.
    What lies outside the picture or the current clip costs nothing.
    """

    def __init__(
        self,
        width: int,
        height: int,
        new_pixels: NewPixels = private_pixels,
        _like: "Surface | None" = None,
    ) -> None:
        """Make a black picture; `new_pixels` gives the memory that is painted on.

        Raises:
            ValueError: for sides that are not 1..8192 pixels.
        """
        self._picture: Picture = Picture(
            width, height, new_pixels, _like._picture if _like else None
        )
        self.width = width
        """(px)"""
        self.height = height
        """(px)"""
        self.scale = scale_of(width, height)
        """Pixels per dp."""
        self.size = Size(width / self.scale, height / self.scale)
        """(dp)"""
        self._parts = max(1, round(HALVES / self.scale))
        self.type: Type = _like.type if _like else Type(self.scale)
        self._lines: Cache[list[tuple[str, float]]] = _like._lines if _like else Cache(1 << 20)
        self._layers: Cache[Surface] = Cache(LAYERS)

    def pixels(self) -> NDArray[np.uint32]:
        """The picture as it is now, shape (height, width), each 0x00RRGGBB, C-contiguous.

        It is read-only. As long as anybody holds the array, nothing is drawn on it any more.
        """
        return self._picture.pixels()

    def snap(self, value: float) -> float:
        """The nearest whole pixel to a coordinate or a width (dp)."""
        return round(value * self.scale) / self.scale

    # -- areas --------------------------------------------------------------------------------

    def fill(self, color: Color) -> None:
        """Paint all of the picture (or of the clip)."""
        self._picture.fill(color)

    def scrim(self, alpha: float) -> None:
        """Darken all of the picture (or of the clip)."""
        self._picture.darken(alpha)

    def rect(
        self,
        rect: Rect,
        color: Color | None,
        alpha: float = 1,
        radius: float = 0,
        outline: Color | None = None,
        outline_width: float = 1,
    ) -> None:
        """An upright rectangle; the outline lies inside its edge."""
        scale = self.scale
        left, top = rect.x * scale, rect.y * scale
        right, bottom = left + rect.width * scale, top + rect.height * scale
        if not (left < right and top < bottom):
            return
        sharp = all(abs(side - round(side)) < 1e-3 for side in (left, top, right, bottom))
        if sharp and color is not None and alpha >= 1 and not radius and outline is None:
            self._picture.fill(color, Box(round(left), round(top), round(right), round(bottom)))
            return
        corner = min(radius * scale, (right - left) / 2, (bottom - top) / 2)
        self._shape(
            Slab(left, top, right, bottom, corner), color, alpha, outline, outline_width, 1.0
        )

    def circle(
        self,
        center: Place,
        radius: float,
        color: Color | None,
        alpha: float = 1,
        outline: Color | None = None,
        outline_width: float = 1.5,
        outline_alpha: float = 1,
        ground: Color | None = None,
    ) -> None:
        """A disc; the outline lies inside its edge.

        With a `ground` a pale disc lets this colour show through, not what is below it.
        """
        x, y, r = center[0] * self.scale, center[1] * self.scale, radius * self.scale
        if 0 < r <= LARGEST and abs(x) < FAR and abs(y) < FAR:
            line, rim = self._thickness(outline_width, outline_alpha)
            self._picture.disc(x, y, r, Coat(color, alpha, outline, rim, line, ground))
        elif r > 0:
            disc = Disc(x, y, r)
            if ground is not None:
                self._picture.paint(disc, FILLED, ground, 1)
            self._shape(disc, color, alpha, outline, outline_width, outline_alpha)

    def polygon(
        self,
        points: Sequence[Place],
        color: Color | None,
        alpha: float = 1,
        outline: Color | None = None,
        outline_width: float = 1.5,
    ) -> None:
        """A convex polygon, its corners in either order; the outline lies inside its edge."""
        scale = self.scale
        hull = Hull(tuple(Point(x * scale, y * scale) for x, y in points))
        if len(hull.corners) >= 3:
            self._shape(hull, color, alpha, outline, outline_width, 1.0)

    # -- lines --------------------------------------------------------------------------------

    def capsule(self, a: Place, b: Place, width: float, color: Color, alpha: float = 1) -> None:
        """A thick line with round ends."""
        thick, alpha = self._thickness(width, alpha)
        self._picture.paint(Bar(self._point(a), self._point(b), thick), FILLED, color, alpha)

    def line(
        self,
        a: Place,
        b: Place,
        width: float,
        color: Color,
        alpha: float = 1,
        dash: tuple[float, float] | None = None,
    ) -> None:
        """A line with square ends; `dash` gives the lengths of dashes and gaps (dp)."""
        thick, alpha = self._thickness(width, alpha)
        on, off = (dash[0] * self.scale, dash[1] * self.scale) if dash else (0.0, 0.0)
        stroke = Stroke(self._point(a), self._point(b), thick, on, off)
        self._picture.paint(stroke, FILLED, color, alpha)

    def arrow(
        self,
        tail: Place,
        tip: Place,
        color: Color,
        width: float = 4,
        head: arrows.Head = "solid",
        alpha: float = 1,
    ) -> None:
        """An arrow; one that is too short for its head is drawn smaller, one without length not."""
        start, end = self._point(tail), self._point(tip)
        if not (abs(start.x) < FAR and abs(start.y) < FAR):
            return
        if alpha < 1:
            # What fades moves, too, as a rule: at few places its sprite is soon met again.
            reach, parts = Point(end.x - start.x, end.y - start.y), self._parts
            start = Point(_to(start.x, parts), _to(start.y, parts))
            end = Point(start.x + _to(reach.x, FINEST), start.y + _to(reach.y, FINEST))
        # Seen from the pixel where it starts, it is the same shape wherever it is.
        column, row = math.floor(start.x), math.floor(start.y)
        start, end = (Point(at.x - column, at.y - row) for at in (start, end))
        if arrows.has_length(start, end):
            shape = ArrowShape(start, end, width * self.scale, head == "hollow")
            self._picture.paint(shape, FILLED, color, alpha, column, row)

    # -- words --------------------------------------------------------------------------------

    def measure(
        self, words: str, style: Style, width: float | None = None, lines: int | None = None
    ) -> Size:
        """The size of what `text` draws with the same arguments (dp)."""
        broken = self._break(words, style, width, lines)
        widest = max(wide for _, wide in broken)
        return Size(widest / self.scale, len(broken) * style.line_height)

    def text(
        self,
        words: str,
        at: Place,
        style: Style,
        color: Color,
        alpha: float = 1,
        align: Align = "left",
        valign: Valign = "top",
        width: float | None = None,
        lines: int | None = None,
    ) -> Rect:
        """Words, broken into lines of at most `width` dp; returns the room they take.

        `valign`: `at.y` is the top of the first line, the middle of the capitals (of all lines
        together), or the first baseline. What needs more than `lines` lines ends with an ellipsis.
        """
        scale = self.scale
        broken = self._break(words, style, width, lines)
        em = self.type.face(style).pixels
        leading = style.line_height * scale
        above = (leading - (ASCENT + DESCENT) * em) / 2 + ASCENT * em
        baseline = at[1] * scale
        if valign == "top":
            baseline += above
        elif valign == "middle":
            baseline += (CAP_HEIGHT * em - (len(broken) - 1) * leading) / 2
        widest = 0.0
        for row, (line, wide) in enumerate(broken):
            widest = max(widest, wide)
            left = at[0] * scale - _share(align) * wide
            self._line(line, left, baseline + row * leading, style, color, alpha)
        x = at[0] - _share(align) * widest / scale
        return Rect(x, (baseline - above) / scale, widest / scale, len(broken) * style.line_height)

    def letter(
        self, words: str, center: Place, style: Style, color: Color, alpha: float = 1
    ) -> None:
        """A short word about a point that moves: placed to a quarter of a pixel."""
        x, y = center[0] * self.scale, center[1] * self.scale
        if not (words and alpha > 0 and abs(x) < FAR and abs(y) < FAR):
            return
        face = self.type.face(style, FINE)
        words = printable(words)[:LONGEST]
        left, baseline = x - face.width(words) / 2, y + CAP_HEIGHT * face.pixels / 2
        column, row = math.floor(left), math.floor(baseline)
        right, down = int((left - column) * FINE), int((baseline - row) * FINE)
        key = (face, words, right, down)
        self._picture.stamp(key, color, alpha, column, row, lambda: face.mask(words, right, down))

    def badge(
        self,
        words: str,
        rect: Rect,
        style: Style,
        color: Color,
        ground: tuple[Color, float],
        alpha: float = 1,
    ) -> None:
        """A line of words in the middle of a rounded ground (a colour and its opacity).

        Ground and words fade as one, and are placed to whole pixels together.
        """
        scale = self.scale
        left, top = rect.x * scale, rect.y * scale
        width, height = round(rect.width * scale), round(rect.height * scale)
        if not (width > 0 and height > 0 and abs(left) < FAR and abs(top) < FAR):
            return
        face = self.type.face(style)
        ((line, wide),) = self._break(words, style, None, 1)
        middle, baseline = (width - wide) / 2, (height + CAP_HEIGHT * face.pixels) / 2
        self._picture.stamp(
            ("badge", face, line, width, height, color, ground),
            color,
            alpha,
            round(left),
            round(top),
            lambda: badge(
                face.line(line), round(middle), round(baseline), color, (width, height), ground
            ),
        )

    # -- the whole ----------------------------------------------------------------------------

    @contextmanager
    def clip(self, rect: Rect) -> Iterator[None]:
        """Paint only inside `rect` (rounded to whole pixels), and inside the clip around it."""
        scale = self.scale
        left, top = round(rect.x * scale), round(rect.y * scale)
        right, bottom = round(rect.right * scale), round(rect.bottom * scale)
        with self._picture.clip(Box(left, top, right, bottom)):
            yield

    def still(self, key: Hashable, rect: Rect, paint: Callable[[], None]) -> None:
        """What `paint` paints inside `rect`; called once per `key` while the same page lies below.

        `key` must tell apart all that it depends on.
        """
        scale = self.scale
        left, top = math.floor(rect.x * scale), math.floor(rect.y * scale)
        right, bottom = math.ceil(rect.right * scale), math.ceil(rect.bottom * scale)
        self._picture.patch(key, Box(left, top, right, bottom), paint)

    def static(self, key: Hashable, paint: Callable[["Surface"], None]) -> None:
        """Show the whole picture that `paint` paints, which is called once per `key`.

        `key` must tell apart all that the picture depends on. The picture starts black and opaque.
        """
        layer = self._layers.find(key)
        if layer is None:
            layer = Surface(self.width, self.height, _like=self)
            paint(layer)
            self._layers.keep(key, layer, 1)
        self._picture.show(layer._picture.page())

    # -- below: pixels ------------------------------------------------------------------------

    def _point(self, at: Place) -> Point:
        return Point(at[0] * self.scale, at[1] * self.scale)

    def _thickness(self, width: float, alpha: float) -> tuple[float, float]:
        """A line thinner than a pixel is drawn a pixel wide, but paler."""
        pixels = width * self.scale
        return (pixels, alpha) if pixels >= 1 else (1.0, alpha * pixels)

    def _break(
        self, words: str, style: Style, width: float | None, lines: int | None
    ) -> list[tuple[str, float]]:
        """The lines that words are broken into, and how wide each is (px)."""
        pixels = None if width is None else width * self.scale
        key = (words, style, pixels, lines)
        broken = self._lines.find(key)
        if broken is None:
            broken = [
                (line, self.type.width(line, style))
                for line in self.type.lines(words, style, pixels, lines)
            ]
            self._lines.keep(key, broken, 200 + 100 * len(broken) + 2 * len(words))
        return broken

    def _line(
        self, line: str, left: float, baseline: float, style: Style, color: Color, alpha: float
    ) -> None:
        if not (line and alpha > 0 and abs(left) < FAR and abs(baseline) < FAR):
            return
        face = self.type.face(style)
        self._picture.stamp(
            (face, line), color, alpha, round(left), round(baseline), lambda: face.line(line)
        )

    def _shape(
        self,
        shape: Shape,
        color: Color | None,
        alpha: float,
        outline: Color | None,
        outline_width: float,
        outline_alpha: float,
    ) -> None:
        """An area and its rim: in one go if they have one colour."""
        line, outline_alpha = self._thickness(outline_width, outline_alpha)
        if outline is None:
            if color is not None:
                self._picture.paint(shape, FILLED, color, alpha)
        elif color is None or color == outline:
            area = alpha if color is not None else 0.0
            self._picture.paint(shape, Look(area, outline_alpha, line), outline, 1)
        else:
            self._picture.paint(shape, Look(inset=line / 2), color, alpha)
            self._picture.paint(shape, Look(0, 1, line), outline, outline_alpha)


def _to(value: float, parts: int) -> float:
    """`value` rounded to whole `parts` of a pixel; what is not finite or far off stays."""
    return round(value * parts) / parts if abs(value) < FAR else value


def _share(align: Align) -> float:
    """How much of a line lies to the left of its place."""
    return {"left": 0.0, "center": 0.5, "right": 1.0}[align]
