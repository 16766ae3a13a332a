"""Trees of hinged bodies: which impulses change the velocities of all hinges as wanted.

A tree is eliminated from its tips to its root (Baraff, "Linear-time dynamics using Lagrange
multipliers", 1996; the masses are the articulated-body inertias of Featherstone, "The calculation
of robot dynamics using articulated-body inertias", 1983). An impulse P acts at the arm r of a
child, and what is wanted is the velocity u of its point q: at an instant the two are the same; a
part of a tick exerts its impulses at its start, and hinges are to hold at its end (`limb_motion`),
so that the equations are not symmetric. Child and all that hangs on it resist with

    A v + b w = P + F,    c . v + d w = r x P + Q    (velocity v, spin w; F, Q: of what hangs on it)

With u = v + w k x q, b' = b - A (k x q), c' = c - A^T (k x r), T = d - c . (k x q) - (k x r) . b',

    w = (Q - r x F - c' . u)/T,    P = K u + b' (Q - r x F)/T - F,    K = A - b' c'^T/T:

one division a hinge. The parent bears K at its end of the hinge. A free root is solved for last.
The cost is in proportion to the number of hinges, also where many of them sit on one body.

Limbs that act are taken in runs, of which no one depends on another. What a run does is parted so
that in each loop all rows are one after another: a processor does several at once.
"""

from engine.kernels.elementary import MANY_TURNS, cos_sin, turned
from engine.linkage.geometry import TORN
from engine.tables import Tables


def find_runs(t: Tables) -> None:
    """List the runs of limbs that act: rows one after another, their parents too, beyond them."""
    bones = t.bones
    runs = 0
    for at in range(bones.sizes[8]):
        k = bones.acting[at]
        lead = t.limbs.parent[k] - k
        last = runs - 1
        follows = runs > 0 and k == bones.run_end[last] and lead == bones.run_lead[last]
        if not follows or k >= bones.run_first[last] + lead:
            bones.run_first[runs] = k
            bones.run_lead[runs] = lead
            runs += 1
        bones.run_end[runs - 1] = k + 1
    bones.sizes[12] = runs


def gather_masses(t: Tables) -> None:
    """Read what the bodies resist with."""
    for bone in range(t.bones.sizes[1]):
        gather_mass(t, bone)


def gather_mass(t: Tables, bone: int) -> None:
    """Read what the body of a bone resists with."""
    bones = t.bones
    bodies = t.bodies
    row = bones.body[bone]
    bones.inverse_mass[bone] = bodies.inverse_mass[row]
    bones.inverse_inertia[bone] = bodies.inverse_inertia[row]
    bones.mass[bone] = bodies.mass[row]
    bones.inertia[bone] = bodies.inertia[row] if bodies.inverse_inertia[row] > 0.0 else 0.0


def stand(t: Tables) -> None:
    """Place all bones where their bodies are now, and the limbs."""
    bones = t.bones
    bodies = t.bodies
    for at in range(bones.sizes[11]):
        bone = bones.acting[at]
        row = bones.body[bone]
        if row >= 0:
            set_pose(t, bone, bodies.x[row], bodies.y[row], bodies.angle[row])
        else:
            set_pose(t, bone, 0.0, 0.0, 0.0)
    turn_all(t)
    for run in range(bones.sizes[12]):
        lead = bones.run_lead[run]
        for k in range(bones.run_first[run], bones.run_end[run]):
            place_limb(t, k, k + lead)
    t.progress.torn[0] = 0
    for run in range(bones.sizes[12]):
        for k in range(bones.run_first[run], bones.run_end[run]):
            note_torn(t, k)


def note_torn(t: Tables, k: int) -> None:
    """Note if a limb that was just placed is torn."""
    if t.limbs.miss[k] > TORN * TORN / 4.0:
        t.progress.torn[0] = 1


def set_pose(t: Tables, bone: int, x: float, y: float, angle: float) -> None:
    """Note the pose of a bone (m, rad), which has yet to be turned."""
    t.bones.x[bone] = x
    t.bones.y[bone] = y
    t.bones.angle[bone] = angle


def turn_all(t: Tables) -> None:
    """Turn all bones to where their angles are noted."""
    bones = t.bones
    far = 0.0
    for at in range(bones.sizes[11]):
        angle = bones.angle[bones.acting[at]]
        far = angle if angle > far else far
        far = -angle if -angle > far else far
    if far < MANY_TURNS:
        for bone in range(bones.sizes[2]):  # side by side; what does not act is not read
            bones.cos[bone], bones.sin[bone] = turned(bones.angle[bone])
    else:
        for at in range(bones.sizes[11]):
            bone = bones.acting[at]
            bones.cos[bone], bones.sin[bone] = cos_sin(bones.angle[bone])


def stands(t: Tables) -> bool:
    """Whether the limbs are placed for the poses and the masses that the bodies have."""
    bones = t.bones
    bodies = t.bodies
    if bones.sizes[4] == 0:
        return False
    for at in range(bones.sizes[11]):
        bone = bones.acting[at]
        row = bones.body[bone]
        if row >= 0 and (
            bones.x[bone] != bodies.x[row]
            or bones.y[bone] != bodies.y[row]
            or bones.angle[bone] != bodies.angle[row]
            or bones.inverse_mass[bone] != bodies.inverse_mass[row]
            or bones.inverse_inertia[bone] != bodies.inverse_inertia[row]
        ):
            return False
    return True


def place_bone(t: Tables, bone: int, x: float, y: float, angle: float) -> None:
    """Put a bone into a pose (m, rad)."""
    set_pose(t, bone, x, y, angle)
    t.bones.cos[bone], t.bones.sin[bone] = cos_sin(angle)


def place_limb(t: Tables, k: int, parent: int) -> None:
    """Find where the hinge is on both bones that have been placed, and where its impulse acts."""
    bones = t.bones
    limbs = t.limbs
    cos = bones.cos[k]
    sin = bones.sin[k]
    x = limbs.child_x[k]
    y = limbs.child_y[k]
    tip_x = cos * x - sin * y
    tip_y = sin * x + cos * y
    cos = bones.cos[parent]
    sin = bones.sin[parent]
    x = limbs.parent_x[k]
    y = limbs.parent_y[k]
    base_x = cos * x - sin * y
    base_y = sin * x + cos * y
    gap_x = (bones.x[k] + tip_x) - (bones.x[parent] + base_x)
    gap_y = (bones.y[k] + tip_y) - (bones.y[parent] + base_y)
    limbs.tip_x[k] = tip_x
    limbs.tip_y[k] = tip_y
    limbs.base_x[k] = base_x
    limbs.base_y[k] = base_y
    limbs.gap_x[k] = gap_x
    limbs.gap_y[k] = gap_y
    square = (gap_x * gap_x + gap_y * gap_y) * limbs.scale[k]
    limbs.miss[k] = square
    share = 0.5 if square <= TORN * TORN else 0.0
    half_x = gap_x * share
    half_y = gap_y * share
    limbs.arm_x[k] = limbs.reach_x[k] = tip_x - half_x
    limbs.arm_y[k] = limbs.reach_y[k] = tip_y - half_y
    limbs.lever_x[k] = limbs.span_x[k] = base_x + half_x
    limbs.lever_y[k] = limbs.span_y[k] = base_y + half_y


def resolve(t: Tables) -> None:
    """Eliminate all limbs, from the tips to the roots."""
    bones = t.bones
    for bone in range(bones.sizes[2]):
        load_alone(t, bone)
    for run in range(bones.sizes[12]):
        first = bones.run_first[run]
        end = bones.run_end[run]
        lead = bones.run_lead[run]
        eliminate(t, first, end)
        for k in range(first, end):
            bear(t, k, k + lead)


def resolve_tree(t: Tables, tree: int) -> None:
    """The same for one tree."""
    first = t.trees.first[tree]
    end = first + t.trees.limbs[tree]
    parent = t.limbs.parent
    member = t.limbs.member
    load_alone(t, parent[member[end - 1]])
    for at in range(first, end):
        load_alone(t, member[at])
    for at in range(first, end):
        eliminate(t, member[at], member[at] + 1)
        bear(t, member[at], parent[member[at]])


def load_alone(t: Tables, bone: int) -> None:
    """Let a bone bear nothing but its body."""
    bones = t.bones
    bones.xx[bone] = bones.mass[bone]
    bones.yy[bone] = bones.mass[bone]
    bones.tt[bone] = bones.inertia[bone]
    bones.xy[bone] = 0.0
    bones.yx[bone] = 0.0
    bones.xt[bone] = 0.0
    bones.yt[bone] = 0.0
    bones.tx[bone] = 0.0
    bones.ty[bone] = 0.0


def eliminate(t: Tables, first: int, end: int) -> None:
    """Find what resists the motion of hinges, from row `first` to before `end`."""
    bones = t.bones
    limbs = t.limbs
    for k in range(first, end):
        xx = bones.xx[k]
        xy = bones.xy[k]
        yx = bones.yx[k]
        yy = bones.yy[k]
        x = limbs.reach_x[k]
        y = limbs.reach_y[k]
        lean_x = bones.xt[k] + xx * y - xy * x
        lean_y = bones.yt[k] + yx * y - yy * x
        turning = bones.tt[k] + bones.tx[k] * y - bones.ty[k] * x
        x = limbs.arm_x[k]
        y = limbs.arm_y[k]
        turning += lean_x * y - lean_y * x
        ease = 1.0 / turning if bones.inverse_inertia[k] > 0.0 and turning > 0.0 else 0.0
        sway_x = (bones.tx[k] + xx * y - yx * x) * ease
        sway_y = (bones.ty[k] + xy * y - yy * x) * ease
        xx -= lean_x * sway_x
        xy -= lean_x * sway_y
        yx -= lean_y * sway_x
        yy -= lean_y * sway_y
        limbs.ease[k] = ease
        limbs.sway_x[k] = sway_x
        limbs.sway_y[k] = sway_y
        limbs.lean_x[k] = lean_x * ease
        limbs.lean_y[k] = lean_y * ease
        limbs.xx[k] = xx
        limbs.xy[k] = xy
        limbs.yx[k] = yx
        limbs.yy[k] = yy


def bear(t: Tables, k: int, parent: int) -> None:
    """Let the parent bear what resists the motion of a hinge."""
    bones = t.bones
    limbs = t.limbs
    xx = limbs.xx[k]
    xy = limbs.xy[k]
    yx = limbs.yx[k]
    yy = limbs.yy[k]
    x = limbs.span_x[k]
    y = limbs.span_y[k]
    both_x = xy * x - xx * y
    both_y = yy * x - yx * y
    bones.xx[parent] += xx
    bones.xy[parent] += xy
    bones.yx[parent] += yx
    bones.yy[parent] += yy
    bones.xt[parent] += both_x
    bones.yt[parent] += both_y
    x = limbs.lever_x[k]
    y = limbs.lever_y[k]
    bones.tx[parent] += yx * x - xx * y
    bones.ty[parent] += yy * x - xy * y
    bones.tt[parent] += both_y * x - both_x * y


def solve_all(t: Tables) -> None:
    """Find the impulses that change the velocities of all hinges as wanted."""
    bones = t.bones
    sizes = bones.sizes
    for bone in range(sizes[2]):
        rest(t, bone)
    for run in range(sizes[12]):
        first = bones.run_first[run]
        end = bones.run_end[run]
        lead = bones.run_lead[run]
        for k in range(first, end):
            push(t, k)
        for k in range(first, end):
            push_parent(t, k, k + lead)
    for at in range(sizes[8], sizes[9]):
        move_root(t, bones.acting[at])
    for run in range(sizes[12] - 1, -1, -1):
        lead = bones.run_lead[run]
        for k in range(bones.run_first[run], bones.run_end[run]):
            move_child(t, k, k + lead)


def solve_tree(t: Tables, tree: int) -> None:
    """The same for one tree."""
    first = t.trees.first[tree]
    end = first + t.trees.limbs[tree]
    parent = t.limbs.parent
    member = t.limbs.member
    rest(t, parent[member[end - 1]])
    for at in range(first, end):
        rest(t, member[at])
    for at in range(first, end):
        push(t, member[at])
        push_parent(t, member[at], parent[member[at]])
    if t.trees.root[tree] >= 0:
        move_root(t, t.trees.root[tree])
    for at in range(end - 1, first - 1, -1):
        move_child(t, member[at], parent[member[at]])


def rest(t: Tables, bone: int) -> None:
    """Let nothing push a bone."""
    bones = t.bones
    bones.push_x[bone] = 0.0
    bones.push_y[bone] = 0.0
    bones.push_turn[bone] = 0.0


def push(t: Tables, k: int) -> None:
    """Find the impulse of a hinge as if the parent did not move."""
    bones = t.bones
    limbs = t.limbs
    x = bones.push_x[k]
    y = bones.push_y[k]
    turn = bones.push_turn[k] + x * limbs.arm_y[k] - y * limbs.arm_x[k]
    bones.push_turn[k] = turn
    rate_x = limbs.rate_x[k]
    rate_y = limbs.rate_y[k]
    limbs.free_x[k] = limbs.xx[k] * rate_x + limbs.xy[k] * rate_y + limbs.lean_x[k] * turn - x
    limbs.free_y[k] = limbs.yx[k] * rate_x + limbs.yy[k] * rate_y + limbs.lean_y[k] * turn - y


def push_parent(t: Tables, k: int, parent: int) -> None:
    """Let the parent feel it."""
    bones = t.bones
    limbs = t.limbs
    x = limbs.free_x[k]
    y = limbs.free_y[k]
    bones.push_x[parent] -= x
    bones.push_y[parent] -= y
    bones.push_turn[parent] -= limbs.lever_x[k] * y - limbs.lever_y[k] * x


def move_root(t: Tables, bone: int) -> None:
    """Find how a free root moves by what hangs on it."""
    bones = t.bones
    ease = 1.0 / bones.tt[bone] if bones.inverse_inertia[bone] > 0.0 else 0.0
    sway_x = bones.tx[bone] * ease
    sway_y = bones.ty[bone] * ease
    xx = bones.xx[bone] - bones.xt[bone] * sway_x
    xy = bones.xy[bone] - bones.xt[bone] * sway_y
    yx = bones.yx[bone] - bones.yt[bone] * sway_x
    yy = bones.yy[bone] - bones.yt[bone] * sway_y
    turn = bones.push_turn[bone] * ease
    x = bones.push_x[bone] - bones.xt[bone] * turn
    y = bones.push_y[bone] - bones.yt[bone] * turn
    scale = xx * yy - xy * yx
    step_x = 0.0
    step_y = 0.0
    if scale > 0.0:
        step_x = (yy * x - xy * y) / scale
        step_y = (xx * y - yx * x) / scale
    bones.step_x[bone] = step_x
    bones.step_y[bone] = step_y
    bones.step_spin[bone] = turn - sway_x * step_x - sway_y * step_y


def move_child(t: Tables, k: int, parent: int) -> None:
    """Find the impulse of a hinge and how the child moves, now that the parent does."""
    bones = t.bones
    limbs = t.limbs
    spin = bones.step_spin[parent]
    x = bones.step_x[parent] - spin * limbs.span_y[k]
    y = bones.step_y[parent] + spin * limbs.span_x[k]
    limbs.answer_x[k] = limbs.free_x[k] + limbs.xx[k] * x + limbs.xy[k] * y
    limbs.answer_y[k] = limbs.free_y[k] + limbs.yx[k] * x + limbs.yy[k] * y
    x += limbs.rate_x[k]
    y += limbs.rate_y[k]
    spin = limbs.ease[k] * bones.push_turn[k] - limbs.sway_x[k] * x - limbs.sway_y[k] * y
    bones.step_x[k] = x + spin * limbs.reach_y[k]
    bones.step_y[k] = y - spin * limbs.reach_x[k]
    bones.step_spin[k] = spin


def find_worst(t: Tables) -> None:
    """Note of each tree the greatest miss of a hinge."""
    limbs = t.limbs
    worst = t.trees.worst
    for at in range(t.bones.sizes[10]):
        worst[t.trees.acting[at]] = 0.0
    for at in range(t.bones.sizes[8]):
        k = t.bones.acting[at]
        tree = limbs.tree[k]
        if limbs.miss[k] > worst[tree]:
            worst[tree] = limbs.miss[k]
