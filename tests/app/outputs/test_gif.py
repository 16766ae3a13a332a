from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageSequence

from app.frames import Pixels
from app.outputs.gif import EXACT

Write = Callable[..., Path]


def shown(path: Path) -> list[tuple[Pixels, int]]:
    """What a viewer shows: pictures as 0xRRGGBB and how long each lasts (ms)."""
    with Image.open(path) as image:
        pictures = []
        for part in ImageSequence.Iterator(image):
            rgb = np.asarray(part.convert("RGB")).astype(np.uint32)
            pictures.append(
                (rgb[..., 0] << 16 | rgb[..., 1] << 8 | rgb[..., 2], round(part.info["duration"]))
            )
    return pictures


def delays(path: Path) -> list[int]:
    """In hundredths, read from the graphic control extensions themselves."""
    data = path.read_bytes()
    at = 13 + 768
    found = []
    while data[at] != 0x3B:
        if data[at] == 0x21:
            if data[at + 1] == 0xF9:
                found.append(data[at + 4] + 256 * data[at + 5])
            at += 2
        else:
            assert data[at] == 0x2C
            at += 11
        while data[at]:
            at += 1 + data[at]
        at += 1
    assert at == len(data) - 1
    return found


def test_few_colours_are_exact(write: Write, pictures: list[Pixels]) -> None:
    """Under 64 colours in all: each picture comes back pixel by pixel."""
    flat = [np.where(p & 0xFF == 0x12, p, p & 0xC0C0C0).astype(np.uint32) for p in pictures]
    assert len(np.unique(flat)) < 64
    films = shown(write("film.gif", flat))
    frames = iter(flat)
    for pixels, lasts in films:
        for _ in range(round(lasts * 30 / 1000)):
            assert np.array_equal(pixels, next(frames))
    assert next(frames, None) is None


def test_flat_colours_are_exact_and_others_near(write: Write, pictures: list[Pixels]) -> None:
    films = shown(write("film.gif", pictures))
    first = films[0][0]
    for colour in (0x121212, 0x1E1E1E, 0x80CBC4, 0xFF8A65):
        assert (first[pictures[0] == colour] == colour).all()
    for shift in (16, 8, 0):
        error = ((first >> shift) & 0xFF).astype(int) - ((pictures[0] >> shift) & 0xFF)
        assert np.abs(error).max() <= 10


def test_a_late_area_finds_room_after_many_other_colours(write: Write) -> None:
    dice = np.random.default_rng(1)
    pictures = [dice.integers(0, 1 << 24, (48, 64), np.uint32) for _ in range(5)]
    late = np.full((48, 64), 0x121212, np.uint32)
    late[10:30, 10:30] = 0xFF8A65
    pixels, _ = shown(write("film.gif", [*pictures, late]))[-1]
    for shift in (16, 8, 0):
        error = (pixels >> shift & 0xFF).astype(int) - (late >> shift & 0xFF)
        assert np.abs(error).max() <= 8


def test_theme_colours_are_exact_however_late(write: Write) -> None:
    dice = np.random.default_rng(2)
    pictures = [dice.integers(0, 1 << 24, (48, 64), np.uint32) for _ in range(5)]
    colours = [red << 16 | green << 8 | blue for red, green, blue in EXACT]
    late = np.resize(np.array(colours, np.uint32), (48, 64))
    pixels, _ = shown(write("film.gif", [*pictures, late]))[-1]
    assert np.array_equal(pixels, late)


def test_thirty_frames_are_three_three_four(write: Write, pictures: list[Pixels]) -> None:
    different = [pictures[0] + np.uint32(n) for n in range(9)]
    assert delays(write("film.gif", different)) == [3, 3, 4] * 3


@pytest.mark.parametrize("fps", [60, 50, 30, 20, 15, 12, 10, 7, 1])
@pytest.mark.parametrize("count", [1, 2, 3, 40, 61])
def test_delays_add_up_to_the_true_time(write: Write, fps: int, count: int) -> None:
    pictures = [np.full((2, 2), n, np.uint32) for n in range(count)]
    found = delays(write("film.gif", pictures, fps))
    assert min(found) >= 2
    whole = 100 * count // fps
    assert sum(found) - whole in ((0, 1) if fps >= 50 and count % 2 else (0,))


def test_equal_frames_become_one_that_lasts(write: Write, pictures: list[Pixels]) -> None:
    found = delays(write("film.gif", [pictures[0]] * 30 + [pictures[5]] * 30))
    assert found == [100, 100]


def test_a_very_long_picture_is_split(write: Write) -> None:
    """A delay has 16 bits: 655.35 s. At 1 fps, 1400 equal frames last 1400 s."""
    found = delays(write("film.gif", [np.zeros((2, 2), np.uint32)] * 1400, 1))
    assert found == [65535, 65535, 140000 - 2 * 65535]


def test_it_plays_for_ever(write: Write, pictures: list[Pixels]) -> None:
    with Image.open(write("film.gif", pictures)) as image:
        assert image.info["loop"] == 0


def test_only_the_changed_box_is_stored(write: Write) -> None:
    still = np.random.default_rng(3).integers(0, 200, (48, 64), np.uint32)
    moved = still.copy()
    moved[20, 30] += 9
    one = write("one.gif", [still]).stat().st_size
    two = write("two.gif", [still, moved]).stat().st_size
    assert two - one < 40
