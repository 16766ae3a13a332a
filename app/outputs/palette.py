"""The colours of a GIF: chosen while the film runs, so that it need not be seen twice."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

SIZE = 256
TRANSPARENT = 0
"""Index that shows no colour; in the lookup table it means "not looked up yet"."""

FLAT = 64
"""Pixels from which a colour counts as an area when it is met, not as a soft edge."""

GOOD = 12
"""Distance to its entry at which a colour is settled; until then it may come back as an area."""

CANDIDATES = 4096
"""Colours compared at once; of more new ones in one frame, the commonest stand for entries."""

PART = 1 << 20
"""Pixels looked at together: what is worked out for each of them takes many times its own room."""

_Steps = tuple[tuple[int, int], ...]

_TOLERANCE: _Steps = ((64, 1), (112, 8), (160, 16), (200, 28))
"""(entries in use, distance): up to so many, a colour that far from all others gets its own."""

_FLAT_TOLERANCE: _Steps = ((176, 1), (216, 4), (240, 8), (SIZE, 16))
"""The same for areas: exact as long as there is plenty of room; the last entries are theirs."""


class Palette:
    """One global palette that grows: colours of areas first, then those unlike any other.

    A colour keeps an entry that suits it, so what stands still does not flicker. The later a colour
    comes, the more it must differ to get an entry of its own: some room is left for the dialog, the
    arrow, the label that only appear near the end.
    """

    def __init__(self, first: Sequence[tuple[int, int, int]] = ()) -> None:
        """`first`: colours (red, green, blue) that have entries from the start, so stay exact."""
        self._colours = np.zeros((SIZE, 3), np.int32)
        self._used = 1 + len(first)
        self._colours[1 : self._used] = np.reshape(first, (len(first), 3))
        # A page of it costs memory only when one of its colours is met.
        self._table = np.zeros(1 << 24, np.uint8)

    def __call__(self, pixels: NDArray[np.uint32]) -> NDArray[np.uint8]:
        """The index of the entry that stands for each pixel: exact, or the nearest there is."""
        flat, indices = pixels.reshape(-1), np.empty(pixels.size, np.uint8)
        parts = [slice(at, at + PART) for at in range(0, pixels.size, PART)]
        unknown = []
        for part in parts:
            # With this mode `take` needs no room besides.
            self._table.take(flat[part], out=indices[part], mode="clip")
            unknown.append(np.flatnonzero(indices[part] == TRANSPARENT))
        if any(places.size for places in unknown):
            new = [flat[part][places] for part, places in zip(parts, unknown, strict=True)]
            values, nearest = self._learn(*_counted(new))
            for part, places, met in zip(parts, unknown, new, strict=True):
                indices[part][places] = nearest[np.searchsorted(values, met)]
        return indices.reshape(pixels.shape)

    def colours(self) -> bytes:
        """The table as a GIF stores it: red, green, blue for each of the 256 entries."""
        return self._colours.astype(np.uint8).tobytes()

    def _learn(
        self, values: NDArray[np.uint32], counts: NDArray[np.intp]
    ) -> tuple[NDArray[np.uint32], NDArray[np.uint8]]:
        """Give entries to the most telling of the unknown colours; return all and their nearest."""
        rgb = np.stack([(values >> shift) & 0xFF for shift in (16, 8, 0)], axis=1).astype(np.int32)
        flat = counts >= FLAT
        common = np.argsort(-counts, kind="stable")[:CANDIDATES]
        for among, tolerance in ((flat, _FLAT_TOLERANCE), (~flat, _TOLERANCE)):
            chosen = common[among[common]]
            self._admit(rgb[chosen], counts[chosen], tolerance)
        nearest = np.empty(len(values), np.uint8)
        for start in range(0, len(values), CANDIDATES):
            part = slice(start, start + CANDIDATES)
            squares = self._squares(rgb[part])
            nearest[part] = 1 + squares.argmin(axis=1)
            settled = (squares.min(axis=1) <= GOOD**2) | (self._used == SIZE)
            self._table[values[part][settled]] = nearest[part][settled]
        return values, nearest

    def _admit(
        self,
        rgb: NDArray[np.int32],
        counts: NDArray[np.intp],
        tolerance: _Steps,
    ) -> None:
        if len(rgb) == 0:
            return
        far = self._squares(rgb).min(axis=1, initial=3 * 255**2)
        for limit, distance in tolerance:
            while self._used < limit:
                best = int(np.argmax(np.where(far >= distance**2, far * counts, 0)))
                if far[best] < distance**2:
                    break
                self._colours[self._used] = rgb[best]
                self._used += 1
                far = np.minimum(far, ((rgb - rgb[best]) ** 2).sum(axis=1))

    def _squares(self, rgb: NDArray[np.int32]) -> NDArray[np.int32]:
        """Squared distance of each colour to each entry in use, shape (colours, entries)."""
        entries = self._colours[1 : self._used]
        total = np.zeros((len(rgb), len(entries)), np.int32)
        for channel in range(3):
            total += (rgb[:, channel, None] - entries[None, :, channel]) ** 2
        return total


def _counted(parts: Sequence[NDArray[np.uint32]]) -> tuple[NDArray[np.uint32], NDArray[np.intp]]:
    """Each colour that is met in any part, in ascending order, and how often it is."""
    each = [np.unique(part, return_counts=True) for part in parts]
    values, place = np.unique(np.concatenate([met for met, _ in each]), return_inverse=True)
    counts = np.zeros(len(values), np.intp)
    np.add.at(counts, place, np.concatenate([times for _, times in each]))
    return values, counts
