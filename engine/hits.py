"""What questions to a world find; see `queries`."""

from typing import NamedTuple

from engine.body import Body
from engine.vector import Vector


class Hit(NamedTuple):
    """What a ray or a moving shape meets."""

    body: Body
    point: Vector
    """On the surface of the body (m, world); of a ray that starts inside, its start."""
    normal: Vector
    """Unit vector out of the body, at the nearest surface if it starts inside."""
    fraction: float
    """Share of the way from start to end, 0..1; 0 if it starts inside."""


class Nearest(NamedTuple):
    """The body whose surface is nearest to a point."""

    body: Body
    point: Vector
    """On its surface (m, world)."""
    normal: Vector
    """Unit vector out of the body there."""
    distance: float
    """From its surface (m), negative inside."""
