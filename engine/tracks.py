"""What many ticks in one call record."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from engine import validate
from engine.body import Body
from engine.collision import Collision
from engine.validate import shown


@dataclass(frozen=True)
class Tracks:
    """What `World.run` recorded: a row a moment, a column a body."""

    times: Any
    """Array (ticks + 1,): time of the world (s), the start first."""
    ids: Any
    """Array (bodies,): the bodies that were there at the start, in order."""
    columns: dict[str, Any]
    """For each recorded name an array (ticks + 1, bodies); NaN once a body is removed."""
    collisions: tuple[Collision, ...]
    """In order of time, if they were asked for."""
    collision_count: int
    """How many there were, asked for or not."""

    def __repr__(self) -> str:
        """Say of how many ticks and bodies they are, and what was recorded."""
        names = ", ".join(self.columns) or "nothing"
        return f"<Tracks: {len(self.times) - 1} ticks of {len(self.ids)} bodies, {names}>"

    def keys(self) -> Iterable[str]:
        """The recorded names: so `dict(tracks)` makes a dictionary of all arrays."""
        return self.columns.keys()

    def __getitem__(self, name: str) -> Any:
        """One recorded name: an array (ticks + 1, bodies)."""
        if name not in self.columns:
            raise KeyError(
                f"{shown(name)} was not recorded, only {', '.join(self.columns) or 'nothing'}"
            )
        return self.columns[name]

    def __iter__(self) -> Iterator[str]:
        """The recorded names."""
        return iter(self.columns)

    def of(self, body: Body | int) -> dict[str, Any]:
        """The columns of one body, or of that with this id, by name: arrays (ticks + 1,).

        Raises:
            LookupError: if it was not there at the start.
        """
        id = body.id if isinstance(body, Body) else validate.identity(body, "a body")
        place = np.flatnonzero(self.ids == id)
        if not len(place):
            raise LookupError(f"there is no body {id} in these tracks")
        return {name: column[:, place[0]] for name, column in self.columns.items()}
