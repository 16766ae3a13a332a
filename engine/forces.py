"""What sets bodies in motion: forces, torques, drag, and the handle of a push that acts."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from engine import validate
from engine.inputs import noted_only
from engine.validate import shown

if TYPE_CHECKING:
    from engine.world import World


@dataclass(frozen=True)
class Force:
    """A force (N) in world directions."""

    x: float
    y: float

    def __post_init__(self) -> None:
        """Refuse what is no finite number."""
        object.__setattr__(self, "x", validate.finite(self.x, "force x"))
        object.__setattr__(self, "y", validate.finite(self.y, "force y"))


@dataclass(frozen=True)
class Torque:
    """A torque (N m), counter-clockwise."""

    value: float

    def __post_init__(self) -> None:
        """Refuse what is no finite number."""
        object.__setattr__(self, "value", validate.finite(self.value, "torque"))


@dataclass(frozen=True)
class LinearDrag:
    """A force -k v on the centre of every body; k in kg/s."""

    k: float

    def __post_init__(self) -> None:
        """Refuse what is negative or no finite number."""
        object.__setattr__(self, "k", validate.not_negative(self.k, "drag k"))


@dataclass(frozen=True)
class QuadraticDrag:
    """A force -k |v| v on the centre of every body; k in kg/m."""

    k: float

    def __post_init__(self) -> None:
        """Refuse what is negative or no finite number."""
        object.__setattr__(self, "k", validate.not_negative(self.k, "drag k"))


Drag = LinearDrag | QuadraticDrag
"""Either law of drag."""


def components(effort: Force | Torque) -> tuple[float, float, float]:
    """Force (x and y, N) and torque (N m) of what is exerted.

    Raises:
        TypeError: for what is neither a force nor a torque.
    """
    if isinstance(effort, Force):
        return effort.x, effort.y, 0.0
    if isinstance(effort, Torque):
        return 0.0, 0.0, effort.value
    raise TypeError(f"only a Force or a Torque can be exerted, not {shown(effort)}")


class Push:
    """A force or torque that acts on a body, until its time is over or it is stopped."""

    __slots__ = ("_id", "_world")

    def __init__(self, world: "World", id: int) -> None:
        """Made by `Body.exert`."""
        self._world = world
        self._id = id

    def __repr__(self) -> str:
        """Say which push it is and whether it acts."""
        return f"<Push {self.id}, {'active' if self.active else 'over'}>"

    @property
    def id(self) -> int:
        """None is used twice."""
        return self._id

    @property
    def active(self) -> bool:
        """Whether it will act in the next tick."""
        return self._world.is_acting(self.id)

    @noted_only
    def change(self, effort: Force | Torque) -> None:
        """Exert another force or torque from the next tick on: there, and as long as it lasts.

        Raises:
            ValueError: if the push is over.
        """
        x, y, torque = components(effort)
        self._world.change_push(self.id, x, y, torque)

    @noted_only
    def stop(self) -> None:
        """End it now; to stop it twice, or after its time, does nothing."""
        self._world.stop(self.id)
