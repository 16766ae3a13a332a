"""A world as plain data, to be kept as JSON, sent to another process and continued there.

All columns of all tables are saved, the impulses of resting contacts too, so that the loaded world
goes on bit for bit. JSON writes a float in the shortest way that reads back as the same float.
"""

import math
import sys
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, get_args, get_type_hints

import numpy as np

from engine import validate
from engine.body import Body
from engine.filters import ALL
from engine.force_laws import ActingLaw, PointGravity, SpringTo, checked_law
from engine.forces import Force, LinearDrag, QuadraticDrag, Torque
from engine.joint import Joint
from engine.joints import KINDS as JOINTS
from engine.ledger import totals
from engine.materials import material_name
from engine.plain import INFINITIES, Decoder, Functions, encode, name_of
from engine.settings import INTEGRATORS, MOST_SUBSTEPS, Laws, Sleep, geometric_mean, larger
from engine.shapes import Shape
from engine.snapshot import Snapshot
from engine.tables import Books, Counts, Joints, Tables, allocate, arrays
from engine.tables.linkage import STRAINED
from engine.validate import shown

if TYPE_CHECKING:
    from engine.world import World

FORMAT = 1
"""Version of the data; other versions are refused."""

KINDS = (
    *get_args(Shape),
    Force,
    Torque,
    LinearDrag,
    QuadraticDrag,
    PointGravity,
    SpringTo,
    Sleep,
    *JOINTS,
)
"""Dataclasses that may stand in saved data."""

TABLES: dict[str, Any] = {
    name: kind
    for name, kind in get_type_hints(Tables).items()
    if name in (*Counts._fields, "state", "books")
}
"""What is saved; how many rows a table has says itself."""

ROWS_OF = {
    "bodies.first": "corners",
    "bodies.first_piece": "pieces",
    "pieces.body": "bodies",
    "pieces.first": "corners",
    "pairs.a": "bodies",
    "pairs.b": "bodies",
    "pairs.piece_a": "pieces",
    "pairs.piece_b": "pieces",
    "pushes.row": "bodies",
}
"""Columns that hold rows of another table, which kernels trust."""

AT_MOST = {
    "pairs.points": 2,
    "pairs.acting": 2,
    "pairs.state": 4,
    "pairs.queued": 1,
    "pairs.steady": 1,
    "bodies.parting": 1,
    "bodies.moves": 1,
    "bodies.sensor": 1,
    "bodies.asleep": 1,
    "bodies.restless": 1,
    "bodies.stuck": 2,
    "bodies.anchored": 1,
    "bodies.category": ALL,
    "bodies.mask": ALL,
    "pieces.one_sided": 1,
    "pieces.seams": 1,
    "corners.kind": 3,
    "state.stale": 1,
    "state.restless": 1,
    "state.deep": 2,
    "joints.kind": len(JOINTS) - 1,
    "joints.motor": 1,
    "joints.broken": 2,
    "joints.mode": STRAINED,
    "books.forced": 1,
}
"""Largest value of columns that hold a choice or a small number."""

COUNTS = (
    "bodies.id",
    "bodies.held",
    "bodies.calm",
    "pairs.bounces",
    "bodies.corners",
    "bodies.pieces",
    "pieces.corners",
    "pieces.before",
    "pieces.after",
    "bodies.group",
    "bodies.material",
    "materials.a",
    "materials.b",
    "ignored.a",
    "ignored.b",
    "ignored.joint",
    "pairs.touched",
    "pairs.touched_before",
    "parted.a",
    "parted.b",
    "parted.touched",
    "parted.touched_before",
    "pushes.id",
    "contacts.feature",
    "state.tick",
    "state.ticks",
    "state.next_body",
    "state.next_push",
    "state.next_law",
    "state.next_joint",
    "state.trusted",
    "joints.id",
    "joints.a",
    "joints.b",
)
"""Columns of other whole numbers, none negative."""

DERIVED = (
    "bodies.first_link",
    "bodies.links",
    "bodies.first_ignored",
    "bodies.joined",
    "bodies.waits",
    "bodies.cluster",
    "bodies.stirred",
    "bodies.burdens",
    "bodies.placed",
    "bodies.here_angle",
    "bodies.stands",
    "bodies.seen",
    "bodies.shoved",
    "bodies.block",
    "bodies.gained",
    "bodies.kicked",
    "bodies.bone",
    "bodies.absement_x",
    "bodies.absement_y",
    "bodies.from_absement_x",
    "bodies.from_absement_y",
    "pairs.queue",
    "pairs.resting",
    "pairs.grouped",
    "pairs.lane",
    "pairs.waiting",
    "pairs.slid",
    "state.loose",
)
"""Columns that are made anew before they are read: they are not saved."""

TURNS = tuple(name for name in Books._fields if name.endswith("_turn"))
"""Columns of `Books` that worlds which were saved before there were any lack, all of them."""

MOST = sys.float_info.max
"""Largest number of all."""

NOT_NEGATIVE = ("mass", "inverse_mass", "inertia", "inverse_inertia", "restitution", "friction")
"""Columns of `Bodies`."""

RULES = {"restitution_rule": larger, "friction_rule": geometric_mean}
"""What makes the coefficients of a pair, unless told otherwise."""

KEYS = ("format", "laws", "rules", "handles", "force_laws", "materials", "tables")


def to_dict(world: "World") -> dict[str, Any]:
    """Say all that varies in a world as plain data."""
    functions_of(world)
    saved = world.snapshot()
    own = {name: getattr(world, name) for name in RULES}
    return {
        "format": FORMAT,
        "laws": world.laws._asdict(),
        "rules": {name: None if own[name] is RULES[name] else encode(own[name]) for name in RULES},
        "handles": [
            {"id": body.id, "name": body.name, "shape": encode(body.shape)}
            for body in saved.handles
        ],
        "force_laws": [
            {"id": each.id, "law": encode(each.law), "bodies": _ids(each, world)}
            for each in saved.force_laws
        ],
        "materials": sorted(world.store.materials.values()),
        "tables": {
            name: {
                field: _listed(values)
                for field, values in zip(kind._fields, saved.tables[name], strict=True)
                if f"{name}.{field}" not in DERIVED
            }
            for name, kind in TABLES.items()
        },
    }


def functions_of(world: "World") -> dict[str, Any]:
    """The Python functions that the motion depends on, by the names under which they are saved.

    Raises:
        ValueError: if two of them have one name.
    """
    used = [rule for name, usual in RULES.items() if (rule := getattr(world, name)) is not usual]
    used += [law.law for law in world.force_laws if law.is_python]
    named: dict[str, Any] = {}
    for function in used:
        name = name_of(function)
        if named.setdefault(name, function) != function:
            raise ValueError(f"two functions are called {name}: a world cannot be saved with both")
    return named


def by_name(functions: Any) -> Functions:
    """Check functions that were handed in by their names; None is none."""
    handed: dict[str, Any] = {} if functions is None else functions
    if not isinstance(handed, Mapping) or not all(callable(each) for each in handed.values()):
        raise TypeError(f"functions must be a dictionary of functions, not {shown(functions)}")
    return handed


def refill(world: "World", data: dict[str, Any], functions: Functions) -> None:
    """Make a new, empty world what `to_dict` said.

    One that was saved before there were books of angular momentum begins them now: what it has was
    brought by hand.

    Raises:
        TypeError, ValueError: in one sentence, for data of another version or that `to_dict` would
            not have made.
        LookupError: for a function that is not among `functions`.
    """
    validate.keys(data, KEYS, "a saved world")
    validate.version(data["format"], FORMAT, "a saved world")
    decode = Decoder(KINDS, functions)
    validate.keys(data["rules"], tuple(RULES), "the rules of a saved world")
    for name, usual in RULES.items():
        rule = data["rules"][name]
        setattr(world, name, usual if rule is None else decode(rule))
    world.laws = _laws(data["laws"])
    validate.keys(data["tables"], tuple(TABLES), "the tables of a saved world")
    saved = data["tables"]
    begins = isinstance(saved["books"], dict) and not any(name in saved["books"] for name in TURNS)
    if begins:
        saved = saved | {"books": saved["books"] | {name: [0.0] for name in TURNS}}
    tables = {name: _table(name, saved[name]) for name in TABLES}
    _check_rows(tables)
    handles = tuple(
        _handle(world, each, decode) for each in validate.listed(data["handles"], "handles")
    )
    if [body.id for body in handles] != list(tables["bodies"].id):
        raise ValueError("the handles of a saved world must have the ids of its bodies, in order")
    _check_shapes(handles, tables)
    counts = tuple(np.array([len(tables[name][0])]) for name in Counts._fields)
    columns = {name: arrays(table) for name, table in tables.items()}
    acting = _force_laws(world, data["force_laws"], decode, handles)
    if acting and acting[-1].id >= tables["state"].next_law[0]:
        raise ValueError(f"next_law of a saved world must be beyond {acting[-1].id}")
    joints = _joints(world, tables["joints"], handles)
    if joints and joints[-1].id >= tables["state"].next_joint[0]:
        raise ValueError(f"next_joint of a saved world must be beyond {joints[-1].id}")
    for name in validate.listed(data["materials"], "the materials of a saved world"):
        world.store.material(material_name(name))
    columns |= {"counts": counts}
    world.restore(Snapshot(columns, handles, acting, joints, world.laws, world.rules))
    if begins:
        _, _, turn, _ = totals(world.store.tables).tolist()
        world.store.tables.books.hand_turn[0] = turn


def _ids(law: ActingLaw, world: "World") -> list[int] | None:
    """Of the bodies on which a law acts, those that are still there."""
    return None if law.bodies is None else [body.id for body in law.bodies if body in world]


def _listed(values: Any) -> list[Any]:
    """A column as a list, infinities spelt out."""
    listed: list[Any] = values.tolist()
    if values.dtype.kind == "f" and not np.isfinite(values).all():
        if np.isnan(values).any():
            raise ValueError("a world with a number that is none (NaN) cannot be saved")
        listed = [x if math.isfinite(x) else ("inf" if x > 0.0 else "-inf") for x in listed]
    return listed


def _laws(data: Any) -> Laws:
    validate.keys(data, Laws._fields, "the laws of a saved world")
    whole = ("integrator", "substeps")
    values = {name: _number(f"laws.{name}", data[name], name in whole) for name in Laws._fields}
    laws = Laws(**values)
    if not (0 <= laws.integrator < len(INTEGRATORS) and 1 <= laws.substeps <= MOST_SUBSTEPS):
        raise ValueError(f"no world has integrator {laws.integrator}, {laws.substeps} substeps")
    if not (laws.linear_drag >= 0.0 and laws.quadratic_drag >= 0.0):
        raise ValueError("the drag of a saved world must not be negative")
    if laws.linear_drag > 0.0 and laws.quadratic_drag > 0.0:
        raise ValueError("a saved world has one law of drag, not two")
    return laws


def _number(name: str, value: Any, whole: bool) -> Any:
    """Check a finite number."""
    kinds = int if whole else int | float
    if isinstance(value, bool) or not isinstance(value, kinds):
        raise TypeError(f"{name} of a saved world must be a number, not {shown(value)}")
    if not abs(value) <= MOST:
        raise ValueError(f"{name} of a saved world must be finite, not {shown(value)}")
    return value if whole else float(value)


def _handle(world: "World", data: Any, decode: Decoder) -> Body:
    validate.keys(data, ("id", "name", "shape"), "a handle of a saved world")
    id, name, shape = data["id"], data["name"], decode(data["shape"])
    if not isinstance(name, str) or not isinstance(shape, Shape):
        raise TypeError(
            f"a saved body must have a name and a shape, not {shown(name)} and {shown(shape)}"
        )
    return Body(world, _number("id", id, True), shape, name)


def _joints(world: "World", table: Joints, handles: tuple[Body, ...]) -> tuple[Joint, ...]:
    """The handles of the joints; refuse joints of bodies that are not there."""
    body_of: dict[int, Body | None] = {0: None} | {body.id: body for body in handles}
    joints = []
    columns = [np.asarray(column) for column in (table.id, table.a, table.b, table.size)]
    for id, a, b, size in zip(*columns, strict=True):
        if a == b or a not in body_of or b not in body_of or not size > 0.0:
            raise ValueError(f"joint {id} of a saved world must join two bodies that are there")
        joints.append(Joint(world, int(id), body_of[int(a)], body_of[int(b)]))
    if (np.diff(np.asarray(table.id)) <= 0).any():
        raise ValueError("the joints of a saved world must stand in order, none twice")
    return tuple(joints)


def _force_laws(
    world: "World", data: Any, decode: Decoder, handles: tuple[Body, ...]
) -> tuple[ActingLaw, ...]:
    by_id = {body.id: body for body in handles}
    acting: list[ActingLaw] = []
    for each in validate.listed(data, "the laws of force of a saved world"):
        validate.keys(each, ("id", "law", "bodies"), "a law of force of a saved world")
        id, ids, bodies = _number("id", each["id"], True), each["bodies"], None
        if ids is not None:
            listed = validate.listed(ids, "the bodies of a law")
            if not all(isinstance(i, int) and i in by_id for i in listed):
                raise ValueError(f"law {id} acts on bodies {ids}, but not all of them are saved")
            bodies = tuple(by_id[i] for i in listed)
        if acting and id <= acting[-1].id:
            raise ValueError("the laws of force of a saved world must stand in order, none twice")
        acting.append(ActingLaw(world, id, checked_law(decode(each["law"])), bodies))
    return tuple(acting)


def _table(name: str, data: Any) -> Any:
    """The arrays of a table, all of one length."""
    kind = TABLES[name]
    saved = tuple(field for field in kind._fields if f"{name}.{field}" not in DERIVED)
    validate.keys(data, saved, f"the table {name} of a saved world")
    rows = len(validate.listed(data[saved[0]], f"{name}.{saved[0]} of a saved world"))
    table = allocate(kind, rows)
    for field in saved:
        where = f"{name}.{field}"
        listed = validate.listed(data[field], f"{where} of a saved world", rows)
        column = np.asarray(getattr(table, field))
        column[:] = [_cell(where, value, column.dtype.kind == "i") for value in listed]
    return table


def _cell(where: str, value: Any, whole: bool) -> Any:
    """Check one value of a column."""
    if not whole and isinstance(value, str) and value in INFINITIES:
        return INFINITIES[value]
    number = _number(where, value, whole)
    if whole and not 0 <= number < 2**62:
        raise ValueError(f"{where} of a saved world cannot be {number}")
    return number


def _check_rows(tables: dict[str, Any]) -> None:
    """Refuse rows that are not there: kernels trust them."""

    def column(where: str) -> Any:
        table, field = where.split(".")
        return getattr(tables[table], field)

    rows = {name: len(table[0]) for name, table in tables.items()}
    limits = {where: rows[of] - 1 for where, of in ROWS_OF.items()} | AT_MOST
    for where, most in limits.items():
        if (column(where) > most).any():
            raise ValueError(f"{where} of a saved world must be at most {most}")
    bodies, pairs = tables["bodies"], tables["pairs"]
    pieces = tables["pieces"]
    for part in (bodies, pieces):
        if not _follow_each_other(part.first, part.corners, rows["corners"]):
            raise ValueError("the bodies of a saved world must have corners that are there")
    if not _follow_each_other(bodies.first_piece, bodies.pieces, rows["pieces"]):
        raise ValueError("the bodies of a saved world must have pieces that are there")
    body = pieces.body
    if (body != np.repeat(np.arange(rows["bodies"]), bodies.pieces)).any():
        raise ValueError("the pieces of a saved world must name the bodies whose they are")
    if (np.maximum(pieces.before, pieces.after) > bodies.pieces[body]).any():
        raise ValueError("the neighbours of a saved link must be links of its chain")
    if (body[pairs.piece_a] != pairs.a).any() or (body[pairs.piece_b] != pairs.b).any():
        raise ValueError("the pairs of a saved world must name pieces of the bodies they name")
    if rows["contacts"] != 2 * rows["pairs"] or (pairs.a >= pairs.b).any():
        raise ValueError("a saved world must have two contacts a pair, and pairs of two bodies")
    for name in NOT_NEGATIVE:
        if (getattr(bodies, name) < 0.0).any():
            raise ValueError(f"bodies.{name} of a saved world must not be negative")
    for name in ("mass", "inertia"):
        own, inverse = getattr(bodies, name), getattr(bodies, f"inverse_{name}")
        with np.errstate(divide="ignore"):
            if not ((own > 0.0) & ((inverse == 0.0) | (inverse == 1.0 / own))).all():
                raise ValueError(f"inverse_{name} of a saved world must be that of its {name}")
    state = tables["state"]
    if rows["state"] != 1 or rows["books"] != 1 or state.dt[0] < 0.0 or state.base[0] < 0.0:
        raise ValueError(
            "a saved world must have one row of state and books, and its times not negative"
        )
    for kind, ids in (("body", bodies.id), ("push", tables["pushes"].id)):
        following = getattr(state, f"next_{kind}")[0]
        if len(ids) and ids[-1] >= following:
            raise ValueError(f"next_{kind} of a saved world must be beyond {ids[-1]}")
    if (np.diff(bodies.id) <= 0).any() or (np.diff(pairs.piece_a << 32 | pairs.piece_b) <= 0).any():
        raise ValueError("the bodies and pairs of a saved world must stand in order, none twice")


def _follow_each_other(first: Any, number: Any, rows: int) -> bool:
    """Whether so many rows each from a first one on, one or more, are all the rows of a table."""
    ends = np.cumsum(number)
    whole = int(ends[-1]) == rows if len(ends) else rows == 0
    return whole and bool((number >= 1).all() and (first == ends - number).all())


def _check_shapes(handles: tuple[Body, ...], tables: dict[str, Any]) -> None:
    """Refuse handles whose shapes are not those of the tables."""
    bodies, pieces = tables["bodies"], tables["pieces"]
    for row, body in enumerate(handles):
        rows = slice(bodies.first_piece[row], bodies.first_piece[row] + bodies.pieces[row])
        told = list(zip(pieces.corners[rows].tolist(), pieces.radius[rows].tolist(), strict=True))
        if told != [(len(piece.corners), piece.radius) for piece in body.shape.pieces]:
            raise ValueError(
                f"{body.name} of a saved world must have the shape that is in its rows"
            )
