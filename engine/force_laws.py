"""Laws of force that act all the time: gravity of a point, springs to a point, Python functions."""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from engine import validate
from engine.body import Body
from engine.collision import Removed
from engine.forces import Force, Torque
from engine.inputs import noted
from engine.tables import Fields, allocate, views
from engine.tables.bodies import EVERY_BODY, GIVEN, POINT_GRAVITY, SPRING_TO
from engine.validate import shown
from engine.vector import Vector

if TYPE_CHECKING:
    from engine.world import World


@dataclass(frozen=True)
class PointGravity:
    """Newton's gravity of a mass that is fixed at a point: a = -mu r / |r|^3.

    Raises:
        TypeError, ValueError: for what is no point or no finite number, and a negative softening.
    """

    at: Vector
    """Where the mass is (m, world)."""
    mu: float
    """Standard gravitational parameter G M (m^3/s^2); a negative one repels."""
    softening: float = 0.0
    """Length eps (m) in a = -mu r / (r^2 + eps^2)^(3/2) (Plummer, 1911), which has no pole."""

    def __init__(self, at: Any, mu: float, softening: float = 0.0) -> None:
        """Take the place of the mass as a pair (m, world)."""
        object.__setattr__(self, "at", validate.vector(at, "at"))
        object.__setattr__(self, "mu", validate.finite(mu, "mu"))
        object.__setattr__(self, "softening", validate.not_negative(softening, "softening"))

    def energy(self, mass: float, position: Vector) -> float:
        """Potential energy of a mass (kg) at a position (m, world), zero at infinity (J)."""
        x, y = position.x - self.at.x, position.y - self.at.y
        distance = math.sqrt(x * x + y * y + self.softening * self.softening)
        return -mass * self.mu / distance if distance > 0.0 else -math.inf


@dataclass(frozen=True)
class SpringTo:
    """A spring without natural length from a body's centre to a point: F = -k r - c v.

    Raises:
        TypeError, ValueError: for what is no point or no finite number, and for negative numbers.
    """

    at: Vector
    """Where the spring is fixed (m, world)."""
    stiffness: float
    """k (N/m)."""
    damping: float = 0.0
    """c (N s/m), against the velocity in any direction."""

    def __init__(self, at: Any, stiffness: float, damping: float = 0.0) -> None:
        """Take the point as a pair (m, world)."""
        object.__setattr__(self, "at", validate.vector(at, "at"))
        object.__setattr__(self, "stiffness", validate.not_negative(stiffness, "stiffness"))
        object.__setattr__(self, "damping", validate.not_negative(damping, "damping"))

    def energy(self, mass: float, position: Vector) -> float:
        """Potential energy of a body at a position (m, world), zero at the fixed point (J)."""
        del mass
        x, y = position.x - self.at.x, position.y - self.at.y
        return self.stiffness * (x * x + y * y) / 2.0


PythonForce = Callable[[Body, float], Any]
"""A function of a body and the time (s) that returns the force on its centre: a `Force`, a
`Torque`, (fx, fy), (fx, fy, torque) or None."""

Law = PointGravity | SpringTo | PythonForce


class ActingLaw:
    """A law of force that acts in a world until it is removed."""

    __slots__ = ("_bodies", "_id", "_law", "_world")

    def __init__(self, world: "World", id: int, law: Law, bodies: tuple[Body, ...] | None) -> None:
        """Made by `World.add_law`."""
        self._world = world
        self._id = id
        self._law = law
        self._bodies = bodies

    def __repr__(self) -> str:
        """Say which law it is and on what it acts."""
        on = "all bodies" if self.bodies is None else ", ".join(body.name for body in self.bodies)
        return f"<ActingLaw {self.id}: {self.law} on {on}>"

    def __reduce__(self) -> Any:
        """Copy and pickle it with its world, as the law of this id."""
        return law_of, (self._world, self._id)

    @property
    def id(self) -> int:
        """None is used twice."""
        return self._id

    @property
    def law(self) -> Law:
        """What acts."""
        return self._law

    @property
    def bodies(self) -> tuple[Body, ...] | None:
        """On which it acts; None: on all."""
        return self._bodies

    @property
    def active(self) -> bool:
        """Whether it acts."""
        return self in self._world.force_laws

    @property
    def is_python(self) -> bool:
        """Whether it is a Python function."""
        return not isinstance(self.law, PointGravity | SpringTo)

    @noted
    def remove(self) -> None:
        """Let it act no more; to remove it twice does nothing."""
        self._world.store.remove_law(self)


def law_of(world: "World", id: int) -> ActingLaw:
    """The law with this id that acts in a world.

    Raises:
        Removed: (a LookupError) if there is none.
    """
    if id not in world.store.acting:
        raise Removed(f"there is no law {id} in this world")
    return world.store.acting[id]


def checked_law(law: Any) -> Law:
    """Refuse what is no law of force.

    Raises:
        TypeError: in one sentence that names it.
    """
    built_in = isinstance(law, PointGravity | SpringTo)
    if not built_in and (isinstance(law, type) or not callable(law)):
        raise TypeError(f"a law is a PointGravity, a SpringTo or a function, not {shown(law)}")
    checked: Law = law
    return checked


def checked_bodies(world: "World", bodies: Any) -> tuple[Body, ...] | None:
    """The bodies that were named, in order of ids, each once; None if none were.

    Raises:
        TypeError: for what is no body.
        ValueError: for a body that is not dynamic.
        Removed: (a LookupError) for a body that is not in the world.
    """
    if bodies is None:
        return None
    if isinstance(bodies, Body) or not isinstance(bodies, Iterable):
        raise TypeError(f"bodies must be a list of bodies or None, not {shown(bodies)}")
    chosen: dict[int, Body] = {}
    for body in bodies:
        if not isinstance(body, Body):
            raise TypeError(f"a law acts on bodies, not on {shown(body)}")
        world.row(body)
        if not body.is_dynamic:
            raise ValueError(f"{body.name} is {body.kind}: it takes no law of force")
        chosen[body.id] = body
    return tuple(chosen[id] for id in sorted(chosen))


def field_table(
    acting: Sequence[ActingLaw], rows: dict[int, int], handles: Sequence[Body]
) -> Fields:
    """List which law acts on which row: first what acts on all, then by bodies, then by laws.

    Args:
        acting: the laws, in order of ids.
        rows: row in `Bodies` of each id.
        handles: the body of each row.
    """
    listed: list[tuple[int, int, Law]] = []
    for each in acting:
        if each.bodies is not None:
            listed += [(rows[b.id], each.id, each.law) for b in each.bodies if b.id in rows]
        elif each.is_python:
            movable = [i for i, body in enumerate(handles) if body.is_dynamic]
            listed += [(row, each.id, each.law) for row in movable]
        else:
            listed.append((EVERY_BODY, each.id, each.law))
    listed.sort(key=lambda entry: entry[:2])
    fields = allocate(Fields, max(1, len(listed)))
    for i, (row, id, law) in enumerate(listed):
        columns: tuple[Any, ...] = fields
        for column, value in zip(columns, (id, row, *_columns(law)), strict=False):
            column[i] = value
    fields.used[0] = len(listed)
    return views(fields)


def _columns(law: Law) -> tuple[float, ...]:
    """Columns of `Fields` from `kind` on; the others are zero."""
    if isinstance(law, PointGravity):
        return POINT_GRAVITY, *law.at, law.mu, 0.0, law.softening
    if isinstance(law, SpringTo):
        return SPRING_TO, *law.at, law.stiffness, law.damping
    return (GIVEN,)


def effort(returned: Any, law: ActingLaw) -> tuple[float, float, float]:
    """Force and torque (N, N, N m) from what a Python function returned.

    Raises:
        TypeError, ValueError: if it is none of what `PythonForce` says.
    """
    if returned is None:
        return 0.0, 0.0, 0.0
    if isinstance(returned, Force):
        return returned.x, returned.y, 0.0
    if isinstance(returned, Torque):
        return 0.0, 0.0, returned.value
    if not isinstance(returned, tuple) or len(returned) not in (2, 3):
        raise TypeError(
            f"{shown(law.law)} must return a Force, a Torque, (fx, fy), (fx, fy, torque) or None, "
            f"not {shown(returned)}"
        )
    force = validate.vector(returned[:2], "the force of a law")
    turning = validate.finite(returned[2], "the torque of a law") if len(returned) == 3 else 0.0
    return force.x, force.y, turning


def field_columns(fields: Fields) -> list[Any]:
    """Copies of what tells the laws of two worlds apart, for the digest; nothing where none acts.

    Python functions are left out, as callbacks are.
    """
    used = fields.used[0]
    built_in = np.asarray(fields.kind)[:used] != GIVEN
    if not built_in.any():
        return []
    names = ("law", "row", "kind", "x", "y", "strength", "damping", "softening")
    return [np.asarray(getattr(fields, name))[:used][built_in] for name in names]


def energy_in_fields(acting: Iterable[ActingLaw], movable: Sequence[Body]) -> list[float]:
    """Potential energy of each body in each built-in law that acts on it (J)."""
    present = set(movable)
    return [
        each.law.energy(body.mass, body.position)
        for each in acting
        if isinstance(each.law, PointGravity | SpringTo)
        for body in (movable if each.bodies is None else each.bodies)
        if body in present
    ]
