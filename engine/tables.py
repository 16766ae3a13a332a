"""All that varies in a world, as tables of one-dimensional columns, one row a thing.

Kernels read and write the columns by index. They are numpy arrays for compiled kernels and for
bulk work, and memoryviews of the same arrays for interpreted kernels (twice as fast to index).
"""

from typing import Any, NamedTuple, Protocol, TypeVar, get_type_hints

import numpy as np


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


class Bodies(NamedTuple):
    """One row a body, in the order of their ids. World frame, SI units."""

    id: Ints
    x: Floats
    """Centre of mass (m); 0 for a wall, whose vertices are in world coordinates."""
    y: Floats
    angle: Floats
    """Counter-clockwise (rad)."""
    vx: Floats
    """(m/s). Within a tick: the velocity of the pose at `clock`."""
    vy: Floats
    spin: Floats
    """(rad/s)"""
    mass: Floats
    """(kg); infinite for a wall."""
    inverse_mass: Floats
    """(1/kg); 0 makes a body immovable."""
    inertia: Floats
    """(kg m^2); infinite for walls and particles."""
    inverse_inertia: Floats
    """(1/(kg m^2)); 0 keeps a body from turning."""
    restitution: Floats
    friction: Floats
    force_x: Floats
    """What acted during the last tick, contacts apart, as its mean over the tick (N)."""
    force_y: Floats
    torque: Floats
    """(N m)"""
    held: Ints
    """Number of resting contacts at the end of the last tick."""

    first: Ints
    """First row in `Corners`."""
    corners: Ints
    """Number of rows in `Corners`: 1 for round bodies, 2 for walls, 3 and more for polygons."""
    radius: Floats
    """By which the hull of the corners is rounded (m): that of circles and particles."""
    reach: Floats
    """Radius of the bounding circle about the centre (m)."""
    inner: Floats
    """Radius of a circle that fits inside (m); 0 for walls."""
    one_sided: Ints
    """1 for a wall that stops only what comes from its positive side."""

    ax: Floats
    """Mean acceleration of this tick by pushes, gravity and drag (m/s^2)."""
    ay: Floats
    aspin: Floats
    """(rad/s^2)"""
    lead_x: Floats
    """Velocity of the position minus the reported velocity, by the integrator (m/s)."""
    lead_y: Floats
    lead_spin: Floats
    """(rad/s)"""
    clock: Floats
    """Time inside the present part of the tick for which pose and velocity hold (s)."""
    path_x: Floats
    """Acceleration along the path in the present part of the tick, contacts included (m/s^2)."""
    path_y: Floats
    path_spin: Floats
    """(rad/s^2)"""
    busy: Ints
    """Number of resting contacts in the present part of the tick."""
    low_x: Floats
    """Box in which the body may move while the list of pairs holds (m)."""
    low_y: Floats
    high_x: Floats
    high_y: Floats
    order: Ints
    """Rows sorted by `low_x`."""


class Corners(NamedTuple):
    """Corners of all bodies, those of one body in sequence, counter-clockwise."""

    x: Floats
    """In the body's frame (m)."""
    y: Floats
    normal_x: Floats
    """Unit outward normal of the side from this corner to the next, in the body's frame."""
    normal_y: Floats
    world_x: Floats
    """In the world, for the pose for which the body was last placed (m)."""
    world_y: Floats
    world_normal_x: Floats
    world_normal_y: Floats


class Pushes(NamedTuple):
    """One row a force or torque that acts."""

    id: Ints
    row: Ints
    """Of the body."""
    x: Floats
    """Force (N, world)."""
    y: Floats
    torque: Floats
    """(N m)"""
    at_x: Floats
    """Point of attack in the body's frame (m)."""
    at_y: Floats
    left: Floats
    """Time it still lasts (s); infinite until it is stopped."""


Table = TypeVar("Table", bound=tuple[Any, ...])


def allocate(table: type[Table], rows: int) -> Table:
    """Make a table of zeros with room for `rows`."""
    fields: tuple[str, ...] = getattr(table, "_fields")  # noqa: B009, bound to a plain tuple
    kinds = get_type_hints(table)
    columns = [
        np.zeros(rows, dtype=np.int64 if kinds[name] is Ints else np.float64) for name in fields
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


def remove_row(table: Any, row: int, rows: int) -> None:
    """Close the gap that `row` leaves among the first `rows`."""
    for column in arrays(table):
        column[row : rows - 1] = column[row + 1 : rows]
