"""Numbers of the world that a scenario may ask for, in SI units, by name."""

from engine import Body, World

WORLD = (
    "time",
    "collisions",
    "momentum.x",
    "momentum.y",
    "angular_momentum",
    "kinetic_energy",
)
"""Probes of every lesson."""

BODY = (
    "x",
    "y",
    "vx",
    "vy",
    "speed",
    "angle",
    "spin",
    "mass",
    "momentum",
    "kinetic_energy",
    "restitution",
    "friction",
)
"""What can be asked of every body."""


def names(prefix: str) -> tuple[str, ...]:
    """The probes of a body."""
    return tuple(f"{prefix}.{quantity}" for quantity in BODY)


def of_world(world: World, collisions: int) -> dict[str, float]:
    """Time (s), collisions, momentum (kg m/s), angular momentum (kg m^2/s), energy (J)."""
    momentum = world.momentum
    return {
        "time": world.time,
        "collisions": float(collisions),
        "momentum.x": momentum.x,
        "momentum.y": momentum.y,
        "angular_momentum": world.angular_momentum,
        "kinetic_energy": world.kinetic_energy,
    }


def of_body(prefix: str, body: Body) -> dict[str, float]:
    """Position (m), velocity (m/s), angle (rad), spin (rad/s), momentum (kg m/s), the rest."""
    values = (
        body.x,
        body.y,
        body.vx,
        body.vy,
        body.speed,
        body.angle,
        body.spin,
        body.mass,
        body.mass * body.speed,
        body.kinetic_energy,
        body.restitution,
        body.friction,
    )
    return dict(zip(names(prefix), values, strict=True))
