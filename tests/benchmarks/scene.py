"""The film that the benchmarks of the outputs encode: the shipped Reactions scenario."""

from collections.abc import Sequence

from app.camera import Camera
from app.frames import Frame, Moment, Pixels, Sink
from app.overlay import Overlay
from app.player import Player
from app.scenario.load import Overrides, load
from app.session import Session
from app.stage import set_stage
from assets import SCENARIOS
from screens.kit.surface import Surface
from screens.kit.words import load_words

SIZE = (720, 1280)
FPS = 30
NAME = "reactions-many-balls"


def shoot(sinks: Sequence[Sink]) -> None:
    """Simulate and draw the scenario once, handing its frames and moments to `sinks`."""
    size = "x".join(map(str, SIZE))
    scenario = load(str(SCENARIOS / f"{NAME}.yaml"), Overrides(size=size, fps=str(FPS)))
    lesson = set_stage(scenario)
    player = Player(scenario, lesson)
    overlay = Overlay(load_words(scenario.lang))
    camera = Camera(Surface(*SIZE), overlay, sinks, FPS)
    Session(lesson, camera, sinks, lambda cue: None).run(player.play())


class Reel:
    """A sink that keeps every picture."""

    def __init__(self) -> None:
        self.pictures: list[Pixels] = []

    def frame(self, frame: Frame) -> None:
        self.pictures.append(frame.pixels)

    def moment(self, moment: Moment) -> None:
        pass

    def close(self) -> None:
        pass

    def abort(self) -> None:
        pass


def frames() -> list[Pixels]:
    """All pictures of the scenario, each 1280 rows of 720."""
    reel = Reel()
    shoot([reel])
    return reel.pictures
