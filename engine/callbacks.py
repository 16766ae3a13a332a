"""Functions that people attach to bodies, called after a step and never inside it."""

from collections.abc import Iterable

from engine.body import Body
from engine.collision import Collision
from engine.store import Store
from engine.vector import Vector


def poses(store: Store) -> list[tuple[Body, Vector, float]]:
    """Where the bodies are whose moves are listened to."""
    listened_to = [body for body in store.handles if body.on_move is not None]
    return [(body, body.position, body.angle) for body in listened_to]


def call_broken(store: Store) -> None:
    """Call `on_break` of the joints that broke in the last tick, in the order of their ids."""
    for joint in store.take_broken():
        if joint in store.joints and joint.on_break is not None:
            joint.on_break(joint)


def call(
    before: Iterable[tuple[Body, Vector, float]],
    collisions: Iterable[Collision],
    store: Store,
) -> None:
    """Call `on_move` of what moved, then `on_collision` of what collided, in the order they stand.

    Args:
        before: what `poses` returned before the step.
        collisions: what happened in it, in order of time.
        store: of the world; a body that a callback removes is called no more.
    """
    for body, position, angle in before:
        moved = store.holds(body) and (body.position, body.angle) != (position, angle)
        if moved and body.on_move is not None:
            body.on_move(body)
    for collision in collisions:
        for body in (collision.a, collision.b):
            if body.on_collision is not None and store.holds(body):
                body.on_collision(body, collision)
