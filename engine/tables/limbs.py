"""Tables of trees of hinged bodies; see `linkage.trees`."""

from typing import NamedTuple

from engine.tables.columns import Floats, Ints


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
    both: Floats
    """The same that it gives to both about the origin: nothing, unless the parent is immovable, or
    the hinge is torn."""


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
    sway: Floats
    """By how much joints changed the velocity of any of its points in the last impact (m/s)."""
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
    owes: Ints
    """1 if what its hinges exert at the end of the last part is still owed: see `Progress.owed`."""
    does: Ints
    """What the next step of Newton's method does: see `linkage.limbs`."""
    lively: Floats
    """Twice the kinetic energy of its bodies (J), and the same times the squares of how fast they
    turn (J/s^2); see `linkage.pace`. Then what it may become, and by how much it becomes more (J,
    twice); see `linkage.throwing`."""
    lash: Floats
    particles: Ints
    """1 if one of its bodies never turns."""
    worst: Floats
    """The greatest miss of a hinge, in units of its tolerance, squared."""
    before: Floats
    """The same one step before."""
    share: Floats
    """Of the step to take."""
    made_for: Floats
    """The same as the matrix was made."""
