"""A few pictures are held fast, for the look: a change that was not meant shows here.

Compared as an eye would, not byte by byte: font libraries differ by a shade from version to
version. If a change was meant, look at the new pictures and keep them with
`python tests/golden/test_golden.py`.
"""

import os
import shutil
import tempfile
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from app.render import render
from app.scenario.load import Overrides, load

GOLDEN = Path(__file__).parent
SCENARIOS = sorted(GOLDEN.glob("*.yaml"))

MEAN = 0.6
"""Mean difference of a channel that passes (of 255)."""
STRANGE, SHARE = 48, 0.002
"""A pixel that differs by more than this (of 255) is strange; so many of them pass."""


def take(scenario: Path, folder: Path) -> list[Path]:
    """Carry out a scenario in `folder` and return its screenshots."""
    shutil.copy(scenario, folder)
    here = Path.cwd()
    os.chdir(folder)
    try:
        render(load(scenario.name, Overrides(outputs=("report.json",), fps="10")))
    finally:
        os.chdir(here)
    return sorted(folder.glob("*.png"))


@pytest.mark.parametrize("scenario", SCENARIOS, ids=lambda path: path.stem)
def test_a_lesson_looks_as_it_did(scenario: Path, tmp_path: Path) -> None:
    shots = take(scenario, tmp_path)
    assert shots
    for shot in shots:
        new = np.asarray(Image.open(shot).convert("RGB"), dtype=np.int16)
        old = np.asarray(Image.open(GOLDEN / shot.name).convert("RGB"), dtype=np.int16)
        assert new.shape == old.shape, shot.name
        differs = np.abs(new - old)
        assert differs.mean() <= MEAN, shot.name
        assert (differs.max(axis=2) > STRANGE).mean() <= SHARE, shot.name


if __name__ == "__main__":
    for each in SCENARIOS:
        with tempfile.TemporaryDirectory() as folder:
            for shot in take(each, Path(folder)):
                shutil.copy(shot, GOLDEN)
