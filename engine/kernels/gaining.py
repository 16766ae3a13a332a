"""Contacts bring no energy: what sweeps that end too early leave is found by the work they do.

Sweeps start from the impulses of the part before. Those of a landing stopped what fell, and would
throw it up again: the sweeps have to take them back. Solved to the end, contacts take energy but
for what it costs to push overlaps apart. As long as those of an island (see `islands`) bring more,
its sweeps are not at their end; some more follow, and what still gains then is weakened until it
does not.
"""

from engine.kernels.crowds import sweep_until_calm
from engine.kernels.packing import load_points
from engine.kernels.spring import PUSH
from engine.kernels.sticking import cluster_of, connect, island_of
from engine.kernels.sweeps import QUIET
from engine.linkage.limb_sweeps import sweep_all
from engine.tables import Bodies, Tables

MORE = 4
"""So many more sweeps to and fro at most."""


def only_forces_drive(t: Tables, count: int) -> bool:
    """Whether contacts have no energy to bring: nothing immovable that is touched moves."""
    bodies = t.bodies
    for row in range(count):
        if bodies.held[row] > 0 and bodies.inverse_mass[row] == 0.0:
            moves = bodies.vx[row] != 0.0 or bodies.vy[row] != 0.0 or bodies.spin[row] != 0.0
            if moves or bodies.surface_speed[row] != 0.0:
                return False
    return True


def sweep_on(t: Tables, resting: int, count: int, part: float, calm: float, crowded: bool) -> None:
    """Sweep to and fro over contacts of islands that gain energy in a part (s), until one sweep
    changes no velocity by more than `calm` (reaches a second); see `contacts.kick`. A crowd is
    swept as a whole. Those that gain all the same are weakened.
    """
    pairs = t.pairs
    connect(t, count, resting)
    for k in range(resting):
        pairs.grouped[k] = pairs.resting[k]
    gaining = list_gaining(t, resting, count, part)
    for _ in range(MORE):
        if gaining == 0:
            break
        if crowded:
            list_all(t, resting)
            ended = sweep_until_calm(t, 2, calm, 0)
        else:
            sweep_all(t, gaining, calm, False)
            ended = sweep_all(t, gaining, calm, True) == QUIET
        gaining = list_gaining(t, resting, count, part)
        if ended:
            break
    if gaining > 0:
        weaken(t, gaining, count, part)
    list_all(t, resting)


def list_all(t: Tables, resting: int) -> None:
    """List all pairs in their order again."""
    for k in range(resting):
        t.pairs.resting[k] = t.pairs.grouped[k]


def list_gaining(t: Tables, resting: int, count: int, part: float) -> int:
    """List the pairs of islands that gain energy in a part (s) first; return their number.

    Contacts act all through a part, so their impulses do the work by mean velocities. What pushing
    bodies out of overlaps would lend them does not count.
    """
    bodies = t.bodies
    pairs = t.pairs
    for row in range(count):
        bodies.gained[row] = 0.0
        bodies.kicked[row] = 0.0
    for row in range(count):
        if bodies.held[row] > 0 and bodies.inverse_mass[row] > 0.0:
            island = cluster_of(t, row)
            x = bodies.kick_x[row] - bodies.vx[row] - bodies.ax[row] * part
            y = bodies.kick_y[row] - bodies.vy[row] - bodies.ay[row] * part
            work = x * (bodies.vx[row] + bodies.kick_x[row])
            work += y * (bodies.vy[row] + bodies.kick_y[row])
            lent = PUSH * bodies.reach[row]
            bodies.gained[island] += bodies.mass[row] * (work - lent * lent) / 2.0
            bodies.kicked[island] += bodies.mass[row] * (x * x + y * y) / 2.0
            if bodies.inverse_inertia[row] > 0.0:
                turn = bodies.kick_spin[row] - bodies.spin[row] - bodies.aspin[row] * part
                work = turn * (bodies.spin[row] + bodies.kick_spin[row])
                bodies.gained[island] += bodies.inertia[row] * work / 2.0
                bodies.kicked[island] += bodies.inertia[row] * turn * turn / 2.0
    gaining = 0
    for k in range(resting):
        if bodies.gained[island_of(t, pairs.grouped[k])] > 0.0:
            pairs.resting[gaining] = pairs.grouped[k]
            gaining += 1
    return gaining


def weaken(t: Tables, gaining: int, count: int, part: float) -> None:
    """Weaken all contacts of islands that gain energy in a part (s), until they do not.

    By a share s of the kicks, contacts do the work s (W - K) + s^2 K, if all of them do W and
    K is the energy of the kicks alone: none at s = 1 - W/K.
    """
    bodies = t.bodies
    pairs = t.pairs
    for row in range(count):
        if bodies.held[row] > 0 and bodies.inverse_mass[row] > 0.0:
            less = excess(bodies, cluster_of(t, row))
            x = bodies.kick_x[row] - bodies.vx[row] - bodies.ax[row] * part
            y = bodies.kick_y[row] - bodies.vy[row] - bodies.ay[row] * part
            turn = bodies.kick_spin[row] - bodies.spin[row] - bodies.aspin[row] * part
            bodies.kick_x[row] -= less * x
            bodies.kick_y[row] -= less * y
            bodies.kick_spin[row] -= less * turn
    for k in range(gaining):
        pair = pairs.resting[k]
        left = 1.0 - excess(bodies, island_of(t, pair))
        pairs.rolling_torque[pair] *= left
        for row in range(2 * pair, 2 * pair + pairs.points[pair]):
            t.contacts.normal_impulse[row] *= left
            t.contacts.tangent_impulse[row] *= left
        if t.lanes.sizes[2] == 1 and pairs.lane[pair] >= 0:
            load_points(t, pair, pairs.lane[pair])


def excess(bodies: Bodies, island: int) -> float:
    """Share of the kicks of an island that is too much; see `weaken`."""
    gained = bodies.gained[island]
    if gained <= 0.0:
        return 0.0
    kicked = bodies.kicked[island]
    return gained / kicked if gained < kicked else 1.0
