import subprocess
import sys
from pathlib import Path

import pytest

from app.scenario.load import load
from app.scenario.rehearse import rehearse
from app.stage import set_stage

ROOT = Path(__file__).parents[3]
SHIPPED = sorted((ROOT / "assets").glob("*/*.yaml"))


@pytest.fixture
def told(tmp_path, monkeypatch):
    """Line and code of each mistake that a rehearsal of some steps finds."""
    monkeypatch.chdir(tmp_path)

    def tell(screen, *steps, header=""):
        text = f"laws: 1\nscreen: {screen}\n{header}steps:\n" + "".join(f"  - {s}\n" for s in steps)
        (tmp_path / "a.yaml").write_text(text, encoding="utf-8")
        scenario = load("a.yaml")
        first = 4 + header.count("\n")
        mistakes = rehearse(scenario, set_stage(scenario))
        return [(m.place.line - first + 1, m.code) for m in mistakes]

    return tell


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_shipped_scenarios_and_templates_touch_what_is_there(path, monkeypatch):
    monkeypatch.chdir(ROOT)
    scenario = load(str(path.relative_to(ROOT)))
    assert rehearse(scenario, set_stage(scenario)) == []


def test_a_dialog_is_opened_filled_and_closed(told):
    steps = ("tap: cart.a", "fill: {mass: 2, acceleration: 1.5}", "tap: Accept", "tap: cart.b")
    assert told("forces", *steps) == []


def test_what_is_typed_arrives(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = (
        "laws: 1\nscreen: forces\nsteps:\n  - tap: cart.b\n"
        "  - fill: {acceleration: 1.25, mass: 3.5}\n  - tap: dialog.accept\n"
    )
    (tmp_path / "a.yaml").write_text(text, encoding="utf-8")
    scenario = load("a.yaml")
    lessons = set_stage(scenario)
    assert rehearse(scenario, lessons) == []
    probes = lessons.probes()
    assert (probes["cart.b.mass"], probes["cart.b.acceleration"]) == (3.5, 1.25)
    assert probes["cart.b.force"] == 3.5 * 1.25
    assert probes["time"] == 0


def test_a_disabled_button(told):
    steps = ("tap: forces.apply", "wait: 1s", "tap: forces.apply")
    assert told("forces", *steps) == [(3, "no-target")]


def test_after_the_first_thing_that_cannot_be_done_only_what_never_can_is_told(told):
    steps = (
        "tap: Chnge force",
        "drag: {from: force.arrow, to: [9, 9]}",
        "tap: Accept",
        "tap: [-1, 0]",
    )
    assert told("inertia", *steps) == [(1, "no-target"), (4, "no-target")]


def test_a_repetition_is_tried_twice_and_told_once(told):
    steps = ("repeat: {times: 9999, steps: [{tap: forces.apply}]}",)
    assert told("forces", *steps) == [(1, "no-target")]


def test_a_place_must_lie_on_the_screen_of_this_shape(told):
    assert told("inertia", "tap: [600, 100]") == [(1, "no-target")]
    assert told("inertia", "tap: [600, 100]", header="size: 1280x720\n") == []


def test_another_screen_has_other_probes(told):
    assert told("inertia", "tap: nav.forces", "expect: {probe: cart.a.x, equals: 0}") == []
    steps = ("tap: nav.forces", "expect: {probe: body.x, equals: 0}")
    assert told("inertia", *steps) == [(2, "unknown-probe")]


def test_a_tilt_is_felt_by_a_lesson_that_is_shown_later(told):
    assert told("inertia", "tilt: {to: [9, 0]}") == [(1, "no-effect")]
    assert told("inertia", "tilt: {to: [9, 0]}", "tap: Reactions") == []


def test_neither_pictures_nor_films_nor_compilers_are_needed():
    program = (
        "import sys\n"
        "from app.scenario.load import load\n"
        "from app.scenario.rehearse import rehearse\n"
        "from app.stage import set_stage\n"
        "scenario = load(sys.argv[1])\n"
        "assert rehearse(scenario, set_stage(scenario)) == []\n"
        "print(*sorted({'pygame', 'av', 'numba', 'PIL'} & set(sys.modules)))\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", program, str(SHIPPED[0])],
        capture_output=True,
        text=True,
        check=True,
        cwd=ROOT,
    )
    assert done.stdout.strip() == ""
