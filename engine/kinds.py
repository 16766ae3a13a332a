"""Bodies that no force moves: kinematic ones go their way, static ones stay.

A kinematic body has infinite mass and keeps the velocity and spin that people give it: it pushes
others and is pushed by nobody. A static body stays until it is put elsewhere; walls are static.
"""

from typing import TYPE_CHECKING, Any

from engine.kernels.pose import put
from engine.settings import TICK
from engine.tables import FREE, RESTING
from engine.vector import Vector

if TYPE_CHECKING:
    from engine.store import Store


def repose(store: "Store", row: int) -> None:
    """Put the corners of a static body where its pose, just set, wants them."""
    t = store.tables
    if t.bodies.moves[row] == 0:
        put(t.bodies, t.corners, row, t.bodies.x[row], t.bodies.y[row], t.bodies.angle[row])


def set_off(store: "Store", row: int, velocity: Vector, spin: float, substeps: int) -> None:
    """Give a body a velocity (m/s) and a spin (rad/s).

    A kinematic body that sets off against what rests on it strikes it: such a contact rests no
    longer if they now close faster than forces explain within a substep.
    """
    t = store.tables
    bodies, pairs, contacts = t.bodies, t.pairs, t.contacts
    x, y = velocity.x - bodies.vx[row], velocity.y - bodies.vy[row]
    turn = spin - bodies.spin[row]
    bodies.vx[row], bodies.vy[row], bodies.spin[row] = velocity.x, velocity.y, spin
    t.progress.straight[0] = 0
    if bodies.inverse_mass[row] > 0.0:
        return
    from engine.kernels.impacts import settling_speed  # see `store`

    store.wake_all()
    substep = (t.state.dt[0] or TICK) / substeps
    for pair in range(store.count("pairs")):
        if pairs.state[pair] == RESTING and row in (pairs.a[pair], pairs.b[pair]):
            is_a = row == pairs.a[pair]
            arms: Any = contacts.normal_arm_a if is_a else contacts.normal_arm_b
            towards = 1.0 if is_a else -1.0
            along = x * pairs.normal_x[pair] + y * pairs.normal_y[pair]
            for i in range(2 * pair, 2 * pair + pairs.points[pair]):
                if towards * (along + turn * arms[i]) > settling_speed(t, pair, substep):
                    pairs.state[pair] = FREE
