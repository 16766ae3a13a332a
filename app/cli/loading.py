"""Scenario files for the commands: found, read, rehearsed; their mistakes shown together."""

from collections.abc import Callable, Sequence
from pathlib import Path

from app.cli import streams
from app.scenario.load import AS_WRITTEN, Overrides, load
from app.scenario.mistakes import Mistake, ScenarioMistakes, render
from app.scenario.model import Scenario
from app.scenario.rehearse import rehearse
from app.stage import set_stage


def load_all(
    paths: Sequence[str], overrides: Overrides | None = None
) -> tuple[list[Scenario], list[Mistake]]:
    """The scenarios at `paths` that could be read, and every mistake in all of them."""
    scenarios: list[Scenario] = []
    mistakes: list[Mistake] = []
    for path in paths:
        try:
            scenario = load(path, overrides or AS_WRITTEN)
        except ScenarioMistakes as refused:
            mistakes.extend(refused.mistakes)
        else:
            mistakes.extend(rehearse(scenario, set_stage(scenario)))
            scenarios.append(scenario)
    return scenarios, mistakes


def show(mistakes: Sequence[Mistake], told: Callable[[str], None] = lambda text: None) -> None:
    """Show mistakes to people, each of them to `told` as well, and then how many there are."""
    for mistake in mistakes:
        text = render(mistake)
        told(text)
        streams.say(text + "\n")
    files = len({mistake.place.path for mistake in mistakes if mistake.place.line})
    where = f" in {count(files, 'file')}" if files else ""
    streams.say(f"{count(len(mistakes), 'mistake')}{where}")


def count(number: int, thing: str) -> str:
    """Such as "1 file" and "2 files"."""
    return f"{number} {thing}" if number == 1 else f"{number} {thing}s"


def shipped() -> list[Path]:
    """The shipped scenarios, in order of their names."""
    from assets import SCENARIOS

    return sorted(SCENARIOS.glob("*.yaml"))
