"""The laws that hold in a world, as people give them and as kernels read them."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

from engine import validate
from engine.forces import Drag, LinearDrag, QuadraticDrag
from engine.validate import shown
from engine.vector import Vector

TICK = 1.0 / 60.0
"""Length of a tick unless told otherwise (s)."""

INTEGRATORS = ("semi-implicit-euler", "velocity-verlet", "explicit-euler", "rk4")
SEMI_IMPLICIT_EULER, VELOCITY_VERLET, EXPLICIT_EULER, RK4 = range(4)

MOST_SUBSTEPS = 1000
"""Parts of a tick; who wants shorter ones takes shorter ticks."""

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
    sleep_speed: float = 0.0
    """(m/s)"""
    sleep_time: float = 0.0
    """(s); 0: nothing sleeps."""


@dataclass(frozen=True)
class Sleep:
    """When bodies at rest may fall asleep.

    While a body sleeps it stands. As long as it would have stayed slower than `speed`, which it was
    for `time`, it is thereby wrong by less than `speed` in its velocity and by less than `speed`
    times the time that it slept in where it is.
    """

    speed: float = 0.01
    """No point of a body that may sleep is faster (m/s)."""
    time: float = 0.5
    """For how long it has to be so slow (s)."""

    def __post_init__(self) -> None:
        """Refuse what is no positive number."""
        object.__setattr__(self, "speed", validate.positive(self.speed, "sleep speed"))
        object.__setattr__(self, "time", validate.positive(self.time, "sleep time"))


def laws(
    gravity: Any, drag: Drag | None, integrator: str, substeps: int, sleeping: Sleep | bool = False
) -> Laws:
    """Check what was given to `World` and turn it into numbers.

    Raises:
        TypeError, ValueError: in one sentence that names the value.
    """
    if drag is not None and not isinstance(drag, LinearDrag | QuadraticDrag):
        raise TypeError(f"drag must be LinearDrag, QuadraticDrag or None, not {shown(drag)}")
    if not isinstance(integrator, str) or integrator not in INTEGRATORS:
        known = ", ".join(INTEGRATORS)
        raise ValueError(f"integrator must be one of {known}, not {shown(integrator)}")
    return Laws(
        *validate.vector(gravity, "gravity"),
        drag.k if isinstance(drag, LinearDrag) else 0.0,
        drag.k if isinstance(drag, QuadraticDrag) else 0.0,
        INTEGRATORS.index(integrator),
        validate.whole(substeps, "substeps", 1, MOST_SUBSTEPS),
        *_sleep(sleeping),
    )


def given(laws: Laws) -> dict[str, Any]:
    """What `laws` was given, by its names."""
    linear, quadratic = laws.linear_drag, laws.quadratic_drag
    drag = LinearDrag(linear) if linear else QuadraticDrag(quadratic) if quadratic else None
    return {
        "gravity": Vector(laws.gravity_x, laws.gravity_y),
        "drag": drag,
        "integrator": INTEGRATORS[laws.integrator],
        "substeps": laws.substeps,
        "sleeping": Sleep(laws.sleep_speed, laws.sleep_time) if laws.sleep_time else False,
    }


def _sleep(sleeping: Any) -> tuple[float, float]:
    """Speed and time of `Laws`."""
    if sleeping is False:
        return 0.0, 0.0
    rule = Sleep() if sleeping is True else sleeping
    if not isinstance(rule, Sleep):
        raise TypeError(f"sleeping must be True, False or a Sleep, not {shown(sleeping)}")
    return rule.speed, rule.time


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


def rules(restitution: Rule | None, friction: Rule | None) -> Rules:
    """Check what was given to `World`; None is the plain rule.

    Raises:
        TypeError: for what cannot be called.
    """
    return Rules(
        validate.function_or_none(restitution, "restitution_rule") or larger,
        validate.function_or_none(friction, "friction_rule") or geometric_mean,
    )
