"""A store of what was drawn before, bounded in bytes; what was used longest ago goes first."""

from collections import OrderedDict
from collections.abc import Callable, Hashable
from typing import Generic, TypeVar

Value = TypeVar("Value")


class Cache(Generic[Value]):
    """Keeps values by key as long as their sizes sum to at most `limit` bytes."""

    def __init__(self, limit: int) -> None:
        """Start empty."""
        self.limit = limit
        self.size = 0
        self._held: OrderedDict[Hashable, tuple[Value, int]] = OrderedDict()

    def __len__(self) -> int:
        """How many values are held."""
        return len(self._held)

    def get(
        self, key: Hashable, make: Callable[[], Value], size_of: Callable[[Value], int]
    ) -> Value:
        """The value of `key`; `make` makes it if it is not held, `size_of` tells its bytes."""
        held = self._held.get(key)
        if held is not None:
            self._held.move_to_end(key)
            return held[0]
        value = make()
        size = size_of(value)
        if size <= self.limit:
            self._held[key] = (value, size)
            self.size += size
            while self.size > self.limit:
                self.size -= self._held.popitem(last=False)[1][1]
        return value
