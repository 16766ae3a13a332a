"""A short film to encode: dark, flat colours, soft edges, some frames equal to the one before."""

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from app.frames import Film, Frame, Pixels
from app.outputs import open_sink, remote

WIDTH, HEIGHT, FPS = 64, 48, 30


def picture(number: int) -> Pixels:
    """A disc with soft edges, moved by half a pixel per frame over a flat ground and a bar."""
    pixels = np.full((HEIGHT, WIDTH), 0x121212, np.uint32)
    pixels[40:, :] = 0x1E1E1E
    rows, columns = np.mgrid[:HEIGHT, :WIDTH]
    far = np.sqrt((columns - 10 - number / 2) ** 2 + (rows - 20.3) ** 2)
    cover = np.clip(8.5 - far, 0, 1)
    mixed = np.zeros_like(pixels)
    for shift in (16, 8, 0):
        below = (pixels >> shift) & 0xFF
        value = below + ((0x80CBC4 >> shift & 0xFF) - below.astype(float)) * cover
        mixed |= np.rint(value).astype(np.uint32) << np.uint32(shift)
    mixed[2:6, 2 : 6 + number % 7] = 0xFF8A65
    return mixed


@pytest.fixture
def film() -> Film:
    return Film(WIDTH, HEIGHT, FPS, "A disc", "A disc moves to the right.")


@pytest.fixture
def pictures() -> list[Pixels]:
    """Forty frames; each fourth is equal to the one before it."""
    return [picture(number - (number % 4 == 3)) for number in range(40)]


@pytest.fixture
def write(film: Film, tmp_path: Path) -> Callable[..., Path]:
    """Write pictures to a file of that name in the test's folder; `fps` replaces the film's."""

    def write(name: str, pictures: list[Pixels], fps: int = FPS) -> Path:
        height, width = pictures[0].shape
        target = f"{tmp_path}/{name}"
        sink = open_sink(target, Film(width, height, fps, film.title))
        for index, pixels in enumerate(pictures):
            sink.frame(Frame(index, pixels))
        sink.close()
        return Path(target)

    return write


@pytest.fixture
def no_idle_workers() -> Iterator[None]:
    """Whatever a test asks of workers, it begins and ends without any."""
    remote.dismiss_workers()
    yield
    remote.dismiss_workers()
