"""Who wants to know how a run goes: a progress bar, a program that reads JSON lines, or nobody."""

from app.player import Check
from app.report import Output
from app.scenario.model import Scenario
from app.session import Cue


class Watcher:
    """Is told how a run goes; does nothing about it. Others override what they care for."""

    def begun(self, scenario: Scenario, frames: int) -> None:
        """The outputs are open; about so many frames will come (an `until` may add some)."""

    def filmed(self, frames: int) -> None:
        """So many frames have been drawn."""

    def heard(self, cue: Cue, film: float) -> None:
        """A caption, marker or the like came at film time `film` (s)."""

    def checked(self, check: Check) -> None:
        """An `expect` or `until` was decided."""

    def finishing(self, path: str) -> None:
        """All frames are drawn; this output is being finished."""

    def wrote(self, output: Output) -> None:
        """This output is whole and has its name."""

    def failed(self, message: str) -> None:
        """Something went wrong."""

    def ended(self, code: int) -> None:
        """Nothing more will come; the program exits with `code`."""
