"""What the lessons have in common about bodies: the walls around them, and how solid they look."""

import math

from engine import Body, Circle, Particle, Polygon, Wall, World
from screens.kit import theme
from screens.kit.canvas import Canvas
from screens.kit.view import Room

SIDES = ("left", "top", "right", "bottom")


def enclose(world: World, room: Room, friction: float = 0.0) -> None:
    """Put four walls around a room, their positive sides inwards: `wall.left`, ...

    They have no restitution of their own, so that of the body counts (the larger of a pair).
    """
    corners = (
        (room.left, room.bottom),
        (room.left, room.top),
        (room.right, room.top),
        (room.right, room.bottom),
    )
    for i, side in enumerate(SIDES):
        wall = Wall(corners[(i + 1) % 4], corners[i])
        world.add(wall, friction=friction, name=f"wall.{side}")


def opacity(mass: float, light: float, heavy: float) -> float:
    """How solid a body looks: 0.3 for the lightest to 0.95 for the heaviest, even per doubling."""
    part = math.log(mass / light) / math.log(heavy / light)
    return 0.3 + 0.65 * min(max(part, 0.0), 1.0)


def conceal(canvas: Canvas, body: Body) -> None:
    """Hide what is drawn already where a body will be, so that nothing shows through a pale one."""
    view, shape = canvas.view, body.shape
    with canvas.surface.clip(canvas.rect):
        if isinstance(shape, Polygon):
            corners = [view.to_screen(corner) for corner in body.vertices]
            canvas.surface.polygon(corners, theme.CANVAS)
        elif isinstance(shape, Circle | Particle):
            center, radius = view.to_screen(body.position), shape.radius * view.scale
            canvas.surface.circle(center, radius, theme.CANVAS)
