"""A hand for tests: it touches widgets by their ids and lets time pass, by events alone."""

from collections.abc import Mapping
from random import Random

from screens.kit.events import Drag, Event, Key, Release, Tap, Tick
from screens.kit.geometry import Point, Rect, Size
from screens.kit.words import load_words
from screens.lesson import Lesson
from screens.lessons import Lessons, lesson_class

PORTRAIT, LANDSCAPE = Size(360, 640), Size(640, 360)


def lesson(
    id: str, settings: Mapping[str, float] | None = None, size: Size = PORTRAIT, seed: int = 1
) -> Lesson:
    return lesson_class(id)(size, Random(seed).random, settings or {}, load_words())


def lessons(first: str = "inertia", size: Size = PORTRAIT, seed: int = 1) -> Lessons:
    return Lessons(first, size, lambda id: Random(f"{seed}/{id}").random, {}, load_words())


def rect(of: Lesson, id: str) -> Rect:
    return next(widget.rect for widget in of.widgets() if widget.id == id)


def ids(of: Lesson) -> list[str]:
    return [widget.id for widget in of.widgets()]


def tap(on: Lesson, id: str) -> None:
    on.update(Tap(rect(on, id).center))


def drag(on: Lesson, id: str, to: Point) -> None:
    start = rect(on, id).center
    half = Point((start.x + to.x) / 2, (start.y + to.y) / 2)
    for at in (start, half, to):
        on.update(Drag(start, at))
    on.update(Release(to))


def fill(on: Lesson, name: str, text: str) -> None:
    tap(on, f"{name}.field")
    for character in text:
        on.update(Key(character))
    on.update(Key("enter"))


def wait(on: Lesson, ticks: int) -> list[object]:
    """Let time pass; return all collisions."""
    happened: list[object] = []
    for _ in range(ticks):
        on.update(Tick())
        happened += on.collisions
    return happened


def feed(on: Lesson, *events: Event) -> None:
    for event in events:
        on.update(event)
