"""Sprites are laid over pixels by one formula: on every processor a frame has the same bytes."""

import numpy as np
import pytest

from screens.kit.sdl import pygame
from screens.kit.sheets import LAYOUT

STEPS = np.r_[0:256:3, 255, 128]
"""Colours and opacities that are tried, all with all."""


@pytest.mark.parametrize("width", [1, 3, 7, 8, 13, 256])
def test_blits_follow_one_formula(width):
    """Whatever vector instructions there are, and for what is left over at the ends of rows."""
    combined = np.meshgrid(STEPS, STEPS, STEPS, indexing="ij")
    rows = STEPS.size**3 // width
    over, below, opacity = (part.ravel()[: rows * width].reshape(rows, width) for part in combined)
    pixels = (below * 0x010101).astype(np.uint32)
    sprite = (opacity << 24 | over * 0x010101).astype(np.uint32)
    picture = pygame.image.frombuffer(pixels.data, (width, rows), LAYOUT)
    picture.blit(pygame.image.frombuffer(sprite.data, (width, rows), "RGBA"), (0, 0))
    mixed = np.where(opacity > 0, (((over - below) * opacity + over) >> 8) + below, below)
    np.testing.assert_array_equal(pixels, mixed * 0x010101)
