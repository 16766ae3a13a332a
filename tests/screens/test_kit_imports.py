"""What a scenario is checked with must start quickly: no pygame."""

import subprocess
import sys

import pytest


@pytest.mark.parametrize("module", ["scale", "theme", "numbers", "view", "arrows", "labels"])
def test_pygame_is_not_imported(module):
    program = f"import sys, screens.kit.{module}; sys.exit('pygame' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0


def test_dp_are_those_of_the_phone_in_both_orientations():
    from screens.kit.scale import dp_size, scale_of

    assert (scale_of(720, 1280), dp_size(720, 1280)) == (2, (360, 640))
    assert (scale_of(1280, 720), dp_size(1280, 720)) == (2, (640, 360))
    assert (scale_of(360, 1280), dp_size(360, 1280)) == (1, (360, 1280))
    assert dp_size(500, 500) == pytest.approx((640, 640))
