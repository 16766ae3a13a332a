"""Disc against polygon, capsule or wall: the closest side or corner (Voronoi regions)."""

import math

from engine.tables import Corners, Pieces, Touch


def closest(pieces: Pieces, corners: Corners, disc: int, hull: int) -> tuple[float, float, float]:
    """Distance of a placed disc's centre from a placed hull (m), negative inside, and the unit
    normal from the hull to the centre.
    """
    first = pieces.first[hull]
    count = pieces.corners[hull]
    x = corners.world_x[pieces.first[disc]]
    y = corners.world_y[pieces.first[disc]]
    side = first
    height = -1e300
    for i in range(first, first + count):
        above = corners.world_normal_x[i] * (x - corners.world_x[i]) + corners.world_normal_y[i] * (
            y - corners.world_y[i]
        )
        if above > height:
            height = above
            side = i
    normal_x = corners.world_normal_x[side]
    normal_y = corners.world_normal_y[side]
    if height < 0.0:
        return height, normal_x, normal_y
    following = side + 1 if side + 1 < first + count else first
    from_x = x - corners.world_x[side]
    from_y = y - corners.world_y[side]
    along = from_y * normal_x - from_x * normal_y
    if along < 0.0:
        return from_corner(from_x, from_y, normal_x, normal_y)
    to_x = x - corners.world_x[following]
    to_y = y - corners.world_y[following]
    if to_y * normal_x - to_x * normal_y > 0.0:
        return from_corner(to_x, to_y, normal_x, normal_y)
    return height, normal_x, normal_y


def from_corner(x: float, y: float, normal_x: float, normal_y: float) -> tuple[float, float, float]:
    """Length and direction of (x, y); the given normal if there is none."""
    distance = math.sqrt(x * x + y * y)
    if distance > 0.0:
        return distance, x / distance, y / distance
    return 0.0, normal_x, normal_y


def round_hull(
    pieces: Pieces, corners: Corners, touch: Touch, disc: int, hull: int, disc_is_a: bool
) -> int:
    """Write the point where a placed disc and a placed hull are closest; return 1."""
    distance, normal_x, normal_y = closest(pieces, corners, disc, hull)
    gap = distance - pieces.radius[disc] - pieces.radius[hull]
    out = pieces.radius[disc] + gap / 2.0
    center = pieces.first[disc]
    touch.x[0] = corners.world_x[center] - out * normal_x
    touch.y[0] = corners.world_y[center] - out * normal_y
    touch.gap[0] = gap
    touch.feature[0] = 0
    if disc_is_a:
        touch.normal_x[0] = -normal_x
        touch.normal_y[0] = -normal_y
    else:
        touch.normal_x[0] = normal_x
        touch.normal_y[0] = normal_y
    return 1
