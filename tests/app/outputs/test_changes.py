"""What differs between two pictures: a box, and in it the pixels."""

import numpy as np
import pytest

from app.outputs.changes import Box, bands, changed, differences


@pytest.mark.parametrize("width", [8, 9])
def test_the_box_holds_all_that_differs_and_nothing_around_it(width):
    before = np.full((6, width), 0x121212, np.uint32)
    now = before.copy()
    now[2, 3] = now[4, 6] = 0xFFFFFF
    found = differences(before, now)
    assert found is not None
    box, differs = found
    assert box == changed(before, now) == Box(2, 3, 5, 7)
    assert np.argwhere(differs).tolist() == [[0, 0], [2, 3]]


@pytest.mark.parametrize("width", [8, 9])
def test_equal_pictures_have_no_box(width):
    picture = np.arange(5 * width, dtype=np.uint32).reshape(5, width)
    assert differences(picture, picture.copy()) is None
    assert changed(picture, picture.copy()) is None


@pytest.mark.parametrize("place", [(0, 0), (0, 7), (5, 0), (5, 7)])
def test_a_single_pixel_is_found_in_every_corner(place):
    before = np.zeros((6, 8), np.uint32)
    now = before.copy()
    now[place] = 1
    row, column = place
    assert changed(before, now) == Box(row, column, row + 1, column + 1)


@pytest.mark.parametrize(
    ("place", "found"),
    [
        ((0, 0), [Box(0, 0, 4, 2)]),
        ((2, 5), [Box(0, 4, 4, 6)]),
        ((3, 5), [Box(0, 4, 4, 6), Box(4, 4, 8, 6)]),
        ((4, 5), [Box(0, 4, 4, 6), Box(4, 4, 8, 6)]),
        ((9, 7), [Box(8, 6, 10, 8)]),
    ],
)
def test_a_change_is_found_in_its_band_and_beside_it(place, found):
    before = np.zeros((10, 8), np.uint32)
    now = before.copy()
    now[place] = 1
    assert bands(before, now, 4) == found


def test_a_band_reaches_from_its_first_to_its_last_change():
    before = np.zeros((10, 8), np.uint32)
    now = before.copy()
    now[5, 2] = now[6, 5] = 1
    assert bands(before, now, 4) == [Box(4, 2, 8, 6)]
    assert bands(now, now.copy(), 4) == []
