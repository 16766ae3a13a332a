"""From a scenario to its files: sets the stage, opens the outputs, runs the one loop, reports."""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from app.camera import Camera
from app.deliverables import Deliverables
from app.frames import Film
from app.outputs import prepare
from app.outputs.remote import new_pixels
from app.overlay import Overlay
from app.player import Player
from app.report import Output, Report
from app.scenario.limits import Scale, pictures
from app.scenario.mistakes import Mistake
from app.scenario.model import Scenario, Screenshot
from app.session import Cue, Session, never_wait
from app.stage import set_stage
from app.watcher import Watcher
from screens.kit.surface import Surface
from screens.kit.words import load_words


@dataclass(frozen=True, slots=True)
class Rendered:
    """What a run made."""

    outputs: tuple[Output, ...]
    frames: int
    failures: tuple[Mistake, ...]
    """One for each `expect` that did not hold; the films were made all the same."""


def render(
    scenario: Scenario, watcher: Watcher | None = None, pace: Callable[[], None] = never_wait
) -> Rendered:
    """Carry a scenario out and write all its outputs; `pace` is called after each tick.

    Raises NotBegun if an output cannot be begun, OutputError if one cannot be finished, and
    ScenarioFailed or NothingFilmed if the scenario cannot be carried out. Whatever is raised, no
    unfinished file is left, and what stood under a promised name stands there still.
    """
    prepare(scenario.outputs)
    watcher = watcher or Watcher()
    width, height = scenario.size
    film = Film(width, height, scenario.fps, scenario.title, scenario.alt)
    lesson = set_stage(scenario)
    report = Report(scenario)
    shots = [shot.path for shot in pictures(scenario.steps)]
    player = Player(scenario, lesson, watcher.checked)
    with Deliverables(scenario.outputs, shots, film) as deliverables:

        def filmed(frames: int) -> None:
            report.frames = frames
            watcher.filmed(frames)

        overlay = Overlay(load_words(scenario.lang))
        surface = Surface(width, height, new_pixels)
        camera = Camera(surface, overlay, deliverables.films, film.fps, filmed)

        def heed(cue: Cue) -> None:
            if isinstance(cue, Screenshot):
                deliverables.picture(cue.path, camera.picture(lesson))
            report.heed(cue, camera.seconds, lesson.world.time)
            watcher.heard(cue, camera.seconds)

        watcher.begun(scenario, expected_frames(scenario))
        listeners = [report.moment, *(track.moment for track in deliverables.tracks)]
        Session(lesson, camera, listeners, heed, pace).run(player.play())
        outputs = deliverables.finish(report, player.checks, watcher)
    return Rendered(tuple(outputs), camera.clock.frames, tuple(player.failures()))


def expected_frames(scenario: Scenario) -> int:
    """How many frames a film has at least, as far as the file tells."""
    seconds = Scale().weigh(scenario.steps, Fraction(1)).film
    return int(-(-seconds * scenario.fps // 1)) + 1
