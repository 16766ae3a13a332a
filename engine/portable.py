"""The tables of a world as plain data: which columns are saved, and what is refused of saved ones.

Kernels trust what stands in tables: what is read from a file is checked number by number.
"""

import sys
from typing import TYPE_CHECKING, Any, get_type_hints

import numpy as np

from engine import validate
from engine.filters import ALL
from engine.joints import KINDS as JOINTS
from engine.plain import INFINITIES
from engine.tables import Books, Counts, Tables, allocate
from engine.tables.linkage import STRAINED
from engine.validate import shown

if TYPE_CHECKING:
    pass

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
    "bodies.rides",
    "bodies.bent",
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
    "pairs.bears",
    "pairs.grouped",
    "pairs.lane",
    "pairs.waiting",
    "pairs.slid",
    "state.loose",
)
"""Columns that are made anew before they are read: they are not saved."""

TURNS = tuple(name for name in Books._fields if name.endswith("_turn"))
"""Columns of `Books` that worlds which were saved before there were any lack, all of them."""

HELD = ("pace", "asked", "paced")
"""Columns of `State` that worlds which were saved before paces were held lack, all of them."""

MOST = sys.float_info.max
"""Largest number of all."""

NOT_NEGATIVE = ("mass", "inverse_mass", "inertia", "inverse_inertia", "restitution", "friction")
"""Columns of `Bodies`."""


def number(name: str, value: Any, whole: bool) -> Any:
    """Check a finite number of saved data, by its name."""
    kinds = int if whole else int | float
    if isinstance(value, bool) or not isinstance(value, kinds):
        raise TypeError(f"{name} of a saved world must be a number, not {shown(value)}")
    if not abs(value) <= MOST:
        raise ValueError(f"{name} of a saved world must be finite, not {shown(value)}")
    return value if whole else float(value)


def read_table(name: str, data: Any) -> Any:
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
    checked = number(where, value, whole)
    if whole and not 0 <= checked < 2**62:
        raise ValueError(f"{where} of a saved world cannot be {checked}")
    return checked


def check_rows(tables: dict[str, Any]) -> None:
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
    if not all(0.0 <= getattr(state, name)[0] <= MOST for name in HELD):
        raise ValueError("the pace of joints in a saved world must be finite and not negative")
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
