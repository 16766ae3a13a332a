"""Pictures as the encoders of video want them: yuv420p, of which only what changed is made anew.

A lesson's frame is mostly the one before it, and to convert all of it takes a third of the time
that libx264 needs to encode it.
"""

from collections import deque
from typing import Any, NamedTuple

import av
import numpy as np
from av.video.reformatter import ColorRange, Colorspace, Interpolation, VideoReformatter
from numpy.typing import NDArray

from app.frames import Film, Pixels
from app.outputs.changes import Box, bands

BAND = 32
"""Rows that are converted together: of each band what lies between its first and last change."""

MARGIN = 2
"""Rows above and below that a band depends on. Each row of colours belongs to two of pixels, and is
mixed from these and the next ones; to the left and right nothing is mixed."""

STRIP = 2048
"""Columns that are converted at once."""

Plane = NDArray[np.uint8]
"""Brightness, or one of two of colour of half its width and height. Rows may end with unused bytes.
"""


def converted(pixels: Pixels, reformatter: VideoReformatter) -> av.VideoFrame:
    """The picture in yuv420p, limited range, BT.709, as players expect it."""
    height, width = pixels.shape
    channels = pixels.view(np.uint8).reshape(height, width, 4)
    return reformatter.reformat(
        av.VideoFrame.from_numpy_buffer(channels, format="bgra"),
        format="yuv420p",
        src_color_range=ColorRange.JPEG,
        dst_color_range=ColorRange.MPEG,
        dst_colorspace=Colorspace.ITU709,
        # Else each kind of processor rounds colours in its own way.
        interpolation=Interpolation.BILINEAR | Interpolation.BITEXACT,
        threads=1,  # more take a fifth more of the processor, which the encoder needs
    )


class _Laid(NamedTuple):
    """A part of the picture that was laid on the strip, and where it begins there."""

    box: Box
    row: int
    column: int


class Converter:
    """Converts the pictures of one film, each as `converted` does, to the last bit."""

    def __init__(self, film: Film, kept: int) -> None:
        """Ready for the first picture; `film` has even sides.

        What `convert` returns stays as it is until it was called `kept` more times.
        """
        self._whole, self._part = VideoReformatter(), VideoReformatter()  # each for one size
        self._seen: Pixels | None = None
        self._shown: deque[av.VideoFrame] = deque(maxlen=kept)
        self._strip = np.zeros((BAND + 2 * MARGIN, STRIP), np.uint32)
        self._most = film.height // len(self._strip) * film.width
        """Columns of bands that take as long as the whole picture."""

    def convert(self, pixels: Pixels) -> av.VideoFrame:
        """The next picture; its pixels are held until the one after it comes."""
        before, self._seen = self._seen, pixels
        boxes = bands(before, pixels, BAND) if before is not None else []
        few = sum(box.width for box in boxes) < self._most
        if few and len(self._shown) == self._shown.maxlen:
            picture = self._shown[0]  # which nobody needs any longer
            planes = _planes(picture)
            for plane, last in zip(planes, _planes(self._shown[-1]), strict=True):
                np.copyto(plane, last)
            self._renew(planes, pixels, boxes)
        else:
            picture = converted(pixels, self._whole)
        self._shown.append(picture)
        return picture

    def _renew(self, planes: list[Plane], pixels: Pixels, boxes: list[Box]) -> None:
        """Convert what is in these boxes, laid side by side on the strip as often as it fills."""
        height, room = self._strip.shape
        laid: list[_Laid] = []
        column = 0
        for top, left, bottom, end in boxes:
            # What is at the edge of the picture must be at the edge of the strip.
            above = min(max(top - MARGIN, 0), len(pixels) - height)
            while left < end:
                right = min(end, left + room - column)
                part = self._strip[:, column : column + right - left]
                part[:] = pixels[above : above + height, left:right]
                laid.append(_Laid(Box(top, left, bottom, right), top - above, column))
                column += right - left
                left = right
                if column == room:
                    self._take(planes, laid)
                    laid, column = [], 0
        if laid:
            self._take(planes, laid)

    def _take(self, planes: list[Plane], laid: list[_Laid]) -> None:
        """Convert the strip, and put what was laid on it where it belongs."""
        y, u, v = planes
        new_y, new_u, new_v = _planes(converted(self._strip, self._part))
        for (top, left, bottom, right), row, column in laid:
            end, last = row + bottom - top, column + right - left
            y[top:bottom, left:right] = new_y[row:end, column:last]
            place = slice(top // 2, bottom // 2), slice(left // 2, right // 2)
            part = slice(row // 2, end // 2), slice(column // 2, last // 2)
            u[place] = new_u[part]
            v[place] = new_v[part]


def _planes(picture: av.VideoFrame) -> list[Plane]:
    """The memory of a picture in yuv420p."""
    return [_rows(plane) for plane in picture.planes]


def _rows(plane: Any) -> Plane:
    return np.frombuffer(plane, np.uint8).reshape(plane.height, plane.line_size)
