"""The books: what every cause gave to the bodies, and took from them.

Each entry is exact for the motion as it is computed, so that they sum to the change to rounding:

- a force that is constant through a tick does the work F . (way of the tick), along any path;
- impulses J_i that are given at once change the kinetic energy by the sum of J_i . (u_i before +
  u_i after) / 2, u_i being the relative velocity where J_i acts, however they depend on each other;
- an impulse that is spread evenly over a part of a tick does the work J . (way of the part) / part;
- what an integrator adds when a flight begins, and takes back when it ends (see `accelerate`), is
  booked as its own error.
"""

from engine.kernels.moments import (
    book_lost,
    book_lost_in_impact,
    book_lost_in_rest,
    book_turn_by_push,
    book_turn_by_wall,
    forget_bend,
    is_particle,
    turn_of,
)
from engine.settings import Laws
from engine.tables import Bodies, Tables

INSTANT = 1e-9
"""Impacts in a part no longer than this (s) are at its start: ways in it are lost in rounding."""

CALM = 1e-14
"""Bodies that are slower (m/s, rad/s) through a part of a tick let their contacts do no work."""


def is_forced(t: Tables, laws: Laws) -> bool:
    """Whether any force but those of contacts and joints may act."""
    return (
        laws.gravity_x != 0.0
        or laws.gravity_y != 0.0
        or laws.linear_drag > 0.0
        or laws.quadratic_drag > 0.0
        or t.counts.pushes[0] > 0
        or t.fields.used[0] > 0
    )


def note_starts(bodies: Bodies, count: int) -> None:
    """Note how bodies stand at the start of a tick, and what pushes, alone so far, do to them."""
    for row in range(count):
        bodies.start_angle[row] = bodies.angle[row]
        bodies.push_x[row] = 0.0
        bodies.push_y[row] = 0.0
        if bodies.inverse_mass[row] > 0.0:
            bodies.push_x[row] = bodies.mass[row] * bodies.ax[row]
            bodies.push_y[row] = bodies.mass[row] * bodies.ay[row]
        bodies.push_torque[row] = bodies.torque[row]
        bodies.field_x[row] = 0.0
        bodies.field_y[row] = 0.0


def work_of(bodies: Bodies, row: int, x: float, y: float, spin: float) -> float:
    """Energy (J) that a change of velocity (m/s) and spin (rad/s) is about to bring."""
    work = x * (bodies.vx[row] + x / 2.0) + y * (bodies.vy[row] + y / 2.0)
    work *= bodies.mass[row]
    if bodies.inverse_inertia[row] > 0.0:
        work += bodies.inertia[row] * spin * (bodies.spin[row] + spin / 2.0)
    return work


def book_lead(t: Tables, row: int, x: float, y: float, spin: float) -> None:
    """Book what an integrator adds to the velocities of a body, just before it does."""
    if x == 0.0 and y == 0.0 and spin == 0.0:
        return
    mass = t.bodies.mass[row]
    t.books.integrator_work[0] += work_of(t.bodies, row, x, y, spin)
    t.books.integrator_turn[0] += turn_of(t.bodies, row, x, y, spin)
    t.books.integrator_x[0] += mass * x
    t.books.integrator_y[0] += mass * y


def book_jolt(t: Tables, row: int, x: float, y: float, spin: float) -> None:
    """Book what joints add to the velocities of a body at once, just before they do."""
    if t.bodies.inverse_mass[row] == 0.0:
        return
    mass = t.bodies.mass[row]
    t.books.joint_work[0] += work_of(t.bodies, row, x, y, spin)
    t.books.joint_x[0] += mass * x
    t.books.joint_y[0] += mass * y


def book_halt(t: Tables, row: int) -> None:
    """Book what is left of the motion of a body that is about to sleep, to what it rests on."""
    bodies = t.bodies
    vx = bodies.vx[row]
    vy = bodies.vy[row]
    t.books.contact_heat[0] -= work_of(bodies, row, -vx, -vy, -bodies.spin[row])
    t.books.wall_turn[0] -= turn_of(bodies, row, vx, vy, bodies.spin[row])
    t.books.wall_x[0] -= bodies.mass[row] * vx
    t.books.wall_y[0] -= bodies.mass[row] * vy


def book_forces(t: Tables, count: int, laws: Laws, dt: float) -> None:
    """Book the work and the impulses of all forces in a tick of `dt` seconds that is over."""
    bodies = t.bodies
    books = t.books
    driven = t.counts.pushes[0] > 0 or t.fields.used[0] > 0
    resisted = laws.linear_drag > 0.0 or laws.quadratic_drag > 0.0
    work = 0.0
    x_sum = 0.0
    y_sum = 0.0
    turn = 0.0
    sleeps = laws.sleep_time > 0.0
    for row in range(count):
        woke = sleeps and bodies.restless[row] == 1  # within this tick: no force acted on it
        if bodies.inverse_mass[row] > 0.0 and not woke:
            weight = bodies.mass[row] * bodies.gravity_scale[row]
            fx = weight * laws.gravity_x
            fy = weight * laws.gravity_y
            x = bodies.x[row] - bodies.start_x[row]
            y = bodies.y[row] - bodies.start_y[row]
            work += fx * x + fy * y
            x_sum += fx
            y_sum += fy
            sum_x = bodies.start_x[row] * dt + bodies.absement_x[row]
            sum_y = bodies.start_y[row] * dt + bodies.absement_y[row]
            turn += sum_x * fy - sum_y * fx
            if resisted:
                fx = bodies.force_x[row] - fx - bodies.push_x[row] - bodies.field_x[row]
                fy = bodies.force_y[row] - fy - bodies.push_y[row] - bodies.field_y[row]
                books.drag_heat[0] -= fx * x + fy * y
                books.drag_x[0] += fx * dt
                books.drag_y[0] += fy * dt
                books.drag_turn[0] += sum_x * fy - sum_y * fx
            if driven:
                book_push(t, row, x, y, dt)
    books.gravity_work[0] += work
    books.gravity_x[0] += x_sum * dt
    books.gravity_y[0] += y_sum * dt
    books.gravity_turn[0] += turn


def book_push(t: Tables, row: int, x: float, y: float, dt: float) -> None:
    """Book what pushes and fields did to a body on its way (m) in a tick (s)."""
    bodies = t.bodies
    books = t.books
    book_turn_by_push(t, row, dt)
    turn = 0.0
    if bodies.inverse_inertia[row] > 0.0:
        turn = bodies.angle[row] - bodies.start_angle[row]
    fx = bodies.push_x[row]
    fy = bodies.push_y[row]
    torque = bodies.push_torque[row]
    books.push_work[0] += fx * x + fy * y + torque * turn
    books.push_x[0] += fx * dt
    books.push_y[0] += fy * dt
    fx = bodies.field_x[row]
    fy = bodies.field_y[row]
    torque = bodies.torque[row] - torque
    books.field_work[0] += fx * x + fy * y + torque * turn
    books.field_x[0] += fx * dt
    books.field_y[0] += fy * dt


def book_wall(t: Tables, row: int, x: float, y: float, jx: float, jy: float) -> None:
    """Book an impulse (N s) that an immovable body gave at (x, y), and its work if it moves."""
    bodies = t.bodies
    t.books.wall_x[0] += jx
    t.books.wall_y[0] += jy
    t.books.wall_turn[0] += x * jy - y * jx
    vx = bodies.vx[row] - bodies.spin[row] * (y - bodies.here_y[row])
    vy = bodies.vy[row] + bodies.spin[row] * (x - bodies.here_x[row])
    t.books.wall_work[0] += jx * vx + jy * vy


def book_impact(t: Tables, pair: int, x: float, y: float, jx: float, jy: float) -> None:
    """Book the impulse (N s) of an impact, given to b at (x, y), if one of the two is immovable."""
    a = t.pairs.a[pair]
    b = t.pairs.b[pair]
    if t.bodies.inverse_mass[a] == 0.0:
        book_wall(t, a, x, y, jx, jy)
    if t.bodies.inverse_mass[b] == 0.0:
        book_wall(t, b, x, y, -jx, -jy)
    book_lost_in_impact(t, pair, x, y, jx, jy)


def note_part(bodies: Bodies, row: int) -> None:
    """Note where a body is when a part of the tick begins."""
    bodies.from_x[row] = bodies.x[row]
    bodies.from_y[row] = bodies.y[row]
    bodies.from_angle[row] = bodies.angle[row]
    bodies.from_absement_x[row] = bodies.absement_x[row]
    bodies.from_absement_y[row] = bodies.absement_y[row]


def book_part(
    t: Tables, resting: int, count: int, part: float, reached: float, disturbed: bool
) -> None:
    """Book what resting contacts did in a part of the tick.

    Args:
        t: the tables; bodies stand at the end of the part, contacts as they were planned.
        resting: number of pairs that rested when it began.
        count: number of bodies.
        part: its planned length (s).
        reached: after which it ended (s).
        disturbed: whether there were impacts within it.
    """
    bodies = t.bodies
    held = bodies.held
    mean_x = bodies.mean_x
    mean_y = bodies.mean_y
    mean_spin = bodies.mean_spin
    half = reached / 2.0
    calm = True
    particles = False
    for row in range(count):
        if held[row] > 0:
            forget_bend(bodies, row, reached)
            particles = particles or is_particle(bodies, row)
            vx = bodies.vx[row] - bodies.path_x[row] * half
            vy = bodies.vy[row] - bodies.path_y[row] * half
            spin = bodies.spin[row] - bodies.path_spin[row] * half
            mean_x[row] = vx
            mean_y[row] = vy
            mean_spin[row] = spin
            if abs(vx) + abs(vy) + abs(spin) > CALM:
                calm = False
    if disturbed:
        calm = False
    if disturbed and reached > INSTANT:
        measure_means(bodies, count, reached)
    book_contacts(t, resting, reached / part, reached, calm, False)
    if particles:
        book_lost_in_rest(t, resting, reached / part, False)


def measure_means(bodies: Bodies, count: int, reached: float) -> None:
    """Set mean velocities by the ways that bodies went in a part with impacts within it (s)."""
    for row in range(count):
        if bodies.held[row] > 0:
            bodies.mean_x[row] = (bodies.x[row] - bodies.from_x[row]) / reached
            bodies.mean_y[row] = (bodies.y[row] - bodies.from_y[row]) / reached
            bodies.mean_spin[row] = (bodies.angle[row] - bodies.from_angle[row]) / reached


def book_relax(t: Tables, resting: int, count: int) -> None:
    """Book what resting contacts did at once, at the end of a part, to velocities: before and
    after the sweeps are what bodies have and what their kick is.
    """
    if resting == 0:
        book_ease(t, count, 0.0, 0.0, 0.0)
        return
    bodies = t.bodies
    held = bodies.held
    mean_x = bodies.mean_x
    mean_y = bodies.mean_y
    mean_spin = bodies.mean_spin
    calm = True
    particles = False
    for row in range(count):
        if held[row] > 0:
            particles = particles or is_particle(bodies, row)
            vx = (bodies.vx[row] + bodies.kick_x[row]) / 2.0
            vy = (bodies.vy[row] + bodies.kick_y[row]) / 2.0
            spin = (bodies.spin[row] + bodies.kick_spin[row]) / 2.0
            mean_x[row] = vx
            mean_y[row] = vy
            mean_spin[row] = spin
            if abs(vx) + abs(vy) + abs(spin) > CALM:
                calm = False
    work, x, y = book_contacts(t, resting, 1.0, 0.0, calm, True)
    if particles:
        book_lost_in_rest(t, resting, 1.0, True)
    if t.braces.sizes[0] > 0 or t.bones.sizes[0] > 0:
        book_ease(t, count, work, x, y)


def book_ease(t: Tables, count: int, work: float, x: float, y: float) -> None:
    """Book to the joints what changed velocities at the end of a part, less what contacts did (J,
    N s).
    """
    bodies = t.bodies
    total = 0.0
    total_x = 0.0
    total_y = 0.0
    for row in range(count):
        if bodies.held[row] > 0 and bodies.inverse_mass[row] > 0.0:
            dx = bodies.kick_x[row] - bodies.vx[row]
            dy = bodies.kick_y[row] - bodies.vy[row]
            turn = bodies.kick_spin[row] - bodies.spin[row]
            total += work_of(bodies, row, dx, dy, turn)
            total_x += bodies.mass[row] * dx
            total_y += bodies.mass[row] * dy
    t.books.joint_work[0] += total - work
    t.books.joint_x[0] += total_x - x
    t.books.joint_y[0] += total_y - y


def book_contacts(
    t: Tables, resting: int, share: float, lasted: float, calm: bool, relaxing: bool
) -> tuple[float, float, float]:
    """Book a `share` of the impulses of contacts, given at the mean velocities of the bodies in a
    part that lasted so long (s).

    Relaxing, only what they changed by since the part counts, and was given at once. Returns the
    energy (J) and the momentum (N s) that it brought to all bodies together.
    """
    books = t.books
    before_work = books.wall_work[0]
    before_x = books.wall_x[0]
    before_y = books.wall_y[0]
    pairs = t.pairs
    inverse_mass = t.bodies.inverse_mass
    mean_x = t.bodies.mean_x
    mean_y = t.bodies.mean_y
    mean_spin = t.bodies.mean_spin
    normal_arm_a = t.contacts.normal_arm_a
    normal_arm_b = t.contacts.normal_arm_b
    tangent_arm_a = t.contacts.tangent_arm_a
    tangent_arm_b = t.contacts.tangent_arm_b
    normal_impulse = t.contacts.normal_impulse
    tangent_impulse = t.contacts.tangent_impulse
    pressed = 0.0
    rubbed = 0.0
    driven = 0.0
    for k in range(resting):
        pair = pairs.resting[k]
        a = pairs.a[pair]
        b = pairs.b[pair]
        wall = inverse_mass[a] == 0.0 or inverse_mass[b] == 0.0
        if calm and not wall and pairs.belt_speed[pair] == 0.0:
            continue
        nx = pairs.normal_x[pair]
        ny = pairs.normal_y[pair]
        vx = mean_x[b] - mean_x[a]
        vy = mean_y[b] - mean_y[a]
        opening = vx * nx + vy * ny
        belt = pairs.belt_speed[pair]
        sliding = vy * nx - vx * ny + belt
        spin_a = mean_spin[a]
        spin_b = mean_spin[b]
        rolling = 0.0
        if pairs.rolling_torque[pair] != 0.0 or pairs.booked_rolling[pair] != 0.0:
            rolling = pairs.rolling_torque[pair] * pairs.part[pair]
            if relaxing:
                rolling -= pairs.booked_rolling[pair]
            rubbed += rolling * (spin_b - spin_a)
        turn_a = rolling
        turn_b = rolling
        push = 0.0
        rub = 0.0
        points = pairs.points[pair] if relaxing else pairs.acting[pair]
        for row in range(2 * pair, 2 * pair + points):
            normal = normal_impulse[row]
            tangent = tangent_impulse[row]
            if relaxing:
                normal -= t.contacts.booked_normal[row]
                tangent -= t.contacts.booked_tangent[row]
            push += normal
            rub += tangent
            arm_a = normal_arm_a[row]
            arm_b = normal_arm_b[row]
            pressed += normal * (opening + spin_b * arm_b - spin_a * arm_a)
            turn_a += normal * arm_a
            turn_b += normal * arm_b
            if tangent != 0.0:
                arm_a = tangent_arm_a[row]
                arm_b = tangent_arm_b[row]
                rubbed += tangent * (sliding + spin_b * arm_b - spin_a * arm_a)
                turn_a += tangent * arm_a
                turn_b += tangent * arm_b
        driven += rub * belt
        if wall:
            x = (push * nx - rub * ny) * share
            y = (push * ny + rub * nx) * share
            if inverse_mass[a] == 0.0:
                book_held(t, a, x, y, turn_a * share)
                book_turn_by_wall(t, b, x, y, turn_b * share, lasted, relaxing)
            if inverse_mass[b] == 0.0:
                book_held(t, b, -x, -y, -turn_b * share)
                book_turn_by_wall(t, a, -x, -y, -turn_a * share, lasted, relaxing)
    books.contact_heat[0] -= pressed * share
    books.friction_heat[0] -= rubbed * share
    books.wall_work[0] -= driven * share
    work = (pressed + rubbed) * share + books.wall_work[0] - before_work
    return work, books.wall_x[0] - before_x, books.wall_y[0] - before_y


def book_held(t: Tables, row: int, jx: float, jy: float, turn: float) -> None:
    """Book the impulse (N s) that an immovable body gave in a resting contact; work if it moves,
    for which the angular impulse that it gave counts too (N m s, about its centre).
    """
    bodies = t.bodies
    t.books.wall_x[0] += jx
    t.books.wall_y[0] += jy
    work = jx * bodies.mean_x[row] + jy * bodies.mean_y[row]
    t.books.wall_work[0] += work + turn * bodies.mean_spin[row]


def book_turn(t: Tables, row: int, turn: float) -> None:
    """Book an angular impulse (N m s) that corrects a contact's torque, just before it acts; what
    an immovable body that turns gets of it is its own work.
    """
    work = turn * (t.bodies.spin[row] + turn * t.bodies.inverse_inertia[row] / 2.0)
    t.books.contact_heat[0] -= work
    if t.bodies.inverse_mass[row] == 0.0:
        t.books.wall_work[0] -= work
    book_lost(t, row, turn)
