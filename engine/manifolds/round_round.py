"""Circle or particle against circle or particle (thesis, eq. 26-29)."""

import math

from engine.kernels.elementary import cos_sin
from engine.tables import Corners, Pieces, Touch


def round_round(pieces: Pieces, corners: Corners, touch: Touch, a: int, b: int) -> int:
    """Write the point where two placed round bodies are closest; return the number of points."""
    center_a = pieces.first[a]
    center_b = pieces.first[b]
    x = corners.world_x[center_b] - corners.world_x[center_a]
    y = corners.world_y[center_b] - corners.world_y[center_a]
    distance = math.sqrt(x * x + y * y)
    if distance > 0.0:
        normal_x = x / distance
        normal_y = y / distance
    else:  # one on the other: any direction, but not the same for all
        turn = 2.399963229728653 * (pieces.body[a] + pieces.body[b])
        normal_x, normal_y = cos_sin(turn)
    gap = distance - pieces.radius[a] - pieces.radius[b]
    out = pieces.radius[a] + gap / 2.0
    touch.x[0] = corners.world_x[center_a] + out * normal_x
    touch.y[0] = corners.world_y[center_a] + out * normal_y
    touch.gap[0] = gap
    touch.normal_x[0] = normal_x
    touch.normal_y[0] = normal_y
    touch.feature[0] = 0
    return 1


def round_round_gap(pieces: Pieces, corners: Corners, a: int, b: int) -> float:
    """Distance of the surfaces of two placed round bodies (m)."""
    center_a = pieces.first[a]
    center_b = pieces.first[b]
    x = corners.world_x[center_b] - corners.world_x[center_a]
    y = corners.world_y[center_b] - corners.world_y[center_a]
    return math.sqrt(x * x + y * y) - pieces.radius[a] - pieces.radius[b]
