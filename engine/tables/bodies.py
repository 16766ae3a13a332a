"""Tables of bodies: what they are, where they are, and what pushes them."""

from typing import NamedTuple

from engine.tables.columns import Floats, Ints

PLAIN, OWN, OTHERS, HIDDEN = range(4)
"""Corners: without seams; the outline arrives along a side of this piece, or of another; within."""

POINT_GRAVITY, SPRING_TO, GIVEN = 1, 2, 3
"""Kinds of a field: two that are built in, and what a Python function gives."""

EVERY_BODY = -1
"""Row of a field that acts on all bodies."""


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
    """Number of resting contacts at the end of the last tick, one more for joined bodies; less than
    0 while the body waits."""
    joined: Ints
    """1 for a body that moves and that a joint holds."""
    bone: Ints
    """Row in `Bones`, plus 1, of a body that moves in a tree of hinges; else 0."""
    calm: Ints
    """For how many ticks the body has rested and been calm."""
    waits: Ints
    """1 while a body that rests steadily goes its way alone, as others take the tick in parts; 2
    once it was hit; see `rousing`."""
    cluster: Ints
    """A body that it is rigidly one with, itself if there is none; see `sticking`."""
    stuck: Ints
    """By how many pins that cluster sticks to the ground, 2 at most."""
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
    """No point of the body was moved further when overlaps were moved apart (m)."""
    rim: Floats
    """No point of the body moves further by rotation in the present part, unless it is hit (m)."""
    came_x: Floats
    """Velocity with which it came to its last impact (m/s)."""
    came_y: Floats
    came_spin: Floats
    """(rad/s)"""
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
    absement_x: Floats
    """Way since the tick began, integrated over time (m s); see `moments`."""
    absement_y: Floats
    from_absement_x: Floats
    """The same when the present part of the tick began."""
    from_absement_y: Floats
    gained: Floats
    """Energy that contacts bring to its island in the present part (J); see `gaining`."""
    kicked: Floats
    """Energy that its bodies would have by what contacts kick them alone (J)."""
    mean_x: Floats
    """Mean velocity in the present part, or of before and after an exchange of impulses (m/s)."""
    mean_y: Floats
    mean_spin: Floats
    """(rad/s)"""
    left_x: Floats
    """What loads did not bear when forces were balanced: a change of velocity in a tick (m/s)."""
    left_y: Floats
    left_spin: Floats
    """(rad/s)"""
    pin_x: Floats
    """Where the first of these pins is (m)."""
    pin_y: Floats
    middle_x: Floats
    """Pose in the middle of the present part, at the end of it once contacts relax (m)."""
    middle_y: Floats
    middle_angle: Floats
    """(rad)"""
    parting: Ints
    """1 if it was moved apart from another at the end of the last tick; see `kernels.parting`."""
    stirred: Ints
    """1 if it was struck while contacts were readied; see `resting`. Also one of its pairs; see
    `halting`."""
    burdens: Ints
    """How many contacts of others that rest on it still have no load; see `standing`."""
    placed: Ints
    """1 if its corners stand as in the middle of the part, while contacts are readied."""
    block: Ints
    """Last block of `Lanes` with one of its contacts, from 1; 0: none."""
    shift_x: Floats
    """Mean position over the present part, less that for which contacts were solved (m)."""
    shift_y: Floats
    rides: Ints
    """Number of links of curves that bore it in the present part; see `curves`."""
    bent: Floats
    """Work that normals of a curve did on it in that part, or before in the tick as it did not ride
    (J)."""
    here_x: Floats
    """Position for which the body was last placed (m)."""
    here_y: Floats
    here_angle: Floats
    """Its angle there (rad), if all its corners"""
    stands: Ints
    """were put there: 1."""
    shoved: Ints
    """1 once its contacts may have moved it; see `parting`."""
    seen: Ints
    """1 once it was seen to after an impact; see `aftermath`."""
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
    first_ignored: Ints
    """First row in `Ignored` of those in which it is a, as pairs were last looked for."""


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
    seams: Ints
    """1 if other pieces of the body join it; see `Corners`."""
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
    kind: Ints
    """Whose the corner is, where pieces of a body join: `PLAIN`, `OWN`, `OTHERS` or `HIDDEN`."""
    low_x: Floats
    """Unit normal of the body's outline before the corner, in the body's frame."""
    low_y: Floats
    high_x: Floats
    """The same after the corner."""
    high_y: Floats
    cover_start: Floats
    """From where to where other pieces cover the side (m, along it); if not, start > end."""
    cover_end: Floats


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


class Fields(NamedTuple):
    """One row a law of force and body it acts on, sorted by body; first those that act on all."""

    law: Ints
    """Id of the law."""
    row: Ints
    """Of the body, or `EVERY_BODY`."""
    kind: Ints
    """`POINT_GRAVITY`, `SPRING_TO` or `GIVEN`."""
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
