"""Columns of numbers, and what can be done to any table of them."""

from functools import cache
from inspect import get_annotations
from typing import Any, Protocol, TypeVar

import numpy as np

LINE = 8
"""Numbers in a line of a processor's cache."""

SIDE_BY_SIDE = {
    "Pairs": (
        "piece_a", "piece_b", "restitution", "friction", "static_friction",
        "rolling_resistance", "belt_speed", "rolling_torque", "slid", "normal_x", "normal_y",
        "points", "booked_rolling", "lane", "acting", "carried", "part", "steady", "seen_x",
        "seen_y", "seen_angle_a", "seen_angle_b", "drift", "touched", "touched_before",
        "given_x", "given_y", "hit_x", "hit_y", "bounces",
    ),
    "Contacts": (
        "feature", "gap", "normal_arm_a", "tangent_arm_a", "normal_arm_b", "tangent_arm_b",
        "normal_mass", "tangent_mass", "target", "hardness", "softness", "normal_impulse",
        "tangent_impulse", "normal_load", "tangent_load", "booked_normal", "booked_tangent",
    ),
    "Limbs": ("goal_x", "goal_y", "grip_xx", "grip_xy", "grip_yy", "turn", "counter", "both"),
    "Joints": (
        "end_0", "end_1", "lag_0", "lag_1", "older_0", "older_1", "since", "spacing", "mean_0",
        "mean_1", "rise_0", "rise_1", "part", "impulse_0", "impulse_1", "sum_x", "sum_y",
        "sum_turn", "force_x", "force_y", "torque", "break_force", "break_torque", "broken",
    ),
}  # fmt: skip
"""Columns, by table and in order, of which the numbers of a row lie side by side in memory: kernels
read them together, of a row here and there."""


class Floats(Protocol):
    """A column of float64."""

    def __getitem__(self, row: int, /) -> float:
        """Value of a row."""
        ...

    def __setitem__(self, row: int, value: float, /) -> None:
        """Set the value of a row."""
        ...

    def __len__(self) -> int:
        """Number of rows there is room for."""
        ...


class Ints(Protocol):
    """A column of int64."""

    def __getitem__(self, row: int, /) -> int:
        """Value of a row."""
        ...

    def __setitem__(self, row: int, value: int, /) -> None:
        """Set the value of a row."""
        ...

    def __len__(self) -> int:
        """Number of rows there is room for."""
        ...


Table = TypeVar("Table", bound=tuple[Any, ...])


def allocate(table: type[Table], rows: int) -> Table:
    """Make a table of zeros with room for `rows`.

    The columns lie in one block of memory, an odd number of cache lines apart: if it were a power
    of two, as rows often are, the same row of all columns would compete for the same few places in
    the cache of a processor. Of columns in `SIDE_BY_SIDE`, the numbers of a row lie together
    instead.
    """
    kinds = get_annotations(table)
    together = side_by_side(table)
    alone = [name for name in kinds if name not in together]
    lines = (rows + LINE - 1) // LINE | 1
    columns = {}
    for names, block in (
        (alone, np.zeros((len(alone), lines * LINE), np.int64)),
        (together, np.zeros((rows, len(together)), np.int64).T),
    ):
        as_ints, as_floats = block[:, :rows], block.view(np.float64)[:, :rows]
        for name, ints, floats in zip(names, as_ints, as_floats, strict=True):
            columns[name] = ints if kinds[name] is Ints else floats
    return table(**columns)


def side_by_side(table: Any) -> tuple[str, ...]:
    """The columns of a table of which the numbers of a row lie side by side in memory, in order."""
    return SIDE_BY_SIDE.get(table.__name__, ())


def grow(table: Table, rows: int) -> Table:
    """Copy a table into one with room for `rows`."""
    larger, known = allocate(type(table), rows), len(table[0])
    for old, new in zip(_blocks(table), _blocks(larger), strict=True):
        new[:, :known] = old[:, :known]
    return larger


def _blocks(table: Any) -> list[Any]:
    """The memory of a table that `allocate` made (int64), a column of the table in each row."""
    found = []
    for column, aside in _one_of_each_block(table.__class__):
        memory = getattr(table[column], "obj", table[column]).base
        found.append(memory.T if aside else memory)
    return found


@cache
def _one_of_each_block(table: type) -> list[tuple[int, bool]]:
    """A column of each block of memory, by its number, and whether it is one of `SIDE_BY_SIDE`."""
    together = side_by_side(table)
    fields: tuple[str, ...] = getattr(table, "_fields")  # noqa: B009, bound to a plain tuple
    kinds = [name in together for name in fields]
    return [(kinds.index(aside), aside) for aside in (False, True) if aside in kinds]


def arrays(table: Any) -> tuple[Any, ...]:
    """The columns of a table as numpy arrays."""
    return tuple(np.asarray(column) for column in table)


def views(table: Table) -> Table:
    """The same table through memoryviews of its arrays."""
    return type(table)(*(memoryview(column) for column in arrays(table)))


def remove_rows(table: Any, row: int, number: int, rows: int) -> None:
    """Close the gap that `number` rows from `row` on leave among the first `rows`."""
    after = row + number
    if after == rows:
        return
    for column in arrays(table):
        column[row : rows - number] = column[after:rows]


def move_row(table: Any, source: int, target: int) -> None:
    """Put a row before an earlier one, or leave it; those between move down."""
    if source == target:
        return
    for column in arrays(table):
        moved = column[source]
        column[target + 1 : source + 1] = column[target:source].copy()
        column[target] = moved


def start_row(table: Any, row: int) -> None:
    """Write zeros to a row of a table of views: what `clear_row` does, all columns at once."""
    for block in _blocks(table):
        block[:, row] = 0


def copy_row(table: Any, source: int, target: int) -> None:
    """Write to row `target` what stands in row `source`. Kernels may call it."""
    for column in table:
        column[target] = column[source]


def clear_row(table: Any, row: int) -> None:
    """Write zeros to a row. Kernels may call it."""
    for column in table:
        column[row] = 0
