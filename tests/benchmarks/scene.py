"""The film that the benchmarks of the outputs make: the shipped Reactions scenario."""

import tempfile
from pathlib import Path

import numpy as np
from PIL import Image

from app.camera import Camera
from app.frames import Film, Pixels, Sink
from app.overlay import Overlay
from app.player import Player
from app.render import render
from app.scenario.load import Overrides, load
from app.scenario.model import Scenario
from app.session import Session
from app.stage import set_stage
from assets import SCENARIOS
from screens.kit.surface import Surface
from screens.kit.words import load_words

SIZE = (720, 1280)
FPS = 30
NAME = "reactions-many-balls"


def scenario() -> Scenario:
    """What is filmed."""
    size = "x".join(map(str, SIZE))
    return load(str(SCENARIOS / f"{NAME}.yaml"), Overrides(size=size, fps=str(FPS)))


def film() -> Film:
    """What an output is told of it."""
    filmed = scenario()
    return Film(*filmed.size, filmed.fps, filmed.title, filmed.alt)


def export(*paths: Path | str) -> None:
    """Simulate and draw the scenario once, as `laws render` does, and write these outputs."""
    render(scenario()._replace(outputs=tuple(map(str, paths))))


def play(sink: Sink) -> None:
    """Simulate and draw the scenario once, and hand every frame to `sink`."""
    filmed = scenario()
    lesson = set_stage(filmed)
    surface, overlay = Surface(*filmed.size), Overlay(load_words(filmed.lang))
    camera = Camera(surface, overlay, [sink], filmed.fps)
    player = Player(filmed, lesson, lambda *_: None)
    Session(lesson, camera, [], lambda cue: None).run(player.play())


def frames() -> list[Pixels]:
    """All pictures of the scenario, each 1280 rows of 720, read back from a folder of PNG."""
    with tempfile.TemporaryDirectory() as folder:
        export(f"{folder}/frames/")
        return [_read(file) for file in sorted(Path(folder, "frames").iterdir())]


def _read(file: Path) -> Pixels:
    with Image.open(file) as image:
        rgb = np.asarray(image).astype(np.uint32)
    return rgb[..., 0] << 16 | rgb[..., 1] << 8 | rgb[..., 2]
