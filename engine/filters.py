"""Which bodies pass through each other: by category, by group, and pair by pair.

Two bodies touch if each is of a category that the other's mask names, unless they are of the same
group other than 0, or one was told to ignore the other. Walls have filters like all bodies.
"""

from bisect import bisect_left
from typing import Any

import numpy as np

from engine import validate
from engine.tables import Ignored, Tables

ALL = 0xFFFFFFFF
"""Mask of all 32 categories."""

MOST_GROUPS = 2**31
"""Groups are smaller."""


def category_bits(value: Any) -> int:
    """Check a category: one or more of 32 bits."""
    return validate.whole(value, "category", 1, ALL)


def mask_bits(value: Any) -> int:
    """Check a mask: any of 32 bits, 0 for a body that touches nothing."""
    return validate.whole(value, "mask", 0, ALL)


def group_number(value: Any) -> int:
    """Check a group: 0 for none."""
    return validate.whole(value, "group", 0, MOST_GROUPS - 1)


def pair_keys(a: Any, b: Any) -> Any:
    """One number for each pair of ids, whichever comes first."""
    return (np.minimum(a, b) << 32) | np.maximum(a, b)


def ignored_keys(ignored: Ignored, number: int) -> Any:
    """The same for the pairs that were told to ignore each other."""
    return pair_keys(np.asarray(ignored.a)[:number], np.asarray(ignored.b)[:number])


def row_of_ignored(t: Tables, a: int, b: int, joint: int) -> tuple[int, bool]:
    """Row of `Ignored` where two bodies, by their ids, ignore each other on behalf of a joint (0:
    by hand), and whether they do; if not, it is where that belongs in order.
    """

    def key(row: int) -> tuple[int, int, int]:
        return t.ignored.a[row], t.ignored.b[row], t.ignored.joint[row]

    wanted, rows = (min(a, b), max(a, b), joint), range(t.counts.ignored[0])
    row = bisect_left(rows, wanted, key=key)
    return row, row in rows and key(row) == wanted


def ignored_columns(t: Tables) -> list[Any]:
    """The pairs that ignore each other, in order, for the digest; nothing where none do."""
    number = t.counts.ignored[0]
    return [np.unique(ignored_keys(t.ignored, number))] if number else []
