"""How impulses of hinges get to the bodies and back: bones hold what the limbs change."""

from engine.tables import Tables


def read_means(t: Tables) -> None:
    """Read the mean velocities over the part, or over its second half where hinges act through it
    all, that is those of its end; what joints lend is nothing yet, unless bodies did not get it.
    """
    bones = t.bones
    bodies = t.bodies
    delivered = bones.sizes[7] > 0
    for at in range(bones.sizes[9]):
        bone = bones.acting[at]
        row = bones.body[bone]
        if t.trees.evenly[bones.tree[bone]] == 1:
            read_end(t, bone, row)
        else:
            half = bones.lasts[bone] / 2.0
            bones.vx[bone] = bodies.vx[row] + bodies.ax[row] * half
            bones.vy[bone] = bodies.vy[row] + bodies.ay[row] * half
            bones.spin[bone] = bodies.spin[row] + bodies.aspin[row] * half
            if delivered:
                lend_nothing(t, bone)
    read_held(t)


def read_ends(t: Tables) -> None:
    """Read the velocities at the end of the part."""
    bones = t.bones
    for at in range(bones.sizes[9]):
        bone = bones.acting[at]
        read_end(t, bone, bones.body[bone])
    read_held(t)


def read_present(t: Tables) -> None:
    """Read the velocities that the bodies have."""
    bones = t.bones
    for at in range(bones.sizes[9]):
        bone = bones.acting[at]
        read_own(t, bone, bones.body[bone])
        lend_nothing(t, bone)
    read_held(t)


def read_end(t: Tables, bone: int, row: int) -> None:
    """Read the velocity of a body at the end of the part; what joints lend is nothing yet."""
    t.bones.vx[bone] = t.bodies.kick_x[row]
    t.bones.vy[bone] = t.bodies.kick_y[row]
    t.bones.spin[bone] = t.bodies.kick_spin[row]
    lend_nothing(t, bone)


def read_held(t: Tables) -> None:
    """Read the velocities of the bodies from which trees hang."""
    bones = t.bones
    for bone in range(bones.sizes[1], bones.sizes[2]):
        if bones.body[bone] >= 0:
            read_own(t, bone, bones.body[bone])


def read_own(t: Tables, bone: int, row: int) -> None:
    """Read the velocity that a body has."""
    t.bones.vx[bone] = t.bodies.vx[row]
    t.bones.vy[bone] = t.bodies.vy[row]
    t.bones.spin[bone] = t.bodies.spin[row]


def lend_nothing(t: Tables, bone: int) -> None:
    """Joints have not changed the velocity of a bone yet."""
    t.bones.lent_x[bone] = 0.0
    t.bones.lent_y[bone] = 0.0
    t.bones.lent_spin[bone] = 0.0


def forget_jolts(t: Tables, bone: int) -> None:
    """Begin a part: joints have not jolted a bone yet."""
    bones = t.bones
    bones.sum_x[bone] = 0.0
    bones.sum_y[bone] = 0.0
    bones.late_x[bone] = 0.0
    bones.late_y[bone] = 0.0
    bones.late_once_x[bone] = 0.0
    bones.late_once_y[bone] = 0.0
    bones.late_twice_x[bone] = 0.0
    bones.late_twice_y[bone] = 0.0


def lend_all(t: Tables) -> None:
    """Let what the limbs exert beyond what was given change the velocities of the bones.

    Steps of the solution would do so too, but for rounding: this way both bones get the same.
    """
    bones = t.bones
    for bone in range(bones.sizes[1]):
        lend_nothing(t, bone)
    for run in range(bones.sizes[12]):
        first = bones.run_first[run]
        end = bones.run_end[run]
        lead = bones.run_lead[run]
        for k in range(first, end):
            lend_parent(t, k, k + lead)
        for k in range(first, end):
            lend_child(t, k)


def give_all(t: Tables) -> None:
    """Note that the bodies got what the limbs exert."""
    limbs = t.limbs
    for run in range(t.bones.sizes[12]):
        for k in range(t.bones.run_first[run], t.bones.run_end[run]):
            limbs.given_x[k] = limbs.impulse_x[k]
            limbs.given_y[k] = limbs.impulse_y[k]


def lend_limb(t: Tables, k: int) -> None:
    """Let what one limb exerts change the velocities of its bones."""
    lend_parent(t, k, t.limbs.parent[k])
    lend_child(t, k)


def lend_parent(t: Tables, k: int, parent: int) -> None:
    """Let what a limb exerts change the velocity of the parent."""
    bones = t.bones
    limbs = t.limbs
    x = limbs.impulse_x[k] - limbs.given_x[k]
    y = limbs.impulse_y[k] - limbs.given_y[k]
    turn = limbs.lever_x[k] * y - limbs.lever_y[k] * x
    bones.lent_x[parent] -= bones.inverse_mass[parent] * x
    bones.lent_y[parent] -= bones.inverse_mass[parent] * y
    bones.lent_spin[parent] -= bones.inverse_inertia[parent] * turn


def lend_child(t: Tables, k: int) -> None:
    """Let it change that of the child."""
    bones = t.bones
    limbs = t.limbs
    x = limbs.impulse_x[k] - limbs.given_x[k]
    y = limbs.impulse_y[k] - limbs.given_y[k]
    turn = limbs.arm_x[k] * y - limbs.arm_y[k] * x
    bones.lent_x[k] += bones.inverse_mass[k] * x
    bones.lent_y[k] += bones.inverse_mass[k] * y
    bones.lent_spin[k] += bones.inverse_inertia[k] * turn


def deliver_starts(t: Tables) -> None:
    """Give what joints lent to the bodies: now and from now on, or all through the part."""
    bones = t.bones
    bodies = t.bodies
    work = 0.0
    total_x = 0.0
    total_y = 0.0
    for at in range(bones.sizes[9]):
        bone = bones.acting[at]
        if t.trees.evenly[bones.tree[bone]] == 1:
            deliver_end(t, bone)
            continue
        row = bones.body[bone]
        mass = bones.mass[bone]
        x = bones.lent_x[bone]
        y = bones.lent_y[bone]
        spin = bones.lent_spin[bone]
        vx = bodies.vx[row]
        vy = bodies.vy[row]
        turning = bodies.spin[row]
        work += mass * (x * (vx + x / 2.0) + y * (vy + y / 2.0))
        work += bones.inertia[bone] * spin * (turning + spin / 2.0)
        total_x += mass * x
        total_y += mass * y
        bodies.vx[row] = vx + x
        bodies.vy[row] = vy + y
        bodies.spin[row] = turning + spin
        bodies.kick_x[row] += x
        bodies.kick_y[row] += y
        bodies.kick_spin[row] += spin
        bones.sum_x[bone] += x
        bones.sum_y[bone] += y
    t.books.joint_work[0] += work
    t.books.joint_x[0] += total_x
    t.books.joint_y[0] += total_y


def deliver_ends(t: Tables) -> None:
    """Give what joints lent to the bodies, at the end of the part."""
    for at in range(t.bones.sizes[9]):
        deliver_end(t, t.bones.acting[at])


def deliver_end(t: Tables, bone: int) -> None:
    """Give what joints lent to one of them."""
    bodies = t.bodies
    row = t.bones.body[bone]
    bodies.kick_x[row] += t.bones.lent_x[bone]
    bodies.kick_y[row] += t.bones.lent_y[bone]
    bodies.kick_spin[row] += t.bones.lent_spin[bone]


def add_up_limb(t: Tables, k: int) -> None:
    """Add the impulse of a limb to the sums of the tick."""
    joint = t.limbs.joint[k]
    t.joints.sum_x[joint] += t.limbs.sign[k] * t.limbs.impulse_x[k]
    t.joints.sum_y[joint] += t.limbs.sign[k] * t.limbs.impulse_y[k]
