"""Memory that processes share: a place is used again once nobody holds its picture."""

import os
from collections.abc import Iterator

import numpy as np
import pytest

from app.frames import Film, Pixels
from app.outputs.shared import FEWEST, MOST, ROOM, Lender, Memory, most_waiting

SHAPE = (48, 64)
FILM = Film(64, 48, 30, "Film")


@pytest.fixture
def memory() -> Iterator[Memory]:
    memory = Memory()
    yield memory
    os.close(memory.descriptor)


def painted(memory: Memory, value: int) -> tuple[int, Pixels]:
    """A finished picture of one colour, and its place."""
    pixels = memory.new(SHAPE)
    pixels[:] = value
    pixels.flags.writeable = False
    place = memory.place(pixels)
    assert place is not None
    return place, pixels


def size(memory: Memory) -> int:
    return os.fstat(memory.descriptor).st_size


def test_what_one_side_paints_the_other_reads(memory: Memory) -> None:
    pictures = [painted(memory, value) for value in range(MOST)]
    lender = Lender(memory.descriptor, FILM)
    for place, pixels in pictures:
        assert np.array_equal(lender.lend(place), pixels)
    with pytest.raises(ValueError, match="read-only"):
        lender.lend(pictures[0][0])[0, 0] = 1


def test_only_a_finished_picture_of_this_memory_has_a_place(memory: Memory) -> None:
    pixels = memory.new(SHAPE)
    assert memory.place(pixels) is None
    pixels.flags.writeable = False
    assert memory.place(pixels) is not None
    assert memory.place(pixels[1:]) is None
    assert memory.place(pixels[:, :32]) is None
    other = np.zeros(SHAPE, np.uint32)
    other.flags.writeable = False
    assert memory.place(other) is None


def test_a_place_is_used_again_once_nobody_holds_its_picture(memory: Memory) -> None:
    place, pixels = painted(memory, 1)
    _, other = painted(memory, 2)
    part = pixels[3:5].view(np.uint64)
    del pixels
    assert painted(memory, 3)[0] != place
    del part
    assert painted(memory, 4)[0] == place
    assert (other == 2).all()


def test_pictures_of_another_size_get_places_of_their_own(memory: Memory) -> None:
    place, pixels = painted(memory, 1)
    _, held = painted(memory, 2)
    del pixels
    large = memory.new((480, 640))
    large[:] = 3
    assert (held == 2).all()
    assert painted(memory, 4)[0] == place


def test_the_memory_of_the_last_picture_is_given_back(memory: Memory) -> None:
    pictures = [painted(memory, value) for value in range(4)]
    assert size(memory) >= 4 * pictures[0][1].nbytes
    del pictures[1:]
    assert size(memory) > 0
    del pictures[:]
    assert size(memory) == 0
    assert painted(memory, 9)[0] == 0


def test_where_there_is_no_room_no_place_is_lost(
    memory: Memory, monkeypatch: pytest.MonkeyPatch
) -> None:
    place, pixels = painted(memory, 1)
    _, held = painted(memory, 2)
    del pixels

    def no_room(*_: object, **__: object) -> None:
        raise OSError("Cannot allocate memory")

    with monkeypatch.context() as patch:
        patch.setattr("app.outputs.shared.mmap.mmap", no_room)
        with pytest.raises(OSError, match="Cannot allocate"):
            memory.new(SHAPE)
    assert painted(memory, 3)[0] == place
    del held
    assert size(memory) == 0


def test_a_picture_comes_back_once_nobody_holds_it(memory: Memory) -> None:
    pictures = [painted(memory, value) for value in range(2)]
    lender = Lender(memory.descriptor, FILM)
    first, second = (lender.lend(place) for place, _ in pictures)
    again = lender.lend(pictures[0][0])
    assert lender.given_back() == []
    del second
    assert lender.given_back() == [pictures[1][0]]
    assert lender.given_back() == []
    part = first[3:5].view(np.uint64)
    del first
    assert lender.given_back() == []
    del again
    assert lender.given_back() == [pictures[0][0]]
    del part
    assert lender.given_back() == [pictures[0][0]]


def test_pictures_of_an_earlier_film_are_no_business_of_the_next(memory: Memory) -> None:
    place, _pixels = painted(memory, 1)
    held = Lender(memory.descriptor, FILM).lend(place)
    lender = Lender(memory.descriptor, FILM)
    del held
    assert lender.given_back() == []


def test_of_large_pictures_fewer_may_wait() -> None:
    shares = [most_waiting(Film(width, width, 30, "")) for width in (16, 2000, 8192)]
    assert shares == [MOST, ROOM // (4 * 2000 * 2000), FEWEST]
