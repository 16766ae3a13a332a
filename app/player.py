"""The player: the steps of a scenario become events, tick by tick.

It sees the lesson only through what any viewer could see: its widgets and its probes.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

from app.gestures import gesture
from app.scenario import model
from app.scenario.mistakes import Mistake, Place
from app.scenario.model import Scenario, Step, ticks
from app.session import Cue
from app.targets import NoTarget
from screens.kit.events import Event, Tick, Tilt
from screens.lesson import Lesson

LONGEST = 60 * 60 * 60
"""Ticks that a scenario may last: one hour."""

Doing = Event | Cue


class ScenarioFailed(Exception):
    """The scenario cannot go on; `mistake` says why and where."""

    def __init__(self, mistake: Mistake) -> None:
        """Keep the mistake for whoever shows it."""
        super().__init__(str(mistake))
        self.mistake = mistake
        self.unmet: Sequence[Mistake] = ()
        """One for every `expect` before that did not hold."""


@dataclass(frozen=True, slots=True)
class Check:
    """An `expect` or `until` that was decided."""

    step: model.Expect | model.Until
    value: float | None
    """The probe's value when it was decided; None if it had none."""
    time: float
    """Of the lesson's world (s)."""
    passed: bool


class Player:
    """Plays one scenario on one lesson."""

    def __init__(
        self,
        scenario: Scenario,
        lesson: Lesson,
        checked: Callable[[Check], None] = lambda check: None,
    ) -> None:
        """Nothing happens until `play`; `checked` is told of every `expect` and `until`."""
        self._scenario = scenario
        self._lesson = lesson
        self._checked = checked
        self._ticks = 0
        self._tilt = (0.0, 0.0)
        self.checks: list[Check] = []
        """Every `expect` and `until` so far, in the order they were decided."""

    def play(self) -> Iterator[Doing]:
        """What happens, in order; raises ScenarioFailed if the scenario cannot go on.

        The next thing is worked out only when it is asked for, so that it can depend on what the
        one before did to the lesson.
        """
        try:
            yield from self._play(self._scenario.steps)
        except ScenarioFailed as failed:
            failed.unmet = self.failures()
            raise

    def failures(self) -> list[Mistake]:
        """One mistake for every `expect` that did not hold, in order."""
        return [
            _unmet(check)
            for check in self.checks
            if isinstance(check.step, model.Expect) and not check.passed
        ]

    def _play(self, steps: Sequence[Step]) -> Iterator[Doing]:
        for step in steps:
            match step:
                case model.Repeat():
                    for _ in range(step.times):
                        yield from self._play(step.steps)
                case model.Run():
                    yield from self._play(step.steps)
                case model.Wait():
                    yield from self._wait(step.place, ticks(step.seconds))
                case model.Tap() | model.Drag() | model.Fill():
                    yield from self._gesture(step)
                case model.Tilt():
                    yield from self._turn(step)
                case model.Until():
                    yield from self._until(step)
                case model.Expect():
                    self._expect(step)
                case _:
                    yield step

    def _tick(self, place: Place) -> Tick:
        self._ticks += 1
        if self._ticks > LONGEST:
            raise ScenarioFailed(
                Mistake(place, "too-long", "here the scenario has lasted longer than 1 h")
            )
        return Tick()

    def _wait(self, place: Place, count: int) -> Iterator[Doing]:
        for _ in range(count):
            yield self._tick(place)

    def _gesture(self, step: model.Tap | model.Drag | model.Fill) -> Iterator[Doing]:
        """What a hand does, tick by tick."""
        try:
            for touch in gesture(self._lesson, step):
                if touch.after_tick:
                    yield self._tick(step.place)
                yield from touch.events
        except NoTarget as gone:
            raise _nothing_there(step.place, gone) from gone

    def _turn(self, step: model.Tilt) -> Iterator[Doing]:
        """Tilt the device: straight from each point of the curve to the next."""
        curve = step.curve
        if step.to is not None:
            curve = ((0.0, *self._tilt), (step.over, *step.to))
        else:
            yield self._tilted(curve[0][1:])
        begun = 0
        for before, after in pairwise(curve):
            end = ticks(after[0])
            for tick in range(begun + 1, end + 1):
                yield self._tick(step.place)
                part = (tick - begun) / (end - begun)
                yield self._tilted(
                    tuple(a + part * (b - a) for a, b in zip(before[1:], after[1:], strict=True))
                )
            begun = end
        yield self._tilted(curve[-1][1:])

    def _tilted(self, angles: Sequence[float]) -> Tilt:
        roll, pitch = angles
        self._tilt = (roll, pitch)
        return Tilt(roll, pitch)

    def _value(self, probe: str) -> float | None:
        """What the probe says now, or None if there is no such number at this moment."""
        value = self._lesson.probes().get(probe)
        return None if value is None or math.isnan(value) else float(value)

    def _expect(self, step: model.Expect) -> None:
        value = self._value(step.probe)
        self._decided(step, value, value is not None and step.comparison.holds(value))

    def _decided(self, step: model.Expect | model.Until, value: float | None, passed: bool) -> None:
        check = Check(step, value, self._lesson.world.time, passed)
        self.checks.append(check)
        self._checked(check)

    def _until(self, step: model.Until) -> Iterator[Doing]:
        """Let time pass until the comparison holds; it may hold at once."""
        nearest: Reading | None = None
        for remaining in range(ticks(step.within), -1, -1):
            value = self._value(step.probe)
            now = self._lesson.world.time
            if value is not None:
                if step.comparison.holds(value):
                    self._decided(step, value, passed=True)
                    return
                reading = Reading(step.comparison.distance(value), value, now)
                nearest = reading if nearest is None or reading.away < nearest.away else nearest
            if remaining:
                yield self._tick(step.place)
        self._decided(step, value, passed=False)
        raise ScenarioFailed(_never_held(step, value, nearest))


class Reading(NamedTuple):
    """What a probe said at one time."""

    away: float
    """From what was wanted."""
    value: float
    time: float
    """Of the lesson's world (s)."""


def _nothing_there(place: Place, gone: NoTarget) -> ScenarioFailed:
    return ScenarioFailed(Mistake(place, "no-target", gone.sentence, gone.help))


def _never_held(step: model.Until, last: float | None, nearest: Reading | None) -> Mistake:
    sentence = f"{step.probe} did not come {step.comparison} within {step.within:g} s"
    if nearest is None:
        return Mistake(step.place, "until-failed", f"{sentence}: it had no value")
    ended = "it has no value now" if last is None else f"it is {last:.9g} now"
    best = f"came nearest at t = {nearest.time:.3f} s with {nearest.value:.9g}"
    return Mistake(step.place, "until-failed", f"{sentence}: {ended}, and {best}")


def _unmet(check: Check) -> Mistake:
    step = check.step
    was = (
        "it has no value"
        if check.value is None
        else f"it is {_shown(step.comparison, check.value)}"
    )
    return Mistake(
        step.place,
        "expect-failed",
        f"{step.probe} should be {step.comparison}, but {was} at t = {check.time:.3f} s",
    )


def _shown(comparison: model.Comparison, value: float) -> str:
    """The value; if one number was wanted, also by how much it misses that one."""
    wanted = comparison.near if comparison.equals is None else comparison.equals
    return f"{value:.9g}" if wanted is None else f"{value:.9g}, off by {abs(value - wanted):.3g},"
