"""How much a scenario may ask for: counted from the file, without carrying anything out."""

from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from app.scenario.mistakes import Mistake
from app.scenario.model import Drag, Repeat, Run, Screenshot, Speed, Step, Tilt, Wait

MOST_STEPS = 10_000
"""Of a scenario, with every repetition counted."""

LONGEST = 3600
"""Seconds, of the simulated time as well as of the film."""


class Load(NamedTuple):
    """What some steps ask for."""

    steps: int = 0
    simulated: Fraction = Fraction(0)
    """Seconds at least; an `until` adds only what it turns out to need."""
    film: Fraction = Fraction(0)
    """Seconds at least."""
    speed: Fraction = Fraction(1)
    """At which the film runs afterwards."""

    def then(self, other: "Load", times: int = 1) -> "Load":
        """This, and after it another, `times` times."""
        return Load(
            self.steps + times * other.steps,
            self.simulated + times * other.simulated,
            self.film + times * other.film,
            other.speed,
        )


class Scale:
    """Weighs steps; what several `run`s share is weighed once for each speed."""

    def __init__(self) -> None:
        """Begin with nothing weighed."""
        self._known: dict[tuple[int, Fraction], Load] = {}

    def weigh(self, steps: tuple[Step, ...], speed: Fraction) -> Load:
        """What `steps` ask for if the film runs at `speed` when they begin."""
        key = (id(steps), speed)
        if key not in self._known:
            load = Load(speed=speed)
            for step in steps:
                load = load.then(self.one(step, load.speed))
            self._known[key] = load
        return self._known[key]

    def one(self, step: Step, speed: Fraction) -> Load:
        """What a single step asks for."""
        match step:
            case Repeat():
                first = self.weigh(step.steps, speed)
                return first.then(self.weigh(step.steps, first.speed), step.times - 1)
            case Run():
                return self.weigh(step.steps, speed)
            case Speed():
                return Load(1, speed=Fraction(str(step.factor)))
            case Wait():
                seconds = Fraction(str(step.seconds))
            case Drag() | Tilt():
                seconds = Fraction(str(step.over))
            case _:
                seconds = Fraction(0)
        return Load(1, seconds, seconds / speed, speed)


def excess(steps: tuple[Step, ...]) -> Iterator[Mistake]:
    """A mistake at the first step with which the scenario becomes too much, for each limit."""
    scale = Scale()
    load = Load()
    told: set[str] = set()
    for step in steps:
        load = load.then(scale.one(step, load.speed))
        for code, value, limit, sentence in (
            ("too-many-steps", load.steps, MOST_STEPS, "{0} steps with this one; at most {1}"),
            ("too-long", load.simulated, LONGEST, "{0} s of time with this step; at most {1} s"),
            ("too-long", load.film, LONGEST, "{0} s of film with this step; at most {1} s"),
        ):
            if value > limit and code not in told:
                told.add(code)
                amount = str(-(-value // 1)) if value < 10**12 else "more than 10^12"
                sentence = "the scenario has " + sentence.format(amount, limit)
                yield Mistake(step.place, code, sentence, "make it shorter, or several files")


def pictures(steps: tuple[Step, ...]) -> Iterator[Screenshot]:
    """Every screenshot that is written, in order; one that is repeated comes twice."""
    for step in steps:
        match step:
            case Screenshot():
                yield step
            case Repeat():
                for _ in range(min(step.times, 2)):
                    yield from pictures(step.steps)
            case Run():
                yield from pictures(step.steps)
            case _:
                pass
