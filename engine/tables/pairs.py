"""Tables of what may touch and what does."""

from typing import NamedTuple

from engine.tables.columns import Floats, Ints

FREE, RESTING, PASSING, SENSING, SLEEPING = range(5)
"""States of a pair: they move on their own; they rest on each other; one comes through a one-sided
wall from behind; one of them is a sensor; they rested on each other when they fell asleep."""


NEVER = 1e300
"""A time that does not come (s)."""

LATER = -1.0
"""A time that is still to be found (s)."""


IMPACTS_AT_ONCE = 4096
"""Rows of the table of impacts; after so many in one tick the kernel pauses to have it emptied."""


MOST_HITS = 256
"""Rows of the table of points that are struck at one instant."""


class Pairs(NamedTuple):
    """One row two pieces of two bodies whose boxes overlap, sorted by (piece_a, piece_b).

    What only pairs have that touch lies side by side; through the rest kernels go pair by pair.
    """

    a: Ints
    """Rows of `Bodies`, a < b."""
    b: Ints
    piece_a: Ints
    """Rows of `Pieces`."""
    piece_b: Ints
    restitution: Floats
    friction: Floats
    """Of what slides."""
    static_friction: Floats
    """Of what rests, at least as large."""
    rolling_resistance: Floats
    """Lever arm by which the normal force resists rolling (m)."""
    belt_speed: Floats
    """Of the surface of b past that of a along the tangent, if the bodies stood still (m/s)."""
    rolling_torque: Floats
    """With which the resting contact resisted rolling, on b, in its last part (N m)."""
    slid: Floats
    """How fast b slid past a along the tangent when a part began in which kinetic friction acts
    (m/s); 0: static friction does, as they held to each other."""
    size: Floats
    """Reach of the smaller body (m), the scale of all tolerances."""
    state: Ints
    """`FREE`, `RESTING`, `PASSING`, `SENSING` or `SLEEPING`."""
    normal_x: Floats
    """Unit normal from a to b of the resting contact; its tangent is this turned left."""
    normal_y: Floats
    points: Ints
    """Number of rows in `Contacts`, 0 to 2, from row 2 * pair on."""
    booked_rolling: Floats
    """What of the rolling resistance has been booked (N m s)."""
    lane: Ints
    """Row of `Lanes` while a crowd is packed, -1: none; see `crowds`."""
    acting: Ints
    """Number of those that act in the present part, whatever impacts make of the pair meanwhile."""
    carried: Floats
    """Change of normal velocity that the resting contact brought about in its last part (m/s)."""
    part: Floats
    """Length of that part (s)."""
    steady: Ints
    """1 if that part was a steady one."""
    seen_x: Floats
    """From the centre of a to that of b, when the contact was last measured (m)."""
    seen_y: Floats
    seen_angle_a: Floats
    """Angles of both bodies then (rad)."""
    seen_angle_b: Floats
    drift: Floats
    """How far the two moved over each other since their points were found (m)."""
    apart: Floats
    """The surfaces of a free pair are at least so far apart when a part begins (m); those of a
    sensor and a body so far, or so deep in each other."""
    clear: Floats
    """For so long a free pair does not meet if all fly straight on, see `Progress.straight` (s)."""
    touched: Ints
    """Number of the tick in which the two last touched, or began to rest; see `touches`."""
    touched_before: Ints
    """Number of the tick in which they had touched before."""
    given_x: Floats
    """Impulse that b was given in the tick `touched`, but for what `Contacts` holds (N s)."""
    given_y: Floats
    hit_x: Floats
    """Where their last impact was (m, world)."""
    hit_y: Floats
    bounces: Ints
    """How many flights on end were shorter than a substep."""
    struck: Floats
    """Time of the last impact since the present tick began (s), mostly negative."""
    meeting: Floats
    """When the two meet in the present part of the tick (s), or `NEVER`, or `LATER`."""
    speed: Floats
    """With which they then approach each other (m/s)."""
    queued: Ints
    """Place of the pair in `queue`, from 1; 0: none."""
    queue: Ints
    """Pairs that meet in the present part, a heap (a list of its own, not by row); see `agenda`."""
    resting: Ints
    """Pairs that rest in the present part, in order (a list of its own, not by row)."""
    grouped: Ints
    """The same in the order of groups of joined bodies; see `linkage.limb_groups`."""
    bears: Ints
    """Row in `Structures` of what a resting pair bears by a much lighter body, or -1; see
    `linkage.loaded`."""
    waiting: Ints
    """Pairs that rest steadily through the present tick (a list of its own); see `islands`."""


class Contacts(NamedTuple):
    """Points of resting contacts, two rows a pair."""

    feature: Ints
    """Which corners made it, to find it again in the next part."""
    gap: Floats
    """Distance of the surfaces (m), negative if they overlap."""
    normal_arm_a: Floats
    """Lever arm of a unit impulse along the normal about the centre of a, r x n (m)."""
    tangent_arm_a: Floats
    """The same along the tangent, r x t = r . n (m)."""
    normal_arm_b: Floats
    tangent_arm_b: Floats
    normal_mass: Floats
    """Impulse that changes the normal velocity by 1 m/s (kg)."""
    tangent_mass: Floats
    target: Floats
    """Speed with which the bodies are to approach, less if negative, in the present pass (m/s);
    while they are measured, with which they opened before, or `NEVER`."""
    hardness: Floats
    """Impulse per speed that is missing, in the present pass (kg)."""
    softness: Floats
    """Share of the impulse that the spring drops in the present pass."""
    normal_impulse: Floats
    """Summed over the part (N s)."""
    tangent_impulse: Floats
    normal_load: Floats
    """What bears the forces in a steady part; the rest stops what still moves (N)."""
    tangent_load: Floats
    booked_normal: Floats
    """What of the impulses has been booked (N s)."""
    booked_tangent: Floats


class Touch(NamedTuple):
    """Where two pieces touch, as the geometry last found it: two rows, the normal in the first; and
    two rows of where two bodies touch with all theirs, see `footprint`.
    """

    x: Floats
    """Point halfway between the surfaces (m, world)."""
    y: Floats
    gap: Floats
    """(m)"""
    normal_x: Floats
    """Unit normal from a to b."""
    normal_y: Floats
    feature: Ints


class Hits(NamedTuple):
    """One row a point at which bodies are struck at one instant; see `simultaneous`."""

    gathered: Ints
    """Pairs that are struck together (a list of its own, not by row)."""
    rested: Ints
    """1 for each of these that rested before (in the order of the list)."""
    rests: Ints
    """1 for one that does so from then on (in the order of the list)."""
    first: Ints
    """First row of each, and number of rows (in the order of the list)."""
    rows: Ints
    pair: Ints
    x: Floats
    """(m, world)"""
    y: Floats
    normal_x: Floats
    """Unit normal from a to b."""
    normal_y: Floats
    idle: Ints
    """1 for a point that is given nothing: others on both sides of it leave it nothing to bear, or
    it opens, and what bounces elsewhere drives it back."""
    came: Floats
    """Speed of approach before (m/s)."""
    leaves: Floats
    """With which the bodies leave each other at least (m/s)."""
    impulse: Floats
    """Along the normal (N s)."""
    slid: Floats
    """Speed of b past a, before; then without friction (m/s)."""
    along: Floats
    """Impulse of friction, on b, along the normal turned left (N s)."""
    met: Floats
    """Speed of approach before all of it (m/s); the others are those of one round."""
    given: Floats
    """Impulses of all rounds: along the normal, and of friction (N s)."""
    rubbed: Floats


class Unknowns(NamedTuple):
    """One row an impulse that is sought, of a point in `Hits`, or of `contact`; see
    `complementarity`.
    """

    a: Ints
    """Rows of `Bodies`."""
    b: Ints
    along_x: Floats
    """Unit vector along which it acts on b."""
    along_y: Floats
    arm_a: Floats
    """Its lever arms about the centres of the two (m)."""
    arm_b: Floats
    contact: Ints
    """Row of `Contacts` of a point at which something rests; see `linkage.loaded`."""
    value: Floats
    """(N s)"""
    least: Floats
    """Bounds of it (N s)."""
    most: Floats
    wanted: Floats
    """By how much a speed is to change by all impulses (m/s)."""
    lacks: Floats
    """What of that they have not yet brought about (m/s)."""
    free: Ints
    """Rows that are at no bound (a list of its own, not by row)."""
    change: Floats
    """Of the impulses in that list (N s)."""


class Delassus(NamedTuple):
    """What unit impulses change (1/kg), row by row; as many columns as there are impulses."""

    coupling: Floats
    factor: Floats
    """The same of those at no bound and what they lack, as far as it is eliminated."""


class Impacts(NamedTuple):
    """One row an impact, in order of time."""

    a: Ints
    """Rows of `Bodies`."""
    b: Ints
    x: Floats
    y: Floats
    normal_x: Floats
    normal_y: Floats
    impulse_x: Floats
    """Given to b (N s)."""
    impulse_y: Floats
    speed: Floats
    restitution: Floats
    time: Floats
    """Since the tick began (s); once it is over, since the world began."""
    written: Ints
    """First row: how many impacts stand here; second row: how many this tick has had."""


class Links(NamedTuple):
    """The pairs of each body, those of one body in sequence."""

    pair: Ints


class Ignored(NamedTuple):
    """One row two bodies that pass through each other, and why; sorted."""

    a: Ints
    """Ids of bodies, a < b."""
    b: Ints
    joint: Ints
    """Id of the joint that wants it so; 0: they were told to by hand."""


class Parted(NamedTuple):
    """One row a pair that was dropped from the list while, or just after, it touched."""

    a: Ints
    """Ids of bodies."""
    b: Ints
    touched: Ints
    """As in `Pairs`."""
    touched_before: Ints
    given_x: Floats
    given_y: Floats
    hit_x: Floats
    hit_y: Floats
    normal_x: Floats
    normal_y: Floats


class Found(NamedTuple):
    """Pairs of pieces whose boxes overlap, as they are found; as many rows as `Pairs` has."""

    a: Ints
    """Rows of `Pieces`, a < b."""
    b: Ints
    before_a: Ints
    """The same, half sorted."""
    before_b: Ints
    known: Ints
    """Which row of `Pairs` this pair had before, or -1."""


class Grid(NamedTuple):
    """Squares over the world in which the broad phase looks for neighbours; see `neighbours`."""

    start: Ints
    """By the number of a square: place of its first box."""
    order: Ints
    """By places: the piece, and its box (m)."""
    low_x: Floats
    low_y: Floats
    high_x: Floats
    high_y: Floats
    plain: Ints
    """1 if it may touch any other for which this is 1; see `neighbours.is_plain`."""
    square: Ints
    """By pieces: number of the square in which its box has its centre, or `neighbours.LARGER`."""
    column: Ints
    """By pieces: where that square is."""
    row: Ints
    extent: Floats
    """By pieces: width or height of the box, whichever is more (m)."""
