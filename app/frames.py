"""What the loop hands to the outputs: pictures, and the moments between them."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from engine import Collision, World

Pixels = NDArray[np.uint32]
"""Shape (height, width), each 0x00RRGGBB, C-contiguous; its bytes are B, G, R, 0."""


@dataclass(frozen=True, slots=True)
class Frame:
    """One picture of a film; it is shown from index/fps to (index + 1)/fps."""

    index: int
    pixels: Pixels
    """Read-only; it stays as it is as long as anybody holds it."""


class Moment(NamedTuple):
    """The world after a tick, or at the start. Read it at once: the world moves on."""

    time: float
    """Simulated time of the world (s)."""
    world: "World"
    collisions: "Sequence[Collision]"
    """Those of the tick that ended now."""


@dataclass(frozen=True, slots=True)
class Film:
    """What an output must know before the first frame."""

    width: int
    """In pixels."""
    height: int
    fps: int
    title: str
    alt: str = ""


class Sink(Protocol):
    """Where frames and moments go. Nothing stands under the promised name before `close`."""

    def frame(self, frame: Frame) -> None:
        """Take the next picture."""

    def moment(self, moment: Moment) -> None:
        """Take the next state of the world."""

    def close(self) -> None:
        """Finish the file and give it its name."""

    def abort(self) -> None:
        """Drop what was begun; what stood under the name before stands there still."""
