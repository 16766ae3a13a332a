"""A standalone 2D rigid-body engine: SI units, float64, +y up, angles counter-clockwise.

    >>> from engine import Circle, Wall, World
    >>> world = World(gravity=(0, -9.81))
    >>> floor = world.add(Wall((-5, 0), (5, 0)))
    >>> ball = world.add(Circle(0.2), mass=0.5, position=(0, 1.2), restitution=0.8)
    >>> tracks = world.run(60)

`World` has all that a room can do; its `add` and `join` return handles, `Body` and `Joint`. The
guide is docs/engine.md.
"""

from engine.body import Body
from engine.collision import Collision, Collisions, Diverged, Removed
from engine.contact import Contact
from engine.force_laws import ActingLaw, PointGravity, SpringTo
from engine.forces import Force, LinearDrag, Push, QuadraticDrag, Torque
from engine.hits import Hit, Nearest
from engine.joint import Joint
from engine.joints import Distance, Pin, Pulley, Rope, Slider, Spring, Weld
from engine.ledger import Ledger
from engine.recording import Recording
from engine.replay import Divergence, replay
from engine.settings import TICK, Sleep
from engine.shapes import (
    Box,
    Capsule,
    Chain,
    Circle,
    Compound,
    Concave,
    Particle,
    Polygon,
    Shape,
    Wall,
)
from engine.snapshot import Snapshot
from engine.tracks import Tracks
from engine.vector import Vector
from engine.world import World

__all__ = [
    "TICK",
    "ActingLaw",
    "Body",
    "Box",
    "Capsule",
    "Chain",
    "Circle",
    "Collision",
    "Collisions",
    "Compound",
    "Concave",
    "Contact",
    "Distance",
    "Diverged",
    "Divergence",
    "Force",
    "Hit",
    "Joint",
    "Ledger",
    "LinearDrag",
    "Nearest",
    "Particle",
    "Pin",
    "PointGravity",
    "Polygon",
    "Pulley",
    "Push",
    "QuadraticDrag",
    "Recording",
    "Removed",
    "Rope",
    "Shape",
    "Sleep",
    "Slider",
    "Snapshot",
    "Spring",
    "SpringTo",
    "Torque",
    "Tracks",
    "Vector",
    "Wall",
    "Weld",
    "World",
    "replay",
]


def __dir__() -> list[str]:
    """The public names; modules are there for those who look for them."""
    return __all__
