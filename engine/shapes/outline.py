"""The edges of shapes as lines, for those who draw them."""

from engine.shapes.compound import Compound
from engine.shapes.concave import Concave
from engine.shapes.piece import turned
from engine.shapes.polygon import Box, Polygon
from engine.shapes.round import Capsule, Circle, Particle
from engine.shapes.wall import Chain, Wall
from engine.vector import Vector

Outline = tuple[Vector, ...]


def outlines(
    shape: Circle | Particle | Capsule | Polygon | Box | Concave | Compound | Wall | Chain,
) -> tuple[Outline, ...]:
    """One line for each part of a shape, in its own coordinates (m).

    Lines run counter-clockwise and are closed, but for those of walls and open chains; arcs are
    made of chords, 64 to a full circle, with their ends on the arc.
    """
    if isinstance(shape, Compound):
        return tuple(
            tuple(turned(point, at, angle) for point in line)
            for part, at, angle in shape.parts
            for line in outlines(part)
        )
    if isinstance(shape, Chain):
        return ((*shape.points, shape.points[0]) if shape.loop else shape.points,)
    if isinstance(shape, Concave):
        return (shape.vertices,)
    return tuple(piece.outline for piece in shape.pieces)
