"""Titles are read back by other readers: Pillow and FFmpeg's demuxers."""

from pathlib import Path

import pytest
from PIL import Image

from app.frames import Film, Frame, Pixels
from app.outputs import open_sink

TITLE = "Größer & <schwerer> → langsamer"
ALT = "Zwei Wagen. " * 60


def written(name: str, folder: Path, pictures: list[Pixels], title: str, alt: str) -> Path:
    height, width = pictures[0].shape
    sink = open_sink(f"{folder}/{name}", Film(width, height, 30, title, alt))
    for index, pixels in enumerate(pictures[:3]):
        sink.frame(Frame(index, pixels))
    sink.close()
    return folder / name


@pytest.mark.parametrize("name", ["a.mp4", "a.webm"])
def test_films_hold_title_and_alt(name: str, tmp_path: Path, pictures: list[Pixels]) -> None:
    av = pytest.importorskip("av")
    with av.open(str(written(name, tmp_path, pictures, TITLE, ALT))) as file:
        held = {key.lower(): value for key, value in file.metadata.items()}
    assert held["title"] == TITLE
    assert held["comment"] == ALT


def test_a_gif_holds_both_in_its_comment(tmp_path: Path, pictures: list[Pixels]) -> None:
    with Image.open(written("a.gif", tmp_path, pictures, TITLE, ALT)) as image:
        assert image.info["comment"].decode() == f"{TITLE}\n{ALT}"
        assert image.n_frames == 3


def test_an_apng_holds_both_in_text_chunks(tmp_path: Path, pictures: list[Pixels]) -> None:
    with Image.open(written("a.apng", tmp_path, pictures, TITLE, ALT)) as image:
        assert image.info["Title"] == TITLE
        assert image.info["Description"] == ALT
        assert image.n_frames == 3


def test_a_webp_holds_both_in_its_xmp(tmp_path: Path, pictures: list[Pixels]) -> None:
    from xml.etree import ElementTree

    with Image.open(written("a.webp", tmp_path, pictures, TITLE, ALT)) as image:
        texts = [
            node.text for node in ElementTree.fromstring(image.info["xmp"]).iter() if node.text
        ]
        assert texts == [TITLE, ALT]
        assert image.n_frames == 3


@pytest.mark.parametrize(
    ("name", "key"), [("a.gif", "comment"), ("a.apng", "Title"), ("a.webp", "xmp")]
)
def test_without_words_nothing_is_held(
    name: str, key: str, tmp_path: Path, pictures: list[Pixels]
) -> None:
    with Image.open(written(name, tmp_path, pictures, "", "")) as image:
        assert key not in image.info
        assert image.n_frames == 3
