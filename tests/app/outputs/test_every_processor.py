"""Films had other bytes on other processors, and MP4 now and then on the same one.

libx264 takes estimates of what each kind of processor is quick at unless it is told not to: on one
that has AVX-512, busy with other things, a film of forty frames came out differently about once in
five hundred times. libswscale rounds colours as is quickest.
"""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from app.frames import Film, Frame, Pixels
from app.outputs import open_sink

av = pytest.importorskip("av")

from app.outputs.video import Mp4  # noqa: E402

PLAIN = """
import ctypes, re, sys
import av
from pathlib import Path

maps = Path("/proc/self/maps").read_text()
for library in set(re.findall(r"/\\S*libavutil\\S*", maps)):
    ctypes.CDLL(library).av_force_cpu_flags(0)

import numpy as np
from app.frames import Film, Frame
from app.outputs import open_sink

pictures = np.load(sys.argv[1])
sink = open_sink(sys.argv[2], Film(64, 48, 30, "A disc", "A disc moves to the right."))
for number, pixels in enumerate(pictures):
    sink.frame(Frame(number, pixels))
sink.close()
"""
"""Writes a film without any instructions that not every processor has."""


def filmed(target: Path, film: Film, pictures: list[Pixels]) -> bytes:
    sink = open_sink(target, film)
    for number, pixels in enumerate(pictures):
        sink.frame(Frame(number, pixels))
    sink.close()
    return target.read_bytes()


def test_x264_writes_the_same_without_any_vector_instructions(
    tmp_path: Path, film: Film, pictures: list[Pixels], monkeypatch: pytest.MonkeyPatch
) -> None:
    quick = filmed(tmp_path / "quick.mp4", film, pictures)
    options = Mp4.coding["x264-params"] + ":asm=0"
    monkeypatch.setattr(Mp4, "coding", {**Mp4.coding, "x264-params": options})
    assert filmed(tmp_path / "plain.mp4", film, pictures) == quick


@pytest.mark.skipif(not Path("/proc/self/maps").exists(), reason="libraries are found on Linux")
@pytest.mark.parametrize("name", ["film.mp4", "film.webm"])
def test_films_are_the_same_on_a_plain_processor(
    tmp_path: Path, film: Film, pictures: list[Pixels], name: str
) -> None:
    noise = np.random.default_rng(7).integers(0, 1 << 24, (3, film.height, film.width), np.uint32)
    shown = [*pictures[:5], *noise]
    quick = filmed(tmp_path / name, film, shown)
    np.save(tmp_path / "pictures.npy", np.array(shown))
    plain = tmp_path / "plain" / name
    plain.parent.mkdir()
    subprocess.run(
        [sys.executable, "-c", PLAIN, str(tmp_path / "pictures.npy"), str(plain)],
        env={**os.environ, "VPX_SIMD_CAPS": "0"},
        check=True,
    )
    assert plain.read_bytes() == quick
