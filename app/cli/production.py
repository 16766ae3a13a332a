"""Carries scenarios out for the commands, and turns what comes of it into words and exit codes."""

import gc
import os
from collections.abc import Iterator, Sequence
from pathlib import Path

from app.camera import NothingFilmed
from app.cli import streams
from app.cli.loading import count, load_all, show
from app.cli.progress import watching
from app.cli.stopping import wish
from app.deliverables import NotBegun
from app.installation import installed, pygame_trouble
from app.outputs import OutputError
from app.player import ScenarioFailed
from app.render import Rendered, render
from app.scenario.limits import pictures
from app.scenario.load import Overrides
from app.scenario.model import Scenario
from app.watcher import Watcher
from engine import Diverged

DONE, FAILED, REFUSED = 0, 1, 2
"""Exit codes."""


def produce(files: Sequence[str], overrides: Overrides, *, quiet: bool, json: bool) -> int:
    """Render all files; the exit code. Nothing is drawn if any of them has a mistake."""
    with watching(quiet=quiet, json=json) as watcher:
        code = _produce(files, overrides, watcher, prints_paths=not json)
        watcher.ended(code)
    return code


def _produce(
    files: Sequence[str], overrides: Overrides, watcher: Watcher, *, prints_paths: bool
) -> int:
    if not ready(watcher):
        return REFUSED
    scenarios, mistakes = load_all(files, overrides)
    if mistakes:
        show(mistakes, watcher.failed)
        return REFUSED
    scenarios = [with_output(scenario) for scenario in scenarios]
    clashes = list(written_twice(scenarios))
    for sentence in clashes:
        complain(sentence, watcher)
    if clashes:
        return REFUSED
    code = DONE
    for scenario in scenarios:
        result, rendered = attempt(scenario, watcher)
        code = max(code, result)
        if rendered is not None and prints_paths:
            for output in rendered.outputs:
                streams.result(output.path)
    return code


def ready(watcher: Watcher) -> bool:
    """Whether pictures can be drawn at all; says why not, or prepares for a longer run."""
    gc.freeze()  # what is imported stays: to look through it again takes 0.1 s
    gc.enable()
    trouble = pygame_trouble()
    if trouble is not None:
        complain(trouble, watcher)
    return trouble is None


def attempt(scenario: Scenario, watcher: Watcher) -> tuple[int, Rendered | None]:
    """Render one scenario; the exit code, and what was made if anything was."""
    try:
        rendered = render(scenario, watcher, wish.insist)
    except NotBegun as error:
        complain(str(error), watcher)
        return FAILED, None
    except (OutputError, NothingFilmed, Diverged) as error:
        complain(f"{scenario.path}: {error}; no unfinished file is left", watcher)
        return FAILED, None
    except ScenarioFailed as failed:
        show([*failed.unmet, failed.mistake], watcher.failed)
        complain(f"{scenario.path}: stopped there; no output was written", watcher)
        return FAILED, None
    if rendered.failures:
        show(rendered.failures, watcher.failed)
        unmet = count(len(rendered.failures), "expectation")
        complain(
            f"{scenario.path}: {unmet} not met; the outputs were written all the same", watcher
        )
        return FAILED, rendered
    return DONE, rendered


def complain(sentence: str, watcher: Watcher) -> None:
    """Say to people and to programs what went wrong."""
    streams.say(f"laws: {sentence}")
    watcher.failed(sentence)


def with_output(scenario: Scenario) -> Scenario:
    """The scenario; if it asks for no output, with a film under its own name in out/."""
    if scenario.outputs:
        return scenario
    width, height = scenario.size
    filmable = installed("av") is not None and width % 2 == 0 and height % 2 == 0
    name = f"out/{Path(scenario.path).stem}{'.mp4' if filmable else '.gif'}"
    return scenario._replace(outputs=(name,))


def written_twice(scenarios: Sequence[Scenario]) -> Iterator[str]:
    """A sentence for each file that two of the scenarios would write, or that is one of them."""
    sources = {os.path.realpath(scenario.path) for scenario in scenarios}
    taken: dict[str, str] = {}
    for scenario in scenarios:
        paths = (*scenario.outputs, *(shot.path for shot in pictures(scenario.steps)))
        places = {os.path.realpath(path): path for path in paths}
        for place, path in places.items():
            if place in sources:
                yield f"'{path}' would be written over a scenario"
            if place in taken:
                yield f"'{path}' would be written by {taken[place]} and by {scenario.path}"
        taken |= dict.fromkeys(places, scenario.path)
