import io
import struct
import zlib
from collections.abc import Callable
from pathlib import Path

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image

from app.frames import Pixels
from app.outputs.png import BAND, Pictures, png_bytes

Write = Callable[..., Path]


def read(data: bytes) -> Pixels:
    with Image.open(io.BytesIO(data)) as image:
        assert image.mode == "RGB"
        rgb = np.asarray(image).astype(np.uint32)
    return rgb[..., 0] << 16 | rgb[..., 1] << 8 | rgb[..., 2]


@given(st.integers(1, 3 * BAND + 1), st.integers(1, 40), st.integers(0, 99))
@settings(deadline=None, max_examples=40)
def test_pixels_come_back(height: int, width: int, seed: int) -> None:
    pixels = np.random.default_rng(seed).integers(0, 1 << 24, (height, width), np.uint32)
    assert np.array_equal(read(png_bytes(pixels)), pixels)


def test_the_stream_is_a_whole_zlib_stream() -> None:
    """zlib itself checks the Adler sum that was put together from those of the bands."""
    pixels = np.arange(3 * BAND * 50, dtype=np.uint32).reshape(3 * BAND, 50)
    data = png_bytes(pixels)
    at = data.index(b"IDAT")
    (size,) = struct.unpack(">I", data[at - 4 : at])
    assert len(zlib.decompress(data[at + 4 : at + 4 + size])) == 3 * BAND * 151


@given(st.integers(0, 3 * BAND - 1), st.integers(0, 49))
@settings(deadline=None, max_examples=30)
def test_bands_used_again_give_the_same_file(row: int, column: int) -> None:
    dice = np.random.default_rng(5)
    before = dice.integers(0, 1 << 24, (3 * BAND, 50), np.uint32)
    after = before.copy()
    after[row, column] ^= 0xFF
    pictures = Pictures()
    pictures.encode(before)
    assert pictures.encode(after) == png_bytes(after)
    assert pictures.encode(after.copy()) == png_bytes(after)
    assert pictures.encode(before[:10]) == png_bytes(before[:10])


def test_a_folder_holds_each_frame(write: Write, pictures: list[Pixels]) -> None:
    folder = write("frames/", pictures)
    files = sorted(folder.iterdir())
    assert [file.name for file in files] == [f"frame-{n:05d}.png" for n in range(1, 41)]
    for file, pixels in zip(files, pictures, strict=True):
        assert np.array_equal(read(file.read_bytes()), pixels)


def test_a_shorter_film_leaves_no_frame_of_the_longer_one(
    write: Write, pictures: list[Pixels]
) -> None:
    write("frames/", pictures)
    folder = write("frames/", pictures[:3])
    assert len(list(folder.iterdir())) == 3
