"""Joints at the instant in which something strikes a joined body: all that is joined to it answers.

Velocities are linear in impulses, as long as no limit lets go: what a body with its joints answers
to a unit impulse (`answer`) says which impulse an impact takes, and what answers to that (`react`).
"""

from engine.linkage.geometry import place_node, weigh_node
from engine.linkage.impulses import add_up, take
from engine.linkage.jolts import jolt_at
from engine.linkage.limb_impacts import (
    answer_of_tree,
    commit_tree,
    heaviest_of_tree,
    place_tree,
    pose_in_flight,
    tree_at,
)
from engine.linkage.moments import book_braces
from engine.linkage.skyline import solve
from engine.linkage.tally import has_braces, node_of
from engine.linkage.velocities import MOST_CHANGES, begin_instant, find_rates, renew
from engine.tables import Tables

ALIKE = 8.0
"""Masses that differ by so many times count as alike."""

Changes = tuple[float, float, float, float, float, float]
"""Of the velocity and spin of a, then of b (m/s, rad/s)."""


def prepare_answers(t: Tables, a: int, b: int, time: float) -> None:
    """Place what is joined to a and b where it is at `time` of the part (s)."""
    tree_a = tree_at(t, a)
    tree_b = tree_at(t, b)
    if tree_a >= 0:
        place_tree(t, tree_a, time)
    if tree_b >= 0 and tree_b != tree_a:
        place_tree(t, tree_b, time)
    if has_braces(t, a) or has_braces(t, b):
        t.braces.sizes[5] = 0
        place_in_flight(t, time)
        begin_instant(t)
        renew(t)


def answer(t: Tables, a: int, b: int, change: Changes) -> Changes:
    """How velocities of a and b change in all if impulses alone would change them so; joints lend
    the rest to what has been placed.
    """
    tree_a = tree_at(t, a)
    tree_b = tree_at(t, b)
    in_all = change
    if tree_a >= 0:
        in_all = answer_of_tree(t, tree_a, a, b, in_all)
    if tree_b >= 0 and tree_b != tree_a:
        in_all = answer_of_tree(t, tree_b, a, b, in_all)
    if has_braces(t, a) or has_braces(t, b):
        in_all = answer_of_braces(t, a, b, in_all)
    return in_all


def answer_of_braces(t: Tables, a: int, b: int, change: Changes) -> Changes:
    """The same for the joints that are no hinges of trees."""
    for row in range(t.braces.sizes[2]):
        t.equations.impulse[row] = 0.0
    for node in range(1, t.braces.sizes[1]):
        still(t, node)
    node_a = note_change(t, a, change[0], change[1], change[2])
    node_b = note_change(t, b, change[3], change[4], change[5])
    for step in range(MOST_CHANGES):
        find_rates(t, False)
        solve(t)
        if not take(t, 0.0, False, step < MOST_CHANGES - 1):
            break
        renew(t)
    nodes = t.nodes
    return (
        change[0] + nodes.lent_x[node_a],
        change[1] + nodes.lent_y[node_a],
        change[2] + nodes.lent_spin[node_a],
        change[3] + nodes.lent_x[node_b],
        change[4] + nodes.lent_y[node_b],
        change[5] + nodes.lent_spin[node_b],
    )


def amends(t: Tables, a: int, b: int, time: float) -> Changes:
    """By how much velocities of a and b would change if they, and those of all that is joined to
    them, obeyed the joints at `time` of the part (s), trees of hinges apart; everything has been
    placed.

    Joints see to it at the end of a part: within it, velocities are not quite such as they allow,
    and far from it where contacts press on them. What is amiss is across all that joints allow, so
    that no impulse changes it. Limits and motors go on as they are.
    """
    if not has_braces(t, a) and not has_braces(t, b):
        return (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    for node in range(1, t.braces.sizes[1]):
        read_in_flight(t, node, time)
    find_rates(t, True)
    solve(t)
    take(t, 0.0, False, False)
    nodes = t.nodes
    node_a = node_of(t, a)
    node_b = node_of(t, b)
    return (
        nodes.lent_x[node_a],
        nodes.lent_y[node_a],
        nodes.lent_spin[node_a],
        nodes.lent_x[node_b],
        nodes.lent_y[node_b],
        nodes.lent_spin[node_b],
    )


def react(t: Tables, a: int, b: int, time: float, change: Changes) -> None:
    """Let the joints answer, at `time` of the part (s), to what changed the velocities of a and b.

    Everything has been placed. What lent to a and b changes them further.
    """
    answer(t, a, b, change)
    tree_a = tree_at(t, a)
    tree_b = tree_at(t, b)
    if tree_a >= 0:
        commit_tree(t, tree_a, time)
    if tree_b >= 0 and tree_b != tree_a:
        commit_tree(t, tree_b, time)
    if not has_braces(t, a) and not has_braces(t, b):
        return
    add_up(t)
    nodes = t.nodes
    for node in range(1, t.braces.sizes[1]):
        if changed(t, node):
            x = nodes.lent_x[node]
            y = nodes.lent_y[node]
            jolt_at(t, nodes.body[node], time, x, y, nodes.lent_spin[node])
            nodes.late[node] = 1
    book_braces(t, time, True)


def lightness(t: Tables, a: int, b: int) -> float:
    """Mass of a or b, as a share of the heaviest body that is joined to it; the smaller of the two,
    times `ALIKE`, 0..1. Everything has been placed.
    """
    of_a = ALIKE * share_of_heaviest(t, a)
    of_b = ALIKE * share_of_heaviest(t, b)
    least = of_a if of_a < of_b else of_b
    return least if least < 1.0 else 1.0


def share_of_heaviest(t: Tables, row: int) -> float:
    """Mass of one of them as such a share; 1 if it is not joined."""
    tree = tree_at(t, row)
    if tree >= 0:
        return t.bodies.mass[row] / heaviest_of_tree(t, tree)
    if has_braces(t, row):
        return t.bodies.mass[row] / t.structures.heaviest[t.nodes.structure[node_of(t, row)]]
    return 1.0


def still(t: Tables, node: int) -> None:
    """Let a node not move."""
    nodes = t.nodes
    nodes.vx[node] = 0.0
    nodes.vy[node] = 0.0
    nodes.spin[node] = 0.0
    nodes.lent_x[node] = 0.0
    nodes.lent_y[node] = 0.0
    nodes.lent_spin[node] = 0.0


def changed(t: Tables, node: int) -> bool:
    """Whether joints last changed the velocity of a node."""
    nodes = t.nodes
    return nodes.lent_x[node] != 0.0 or nodes.lent_y[node] != 0.0 or nodes.lent_spin[node] != 0.0


def place_in_flight(t: Tables, time: float) -> None:
    """Place the nodes where their bodies are at `time` of the part (s)."""
    for node in range(1, t.braces.sizes[1]):
        weigh_node(t, node)
        x, y, angle = pose_in_flight(t.bodies, t.nodes.body[node], time)
        place_node(t, node, x, y, angle)


def read_in_flight(t: Tables, node: int, time: float) -> None:
    """Read the velocity that a node's body has at `time` of the part (s)."""
    nodes = t.nodes
    bodies = t.bodies
    row = nodes.body[node]
    still(t, node)
    passed = time - bodies.clock[row] if bodies.inverse_mass[row] > 0.0 else 0.0
    nodes.vx[node] = bodies.vx[row] + bodies.path_x[row] * passed
    nodes.vy[node] = bodies.vy[row] + bodies.path_y[row] * passed
    nodes.spin[node] = bodies.spin[row] + bodies.path_spin[row] * passed


def note_change(t: Tables, row: int, vx: float, vy: float, spin: float) -> int:
    """Write the change of a body's velocity (m/s, rad/s) to its node; return that, 0 for none."""
    nodes = t.nodes
    node = node_of(t, row)
    if node > 0:
        nodes.vx[node] = vx
        nodes.vy[node] = vy
        nodes.spin[node] = spin
    return node
