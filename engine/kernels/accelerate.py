"""Newton's second law: what pushes, gravity and drag do to each body during one tick.

Within a tick every body moves along a parabola: its mean acceleration is constant, and an
integrator is nothing but a rule for that acceleration and for the velocity at which the parabola
starts. The difference between that velocity and the reported one is the body's *lead*:

- semi-implicit Euler (thesis, eq. 16-17), x' = x + (v + a dt) dt: lead = a dt / 2. Its velocity is
  that of half a tick ago, which makes the position err by exactly a T dt / 2 after the time T;
- explicit Euler, x' = x + v dt: lead = -a dt / 2;
- velocity Verlet, x' = x + v dt + a0 dt^2 / 2, v' = v + (a0 + a1) dt / 2: no lead for constant a;
- the classic Runge-Kutta method of fourth order: no lead for constant a.

Impacts happen at the velocity of the parabola, so that all four bounce truly.
"""

from engine.kernels.books import note_starts
from engine.kernels.elementary import cos_sin
from engine.kernels.fields import immerse, lead_of_euler
from engine.settings import Laws
from engine.tables import Bodies, Fields, Pushes
from engine.tables.bodies import EVERY_BODY


def accelerate(
    bodies: Bodies,
    count: int,
    pushes: Pushes,
    pushing: int,
    fields: Fields,
    laws: Laws,
    dt: float,
    forced: bool,
) -> None:
    """Set mean accelerations, leads and mean forces of this tick; use up the time of the pushes."""
    ax = bodies.ax
    ay = bodies.ay
    moves = bodies.moves
    for row in range(count):
        if moves[row] == 1:
            ax[row] = ay[row] = bodies.aspin[row] = 0.0
            bodies.lead_x[row] = bodies.lead_y[row] = bodies.lead_spin[row] = 0.0
    push(bodies, count, pushes, pushing, dt)
    if forced:
        note_starts(bodies, count)
    fielded = fields.used[0]
    everyone = 0
    while everyone < fielded and fields.row[everyone] == EVERY_BODY:
        everyone += 1
    first = everyone
    dragged = laws.linear_drag > 0.0 or laws.quadratic_drag > 0.0
    lead = lead_of_euler(laws.integrator, dt)
    for row in range(count):
        last = first
        while last < fielded and fields.row[last] == row:
            last += 1
        if bodies.inverse_mass[row] > 0.0:
            if dragged or everyone > 0 or last > first:
                immerse(bodies, row, fields, everyone, first, last, laws, dt)
            else:
                scale = bodies.gravity_scale[row]
                ax[row] += scale * laws.gravity_x
                ay[row] += scale * laws.gravity_y
                if lead != 0.0:
                    bodies.lead_x[row] = ax[row] * lead
                    bodies.lead_y[row] = ay[row] * lead
                    bodies.lead_spin[row] = bodies.aspin[row] * lead
            bodies.force_x[row] = bodies.mass[row] * ax[row]
            bodies.force_y[row] = bodies.mass[row] * ay[row]
            if bodies.held[row] > 0:
                bodies.lead_x[row] = bodies.lead_y[row] = bodies.lead_spin[row] = 0.0
        first = last


def act_on(bodies: Bodies, row: int, fields: Fields, laws: Laws, dt: float) -> None:
    """Let gravity and fields act for a tick on one body that nothing pushes and that stood."""
    bodies.ax[row] = bodies.ay[row] = bodies.aspin[row] = 0.0
    bodies.lead_x[row] = bodies.lead_y[row] = bodies.lead_spin[row] = 0.0
    fielded = fields.used[0]
    everyone = 0
    while everyone < fielded and fields.row[everyone] == EVERY_BODY:
        everyone += 1
    first = everyone
    while first < fielded and fields.row[first] < row:
        first += 1
    last = first
    while last < fielded and fields.row[last] == row:
        last += 1
    immerse(bodies, row, fields, everyone, first, last, laws, dt)
    bodies.force_x[row] = bodies.mass[row] * bodies.ax[row]
    bodies.force_y[row] = bodies.mass[row] * bodies.ay[row]


def push(bodies: Bodies, count: int, pushes: Pushes, pushing: int, dt: float) -> None:
    """Add up the pushes; one that ends within the tick counts for the part that it lasts.

    A force F over the first part tau of the tick moves the body by F/m tau (dt - tau/2): the lead
    is what the mean acceleration F/m tau/dt lacks of that.
    """
    for row in range(count):
        bodies.torque[row] = 0.0
    for i in range(pushing):
        row = pushes.row[i]
        lasts = pushes.left[i]
        if lasts - dt <= 1e-9 * dt:  # no tick for a remainder of rounding
            pushes.left[i] = 0.0
        else:
            pushes.left[i] = lasts - dt
            lasts = dt
        share = lasts / dt
        late = (dt - lasts) / 2.0
        angle = bodies.angle[row] + bodies.spin[row] * dt / 2.0
        cos, sin = cos_sin(angle)
        arm_x = cos * pushes.at_x[i] - sin * pushes.at_y[i]
        arm_y = sin * pushes.at_x[i] + cos * pushes.at_y[i]
        x = pushes.x[i] * share
        y = pushes.y[i] * share
        torque = pushes.torque[i] * share + arm_x * y - arm_y * x
        ax = x * bodies.inverse_mass[row]
        ay = y * bodies.inverse_mass[row]
        aspin = torque * bodies.inverse_inertia[row]
        bodies.ax[row] += ax
        bodies.ay[row] += ay
        bodies.aspin[row] += aspin
        bodies.torque[row] += torque
        bodies.lead_x[row] += ax * late
        bodies.lead_y[row] += ay * late
        bodies.lead_spin[row] += aspin * late
