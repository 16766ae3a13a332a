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
    astray: Floats
    """How far beyond its limits the coordinate is because a part of a tick had no solution (m or
    rad), negative below the low one: it comes back slowly."""
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
    """By how much it exerted more at the start of a part than at the end of the one before, divided
    by the length of the part (N/s)."""
    lag_1: Floats
    older_0: Floats
    """The same when it was noted before (N/s),"""
    older_1: Floats
    since: Floats
    """how long ago the former was noted, and how much longer ago the latter (s)."""
    spacing: Floats
    mean_0: Floats
    """What it exerted about the start of that part, as a force (N),"""
    mean_1: Floats
    rise_0: Floats
    """and how fast that grew from the start of the part before on (N/s)."""
    rise_1: Floats
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
    that of the poses in which the bodies are now; how many coordinates there are; and what joints
    do in the present part if no solution was found for it: see `modes.CLOSES` (a list of its own).
    """


class Nodes(NamedTuple):
    """One row a body that is joined to something; row 0 is the world, which stands still."""

    body: Ints
    """Row in `Bodies`."""
    structure: Ints
    """Row in `Structures`; 0 if it cannot move."""
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
    sum_spin: Floats
    """(rad/s)"""
    driven_x: Floats
    """What motors, springs and hands alone add to it in all, to see what the others do (m/s)."""
    driven_y: Floats
    driven_spin: Floats
    """(rad/s)"""
    late: Ints
    """1 if they added to it later in the part, too, as something was struck."""


class Structures(NamedTuple):
    """One row a structure: movable bodies that joints hold together, trees of hinges apart; row 0
    is for what cannot move.
    """

    first: Ints
    """First row in `Equations`, and the row after the last."""
    end: Ints
    heaviest: Floats
    """Mass of its heaviest body (kg)."""


class Equations(NamedTuple):
    """One row a scalar constraint, in the order of elimination."""

    value: Floats
    """What is constrained, in the pose that was last measured (m or rad)."""
    start: Floats
    """The same at the start of the part."""
    closes: Floats
    """How far it may come back in the part, where it gapes (see `linkage.closing`)."""
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
