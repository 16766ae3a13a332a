"""Discs: a table over the squared distance gives what the distance itself gives."""

import math

import numpy as np
import pytest

from screens.kit import discs, raster, theme
from screens.kit.discs import Coat, Discs
from screens.kit.raster import Box, Look
from screens.kit.surface import Surface

PLACES = [(40.0, 40.0), (40.5, 39.5), (39.83, 40.29), (40.01, 40.99)]
BOX = Box(0, 0, 80, 80)


def sprite(x: float, y: float, radius: float, coat: Coat) -> np.ndarray:
    made, whole = Discs(), np.zeros((BOX.bottom, BOX.right), np.uint32)
    columns, rows = made.axis(x, radius), made.axis(y, radius)
    part = made.sprite(columns, rows, radius, coat)
    whole[rows.first :, columns.first :][: part.shape[0], : part.shape[1]] = part
    return whole


def opacity(x: float, y: float, radius: float, coat: Coat) -> np.ndarray:
    return (sprite(x, y, radius, coat) >> 24).astype(int)


@pytest.mark.parametrize("radius", [1.0, 3.7, 12.0, 30.2])
@pytest.mark.parametrize("place", PLACES)
def test_a_plain_disc_is_covered_as_by_its_signed_distance(place, radius):
    exact = raster.cover(raster.Disc(*place, radius), raster.FILLED, BOX).astype(int)
    assert np.abs(opacity(*place, radius, Coat(theme.WHITE)) - exact).max() <= 6


@pytest.mark.parametrize("place", PLACES)
def test_a_pale_disc_with_a_rim_is_covered_as_by_its_signed_distance(place):
    exact = raster.cover(raster.Disc(*place, 20.4), Look(0.3, 0.8, 3.0), BOX).astype(int)
    coat = Coat(theme.TEAL, 0.3, theme.TEAL, 0.8, 3.0)
    assert np.abs(opacity(*place, 20.4, coat) - exact).max() <= 6


def test_the_rim_lies_over_the_area_and_both_over_the_ground():
    coat = Coat((200, 100, 0), 0.5, (0, 0, 250), 1.0, 4.0, ground=(100, 100, 100))
    pixels = sprite(40, 40, 20, coat)
    assert pixels[40, 40] == 0xFF966432  # halfway between area and ground
    assert pixels[40, 21] == 0xFF0000FA
    assert pixels[40, 10] == 0


def test_a_disc_with_a_ground_hides_what_is_below():
    over_words, over_nothing = Surface(360, 640), Surface(360, 640)
    over_words.text("hidden", (80, 90), theme.VALUE, theme.TEXT)
    for surface in (over_words, over_nothing):
        surface.circle((100.3, 100.1), 60, theme.TEAL, 0.3, outline=theme.TEAL, ground=theme.CANVAS)
    assert (over_words.pixels() == over_nothing.pixels()).all()


def test_large_discs_look_like_small_ones():
    """Beyond `LARGEST` another way is taken."""
    pictures = []
    for radius in (discs.LARGEST, math.nextafter(discs.LARGEST, math.inf)):
        surface = Surface(360, 640)
        surface.circle(
            (170.25, 300.75), radius, theme.TEAL, 0.5, outline=theme.ORANGE, ground=theme.CANVAS
        )
        pictures.append(surface.pixels().view(np.uint8).astype(int))
    assert np.abs(pictures[0] - pictures[1]).max() <= 4


def test_tables_are_bounded():
    made = Discs()
    for i in range(1, 300):
        axis = made.axis(40 + i / 7, i / 3)
        made.sprite(axis, axis, i / 3, Coat(theme.WHITE))
    assert made._axes.size <= discs.AXES
    assert made._tables.size <= discs.TABLES
