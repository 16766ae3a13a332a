"""What a step reports."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple, overload

from engine.tables import Impacts
from engine.vector import Vector

if TYPE_CHECKING:
    from engine.body import Body


_row = tuple.__new__
"""Makes named tuples in half the time that their classes take."""


class Collision(NamedTuple):
    """One impact of two bodies: they met with some speed and were turned back."""

    a: "Body"
    b: "Body"
    point: Vector
    """Where they touched (m, world)."""
    normal: Vector
    """Unit vector from a to b."""
    impulse: Vector
    """What b received (N s, world); a received its exact opposite."""
    speed: float
    """With which they approached each other along the normal, before (m/s, >= 0)."""
    restitution: float
    """Of the pair, 0..1."""
    time: float
    """Of the impact (s, time of the world)."""


FEW = 8
"""So many are made at once."""


class Collisions(Sequence[Collision]):
    """What happened in a step, in order of time: as a list, but that it cannot be changed.

    Where there are many, they are made when somebody reads the first: thousands of objects a second
    that nobody looks at would cost as much as the physics of a heap that lands.
    """

    __slots__ = ("_made", "_make", "_number")

    def __init__(
        self,
        made: list[Collision] | None,
        number: int = 0,
        make: Callable[[], list[Collision]] = list,
    ) -> None:
        """Keep those that are `made`, or if that is None so many that `make` will make."""
        self._made = made
        self._number = number if made is None else len(made)
        self._make = make

    def __len__(self) -> int:
        """How many there are."""
        return self._number

    def __iter__(self) -> Iterator[Collision]:
        """One after another."""
        return iter(self._all())

    @overload
    def __getitem__(self, at: int) -> Collision: ...

    @overload
    def __getitem__(self, at: slice) -> list[Collision]: ...

    def __getitem__(self, at: int | slice) -> Collision | list[Collision]:
        """One of them, or several."""
        return self._all()[at]

    def __add__(self, others: Iterable[Collision]) -> list[Collision]:
        """These, then others."""
        return [*self._all(), *others]

    def __radd__(self, others: Iterable[Collision]) -> list[Collision]:
        """Others, then these."""
        return [*others, *self._all()]

    def __eq__(self, other: object) -> bool:
        """Whether a list, or what another step returned, holds the same."""
        if isinstance(other, Collisions | list):
            return self._all() == list(other)
        return NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        """As that of a list."""
        return repr(self._all())

    def _all(self) -> list[Collision]:
        """All of them, made if they are not yet."""
        if self._made is None:
            self._made = self._make()
            self._make = list
        return self._made


NONE = Collisions([])
"""Nothing happened."""


def read(impacts: Impacts, handles: Sequence["Body"]) -> Collisions:
    """Turn the table of impacts into collisions and empty it.

    Args:
        impacts: the table, with times of the world.
        handles: the bodies in order of their rows.
    """
    number = impacts.written[0]
    impacts.written[0] = 0
    if number <= FEW:
        return Collisions(_made(impacts, handles, number))
    columns = [_copy(column, number) for column in impacts]
    return Collisions(None, number, partial(_made, columns, list(handles), number))


def _copy(column: Any, number: int) -> Any:
    """The first numbers of a column, which is a memoryview, as another."""
    return memoryview(bytes(column[:number])).cast(column.format)


def _made(columns: Sequence[Any], handles: Sequence["Body"], number: int) -> list[Collision]:
    """Turn the first rows of a table of impacts into collisions."""
    a, b, x, y, normal_x, normal_y, impulse_x, impulse_y, speed, restitution, time, _ = columns
    return [
        _row(
            Collision,
            (
                handles[a[i]],
                handles[b[i]],
                _row(Vector, (x[i], y[i])),
                _row(Vector, (normal_x[i], normal_y[i])),
                _row(Vector, (impulse_x[i], impulse_y[i])),
                speed[i],
                restitution[i],
                time[i],
            ),
        )
        for i in range(number)
    ]


class Diverged(ArithmeticError):
    """A body left the range of numbers; the sentence names it and the tick, the first being 1."""


class Removed(LookupError):
    """A body was used after it had been removed from its world."""
