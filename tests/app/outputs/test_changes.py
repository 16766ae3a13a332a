"""What differs between two pictures: a box, and in it the pixels."""

import numpy as np
import pytest

from app.outputs.changes import Box, changed, differences


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
