import os
import sys
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from threading import get_native_id

import numpy as np
import pytest

from app.frames import Film, Frame, Pixels

av = pytest.importorskip("av")

from app.outputs.video import GIVES_WAY, Mp4  # noqa: E402

Write = Callable[..., Path]

SWATCHES = (0x121212, 0x80CBC4, 0xFF8A65, 0xF0E442, 0xBB86FC, 0xFFFFFF, 0x000000, 0x808080)


def decoded(path: Path) -> list[tuple[Fraction, np.ndarray]]:
    with av.open(str(path)) as file:
        return [
            (frame.pts * frame.time_base, frame.to_ndarray(format="yuv420p"))
            for frame in file.decode(video=0)
        ]


def rgb_of(yuv: np.ndarray, row: int, column: int, height: int, width: int) -> tuple[float, ...]:
    """BT.709, limited range, by the formulas of ITU-R BT.709-6 (tables 3 and 4)."""
    planes = yuv.reshape(-1).astype(float)
    quarter = height * width // 4
    y = (planes[row * width + column] - 16) / 219
    chroma = (row // 2) * (width // 2) + column // 2
    u = (planes[height * width + chroma] - 128) / 224
    v = (planes[height * width + quarter + chroma] - 128) / 224
    red, blue = y + 1.5748 * v, y + 1.8556 * u
    green = (y - 0.2126 * red - 0.0722 * blue) / 0.7152
    return tuple(255 * part for part in (red, green, blue))


@pytest.mark.parametrize("name", ["film.mp4", "film.webm"])
def test_colours_survive(write: Write, name: str) -> None:
    pixels = np.zeros((64, 32 * len(SWATCHES)), np.uint32)
    for number, colour in enumerate(SWATCHES):
        pixels[:, 32 * number : 32 * number + 32] = colour
    _, yuv = decoded(write(name, [pixels] * 5))[-1]
    for number, colour in enumerate(SWATCHES):
        found = rgb_of(yuv, 32, 32 * number + 16, *pixels.shape)
        wanted = [(colour >> shift) & 0xFF for shift in (16, 8, 0)]
        assert found == pytest.approx(wanted, abs=3), f"{colour:06x}"


@pytest.mark.parametrize("name", ["film.mp4", "film.webm"])
@pytest.mark.parametrize("fps", [60, 30, 12])
def test_every_frame_at_its_time(write: Write, pictures: list[Pixels], name: str, fps: int) -> None:
    frames = decoded(write(name, pictures, fps))
    assert len(frames) == 40
    for index, (time, _) in enumerate(frames):
        assert float(time) == pytest.approx(index / fps, abs=0.00051)  # WebM counts milliseconds


@pytest.mark.skipif(sys.platform != "linux", reason="its threads have one priority")
def test_encoding_goes_before_converting(tmp_path: Path, film: Film) -> None:
    encoder = Mp4(tmp_path / "film.mp4", film)
    niceness = encoder._thread.submit(lambda: os.getpriority(os.PRIO_PROCESS, get_native_id()))
    assert niceness.result() == min(os.nice(0) + GIVES_WAY, 19)
    encoder.frame(Frame(0, np.zeros((film.height, film.width), np.uint32)))
    assert os.getpriority(os.PRIO_PROCESS, get_native_id()) == os.nice(0)
    encoder.finish()


def test_what_a_player_is_told(write: Write, pictures: list[Pixels]) -> None:
    with av.open(str(write("film.mp4", pictures))) as file:
        stream = file.streams.video[0]
        context = stream.codec_context
        assert (context.codec.name, context.pix_fmt) in [("h264", "yuv420p")]
        assert (context.width, context.height) == (64, 48)
        assert stream.average_rate == 30
        assert stream.frames == 40
        assert stream.duration * stream.time_base == Fraction(40, 30)
        tags = (context.colorspace, context.color_primaries, context.color_trc)
        assert [int(tag) for tag in tags] == [1, 1, 1]
        assert int(context.color_range) == 1
        assert "creation_time" not in file.metadata


def test_the_index_comes_first(write: Write, pictures: list[Pixels]) -> None:
    data = write("film.mp4", pictures).read_bytes()
    assert data.index(b"moov") < data.index(b"mdat")


@pytest.mark.parametrize("name", ["film.mp4", "film.webm"])
def test_the_picture_is_the_right_one(write: Write, pictures: list[Pixels], name: str) -> None:
    """Luma of each frame against that of its picture, by the formula of BT.709."""
    for (_, yuv), pixels in zip(decoded(write(name, pictures)), pictures, strict=True):
        red, green, blue = ((pixels >> shift & 0xFF) / 255 for shift in (16, 8, 0))
        luma = 16 + 219 * (0.2126 * red + 0.7152 * green + 0.0722 * blue)
        assert np.abs(yuv[:48] - luma).mean() < 1.5
