"""How far edge pixels are from a picture sampled at 16 x 16 points a pixel (0 to 255).

    python tests/benchmarks/shapes.py

Circles and polygons at fractional places, drawn by the kit and by pygame's own primitives.
"""

import math
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

sys.path.insert(0, str(Path(__file__).parents[1] / "screens"))

import truth

from screens.kit import theme
from screens.kit.sdl import pygame
from screens.kit.surface import Surface

SHAPES = 60
SIDE = 128
Draw = Callable[[Any, int], None]


def place(i: int) -> tuple[float, float, float]:
    """Centre and radius of the i-th shape (px)."""
    return 60 + 0.37 * (i % 20), 58 + 0.23 * (i % 17), 6 + 0.71 * i


def corners(i: int) -> list[tuple[float, float]]:
    """Of the i-th polygon: 3 to 7, turned a little further each time."""
    x, y, radius = place(i)
    turns = [0.17 * i + 2 * math.pi * k / (3 + i % 5) for k in range(3 + i % 5)]
    return [(x + radius * math.cos(t), y + radius * math.sin(t)) for t in turns]


def by_kit(draw: Draw, i: int) -> NDArray[np.uint32]:
    """The picture on a surface whose dp are pixels."""
    surface = Surface(360, 640)
    draw(surface, i)
    return surface.pixels()[:SIDE, :SIDE]


def by_pygame(draw: Draw, i: int) -> NDArray[np.uint32]:
    """The picture on a plain surface."""
    surface = pygame.Surface((SIDE, SIDE), 0, 32)
    draw(surface, i)
    return pygame.surfarray.array2d(surface).T.astype(np.uint32)


def main() -> None:
    """Print a line for each way to draw."""
    white = theme.WHITE
    ways = [
        ("kit circle", by_kit, lambda s, i: s.circle(place(i)[:2], place(i)[2], white), "disc"),
        ("kit polygon", by_kit, lambda s, i: s.polygon(corners(i), white), "hull"),
        (
            "pygame.draw.circle",
            by_pygame,
            lambda s, i: pygame.draw.circle(s, white, place(i)[:2], place(i)[2]),
            "disc",
        ),
        (
            "pygame.draw.aacircle",
            by_pygame,
            lambda s, i: pygame.draw.aacircle(s, white, place(i)[:2], place(i)[2]),
            "disc",
        ),
        (
            "pygame.draw.polygon",
            by_pygame,
            lambda s, i: pygame.draw.polygon(s, white, corners(i)),
            "hull",
        ),
    ]
    print(f"{'':22}{'mean':>6}{'worst':>7}   of 255, over {SHAPES} shapes")
    for name, by, draw, kind in ways:
        errors = []
        for i in range(SHAPES):
            picture = by(draw, i)
            if kind == "disc":
                want = truth.disc(SIDE, SIDE, *place(i))
            else:
                want = truth.hull(SIDE, SIDE, corners(i))
            errors.append(truth.edge_error(picture, want))
        print(f"{name:22}{np.mean(errors):6.1f}{max(errors):7.1f}")


if __name__ == "__main__":
    main()
