"""What the lessons have in common about bodies: their world, the walls around it, how solid bodies
look.
"""

import math
from functools import lru_cache

from engine import Body, Vector, Wall, World
from screens.kit.canvas import Canvas
from screens.kit.view import Room

HEAD_ROOM = 3.0
"""What stays free between the head of an arrow and the border of the canvas (dp)."""
SHORTEST = 0.3
"""Arrows that would leave the canvas are shortened to this part of themselves at most."""
BESIDE = 7.0
"""How far beside a body an arrow is drawn that has no room before it (dp)."""
SIDES = ("left", "top", "right", "bottom")


def new_world() -> World:
    """A world as lessons have it.

    It moves a dozen bodies, so it stays interpreted: to change to machine code in the middle of a
    long film would take 126 MB, for numba.
    """
    return World(integrator="velocity-verlet", kernels="interpreted")


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


@lru_cache(maxsize=64)
def opacity(mass: float, light: float, heavy: float) -> float:
    """How solid a body looks: 0.3 for the lightest to 0.95 for the heaviest, even per doubling."""
    part = math.log(mass / light) / math.log(heavy / light)
    return 0.3 + 0.65 * min(max(part, 0.0), 1.0)


def fitting(canvas: Canvas, at: tuple[float, float], reach: tuple[float, float]) -> float:
    """How much of an arrow may be drawn for its head to stay in the canvas, at most 1.

    `at` is where it starts (m), `reach` how far it goes (dp, +y up).
    """
    start, within = canvas.view.to_screen(at), canvas.rect.inset(HEAD_ROOM)
    part = 1.0
    for here, way, low, high in (
        (start.x, reach[0], within.x, within.right),
        (start.y, -reach[1], within.y, within.bottom),
    ):
        if way != 0.0:
            part = min(part, ((high if way > 0.0 else low) - here) / way)
    return part


def leaving(
    canvas: Canvas, body: Body, reach: tuple[float, float], radius: float, aside: float = 0.0
) -> tuple[Vector, float]:
    """Where an arrow that leaves a body starts (m), and how much of its `reach` (dp) is drawn.

    It starts on the outline, moved to its left by `aside` (dp); if there is no room before the
    body of this `radius` (m), all of it is drawn beside.
    """
    (dx, dy), scale = reach, canvas.view.scale
    length, edge = math.sqrt(dx * dx + dy * dy), canvas.edge(body, reach)
    part = fitting(canvas, edge, reach)
    if part < SHORTEST:
        return beside(canvas, body.position, reach, radius + aside / scale), 1.0
    by = aside / scale / length
    return Vector(edge[0] - dy * by, edge[1] + dx * by), part


def beside(canvas: Canvas, center: Vector, reach: tuple[float, float], radius: float) -> Vector:
    """Where an arrow starts (m) that lies beside a body of some radius (m), all of it in sight.

    Of both sides of the body the one that is nearer to the middle of the room; its head is level
    with the front of the body if there is room for its tail.
    """
    scale, (dx, dy) = canvas.view.scale, reach
    length = math.sqrt(dx * dx + dy * dy)
    away = radius + BESIDE / scale
    x, y = -dy / length * away, dx / length * away
    if x * center.x + y * center.y > 0.0:
        x, y = -x, -y
    middle = (center.x + x, center.y + y)
    front = radius * scale / length
    ahead = front * fitting(canvas, middle, (front * dx, front * dy))
    head = (middle[0] + ahead * dx / scale, middle[1] + ahead * dy / scale)
    back = fitting(canvas, head, (-dx, -dy))
    return Vector(head[0] - back * dx / scale, head[1] - back * dy / scale)


def distance(at: Vector, start: Vector, end: Vector) -> float:
    """From a point to a line segment (m)."""
    along = Vector(end.x - start.x, end.y - start.y)
    square = along.x * along.x + along.y * along.y
    part = (at.x - start.x) * along.x + (at.y - start.y) * along.y
    part = min(max(part / square, 0.0), 1.0) if square > 0.0 else 0.0
    return math.dist(at, (start.x + part * along.x, start.y + part * along.y))
