"""Drag stops, however strong it is: v' = -(k/m) v, or -(k/m) |v| v, never turns a body back.

Drag that would stop a body within half a tick made every integrator swing up: a ball of 1 kg in a
drag of 200 kg/s had 1e30 m/s within a second.
"""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine import Circle, LinearDrag, QuadraticDrag, World
from engine.settings import INTEGRATORS

G = 9.81

rates = st.floats(-2.0, 8.0).map(lambda power: 10.0**power)


@settings(max_examples=80, deadline=None)
@given(integrator=st.sampled_from(INTEGRATORS), rate=rates, linear=st.booleans())
def test_drag_alone_slows_and_never_turns_back(integrator: str, rate: float, linear: bool) -> None:
    """Kinetic energy can only become less; what it lost is booked as heat of drag."""
    drag = LinearDrag(rate) if linear else QuadraticDrag(rate)
    world = World(drag=drag, integrator=integrator)
    body = world.add(Circle(0.5), mass=2.0, velocity=(3.0, 4.0))
    for _ in range(60):
        before = body.velocity
        world.step()
        for now, then in zip(body.velocity, before, strict=True):
            assert -1e-12 <= now <= then
    books = world.ledger()
    lost = 25.0 - body.mass * body.speed * body.speed / 2
    assert books.dissipated.drag - books.work.integrator == pytest.approx(lost, rel=1e-9, abs=1e-9)


@settings(max_examples=60, deadline=None)
@given(integrator=st.sampled_from(INTEGRATORS), rate=rates.filter(lambda rate: rate > 5.0))
def test_what_falls_reaches_its_terminal_speed(integrator: str, rate: float) -> None:
    """m g / k: there the drag at the start of a tick is that at its end."""
    world = World(gravity=(0.0, -G), drag=LinearDrag(rate), integrator=integrator)
    body = world.add(Circle(0.5), mass=1.0)
    world.run(600)
    assert body.speed == pytest.approx(G / rate, rel=1e-6)


@pytest.mark.parametrize("integrator", INTEGRATORS)
def test_a_fast_body_in_strong_quadratic_drag_falls_at_its_terminal_speed(integrator: str) -> None:
    """The root of m g / k, from 1000 m/s."""
    world = World(gravity=(0.0, -G), drag=QuadraticDrag(2.0), integrator=integrator)
    body = world.add(Circle(0.5), mass=1.0, velocity=(1000.0, 0.0))
    world.run(600)
    assert body.speed == pytest.approx(math.sqrt(G / 2.0), rel=1e-6)
