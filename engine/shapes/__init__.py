"""What a body looks like, in its own coordinates (m), with the centre of mass at the origin."""

from engine.shapes.compound import Compound
from engine.shapes.concave import Concave
from engine.shapes.outline import outlines
from engine.shapes.piece import ORIGIN, Piece
from engine.shapes.polygon import Box, Polygon
from engine.shapes.round import Capsule, Circle, Particle
from engine.shapes.wall import Chain, Wall

Barrier = Wall | Chain
"""What never moves, in world coordinates."""

Shape = Circle | Particle | Capsule | Polygon | Box | Concave | Compound | Wall | Chain
"""Any of them."""

__all__ = [
    "ORIGIN",
    "Barrier",
    "Box",
    "Capsule",
    "Chain",
    "Circle",
    "Compound",
    "Concave",
    "Particle",
    "Piece",
    "Polygon",
    "Shape",
    "Wall",
    "outlines",
]
