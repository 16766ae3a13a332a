"""Circle or particle against circle or particle (thesis, eq. 26-29)."""

import math

from engine.tables import Bodies, Touch


def round_round(bodies: Bodies, touch: Touch, a: int, b: int) -> int:
    """Write the point where two placed round bodies are closest; return the number of points."""
    x = bodies.here_x[b] - bodies.here_x[a]
    y = bodies.here_y[b] - bodies.here_y[a]
    distance = math.sqrt(x * x + y * y)
    if distance > 0.0:
        normal_x = x / distance
        normal_y = y / distance
    else:  # one on the other: any direction, but not the same for all
        turn = 2.399963229728653 * (a + b)
        normal_x = math.cos(turn)
        normal_y = math.sin(turn)
    gap = distance - bodies.radius[a] - bodies.radius[b]
    out = bodies.radius[a] + gap / 2.0
    touch.x[0] = bodies.here_x[a] + out * normal_x
    touch.y[0] = bodies.here_y[a] + out * normal_y
    touch.gap[0] = gap
    touch.normal_x[0] = normal_x
    touch.normal_y[0] = normal_y
    touch.feature[0] = 0
    return 1


def round_round_gap(bodies: Bodies, a: int, b: int) -> float:
    """Distance of the surfaces of two placed round bodies (m)."""
    x = bodies.here_x[b] - bodies.here_x[a]
    y = bodies.here_y[b] - bodies.here_y[a]
    return math.sqrt(x * x + y * y) - bodies.radius[a] - bodies.radius[b]
