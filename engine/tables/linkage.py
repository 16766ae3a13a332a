"""Tables of joints, and of the equations that hold them together."""

from typing import NamedTuple

from engine.tables.columns import Floats, Ints

FREE_WAY, FIXED, ELASTIC, AT_LOW, AT_HIGH, DRIVEN, STRAINED = range(7)
"""What the coordinate of a joint does; a strained motor does all it can and fails to keep its
speed."""

BREAKING, BROKEN = 1, 2
"""States of a joint that gave way: in this tick; before."""


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
    """`BREAKING` or `BROKEN` if it gave way; else 0."""
    mode: Ints
    """What the coordinate does: `FREE_WAY`, `FIXED` and so on."""
    impulse_0: Floats
    """Of its rows at the start of the last part of a tick (N s or N m s), to start from."""
    impulse_1: Floats
    impulse_2: Floats
    end_0: Floats
    """Of a hinge of a tree: what it exerted at the end of that part, as a force (N)."""
    end_1: Floats
    lag_0: Floats
    """By how much it exerted more at the start of a part, divided by its length (N/s)."""
    lag_1: Floats
    older_0: Floats
    """The same in the part before (N/s)."""
    older_1: Floats
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


class Limbs(NamedTuple):
    """One row a hinge of a tree of bodies (see `linkage.trees`), the furthest from the root first.

    Row k hinges the bone k, its child, to another bone, its parent.
    """

    joint: Ints
    """Row in `Joints`."""
    parent: Ints
    """Row in `Bones`."""
    tree: Ints
    """Row in `Trees`."""
    member: Ints
    """Rows of `Limbs`, tree by tree: where one begins says `Trees` (a list of its own)."""
    sign: Floats
    """1 if the child is b of the joint, -1 if it is a."""
    scale: Floats
    """One over the unit of tolerances, squared (1/m^2)."""
    hangs: Floats
    """Of a hinge on a held parent: length of a pendulum that swings like what hangs on it (m)."""
    child_x: Floats
    """Hinge in the frame of the child (m)."""
    child_y: Floats
    parent_x: Floats
    """Hinge in the frame of the parent (m)."""
    parent_y: Floats
    tip_x: Floats
    """From the centre of the child to the hinge, as the bodies were last placed (m, world)."""
    tip_y: Floats
    base_x: Floats
    """From the centre of the parent to the hinge (m, world)."""
    base_y: Floats
    arm_x: Floats
    """From the centre of the child to where the impulse acts: halfway between both hinges."""
    arm_y: Floats
    lever_x: Floats
    """The same from the centre of the parent."""
    lever_y: Floats
    reach_x: Floats
    """From the centre of the child to the point whose velocity is to change (m, world)."""
    reach_y: Floats
    span_x: Floats
    """The same from the centre of the parent."""
    span_y: Floats
    gap_x: Floats
    """From the hinge of the parent to that of the child (m)."""
    gap_y: Floats
    xx: Floats
    """What resists the motion of the hinge: the child and all that hangs on it (kg)."""
    xy: Floats
    yx: Floats
    yy: Floats
    sway_x: Floats
    """How the child turns as its hinge moves (rad/m)."""
    sway_y: Floats
    lean_x: Floats
    """How its turning by an angular impulse pushes on the hinge (1/m)."""
    lean_y: Floats
    ease: Floats
    """How it turns by an angular impulse (1/(kg m^2))."""
    rate_x: Floats
    """By how much the velocity of the hinge has to change (m/s)."""
    rate_y: Floats
    free_x: Floats
    """Impulse on the child, as long as the parent does not move (N s)."""
    free_y: Floats
    answer_x: Floats
    """Impulse on the child: the solution (N s)."""
    answer_y: Floats
    impulse_x: Floats
    """On the child, summed over the part or the instant (N s)."""
    impulse_y: Floats
    given_x: Floats
    """Of that, what the bodies already got."""
    given_y: Floats
    miss: Floats
    """How far or how fast the hinge opens, in units of its tolerance, squared."""
    goal_x: Floats
    """Velocity that sweeps give to the hinge of the child past that of the parent (m/s)."""
    goal_y: Floats
    grip_xx: Floats
    """What resists that, as if no other hinge held the two (kg)."""
    grip_xy: Floats
    grip_yy: Floats
    turn: Floats
    """Angular impulse that it gives to the child all through the part (N m s)."""
    counter: Floats
    """The same that it takes from the parent."""


class Bones(NamedTuple):
    """One row a body in a tree: first the children of `Limbs`, in their order, then the roots that
    are free, then those that are held: immovable bodies, and the world, one for each tree on them.
    """

    body: Ints
    """Row in `Bodies`, -1 for the world."""
    tree: Ints
    """Row in `Trees`."""
    sizes: Ints
    """How many limbs, movable bones, bones and trees there are, and whether the limbs are placed
    for the poses in which the bodies are now; how many trees are lost; and whether the limbs are
    resolved for the end of the present part; on how many trees contacts act; and, of those in
    `acting`, how many are limbs, movable bones, trees and bones; how many runs there are (a list of
    its own)."""
    acting: Ints
    """Rows of the bones of trees that take part in the present part of the tick, in the order of
    all; see `linkage.acting` (a list of its own)."""
    run_first: Ints
    """Runs of limbs that act, rows one after another, whose parents are so, too (a list of its own,
    as the next two): the first row,"""
    run_end: Ints
    """the row after the last,"""
    run_lead: Ints
    """and how far behind each limb its parent is: beyond the run."""
    mass: Floats
    """(kg)"""
    inverse_mass: Floats
    inertia: Floats
    """(kg m^2); 0 for what does not turn."""
    inverse_inertia: Floats
    x: Floats
    """Pose for which the limbs were placed (m)."""
    y: Floats
    angle: Floats
    """(rad)"""
    cos: Floats
    sin: Floats
    vx: Floats
    """Velocity before joints change it (m/s): the mean over the part, or at an instant."""
    vy: Floats
    spin: Floats
    lent_x: Floats
    """What joints add to it (m/s)."""
    lent_y: Floats
    lent_spin: Floats
    lasts: Floats
    """How long it goes on so, from where it was placed to the end of the part (s)."""
    way_x: Floats
    """From there to the end of the part (m)."""
    way_y: Floats
    turn_sin: Floats
    """Sine of the angle by which it turns meanwhile, and its cosine less 1."""
    turn_less: Floats
    xx: Floats
    """Mass of the body and of what hangs on it, as it resists a motion of its centre (kg)."""
    xy: Floats
    yx: Floats
    yy: Floats
    xt: Floats
    """How its turning resists a motion, and a motion its turning (kg m); itself (kg m^2)."""
    yt: Floats
    tx: Floats
    ty: Floats
    tt: Floats
    push_x: Floats
    """Impulse (N s, N m s) by what hangs on it; of a child, the latter about its hinge."""
    push_y: Floats
    push_turn: Floats
    sum_x: Floats
    """What joints added to its velocity at the start of the part in all (m/s)."""
    sum_y: Floats
    late_x: Floats
    """What they added since, as they were struck (m/s); times when (m), times that again (m s)."""
    late_y: Floats
    late_once_x: Floats
    late_once_y: Floats
    late_twice_x: Floats
    late_twice_y: Floats
    step_x: Floats
    """Change of its velocity: the solution (m/s)."""
    step_y: Floats
    step_spin: Floats


class Trees(NamedTuple):
    """One row a tree of hinged bodies, and a last one for all bodies that no tree holds."""

    first: Ints
    """First place in `Limbs.member`, and number of limbs."""
    limbs: Ints
    root: Ints
    """Row in `Bones` of its root if that is free, else -1."""
    evenly: Ints
    """1 if contacts act on it in the present part: its hinges then do so too, all through it."""
    acting: Ints
    """Trees that take part in the present part of the tick (a list of its own)."""
    group: Ints
    """Tree that stands for the group of trees which touch each other; see `linkage.limb_groups`."""
    next: Ints
    """Next tree of the group, -1: none."""
    pairs: Ints
    """Number of pairs of the group, in the row that stands for it."""
    place: Ints
    """Where its next pair is to be listed."""
    does: Ints
    """What the next step of Newton's method does: see `linkage.limbs`."""
    worst: Floats
    """The greatest miss of a hinge, in units of its tolerance, squared."""
    before: Floats
    """The same one step before."""
    share: Floats
    """Of the step to take."""
    made_for: Floats
    """The same as the matrix was made."""
