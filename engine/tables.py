"""All that varies in a world, as tables of one-dimensional columns, one row a thing.

Kernels read and write the columns by index. They are numpy arrays for compiled kernels and for
bulk work, and memoryviews of the same arrays for interpreted kernels (twice as fast to index).
"""

from typing import Any, NamedTuple, Protocol, TypeVar, get_type_hints

import numpy as np


class Floats(Protocol):
    """A column of float64."""

    def __getitem__(self, row: int, /) -> float:
        """Value of a row."""
        ...

    def __setitem__(self, row: int, value: float, /) -> None:
        """Set the value of a row."""
        ...

    def __len__(self) -> int:
        """Number of rows there is room for."""
        ...


class Ints(Protocol):
    """A column of int64."""

    def __getitem__(self, row: int, /) -> int:
        """Value of a row."""
        ...

    def __setitem__(self, row: int, value: int, /) -> None:
        """Set the value of a row."""
        ...

    def __len__(self) -> int:
        """Number of rows there is room for."""
        ...


class Bodies(NamedTuple):
    """One row a body, in the order of their ids. World frame, SI units."""

    id: Ints
    x: Floats
    """Centre of mass (m); 0 for a wall, whose corners are in world coordinates."""
    y: Floats
    angle: Floats
    """Counter-clockwise (rad)."""
    vx: Floats
    """(m/s). Within a tick: the velocity of the pose at `clock`."""
    vy: Floats
    spin: Floats
    """(rad/s)"""
    mass: Floats
    """(kg); infinite for a wall."""
    inverse_mass: Floats
    """(1/kg); 0 makes a body deaf to forces and impulses."""
    inertia: Floats
    """(kg m^2); infinite for walls and particles."""
    inverse_inertia: Floats
    """(1/(kg m^2)); 0 keeps a body from turning."""
    restitution: Floats
    friction: Floats
    """Of what slides, and of what rests unless `static_friction` says otherwise."""
    static_friction: Floats
    """Of what rests; `settings.AS_FRICTION` if it is no other."""
    rolling_resistance: Floats
    """Lever arm by which the normal force resists rolling (m)."""
    surface_speed: Floats
    """Of the surface along the edge (m/s): counter-clockwise; of a wall: from start to end."""
    material: Ints
    """Number of its name, see `materials`; 0: none."""
    sensor: Ints
    """1 for a body that notices what overlaps it and acts on nothing."""
    category: Ints
    """Bits of the kinds of body that it is; see `filters`."""
    mask: Ints
    """Bits of the categories that it touches."""
    group: Ints
    """Bodies of the same group pass through each other; 0: none."""
    gravity_scale: Floats
    """By which the gravity of the world is multiplied for this body."""
    force_x: Floats
    """What acted during the last tick, contacts apart, as its mean over the tick (N)."""
    force_y: Floats
    torque: Floats
    """(N m)"""
    held: Ints
    """Number of resting contacts at the end of the last tick, one more for joined bodies."""
    joined: Ints
    """1 for a body that moves and that a joint holds."""
    calm: Ints
    """For how many ticks the body has rested and been calm."""
    last_x: Floats
    """Pose and velocity when that was last looked at (m, m/s)."""
    last_y: Floats
    last_angle: Floats
    """(rad)"""
    last_vx: Floats
    last_vy: Floats

    asleep: Ints
    """1 for a body that sleeps: nothing moves it until it is woken; see `sleeping`."""
    quiet: Floats
    """For how long it has rested and been slow (s)."""
    restless: Ints
    """1 for one that may not sleep with its island, or has just been woken."""
    anchored: Ints
    """1 for one whose island rests on something immovable."""

    moves: Ints
    """0 for a body that stays where it is: its corners are placed once, when it is added."""
    first: Ints
    """First row in `Corners`, and number of rows: the corners of all its pieces."""
    corners: Ints
    first_piece: Ints
    """First row in `Pieces`, and number of rows."""
    pieces: Ints
    reach: Floats
    """Radius of the bounding circle about the centre (m); of no use for walls."""

    ax: Floats
    """Mean acceleration of this tick by pushes, gravity and drag (m/s^2)."""
    ay: Floats
    aspin: Floats
    """(rad/s^2)"""
    lead_x: Floats
    """Velocity of the position minus the reported velocity, by the integrator (m/s)."""
    lead_y: Floats
    lead_spin: Floats
    """(rad/s)"""
    clock: Floats
    """Time inside the present part of the tick for which pose and velocity hold (s)."""
    path_x: Floats
    """Acceleration along the path in the present part of the tick, contacts included (m/s^2)."""
    path_y: Floats
    path_spin: Floats
    """(rad/s^2)"""
    way: Floats
    """No point of the body moves further in the present part, unless something hits it (m)."""
    kick_x: Floats
    """Velocity at the end of the present part, as the resting contacts make it (m/s)."""
    kick_y: Floats
    kick_spin: Floats
    """(rad/s)"""
    start_x: Floats
    """Pose when the tick began (m, rad); see `books` for these and the following."""
    start_y: Floats
    start_angle: Floats
    push_x: Floats
    """Mean force and torque of the pushes in this tick (N, N m)."""
    push_y: Floats
    push_torque: Floats
    field_x: Floats
    """Mean force of the laws of force in this tick (N)."""
    field_y: Floats
    from_x: Floats
    """Pose when the present part of the tick began (m, rad)."""
    from_y: Floats
    from_angle: Floats
    mean_x: Floats
    """Mean velocity in the present part, or of before and after an exchange of impulses (m/s)."""
    mean_y: Floats
    mean_spin: Floats
    """(rad/s)"""
    middle_x: Floats
    """Pose in the middle of the present part, at the end of it once contacts relax (m)."""
    middle_y: Floats
    middle_angle: Floats
    """(rad)"""
    shift_x: Floats
    """Mean position over the present part, less that for which contacts were solved (m)."""
    shift_y: Floats
    here_x: Floats
    """Position for which the body was last placed (m)."""
    here_y: Floats
    low_x: Floats
    """Box in which a body that moves may move while the list of pairs holds (m)."""
    low_y: Floats
    high_x: Floats
    high_y: Floats
    low_angle: Floats
    """Angles between which a body of several pieces may turn meanwhile (rad)."""
    high_angle: Floats
    first_link: Ints
    """First row in `Links`, and number of rows: the pairs of this body."""
    links: Ints


class Pieces(NamedTuple):
    """One row a convex piece of a body, in the order of bodies; most bodies have one.

    A piece is the hull of its corners, rounded by a radius.
    """

    body: Ints
    """Row of the body."""
    first: Ints
    """First row in `Corners`."""
    corners: Ints
    """Number of rows: 1 makes a disc, 2 a line (a wall, or a capsule), 3 and more a polygon."""
    radius: Floats
    """By which the hull of the corners is rounded (m)."""
    inner: Floats
    """Radius of a circle that fits inside (m); 0 for walls."""
    x: Floats
    """Centre of a bounding circle, in the body's frame (m)."""
    y: Floats
    reach: Floats
    """Radius of that circle (m)."""
    swing: Floats
    """Greatest distance of its points from the body's centre (m); 0 for a disc about it."""
    one_sided: Ints
    """1 for a wall that stops only what comes from its positive side."""
    before: Ints
    """Which piece of the body joins the first corner of this link of a chain, from 1; 0: none."""
    after: Ints
    """The same for the second corner."""
    low_x: Floats
    """Box in which the piece may be while the list of pairs holds (m)."""
    low_y: Floats
    high_x: Floats
    high_y: Floats


class Corners(NamedTuple):
    """Corners of all pieces, those of one piece in sequence, counter-clockwise."""

    x: Floats
    """In the body's frame (m)."""
    y: Floats
    normal_x: Floats
    """Unit outward normal of the side from this corner to the next, in the body's frame."""
    normal_y: Floats
    world_x: Floats
    """In the world, for the pose for which the body was last placed (m)."""
    world_y: Floats
    world_normal_x: Floats
    world_normal_y: Floats


class Pushes(NamedTuple):
    """One row a force or torque that acts."""

    id: Ints
    row: Ints
    """Of the body."""
    x: Floats
    """Force (N, world)."""
    y: Floats
    torque: Floats
    """(N m)"""
    at_x: Floats
    """Point of attack in the body's frame (m)."""
    at_y: Floats
    left: Floats
    """Time it still lasts (s); infinite until it is stopped."""


class Pairs(NamedTuple):
    """One row two pieces of two bodies whose boxes overlap, sorted by (piece_a, piece_b)."""

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
    """The surfaces of a free pair are at least so far apart when a part begins (m)."""
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
    """When the two meet in the present part of the tick (s), or `NEVER`."""
    speed: Floats
    """With which they then approach each other (m/s)."""
    queued: Ints
    """1 if the pair stands in `queue`."""
    queue: Ints
    """Pairs that meet in the present part, in no order (a list of its own, not by row)."""
    resting: Ints
    """Pairs that rest in the present part, in order (a list of its own, not by row)."""


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
    """Speed with which the bodies are to approach, less if negative, in the present pass (m/s)."""
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
    """Where two bodies touch, as the geometry last found it: two rows, the normal in the first."""

    x: Floats
    """Point halfway between the surfaces (m, world)."""
    y: Floats
    gap: Floats
    """(m)"""
    normal_x: Floats
    """Unit normal from a to b."""
    normal_y: Floats
    feature: Ints


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


class Joints(NamedTuple):
    """One row a joint, in the order of their ids. What its rows constrain: `linkage.geometry`."""

    id: Ints
    kind: Ints
    """Index in `joints.KINDS`."""
    a: Ints
    """Id of the body; 0 is the world itself."""
    b: Ints
    a_x: Floats
    """Anchors in the frames of the bodies (m)."""
    a_y: Floats
    b_x: Floats
    b_y: Floats
    axis_x: Floats
    """Unit vector along which b slides, in the frame of a."""
    axis_y: Floats
    over_a_x: Floats
    """Points of the world over which the string of a pulley runs (m)."""
    over_a_y: Floats
    over_b_x: Floats
    over_b_y: Floats
    ratio: Floats
    """How many times the string of a pulley runs on the side of b."""
    rest_angle: Floats
    """Angle of b less that of a at which they count as not turned (rad)."""
    size: Floats
    """Scale of the tolerances (m)."""
    low: Floats
    """Limits of the joint's coordinate (m or rad); equal where it is fixed."""
    high: Floats
    motor: Ints
    """1 if a motor drives the coordinate."""
    speed: Floats
    """Of the motor (m/s or rad/s)."""
    effort: Floats
    """The most that the motor can do (N or N m)."""
    stiffness: Floats
    """Of a spring (N/m)."""
    damping: Floats
    """(N s/m)"""
    break_force: Floats
    """(N)"""
    break_torque: Floats
    """(N m)"""
    broken: Ints
    """`BREAKING` or `BROKEN` (`linkage.tally`) if it gave way; else 0."""
    mode: Ints
    """What the coordinate does: `FREE_WAY`, `FIXED`, ... of `linkage.modes`."""
    impulse_0: Floats
    """Of its rows at the start of the last part of a tick (N s or N m s), to start from."""
    impulse_1: Floats
    impulse_2: Floats
    part: Floats
    """Length of that part (s)."""
    sum_x: Floats
    """Impulse that b got in the present tick (N s)."""
    sum_y: Floats
    sum_turn: Floats
    """(N m s)"""
    force_x: Floats
    """Mean over the last tick, exerted on b (N)."""
    force_y: Floats
    torque: Floats
    """(N m)"""


class Braces(NamedTuple):
    """One row a joint that acts, in the order of elimination (see `linkage.order`)."""

    joint: Ints
    """Row in `Joints`."""
    shape: Ints
    """`POINT`, `SLIDE`, `LINE` or `STRING` of `linkage.geometry`."""
    node_a: Ints
    """Rows in `Nodes`."""
    node_b: Ints
    first: Ints
    """First row in `Equations`, and how many there are."""
    rows: Ints
    sizes: Ints
    """How many braces, nodes, equations, couplings and entries there are; whether the system is
    that of the poses in which the bodies are now; and how many coordinates there are (a list of its
    own)."""


class Nodes(NamedTuple):
    """One row a body that is joined to something; row 0 is the world, which stands still."""

    body: Ints
    """Row in `Bodies`."""
    inverse_mass: Floats
    inverse_inertia: Floats
    x: Floats
    """Pose for which the joints are measured (m)."""
    y: Floats
    angle: Floats
    cos: Floats
    sin: Floats
    vx: Floats
    """Mean velocity over the part, or velocity at an instant, before joints change it (m/s)."""
    vy: Floats
    spin: Floats
    lent_x: Floats
    """What joints add to it (m/s)."""
    lent_y: Floats
    lent_spin: Floats
    sum_x: Floats
    """What joints added at the start of the part in all (m/s)."""
    sum_y: Floats


class Equations(NamedTuple):
    """One row a scalar constraint, in the order of elimination."""

    value: Floats
    """What is constrained, in the pose that was last measured (m or rad)."""
    start: Floats
    """The same at the start of the part."""
    impulse: Floats
    """Summed over the part (N s or N m s)."""
    change: Floats
    """What the last step added to it."""
    total: Floats
    """What all steps added to it since the equations were taken up."""
    solved: Ints
    """Whether it is one of the equations."""
    soft: Floats
    """What a spring adds to the diagonal (1/kg)."""
    elastic: Floats
    """Of a spring: the two coefficients of its rule, and where it rests (`linkage.springs`)."""
    viscous: Floats
    middle: Floats
    mass: Floats
    """Impulse that changes the velocity of the row by 1 m/s or rad/s, were it alone (kg)."""
    first: Ints
    """First column of the profile."""
    base: Ints
    """Row in `Profile` where column 0 would stand; column k stands k further."""
    unknown: Floats
    """Right-hand side, then solution."""
    inverse_pivot: Floats
    """0 for rows that are not solved."""


class Arms(NamedTuple):
    """Jacobians: two rows a constraint, one for each body."""

    node: Ints
    x: Floats
    y: Floats
    turn: Floats
    by_mass_x: Floats
    """The same divided by mass or moment of inertia."""
    by_mass_y: Floats
    by_inertia: Floats


class Couplings(NamedTuple):
    """One row a product of two Jacobians that share a body."""

    at: Ints
    """Row of `Profile` to which it adds."""
    left: Ints
    """Rows of `Arms`."""
    right: Ints


class Profile(NamedTuple):
    """The system matrix: of each row the entries from its first column to the diagonal."""

    entry: Floats


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


class Fields(NamedTuple):
    """One row a law of force and body it acts on, sorted by body; first those that act on all."""

    law: Ints
    """Id of the law."""
    row: Ints
    """Of the body, or `fields.EVERY_BODY`."""
    kind: Ints
    """`fields.POINT_GRAVITY`, `fields.SPRING_TO`, or `fields.GIVEN` by a Python function."""
    x: Floats
    """Where the centre of the field is (m, world); if given: force at the start of the tick (N)."""
    y: Floats
    strength: Floats
    """mu (m^3/s^2) or stiffness (N/m)."""
    damping: Floats
    """Of a spring (N s/m)."""
    softening: Floats
    """Of gravity (m)."""
    torque: Floats
    """If given: at the start of the tick (N m)."""
    later_x: Floats
    """If given: force and torque at the end of the tick."""
    later_y: Floats
    later_torque: Floats
    used: Ints
    """First row: how many rows are in use."""


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


class Materials(NamedTuple):
    """One row two materials that have coefficients of their own; -1 where they have none."""

    a: Ints
    """Numbers of their names, a <= b."""
    b: Ints
    restitution: Floats
    friction: Floats
    static_friction: Floats
    rolling_resistance: Floats
    """(m)"""


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

    head: Ints
    """The piece on top of a square, by the square's hash, or `neighbours.NOBODY`."""
    following: Ints
    """By pieces: the one below it in squares of the same hash, or `neighbours.NOBODY`."""
    column: Ints
    """By pieces: the square in which its box has its centre."""
    row: Ints
    large: Ints
    """Pieces that are larger than a square (a list of its own, not by row)."""


class Progress(NamedTuple):
    """One row: how far the kernels are within a tick, and why they paused."""

    phase: Ints
    """`tick.WAITING` between two ticks, `tick.PAIRING` or `tick.MOVING`."""
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
    sensing: Ints
    """Number of pairs with a sensor."""
    own_rules: Ints
    """1 if coefficients of pairs are made by Python."""
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
    touch: Touch
    impacts: Impacts
    joints: Joints
    braces: Braces
    nodes: Nodes
    equations: Equations
    arms: Arms
    couplings: Couplings
    profile: Profile
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


FREE, RESTING, PASSING, SENSING, SLEEPING = range(5)
"""States of a pair: they move on their own; they rest on each other; one comes through a one-sided
wall from behind; one of them is a sensor; they rested on each other when they fell asleep."""

NEVER = 1e300
"""A time that does not come (s)."""

LINE = 8
"""Numbers in a line of a processor's cache."""

IMPACTS_AT_ONCE = 4096
"""Rows of the table of impacts; after so many in one tick the kernel pauses to have it emptied."""

ROWS = {
    "bodies": 16,
    "pieces": 16,
    "corners": 64,
    "pushes": 8,
    "pairs": 64,
    "contacts": 128,
    "links": 128,
    "found": 64,
    "parted": 64,
    "grid": 64,
    "touch": 2,
    "impacts": IMPACTS_AT_ONCE,
    "joints": 4,
    "braces": 8,
    "nodes": 2,
}
"""Rows that the tables of a new world have room for; those that are not named have one."""

Table = TypeVar("Table", bound=tuple[Any, ...])


def new_tables() -> Tables:
    """Make the tables of an empty world."""
    kinds = get_type_hints(Tables)
    return Tables(
        **{name: views(allocate(kinds[name], ROWS.get(name, 1))) for name in Tables._fields}
    )


def allocate(table: type[Table], rows: int) -> Table:
    """Make a table of zeros with room for `rows`.

    The columns lie in one block of memory, an odd number of cache lines apart: if it were a power
    of two, as rows often are, the same row of all columns would compete for the same few places in
    the cache of a processor.
    """
    fields: tuple[str, ...] = getattr(table, "_fields")  # noqa: B009, bound to a plain tuple
    kinds = get_type_hints(table)
    lines = (rows + LINE - 1) // LINE | 1
    block = np.zeros((len(fields), lines * LINE), np.int64)
    columns = [
        column[:rows] if kinds[name] is Ints else column[:rows].view(np.float64)
        for name, column in zip(fields, block, strict=True)
    ]
    return table(*columns)


def grow(table: Table, rows: int) -> Table:
    """Copy a table into one with room for `rows`."""
    larger = allocate(type(table), rows)
    for old, new in zip(arrays(table), arrays(larger), strict=True):
        new[: len(old)] = old
    return larger


def arrays(table: Any) -> tuple[Any, ...]:
    """The columns of a table as numpy arrays."""
    return tuple(np.asarray(column) for column in table)


def views(table: Table) -> Table:
    """The same table through memoryviews of its arrays."""
    return type(table)(*(memoryview(column) for column in arrays(table)))


def remove_rows(table: Any, row: int, number: int, rows: int) -> None:
    """Close the gap that `number` rows from `row` on leave among the first `rows`."""
    after = row + number
    if after == rows:
        return
    for column in arrays(table):
        column[row : rows - number] = column[after:rows]


def sort_rows(table: Any, rows: int) -> None:
    """Sort the first `rows` by the first column, then the second and so on."""
    columns = [column[:rows] for column in arrays(table)]
    order = np.lexsort(columns[::-1])
    for column in columns:
        column[:] = column[order]


def copy_row(table: Any, source: int, target: int) -> None:
    """Write to row `target` what stands in row `source`. Kernels may call it."""
    for column in table:
        column[target] = column[source]


def clear_row(table: Any, row: int) -> None:
    """Write zeros to a row. Kernels may call it."""
    for column in table:
        column[row] = 0
