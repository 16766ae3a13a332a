"""What `World.contacts` reports; see `touching`."""

from typing import NamedTuple

from engine.body import Body
from engine.vector import Vector


class Contact(NamedTuple):
    """Two bodies that touched in the last tick, or did in the tick before and no longer do.

    They touch in a tick if an impact or a resting contact acts on them in it; a sensor and a body,
    if they overlap when it is over, or came and went within it.
    """

    a: Body
    b: Body
    """The one that was added later."""
    phase: str
    """It is "begin", "stay" or "end"; a single bounce begins, and ends in the tick after."""
    points: tuple[Vector, ...]
    """Where they rest on each other, or the last impact was (m, world); none of a sensor, none at
    the end."""
    normal: Vector
    """Unit vector from a to b at the first of the points; zero if there are none."""
    impulse: Vector
    """What b received in the tick (N s), impacts and resting contact together; a received its
    exact opposite. Those of bodies that sleep are not computed."""
    sensor: bool
    """Whether one of the two is a sensor."""
