"""The room in which bodies move."""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from engine import snapshot as snapshots
from engine import validate
from engine.body import Body, OnCollision, OnMove
from engine.collision import Collision, Diverged, Removed
from engine.enrol import initial_values, refill, write_body
from engine.forces import Drag, Push
from engine.jit import choose
from engine.pairing import as_arrays, forget, link, pair_up, resting_columns
from engine.settings import TICK, Rule, geometric_mean, larger, laws
from engine.shapes import Shape
from engine.snapshot import Snapshot
from engine.tables import (
    Bodies,
    Contacts,
    Corners,
    Impacts,
    Links,
    Pairs,
    Pushes,
    Tables,
    Touch,
    allocate,
    arrays,
    grow,
    remove_row,
    views,
)
from engine.tick import SOUND
from engine.travel import ESCAPED
from engine.vector import Vector

IMPACTS_AT_ONCE = 4096
"""Rows of the table of impacts; after so many in one tick the kernel pauses to have it emptied."""


class World:
    """A room of rigid bodies that obeys Newton's laws, one tick at a time.

    Args:
        gravity: acceleration that every body feels (m/s^2).
        drag: `LinearDrag`, `QuadraticDrag` or None.
        integrator: "semi-implicit-euler", "velocity-verlet", "explicit-euler" or "rk4".
        substeps: into how many parts a tick is divided for bodies that rest on each other.
        restitution_rule: makes the restitution of a pair from those of its two bodies; None:
            the larger.
        friction_rule: the same for friction; None: the geometric mean.
        kernels: "interpreted", "compiled" (by numba) or "auto", which the environment variable
            LAWS_KERNELS decides; all give the same bits.
    """

    def __init__(
        self,
        gravity: Any = (0.0, 0.0),
        drag: Drag | None = None,
        integrator: str = "semi-implicit-euler",
        substeps: int = 6,
        restitution_rule: Rule | None = None,
        friction_rule: Rule | None = None,
        kernels: str = "auto",
    ) -> None:
        self.laws = laws(gravity, drag, integrator, substeps)
        self.restitution_rule = restitution_rule or larger
        self.friction_rule = friction_rule or geometric_mean
        self.tick = 0
        """Number of steps taken."""
        self._count = 0
        self._corner_count = 0
        self._push_count = 0
        self._next_body = 1
        self._next_push = 1
        self._clock = (0.0, 0, 0.0)  # time = base + ticks * dt, so that sixty ticks are 1 s
        self._handles: dict[int, Body] = {}
        self._rows: dict[int, int] = {}
        self._kernels = choose(kernels)
        self._stale = True
        self._pair_count = 0
        self.tables = Tables(
            bodies=views(allocate(Bodies, 16)),
            corners=views(allocate(Corners, 64)),
            pairs=views(allocate(Pairs, 64)),
            contacts=views(allocate(Contacts, 128)),
            links=views(allocate(Links, 1)),
            touch=views(allocate(Touch, 2)),
            impacts=views(allocate(Impacts, IMPACTS_AT_ONCE)),
        )
        self.pushes = views(allocate(Pushes, 8))
        self._arrays_of = self._arrays = self.tables

    def step(self, dt: float = TICK) -> list[Collision]:
        """Advance by `dt` seconds; return the collisions that happened, in order of time.

        Nothing calls back from inside. Same tables in, same tables out.

        Raises:
            Diverged: when a body left the range of numbers; the world is then of no more use.
        """
        dt = validate.positive(dt, "dt")
        watched = self._where_callbacks_look()
        pairs_hold = self._accelerate(dt)
        if not pairs_hold:
            self._find_pairs(dt)
        collisions = self._move(dt)
        self._end_pushes()
        self._tell_time(dt)
        self._call_back(watched, collisions)
        return collisions

    def add(
        self,
        shape: Shape,
        *,
        mass: float | None = None,
        position: Any = None,
        angle: float | None = None,
        velocity: Any = None,
        spin: float | None = None,
        restitution: float = 0.0,
        friction: float = 0.0,
        inertia: float | None = None,
        name: str | None = None,
        on_move: OnMove | None = None,
        on_collision: OnCollision | None = None,
    ) -> Body:
        """Put a body into the world; return its handle.

        Mass is 1 kg, the rest zero unless given; the moment of inertia follows from shape and mass.
        A wall takes none of mass, position, angle, velocity, spin, inertia.
        """
        if not isinstance(shape, Shape):
            raise TypeError(f"a body needs a Circle, Particle, Polygon or Wall, not {shape!r}")
        given = {"mass": mass, "position": position, "angle": angle, "velocity": velocity}
        given |= {"spin": spin, "inertia": inertia}
        given |= {"restitution": restitution, "friction": friction}
        values = initial_values(shape, given)
        id = self._next_body
        self._next_body += 1
        kind = type(shape).__name__.lower()
        body = Body(self, id, shape, f"{kind} {id}" if name is None else str(name))
        body.on_move, body.on_collision = on_move, on_collision
        self.tables, self._corner_count = write_body(
            self.tables, shape, id, self._count, self._corner_count, values
        )
        self._handles[id] = body
        self._rows[id] = self._count
        self._count += 1
        self.displaced()
        return body

    def remove(self, body: Body) -> None:
        """Take a body, with all that pushes it, out of the world; its handle is then refused."""
        row = self.row(body)
        for i in reversed(range(self._push_count)):
            if self.pushes.row[i] == row:
                self._drop_push(i)
        rows = np.asarray(self.pushes.row)[: self._push_count]
        rows[rows > row] -= 1
        first, corners = self.bodies.first[row], self.bodies.corners[row]
        for _ in range(corners):
            remove_row(self.tables.corners, first, self._corner_count)
            self._corner_count -= 1
        remove_row(self.bodies, row, self._count)
        self._pair_count = forget(self.tables, self._pair_count, row)
        self._count -= 1
        np.asarray(self.bodies.first)[row : self._count] -= corners
        del self._handles[body.id]
        self._rows = {id: i for i, id in enumerate(self._handles)}
        np.asarray(self.bodies.order)[: self._count] = np.arange(self._count)
        self.displaced()

    def __iter__(self) -> Iterator[Body]:
        """The bodies, walls too, in the order of their ids."""
        return iter(list(self._handles.values()))

    def __len__(self) -> int:
        """Number of bodies, walls too."""
        return len(self._handles)

    def body(self, id: int) -> Body:
        """The body with this id.

        Raises:
            Removed: (a LookupError) if there is none.
        """
        if id not in self._handles:
            raise Removed(f"there is no body {id} in this world")
        return self._handles[id]

    @property
    def bodies(self) -> Bodies:
        """Table of the bodies, a row each in the order of ids; what `Body` reads and writes."""
        return self.tables.bodies

    @property
    def time(self) -> float:
        """Since the world began (s)."""
        base, ticks, dt = self._clock
        return base + ticks * dt

    @property
    def gravity(self) -> Vector:
        """Acceleration that every body feels (m/s^2)."""
        return Vector(self.laws.gravity_x, self.laws.gravity_y)

    @gravity.setter
    def gravity(self, value: Any) -> None:
        down = validate.vector(value, "gravity")
        self.laws = self.laws._replace(gravity_x=down.x, gravity_y=down.y)

    @property
    def momentum(self) -> Vector:
        """Of all bodies (kg m/s)."""
        each = [body.momentum for body in self]
        return Vector(math.fsum(p.x for p in each), math.fsum(p.y for p in each))

    @property
    def angular_momentum(self) -> float:
        """Of all bodies about the origin (kg m^2/s)."""
        return math.fsum(body.angular_momentum for body in self)

    @property
    def kinetic_energy(self) -> float:
        """Of all bodies, rotation included (J)."""
        return math.fsum(body.kinetic_energy for body in self)

    @property
    def potential_energy(self) -> float:
        """Of all bodies in the gravity, zero at the origin (J)."""
        down = self.gravity
        each = (
            -body.mass * (down.x * body.x + down.y * body.y) for body in self if not body.is_wall
        )
        return math.fsum(each)

    def snapshot(self) -> Snapshot:
        """Copy all that varies; `restore` brings it back bit for bit."""
        t, pairs = self.tables, self._pair_count
        used: list[tuple[Any, int]] = [(t.bodies, self._count), (t.corners, self._corner_count)]
        used += [(t.pairs, pairs), (t.contacts, 2 * pairs), (self.pushes, self._push_count)]
        tables = tuple(tuple(column[:n].copy() for column in arrays(t)) for t, n in used)
        numbers = (self.tick, *self._clock, self._next_body, self._next_push, self._stale)
        return Snapshot(tables, numbers, tuple(self._handles.values()))

    def restore(self, snapshot: Snapshot) -> None:
        """Go back to a snapshot of this world; bodies added since are gone, removed ones return."""
        if not isinstance(snapshot, Snapshot):
            raise TypeError(f"only a Snapshot can be restored, not {snapshot!r}")
        if any(body._world is not self for body in snapshot.handles):
            raise ValueError("the snapshot is of another world")
        bodies, corners, pairs, contacts, pushes = snapshot.tables
        new_bodies, self._count = refill(self.bodies, bodies)
        new_corners, self._corner_count = refill(self.tables.corners, corners)
        new_pairs, self._pair_count = refill(self.tables.pairs, pairs)
        new_contacts, _ = refill(self.tables.contacts, contacts)
        self.tables = self.tables._replace(
            bodies=new_bodies, corners=new_corners, pairs=new_pairs, contacts=new_contacts
        )
        self.pushes, self._push_count = refill(self.pushes, pushes)
        self.tables = link(self.tables, self._count, self._pair_count)
        tick, base, ticks, dt, next_body, next_push, stale = snapshot.numbers
        self.tick, self._clock = int(tick), (base, int(ticks), dt)
        self._next_body, self._next_push = int(next_body), int(next_push)
        self._stale = bool(stale)
        self._handles = {body.id: body for body in snapshot.handles}
        self._rows = {id: i for i, id in enumerate(self._handles)}

    def digest(self) -> str:
        """Hash of the state (SHA-256, hexadecimal): equal for equal worlds on any machine."""
        clock = (float(self.tick), self.time)
        return snapshots.digest(
            self.bodies,
            self._count,
            self.pushes,
            self._push_count,
            clock,
            resting_columns(self.tables, self._pair_count),
        )

    # What the handles ask for.

    def row(self, body: Body) -> int:
        """Row of a body in the tables.

        Raises:
            Removed: (a LookupError) if it is no longer in this world.
        """
        row = self._rows.get(body.id)
        if row is None or body._world is not self or self._handles[body.id] is not body:
            raise Removed(f"{body.name} is not in this world")
        return row

    def push(self, body: Body, x: float, y: float, torque: float, at: Vector, lasts: float) -> Push:
        """Let a force (N) or torque (N m) act; see `Body.exert`."""
        if self._push_count == len(self.pushes.id):
            self.pushes = views(grow(self.pushes, 2 * self._push_count))
        id = self._next_push
        self._next_push += 1
        values = (id, self.row(body), x, y, torque, at.x, at.y, lasts)
        columns: tuple[Any, ...] = self.pushes
        for column, value in zip(columns, values, strict=True):
            column[self._push_count] = value
        self._push_count += 1
        return Push(self, id)

    def is_acting(self, push: int) -> bool:
        """Whether the push with this id still acts."""
        return any(self.pushes.id[i] == push for i in range(self._push_count))

    def stop(self, push: int) -> None:
        """End the push with this id, if it still acts."""
        for i in range(self._push_count):
            if self.pushes.id[i] == push:
                self._drop_push(i)
                return

    def displaced(self) -> None:
        """Take note that a body was moved by hand, or its material changed."""
        self._stale = True

    # The parts of a step.

    def _accelerate(self, dt: float) -> bool:
        """Let forces act for a tick; return whether the list of pairs holds."""
        pushes: Any = self.pushes
        if self._kernels.compiled:
            pushes = Pushes(*arrays(pushes))
        lost, pairs_hold = self._kernels.start(
            self._seen(), self._count, pushes, self._push_count, self.laws, dt
        )
        self._refuse_divergence(lost)
        return pairs_hold and not self._stale

    def _find_pairs(self, dt: float) -> None:
        """List the pairs that may touch in this tick."""
        rules = (self.restitution_rule, self.friction_rule)
        self.tables, self._pair_count = pair_up(
            self.tables, self._count, self._pair_count, dt, rules, self._kernels
        )
        self._stale = False

    def _move(self, dt: float) -> list[Collision]:
        """Move all bodies through the tick, along their paths and from impact to impact."""
        collisions: list[Collision] = []
        substep, limit = dt / self.laws.substeps, 1000 + 50 * self._count
        self.tables.impacts.written[1] = -1
        now = 0.0
        while now < dt:
            status, now = self._kernels.go(
                self._seen(), self._count, self._pair_count, now, dt, substep, limit
            )
            collisions += self._reported()
            if status == ESCAPED:
                self._find_pairs(dt)
        self._refuse_divergence(
            self._kernels.finish(self._seen(), self._count, self._pair_count, self.laws, dt)
        )
        return collisions

    def _seen(self) -> Tables:
        """The tables as the kernels take them: memoryviews, or arrays if they are compiled."""
        if not self._kernels.compiled:
            return self.tables
        if self._arrays_of is not self.tables:
            self._arrays_of, self._arrays = self.tables, as_arrays(self.tables)
        return self._arrays

    def _reported(self) -> list[Collision]:
        """Turn the table of impacts into collisions and empty it."""
        impacts, handles = self.tables.impacts, list(self._handles.values())
        number = impacts.written[0]
        impacts.written[0] = 0
        return [
            Collision(
                a=handles[impacts.a[i]],
                b=handles[impacts.b[i]],
                point=Vector(impacts.x[i], impacts.y[i]),
                normal=Vector(impacts.normal_x[i], impacts.normal_y[i]),
                impulse=Vector(impacts.impulse_x[i], impacts.impulse_y[i]),
                speed=impacts.speed[i],
                restitution=impacts.restitution[i],
                time=self.time + impacts.time[i],
            )
            for i in range(number)
        ]

    def _end_pushes(self) -> None:
        for i in reversed(range(self._push_count)):
            if self.pushes.left[i] <= 0.0:
                self._drop_push(i)

    def _drop_push(self, i: int) -> None:
        remove_row(self.pushes, i, self._push_count)
        self._push_count -= 1

    def _tell_time(self, dt: float) -> None:
        base, ticks, last = self._clock
        self.tick += 1
        self._clock = (base, ticks + 1, dt) if dt == last else (self.time, 1, dt)

    def _refuse_divergence(self, row: int) -> None:
        if row != SOUND:
            body = list(self._handles.values())[row]
            raise Diverged(f"{body.name} left the range of numbers in tick {self.tick}")

    def _where_callbacks_look(self) -> list[tuple[Body, Vector, float]]:
        listeners = [body for body in self._handles.values() if body.on_move is not None]
        return [(body, body.position, body.angle) for body in listeners]

    def _call_back(
        self, before: list[tuple[Body, Vector, float]], collisions: list[Collision]
    ) -> None:
        for body, position, angle in before:
            moved = body.id in self._handles and (body.position, body.angle) != (position, angle)
            if moved and body.on_move is not None:
                body.on_move(body)
        for collision in collisions:
            for body in (collision.a, collision.b):
                if body.id in self._handles and body.on_collision is not None:
                    body.on_collision(body, collision)
