"""The room in which bodies move."""

import math
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from engine import callbacks, ledger, validate
from engine.asking import ask_functions
from engine.body import Body, OnCollision, OnMove
from engine.clockwork import Clockwork
from engine.collision import Collisions, Removed
from engine.contact import Contact
from engine.enrol import initial_values
from engine.filters import ALL
from engine.force_laws import ActingLaw, Law, checked_bodies, checked_law, energy_in_fields
from engine.forces import Drag, Push
from engine.hits import Hit, Nearest
from engine.inputs import noted, noted_only
from engine.joint import Joint, OnBreak
from engine.joints import Spec
from engine.ledger import Ledger
from engine.materials import pair_row
from engine.recording import Recording
from engine.settings import TICK, Rule, Sleep, given, laws, rules
from engine.shapes import Shape
from engine.snapshot import Snapshot
from engine.store import Store
from engine.tables import Bodies, Tables
from engine.tracks import Tracks
from engine.validate import shown
from engine.vector import Vector

if TYPE_CHECKING:
    from engine.plain import Functions
    from engine.queries import Choice


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
        sleeping: whether bodies that came to rest may sleep, which saves time and is wrong by no
            more than `Sleep` says; True: by its usual numbers.
    """

    __slots__ = ("__weakref__", "_clockwork", "laws", "recorder", "rules", "store")

    def __init__(
        self,
        gravity: Any = (0.0, 0.0),
        drag: Drag | None = None,
        integrator: str = "semi-implicit-euler",
        substeps: int = 6,
        restitution_rule: Rule | None = None,
        friction_rule: Rule | None = None,
        kernels: str = "auto",
        sleeping: Sleep | bool = False,
    ) -> None:
        self.laws = laws(gravity, drag, integrator, substeps, sleeping)
        self.rules = rules(restitution_rule, friction_rule)
        """What makes the coefficients of a pair."""
        self.store = Store()
        """All that varies."""
        self.recorder: Recording | None = None
        """Who takes note of inputs; see `record`."""
        self._clockwork = Clockwork(self.store, kernels)

    def __repr__(self) -> str:
        """Say what is in it, and how old it is."""
        joints = f", {len(self.joints)} joints" if self.joints else ""
        return f"<World: {len(self)} bodies{joints}, {self.time:.6g} s>"

    def __reduce__(self) -> Any:
        """Copy and pickle it: what `to_dict` says, and the functions that its motion depends on.

        Handles that are copied together with it are then handles of the copy.
        """
        from engine import saving  # see `store`

        saved = (self.to_dict(), saving.functions_of(self), self._clockwork.mode)
        return type(self).from_dict, saved

    def step(self, dt: float = TICK) -> Collisions:
        """Advance by `dt` seconds; return the collisions that happened, in order of time.

        Nothing calls back from inside. Same tables in, same tables out.

        Args:
            dt: length of the tick (s), 1/60 s unless told otherwise; it need not be shorter, as
                impacts happen at instants of their own.

        Raises:
            Diverged: when a body left the range of numbers; the world is then of no more use.
        """
        dt = validate.tick(dt)
        store = self.store
        store.refuse_while_asking()
        if store.before is not None:
            store.close_books()
        poses = callbacks.poses(store) if store.listened_to else []
        if store.acting:
            ask_functions(store, self.laws, dt)
        collisions = self._clockwork.tick(self.laws, self.rules, dt)
        if self.recorder is not None:
            self.recorder.end_tick(self, dt)
        if store.listened_to:
            callbacks.call(poses, collisions, store)
        if store.joints:
            callbacks.call_broken(store)
        return collisions

    def run(
        self,
        ticks: int,
        dt: float = TICK,
        record: Iterable[str] = ("x", "y", "angle"),
        collisions: bool = False,
    ) -> Tracks:
        """Take many steps at once, to the same bits; return where the bodies were at each tick.

        Args:
            ticks: how many steps to take.
            dt: length of each (s).
            record: which of x, y (m), angle (rad), vx, vy (m/s), spin (rad/s), force_x, force_y (N)
                and torque (N m) to keep.
            collisions: whether to keep the collisions as well.

        Raises:
            Diverged: as `step`.
        """
        from engine import bulk  # see `store`

        return bulk.run(self, self._clockwork, ticks, dt, record, collisions)

    def state(self) -> Any:
        """Read all bodies at once: an array (bodies, 7) of id, x, y (m), angle (rad), vx, vy (m/s)
        and spin (rad/s), in the order of ids.
        """
        from engine import bulk  # see `store`

        return bulk.state(self)

    @noted
    def set_state(self, state: Any) -> None:
        """Set pose and motion of many bodies, by rows as `state` returns them, in any order.

        Walls may be among them where they are; a particle must have no spin.

        Raises:
            TypeError, ValueError, Removed: for rows that are none; nothing has changed then.
        """
        from engine import bulk  # see `store`

        bulk.set_state(self, state)

    # Bodies.

    @noted
    def add(
        self,
        shape: Shape,
        *,
        kind: str | None = None,
        mass: float | None = None,
        position: Any = None,
        angle: float | None = None,
        velocity: Any = None,
        spin: float | None = None,
        restitution: float = 0.0,
        friction: float = 0.0,
        static_friction: float | None = None,
        rolling_resistance: float = 0.0,
        surface_speed: float = 0.0,
        material: str | None = None,
        inertia: float | None = None,
        gravity_scale: float = 1.0,
        fixed_rotation: bool = False,
        sensor: bool = False,
        category: int = 1,
        mask: int = ALL,
        group: int = 0,
        name: str | None = None,
        on_move: OnMove | None = None,
        on_collision: OnCollision | None = None,
    ) -> Body:
        """Put a body into the world; return its handle.

        A wall or chain takes none of kind, mass, inertia, position, angle, velocity, spin.

        Args:
            shape: what it looks like; may be shared by any number of bodies.
            kind: "dynamic" (the usual one) is moved by forces; "kinematic" has infinite mass and
                goes with its own velocity and spin, pushing others; "static" stays where it is put,
                as walls do, which are nothing else.
            mass: (kg); None: 1 kg.
            position: of the centre of mass (m), as (x, y); None: the origin.
            angle: counter-clockwise (rad); None: 0.
            velocity: of the centre of mass (m/s), as (x, y); None: at rest.
            spin: angular velocity, counter-clockwise (rad/s); None: 0.
            restitution: share of the approach speed that an impact gives back, 0..1; that of a pair
                is the larger, unless the world has a rule.
            friction: Coulomb's coefficient; that of a pair is the geometric mean.
            static_friction: the same for what rests, at least `friction`; None: `friction`.
            rolling_resistance: lever arm (m) of the normal force against rolling.
            surface_speed: of a conveyor (m/s): along a wall or chain, counter-clockwise along the
                edge of other shapes.
            material: a name, see `set_material_pair`.
            inertia: mass moment of inertia about the centre of mass (kg m^2); None: that of the
                shape with this mass.
            gravity_scale: by which the world's gravity is multiplied for it.
            fixed_rotation: whether neither contacts nor torques turn it.
            sensor: whether it acts on nothing and only notices what overlaps it, see `contacts`.
            category: bits (32) of the kinds of body that it is.
            mask: bits of the categories that it touches, if their masks name its own as well.
            group: bodies of the same group other than 0 pass through each other.
            name: for messages and tracks; None: shape and id, as "circle 2".
            on_move: called with the body after each step in which it moved.
            on_collision: called with the body and each of its collisions after the step.

        Raises:
            TypeError, ValueError: in one sentence that names the value; nothing has changed then.
        """
        if not isinstance(shape, Shape):
            raise TypeError(
                f"a body needs a shape, such as a Circle or a Polygon, not {shown(shape)}"
            )
        wanted = {
            "kind": kind, "mass": mass, "inertia": inertia, "fixed_rotation": fixed_rotation,
            "position": position, "angle": angle, "velocity": velocity, "spin": spin,
            "restitution": restitution, "friction": friction, "static_friction": static_friction,
            "rolling_resistance": rolling_resistance, "surface_speed": surface_speed,
            "material": material, "gravity_scale": gravity_scale, "sensor": sensor,
            "category": category, "mask": mask, "group": group,
        }  # fmt: skip
        values = initial_values(shape, wanted)
        name = None if name is None else validate.text(name, "name")
        on_move = validate.function_or_none(on_move, "on_move")
        on_collision = validate.function_or_none(on_collision, "on_collision")
        self.store.material(material)
        id = self.store.new_id("body")
        body = Body(self, id, shape, name or f"{type(shape).__name__.lower()} {id}")
        if on_move is not None or on_collision is not None:
            body.on_move, body.on_collision = on_move, on_collision
        self.store.add_body(body, shape, values)
        return body

    @noted
    def remove(self, body: Body) -> None:
        """Take a body, with its joints and all that pushes it, out of the world; its handle is then
        refused. Joints and laws of force have a `remove` of their own.
        """
        self._own(body)
        self.store.remove_body(body)
        self.displaced()

    @noted
    def set_material_pair(
        self,
        a: str,
        b: str,
        *,
        restitution: float | None = None,
        friction: float | None = None,
        static_friction: float | None = None,
        rolling_resistance: float | None = None,
    ) -> None:
        """Give two materials, or one with itself, coefficients of their own.

        They hold for two bodies of these materials in place of what the bodies say; what is None is
        left to the bodies. A second call replaces what the first said.
        """
        self.store.pair_materials(
            (a, b), pair_row(a, b, restitution, friction, static_friction, rolling_resistance)
        )
        self.displaced()

    @noted
    def ignore(self, a: Body, b: Body) -> None:
        """Let two bodies pass through each other, whatever their filters say, until `heed`; twice
        does nothing.
        """
        self._two_bodies(a, b)
        if self.store.ignore(a, b):
            self.displaced()

    @noted
    def heed(self, a: Body, b: Body) -> None:
        """Take `ignore` back; twice does nothing."""
        self._two_bodies(a, b)
        if self.store.heed(a, b):
            self.displaced()

    def ignores(self, a: Body, b: Body) -> bool:
        """Whether two bodies ignore each other, told by hand or joined."""
        self._two_bodies(a, b)
        return self.store.ignores(a, b)

    def _own(self, body: Any) -> None:
        if not isinstance(body, Body):
            removable = isinstance(body, Joint | ActingLaw)
            hint = ", which has a remove() of its own" if removable else ""
            raise TypeError(f"it takes a body of this world, not {shown(body)}{hint}")
        self.row(body)

    def _two_bodies(self, a: Body, b: Body) -> None:
        for body in (a, b):
            self._own(body)
        if a is b:
            raise ValueError(f"it takes two bodies, not {a.name} twice")

    # Joints and laws of force.

    @noted
    def join(
        self,
        a: Body | None,
        b: Body | None,
        joint: Spec,
        *,
        collide: bool = False,
        break_force: float | None = None,
        break_torque: float | None = None,
        on_break: OnBreak | None = None,
    ) -> Joint:
        """Join two bodies, or a body and a fixed point of the world (None); return the joint.

        Args:
            a: one body.
            b: the other; `Joint.force` is what it feels.
            joint: a `Distance`, `Rope`, `Spring`, `Pin`, `Weld`, `Slider` or `Pulley`.
            collide: whether the two may touch each other.
            break_force: mean force over a tick (N) beyond which it breaks; None: never.
            break_torque: the same for the torque (N m).
            on_break: called with the joint after the step in which it broke.

        Raises:
            TypeError, ValueError: for what cannot be joined so.
            Removed: (a LookupError) for a body that is not in this world.
        """
        from engine.joining import joint_columns  # see `store`

        for body in (a, b):
            if body is not None:
                self._own(body)
        values = joint_columns(a, b, joint, break_force, break_torque)
        collide = validate.truth(collide, "collide")
        on_break = validate.function_or_none(on_break, "on_break")
        handle = Joint(self, self.store.new_id("joint"), a, b)
        handle.on_break = on_break
        self.store.add_joint(handle, values, collide)
        return handle

    def joint(self, id: int) -> Joint:
        """The joint with this id.

        Raises:
            Removed: (a LookupError) if there is none.
        """
        return self.store.joint(id)

    @property
    def joints(self) -> tuple[Joint, ...]:
        """The joints, broken ones too, in the order in which they were made."""
        return tuple(self.store.joints)

    @noted
    def add_law(self, law: Law, bodies: Iterable[Body] | None = None) -> ActingLaw:
        """Let a law of force act from the next tick on; return it, to be removed again.

        Args:
            law: `PointGravity`, `SpringTo`, or a function of a body and the time (s) that returns
                a `Force`, a `Torque`, (fx, fy), (fx, fy, torque) or None. A function must not
                change the world. It is asked before each tick, and with velocity Verlet and
                Runge-Kutta once more for the end of the tick: microseconds a body, where the
                built-in laws cost nanoseconds.
            bodies: on which it acts, on their centres; None: on all, also those added later.
        """
        law, named = checked_law(law), checked_bodies(self, bodies)
        acting = ActingLaw(self, self.store.new_id("law"), law, named)
        self.store.add_law(acting)
        return acting

    @property
    def force_laws(self) -> tuple[ActingLaw, ...]:
        """The laws of force that act, in the order in which they were added."""
        return tuple(self.store.acting.values())

    # Questions.

    def query_point(
        self, point: Any, mask: int = ALL, leave_out: Iterable[Body] = ()
    ) -> list[Body]:
        """Bodies that contain a point (m), in the order of ids; a wall contains what is on it.

        Queries take bodies as they stand now; sensors are not in question.

        Args:
            point: of the world (m).
            mask: bits of the categories in question.
            leave_out: bodies that are not in question.
        """
        return self._choice(mask, leave_out).at_point(point)

    def query_box(
        self, low: Any, high: Any, mask: int = ALL, leave_out: Iterable[Body] = ()
    ) -> list[Body]:
        """Bodies that touch the upright box between two corners (m), in the order of ids."""
        return self._choice(mask, leave_out).in_box(low, high)

    def cast_ray(
        self, start: Any, end: Any, mask: int = ALL, leave_out: Iterable[Body] = ()
    ) -> Hit | None:
        """The first body on the way from start to end (m); None if there is none.

        A body that contains the start is hit at once. One-sided walls let through what comes from
        behind.
        """
        return next(iter(self.cast_ray_through(start, end, mask, leave_out)), None)

    def cast_ray_through(
        self, start: Any, end: Any, mask: int = ALL, leave_out: Iterable[Body] = ()
    ) -> list[Hit]:
        """All bodies on the way from start to end (m), by distance, then by ids."""
        return self._choice(mask, leave_out).along_ray(start, end)

    def cast_shape(
        self,
        shape: Shape,
        start: Any,
        end: Any,
        angle: float = 0.0,
        mask: int = ALL,
        leave_out: Iterable[Body] = (),
    ) -> Hit | None:
        """The first body that a shape touches whose centre moves from start to end (m).

        It keeps its angle (rad). What it touches at the start is hit at once.
        """
        met = self._choice(mask, leave_out).along_sweep(shape, start, end, angle)
        return next(iter(met), None)

    def nearest(
        self,
        point: Any,
        mask: int = ALL,
        leave_out: Iterable[Body] = (),
        within: float = math.inf,
    ) -> Nearest | None:
        """The body whose surface is nearest to a point; None if none is `within` (m) reach."""
        return self._choice(mask, leave_out).nearest_to(point, within)

    def _choice(self, mask: int, leave_out: Iterable[Body]) -> "Choice":
        """Which bodies a question is about."""
        from engine.queries import Choice  # see `store`

        return Choice(self.store, mask, leave_out)

    # What is in it.

    def __iter__(self) -> Iterator[Body]:
        """The bodies, walls too, in the order of their ids."""
        return iter(list(self.store.handles))

    def __contains__(self, body: object) -> bool:
        """Whether a body is in this world."""
        return isinstance(body, Body) and self.store.holds(body)

    def __len__(self) -> int:
        """Number of bodies, walls too."""
        return len(self.store.handles)

    def body(self, id: int) -> Body:
        """The body with this id.

        Raises:
            Removed: (a LookupError) if there is none.
        """
        row = self.store.rows.get(validate.identity(id, "a body"))
        if row is None:
            raise Removed(f"there is no body {shown(id)} in this world")
        return self.store.handles[row]

    @property
    def contacts(self) -> list[Contact]:
        """What touched in the last tick, or did in the tick before, in the order of ids.

        For each body, the impulses of its contacts, of its joints and of the forces on it add up
        to the change of its momentum in the tick (by the Euler methods, apart from their own
        error). Bodies that were removed are not told of.
        """
        from engine import touching  # see `store`

        return touching.contacts(self.store)

    @property
    def tables(self) -> Tables:
        """All tables."""
        return self.store.tables

    @property
    def bodies(self) -> Bodies:
        """Table of the bodies, a row each in the order of ids; what `Body` reads and writes."""
        return self.store.tables.bodies

    @property
    def tick(self) -> int:
        """Number of steps taken."""
        return self.store.tables.state.tick[0]

    @property
    def time(self) -> float:
        """Since the world began (s)."""
        return self.store.time

    @property
    def kernels(self) -> str:
        """What it runs on at present: "interpreted" or "compiled"."""
        return "compiled" if self._clockwork.compiled else "interpreted"

    # The laws that hold.

    @property
    def restitution_rule(self) -> Rule:
        """Makes the restitution of a pair from those of its bodies."""
        return self.rules.restitution

    @restitution_rule.setter
    @noted
    def restitution_rule(self, rule: Rule | None) -> None:
        self.rules = rules(rule, self.rules.friction)
        self.displaced()

    @property
    def friction_rule(self) -> Rule:
        """Makes the friction of a pair from those of its bodies."""
        return self.rules.friction

    @friction_rule.setter
    @noted
    def friction_rule(self, rule: Rule | None) -> None:
        self.rules = rules(self.rules.restitution, rule)
        self.displaced()

    @property
    def gravity(self) -> Vector:
        """Acceleration that every body feels (m/s^2)."""
        return Vector(self.laws.gravity_x, self.laws.gravity_y)

    @gravity.setter
    @noted
    def gravity(self, value: Any) -> None:
        self._change(gravity=value)

    @property
    def drag(self) -> Drag | None:
        """`LinearDrag`, `QuadraticDrag` or None."""
        drag: Drag | None = given(self.laws)["drag"]
        return drag

    @drag.setter
    @noted
    def drag(self, value: Drag | None) -> None:
        self._change(drag=value)

    @property
    def integrator(self) -> str:
        """How accelerations become motion; see `World`."""
        return str(given(self.laws)["integrator"])

    @integrator.setter
    @noted
    def integrator(self, value: str) -> None:
        self._change(integrator=value)

    @property
    def substeps(self) -> int:
        """Into how many parts a tick is divided for bodies that rest on each other."""
        return self.laws.substeps

    @substeps.setter
    @noted
    def substeps(self, value: int) -> None:
        self._change(substeps=value)

    @property
    def sleeping(self) -> Sleep | bool:
        """When bodies at rest may fall asleep: a `Sleep`, or False for never."""
        sleep: Sleep | bool = given(self.laws)["sleeping"]
        return sleep

    @sleeping.setter
    @noted
    def sleeping(self, value: Sleep | bool) -> None:
        self._change(sleeping=value)

    def _change(self, **given_anew: Any) -> None:
        """Let other laws hold from the next tick on; all wake."""
        self.laws = laws(**(given(self.laws) | given_anew))
        self.store.wake_all()

    # Totals and books.

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
        """Of all bodies in the gravity, zero at the origin, and in built-in laws of force (J)."""
        down = self.gravity
        movable = [body for body in self if body.is_dynamic]
        each = [-b.mass * b.gravity_scale * (down.x * b.x + down.y * b.y) for b in movable]
        return math.fsum(each + energy_in_fields(self.force_laws, movable))

    def ledger(self) -> Ledger:
        """Read the books: momentum and energy, and what gave and took them since the beginning."""
        self.store.close_books()
        return ledger.ledger(self)

    # To come back to, to keep, to compare.

    def snapshot(self) -> Snapshot:
        """Copy all that varies; `restore` brings it back bit for bit."""
        return self.store.snapshot(self.laws, self.rules)

    @noted
    def restore(self, snapshot: Snapshot) -> None:
        """Go back to a snapshot of this world; bodies added since are gone, removed ones return.

        Names, and functions that bodies call back, stay what they are.
        """
        if not isinstance(snapshot, Snapshot):
            raise TypeError(f"only a Snapshot can be restored, not {shown(snapshot)}")
        belongs: Any = (*snapshot.handles, *snapshot.joints, *snapshot.force_laws)
        if any(each._world is not self for each in belongs):
            raise ValueError("the snapshot is of another world")
        self.store.restore(snapshot)
        self.laws, self.rules = snapshot.laws, snapshot.rules

    def to_dict(self) -> dict[str, Any]:
        """Say all that varies as plain data that JSON can hold; `from_dict` makes a world of it.

        The two go on bit for bit alike, in other processes and on other machines too. Functions
        that bodies call back are not saved; other functions (rules) are, by their names.
        """
        from engine import saving  # see `store`

        return saving.to_dict(self)

    @classmethod
    def from_dict(
        cls, data: dict[str, Any], functions: "Functions | None" = None, kernels: str = "auto"
    ) -> "World":
        """Make the world that `to_dict` saved.

        Args:
            data: what `to_dict` returned, or what JSON made of it.
            functions: the Python functions that the world uses, by the names under which they were
                saved: `{"lesson.rule": rule}`.
            kernels: as for a new world.

        Raises:
            TypeError, ValueError: in one sentence, for data of another version or damaged data.
            LookupError: for a function that is missing.
        """
        from engine import saving  # see `store`

        world = cls(kernels=kernels)
        saving.refill(world, data, saving.by_name(functions))
        return world

    def record(self) -> Recording:
        """Note all that is done to the world from now on, for `replay`.

        Use it in a `with` block, or call `stop()` of what is returned.
        """
        return Recording.of(self)

    def digest(self) -> str:
        """Hash of the state (SHA-256, hexadecimal): equal for equal worlds on any machine."""
        return self.store.digest()

    # What the handles ask for.

    def row(self, body: Body) -> int:
        """Row of a body in the tables.

        Raises:
            Removed: (a LookupError) if it is no longer in this world.
        """
        return self.store.row(body)

    @noted_only
    def push(self, body: Body, x: float, y: float, torque: float, at: Vector, lasts: float) -> Push:
        """Let a force (N) or torque (N m) act; see `Body.exert`."""
        id = self.store.new_id("push")
        row = self.row(body)
        self.store.append("pushes", (id, row, x, y, torque, at.x, at.y, lasts))
        return Push(self, id)

    def is_acting(self, push: int) -> bool:
        """Whether the push with this id still acts."""
        return self._row_of_push(push) is not None

    @noted_only
    def change_push(self, push: int, x: float, y: float, torque: float) -> None:
        """Let the push with this id exert another force (N) or torque (N m)."""
        row, pushes = self._row_of_push(push), self.tables.pushes
        if row is None:
            raise ValueError(f"push {shown(push)} is over: what it exerts cannot change")
        pushes.x[row], pushes.y[row], pushes.torque[row] = x, y, torque
        self.store.wake(pushes.row[row])

    @noted_only
    def stop(self, push: int) -> None:
        """End the push with this id, if it still acts."""
        row = self._row_of_push(push)
        if row is not None:
            self.store.drop("pushes", row)

    def _row_of_push(self, push: int) -> int | None:
        id, ids = validate.identity(push, "a push"), self.tables.pushes.id
        return next((i for i in range(self.store.count("pushes")) if ids[i] == id), None)

    @noted
    def displaced(self) -> None:
        """Take note that a body was moved by hand, or its material changed; all wake."""
        self.tables.state.stale[0] = 1
        self.store.wake_all()
