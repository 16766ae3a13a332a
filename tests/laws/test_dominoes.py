"""Rows of dominoes.

The wave soon runs at a speed of its own, whatever set it off (Stronge, "The domino effect", Proc.
R. Soc. A 409, 1987; Banks, "Towing Icebergs, Falling Dominoes", 1998); each falls on the next if
that stands nearer than it is high.
"""

import pytest

from engine import Box, Force, Wall, World

G = 9.81
HEIGHT = 1.0
THICK = 0.15


def topple(push: float, gap: float, count: int, seconds: float) -> tuple[list[float], float]:
    """Push the top of the first of so many dominoes (N, for half a second); return when each
    leans by 0.1 rad (s), and by how much the energy rose in a tick at most, after the push (J).
    """
    world = World(gravity=(0, -G), integrator="velocity-verlet")
    world.add(Wall((-5, 0), (60, 0)), friction=0.4)
    row = [
        world.add(
            Box(THICK, HEIGHT), position=(i * (gap + THICK), HEIGHT / 2), mass=1.0, friction=0.4
        )
        for i in range(count)
    ]
    row[0].exert(Force(push, 0), duration=0.5, at=(0, HEIGHT))
    world.run(30)
    fallen: dict[int, float] = {}
    rise = 0.0
    energy = world.kinetic_energy + world.potential_energy
    while world.time < seconds:
        world.step()
        before, energy = energy, world.kinetic_energy + world.potential_energy
        rise = max(rise, energy - before)
        for i, domino in enumerate(row):
            if i not in fallen and abs(domino.angle) > 0.1:
                fallen[i] = world.time - (abs(domino.angle) - 0.1) / abs(domino.spin)
    return [fallen[i] for i in sorted(fallen)], rise


def test_the_wave_runs_at_a_speed_of_its_own() -> None:
    """Pushed thrice as hard, the row falls as fast from the ninth on; no energy is gained."""
    speeds = []
    for push in (1.2, 4.0):
        times, rise = topple(push, 0.3, 14, 3.2)
        assert len(times) == 14
        assert rise < 1e-4 * 14 * G * HEIGHT / 2
        speeds.append(5 * (0.3 + THICK) / (times[13] - times[8]))
    assert speeds[0] == pytest.approx(speeds[1], rel=5e-3)


@pytest.mark.parametrize(("gap", "falls"), [(0.9, True), (1.1, False)])
def test_dominoes_fall_if_they_stand_nearer_than_they_are_high(gap: float, falls: bool) -> None:
    times, _ = topple(1.5, gap, 6, 3.5)
    assert len(times) == (6 if falls else 1)
