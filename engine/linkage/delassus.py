"""What an impulse at a contact changes where joints answer to it at once: the Delassus operator.

A unit impulse at one point changes the speed at another by
A = J (M^-1 - M^-1 G^T (G M^-1 G^T)^-1 G M^-1) J^T (Jacobians J of the contacts and G of the joints,
inverse masses M^-1; Brogliato, "Nonsmooth Mechanics", 2016, section 5.2). What joints add is solved
inside the profile of their system (`skyline`).
"""

from engine.kernels.complementarity import coupling
from engine.linkage.answers import still
from engine.linkage.impulses import lend, rate_of
from engine.linkage.skyline import solve_between
from engine.linkage.tally import has_braces, node_of
from engine.tables import Tables


def couple_through_joints(t: Tables, points: int, structure: int) -> None:
    """Find how impulses change speeds, joints included."""
    count = 2 * points
    entry = t.delassus.coupling
    for unknown in range(count):
        be_still(t)
        shake(t, unknown, structure, 1.0)
        answer(t, structure)
        for row in range(t.structures.first[structure], t.structures.end[structure]):
            lend(t, row, t.equations.unknown[row])
        for other in range(unknown, count):
            changes = coupling(t, other, unknown) + lent_along(t, other, structure)
            entry[unknown * count + other] = changes
            entry[other * count + unknown] = changes


def be_still(t: Tables) -> None:
    """Let no node move."""
    for node in range(t.braces.sizes[1]):
        still(t, node)


def shake(t: Tables, unknown: int, structure: int, impulse: float) -> None:
    """Let an impulse change the velocities of nodes of a structure."""
    unknowns = t.unknowns
    a = unknowns.a[unknown]
    b = unknowns.b[unknown]
    x = unknowns.along_x[unknown] * impulse
    y = unknowns.along_y[unknown] * impulse
    shake_node(t, node_in(t, a, structure), -x, -y, -unknowns.arm_a[unknown] * impulse)
    shake_node(t, node_in(t, b, structure), x, y, unknowns.arm_b[unknown] * impulse)


def shake_node(t: Tables, node: int, x: float, y: float, turn: float) -> None:
    """Let an impulse (N s) and an angular one (N m s) change the velocity of a node."""
    nodes = t.nodes
    nodes.vx[node] += nodes.inverse_mass[node] * x
    nodes.vy[node] += nodes.inverse_mass[node] * y
    nodes.spin[node] += nodes.inverse_inertia[node] * turn


def answer(t: Tables, structure: int) -> None:
    """Find the impulses by which the joints of a structure answer to the velocities of its nodes,
    as `unknown` of its equations.
    """
    first = t.structures.first[structure]
    end = t.structures.end[structure]
    for row in range(first, end):
        t.equations.unknown[row] = -rate_of(t, 2 * row) - rate_of(t, 2 * row + 1)
    solve_between(t, first, end)


def lent_along(t: Tables, unknown: int, structure: int) -> float:
    """How fast what joints lent opens a point, along its direction (m/s)."""
    unknowns = t.unknowns
    x = unknowns.along_x[unknown]
    y = unknowns.along_y[unknown]
    opens = of_body(t, unknowns.b[unknown], structure, x, y, unknowns.arm_b[unknown])
    return opens - of_body(t, unknowns.a[unknown], structure, x, y, unknowns.arm_a[unknown])


def of_body(t: Tables, row: int, structure: int, x: float, y: float, arm: float) -> float:
    """What one body adds to that; 0 if it is none of the structure."""
    nodes = t.nodes
    node = node_in(t, row, structure)
    return nodes.lent_x[node] * x + nodes.lent_y[node] * y + nodes.lent_spin[node] * arm


def node_in(t: Tables, row: int, structure: int) -> int:
    """The node of a body in a structure; 0, which never moves, if it is none of it."""
    node = node_of(t, row) if has_braces(t, row) else 0
    return node if t.nodes.structure[node] == structure else 0
