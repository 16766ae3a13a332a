"""Impulses at many points at once, each within bounds of its own.

An impulse x_j at point j changes the speed at point i by A_ij x_j (the Delassus matrix, symmetric).
Wanted are impulses for which each speed changes by what it lacks, A x = b; but where one is at its
lower bound a speed may change by more, and where one is at its upper bound by less (a mixed linear
complementarity problem). Passing over the points one by one (projected Gauss-Seidel) soon finds
which are at a bound and is slow with all others; so these are then solved for together, by
elimination, and passes go on from there: Silcowitz, Niebe and Erleben, "Projected Gauss-Seidel
Subspace Minimization Method for Interactive Rigid Body Dynamics", 2010.
"""

from engine.tables import Tables

UNBOUNDED = 1e300
"""More than any impulse (N s)."""

BETWEEN = 3
"""Passes between two eliminations."""

SINGULAR = 1e-11
"""What is left of a number on the diagonal, as a share of it, if a point follows from others: its
impulse stays what it was."""


def couple(t: Tables, rows: int, turned: int) -> None:
    """Find how impulses along the normals in `Hits`, or along the same `turned` left, change speeds
    in these directions.
    """
    hits = t.hits
    unknowns = t.unknowns
    pairs = t.pairs
    bodies = t.bodies
    for row in range(rows):
        pair = hits.pair[row]
        a = pairs.a[pair]
        b = pairs.b[pair]
        x = hits.normal_x[row]
        y = hits.normal_y[row]
        if turned == 1:
            x, y = -y, x
        unknowns.a[row] = a
        unknowns.b[row] = b
        unknowns.along_x[row] = x
        unknowns.along_y[row] = y
        at_x = hits.x[row]
        at_y = hits.y[row]
        unknowns.arm_a[row] = (at_x - bodies.here_x[a]) * y - (at_y - bodies.here_y[a]) * x
        unknowns.arm_b[row] = (at_x - bodies.here_x[b]) * y - (at_y - bodies.here_y[b]) * x
    for row in range(rows):
        for other in range(row, rows):
            changes = coupling(t, row, other)
            t.delassus.coupling[row * rows + other] = changes
            t.delassus.coupling[other * rows + row] = changes


def coupling(t: Tables, row: int, other: int) -> float:
    """Change of the speed at one point by a unit impulse at another (1/kg)."""
    unknowns = t.unknowns
    inverse_mass = t.bodies.inverse_mass
    inverse_inertia = t.bodies.inverse_inertia
    a = unknowns.a[row]
    b = unknowns.b[row]
    along = unknowns.along_x[row] * unknowns.along_x[other]
    along += unknowns.along_y[row] * unknowns.along_y[other]
    arm_a = unknowns.arm_a[row]
    arm_b = unknowns.arm_b[row]
    changes = 0.0
    if a == unknowns.a[other]:
        changes += inverse_mass[a] * along + inverse_inertia[a] * arm_a * unknowns.arm_a[other]
    elif a == unknowns.b[other]:
        changes -= inverse_mass[a] * along + inverse_inertia[a] * arm_a * unknowns.arm_b[other]
    if b == unknowns.b[other]:
        changes += inverse_mass[b] * along + inverse_inertia[b] * arm_b * unknowns.arm_b[other]
    elif b == unknowns.a[other]:
        changes -= inverse_mass[b] * along + inverse_inertia[b] * arm_b * unknowns.arm_a[other]
    return changes


def solve_bounded(t: Tables, rows: int, enough: float, passes: int) -> float:
    """Find the impulses `value` of `Unknowns`, from those that stand there on, until the speed at
    no point changes by more than `enough` (m/s) in a pass, in so many `passes` at most; return by
    how much one did in the last.
    """
    most = enough
    for swept in range(passes):
        if swept % BETWEEN == 0:
            find_lacks(t, rows)
        most = pass_over(t, rows)
        if most <= enough:
            break
        if swept % BETWEEN == BETWEEN - 1:
            solve_free(t, rows)
    return most


def find_lacks(t: Tables, rows: int) -> None:
    """Find by how much speeds still are to change."""
    unknowns = t.unknowns
    coupling = t.delassus.coupling
    for row in range(rows):
        unknowns.lacks[row] = unknowns.wanted[row]
    for row in range(rows):
        value = unknowns.value[row]
        if value != 0.0:
            for other in range(rows):
                unknowns.lacks[other] -= coupling[row * rows + other] * value


def pass_over(t: Tables, rows: int) -> float:
    """Solve for one point after another; return the largest change of a speed (m/s)."""
    unknowns = t.unknowns
    coupling = t.delassus.coupling
    largest = 0.0
    for row in range(rows):
        yields = coupling[row * rows + row]
        change = change_within(t, row, unknowns.value[row] + unknowns.lacks[row] / yields)
        if change != 0.0:
            for other in range(rows):
                unknowns.lacks[other] -= coupling[row * rows + other] * change
            if abs(change) * yields > largest:
                largest = abs(change) * yields
    return largest


def solve_free(t: Tables, rows: int) -> None:
    """Solve for all points together whose impulses are at no bound, and go that way until one is.

    Each such step comes nearer to what is sought, as each pass does: a quadratic function, the
    energy that is left, falls.
    """
    unknowns = t.unknowns
    free = 0
    for row in range(rows):
        if unknowns.least[row] < unknowns.value[row] < unknowns.most[row]:
            unknowns.free[free] = row
            free += 1
    find_lacks(t, rows)
    eliminate(t, rows, free)
    share = 1.0
    for i in range(free - 1, -1, -1):
        row = unknowns.free[i]
        change = change_of_free(t, i, free)
        unknowns.change[i] = change
        room = unknowns.most[row] if change > 0.0 else unknowns.least[row]
        room -= unknowns.value[row]
        if abs(change) * share > abs(room):
            share = room / change
    for i in range(free):
        row = unknowns.free[i]
        change_within(t, row, unknowns.value[row] + share * unknowns.change[i])


def eliminate(t: Tables, rows: int, free: int) -> None:
    """Bring the equations of the `free` impulses into the form of a triangle (Gauss); what follows
    from others gets a zero on the diagonal.
    """
    unknowns = t.unknowns
    coupling = t.delassus.coupling
    factor = t.delassus.factor
    width = free + 1
    for i in range(free):
        row = unknowns.free[i]
        for j in range(i, free):
            factor[i * width + j] = coupling[row * rows + unknowns.free[j]]
        factor[i * width + free] = unknowns.lacks[row]
    for k in range(free):
        row = unknowns.free[k]
        pivot = factor[k * width + k]
        if pivot <= SINGULAR * coupling[row * rows + row]:
            factor[k * width + k] = 0.0
            continue
        for i in range(k + 1, free):
            share = factor[k * width + i] / pivot
            if share != 0.0:
                for j in range(i, width):
                    factor[i * width + j] -= share * factor[k * width + j]


def change_of_free(t: Tables, i: int, free: int) -> float:
    """By how much the impulse in place `i` of the free ones is to change (N s), if those after it
    are known.
    """
    factor = t.delassus.factor
    first = i * (free + 1)
    pivot = factor[first + i]
    if pivot <= 0.0:
        return 0.0
    left = factor[first + free]
    for j in range(i + 1, free):
        left -= factor[first + j] * t.unknowns.change[j]
    return left / pivot


def change_within(t: Tables, row: int, value: float) -> float:
    """Set an impulse within its bounds (N s); return by how much it changed."""
    unknowns = t.unknowns
    before = unknowns.value[row]
    if value < unknowns.least[row]:
        value = unknowns.least[row]
    elif value > unknowns.most[row]:
        value = unknowns.most[row]
    unknowns.value[row] = value
    return value - before
