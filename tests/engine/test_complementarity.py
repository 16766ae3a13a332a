"""Impulses within bounds, beside what defines them (Karush, Kuhn and Tucker)."""

import itertools
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.kernels.complementarity import SINGULAR, solve_bounded
from engine.tables import MOST_HITS, Tables, new_tables

Numbers = np.ndarray[Any, np.dtype[np.float64]]

ENOUGH = 1e-13


def solve(
    coupling: Numbers, wanted: Numbers, least: Numbers, most: Numbers, passes: int = 300
) -> Numbers:
    t: Tables = new_tables()
    rows = len(wanted)
    np.asarray(t.delassus.coupling)[: rows * rows] = coupling.ravel()
    for name, values in (("wanted", wanted), ("least", least), ("most", most)):
        np.asarray(getattr(t.unknowns, name))[:rows] = values
    changes = solve_bounded(t, rows, ENOUGH * np.abs(wanted).max(), passes)
    assert changes <= ENOUGH * np.abs(wanted).max()
    return np.asarray(t.unknowns.value)[:rows].copy()


def problem(rows: int, bodies: int, seed: int) -> tuple[Numbers, Numbers]:
    """J M^-1 J^T of `rows` points between `bodies` of 1 to 100 kg, each of three freedoms."""
    dice = np.random.default_rng(seed)
    jacobian = np.zeros((rows, 3 * bodies))
    for row in range(rows):
        for body in dice.choice(bodies, 2, replace=False):
            jacobian[row, 3 * body : 3 * body + 3] = dice.normal(size=3)
    inverse = np.repeat(10.0 ** -dice.uniform(0, 2, bodies), 3)
    return (jacobian * inverse) @ jacobian.T, jacobian @ dice.normal(size=3 * bodies)


@given(st.integers(1, 40), st.integers(14, 30), st.integers(0, 10**6))
def test_impulses_push_or_do_nothing(rows: int, bodies: int, seed: int) -> None:
    """x >= 0, A x - b >= 0, and x (A x - b) = 0."""
    coupling, wanted = problem(rows, bodies, seed)
    x = solve(coupling, wanted, np.zeros(rows), np.full(rows, 1e300))
    exceeds = coupling @ x - wanted
    fine = 1e-9 * np.abs(wanted).max()
    assert (x >= 0.0).all()
    assert (exceeds >= -fine).all()
    assert np.abs(exceeds[x > 0.0]).max(initial=0.0) <= fine


@given(st.integers(1, 40), st.integers(14, 30), st.integers(0, 10**6))
def test_impulses_stay_within_bounds(rows: int, bodies: int, seed: int) -> None:
    """-m <= x <= m; where x is at a bound, what it still lacks would drive it beyond."""
    coupling, wanted = problem(rows, bodies, seed)
    most = np.random.default_rng(seed).uniform(0, 2, rows)
    x = solve(coupling, wanted, -most, most)
    lacks = wanted - coupling @ x
    fine = 1e-9 * np.abs(wanted).max()
    assert (np.abs(x) <= most).all()
    assert (lacks[x < most] <= fine).all()
    assert (lacks[x > -most] >= -fine).all()


@pytest.mark.parametrize("ratio", [1.0, 90.0, 1e4])
@pytest.mark.parametrize("cars", [3, 20, 100])
def test_long_trains_take_few_passes(cars: int, ratio: float) -> None:
    """Cars of 1 and of `ratio` kg by turns, of which the first comes at 1 m/s and all others stand:
    v = m1/(m1 + m2 + ...). Passes alone would need some cars^2, or ratio, of them.
    """
    masses = [1.0, ratio] * (cars // 2) + [1.0] * (cars % 2)
    rows = cars - 1
    coupling = np.zeros((rows, rows))
    for i, j in itertools.product(range(rows), repeat=2):
        if i == j:
            coupling[i, j] = 1 / masses[i] + 1 / masses[i + 1]
        elif abs(i - j) == 1:
            coupling[i, j] = -1 / masses[max(i, j)]
    wanted = np.zeros(rows)
    wanted[0] = 1.0
    x = solve(coupling, wanted, np.zeros(rows), np.full(rows, 1e300), passes=5 * rows)
    assert x[-1] / masses[-1] == pytest.approx(1 / sum(masses), rel=1e-9)


def test_points_that_follow_from_others_change_nothing_more() -> None:
    """Four feet of one table: only two of them are needed, and the numbers of all are singular."""
    arms = np.array([-2.0, -1.0, 1.0, 2.0])
    coupling = 1.0 + np.outer(arms, arms)
    x = solve(coupling, np.ones(4), np.zeros(4), np.full(4, 1e300))
    assert np.linalg.matrix_rank(coupling, tol=SINGULAR) == 2
    assert coupling @ x == pytest.approx(np.ones(4), rel=1e-12)


def test_there_is_room_for_all_points() -> None:
    t = new_tables()
    assert len(t.delassus.factor) >= MOST_HITS * (MOST_HITS + 1)
