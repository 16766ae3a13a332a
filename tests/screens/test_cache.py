"""The cache keeps within its bound and drops what was used longest ago."""

from hypothesis import given
from hypothesis import strategies as st

from screens.kit.cache import Cache


def test_what_was_used_longest_ago_goes_first():
    cache: Cache[str] = Cache(30)
    for key in "abc":
        cache.keep(key, key.upper(), 10)
    assert cache.find("a") == "A"
    cache.keep("d", "D", 10)
    assert [cache.find(key) for key in "abcd"] == ["A", None, "C", "D"]


def test_what_is_larger_than_all_the_room_is_not_kept():
    cache: Cache[int] = Cache(30)
    cache.keep("small", 1, 10)
    assert cache.keep("large", 2, 31) == 2
    assert (cache.find("small"), cache.find("large")) == (1, None)


@given(st.lists(st.tuples(st.integers(0, 9), st.integers(0, 40))))
def test_sizes_sum_up_and_stay_within_the_bound(steps):
    cache: Cache[int] = Cache(100)
    sizes: dict[int, int] = {}
    for key, size in steps:
        cache.keep(key, size, size)
        sizes[key] = size
        held = {k: v for k, v in sizes.items() if cache.find(k) is not None}
        assert cache.size == sum(held.values()) <= 100
        assert len(cache) == len(held)
