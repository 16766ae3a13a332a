"""The damped spring, exact for any length of a part.

Over a part of length h the extension x of a spring (mass m of its row, stiffness k, damping c) goes
from x0 to x1. It exerts half of its impulse at the start and half at the end, each

    P = -(m/h) (K (x0 + x1) + C (x1 - x0)),

which is the trapezoidal rule for K = k h^2/(4m), C = c h/(2m): stable for any stiffness. Its steps
obey (1 + K + C) x2 - (2 - 2K) x1 + (1 + K - C) x0 = 0. The true motion x ~ exp(-g t) cos(w t + f),
g = c/(2m), w^2 = k/m - g^2, obeys x2 - S x1 + Q x0 = 0 with S = 2 exp(-g h) cos(w h) and
Q = exp(-2 g h). Equating the two gives K and C for which a single oscillator is exact at the ends
of all parts: D = 4/(1 + Q + S), K = D (1 + Q)/2 - 1, C = D (1 - Q)/2.
"""

import math

from engine.kernels.elementary import cos_sin, exponential
from engine.tables import Tables

FASTEST = 2.0
"""Up to so many radians of its oscillation a part a spring is exact, beyond only stable."""


def tune(t: Tables, row: int, joint: int, part: float) -> None:
    """Set the coefficients of a spring's row for a part (s), from its mass."""
    equations = t.equations
    mass = equations.mass[row]
    elastic = 0.0
    viscous = 0.0
    middle = t.joints.low[joint]
    if mass > 0.0:
        square = t.joints.stiffness[joint] / mass
        decay = t.joints.damping[joint] / (2.0 * mass)
        elastic, viscous = coefficients(square, decay, part)
        if elastic > 0.0:  # where a constant force bends it is exact as well
            push = outer_acceleration(t, row)
            middle += push / square - push * part * part / (4.0 * elastic)
    equations.elastic[row] = elastic
    equations.viscous[row] = viscous
    equations.middle[row] = middle
    acts = elastic + viscous > 0.0
    equations.solved[row] = 1 if acts else 0
    equations.soft[row] = 1.0 / ((elastic + viscous) * mass) if acts else 0.0


def coefficients(square: float, decay: float, part: float) -> tuple[float, float]:
    """K and C for a squared circular frequency (1/s^2), a rate of decay (1/s) and a part (s)."""
    if square * part * part > FASTEST * FASTEST:
        return square * part * part / 4.0, decay * part
    shrunk = exponential(-2.0 * decay * part)
    rest = square - decay * decay
    if rest > 0.0:
        swing = 2.0 * exponential(-decay * part) * cos_sin(math.sqrt(rest) * part)[0]
    else:
        fast = decay + math.sqrt(-rest)
        slow = square / fast if fast > 0.0 else 0.0
        swing = exponential(-slow * part) + exponential(-fast * part)
    scale = 4.0 / (1.0 + shrunk + swing)
    elastic = scale * (1.0 + shrunk) / 2.0 - 1.0
    if elastic < 0.0 or square == 0.0:
        elastic = 0.0
    return elastic, scale * (1.0 - shrunk) / 2.0


def outer_acceleration(t: Tables, row: int) -> float:
    """By how much pushes, gravity and drag accelerate the extension (m/s^2)."""
    bodies = t.bodies
    total = 0.0
    for arm in range(2 * row, 2 * row + 2):
        node = t.arms.node[arm]
        if t.nodes.inverse_mass[node] > 0.0:
            body = t.nodes.body[node]
            total += t.arms.x[arm] * bodies.ax[body] + t.arms.y[arm] * bodies.ay[body]
            total += t.arms.turn[arm] * bodies.aspin[body]
    return total


def miss(t: Tables, row: int, part: float) -> float:
    """By how much the extension at the end of the part misses what the impulse makes of it (m)."""
    equations = t.equations
    elastic = equations.elastic[row]
    viscous = equations.viscous[row]
    start = equations.start[row]
    end = equations.value[row]
    push = equations.impulse[row] * part / equations.mass[row]
    push += elastic * (start + end - 2.0 * equations.middle[row]) + viscous * (end - start)
    return push / (elastic + viscous)
