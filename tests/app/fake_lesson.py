"""A lesson with one body under a constant force: all that the loop and the player need."""

from types import SimpleNamespace

import numpy as np

from engine import Circle, Force, World
from screens.kit.events import Tap, Tick, Tilt
from screens.kit.geometry import Point, Rect, Size
from screens.lesson import Widget

PUSH = Widget("push", Rect(0, 0, 50, 50), "Push")
"""A tap on it pushes the body with 2 N (1 kg) for good; before that it is at rest."""

DEAD = Widget("dead", Rect(50, 0, 50, 50), "", enabled=False)


class FakeLesson:
    id = "fake"
    size = Size(100, 100)

    def __init__(self):
        self.world = World(integrator="velocity-verlet")
        self.body = self.world.add(Circle(0.1), mass=1.0, name="body")
        self.collisions = ()
        self.tilt = (0.0, 0.0)
        self.events = []

    def update(self, event):
        self.events.append(event)
        match event:
            case Tick(dt=dt):
                self.collisions = self.world.step(dt)
            case Tap(at=at) if PUSH.rect.holds(at):
                self.body.exert(Force(2, 0))
            case Tilt(roll=roll, pitch=pitch):
                self.tilt = (roll, pitch)

    def widgets(self):
        return (PUSH, DEAD)

    def probes(self):
        return {
            "time": self.world.time,
            "body.x": self.body.x,
            "body.speed": self.body.speed,
            "tilt.x": self.tilt[0],
            "tilt.y": self.tilt[1],
            "nothing": float("nan"),
        }

    def draw(self, surface):
        surface.drawn = self.world.tick


class FakeSurface:
    """Its picture is one pixel: the tick that was drawn."""

    size = Size(100, 100)
    drawn = 0
    draws = 0

    def pixels(self):
        self.draws += 1
        return np.array([[self.drawn]], dtype=np.uint32)

    def __getattr__(self, name):
        return lambda *args, **kwargs: None


class Collector:
    """A sink that remembers."""

    def __init__(self):
        self.frames = []
        self.moments = []

    def frame(self, frame):
        self.frames.append((frame.index, int(frame.pixels[0, 0])))

    def moment(self, moment):
        self.moments.append((moment.time, moment.world.tick))

    @property
    def shown(self):
        """The tick that each frame shows."""
        return [tick for _, tick in self.frames]


def at(x, y):
    return Point(x, y)


def scenario(*steps):
    return SimpleNamespace(steps=steps)
