"""Worlds of our engine that benchmarks and tests share, by the kernels they run on."""

from collections.abc import Callable

from engine import Circle, Particle, Polygon, Wall, World


def room(world: World, size: float, restitution: float, friction: float) -> World:
    corners = [(0.0, 0.0), (size, 0.0), (size, size), (0.0, size)]
    for i in range(4):
        world.add(
            Wall(corners[i], corners[(i + 1) % 4]), restitution=restitution, friction=friction
        )
    return world


def gas(count: int, kernels: str) -> World:
    """Elastic particles without gravity, at the density of a lesson."""
    side = int(count**0.5) + 1
    world = room(World(kernels=kernels), float(side), 1.0, 0.0)
    for i in range(count):
        world.add(
            Particle(0.2),
            position=(0.5 + i % side, 0.5 + i // side),
            velocity=((i * 7919 % 13 - 6) / 4, (i * 104729 % 11 - 5) / 4),
            restitution=1.0,
        )
    return world


def pile(kernels: str) -> World:
    """Twelve mixed bodies that have settled between four walls."""
    world = room(World(gravity=(0, -9.81), kernels=kernels), 4.0, 0.2, 0.5)
    for i in range(12):
        world.add(
            Polygon.box(0.8, 0.6) if i % 2 else Circle(0.35),
            position=(0.7 + (i % 4) * 0.85, 0.5 + (i // 4)),
            angle=0.1 * i,
            restitution=0.2,
            friction=0.5,
        )
    for _ in range(240):
        world.step()
    return world


def pyramid(base: int, kernels: str, apart: float = 0.0) -> World:
    """Boxes on boxes, at rest, or `apart` by so much (m), so that they fall on each other."""
    world = World(gravity=(0, -9.81), kernels=kernels)
    world.add(Wall((-50, 0), (50, 0)), friction=0.6)
    for row in range(base):
        for i in range(base - row):
            x = (i - (base - row) / 2) * 1.05
            y = row + 0.5 + apart * (row + 1)
            world.add(Polygon.box(1, 1), position=(x, y), friction=0.6)
    return world


SCENES: dict[str, Callable[[str], World]] = {
    "free flight, 12": lambda kernels: gas(12, kernels),
    "gas, 100": lambda kernels: gas(100, kernels),
    "pile, 12": pile,
    "pyramid, base 10": lambda kernels: pyramid(10, kernels),
    "pyramid, base 10, landed": lambda kernels: pyramid(10, kernels, 1e-3),
}
"""What makes each, on the kernels that are asked for."""
