"""H.264 in MP4 and VP9 in WebM: what slides, learning platforms and browsers play."""

from fractions import Fraction
from pathlib import Path
from typing import ClassVar

import av
from av.video.reformatter import ColorRange, Colorspace

from app.frames import Film, Frame, Moment, Pixels
from app.outputs.promise import OutputError

KEYFRAME_EVERY = 2
"""Seconds between pictures that a player can jump to."""
