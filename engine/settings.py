"""The laws that hold in a world, as people give them and as kernels read them."""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

from engine import validate
from engine.forces import Drag, LinearDrag, QuadraticDrag
from engine.vector import Vector

TICK = 1.0 / 60.0
"""Length of a tick unless told otherwise (s)."""

INTEGRATORS = ("semi-implicit-euler", "velocity-verlet", "explicit-euler", "rk4")
SEMI_IMPLICIT_EULER, VELOCITY_VERLET, EXPLICIT_EULER, RK4 = range(4)

AS_FRICTION = -1.0
"""A static friction that is that of what slides."""

Rule = Callable[[float, float], float]
"""Makes the coefficient of a pair from those of its two bodies."""


class Laws(NamedTuple):
    """What kernels need to know, in numbers."""

    gravity_x: float
    """(m/s^2)"""
    gravity_y: float
    linear_drag: float
    """(kg/s)"""
    quadratic_drag: float
    """(kg/m)"""
    integrator: int
    """Index in `INTEGRATORS`."""
    substeps: int
    """Into how many parts a tick is divided for bodies that rest on each other."""


def laws(gravity: Any, drag: Drag | None, integrator: str, substeps: int) -> Laws:
    """Check what was given to `World` and turn it into numbers.

    Raises:
        TypeError, ValueError: in one sentence that names the value.
    """
    down = gravity if isinstance(gravity, Vector) else validate.vector(gravity, "gravity")
    if drag is not None and not isinstance(drag, LinearDrag | QuadraticDrag):
        raise TypeError(f"drag must be LinearDrag, QuadraticDrag or None, not {drag!r}")
    if integrator not in INTEGRATORS:
        known = ", ".join(INTEGRATORS)
        raise ValueError(f"integrator must be one of {known}, not {integrator!r}")
    return Laws(
        validate.finite(down[0], "gravity[0]"),
        validate.finite(down[1], "gravity[1]"),
        drag.k if isinstance(drag, LinearDrag) else 0.0,
        drag.k if isinstance(drag, QuadraticDrag) else 0.0,
        INTEGRATORS.index(integrator),
        validate.whole(substeps, "substeps", 1),
    )


def larger(a: float, b: float) -> float:
    """The larger of two restitutions: what bounces off anything bounces off everything."""
    return a if a > b else b


def geometric_mean(a: float, b: float) -> float:
    """Geometric mean of two coefficients of friction: one slippery body makes a slippery pair."""
    return math.sqrt(a * b)


class Rules(NamedTuple):
    """What makes the coefficients of a pair from those of its bodies."""

    restitution: Rule
    friction: Rule


PLAIN_RULES = Rules(larger, geometric_mean)
"""Rules that kernels know; all others are asked in Python."""
