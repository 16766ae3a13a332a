"""Pictures of which only what changed is converted: the same bits as if all of it had been."""

from collections.abc import Iterator

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.frames import Film, Pixels

av = pytest.importorskip("av")

from app.outputs import conversion  # noqa: E402
from app.outputs.conversion import Converter, converted  # noqa: E402

KEPT = 2


def planes(picture: "av.VideoFrame") -> list[np.ndarray]:
    """What can be seen of a picture in yuv420p."""
    rows = [np.frombuffer(plane, np.uint8).reshape(-1, plane.line_size) for plane in picture.planes]
    return [part[:, : plane.width].copy() for part, plane in zip(rows, picture.planes, strict=True)]


def are_equal(a: "av.VideoFrame", b: "av.VideoFrame") -> bool:
    same = (a.width, a.height, a.format.name, a.color_range, a.colorspace) == (
        (b.width, b.height, b.format.name, b.color_range, b.colorspace)
    )
    return same and all(map(np.array_equal, planes(a), planes(b)))


def noise(rng: np.random.Generator, *shape: int) -> Pixels:
    return rng.integers(0, 1 << 24, shape, np.uint32)


def noisy(rng: np.random.Generator, height: int, width: int, frames: int) -> Iterator[Pixels]:
    """Pictures each of which differs from the one before in a few boxes, with edges anywhere."""
    now = noise(rng, height, width)
    for _ in range(frames):
        yield now
        now = now.copy()
        for _ in range(rng.integers(0, 4)):
            top, left = rng.integers(0, height), rng.integers(0, width)
            box = now[top : top + rng.integers(1, 30), left : left + rng.integers(1, 50)]
            box[:] = noise(rng, *box.shape)


@settings(max_examples=60, deadline=None)
@given(
    seed=st.integers(0, 2**32 - 1),
    width=st.integers(1, 150).map(lambda half: 2 * half),
    height=st.integers(1, 120).map(lambda half: 2 * half),
)
def test_the_same_bits_as_all_of_it(seed: int, width: int, height: int) -> None:
    converter, reference = (
        Converter(Film(width, height, 30, ""), KEPT),
        conversion.VideoReformatter(),
    )
    for pixels in noisy(np.random.default_rng(seed), height, width, 6):
        assert are_equal(converter.convert(pixels), converted(pixels, reference))


@pytest.mark.parametrize("size", [(720, 1280), (1920, 1080), (180, 320), (2200, 100)])
def test_the_same_bits_at_the_sizes_of_films(size: tuple[int, int]) -> None:
    width, height = size
    converter, reference = (
        Converter(Film(width, height, 30, ""), KEPT),
        conversion.VideoReformatter(),
    )
    for pixels in noisy(np.random.default_rng(1), height, width, 5):
        assert are_equal(converter.convert(pixels), converted(pixels, reference))


@pytest.mark.parametrize("row", [0, 1, 31, 32, 33, 63, 64, 98, 99])
def test_a_change_shows_in_the_rows_of_colour_around_it(row: int) -> None:
    converter, reference = Converter(Film(64, 100, 30, ""), 1), conversion.VideoReformatter()
    pixels = noise(np.random.default_rng(2), 100, 64)
    converter.convert(pixels)
    pixels = pixels.copy()
    pixels[row] ^= 0xFFFFFF
    assert are_equal(converter.convert(pixels), converted(pixels, reference))


def test_what_was_returned_is_kept_for_a_while() -> None:
    converter = Converter(Film(64, 100, 30, ""), KEPT)
    pictures = []
    for pixels in noisy(np.random.default_rng(3), 100, 64, 12):
        pictures.append((converter.convert(pixels), pixels))
        for picture, shown in pictures[-KEPT:]:
            assert are_equal(picture, converted(shown, conversion.VideoReformatter()))
    assert len({id(picture) for picture, _ in pictures}) < len(pictures)


def test_only_what_changed_is_converted(monkeypatch: pytest.MonkeyPatch) -> None:
    converter = Converter(Film(640, 960, 30, ""), 1)
    pixels = np.zeros((960, 640), np.uint32)
    converter.convert(pixels)
    sizes = []

    def noted(pixels: Pixels, reformatter: object) -> "av.VideoFrame":
        sizes.append(pixels.size)
        return converted(pixels, reformatter)

    monkeypatch.setattr(conversion, "converted", noted)
    converter.convert(pixels.copy())
    assert sizes == []
    pixels = pixels.copy()
    pixels[500:530, 300:330] = 0xFF
    converter.convert(pixels)
    assert sum(sizes) < pixels.size / 4
