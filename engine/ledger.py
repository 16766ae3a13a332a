"""What is in a world's books: momentum and energy, and where they came from and went."""

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from engine.tables import Tables
from engine.validate import shown
from engine.vector import Vector

if TYPE_CHECKING:
    from engine.world import World


class Impulses(NamedTuple):
    """Impulses that bodies received (N s)."""

    gravity: Vector
    """By the world's gravity."""
    pushes: Vector
    """By what `Body.exert` lets act."""
    laws: Vector
    """By laws of force (`World.add_law`)."""
    drag: Vector
    walls: Vector
    """By walls and all that no impulse moves."""
    joints: Vector
    """By joints to fixed points of the world and to what no impulse moves."""
    hand: Vector
    """What adding, removing and setting bodies between ticks brought."""
    integrator: Vector
    """Error of the integrator, where flights begin and end."""

    @property
    def total(self) -> Vector:
        """All together."""
        return Vector(math.fsum(v.x for v in self), math.fsum(v.y for v in self))


class AngularImpulses(NamedTuple):
    """Angular impulses about the origin that bodies received (kg m^2/s)."""

    gravity: float
    """By the world's gravity."""
    pushes: float
    """By what `Body.exert` lets act."""
    laws: float
    """By laws of force (`World.add_law`)."""
    drag: float
    walls: float
    """By walls and all that no impulse moves."""
    joints: float
    """By joints to fixed points of the world and to what no impulse moves."""
    particles: float
    """Less what would turn particles, which never spin: it is lost."""
    corrections: float
    """By moving deep overlaps apart, and by hinges that are torn so far that they pull at both
    anchors."""
    hand: float
    """What adding, removing and setting bodies between ticks brought."""
    integrator: float
    """Error of the integrator, where flights begin and end."""

    @property
    def total(self) -> float:
        """All together."""
        return math.fsum(self)


class Work(NamedTuple):
    """Energy that bodies received (J)."""

    gravity: float
    pushes: float
    laws: float
    walls: float
    """By immovable bodies that move, and by belts (surface speed)."""
    joints: float
    """By motors and springs, less what they and other joints took."""
    hand: float
    integrator: float

    @property
    def total(self) -> float:
        """All together."""
        return math.fsum(self)


class Dissipated(NamedTuple):
    """Energy that bodies lost (J)."""

    restitution: float
    """In impacts, along the normal."""
    friction: float
    """In impacts and in resting contacts, along the surface; rolling resistance too."""
    contact: float
    """In resting contacts, along the normal: what falls flat, less what pushes overlaps apart."""
    drag: float

    @property
    def total(self) -> float:
        """All together."""
        return math.fsum(self)


class Ledger(NamedTuple):
    """The books of a world, from its beginning to now.

    Momentum is the sum of the impulses, angular momentum that of the angular impulses, kinetic
    energy the work less what was dissipated, all to rounding: `momentum_error`,
    `angular_momentum_error` and `energy_error` say what is left. For the change since an earlier
    moment, take a ledger then as well: `later.since(earlier)`.
    """

    time: float
    """Of the world (s)."""
    momentum: Vector
    """Of all bodies (kg m/s)."""
    angular_momentum: float
    """Of all bodies about the origin (kg m^2/s)."""
    kinetic: float
    """Kinetic energy (J)."""
    potential: float
    """Potential energy in gravity and in laws of force (J)."""
    impulses: Impulses
    angular_impulses: AngularImpulses
    work: Work
    dissipated: Dissipated

    @property
    def outside_impulse(self) -> Vector:
        """What the bodies received from outside: forces and walls (N s)."""
        each, total = self.impulses, self.impulses.total
        own = (each.hand, each.integrator)
        return Vector(total.x - sum(v.x for v in own), total.y - sum(v.y for v in own))

    @property
    def outside_angular_impulse(self) -> float:
        """What the bodies received from outside, about the origin: by forces, walls and joints to
        fixed points (kg m^2/s).
        """
        each = self.angular_impulses
        own = (each.particles, each.corrections, each.hand, each.integrator)
        return each.total - math.fsum(own)

    @property
    def momentum_error(self) -> Vector:
        """What the books lack (kg m/s): rounding."""
        total = self.impulses.total
        return Vector(self.momentum.x - total.x, self.momentum.y - total.y)

    @property
    def angular_momentum_error(self) -> float:
        """What the books lack (kg m^2/s): rounding."""
        return self.angular_momentum - self.angular_impulses.total

    @property
    def energy_error(self) -> float:
        """What the books lack (J): rounding."""
        return self.kinetic - (self.work.total - self.dissipated.total)

    def since(self, earlier: "Ledger") -> "Ledger":
        """What changed since an earlier ledger of the same world: each entry less that one's.

        Raises:
            TypeError: for what is no ledger.
        """
        if not isinstance(earlier, Ledger):
            raise TypeError(f"only a Ledger can be compared with, not {shown(earlier)}")
        change: Ledger = _less(self, earlier)
        return change


def ledger(world: "World") -> Ledger:
    """Read the books of a world."""
    books = world.tables.books
    momentum_x, momentum_y, angular_momentum, kinetic = totals(world.tables).tolist()
    names = ("gravity", "push", "field", "drag", "wall", "joint", "hand", "integrator")
    turns = (*names[:6], "particle", "correction", *names[6:])
    works = ("gravity", "push", "field", "wall", "joint", "hand", "integrator")
    heats = ("restitution", "friction", "contact", "drag")
    impulses = [
        Vector(getattr(books, f"{name}_x")[0], getattr(books, f"{name}_y")[0]) for name in names
    ]
    return Ledger(
        time=world.time,
        momentum=Vector(momentum_x, momentum_y),
        angular_momentum=angular_momentum,
        kinetic=kinetic,
        potential=world.potential_energy,
        impulses=Impulses(*impulses),
        angular_impulses=AngularImpulses(*(getattr(books, f"{name}_turn")[0] for name in turns)),
        work=Work(*(getattr(books, f"{name}_work")[0] for name in works)),
        dissipated=Dissipated(*(getattr(books, f"{name}_heat")[0] for name in heats)),
    )


def totals(tables: Tables) -> Any:
    """Momentum (x and y, kg m/s), angular momentum about the origin (kg m^2/s) and kinetic energy
    (J) of all bodies that can be moved.
    """
    count = tables.counts.bodies[0]
    free = np.flatnonzero(np.asarray(tables.bodies.inverse_mass)[:count] > 0.0)

    def column(name: str) -> Any:
        return np.asarray(getattr(tables.bodies, name))[free]

    mass, vx, vy, spin = column("mass"), column("vx"), column("vy"), column("spin")
    inertia = np.where(column("inverse_inertia") > 0.0, column("inertia"), 0.0)
    with np.errstate(over="ignore", invalid="ignore"):  # a world that is about to diverge
        px, py = mass * vx, mass * vy
        energy = (mass * (vx * vx + vy * vy) + inertia * spin * spin) / 2.0
        angular = column("x") * py - column("y") * px + inertia * spin
        return np.array([_sum(each) for each in (px, py, angular, energy)])


def _sum(values: Any) -> float:
    """The sum, rounded once; of what no number can hold, as numpy says."""
    total = float(values.sum())
    return math.fsum(values.tolist()) if math.isfinite(total) else total


def book_hand(tables: Tables, before: Any) -> None:
    """Book what was done between ticks, since the totals were `before`."""
    with np.errstate(invalid="ignore"):
        x, y, turn, work = (totals(tables) - before).tolist()
    tables.books.hand_x[0] += x
    tables.books.hand_y[0] += y
    tables.books.hand_turn[0] += turn
    tables.books.hand_work[0] += work


def _less(later: Any, earlier: Any) -> Any:
    """Each entry less that of an earlier ledger."""
    if isinstance(later, float):
        return later - earlier
    return type(later)(*map(_less, later, earlier))
