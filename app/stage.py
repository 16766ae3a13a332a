"""The stage: the lessons as a scenario finds them, with dice from its seed."""

from collections.abc import Callable
from random import Random

from app.scenario.model import Scenario
from screens.kit.scale import dp_size
from screens.kit.words import load_words
from screens.lesson import Dice
from screens.lessons import Lessons


def set_stage(scenario: Scenario) -> Lessons:
    """The lessons before the first step; the same scenario always gives the same."""
    return Lessons(
        first=scenario.screen,
        size=dp_size(*scenario.size),
        dice_for=dice_of(scenario.seed),
        settings=scenario.settings,
        words=load_words(scenario.lang),
    )


def dice_of(seed: int) -> Callable[[str], Dice]:
    """Dice for each lesson by its id: what one lesson rolls does not change another's."""
    return lambda lesson_id: Random(f"{seed}/{lesson_id}").random
