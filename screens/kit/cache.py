"""A store of what was drawn before, bounded in bytes; what was used longest ago goes first."""

from collections import OrderedDict
from collections.abc import Hashable
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

    def find(self, key: Hashable) -> Value | None:
        """The value of `key`, or None if it is not held."""
        held = self._held.get(key)
        if held is None:
            return None
        self._held.move_to_end(key)
        return held[0]

    def keep(self, key: Hashable, value: Value, size: int) -> Value:
        """Hold a value of `size` bytes, unless it is larger than all the room; returns it."""
        if size <= self.limit:
            before = self._held.pop(key, None)
            self.size += size - (before[1] if before else 0)
            self._held[key] = (value, size)
            while self.size > self.limit:
                self.size -= self._held.popitem(last=False)[1][1]
        return value
