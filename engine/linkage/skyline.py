"""The system of equations of all joints, solved directly.

Impulses that joints exert change the velocities of their rows by A = J M^-1 J^T (Jacobians J,
inverse masses M^-1; a spring adds its softness to the diagonal). A is symmetric and positive
definite, and rows meet in it only where joints share a body. Rows stand in an order that keeps
such joints close to each other (`linkage.order`), so that A = L D L^T is factorised inside its
profile (Jennings, "A compact storage scheme for the solution of symmetric linear simultaneous
equations", 1966): for a chain, a number of operations in proportion to its length.

Rows that are not solved keep their place; zero stands for the inverse of their pivot. So it does
for equations that say nothing new (a plank on two nails).
"""

from engine.tables import Tables

REDUNDANT = 1e-8
"""A pivot below this share of its diagonal entry is rounding, or little more: others already say
the same, and what divides by it makes of rounding what bodies feel."""


def assemble(t: Tables) -> None:
    """Set the entries of A, and the mass of each row."""
    entry = t.profile.entry
    arms = t.arms
    equations = t.equations
    for k in range(t.braces.sizes[4]):
        entry[k] = 0.0
    for k in range(t.braces.sizes[3]):
        left = t.couplings.left[k]
        right = t.couplings.right[k]
        entry[t.couplings.at[k]] += (
            arms.x[left] * arms.by_mass_x[right]
            + arms.y[left] * arms.by_mass_y[right]
            + arms.turn[left] * arms.by_inertia[right]
        )
    for row in range(t.braces.sizes[2]):
        diagonal = entry[equations.base[row] + row]
        equations.mass[row] = 1.0 / diagonal if diagonal > 0.0 else 0.0


def factorise(t: Tables) -> None:
    """Turn the entries of A into those of L; the pivots D are kept as their inverses."""
    entry = t.profile.entry
    equations = t.equations
    for row in range(t.braces.sizes[2]):
        if equations.solved[row] == 0:
            equations.inverse_pivot[row] = 0.0
            continue
        first = equations.first[row]
        base = equations.base[row]
        for column in range(first, row):
            base_of = equations.base[column]
            start = equations.first[column]
            if start < first:
                start = first
            value = entry[base + column]
            for k in range(start, column):
                value -= entry[base + k] * entry[base_of + k]
            entry[base + column] = value
        diagonal = entry[base + row] + equations.soft[row]
        pivot = diagonal
        for column in range(first, row):
            value = entry[base + column]
            lower = value * equations.inverse_pivot[column]
            entry[base + column] = lower
            pivot -= value * lower
        equations.inverse_pivot[row] = 1.0 / pivot if pivot > REDUNDANT * diagonal else 0.0


def solve(t: Tables) -> None:
    """Replace the right-hand sides in `unknown` by the solution."""
    solve_between(t, 0, t.braces.sizes[2])


def solve_between(t: Tables, start: int, end: int) -> None:
    """The same for rows from `start` to `end`, which no others share a body with."""
    entry = t.profile.entry
    equations = t.equations
    unknown = equations.unknown
    for row in range(start, end):
        if equations.solved[row] == 0:
            unknown[row] = 0.0
            continue
        base = equations.base[row]
        value = unknown[row]
        for k in range(equations.first[row], row):
            value -= entry[base + k] * unknown[k]
        unknown[row] = value
    for row in range(start, end):
        unknown[row] *= equations.inverse_pivot[row]
    for row in range(end - 1, start - 1, -1):
        value = unknown[row]
        if equations.solved[row] != 0 and value != 0.0:
            base = equations.base[row]
            for k in range(equations.first[row], row):
                unknown[k] -= entry[base + k] * value
