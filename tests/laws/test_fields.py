"""Central forces: Kepler's laws, the harmonic oscillator, and the order of each integrator."""

import math

import pytest

from engine import Body, Circle, PointGravity, SpringTo, Wall, World

DT = 1 / 60
SECOND_ORDER = ("semi-implicit-euler", "velocity-verlet", "rk4")


def run(world: World, ticks: int) -> None:
    for _ in range(ticks):
        world.step(DT)


def energy(world: World) -> float:
    return world.kinetic_energy + world.potential_energy


def orbit(integrator: str, r: float, speed: float, mu: float) -> tuple[World, Body]:
    world = World(integrator=integrator)
    world.add_law(PointGravity((1.0, 2.0), mu))
    return world, world.add(Circle(0.1), mass=3.0, position=(1.0 + r, 2.0), velocity=(0.0, speed))


@pytest.mark.parametrize(("integrator", "phase"), [("velocity-verlet", 2e-3), ("rk4", 1e-6)])
def test_a_circular_orbit_has_keplers_period(integrator: str, phase: float) -> None:
    """T = 2 pi sqrt(r^3 / mu): here 240 ticks."""
    r, mu = 2.0, 2.0 * math.pi**2
    world, body = orbit(integrator, r, math.sqrt(mu / r), mu)
    run(world, 240)
    assert math.atan2(body.y - 2.0, body.x - 1.0) == pytest.approx(0.0, abs=phase)
    assert math.dist(body.position, (1.0, 2.0)) == pytest.approx(r, rel=2e-4)
    assert body.force.x == pytest.approx(-3.0 * mu / r**2, rel=1e-3)


def test_the_energy_of_an_orbit_does_not_drift() -> None:
    """Velocity Verlet is symplectic: after 100 ellipses (e = 0.3) the energy is still the same."""
    mu, r = 80.0, 1.5
    axis = r / 0.7
    world, body = orbit("velocity-verlet", r, math.sqrt(mu * (2 / r - 1 / axis)), mu)
    start, momentum = energy(world), r * body.vy
    ticks = round(100 * 2 * math.pi * math.sqrt(axis**3 / mu) / DT)
    first = latest = 0.0
    for tick in range(ticks):
        world.step(DT)
        error = abs(energy(world) / start - 1.0)
        if tick < ticks / 100:
            first = max(first, error)
        elif tick > 0.99 * ticks:
            latest = max(latest, error)
    assert first < 5e-3
    assert latest < 1.05 * first
    swept = (body.x - 1.0) * body.vy - (body.y - 2.0) * body.vx
    assert swept == pytest.approx(momentum, rel=1e-9)  # Kepler's second law


def test_vis_viva_along_an_ellipse() -> None:
    """v^2 = mu (2/r - 1/a) everywhere; the far point lies at 2a - r."""
    mu, r = 10.0, 1.0
    axis = 1.6
    world, body = orbit("rk4", r, math.sqrt(mu * (2 / r - 1 / axis)), mu)
    farthest = 0.0
    for _ in range(round(2 * math.pi * math.sqrt(axis**3 / mu) / DT)):
        world.step(DT)
        distance = math.dist(body.position, (1.0, 2.0))
        farthest = max(farthest, distance)
        assert body.speed**2 == pytest.approx(mu * (2 / distance - 1 / axis), rel=1e-4)
    assert farthest == pytest.approx(2 * axis - r, rel=1e-3)


def test_softened_gravity_has_no_pole() -> None:
    """Through the middle and out again: E = v^2/2 - mu / sqrt(r^2 + eps^2) (Plummer)."""
    world = World(integrator="velocity-verlet")
    world.add_law(PointGravity((0, 0), 5.0, softening=0.5))
    world.add(Circle(0.1), position=(-2.0, 0.0))
    start = energy(world)
    assert start == pytest.approx(-5.0 / math.sqrt(4.25), rel=1e-12)
    run(world, 200)
    assert energy(world) == pytest.approx(start, rel=1e-2)
    at_the_pole = World()
    at_the_pole.add_law(PointGravity((0, 0), 5.0))
    still = at_the_pole.add(Circle(0.1))
    at_the_pole.step()
    assert still.position == (0.0, 0.0)


@pytest.mark.parametrize("integrator", SECOND_ORDER)
@pytest.mark.parametrize("amplitude", [0.1, 10.0])
def test_a_spring_to_a_point_swings_with_its_period(integrator: str, amplitude: float) -> None:
    """T = 2 pi sqrt(m/k), whatever the amplitude: 60 ticks, up to the order of the integrator."""
    mass = 2.0
    world = World(integrator=integrator)
    world.add_law(SpringTo((0, 0), mass * (2 * math.pi) ** 2))
    body = world.add(Circle(0.1), mass=mass, position=(amplitude, 0.0))
    run(world, 60)
    tolerance = 3e-3 if integrator != "rk4" else 2e-5
    if integrator == "semi-implicit-euler":
        tolerance = 0.06  # its positions belong to half a tick later
    assert body.x == pytest.approx(amplitude, rel=tolerance)


def test_the_ellipse_of_an_isotropic_oscillator_closes() -> None:
    """Verlet's own period of a harmonic oscillator: cos(w' dt) = 1 - (w dt)^2 / 2."""
    world = World(integrator="velocity-verlet")
    omega = math.sqrt(2.0 * (1.0 - math.cos(2.0 * math.pi / 90))) / DT
    world.add_law(SpringTo((0, 0), omega**2))
    body = world.add(Circle(0.1), position=(2.0, 0.0), velocity=(0.0, 3.0))
    run(world, 9000)
    assert body.x == pytest.approx(2.0, rel=1e-9)
    assert body.y == pytest.approx(0.0, abs=1e-9)


def test_a_damped_spring_loses_its_swing_by_the_logarithmic_decrement() -> None:
    """Successive maxima shrink by exp(-c T' / 2m), T' = 2 pi / sqrt(k/m - (c/2m)^2)."""
    mass, stiffness, damping = 2.0, 80.0, 1.5
    world = World(integrator="rk4")
    world.add_law(SpringTo((0, 0), stiffness, damping))
    body = world.add(Circle(0.1), mass=mass, position=(1.0, 0.0))
    rate = damping / (2 * mass)
    omega = math.sqrt(stiffness / mass - rate * rate)
    for tick in range(1, 240):
        world.step(DT)
        time = tick * DT
        wave = math.cos(omega * time) + rate / omega * math.sin(omega * time)
        assert body.x == pytest.approx(math.exp(-rate * time) * wave, abs=1e-5)


@pytest.mark.parametrize(
    ("integrator", "order"),
    [("semi-implicit-euler", 1), ("explicit-euler", 1), ("velocity-verlet", 2), ("rk4", 4)],
)
def test_the_order_of_each_integrator(integrator: str, order: int) -> None:
    """Half the tick, 2^-order of the error, with a built-in law."""
    errors = []
    for ticks in (60, 120):
        world = World(integrator=integrator)
        world.add_law(SpringTo((0, 0), 4.0))
        body = world.add(Circle(0.1), position=(1.0, 0.0))
        for _ in range(ticks):
            world.step(1.0 / ticks)
        errors.append(abs(body.x - math.cos(2.0)))
    assert math.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.1)


@pytest.mark.parametrize(
    ("integrator", "order"),
    [("semi-implicit-euler", 1), ("explicit-euler", 1), ("velocity-verlet", 2), ("rk4", 2)],
)
def test_the_order_of_each_integrator_with_a_python_function(integrator: str, order: int) -> None:
    errors = []
    for ticks in (60, 120):
        world = World(integrator=integrator)
        world.add_law(lambda body, time: (-4.0 * body.x, 0.0))
        body = world.add(Circle(0.1), position=(1.0, 0.0))
        for _ in range(ticks):
            world.step(1.0 / ticks)
        errors.append(abs(body.x - math.cos(2.0)))
    assert math.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.1)


def test_a_force_that_grows_with_time() -> None:
    """F = c t: v = c t^2 / 2m exactly, x = c t^3 / 6m up to the second order; torques alike."""
    world = World(integrator="velocity-verlet")
    body = world.add(Circle(1.0), mass=2.0)
    world.add_law(lambda body, time: (6.0 * time, 0.0, 4.0 * time), [body])
    run(world, 120)
    assert body.vx == pytest.approx(6.0 * 4.0 / 4.0, rel=1e-12)
    assert body.x == pytest.approx(6.0 * 8.0 / 12.0, rel=1e-4)
    assert body.spin == pytest.approx(4.0 * 4.0 / (2.0 * body.inertia), rel=1e-12)
    assert body.force.x == pytest.approx(6.0 * (2.0 - DT / 2.0), rel=1e-12)
    assert body.torque == pytest.approx(4.0 * (2.0 - DT / 2.0), rel=1e-12)


def test_gravity_scale_multiplies_gravity_alone() -> None:
    world = World(gravity=(0.0, -10.0), integrator="velocity-verlet")
    plain = world.add(Circle(0.1))
    moon = world.add(Circle(0.1), position=(5, 0), gravity_scale=0.165)
    balloon = world.add(Circle(0.1), mass=4.0, position=(9, 0), gravity_scale=-1.0)
    run(world, 60)
    assert plain.vy == pytest.approx(-10.0, rel=1e-12)
    assert moon.vy == pytest.approx(-1.65, rel=1e-12)
    assert balloon.y == pytest.approx(5.0, rel=1e-12)
    assert balloon.force == (0.0, 40.0)
    balloon.gravity_scale = 0.0
    run(world, 60)
    assert balloon.y == pytest.approx(15.0, rel=1e-12)
    assert world.potential_energy == pytest.approx(10.0 * plain.y + 1.65 * moon.y, rel=1e-12)


def test_a_body_that_bounces_in_a_field_keeps_its_energy() -> None:
    """Impacts happen at their own instants, with the mean force of the tick: no drift."""
    world = World(integrator="velocity-verlet")
    world.add(Wall((-5, -0.5), (5, -0.5)), restitution=1.0)
    world.add_law(SpringTo((0, 0), 4.0))
    body = world.add(Circle(0.25), position=(0.0, 2.0))
    start = energy(world)
    run(world, 1200)
    assert energy(world) == pytest.approx(start, rel=0.02)
    assert body.x == 0.0
