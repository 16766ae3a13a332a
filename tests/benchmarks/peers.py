"""Our engine and those it is measured against, behind one small door: scenes are written once.

The others need the extra `bench`: pymunk, pyb2d3 (Box2D v3), Box2D (2.3). Each is set up as its
makers advise, without sleeping, and with its restitution threshold at zero where it can be set, so
that all do the same work.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, Protocol

from engine import Circle, Pin, Polygon, Wall, World

TICK = 1 / 60

State = tuple[float, float, float, float, float, float]
"""Of a body: x, y (m), angle (rad), vx, vy (m/s), spin (rad/s)."""

Point = tuple[float, float]


class Engine(Protocol):
    """What a scene needs of an engine. Handles of bodies are whatever the engine uses."""

    name: str

    def wall(self, a: Point, b: Point) -> Any: ...
    def circle(
        self, x: float, y: float, radius: float, vx: float = 0.0, vy: float = 0.0
    ) -> Any: ...
    def box(self, x: float, y: float, width: float, height: float) -> Any: ...
    def pin(self, a: Any, b: Any, x: float, y: float) -> None: ...
    def step(self) -> None: ...
    def state(self, body: Any) -> State: ...


class Ours:
    """The engine of this repository, its kernels compiled unless told otherwise."""

    name = "ours"

    def __init__(
        self, gravity: float, restitution: float, friction: float, kernels: str = "compiled"
    ) -> None:
        self.world = World(gravity=(0, gravity), integrator="velocity-verlet", kernels=kernels)
        self.material = {"restitution": restitution, "friction": friction}

    def wall(self, a: Point, b: Point) -> Any:
        return self.world.add(Wall(a, b), **self.material)

    def circle(self, x: float, y: float, radius: float, vx: float = 0.0, vy: float = 0.0) -> Any:
        place = {"position": (x, y), "velocity": (vx, vy), "mass": math.pi * radius * radius}
        return self.world.add(Circle(radius), **place, **self.material)

    def box(self, x: float, y: float, width: float, height: float) -> Any:
        shape = Polygon.box(width, height)
        return self.world.add(shape, position=(x, y), mass=width * height, **self.material)

    def pin(self, a: Any, b: Any, x: float, y: float) -> None:
        self.world.join(a, b, Pin(at=(x, y)))

    def step(self) -> None:
        self.world.step(TICK)

    def state(self, body: Any) -> State:
        return (*body.position, body.angle, *body.velocity, body.spin)


class Pymunk:
    """pymunk (Chipmunk): ten iterations, its default."""

    name = "pymunk"

    def __init__(self, gravity: float, restitution: float, friction: float) -> None:
        import pymunk

        self.module = pymunk
        self.space = pymunk.Space()
        self.space.gravity = (0, gravity)
        self.restitution = math.sqrt(restitution)  # Chipmunk multiplies the two coefficients
        self.friction = math.sqrt(friction)

    def _add(self, body: Any, shape: Any) -> Any:
        shape.elasticity, shape.friction = self.restitution, self.friction
        self.space.add(*({body, shape} - {self.space.static_body}))
        return body

    def wall(self, a: Point, b: Point) -> Any:
        static = self.space.static_body
        return self._add(static, self.module.Segment(static, a, b, 0.0))

    def circle(self, x: float, y: float, radius: float, vx: float = 0.0, vy: float = 0.0) -> Any:
        mass = math.pi * radius * radius
        body = self.module.Body(mass, self.module.moment_for_circle(mass, 0, radius))
        body.position, body.velocity = (x, y), (vx, vy)
        return self._add(body, self.module.Circle(body, radius))

    def box(self, x: float, y: float, width: float, height: float) -> Any:
        mass = width * height
        body = self.module.Body(mass, self.module.moment_for_box(mass, (width, height)))
        body.position = (x, y)
        return self._add(body, self.module.Poly.create_box(body, (width, height)))

    def pin(self, a: Any, b: Any, x: float, y: float) -> None:
        joint = self.module.PivotJoint(a or self.space.static_body, b, (x, y))
        joint.collide_bodies = False
        self.space.add(joint)

    def step(self) -> None:
        self.space.step(TICK)

    def state(self, body: Any) -> State:
        return (*body.position, body.angle, *body.velocity, body.angular_velocity)


class Box2D3:
    """Box2D v3 through pyb2d3: four substeps, its default."""

    name = "Box2D v3"

    def __init__(self, gravity: float, restitution: float, friction: float) -> None:
        import pyb2d3

        self.module = pyb2d3
        self.world = pyb2d3.World(gravity=(0, gravity))
        self.world.sleeping_enabled = False
        self.world.restitution_threshold = 0.0
        material = pyb2d3.surface_material(restitution=restitution, friction=friction)
        self.shape = pyb2d3.shape_def(density=1.0, material=material)
        self.ground = self.world.create_static_body(position=(0, 0))

    def wall(self, a: Point, b: Point) -> Any:
        return self.ground.create_shape(self.shape, self.module.segment(a, b))

    def circle(self, x: float, y: float, radius: float, vx: float = 0.0, vy: float = 0.0) -> Any:
        body = self.world.create_dynamic_body(position=(x, y), linear_velocity=(vx, vy))
        body.create_shape(self.shape, self.module.circle((0, 0), radius))
        return body

    def box(self, x: float, y: float, width: float, height: float) -> Any:
        body = self.world.create_dynamic_body(position=(x, y))
        body.create_shape(self.shape, self.module.box(width / 2, height / 2))
        return body

    def pin(self, a: Any, b: Any, x: float, y: float) -> None:
        a = a or self.ground
        self.world.create_revolute_joint(
            body_a=a,
            body_b=b,
            local_anchor_a=a.local_point((x, y)),
            local_anchor_b=b.local_point((x, y)),
        )

    def step(self) -> None:
        self.world.step(TICK, 4)

    def state(self, body: Any) -> State:
        p, v = body.position, body.linear_velocity
        return p.x, p.y, body.angle, v.x, v.y, body.angular_velocity


class Box2D2:
    """Box2D 2.3 through its SWIG package: eight velocity and three position iterations.

    Its restitution threshold of 1 m/s is compiled in: slow bodies do not bounce.
    """

    name = "Box2D 2.3"

    def __init__(self, gravity: float, restitution: float, friction: float) -> None:
        import Box2D

        self.module = Box2D
        self.world = Box2D.b2World(gravity=(0, gravity))
        self.ground = self.world.CreateStaticBody()
        self.material = {"density": 1.0, "restitution": restitution, "friction": friction}

    def wall(self, a: Point, b: Point) -> Any:
        shape = self.module.b2EdgeShape(vertices=[a, b])
        return self.ground.CreateFixture(shape=shape, **self.material)

    def circle(self, x: float, y: float, radius: float, vx: float = 0.0, vy: float = 0.0) -> Any:
        body = self._body(position=(x, y), linearVelocity=(vx, vy))
        body.CreateCircleFixture(radius=radius, **self.material)
        return body

    def box(self, x: float, y: float, width: float, height: float) -> Any:
        body = self._body(position=(x, y))
        body.CreatePolygonFixture(box=(width / 2, height / 2), **self.material)
        return body

    def _body(self, **given: Any) -> Any:
        body = self.world.CreateDynamicBody(**given)
        body.sleepingAllowed = False  # the world's doSleep=False does not reach its islands
        return body

    def pin(self, a: Any, b: Any, x: float, y: float) -> None:
        self.world.CreateRevoluteJoint(bodyA=a or self.ground, bodyB=b, anchor=(x, y))

    def step(self) -> None:
        self.world.Step(TICK, 8, 3)
        self.world.ClearForces()

    def state(self, body: Any) -> State:
        return (*body.position, body.angle, *body.linearVelocity, body.angularVelocity)


PEERS: dict[str, Callable[[float, float, float], Engine]] = {
    each.name: each for each in (Pymunk, Box2D2, Box2D3)
}
