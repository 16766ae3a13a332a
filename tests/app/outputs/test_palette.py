import numpy as np
import pytest

from app.outputs import palette as module
from app.outputs.palette import FLAT, SIZE, TRANSPARENT, Palette


def rgb(palette: Palette) -> np.ndarray:
    return np.frombuffer(palette.colours(), np.uint8).reshape(SIZE, 3).astype(int)


def parts(pixels: np.ndarray) -> np.ndarray:
    return np.stack([(pixels >> shift) & 0xFF for shift in (16, 8, 0)], axis=-1).astype(int)


def test_no_pixel_is_transparent() -> None:
    palette = Palette()
    for seed in range(3):
        pixels = np.random.default_rng(seed).integers(0, 1 << 24, (40, 50), np.uint32)
        assert TRANSPARENT not in palette(pixels)
    assert TRANSPARENT not in palette(np.zeros(1, np.uint32))


def test_each_pixel_gets_the_nearest_entry() -> None:
    """Against all 255 distances, computed here in full, once the palette has settled."""
    palette = Palette()
    pixels = np.random.default_rng(1).integers(0, 1 << 24, 5000, np.uint32)
    for _ in range(3):
        indices = palette(pixels)
    squares = ((parts(pixels)[:, None] - rgb(palette)[None, 1:]) ** 2).sum(axis=2)
    chosen = squares[np.arange(5000), indices.astype(int) - 1]
    assert np.mean(chosen == squares.min(axis=1)) > 0.99


def test_an_area_that_first_was_an_edge_gets_its_entry() -> None:
    """One such pixel is put with its neighbours; a whole area of the same colour is not."""
    palette = Palette()
    crowd = np.random.default_rng(4).integers(0, 1 << 24, 4000, np.uint32) | 0x800000
    palette(crowd)
    edge = np.full(1, 0x20C040, np.uint32)
    index = palette(edge)
    assert np.abs(rgb(palette)[index] - parts(edge)).max() > 16
    area = np.full(2 * FLAT, 0x20C040, np.uint32)
    indices = palette(area)
    assert np.array_equal(rgb(palette)[indices], parts(area))


def test_entries_never_change() -> None:
    palette = Palette(((1, 2, 3), (200, 0, 0)))
    palette(np.arange(0, 1 << 24, 70_001, np.uint32))
    before = rgb(palette)
    palette(np.arange(7, 1 << 24, 30_011, np.uint32))
    kept = before.any(axis=1)
    assert kept[1:3].all()
    assert np.array_equal(rgb(palette)[kept], before[kept])


def test_it_does_not_matter_how_much_is_looked_at_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Large pictures are taken in parts, which needs far less memory."""
    dice = np.random.default_rng(1)
    colours = dice.integers(0, 1 << 24, 900, dtype=np.uint32)
    pictures = [colours[dice.integers(0, count, (70, 90))] for count in (40, 300, 900)]
    films = []
    for part in (1 << 20, 1000):
        monkeypatch.setattr(module, "PART", part)
        palette = Palette(((1, 2, 3),))
        indices = [palette(picture).tolist() for picture in pictures]
        films.append((indices, palette(pictures[0][:0]).tolist(), palette.colours()))
    assert films[0] == films[1]
