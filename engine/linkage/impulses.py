"""How impulses of joints get to the bodies and back: nodes hold what the joints change."""

from engine.linkage.modes import bounds, coordinate_row, is_put_back, overstrained
from engine.tables import Tables
from engine.tables.linkage import STRAINED


def lend(t: Tables, row: int, impulse: float) -> None:
    """Let the impulse of a row change the velocities of its two nodes."""
    arms = t.arms
    nodes = t.nodes
    for arm in range(2 * row, 2 * row + 2):
        node = arms.node[arm]
        nodes.lent_x[node] += arms.by_mass_x[arm] * impulse
        nodes.lent_y[node] += arms.by_mass_y[arm] * impulse
        nodes.lent_spin[node] += arms.by_inertia[arm] * impulse


def rate_of(t: Tables, arm: int) -> float:
    """What one body adds to the velocity of a row (m/s or rad/s)."""
    nodes = t.nodes
    arms = t.arms
    node = arms.node[arm]
    return (
        arms.x[arm] * (nodes.vx[node] + nodes.lent_x[node])
        + arms.y[arm] * (nodes.vy[node] + nodes.lent_y[node])
        + arms.turn[arm] * (nodes.spin[node] + nodes.lent_spin[node])
    )


def take(t: Tables, share: float, spent: bool, bounded: bool) -> bool:
    """Add the solution to the impulses; return whether a mode changed instead.

    Where coordinates would go beyond their bounds, only those go, as far as the bounds, and are no
    equations any more: a solution that had them pull says nothing about the others.

    Args:
        t: the tables.
        share: for which share of the part a motor may give its effort.
        spent: whether it has given part of that already, at the start of the part.
        bounded: whether to heed the bounds.
    """
    if bounded and let_go(t, share, spent):
        return True
    for row in range(t.braces.sizes[2]):
        add(t, row, t.equations.unknown[row])
    return False


def let_go(t: Tables, share: float, spent: bool) -> bool:
    """Bring the impulses that the solution would put beyond their bounds there; see `take`."""
    equations = t.equations
    joints = t.joints
    changed = False
    for brace in range(t.braces.sizes[0]):
        row = coordinate_row(t, brace)
        if row >= 0 and equations.solved[row] == 1:
            joint = t.braces.joint[brace]
            least, most = bounds_left(t, brace, row, share, spent)
            after = equations.impulse[row] + equations.unknown[row]
            if after < least or after > most:
                bound = least if after < least else most
                add(t, row, bound - equations.impulse[row])
                joints.mode[joint] = overstrained(t, joint)
                changed = True
    return changed


def bounds_left(t: Tables, brace: int, row: int, share: float, spent: bool) -> tuple[float, float]:
    """Least and greatest impulse that the coordinate of a joint may have now; see `take`."""
    joints = t.joints
    joint = t.braces.joint[brace]
    least, most = bounds(t, joint, joints.effort[joint] * share * joints.part[joint])
    if spent and (joints.motor[joint] == 1 or is_put_back(t, joint, row)):
        given = noted_impulse(t, joint, row - t.braces.first[brace])
        return least - given, most - given
    return least, most


def add(t: Tables, row: int, change: float) -> None:
    """Add to the impulse of a row."""
    equations = t.equations
    equations.change[row] = change
    equations.total[row] += change
    equations.impulse[row] += change
    lend(t, row, change)


def note_impulses(t: Tables) -> None:
    """Keep the impulses of the start of the part, to start the next one from."""
    joints = t.joints
    impulse = t.equations.impulse
    for brace in range(t.braces.sizes[0]):
        joint = t.braces.joint[brace]
        first = t.braces.first[brace]
        rows = t.braces.rows[brace]
        joints.impulse_0[joint] = impulse[first]
        if rows > 1:
            joints.impulse_1[joint] = impulse[first + 1]
        if rows > 2:
            joints.impulse_2[joint] = impulse[first + 2]


def noted_impulse(t: Tables, joint: int, which: int) -> float:
    """The impulse that a row of a joint gave at the start of the part (N s or N m s)."""
    if which == 0:
        return t.joints.impulse_0[joint]
    if which == 1:
        return t.joints.impulse_1[joint]
    return t.joints.impulse_2[joint]


def add_up(t: Tables) -> None:
    """Add the impulses to the sums of the tick."""
    joints = t.joints
    arms = t.arms
    for brace in range(t.braces.sizes[0]):
        joint = t.braces.joint[brace]
        first = t.braces.first[brace]
        for row in range(first, first + t.braces.rows[brace]):
            impulse = t.equations.impulse[row]
            x = arms.x[2 * row + 1]
            y = arms.y[2 * row + 1]
            if x == 0.0 and y == 0.0:
                joints.sum_turn[joint] += impulse * arms.turn[2 * row + 1]
            else:
                joints.sum_x[joint] += impulse * x
                joints.sum_y[joint] += impulse * y


def solve_for(t: Tables) -> None:
    """Say which rows are equations in the present modes, springs apart."""
    for brace in range(t.braces.sizes[0]):
        row = coordinate_row(t, brace)
        if row >= 0:
            mode = t.joints.mode[t.braces.joint[brace]]
            t.equations.solved[row] = 0 if mode == 0 or mode == STRAINED else 1
