"""A scenario is tried on the real lesson, without time and without a picture.

Taps, drags and typing are carried out, so that one which meets nothing is found before anything is
drawn. Time stands still: what can be touched on a lesson depends on what was touched before.
"""

from app.gestures import gesture
from app.scenario.catalogue import of_screen
from app.scenario.mistakes import Mistake
from app.scenario.model import (
    Drag,
    Expect,
    Fill,
    Repeat,
    Run,
    Scenario,
    Step,
    Tap,
    Tilt,
    Until,
)
from app.targets import NoTarget
from screens.kit import events
from screens.lessons import Lessons

OFTEN = 2
"""How often a repetition is tried at most: what goes wrong the second time goes wrong always."""


def rehearse(scenario: Scenario, lessons: Lessons) -> list[Mistake]:
    """Every step that touches or asks for something that is not there when it is its turn.

    `lessons` are those that the scenario would be played on, freshly made; they are used up.
    """
    rehearsal = _Rehearsal(lessons)
    rehearsal.do(scenario.steps)
    rehearsal.end()
    return list(dict.fromkeys(rehearsal.mistakes))


class _Rehearsal:
    """One try of a scenario, and what went wrong."""

    def __init__(self, lessons: Lessons) -> None:
        self.lessons = lessons
        self.mistakes: list[Mistake] = []
        self.tilts: list[Tilt] = []
        self.felt = False
        """Whether a lesson was shown that feels a tilt; one that is shown later feels it too."""
        self.sure = True
        """Until something could not be done; from then on only what is wrong anyway is told."""

    def do(self, steps: tuple[Step, ...]) -> None:
        for step in steps:
            match step:
                case Repeat():
                    for _ in range(min(step.times, OFTEN)):
                        self.do(step.steps)
                case Run():
                    self.do(step.steps)
                case Tap() | Drag() | Fill():
                    self.touch(step)
                case Tilt():
                    self.tilt(step)
                case Expect() | Until():
                    self.look(step)
                case _:
                    pass
            self.felt |= "tilt.x" in of_screen(self.lessons.id).probes

    def touch(self, step: Tap | Drag | Fill) -> None:
        try:
            for touch in gesture(self.lessons, step):
                for event in touch.events:
                    self.lessons.update(event)
        except NoTarget as gone:
            if self.sure or gone.reason == "outside":
                self.note(step, "no-target", gone.sentence, gone.help)
            self.sure = False

    def tilt(self, step: Tilt) -> None:
        self.tilts.append(step)
        self.lessons.update(events.Tilt(*(step.to or step.curve[-1][1:])))

    def end(self) -> None:
        if self.sure and not self.felt:
            for step in self.tilts:
                sentence = f"the screen '{self.lessons.id}' does not feel a tilt"
                self.note(step, "no-effect", sentence, "'reactions' does")

    def look(self, step: Expect | Until) -> None:
        screen = self.lessons.id
        if self.sure and not of_screen(screen).has_probe(step.probe):
            sentence = f"the screen '{screen}', shown by then, has no probe '{step.probe}'"
            self.note(step, "unknown-probe", sentence)

    def note(self, step: Step, code: str, sentence: str, help: str = "") -> None:
        self.mistakes.append(Mistake(step.place, code, sentence, help))
