from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageSequence

from app.frames import Pixels

Write = Callable[..., Path]


def shown(path: Path) -> list[tuple[Pixels, int]]:
    with Image.open(path) as image:
        pictures = []
        for part in ImageSequence.Iterator(image):
            rgb = np.asarray(part.convert("RGB")).astype(np.uint32)
            part.load()
            pictures.append(
                (rgb[..., 0] << 16 | rgb[..., 1] << 8 | rgb[..., 2], part.info["duration"])
            )
    return pictures


def test_every_pixel_of_every_frame(write: Write, pictures: list[Pixels]) -> None:
    frames = iter(pictures)
    for pixels, lasts in shown(write("film.webp", pictures)):
        for _ in range(round(lasts * 30 / 1000)):
            assert np.array_equal(pixels, next(frames))
    assert next(frames, None) is None


@pytest.mark.parametrize("fps", [60, 30, 12])
def test_times_add_up(write: Write, fps: int) -> None:
    pictures = [np.full((6, 5), 7 * n, np.uint32) for n in range(21)]
    lasts = [lasting for _, lasting in shown(write("film.webp", pictures, fps))]
    assert sum(lasts) == 1000 * 21 // fps
    if fps == 30:
        assert lasts == [33, 33, 34] * 7


@pytest.mark.parametrize("place", [(0, 0), (3, 5), (4, 5), (5, 4), (47, 63)])
def test_odd_places(write: Write, pictures: list[Pixels], place: tuple[int, int]) -> None:
    second = pictures[0].copy()
    second[place] ^= 0xFFFFFF
    (_, _), (pixels, _) = shown(write("film.webp", [pictures[0], second]))
    assert np.array_equal(pixels, second)


def test_it_plays_for_ever(write: Write, pictures: list[Pixels]) -> None:
    path = write("film.webp", pictures)
    data = path.read_bytes()
    assert int.from_bytes(data[4:8], "little") == len(data) - 8
    with Image.open(path) as image:
        assert image.info["loop"] == 0
