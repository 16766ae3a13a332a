"""Memory that is lent: a slot is free again once nobody holds its picture, or any part of it."""

import os
from collections.abc import Iterator

import numpy as np
import pytest

from app.frames import Film
from app.outputs.slots import FEWEST, MOST, ROOM, Lender, filled_by_us, new_memory, slots_for


@pytest.fixture
def memory() -> Iterator[int]:
    descriptor = new_memory()
    yield descriptor
    os.close(descriptor)


def test_what_one_side_fills_the_other_reads(memory: int, film: Film) -> None:
    slots = filled_by_us(memory, film)
    lender = Lender(memory, film)
    assert slots.shape == (MOST, film.height, film.width)
    for slot in range(MOST):
        slots[slot] = np.arange(slot, slot + slots[slot].size).reshape(slots[slot].shape)
        assert np.array_equal(lender.lend(slot), slots[slot])
    with pytest.raises(ValueError, match="read-only"):
        lender.lend(0)[0, 0] = 1


def test_a_slot_comes_back_once_nobody_holds_it(memory: int, film: Film) -> None:
    filled_by_us(memory, film)
    lender = Lender(memory, film)
    first, second = lender.lend(0), lender.lend(1)
    assert lender.given_back() == []
    del second
    assert lender.given_back() == [1]
    assert lender.given_back() == []
    part = first[3:5].view(np.uint64)
    del first
    assert lender.given_back() == []
    del part
    assert lender.given_back() == [0]


def test_slots_of_an_earlier_film_are_no_business_of_the_next(memory: int, film: Film) -> None:
    filled_by_us(memory, film)
    held = Lender(memory, film).lend(0)
    filled_by_us(memory, Film(16, 16, 30, "Another"))
    lender = Lender(memory, Film(16, 16, 30, "Another"))
    del held
    assert lender.given_back() == []


def test_large_pictures_have_fewer_slots() -> None:
    shares = [slots_for(Film(width, width, 30, "")) for width in (16, 2000, 8192)]
    assert shares == [MOST, ROOM // (4 * 2000 * 2000), FEWEST]
