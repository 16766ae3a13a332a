"""Everything that varies in a world, in one place: its tables, and who holds which row.

Large kernels are imported where they are called: it takes a moment, and a world that is only set
up needs none of them.
"""

from bisect import bisect_left
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from engine import validate
from engine.body import Body
from engine.collision import Removed
from engine.enrol import write_body
from engine.filters import ignored_keys, pair_keys, row_of_ignored
from engine.force_laws import ActingLaw, field_table
from engine.joint import Joint
from engine.ledger import book_hand, totals
from engine.materials import number_or_none
from engine.pair_rows import forget
from engine.settings import Laws, Rules
from engine.shapes import Shape
from engine.snapshot import Snapshot, digest
from engine.tables import (
    ROWS,
    Counts,
    Lanes,
    Tables,
    allocate,
    arrays,
    grow,
    move_row,
    new_tables,
    remove_rows,
    start_row,
    views,
)
from engine.tables.linkage import BREAKING, BROKEN

PAIRS = 12
"""Pairs for which there is room at least, of each piece: memory that nobody writes to costs
nothing, a larger table costs a copy of all that it holds."""


class Store:
    """The tables of a world and the handles of its bodies.

    A table named in `Counts` keeps what its rows in use hold: such tables grow, lose rows, are
    saved and restored. The others are room for the kernels to write in.
    """

    __slots__ = (
        "acting", "asking", "before", "broken", "handles", "joints", "listened_to", "materials",
        "rows", "tables",
    )  # fmt: skip

    def __init__(self) -> None:
        """Make an empty one."""
        self.tables: Tables = new_tables()
        self.tables.progress.room[0] = ROWS["pairs"]
        self.handles: list[Body] = []
        """The bodies in order of their rows, which is that of their ids."""
        self.listened_to = False
        """Whether a body ever had a function to call; see `callbacks`."""
        self.asking = False
        """Whether a function is being asked within a step: it must not change the world."""
        self.before: Any = None
        """Momentum and energy before anything was done since the last tick; None: nothing was."""
        self.rows: dict[int, int] = {}
        """Row of each body's id."""
        self.acting: dict[int, ActingLaw] = {}
        """The laws of force by their ids; `Fields` lists them by rows."""
        self.joints: list[Joint] = []
        """The joints in order of their rows, which is that of their ids."""
        self.broken: list[Joint] = []
        """Joints that broke and have not called back yet."""
        self.materials: dict[int, str] = {}
        """Names of materials by their numbers; none is forgotten."""
        state = self.tables.state
        state.next_joint[0] = 1
        state.next_body[0] = state.next_push[0] = state.next_law[0] = 1

    def count(self, table: str) -> int:
        """Number of rows in use."""
        return int(getattr(self.tables.counts, table)[0])

    def make_room(self, table: str, rows: int) -> None:
        """Let a table have room for so many rows at least."""
        old = getattr(self.tables, table)
        room = len(old[0])
        if rows > room:
            while room < rows:
                room *= 2
            self.tables = self.tables._replace(**{table: views(grow(old, room))})

    def append(self, table: str, values: tuple[float, ...]) -> int:
        """Write a row after the last one, its values in the order of the columns; return it."""
        row = self.count(table)
        self.make_room(table, row + 1)
        for column, value in zip(getattr(self.tables, table), values, strict=True):
            column[row] = value
        getattr(self.tables.counts, table)[0] = row + 1
        return row

    def drop(self, table: str, row: int, number: int = 1) -> None:
        """Remove a row, or several from there on; those after them move up."""
        rows = self.count(table)
        remove_rows(getattr(self.tables, table), row, number, rows)
        getattr(self.tables.counts, table)[0] = rows - number

    def new_id(self, kind: str) -> int:
        """Hand out the next id of a "body", "push", "law" or "joint"; none is used twice."""
        following = getattr(self.tables.state, f"next_{kind}")
        id: int = following[0]
        following[0] = id + 1
        return id

    # Bodies.

    def holds(self, body: Body) -> bool:
        """Whether this body is in the world."""
        row = self.rows.get(body.id)
        return row is not None and self.handles[row] is body

    def row(self, body: Body) -> int:
        """Row of a body.

        Raises:
            Removed: (a LookupError) if it is not, or no longer, in this world.
        """
        row = self.rows.get(body.id)
        if row is None or self.handles[row] is not body:
            where = "" if body._world.store is self else " but in another"
            raise Removed(f"{body.name} is not in this world{where}")
        return row

    def add_body(self, body: Body, shape: Shape, values: dict[str, float]) -> None:
        """Write a new body, the columns that were given for it and its shape, to a new row."""
        pieces, counts = shape.pieces, self.tables.counts
        row, piece, corner = counts.bodies[0], counts.pieces[0], counts.corners[0]
        last_piece = piece + len(pieces)
        last_corner = corner + sum([len(each.corners) for each in pieces])
        self.make_room("bodies", row + 1)
        self.make_room("pieces", last_piece)
        self.make_room("corners", last_corner)
        self.make_room("grid", 4 * last_piece)
        counts.bodies[0], counts.pieces[0], counts.corners[0] = row + 1, last_piece, last_corner
        write_body(self.tables, pieces, body.id, row, piece, corner, values)
        self.handles.append(body)
        self.rows[body.id] = row
        self.tables.state.stale[0] = 1
        self.list_fields()

    def remove_body(self, body: Body) -> None:
        """Take out a body with its corners, its pairs and all that pushes it."""
        row = self.row(body)
        if self.joints:
            self.loosen()
        for joint in reversed(self.joints):
            if body in (joint.a, joint.b):
                self.remove_joint(joint)
        for i in reversed(range(self.count("pushes"))):
            if self.tables.pushes.row[i] == row:
                self.drop("pushes", i)
        close_gap(self.tables.pushes.row, self.count("pushes"), row, 1)
        for i in reversed(range(self.count("ignored"))):
            if body.id in (self.tables.ignored.a[i], self.tables.ignored.b[i]):
                self.drop("ignored", i)
        pairs = forget(self.tables, self.count("pairs"), row)
        self.tables.counts.pairs[0], self.tables.counts.contacts[0] = pairs, 2 * pairs
        bodies, pieces = self.tables.bodies, self.tables.pieces
        first, corners = bodies.first[row], bodies.corners[row]
        first_piece, number = bodies.first_piece[row], bodies.pieces[row]
        self.drop("corners", first, corners)
        self.drop("pieces", first_piece, number)
        self.drop("bodies", row)
        close_gap(bodies.first, self.count("bodies"), first, corners)
        close_gap(bodies.first_piece, self.count("bodies"), first_piece, number)
        close_gap(pieces.first, self.count("pieces"), first, corners)
        close_gap(pieces.body, self.count("pieces"), row, 1)
        del self.handles[row]
        self.rows = {handle.id: i for i, handle in enumerate(self.handles)}
        self.list_fields()

    def make_room_for_pairs(self, pairs: int) -> None:
        """Let all tables have room for so many pairs at least."""
        progress = self.tables.progress
        if pairs > progress.room[0]:
            self.make_room("pairs", max(pairs + pairs // 2, PAIRS * self.count("pieces")))
            progress.room[0] = len(self.tables.pairs[0])
            for name in ("found", "parted"):
                self.make_room(name, progress.room[0])
            for name in ("contacts", "links"):
                self.make_room(name, 2 * progress.room[0])
            lanes = views(allocate(Lanes, 2 * progress.room[0]))  # empty between parts of a tick
            self.tables = self.tables._replace(lanes=lanes)

    # Joints.

    def row_of_joint(self, joint: Joint) -> int:
        """Row of a joint.

        Raises:
            Removed: (a LookupError) if it is not, or no longer, in this world.
        """
        if self.joint(joint.id) is not joint:
            raise Removed(f"joint {joint.id} is not in this world")
        return bisect_left(self.joints, joint.id, key=lambda each: each.id)

    def joint(self, id: int) -> Joint:
        """The joint with this id.

        Raises:
            Removed: (a LookupError) if there is none.
        """
        id = validate.identity(id, "a joint")
        row = bisect_left(self.joints, id, key=lambda each: each.id)
        if row == len(self.joints) or self.joints[row].id != id:
            raise Removed(f"there is no joint {validate.shown(id)} in this world")
        return self.joints[row]

    def add_joint(self, joint: Joint, values: dict[str, float], collide: bool) -> None:
        """Write a new joint, the columns that were given for it, to a new row."""
        row = self.count("joints")
        self.make_room("joints", row + 1)
        joints = self.tables.joints
        start_row(joints, row)
        joints.id[row] = joint.id
        for name, value in values.items():
            getattr(joints, name)[row] = value
        self.tables.counts.joints[0] = row + 1
        self.joints.append(joint)
        if joint.a is not None and joint.b is not None and not collide:
            self.ignore(joint.a, joint.b, joint.id)
        self.loosen()

    def remove_joint(self, joint: Joint) -> None:
        """Take out a joint."""
        row = self.row_of_joint(joint)
        self._let_collide(joint)
        self.drop("joints", row)
        del self.joints[row]
        self.loosen()

    def loosen(self) -> None:
        """Take note that joints came, went or changed."""
        self.tables.state.loose[0] = self.tables.state.stale[0] = 1
        self.wake_all()

    def order_joints(self) -> None:
        """Put the joints in order, if they changed."""
        if self.tables.state.loose[0]:
            from engine.linkage.order import put_in_order

            broken = self.tables.joints.broken
            for row, joint in enumerate(self.joints):
                if broken[row] == BREAKING:
                    broken[row] = BROKEN
                    self._let_collide(joint)
                    self.broken.append(joint)
            self.tables = put_in_order(self.tables, len(self.joints), self.rows)
            self.tables.state.loose[0] = 0

    def take_broken(self) -> list[Joint]:
        """The joints that broke since this was last asked."""
        self.order_joints()
        broken, self.broken = self.broken, []
        return broken

    def _let_collide(self, joint: Joint) -> None:
        """Let the bodies of a joint touch each other again."""
        if joint.a is not None and joint.b is not None:
            self.heed(joint.a, joint.b, joint.id)

    # Sleep.

    def wake(self, row: int) -> None:
        """Wake a body with those that it rests on, and that rest on it."""
        if self.tables.bodies.asleep[row]:
            from engine.kernels.sleeping import wake

            wake(self.tables, row)

    def wake_all(self) -> None:
        """Wake all bodies."""
        for row in np.flatnonzero(np.asarray(self.tables.bodies.asleep)[: self.count("bodies")]):
            self.wake(int(row))

    # Pairs that pass through each other.

    def ignore(self, a: Body, b: Body, joint: int = 0) -> bool:
        """Let two bodies pass through each other, by hand or on behalf of a joint; return whether
        that is new.
        """
        row, found = row_of_ignored(self.tables, a.id, b.id, joint)
        if not found:
            last = self.append("ignored", (min(a.id, b.id), max(a.id, b.id), joint))
            move_row(self.tables.ignored, last, row)
        return not found

    def heed(self, a: Body, b: Body, joint: int = 0) -> bool:
        """Take that back; return whether there was anything to be taken back."""
        row, found = row_of_ignored(self.tables, a.id, b.id, joint)
        if found:
            self.drop("ignored", row)
        return found

    def ignores(self, a: Body, b: Body) -> bool:
        """Whether two bodies were told to pass through each other, by whomever."""
        keys = ignored_keys(self.tables.ignored, self.count("ignored"))
        return bool((keys == pair_keys(a.id, b.id)).any())

    # Materials.

    def material(self, name: Any) -> int:
        """Number of a material, whose name is kept; 0 for None."""
        number = number_or_none(name)
        if number:
            self.materials[number] = name
        return number

    def pair_materials(self, names: tuple[str, str], row: tuple[float, ...]) -> None:
        """Write what two materials are to each other, in place of what stood there."""
        for name in names:
            self.material(name)
        known = self.tables.materials
        for i in range(self.count("materials")):
            if (known.a[i], known.b[i]) == row[:2]:
                self.drop("materials", i)
                break
        self.append("materials", row)

    # Laws of force.

    def add_law(self, law: ActingLaw) -> None:
        """Let a law act."""
        self.acting[law.id] = law
        self.list_fields()
        self.wake_all()

    def remove_law(self, law: ActingLaw) -> None:
        """Let a law act no more, if it does."""
        if self.acting.get(law.id) is law:
            del self.acting[law.id]
            self.list_fields()
            self.wake_all()

    def list_fields(self) -> None:
        """List anew which laws of force act on which rows."""
        if self.acting or self.tables.fields.used[0]:
            fields = field_table(tuple(self.acting.values()), self.rows, self.handles)
            self.tables = self.tables._replace(fields=fields)

    # The whole.

    @contextmanager
    def asked(self) -> Iterator[None]:
        """Ask functions that must not change the world: laws of force, and rules."""
        self.asking = True
        try:
            yield
        finally:
            self.asking = False

    def refuse_while_asking(self) -> None:
        """Refuse to be changed by a function that is asked within a step."""
        if self.asking:
            raise RuntimeError("a law of force or a rule must not change the world that asks it")

    def distrust(self) -> None:
        """Let loads no longer be relied on: somebody acts on the world."""
        self.refuse_while_asking()
        self.tables.state.trusted[0] = 0

    def open_books(self) -> None:
        """Look, before the first thing that is done between two ticks, what there is."""
        if self.before is None:
            self.before = totals(self.tables)

    def close_books(self) -> None:
        """Book what was done between two ticks."""
        if self.before is not None:
            book_hand(self.tables, self.before)
            self.before = None

    def snapshot(self, laws: Laws, rules: Rules) -> Snapshot:
        """Copy all that varies in a world with these laws and rules."""
        self.close_books()
        used = {name: self.count(name) for name in Counts._fields}
        used |= {"counts": 1, "state": 1, "books": 1}
        columns = {
            name: tuple(column[:rows].copy() for column in arrays(getattr(self.tables, name)))
            for name, rows in used.items()
        }
        return Snapshot(
            tables=columns,
            handles=tuple(self.handles),
            force_laws=tuple(self.acting.values()),
            joints=tuple(self.joints),
            laws=laws,
            rules=rules,
        )

    def restore(self, snapshot: Snapshot) -> None:
        """Go back to the tables that a snapshot holds, and to what they belong to."""
        from engine.kernels.pairing import link

        self.before = None
        loose = self.tables.state.loose[0] or self.joints or snapshot.joints
        self.make_room("grid", 4 * len(snapshot.tables["pieces"][0]))
        self.make_room_for_pairs(len(snapshot.tables["pairs"][0]))
        for name, saved in snapshot.tables.items():
            rows = len(saved[0])
            self.make_room(name, rows)
            for column, values in zip(arrays(getattr(self.tables, name)), saved, strict=True):
                column[:rows] = values
        link(self.tables, self.count("bodies"), self.count("pairs"))
        self.handles = list(snapshot.handles)
        self.rows = {handle.id: i for i, handle in enumerate(self.handles)}
        self.acting = {law.id: law for law in snapshot.force_laws}
        self.list_fields()
        self.joints = list(snapshot.joints)
        self.tables.state.loose[0] |= int(bool(loose))
        self.tables.progress.straight[0] = 0

    def digest(self) -> str:
        """Hash of the state (SHA-256, hexadecimal): equal for equal worlds on any machine."""
        return digest(self.tables, self.time)

    # The clock.

    @property
    def time(self) -> float:
        """Since the world began (s)."""
        state = self.tables.state
        return state.base[0] + state.ticks[0] * state.dt[0]


def close_gap(column: Any, rows: int, start: int, length: int) -> None:
    """Let row numbers in a column follow rows that moved up, as `length` rows from `start` left."""
    numbers = np.asarray(column)[:rows]
    numbers[numbers > start] -= length
