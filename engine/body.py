"""The handle by which people hold a body. It has no state of its own: the world's tables do."""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from engine import filters, kinds, materials, validate
from engine.collision import Collision
from engine.enrol import inertness
from engine.forces import Force, Push, Torque, components
from engine.inputs import noted, noted_only
from engine.pair_rows import measure_anew
from engine.settings import AS_FRICTION
from engine.shapes import Barrier, Chain, Particle, Shape, Wall, outlines
from engine.shapes.piece import turned
from engine.vector import Vector, rotated

if TYPE_CHECKING:
    from engine.world import World

OnMove = Callable[["Body"], None]
OnCollision = Callable[["Body", Collision], None]


class Body:
    """A rigid body of a world: a shape with mass, pose and motion (SI units, +y up).

    Two attributes may be set to functions that are called after a step, in the order of ids and of
    collisions: `on_move(body)` if the body moved, `on_collision(body, collision)`.
    """

    __slots__ = ("_id", "_name", "_on_collision", "_on_move", "_shape", "_world")

    def __init__(self, world: "World", id: int, shape: Shape, name: str) -> None:
        """Made by `World.add`."""
        self._world = world
        self._id = id
        self._shape = shape
        self._name = name
        self._on_move: OnMove | None = None
        self._on_collision: OnCollision | None = None

    def __repr__(self) -> str:
        """Name it and say what shape it has."""
        return f"<Body {self.id} {self.name!r}: {self.shape}>"

    def __reduce__(self) -> Any:
        """Copy and pickle it with its world, as the body of this id."""
        return type(self._world).body, (self._world, self._id)

    @property
    def id(self) -> int:
        """By which the world and tracks know it; none is used twice."""
        return self._id

    @property
    def shape(self) -> Shape:
        """What it was added with."""
        return self._shape

    @property
    def name(self) -> str:
        """What it is called in messages and tracks; several bodies may share a name."""
        return self._name

    @name.setter
    def name(self, value: Any) -> None:
        self._name = validate.text(value, "name")

    @property
    def on_move(self) -> OnMove | None:
        """Called with this body after a step in which it moved."""
        return self._on_move

    @on_move.setter
    def on_move(self, function: OnMove | None) -> None:
        self._on_move = validate.function_or_none(function, "on_move")
        self._world.store.listened_to |= function is not None

    @property
    def on_collision(self) -> OnCollision | None:
        """Called with this body and each collision that it had, after the step."""
        return self._on_collision

    @on_collision.setter
    def on_collision(self, function: OnCollision | None) -> None:
        self._on_collision = validate.function_or_none(function, "on_collision")
        self._world.store.listened_to |= function is not None

    @property
    def is_wall(self) -> bool:
        """Whether it is a wall or a chain of walls, which never moves."""
        return isinstance(self.shape, Barrier)

    @property
    def kind(self) -> str:
        """It is "dynamic", "kinematic" or "static"; see `World.add`."""
        row, bodies = self._row(), self._world.bodies
        if bodies.mass[row] < math.inf:
            return "dynamic"
        return "kinematic" if bodies.moves[row] else "static"

    @property
    def is_dynamic(self) -> bool:
        """Whether forces and impulses move it."""
        return self._world.bodies.mass[self._row()] < math.inf

    @property
    def position(self) -> Vector:
        """Centre of mass (m); the middle of a wall or chain."""
        if isinstance(self.shape, Barrier):
            return self.shape.middle
        row = self._row()
        return Vector(self._world.bodies.x[row], self._world.bodies.y[row])

    @position.setter
    @noted
    def position(self, value: Any) -> None:
        row, new = self._placeable("position"), validate.vector(value, "position")
        self._world.bodies.x[row], self._world.bodies.y[row] = new
        kinds.repose(self._world.store, row)
        self._world.displaced()

    @property
    def x(self) -> float:
        """Of the centre of mass (m)."""
        return self.position.x

    @x.setter
    @noted
    def x(self, value: Any) -> None:
        self.position = (value, self.y)

    @property
    def y(self) -> float:
        """Of the centre of mass (m)."""
        return self.position.y

    @y.setter
    @noted
    def y(self, value: Any) -> None:
        self.position = (self.x, value)

    @property
    def angle(self) -> float:
        """Counter-clockwise, not wrapped (rad)."""
        return self._world.bodies.angle[self._row()]

    @angle.setter
    @noted
    def angle(self, value: Any) -> None:
        row = self._placeable("angle")
        self._world.bodies.angle[row] = validate.finite(value, "angle")
        kinds.repose(self._world.store, row)
        self._world.displaced()

    @property
    def velocity(self) -> Vector:
        """Of the centre of mass (m/s)."""
        row = self._row()
        return Vector(self._world.bodies.vx[row], self._world.bodies.vy[row])

    @velocity.setter
    @noted
    def velocity(self, value: Any) -> None:
        row, new = self._moving("velocity"), validate.vector(value, "velocity")
        kinds.set_off(self._world.store, row, new, self.spin, self._world.laws.substeps)

    @property
    def vx(self) -> float:
        """(m/s)"""
        return self._world.bodies.vx[self._row()]

    @vx.setter
    @noted
    def vx(self, value: Any) -> None:
        self.velocity = (value, self.vy)

    @property
    def vy(self) -> float:
        """(m/s)"""
        return self._world.bodies.vy[self._row()]

    @vy.setter
    @noted
    def vy(self, value: Any) -> None:
        self.velocity = (self.vx, value)

    @property
    def speed(self) -> float:
        """Of the centre of mass (m/s)."""
        vx, vy = self.velocity
        return math.sqrt(vx * vx + vy * vy)

    @property
    def spin(self) -> float:
        """Angular velocity, counter-clockwise (rad/s)."""
        return self._world.bodies.spin[self._row()]

    @spin.setter
    @noted
    def spin(self, value: Any) -> None:
        row, new = self._moving("spin"), validate.finite(value, "spin")
        if new and self.fixed_rotation:
            raise ValueError(f"{self._who} never rotates, so its spin cannot be {new}")
        kinds.set_off(self._world.store, row, self.velocity, new, self._world.laws.substeps)

    @property
    def mass(self) -> float:
        """(kg); infinite unless dynamic. Setting it scales the moment of inertia alike."""
        return self._world.bodies.mass[self._row()]

    @mass.setter
    @noted
    def mass(self, value: Any) -> None:
        row, new = self._dynamic("mass"), validate.positive(value, "mass")
        self._weigh(row, new, self.inertia * (new / self.mass))
        if self._world.bodies.joined[row]:
            self._world.store.loosen()  # how joints are solved depends on masses

    @property
    def inertia(self) -> float:
        """Mass moment of inertia about the centre (kg m^2); infinite unless dynamic, and for what
        never rotates.
        """
        return self._world.bodies.inertia[self._row()]

    @inertia.setter
    @noted
    def inertia(self, value: Any) -> None:
        row, new = self._dynamic("inertia"), validate.positive(value, "inertia")
        if self.fixed_rotation:
            raise ValueError(f"{self._who} never rotates, so its inertia cannot be {new}")
        self._weigh(row, self.mass, new)

    def _weigh(self, row: int, mass: float, inertia: float) -> None:
        """Give it another mass (kg) and moment of inertia (kg m^2)."""
        for name, value in inertness(self.shape, mass, inertia).items():
            getattr(self._world.bodies, name)[row] = value
        measure_anew(self._world.tables, row)

    @property
    def fixed_rotation(self) -> bool:
        """Whether nothing makes it rotate: added so, or a particle."""
        return isinstance(self.shape, Particle) or (self.is_dynamic and self.inertia == math.inf)

    @property
    def _who(self) -> str:
        return "a particle" if isinstance(self.shape, Particle) else self.name

    @property
    def restitution(self) -> float:
        """Share of the approach speed that an impact gives back, 0..1."""
        return self._world.bodies.restitution[self._row()]

    @restitution.setter
    @noted
    def restitution(self, value: Any) -> None:
        self._world.bodies.restitution[self._row()] = validate.fraction(value, "restitution")
        self._world.displaced()

    @property
    def friction(self) -> float:
        """Coulomb's coefficient, >= 0."""
        return self._world.bodies.friction[self._row()]

    @friction.setter
    @noted
    def friction(self, value: Any) -> None:
        row, new = self._row(), validate.not_negative(value, "friction")
        own = self._world.bodies.static_friction[row]
        materials.grip(None if own == AS_FRICTION else own, new)
        self._world.bodies.friction[row] = new
        self._world.displaced()

    @property
    def static_friction(self) -> float:
        """Coulomb's coefficient for what rests, at least `friction`; None makes it the same."""
        row, bodies = self._row(), self._world.bodies
        own = bodies.static_friction[row]
        return bodies.friction[row] if own == AS_FRICTION else own

    @static_friction.setter
    @noted
    def static_friction(self, value: Any) -> None:
        row, bodies = self._row(), self._world.bodies
        bodies.static_friction[row] = materials.resistance(value, bodies.friction[row])
        self._world.displaced()

    @property
    def rolling_resistance(self) -> float:
        """Lever arm (m) by which the normal force resists rolling; that of a pair is the larger."""
        return self._world.bodies.rolling_resistance[self._row()]

    @rolling_resistance.setter
    @noted
    def rolling_resistance(self, value: Any) -> None:
        arm = validate.not_negative(value, "rolling_resistance")
        self._world.bodies.rolling_resistance[self._row()] = arm
        self._world.displaced()

    @property
    def surface_speed(self) -> float:
        """With which the surface moves along the edge (m/s), as that of a conveyor.

        Of a wall or chain from start to end, of other shapes counter-clockwise.
        """
        return self._world.bodies.surface_speed[self._row()]

    @surface_speed.setter
    @noted
    def surface_speed(self, value: Any) -> None:
        speed = validate.finite(value, "surface_speed")
        self._world.bodies.surface_speed[self._row()] = speed
        self._world.displaced()

    @property
    def material(self) -> str | None:
        """Name of what it is made of, see `World.set_material_pair`; None for nothing special."""
        return self._world.store.materials.get(self._world.bodies.material[self._row()])

    @material.setter
    @noted
    def material(self, value: Any) -> None:
        row = self._row()
        self._world.bodies.material[row] = self._world.store.material(value)
        self._world.displaced()

    @property
    def gravity_scale(self) -> float:
        """By which the gravity of the world is multiplied for this body; laws of force are not."""
        return self._world.bodies.gravity_scale[self._row()]

    @gravity_scale.setter
    @noted
    def gravity_scale(self, value: Any) -> None:
        row = self._dynamic("gravity_scale")
        self._world.bodies.gravity_scale[row] = validate.finite(value, "gravity_scale")

    @property
    def is_asleep(self) -> bool:
        """Whether it came to rest and sleeps; see `Sleep`."""
        return self._world.bodies.asleep[self._row()] == 1

    @noted
    def wake(self) -> None:
        """Wake it, and those that it rests on and that rest on it."""
        self._world.store.wake(self._row())

    @property
    def is_sensor(self) -> bool:
        """Whether it only notices what overlaps it; see `World.contacts`."""
        return self._world.bodies.sensor[self._row()] == 1

    @property
    def category(self) -> int:
        """Bits of the kinds of body that it is."""
        return self._world.bodies.category[self._row()]

    @category.setter
    @noted
    def category(self, value: Any) -> None:
        self._world.bodies.category[self._row()] = filters.category_bits(value)
        self._world.displaced()

    @property
    def mask(self) -> int:
        """Bits of the categories that it touches."""
        return self._world.bodies.mask[self._row()]

    @mask.setter
    @noted
    def mask(self, value: Any) -> None:
        self._world.bodies.mask[self._row()] = filters.mask_bits(value)
        self._world.displaced()

    @property
    def group(self) -> int:
        """Bodies of the same group pass through each other; 0: none."""
        return self._world.bodies.group[self._row()]

    @group.setter
    @noted
    def group(self, value: Any) -> None:
        self._world.bodies.group[self._row()] = filters.group_number(value)
        self._world.displaced()

    @property
    def momentum(self) -> Vector:
        """(kg m/s); zero unless dynamic."""
        if not self.is_dynamic:
            return Vector(0.0, 0.0)
        mass, velocity = self.mass, self.velocity
        return Vector(mass * velocity.x, mass * velocity.y)

    @property
    def angular_momentum(self) -> float:
        """About the origin of the world (kg m^2/s); zero unless dynamic."""
        if not self.is_dynamic:
            return 0.0
        at, momentum = self.position, self.momentum
        own = self.inertia * self.spin if self.spin else 0.0
        return at.x * momentum.y - at.y * momentum.x + own

    @property
    def kinetic_energy(self) -> float:
        """Of motion and rotation (J); zero unless dynamic."""
        if not self.is_dynamic:
            return 0.0
        vx, vy = self.velocity
        own = self.inertia * self.spin * self.spin if self.spin else 0.0
        return (self.mass * (vx * vx + vy * vy) + own) / 2.0

    @property
    def force(self) -> Vector:
        """What acted during the last tick, contacts apart, as its mean over the tick (N)."""
        row = self._row()
        return Vector(self._world.bodies.force_x[row], self._world.bodies.force_y[row])

    @property
    def torque(self) -> float:
        """What acted during the last tick, contacts apart, as its mean over the tick (N m)."""
        return self._world.bodies.torque[self._row()]

    @property
    def vertices(self) -> tuple[Vector, ...]:
        """Corners of a polygon (before it is rounded) or of its outline, ends of a wall, points of
        a chain, in the world (m); none of other shapes: see `outlines`.
        """
        if isinstance(self.shape, Wall):
            return (self.shape.start, self.shape.end)
        local = self.shape.points if isinstance(self.shape, Chain) else ()
        local = getattr(self.shape, "vertices", local)
        return tuple(self.to_world(corner) for corner in local)

    @property
    def outlines(self) -> tuple[tuple[Vector, ...], ...]:
        """The edge of each part of the shape in the world (m), arcs as 64 chords to a circle.

        Closed lines, counter-clockwise, but for those of walls and open chains.
        """
        return tuple(tuple(self.to_world(point) for point in line) for line in outlines(self.shape))

    def to_world(self, point: Any) -> Vector:
        """Turn a point of the body's frame into one of the world (m)."""
        local = validate.vector(point, "point")
        return turned(local, Vector(0.0, 0.0) if self.is_wall else self.position, self.angle)

    def to_local(self, point: Any) -> Vector:
        """Turn a point of the world into one of the body's frame (m)."""
        world = validate.vector(point, "point")
        at = Vector(0.0, 0.0) if self.is_wall else self.position
        return rotated((world.x - at.x, world.y - at.y), -self.angle)

    def velocity_at(self, point: Any) -> Vector:
        """With which the body moves at a point (m, world): v + w x r (m/s)."""
        at, centre = validate.vector(point, "point"), self.position
        (vx, vy), spin = self.velocity, self.spin
        return Vector(vx - spin * (at.y - centre.y), vy + spin * (at.x - centre.x))

    @noted_only
    def exert(self, effort: Force | Torque, duration: float | None = None, at: Any = None) -> Push:
        """Push or turn the body from the next tick on; return the push.

        Args:
            effort: a force keeps its direction in the world, whatever the body does.
            duration: how long it acts (s); None: until `stop()`. What it delivers in all is
                exactly force times duration, whatever the tick.
            at: point of attack of a force (m, world); it moves and turns with the body from now
                on. None: the centre of mass.

        Raises:
            TypeError, ValueError: for what is no effort, and for a body that no force moves.
        """
        self._dynamic("force")
        x, y, torque = components(effort)
        lasts = math.inf if duration is None else validate.positive(duration, "duration")
        if at is not None and isinstance(effort, Torque):
            raise ValueError("a torque has no point of attack")
        point = Vector(0.0, 0.0) if at is None else self.to_local(validate.vector(at, "at"))
        return self._world.push(self, x, y, torque, point, lasts)

    @noted
    def apply_impulse(self, impulse: Any, at: Any = None) -> None:
        """Change momentum and spin at once.

        Args:
            impulse: (N s, world), as (x, y).
            at: where it acts (m, world); None: at the centre of mass, which gives no spin.
        """
        row, given = self._dynamic("impulse"), validate.vector(impulse, "impulse")
        centre = self.position
        point = centre if at is None else validate.vector(at, "at")
        turn = (point.x - centre.x) * given.y - (point.y - centre.y) * given.x
        bodies = self._world.bodies
        bodies.vx[row] += bodies.inverse_mass[row] * given.x
        bodies.vy[row] += bodies.inverse_mass[row] * given.y
        bodies.spin[row] += bodies.inverse_inertia[row] * turn

    def _row(self) -> int:
        return self._world.store.row(self)

    def _dynamic(self, what: str) -> int:
        """Row of the body, if forces move it.

        Raises:
            ValueError: if not, in a sentence that says what it does not take.
        """
        row = self._placeable(what)
        if not self.is_dynamic:
            raise ValueError(f"{self.name} is {self.kind}: it takes no {what}")
        return row

    def _moving(self, what: str) -> int:
        row = self._placeable(what)
        if self.kind == "static":
            raise ValueError(f"{self.name} is static: it takes no {what}")
        return row

    def _placeable(self, what: str) -> int:
        row = self._row()
        if self.is_wall:
            raise ValueError(f"a wall is immovable: {self.name} takes no {what}")
        self._world.store.wake(row)
        return row
