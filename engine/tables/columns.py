"""Columns of numbers, and what can be done to any table of them."""

from typing import Any, Protocol, TypeVar, get_type_hints

import numpy as np

LINE = 8
"""Numbers in a line of a processor's cache."""


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
    the cache of a processor.
    """
    fields: tuple[str, ...] = getattr(table, "_fields")  # noqa: B009, bound to a plain tuple
    kinds = get_type_hints(table)
    lines = (rows + LINE - 1) // LINE | 1
    block = np.zeros((len(fields), lines * LINE), np.int64)
    columns = [
        column[:rows] if kinds[name] is Ints else column[:rows].view(np.float64)
        for name, column in zip(fields, block, strict=True)
    ]
    return table(*columns)


def grow(table: Table, rows: int) -> Table:
    """Copy a table into one with room for `rows`."""
    larger = allocate(type(table), rows)
    for old, new in zip(arrays(table), arrays(larger), strict=True):
        new[: len(old)] = old
    return larger


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


def sort_rows(table: Any, rows: int) -> None:
    """Sort the first `rows` by the first column, then the second and so on."""
    columns = [column[:rows] for column in arrays(table)]
    order = np.lexsort(columns[::-1])
    for column in columns:
        column[:] = column[order]


def copy_row(table: Any, source: int, target: int) -> None:
    """Write to row `target` what stands in row `source`. Kernels may call it."""
    for column in table:
        column[target] = column[source]


def clear_row(table: Any, row: int) -> None:
    """Write zeros to a row. Kernels may call it."""
    for column in table:
        column[row] = 0
