"""H.264 in MP4 and VP9 in WebM: what slides, learning platforms and browsers play."""

import os
import sys
from collections import deque
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from fractions import Fraction
from pathlib import Path
from threading import get_native_id
from typing import ClassVar, cast

import av
from av.packet import Packet
from av.video.reformatter import ColorRange
from av.video.stream import VideoStream

from app.frames import Film, Frame, Moment
from app.outputs.conversion import Converter
from app.outputs.promise import OutputError
from app.outputs.titles import named

KEYFRAMES = 2
"""Seconds between pictures that a player can jump to."""

AHEAD = 2
"""Pictures that may be converted before their turn, so that the encoder never waits for the next.
"""

GIVES_WAY = 10
"""How much niceness converting has beyond that of encoding."""

BT709 = 1
"""As matrix, primaries and transfer: what players assume for pictures of this size."""


class _Video:
    """Feeds pictures to one encoder with one thread: with more, the bytes vary from run to run."""

    container: ClassVar[str]
    codec: ClassVar[str]
    muxing: ClassVar[dict[str, str]]
    coding: ClassVar[dict[str, str]]

    def __init__(self, part: Path, film: Film) -> None:
        self._path = part
        # "bitexact" leaves out dates, random ids and the names of programs.
        options = {"fflags": "+bitexact", **self.muxing}
        self._file = av.open(str(part), "w", format=self.container, container_options=options)
        self._file.metadata.update(named(film, "title", "comment"))
        stream = self._file.add_stream(self.codec, rate=film.fps, options=dict(self.coding))
        self._stream = cast(VideoStream, stream)
        self._stream.width, self._stream.height = film.width, film.height
        self._stream.pix_fmt = "yuv420p"
        self._stream.time_base = Fraction(1, film.fps)
        context = self._stream.codec_context
        context.thread_count = 1
        context.gop_size = KEYFRAMES * film.fps
        context.color_range = ColorRange.MPEG
        context.colorspace = context.color_primaries = context.color_trc = BT709
        self._time_base = Fraction(1, film.fps)
        self._converter = Converter(film, AHEAD + 1)
        self._thread = ThreadPoolExecutor(1, "laws-video", initializer=_give_way)
        self._converting: deque[Future[tuple[av.VideoFrame, int]]] = deque()
        self._frames = 0
        self._packets = 0
        self._bytes = 0

    def frame(self, frame: Frame) -> None:
        """Encode a picture before this one, while this one is converted."""
        self._converting.append(self._thread.submit(self._convert, frame))
        if len(self._converting) > AHEAD:
            self.encode(*self._converting.popleft().result())

    def encode(self, picture: av.VideoFrame, index: int) -> None:
        """Encode a picture that is in yuv420p already."""
        picture.pts = index
        picture.time_base = self._time_base
        self._frames += 1
        self._write(self._stream.encode(picture))

    def moment(self, moment: Moment) -> None:
        """Pictures have no use for it."""

    def finish(self) -> None:
        """Encode what is still waiting, write the index, and see that all of it arrived."""
        while self._converting:
            self.encode(*self._converting.popleft().result())
        self._thread.shutdown()
        if self._frames:
            self._write(self._stream.encode(None))
        self._file.close()
        if self._packets != self._frames:
            raise OutputError(self._path, f"{self._packets} of {self._frames} frames were encoded")
        # The muxer does not always tell of a disk that fills up while its last buffer is written.
        if self._path.stat().st_size < self._bytes:
            raise OutputError(self._path, "the file was cut short; is the disk full?")

    def abandon(self) -> None:
        """Close, once the picture in work is converted."""
        self._thread.shutdown(cancel_futures=True)
        self._file.close()

    def _convert(self, frame: Frame) -> tuple[av.VideoFrame, int]:
        return self._converter.convert(frame.pixels), frame.index

    def _write(self, packets: "list[Packet[VideoStream]]") -> None:
        for packet in packets:
            self._packets += 1
            self._bytes += packet.size
            self._file.mux(packet)


def _give_way() -> None:
    """Let other threads of this process run first: what encodes takes longest, and must not wait.

    Where three threads share two processors, it would wait for a seventh of its time.
    """
    if sys.platform == "linux":  # elsewhere the threads of a process have one priority
        with suppress(OSError):
            os.setpriority(os.PRIO_PROCESS, get_native_id(), os.nice(0) + GIVES_WAY)


class Mp4(_Video):
    """Writes `.mp4`: H.264, yuv420p, its index at the front so that it starts while it loads."""

    container = "mp4"
    codec = "libx264"
    muxing: ClassVar[dict[str, str]] = {"movflags": "+faststart"}
    # At crf 18 the edges of text show no ringing; slower presets save a tenth for twice the time.
    coding: ClassVar[dict[str, str]] = {
        "preset": "veryfast",
        "crf": "18",
        "threads": "1",
        # Else it estimates by what each processor is quick at, and not even always the same.
        "x264-params": "cpu-independent=1",
    }


class WebM(_Video):
    """Writes `.webm`: VP9, yuv420p."""

    container = "webm"
    codec = "libvpx-vp9"
    muxing: ClassVar[dict[str, str]] = {}
    coding: ClassVar[dict[str, str]] = {
        "deadline": "realtime",  # "good" takes four times as long to save a fifth
        "cpu-used": "5",
        "crf": "24",
        "b": "0",
        "row-mt": "0",
        "threads": "1",
    }
