"""The lessons as one: navigation, catalogues, and that drawing changes nothing."""

import copy
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from hand import LANDSCAPE, PORTRAIT, feed, ids, lesson, lessons, tap, wait

import screens
from screens.kit.events import Key, Resize, Tap, Tilt
from screens.kit.geometry import Point
from screens.kit.layout import SCREENS
from screens.kit.surface import Surface
from screens.kit.words import MissingWords, Words, languages, load_words
from screens.lessons import lesson_class

SOURCES = sorted(Path(screens.__file__).parent.rglob("*.py"))


def busy(id: str, size=PORTRAIT):
    """A lesson in which much is to be seen."""
    shown = lesson(id, size=size)
    if id == "inertia":
        tap(shown, "force.toggle")
    elif id == "forces":
        tap(shown, "forces.apply")
    else:
        for x in (-2.0, -1.0, 0.0, 1.0, 2.0):
            shown.update(Tap(shown.view.to_screen((x, 0.0))))
        shown.update(Tilt(40.0, 5.0))
    wait(shown, 100)
    return shown


def opened(id: str, size=PORTRAIT):
    shown = busy(id, size)
    tap(shown, {"inertia": "force.change", "forces": "cart.a"}[id])
    if id == "forces":
        tap(shown, "mass.field")
        feed(shown, Key("7"))
    return shown


SHOWN = [(busy, id) for id in SCREENS] + [(opened, "inertia"), (opened, "forces")]


@pytest.mark.parametrize(("make", "id"), SHOWN)
@pytest.mark.parametrize(("size", "pixels"), [(PORTRAIT, (360, 640)), (LANDSCAPE, (960, 540))])
def test_drawing_changes_nothing(make, id, size, pixels) -> None:
    shown = make(id, size)
    before = shown.world.digest(), shown.probes(), shown.widgets(), inner(shown)
    pictures = []
    for surface in (Surface(*pixels), Surface(*pixels)):
        for _ in range(2):
            shown.draw(surface)
            pictures.append(surface.pixels())
    assert all(np.array_equal(pictures[0], picture) for picture in pictures)
    assert len(np.unique(pictures[0])) > 50
    assert (shown.world.digest(), shown.probes(), shown.widgets(), inner(shown)) == before


def inner(shown) -> dict[str, object]:
    """The state of a lesson besides its world, which is told by its digest."""
    held = {name: value for name, value in vars(shown).items() if name not in ("world", "dice")}
    if getattr(shown, "dialog", None):
        held["dialog"] = copy.copy(vars(shown.dialog))
    return {name: repr(value) if name == "carts" else value for name, value in held.items()}


@pytest.mark.parametrize("id", SCREENS)
def test_catalogues_name_all_that_there_is(id: str) -> None:
    shown = busy(id)
    wait(shown, 200)
    catalogue = lesson_class(id)
    probes = {re.sub(r"^particle\.\d+\.", "particle.N.", name) for name in shown.probes()}
    assert probes == set(catalogue.PROBES)
    there = set(ids(shown))
    if id in ("inertia", "forces"):
        there |= set(ids(opened(id))) - {"dialog"}
    assert there == set(catalogue.WIDGETS)
    assert all(
        s.default is None or s.low <= s.default <= s.high for s in catalogue.SETTINGS.values()
    )


@pytest.mark.parametrize("id", SCREENS)
def test_same_dice_and_events_give_the_same_world(id: str) -> None:
    assert busy(id).world.digest() == busy(id).world.digest()


def test_navigation_leads_to_the_other_lessons_and_back() -> None:
    shown = lessons()
    tap(shown, "force.toggle")
    wait(shown, 30)
    speed = shown.probes()["body.speed"]
    for id in ("reactions", "forces"):
        tap(shown, f"nav.{id}")
        assert (shown.id, shown.lesson.id) == (id, id)
        wait(shown, 10)
        assert shown.probes()["time"] == pytest.approx(10 / 60)
    tap(shown, "nav.inertia")
    assert shown.probes()["body.speed"] == speed
    tap(shown, "nav.inertia")
    assert shown.probes()["body.speed"] == speed


def test_an_open_dialog_covers_the_navigation() -> None:
    shown = lessons()
    tap(shown, "force.change")
    tap(shown, "nav.forces")
    assert shown.id == "inertia"


def test_size_and_tilt_are_the_same_in_all_lessons() -> None:
    shown = lessons()
    tap(shown, "nav.reactions")
    tap(shown, "nav.inertia")
    feed(shown, Tilt(30.0, 0.0), Resize(LANDSCAPE))
    tap(shown, "nav.reactions")
    assert shown.lesson.size == shown.size == LANDSCAPE
    assert shown.probes()["tilt.x"] == 30.0


def test_what_one_lesson_rolls_does_not_change_another() -> None:
    direct = lessons("reactions")
    detour = lessons("inertia")
    tap(detour, "nav.reactions")
    for shown in (direct, detour):
        shown.update(Tap(Point(180, 300)))
    assert direct.probes() == detour.probes()


@pytest.mark.parametrize("id", SCREENS)
def test_lessons_stay_interpreted(id: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """However long a film is: numba would take more memory than all the rest."""
    monkeypatch.setenv("LAWS_KERNELS", "compiled")
    assert lesson(id).world.kernels == "interpreted"


def test_lessons_work_without_pygame() -> None:
    script = """
import sys
from random import Random
from screens.kit.events import Tap, Tick
from screens.kit.geometry import Size
from screens.kit.words import load_words
from screens.kit.layout import SCREENS
from screens.lessons import Lessons
for id in SCREENS:
    shown = Lessons(id, Size(360, 640), lambda id: Random(id).random, {}, load_words())
    for widget in shown.widgets():
        if not widget.id.startswith("nav."):
            shown.update(Tap(widget.rect.center))
    shown.update(Tick())
    shown.probes(), shown.widgets()
heavy = {"pygame", "PIL", "av", "numba"} & set(sys.modules)
raise SystemExit(f"imported: {heavy}" if heavy else 0)
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_english_has_every_text_that_the_lessons_ask_for() -> None:
    asked = {
        name
        for source in SOURCES
        for name in re.findall(r'words\(\s*"([a-z_.A-Z]+)"', source.read_text("utf-8"))
    }
    assert len(asked) > 30
    for lang in languages():
        words = load_words(lang)
        assert [name for name in sorted(asked) if name not in words] == []
        assert set(words.names()) == set(load_words("en").names())


def test_a_missing_text_names_itself_and_the_file() -> None:
    words = Words({"a.b": "{mass} of"}, "xx.toml")
    assert words("a.b", mass="1 kg") == "1 kg of"
    with pytest.raises(MissingWords, match=r"xx\.toml has no text 'a\.c'"):
        words("a.c")
    with pytest.raises(MissingWords, match=r"xx\.toml: the text 'a\.b' cannot be filled"):
        words("a.b")
    with pytest.raises(MissingWords, match="no texts in 'tlh', only in"):
        load_words("tlh")
