"""All tables of a world."""

from inspect import get_annotations
from typing import NamedTuple

from engine.tables.bodies import Bodies, Corners, Fields, Materials, Pieces, Pushes
from engine.tables.columns import Floats, Ints, allocate, views
from engine.tables.lanes import Lanes
from engine.tables.limbs import Bones, Limbs, Trees
from engine.tables.linkage import (
    Arms,
    Braces,
    Couplings,
    Equations,
    Joints,
    Nodes,
    Profile,
    Structures,
)
from engine.tables.pairs import (
    IMPACTS_AT_ONCE,
    MOST_HITS,
    Contacts,
    Delassus,
    Found,
    Grid,
    Hits,
    Ignored,
    Impacts,
    Links,
    Pairs,
    Parted,
    Touch,
    Unknowns,
)


class Counts(NamedTuple):
    """One row: how many rows are in use of the tables of the same names.

    These tables are what a world remembers; all others are written anew by each step.
    """

    bodies: Ints
    pieces: Ints
    corners: Ints
    pushes: Ints
    pairs: Ints
    contacts: Ints
    """Twice the number of pairs."""
    ignored: Ints
    parted: Ints
    joints: Ints
    materials: Ints


class State(NamedTuple):
    """One row: what a world remembers besides."""

    tick: Ints
    """Number of steps taken."""
    base: Floats
    """Time (s) when the present length of a tick came in use."""
    ticks: Ints
    """Number of steps since: the time is base + ticks * dt, so that sixty ticks are 1 s."""
    dt: Floats
    """Length of the last tick (s)."""
    next_body: Ints
    """Id that the next body gets."""
    next_push: Ints
    next_law: Ints
    next_joint: Ints
    stale: Ints
    """1 if the list of pairs is to be made anew, whatever the boxes say."""
    loose: Ints
    """1 if the joints are to be put in order anew."""
    trusted: Ints
    """Ticks for which what rests steadily relies on its loads; see `steady`."""
    deep: Ints
    """2 once bodies overlap deeply in this tick, 1 if they did in the last; see `parting`."""
    restless: Ints
    """1 if a crowd rests in the present part and did not become calm at once; see `contacts`."""
    pace: Floats
    """Parts a second that trees of few limbs take, as they are held to; see `linkage.pace`."""
    asked: Floats
    """The most that they have asked for (1/s) since"""
    paced: Floats
    """so many seconds ago, when it was last looked at."""


class Books(NamedTuple):
    """One row: what each cause has given since the world began; see `ledger` for what they are."""

    gravity_x: Floats
    """Impulses (N s)."""
    gravity_y: Floats
    push_x: Floats
    push_y: Floats
    field_x: Floats
    field_y: Floats
    drag_x: Floats
    drag_y: Floats
    wall_x: Floats
    wall_y: Floats
    joint_x: Floats
    joint_y: Floats
    hand_x: Floats
    hand_y: Floats
    integrator_x: Floats
    integrator_y: Floats
    gravity_turn: Floats
    """Angular impulses about the origin (N m s)."""
    push_turn: Floats
    field_turn: Floats
    drag_turn: Floats
    wall_turn: Floats
    joint_turn: Floats
    particle_turn: Floats
    correction_turn: Floats
    hand_turn: Floats
    integrator_turn: Floats
    gravity_work: Floats
    """Energy that was given (J)."""
    push_work: Floats
    field_work: Floats
    wall_work: Floats
    joint_work: Floats
    hand_work: Floats
    integrator_work: Floats
    restitution_heat: Floats
    """Energy that was taken (J)."""
    friction_heat: Floats
    contact_heat: Floats
    drag_heat: Floats
    forced: Ints
    """1 if any force but those of contacts and joints may act in the present tick."""


class Progress(NamedTuple):
    """One row: how far the kernels are within a tick, and why they paused."""

    phase: Ints
    """One of the phases in `kernels.status`."""
    begun: Ints
    """1 once bodies have begun to move in this tick."""
    now: Floats
    """Since the tick began (s)."""
    told: Ints
    """Rows of `Impacts` whose time is that of the world."""
    lost: Ints
    """Row of the body that left the range of numbers."""
    room: Ints
    """Number of pairs for which all tables have room."""
    wanted: Ints
    """Number of pairs for which they should."""
    straight: Ints
    """1 while nothing but impacts changes the velocity of any body: no accelerations, no bent
    paths, nothing rests; `Pairs.clear` then holds."""
    together: Floats
    """When what meets next meets (s), for all pairs that do so at once; see `agenda`."""
    sensing: Ints
    """Number of pairs with a sensor."""
    one_sided: Ints
    """Number of pairs with a wall that stops only what comes from its left."""
    own_rules: Ints
    """1 if coefficients of pairs are made by Python."""
    roused: Ints
    """1 once something hit what waits, or came to rest on it; 2 if all that waits is to end that;
    see `rousing`."""
    linked: Ints
    """Number of pairs with a link of a chain."""
    riding: Ints
    """Number of contacts in the present part with links of curves; see `riding`."""
    begins: Ints
    """1 once a pair came to rest in the present tick; see `standing`."""
    final: Ints
    """1 if a part will not be made shorter where hinges find no good solution for it."""
    owed: Floats
    """Length of the part (s) for whose end some trees of hinges owe what they exert: they exert it
    as the next begins; 0: none does. See `owing`."""
    torn: Ints
    """1 if a hinge of a tree is torn, or nearly so, as limbs were last placed."""
    stalled: Ints
    """Parts in a row that ended as they began; see `resting.STALLS`."""
    sweeps: Ints
    """Sweeps over resting contacts that a part has at most."""
    recording: Ints
    """Which columns of `Tracks` to write, one bit each; 0: none."""
    moment: Ints
    """Number of ticks that stand in `Tracks`."""


class Tracks(NamedTuple):
    """One row a body and tick: what `run` recorded, tick after tick; see `Bodies`."""

    x: Floats
    y: Floats
    angle: Floats
    vx: Floats
    vy: Floats
    spin: Floats
    force_x: Floats
    force_y: Floats
    torque: Floats


class Tables(NamedTuple):
    """All that varies in a world, and what the kernels of a step write down on the way."""

    bodies: Bodies
    pieces: Pieces
    corners: Corners
    pushes: Pushes
    pairs: Pairs
    contacts: Contacts
    links: Links
    lanes: Lanes
    touch: Touch
    hits: Hits
    unknowns: Unknowns
    delassus: Delassus
    impacts: Impacts
    joints: Joints
    braces: Braces
    nodes: Nodes
    structures: Structures
    equations: Equations
    arms: Arms
    couplings: Couplings
    profile: Profile
    limbs: Limbs
    bones: Bones
    trees: Trees
    counts: Counts
    state: State
    books: Books
    fields: Fields
    ignored: Ignored
    parted: Parted
    materials: Materials
    found: Found
    grid: Grid
    progress: Progress
    tracks: Tracks


ROWS = {
    "bodies": 16,
    "pieces": 16,
    "corners": 64,
    "pushes": 8,
    "pairs": 256,
    "contacts": 512,
    "links": 512,
    "lanes": 512,
    "found": 256,
    "parted": 256,
    "grid": 128,
    "touch": 4,
    "hits": MOST_HITS,
    "unknowns": MOST_HITS,
    "delassus": MOST_HITS * (MOST_HITS + 1),
    "impacts": IMPACTS_AT_ONCE,
    "joints": 4,
    "braces": 8,
    "nodes": 2,
    "bones": 12,
}
"""Rows that the tables of a new world have room for; those that are not named have one."""


def new_tables() -> Tables:
    """Make the tables of an empty world."""
    kinds = get_annotations(Tables)
    return Tables(
        **{name: views(allocate(kinds[name], ROWS.get(name, 1))) for name in Tables._fields}
    )
