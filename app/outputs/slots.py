"""Pictures in memory that two processes share: one fills them, the other lends them to an encoder.

A slot is free again once nobody in the other process holds its picture any more.
"""

import mmap
import os
import tempfile
import weakref

import numpy as np
from numpy.typing import NDArray

from app.frames import Film, Pixels

FEWEST = 3
"""Slots that are always there: an encoder may hold one picture while it is given the next."""

MOST = 5
"""More smooth nothing and cost memory: 3.7 MB each at 720x1280."""

ROOM = 64 * 2**20
"""Bytes of slots for one encoder, but for the fewest: of large pictures there are fewer."""


def slots_for(film: Film) -> int:
    """How many pictures of a film may be shared at a time."""
    return max(FEWEST, min(MOST, ROOM // _bytes(film)))


def new_memory() -> int:
    """A descriptor of memory without a name, which vanishes with the last process that has it."""
    if hasattr(os, "memfd_create"):
        return os.memfd_create("laws-pictures")
    with tempfile.TemporaryFile() as file:
        return os.dup(file.fileno())


def filled_by_us(memory: int, film: Film) -> NDArray[np.uint32]:
    """Its slots as pictures of a film, shape (slots, height, width), with anything in them."""
    slots = slots_for(film)
    os.ftruncate(memory, slots * _bytes(film))
    mapped = mmap.mmap(memory, slots * _bytes(film))
    return np.frombuffer(mapped, np.uint32).reshape(slots, film.height, film.width)


class Lender:
    """The slots of a film on the side of its encoder."""

    def __init__(self, memory: int, film: Film) -> None:
        """The other side has made room in this memory."""
        self._mapped = mmap.mmap(memory, slots_for(film) * _bytes(film))
        self._film = film
        self._given_back: list[int] = []

    def lend(self, slot: int) -> Pixels:
        """The picture in a slot, read-only; it stays as it is as long as anybody holds it."""
        height, width = self._film.height, self._film.width
        pixels = np.frombuffer(self._mapped, np.uint32, height * width, slot * _bytes(self._film))
        pixels.flags.writeable = False
        # Whoever holds a part of them, or sees them otherwise, keeps this very array alive.
        weakref.finalize(pixels, self._given_back.append, slot)
        return pixels.reshape(height, width)

    def given_back(self) -> list[int]:
        """The slots that nobody holds any more, since this was last asked."""
        slots = self._given_back[:]
        del self._given_back[: len(slots)]
        return slots


def _bytes(film: Film) -> int:
    """Of a picture."""
    return 4 * film.height * film.width
