import struct
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageSequence

from app.frames import Pixels

Write = Callable[..., Path]


def chunks(path: Path) -> list[tuple[bytes, bytes]]:
    data = path.read_bytes()
    at, found = 8, []
    while at < len(data):
        (size,) = struct.unpack_from(">I", data, at)
        found.append((data[at + 4 : at + 8], data[at + 8 : at + 8 + size]))
        at += 12 + size
    return found


def times(path: Path) -> list[Fraction]:
    controls = [data for kind, data in chunks(path) if kind == b"fcTL"]
    return [Fraction(*struct.unpack_from(">HH", data, 20)) for data in controls]


def test_every_pixel_of_every_frame(write: Write, pictures: list[Pixels]) -> None:
    frames = iter(pictures)
    path = write("film.apng", pictures)
    with Image.open(path) as image:
        for part, lasts in zip(ImageSequence.Iterator(image), times(path), strict=True):
            rgb = np.asarray(part.convert("RGB")).astype(np.uint32)
            pixels = rgb[..., 0] << 16 | rgb[..., 1] << 8 | rgb[..., 2]
            for _ in range(int(lasts * 30)):
                assert np.array_equal(pixels, next(frames))
    assert next(frames, None) is None


@pytest.mark.parametrize("fps", [60, 30, 12])
def test_times_are_exact(write: Write, pictures: list[Pixels], fps: int) -> None:
    assert sum(times(write("film.apng", pictures, fps))) == Fraction(40, fps)


def test_the_count_at_the_front_and_the_order(write: Write, pictures: list[Pixels]) -> None:
    found = chunks(write("film.apng", pictures))
    kinds = [kind for kind, _ in found]
    assert kinds[:5] == [b"IHDR", b"acTL", b"iTXt", b"fcTL", b"IDAT"]
    assert kinds[-1] == b"IEND"
    count, plays = struct.unpack(">II", found[1][1])
    assert (count, plays) == (kinds.count(b"fcTL"), 0)
    numbers = [struct.unpack_from(">I", data)[0] for kind, data in found if kind[:1] == b"f"]
    assert numbers == list(range(len(numbers)))


def test_a_very_long_picture_is_split(write: Write) -> None:
    path = write("film.apng", [np.zeros((2, 2), np.uint32)] * 70000, 60)
    assert times(path) == [Fraction(65535, 60), Fraction(70000 - 65535, 60)]
