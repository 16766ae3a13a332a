"""A world as plain data, to be kept as JSON, sent to another process and continued there.

All columns of all tables are saved, the impulses of resting contacts too, so that the loaded world
goes on bit for bit. JSON writes a float in the shortest way that reads back as the same float.
"""

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, get_args

import numpy as np

from engine import validate
from engine.body import Body
from engine.force_laws import ActingLaw, PointGravity, SpringTo, checked_law
from engine.forces import Force, LinearDrag, QuadraticDrag, Torque
from engine.joint import Joint
from engine.joints import KINDS as JOINTS
from engine.ledger import totals
from engine.materials import material_name
from engine.plain import Decoder, Functions, encode, name_of
from engine.portable import DERIVED, HELD, TABLES, TURNS, check_rows, number, read_table
from engine.settings import INTEGRATORS, MOST_SUBSTEPS, Laws, Sleep, geometric_mean, larger
from engine.shapes import Shape
from engine.snapshot import Snapshot
from engine.tables import Counts, Joints, arrays
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
    if isinstance(saved["state"], dict) and not any(name in saved["state"] for name in HELD):
        saved = saved | {"state": saved["state"] | {name: [0.0] for name in HELD}}
    begins = isinstance(saved["books"], dict) and not any(name in saved["books"] for name in TURNS)
    if begins:
        saved = saved | {"books": saved["books"] | {name: [0.0] for name in TURNS}}
    tables = {name: read_table(name, saved[name]) for name in TABLES}
    check_rows(tables)
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
    values = {name: number(f"laws.{name}", data[name], name in whole) for name in Laws._fields}
    laws = Laws(**values)
    if not (0 <= laws.integrator < len(INTEGRATORS) and 1 <= laws.substeps <= MOST_SUBSTEPS):
        raise ValueError(f"no world has integrator {laws.integrator}, {laws.substeps} substeps")
    if not (laws.linear_drag >= 0.0 and laws.quadratic_drag >= 0.0):
        raise ValueError("the drag of a saved world must not be negative")
    if laws.linear_drag > 0.0 and laws.quadratic_drag > 0.0:
        raise ValueError("a saved world has one law of drag, not two")
    return laws


def _handle(world: "World", data: Any, decode: Decoder) -> Body:
    validate.keys(data, ("id", "name", "shape"), "a handle of a saved world")
    id, name, shape = data["id"], data["name"], decode(data["shape"])
    if not isinstance(name, str) or not isinstance(shape, Shape):
        raise TypeError(
            f"a saved body must have a name and a shape, not {shown(name)} and {shown(shape)}"
        )
    return Body(world, number("id", id, True), shape, name)


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
        id, ids, bodies = number("id", each["id"], True), each["bodies"], None
        if ids is not None:
            listed = validate.listed(ids, "the bodies of a law")
            if not all(isinstance(i, int) and i in by_id for i in listed):
                raise ValueError(f"law {id} acts on bodies {ids}, but not all of them are saved")
            bodies = tuple(by_id[i] for i in listed)
        if acting and id <= acting[-1].id:
            raise ValueError("the laws of force of a saved world must stand in order, none twice")
        acting.append(ActingLaw(world, id, checked_law(decode(each["law"])), bodies))
    return tuple(acting)


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
