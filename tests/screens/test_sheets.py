"""Frames share memory over time, and nobody notices."""

import threading

import numpy as np
import pytest

from screens.kit import sheets, theme
from screens.kit.geometry import Rect
from screens.kit.sheets import Page, Sheet, Sheets
from screens.kit.surface import Surface

WIDTH, HEIGHT = 60, 40


def page(value: int) -> Page:
    return Page(np.full((HEIGHT, WIDTH), value, np.uint32))


def address(pixels: np.ndarray) -> int:
    return pixels.ctypes.data


def test_memory_is_used_again_when_nobody_holds_it():
    store, ground = Sheets(HEIGHT, WIDTH), page(7)
    first = store.lend(store.laid(ground))
    second = store.lend(store.laid(ground))
    assert address(first) != address(second)
    freed = address(first)
    del first
    assert address(store.laid(ground).pixels) == freed


@pytest.mark.parametrize(
    "derived",
    [
        lambda pixels: pixels[3:9, ::2],
        lambda pixels: pixels.view(np.uint8).reshape(HEIGHT, WIDTH, 4)[..., 0],
        lambda pixels: memoryview(pixels),
        lambda pixels: pixels.T.ravel(order="F"),
    ],
)
def test_whatever_is_made_of_a_frame_keeps_it(derived):
    store = Sheets(HEIGHT, WIDTH)
    held = derived(store.lend(store.laid(page(7))))
    for _ in range(4):
        store.lend(store.laid(page(9)))
    assert (np.asarray(held) & 0xFF).max() == 7


def test_frames_are_read_only():
    pixels = Surface(72, 128).pixels()
    with pytest.raises(ValueError, match="read-only"):
        pixels[0, 0] = 1


def test_a_frame_may_be_dropped_in_another_thread():
    store = Sheets(HEIGHT, WIDTH)
    frames = [store.lend(store.laid(page(7)))]
    freed = address(frames[0])
    thread = threading.Thread(target=frames.clear)
    thread.start()
    thread.join()
    assert address(store.laid(page(7)).pixels) == freed


def test_a_page_is_laid_anew_only_where_something_was_painted():
    ground = page(7)
    sheet = Sheet(np.zeros((HEIGHT, WIDTH), np.uint32))
    sheet.lay(ground)
    assert (sheet.pixels == 7).all()
    sheet.fill((1, 2, 3), (10, 5, 20, 4))
    sheet.fill((4, 5, 6), (12, 6, 2, 2))  # inside the first
    assert sheet.pixels[6, 11] == 0x010203
    assert sheet.pixels[6, 12] == 0x040506
    sheet.pixels[30, 50] = 99  # behind its back
    sheet.lay(ground)
    assert (sheet.pixels == 7).sum() == WIDTH * HEIGHT - 1
    sheet.lay(page(8))
    assert (sheet.pixels == 8).all()


def test_a_sheet_painted_all_over_is_laid_at_once():
    ground, sheet = page(7), Sheet(np.zeros((HEIGHT, WIDTH), np.uint32))
    sheet.lay(ground)
    for _ in range(sheets.PIECES + 1):
        sheet.fill((1, 2, 3), (0, 0, WIDTH, HEIGHT))
    assert not sheet.shows_page((0, 0, 1, 1))
    sheet.lay(ground)
    assert (sheet.pixels == 7).all()
    assert sheet.shows_page((0, 0, WIDTH, HEIGHT))


def test_idle_memory_is_bounded():
    side = 1024
    store, ground = Sheets(side, side), Page(np.zeros((side, side), np.uint32))
    frames = [store.lend(store.laid(ground)) for _ in range(12)]
    frames.clear()
    assert 4 * side * side * len(store._idle) == sheets.IDLE


class TestStill:
    """What stays the same over a page."""

    @staticmethod
    def page(layer: Surface) -> None:
        layer.fill(theme.CANVAS)

    def test_it_is_painted_once_for_each_page_and_key(self):
        surface, rect = Surface(360, 640), Rect(20, 20, 100, 50)
        direct = Surface(360, 640)
        calls: list[str] = []

        def paint(words: str, to: Surface) -> None:
            calls.append(words)
            to.rect(rect, theme.DIALOG, radius=8, outline=theme.TEAL)
            to.text(words, (30, 30), theme.BODY, theme.TEXT)

        for words in ("one", "one", "two", "one", "two"):
            direct.static("page", self.page)
            paint(words, direct)
            calls.clear()
            surface.static("page", self.page)
            surface.still(words, rect, lambda words=words: paint(words, surface))
            assert (surface.pixels() == direct.pixels()).all(), words
        assert calls == []
        surface.static("other", lambda layer: layer.fill(theme.SURFACE))
        surface.still("one", rect, lambda: paint("one", surface))
        assert calls == ["one"]

    def test_it_is_painted_whenever_something_else_lies_below(self):
        rect, calls = Rect(20, 20, 100, 50), []
        pictures = []
        for under in (True, False, True):
            surface = Surface(360, 640)
            for _ in range(2):
                surface.static("page", self.page)
                if under:
                    surface.circle((40, 40), 30, theme.TEAL)

                def paint(surface: Surface = surface) -> None:
                    calls.append(1)
                    surface.rect(rect, theme.WHITE, alpha=0.5)

                surface.still("veil", rect, paint)
            pictures.append(surface.pixels())
        assert len(calls) == 2 + 1 + 2
        assert (pictures[0] == pictures[2]).all()
        assert not (pictures[0] == pictures[1]).all()

    def test_nothing_leaves_its_rectangle_nor_the_clip(self):
        surface = Surface(360, 640)
        for _ in range(2):
            surface.static("page", self.page)
            with surface.clip(Rect(0, 0, 60, 640)):
                surface.still("all", Rect(20, 20, 100, 50), lambda: surface.fill(theme.WHITE))
            rows, columns = np.nonzero(surface.pixels() == 0xFFFFFF)
            assert (rows.min(), rows.max(), columns.min(), columns.max()) == (20, 69, 20, 59)
