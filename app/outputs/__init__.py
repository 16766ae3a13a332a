"""Where films go: one file per format, each written beside its name and renamed when whole.

Nothing heavy is imported before an output is opened, so that a scenario can be checked quickly.
"""

import importlib
import importlib.util
import os
from functools import partial
from typing import TYPE_CHECKING

from app.formats import DATA, SUFFIXES, kind_of
from app.outputs.promise import OutputError, Promise, check_place, explained

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from pathlib import Path

    from app.frames import Film, Sink
    from app.outputs.kept import Encoder

__all__ = [
    "DATA",
    "SUFFIXES",
    "OutputError",
    "Promise",
    "check_output",
    "explained",
    "kind_of",
    "open_sink",
    "prepare",
]

LARGEST = {"gif": 65535, "webp": 16383, "mp4": 16384, "webm": 65535}
"""Pixels a side that a format can hold, where that is little."""

VIDEO_EXTRA = 'python -m pip install "laws-of-motion[video]"'
"""What installs the encoders of .mp4 and .webm."""

_ENCODERS = {
    "mp4": ("app.outputs.video", "Mp4"),
    "webm": ("app.outputs.video", "WebM"),
    "gif": ("app.outputs.gif", "Gif"),
    "apng": ("app.outputs.apng", "Apng"),
    "webp": ("app.outputs.webp", "WebP"),
    "png": ("app.outputs.png", "Frames"),
    "csv": ("app.outputs.tracks", "Tracks"),
}


def check_output(path: str | os.PathLike[str], size: tuple[int, int], fps: int) -> None:
    """Refuse what `open_sink` would refuse, without touching the disk or importing an encoder.

    `size` is in pixels. Raises OutputError. The report (.json) is checked for its place only.
    """
    kind = kind_of(path)
    if kind is None:
        known = " ".join(SUFFIXES)
        raise OutputError(path, f"its kind is not known; use {known} or a folder ending in '/'")
    if fps < 1:
        raise OutputError(path, f"{fps} frames per second show nothing")
    width, height = size
    if max(size) > LARGEST.get(kind, max(size)):
        raise OutputError(path, f"{width}x{height} is too large; at most {LARGEST[kind]} a side")
    if kind in ("mp4", "webm"):
        if width % 2 or height % 2:
            raise OutputError(path, f"a video has even sides, not {width}x{height}")
        if importlib.util.find_spec("av") is None:
            raise OutputError(path, f"the video extra is missing; install it: {VIDEO_EXTRA}")
    check_place(path, folder=kind == "png")


def prepare(paths: "Sequence[str]") -> None:
    """Begin to load what will encode these outputs; it takes a moment, in its own processes."""
    kinds = [kind for kind in map(kind_of, paths) if kind not in DATA]
    if kinds:
        from app.outputs.remote import prepare_workers
        from app.outputs.shared import AVAILABLE

        if AVAILABLE:
            prepare_workers([_ENCODERS[kind][0] for kind in kinds if kind in _ENCODERS])


def open_sink(path: str | os.PathLike[str], film: "Film", *, remote: bool = False) -> "Sink":
    """Open an output of the kind its path asks for; its place is claimed before the first frame.

    `remote`: pictures are encoded by a process of its own, where that can be. Raises OutputError.
    A report (.json) is no sink.
    """
    check_output(path, (film.width, film.height), film.fps)
    kind = kind_of(path)
    if kind is None or kind not in _ENCODERS:
        raise OutputError(path, "a report is written after the film, not frame by frame")
    from app.outputs.kept import Kept
    from app.outputs.remote import Remote
    from app.outputs.shared import AVAILABLE

    module, name = _ENCODERS[kind]
    pictures = kind not in DATA
    make: Callable[[Path, Film], Encoder]
    if remote and pictures and AVAILABLE:  # who reads worlds must be where they are
        make = partial(Remote, module, name)
    else:
        make = getattr(importlib.import_module(module), name)
    return Kept(os.fspath(path), film, make, folder=kind == "png", pictures=pictures)
