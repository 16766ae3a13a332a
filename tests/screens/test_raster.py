"""Coverage of rectangles: worked out where pixels differ, repeated where they do not."""

import numpy as np
import pytest

from screens.kit import raster
from screens.kit.raster import FILLED, Box, Look, Slab

SLABS = [
    Slab(3.2, 4.7, 90.4, 70.1, 8.0),
    Slab(3.0, 4.0, 90.0, 70.0, 0.0),
    Slab(3.5, 4.5, 12.5, 70.5, 4.5),
    Slab(-40.0, -30.0, 300.0, 200.0, 6.0),
    Slab(5.0, 5.0, 5.6, 5.4, 0.1),
]
LOOKS = [FILLED, Look(0.4, 0.9, 3.0), Look(0.0, 1.0, 2.0), Look(inset=1.5)]


@pytest.mark.parametrize("slab", SLABS)
@pytest.mark.parametrize("look", LOOKS)
def test_a_rectangle_is_covered_as_if_each_pixel_was_looked_at(slab, look):
    box = Box(-2, -3, 100, 80)
    x = np.arange(box.left + 0.5, box.right, dtype=np.float32)[None, :]
    y = np.arange(box.top + 0.5, box.bottom, dtype=np.float32)[:, None]
    direct = raster._cover(slab, look, x, y)
    assert (raster.cover(slab, look, box) == direct).all()
