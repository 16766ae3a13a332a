"""How a run tells what it is doing: a bar for a person, JSON lines for a program, or nothing."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from app.cli import streams
from app.json_text import dumps
from app.player import Check
from app.report import Output, described
from app.scenario.model import Caption, Scenario
from app.session import Cue
from app.watcher import Watcher

if TYPE_CHECKING:
    from rich.progress import Progress, TaskID


class JsonLines(Watcher):
    """Every event as one JSON object a line on stdout."""

    def __init__(self) -> None:
        """Nothing has begun."""
        self._fps = 60
        self._frames = 0

    def begun(self, scenario: Scenario, frames: int) -> None:
        """Tell what is being made."""
        self._fps = scenario.fps
        self._tell(
            "start",
            file=scenario.path,
            title=scenario.title,
            frames=frames,
            outputs=list(scenario.outputs),
        )

    def filmed(self, frames: int) -> None:
        """Tell once for each second of film."""
        if frames % self._fps == 0:
            self._tell("progress", frames=frames)

    def heard(self, cue: Cue, film: float) -> None:
        """Tell of captions."""
        if isinstance(cue, Caption):
            self._tell("caption", film=film, text=cue.text)

    def checked(self, check: Check) -> None:
        """Tell how it was decided."""
        self._tell("expect", **described(check))

    def wrote(self, output: Output) -> None:
        """Tell what it is."""
        self._tell("output", **output.described())

    def failed(self, message: str) -> None:
        """Tell what went wrong."""
        self._tell("error", message=message)

    def ended(self, code: int) -> None:
        """Tell with which code the program exits."""
        self._tell("end", code=code)

    def _tell(self, event: str, **fields: object) -> None:
        streams.result(dumps({"event": event} | fields))


class Bar(Watcher):
    """A bar on the terminal that counts frames, then names the file that is being finished."""

    def __init__(self, progress: "Progress") -> None:
        """Draw on a `progress` that is running."""
        self._progress = progress
        self._task: TaskID | None = None
        self._expected = 0

    def begun(self, scenario: Scenario, frames: int) -> None:
        """Start a new bar."""
        self._expected = frames
        self._task = self._progress.add_task(scenario.path, total=frames, doing="drawing")

    def filmed(self, frames: int) -> None:
        """Move the bar; an `until` makes it longer."""
        if self._task is not None:
            self._expected = max(self._expected, frames)
            self._progress.update(self._task, completed=frames, total=self._expected)

    def finishing(self, path: str) -> None:
        """Say that the frames are drawn, and what is still encoded."""
        if self._task is not None:
            self._progress.update(self._task, doing=f"encoding {path}")

    def wrote(self, output: Output) -> None:
        """Say so."""
        if self._task is not None:
            self._progress.update(self._task, doing=f"wrote {output.path}")


@contextmanager
def watching(*, quiet: bool, json: bool) -> Iterator[Watcher]:
    """What watches the runs of one command."""
    if json:
        yield JsonLines()
    elif quiet or not streams.is_terminal():
        yield Watcher()
    else:
        from rich.console import Console
        from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn

        columns = (
            TextColumn("{task.description}", markup=False),
            BarColumn(),
            MofNCompleteColumn(),
            TextColumn("{task.fields[doing]}", markup=False),
        )
        with Progress(
            *columns,
            console=Console(file=sys.stderr),
            transient=True,
            redirect_stdout=sys.stdout.isatty(),
        ) as progress:
            yield Bar(progress)
