"""The table of pairs between two ticks: cut when a body leaves, hashed, mixed by Python rules."""

from typing import Any

import numpy as np

from engine import validate
from engine.settings import Rule
from engine.tables import RESTING, Tables, arrays

RESTING_STATE = (
    "piece_a", "piece_b", "points", "carried", "part", "steady", "drift", "seen_x", "seen_y",
)  # fmt: skip
"""Columns of `Pairs` that tell two worlds apart where pairs rest."""

FAR = 1e9
"""A drift (m) after which the points of any contact are found anew."""


def mix_by_rules(t: Tables, restitution: Rule, friction: Rule) -> None:
    """Give each pair its coefficients by the rules of the world.

    Raises:
        TypeError, ValueError: for what is no coefficient; the list of pairs is then made anew.
    """
    from engine.kernels.rubbing import finish_mixing, static_friction  # see `store`

    bodies, pairs = t.bodies, t.pairs
    stale, t.state.stale[0] = t.state.stale[0], 1
    for pair in range(t.counts.pairs[0]):
        a, b = pairs.a[pair], pairs.b[pair]
        bounce = restitution(bodies.restitution[a], bodies.restitution[b])
        pairs.restitution[pair] = validate.fraction(bounce, "what the restitution rule returns")
        pairs.friction[pair] = rub = _rubbing(friction, bodies.friction[a], bodies.friction[b])
        grip = _rubbing(friction, static_friction(t, a), static_friction(t, b))
        pairs.static_friction[pair] = max(grip, rub)
        finish_mixing(t, pair)
    t.state.stale[0] = stale


def _rubbing(rule: Rule, one: float, other: float) -> float:
    return validate.not_negative(rule(one, other), "what the friction rule returns")


def forget(t: Tables, pair_count: int, row: int) -> int:
    """Drop the pairs of a body that leaves; return how many are left.

    Its row, and the rows of its pieces, still stand.
    """
    last, pieces = t.bodies.first_piece[row] + t.bodies.pieces[row], t.bodies.pieces[row]
    a, b = np.asarray(t.pairs.a)[:pair_count], np.asarray(t.pairs.b)[:pair_count]
    kept = np.flatnonzero((a != row) & (b != row))
    for column in arrays(t.pairs):
        column[: len(kept)] = column[kept]
    for column in arrays(t.contacts):
        column[: 2 * len(kept)] = np.stack((column[2 * kept], column[2 * kept + 1]), 1).ravel()
    for rows in (a[: len(kept)], b[: len(kept)]):
        rows[rows > row] -= 1
    for column in (t.pairs.piece_a, t.pairs.piece_b):
        rows = np.asarray(column)[: len(kept)]
        rows[rows >= last] -= pieces
    return len(kept)


def measure_anew(t: Tables, row: int) -> None:
    """Let the contacts of a body be measured before they act again: its mass changed."""
    for pair in range(t.counts.pairs[0]):
        if row in (t.pairs.a[pair], t.pairs.b[pair]):
            t.pairs.drift[pair] = FAR


def resting_columns(t: Tables, pair_count: int) -> list[Any]:
    """Copies of what the resting pairs remember, for the digest of a world."""
    state = np.asarray(t.pairs.state)[:pair_count]
    at = np.flatnonzero(state == RESTING)
    columns = [np.asarray(getattr(t.pairs, name))[at] for name in RESTING_STATE]
    torques = np.asarray(t.pairs.rolling_torque)[at]
    columns += [torques] if torques.any() else []
    for name in ("normal_impulse", "tangent_impulse", "normal_load", "tangent_load", "gap"):
        column = np.asarray(getattr(t.contacts, name))
        for point in (0, 1):
            used = np.asarray(t.pairs.points)[at] > point
            columns.append(np.where(used, column[2 * at + point], 0.0))
    return columns
