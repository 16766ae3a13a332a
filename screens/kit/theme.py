"""Colours, type and measures that all screens share. Needs no pygame."""

from typing import NamedTuple

Color = tuple[int, int, int]
"""Red, green and blue, 0..255."""


def mix(top: Color, alpha: float, under: Color) -> Color:
    """The solid colour that `top` at opacity `alpha` (0..1) shows over `under`."""
    red, green, blue = (round(t * alpha + u * (1 - alpha)) for t, u in zip(top, under, strict=True))
    return red, green, blue


def luminance(color: Color) -> float:
    """How bright a colour looks, 0..1 (relative luminance of WCAG 2, with a gamma of 2)."""
    red, green, blue = (part / 255 for part in color)
    return 0.2126 * red * red + 0.7152 * green * green + 0.0722 * blue * blue


BLACK: Color = (0x00, 0x00, 0x00)
WHITE: Color = (0xFF, 0xFF, 0xFF)

SURFACE: Color = (0x12, 0x12, 0x12)
CANVAS: Color = (0x18, 0x18, 0x18)
NAVIGATION: Color = (0x1E, 0x1E, 0x1E)
DIALOG: Color = (0x2A, 0x2A, 0x2A)
FIELD: Color = (0x1A, 0x1A, 0x1A)
PILL: Color = (0x20, 0x20, 0x20)

TEAL: Color = (0x80, 0xCB, 0xC4)
ORANGE: Color = (0xFF, 0x8A, 0x65)
YELLOW: Color = (0xF0, 0xE4, 0x42)
PURPLE: Color = (0xBB, 0x86, 0xFC)
BODY_COLORS: tuple[Color, ...] = (TEAL, PURPLE, YELLOW)

TEXT: Color = mix(WHITE, 0.87, SURFACE)
TEXT_MEDIUM: Color = mix(WHITE, 0.60, SURFACE)
TEXT_DISABLED: Color = mix(WHITE, 0.38, SURFACE)
TEXT_DARK: Color = (0x0B, 0x2B, 0x28)
"""On a filled button."""

HAIRLINE: Color = mix(WHITE, 0.16, CANVAS)
GRID: Color = mix(WHITE, 0.05, CANVAS)
OUTLINE: Color = mix(WHITE, 0.30, SURFACE)
TRACK: Color = mix(WHITE, 0.18, DIALOG)
"""The unused part of a slider."""
SELECTED: Color = mix(TEAL, 0.26, NAVIGATION)
"""Behind the lesson that is open, in the navigation."""
WALL: Color = mix(WHITE, 0.60, CANVAS)
BUTTON: Color = TEAL
SCRIM = 0.62
"""Opacity of the black behind a dialog."""

REGULAR, MEDIUM, SEMIBOLD = 400, 500, 600


class Style(NamedTuple):
    """How a piece of text is set."""

    size: float
    """Height of the em (dp)."""
    weight: int = REGULAR
    leading: float = 0.0
    """From one baseline to the next (dp); 0 stands for 1.35 em."""
    capitals: bool = False

    @property
    def line_height(self) -> float:
        """From one baseline to the next (dp)."""
        return self.leading or 1.35 * self.size


TITLE = Style(22, SEMIBOLD, 28)
HEADING = Style(18, SEMIBOLD, 24)
LAW = Style(13, REGULAR, 18)
EXPLANATION = Style(12, REGULAR, 16)
BODY = Style(12, REGULAR, 16)
LABEL = Style(10, MEDIUM, 14, capitals=True)
SMALL = Style(10, REGULAR, 14)
VALUE = Style(15, SEMIBOLD, 20)
BIG_VALUE = Style(20, SEMIBOLD, 26)
BUTTON_TEXT = Style(14, SEMIBOLD, 20)
VECTOR = Style(11, SEMIBOLD, 14)
LETTER = Style(11, SEMIBOLD, 14)
NAV = Style(11, REGULAR, 14)
NUMERAL = Style(14, MEDIUM, 18)

MARGIN = 16.0
"""Between the words and the sides of the screen (dp)."""
GAP = 4.0
"""The step of all distances (dp)."""
RADIUS = 6.0
"""Of the corners of canvases and fields (dp)."""
DIALOG_RADIUS = 20.0
TOUCH = 40.0
"""The least height of what a finger is to hit (dp)."""
OUTLINE_WIDTH = 1.5
ARROW_WIDTH = 4.0
WALL_WIDTH = 4.0
