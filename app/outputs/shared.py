"""Pictures in memory that processes share: painted in one of them, encoded in others.

The others know a picture by its place: where it begins in the memory.
"""

import mmap
import os
import tempfile
import weakref
from collections import deque
from threading import Lock

import numpy as np

from app.frames import Film, Pixels

AVAILABLE = os.name == "posix"
"""Whether processes can share memory by its descriptor."""

FEWEST = 3
"""Pictures of which an encoder may always be behind: one may be held while the next is encoded and
a third is on its way."""

MOST = 5
"""More smooth nothing and cost memory: 3.7 MB each at 720x1280."""

ROOM = 64 * 2**20
"""Bytes of pictures of which one encoder may be behind, but for the fewest."""


def most_waiting(film: Film) -> int:
    """Of how many pictures of a film an encoder may be behind."""
    return max(FEWEST, min(MOST, ROOM // (4 * film.height * film.width)))


class Memory:
    """Memory without a name, which vanishes with the last process that has its descriptor."""

    def __init__(self) -> None:
        """Empty at first; raises OSError."""
        self.descriptor = _nameless()
        self._end = 0
        self._sizes: dict[int, int] = {}
        """Bytes of each place that is in use."""
        self._free: dict[int, list[int]] = {}
        """Places that are not, by their size."""
        self._places: dict[int, int] = {}
        """By the address of the picture."""
        self._dropped: deque[int] = deque()
        """Addresses of pictures that nobody holds any more."""
        self._lock = Lock()

    def new(self, shape: tuple[int, int]) -> Pixels:
        """A picture of (height, width) with anything in it; raises OSError.

        Its place is used again once nobody holds it, or any part of it.
        """
        height, width = shape
        size = -(-4 * height * width // mmap.ALLOCATIONGRANULARITY) * mmap.ALLOCATIONGRANULARITY
        with self._lock:
            self._collect()
            free = self._free.setdefault(size, [])
            place = free[-1] if free else self._end
            if not free:
                os.ftruncate(self.descriptor, place + size)
            mapped = mmap.mmap(self.descriptor, size, offset=place)
            if free:  # only now, as there may be no room to map it
                free.pop()
            else:
                self._end += size
            self._sizes[place] = size
            flat = np.frombuffer(mapped, np.uint32, height * width)
            address = _address(flat)
            self._places[address] = place
        # Whoever holds a part of it, or sees it otherwise, keeps this very array alive.
        weakref.finalize(flat, self._drop, address).atexit = False
        return flat.reshape(height, width)

    def place(self, pixels: Pixels) -> int | None:
        """Where a picture begins; None if it is not in this memory or may yet be changed."""
        if pixels.flags.writeable or not pixels.flags.c_contiguous:
            return None
        return self._places.get(_address(pixels))

    def _drop(self, address: int) -> None:
        """Nobody holds this picture any more; this may be called at any time, in any thread."""
        self._dropped.append(address)
        if self._lock.acquire(blocking=False):
            try:
                self._collect()
            finally:
                self._lock.release()

    def _collect(self) -> None:
        """Take back the places of pictures that were dropped; give back the memory of the last."""
        while self._dropped:
            place = self._places.pop(self._dropped.popleft())
            self._free.setdefault(self._sizes.pop(place), []).append(place)
        if self._end and not self._sizes:
            os.ftruncate(self.descriptor, 0)
            self._end = 0
            self._free.clear()


def _nameless() -> int:
    if hasattr(os, "memfd_create"):
        return os.memfd_create("laws-pictures")
    with tempfile.TemporaryFile() as file:
        return os.dup(file.fileno())


def _address(pixels: Pixels) -> int:
    address: int = pixels.__array_interface__["data"][0]
    return address


class Lender:
    """The pictures of a film on the side of its encoder."""

    def __init__(self, descriptor: int, film: Film) -> None:
        """They lie in the memory that has this descriptor."""
        self._descriptor = descriptor
        self._film = film
        self._mapped: dict[int, mmap.mmap] = {}
        self._given_back: list[int] = []

    def lend(self, place: int) -> Pixels:
        """The picture at a place, read-only; it stays as it is as long as anybody holds it."""
        height, width = self._film.height, self._film.width
        if place not in self._mapped:
            size = 4 * height * width
            self._mapped[place] = mmap.mmap(
                self._descriptor, size, access=mmap.ACCESS_READ, offset=place
            )
        pixels = np.frombuffer(self._mapped[place], np.uint32)
        weakref.finalize(pixels, self._given_back.append, place)
        return pixels.reshape(height, width)

    def given_back(self) -> list[int]:
        """The places of pictures that nobody holds any more, since this was last asked."""
        places = self._given_back[:]
        del self._given_back[: len(places)]
        return places
