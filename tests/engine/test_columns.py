"""How tables lie in memory: columns apart, but for those that kernels read together."""

import numpy as np
import pytest

from engine.tables import (
    Bodies,
    Contacts,
    Joints,
    Pairs,
    allocate,
    arrays,
    clear_row,
    grow,
    move_row,
    side_by_side,
    start_row,
    views,
)


@pytest.mark.parametrize("kind", [Bodies, Pairs, Contacts])
def test_every_number_has_a_place_of_its_own(kind: type) -> None:
    table = allocate(kind, 5)
    for i, column in enumerate(arrays(table)):
        column[:] = 10 * i + np.arange(5)
    for i, column in enumerate(arrays(grow(table, 9))):
        assert list(column) == [10 * i + row for row in range(5)] + [0] * 4


@pytest.mark.parametrize("kind", [Pairs, Contacts])
def test_what_is_read_together_lies_side_by_side(kind: type) -> None:
    table = views(allocate(kind, 5))
    together = side_by_side(kind)
    first = np.asarray(getattr(table, together[0])).ctypes.data
    for i, name in enumerate(together):
        column = np.asarray(getattr(table, name))
        assert column.ctypes.data == first + 8 * i
        assert column.strides == (8 * len(together),)


def test_other_columns_are_whole() -> None:
    assert side_by_side(Bodies) == ()
    assert all(column.strides == (8,) for column in arrays(allocate(Bodies, 5)))


@pytest.mark.parametrize("kind", [Bodies, Joints, Contacts])
def test_a_row_is_started_as_kernels_clear_it(kind: type) -> None:
    one, other = views(allocate(kind, 5)), views(allocate(kind, 5))
    for table in (one, other):
        for i, column in enumerate(arrays(table)):
            column[:] = 10 * i + np.arange(5)
    start_row(one, 3)
    clear_row(other, 3)
    assert [list(column) for column in one] == [list(column) for column in other]


@pytest.mark.parametrize(("source", "target"), [(4, 1), (2, 2), (3, 2), (4, 0)])
def test_a_row_moves_before_an_earlier_one(source: int, target: int) -> None:
    table = views(allocate(Contacts, 5))
    for column in arrays(table):
        column[:] = np.arange(5)
    move_row(table, source, target)
    expected = [row for row in range(5) if row != source]
    expected.insert(target, source)
    assert all(list(column) == expected for column in arrays(table))
