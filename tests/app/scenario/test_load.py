from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from app.scenario import model
from app.scenario.load import Overrides, load
from app.scenario.mistakes import ScenarioMistakes
from app.scenario.model import Comparison
from screens.kit.geometry import Point

WHOLE = """\
laws: 1
screen: inertia
title: A body at rest stays at rest
alt: A pentagon sits still.
seed: 7
lang: en
size: 640x360
fps: 30
output: [out/inertia.mp4, out/frames/]
set: {body.sides: 5, body.mass: 2.5}
steps:
  - caption: At rest.
  - caption:
  - wait: 250ms
  - tap: Change force
  - drag: {from: force.arrow, to: [300, 320.5], over: 0.8s}
  - tap: [10, 20]
  - expect: {probe: body.speed, near: 0, tol: 1e-9}
  - until: {probe: body.speed, above: 1.5, below: 2, within: 1min}
  - marker: coasting
  - screenshot: out/coasting.png
  - speed: 0.25
  - hide
  - show: taps
  - repeat: {times: 3, steps: [{wait: 2}]}
"""
NO_OVERRIDES = Overrides()
SHORT = "laws: 1\nscreen: {}\nsteps:\n  - wait: 1s\n"


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def write(name: str, text: str) -> str:
    Path(name).parent.mkdir(parents=True, exist_ok=True)
    Path(name).write_text(text, encoding="utf-8")
    return name


def codes(path: str, overrides: Overrides = NO_OVERRIDES) -> list[tuple[str, int, str]]:
    with pytest.raises(ScenarioMistakes) as caught:
        load(path, overrides)
    return [(m.place.path, m.place.line, m.code) for m in caught.value.mistakes]


@pytest.mark.usefixtures("folder")
def test_a_whole_file_becomes_a_scenario():
    scenario = load(write("a.yaml", WHOLE))
    assert scenario.path == "a.yaml"
    assert (scenario.laws, scenario.screen, scenario.seed, scenario.lang) == (1, "inertia", 7, "en")
    assert (scenario.size, scenario.fps) == ((640, 360), 30)
    assert scenario.outputs == ("out/inertia.mp4", "out/frames/")
    assert scenario.settings == {"body.sides": 5, "body.mass": 2.5}
    at = [step.place for step in scenario.steps]
    assert [place.line for place in at] == list(range(12, 26))
    assert scenario.steps == (
        model.Caption(at[0], "At rest."),
        model.Caption(at[1], ""),
        model.Wait(at[2], 0.25),
        model.Tap(at[3], "Change force"),
        model.Drag(at[4], "force.arrow", Point(300, 320.5), 0.8),
        model.Tap(at[5], Point(10, 20)),
        model.Expect(at[6], "body.speed", Comparison(near=0, tol=1e-9)),
        model.Until(at[7], "body.speed", Comparison(above=1.5, below=2), 60),
        model.Marker(at[8], "coasting"),
        model.Screenshot(at[9], "out/coasting.png"),
        model.Speed(at[10], 0.25),
        model.Hide(at[11], "film"),
        model.Show(at[12], "taps"),
        model.Repeat(at[13], 3, (model.Wait(scenario.steps[13].steps[0].place, 2),)),
    )


@pytest.mark.usefixtures("folder")
def test_what_a_file_does_not_say():
    scenario = load(write("a.yaml", SHORT.format("forces")))
    assert (scenario.title, scenario.alt, scenario.seed, scenario.lang) == ("", "", 0, "en")
    assert (scenario.size, scenario.fps) == ((720, 1280), 60)
    assert (scenario.outputs, scenario.settings) == ((), {})


@pytest.mark.usefixtures("folder")
def test_steps_of_dialogs_and_tilts():
    fill = "laws: 1\nscreen: forces\nsteps:\n  - fill: {acceleration: 1.5, mass: 2}\n"
    (step,) = load(write("a.yaml", fill)).steps
    assert list(step.values.items()) == [("acceleration", 1.5), ("mass", 2)]
    tilts = (
        "laws: 1\nscreen: reactions\nsteps:\n  - tilt: {to: [15, -5], over: 1s}\n"
        "  - tilt: {curve: [[0s, 0, 0], [500ms, 15, 0]]}\n"
    )
    to, curve = load(write("b.yaml", tilts)).steps
    assert (to.to, to.over, to.curve) == (Point(15, -5), 1, ())
    assert (curve.to, curve.over, curve.curve) == (None, 0.5, ((0, 0, 0), (0.5, 15, 0)))


@pytest.mark.usefixtures("folder")
def test_the_command_line_wins_over_the_file():
    overrides = Overrides(
        seed="9",
        size="1280x720",
        fps="60",
        outputs=("/anywhere/a.gif", "../b/"),
        settings=("body.mass=4", "force.x = -1.5"),
    )
    scenario = load(write("a.yaml", WHOLE), overrides)
    assert (scenario.seed, scenario.size, scenario.fps) == (9, (1280, 720), 60)
    assert scenario.outputs == ("/anywhere/a.gif", "../b/")
    assert scenario.settings == {"body.sides": 5, "body.mass": 4, "force.x": -1.5}


@pytest.mark.usefixtures("folder")
def test_mistakes_of_the_command_line_are_told_with_those_of_the_file():
    overrides = Overrides(
        "x", "9x9", "61", ("a.doc",), ("body.mas=1", "body.mass", "body.mass=9e9")
    )
    path = write("a.yaml", "laws: 1\nscreen: inertia\nsteps:\n  - tpa: body\n")
    assert codes(path, overrides) == [
        ("a.yaml", 4, "unknown-step"),
        ("--fps", 0, "bad-fps"),
        ("--output", 0, "bad-output"),
        ("--seed", 0, "wrong-type"),
        ("--set", 0, "missing-value"),
        ("--set", 0, "unknown-setting"),
        ("--set", 0, "out-of-range"),
        ("--size", 0, "bad-size"),
    ]


@pytest.mark.usefixtures("folder")
def test_even_sides_are_needed_for_films_even_if_the_command_line_says_otherwise():
    path = write("a.yaml", SHORT.format("inertia"))
    assert codes(path, Overrides(size="361x640", outputs=("a.mp4",))) == [
        ("--output", 0, "bad-size")
    ]
    assert load(path, Overrides(size="361x640", outputs=("a.gif",))).size == (361, 640)


@pytest.mark.usefixtures("folder")
def test_a_file_that_is_not_there():
    assert codes("nowhere.yaml") == [("nowhere.yaml", 0, "no-file")]
    assert codes(".") == [(".", 0, "no-file")]
    assert codes("\0") == [("\0", 0, "no-file")]


@pytest.mark.usefixtures("folder")
def test_run_takes_the_steps_of_another_file_with_their_places():
    write("part/b.yaml", SHORT.format("inertia") + "  - run: c.yaml\n")
    write("part/c.yaml", SHORT.format("inertia"))
    path = write("a.yaml", "laws: 1\nscreen: inertia\nsteps:\n  - run: part/b.yaml\n")
    (run,) = load(path).steps
    wait, inner = run.steps
    assert (wait.place.path, wait.place.line) == ("part/b.yaml", 4)
    assert (inner.steps[0].place.path, inner.steps[0].seconds) == ("part/c.yaml", 1)


@pytest.mark.usefixtures("folder")
def test_files_that_run_each_other_many_times_are_counted_not_carried_out():
    write("f0.yaml", SHORT.format("inertia"))
    for level in range(1, 8):
        runs = f"  - run: f{level - 1}.yaml\n" * 100
        write(f"f{level}.yaml", f"laws: 1\nscreen: inertia\nsteps:\n{runs}")
    assert len(load("f1.yaml").steps) == 100
    assert ("f7.yaml", 4, "too-many-steps") in codes("f7.yaml")


@pytest.mark.usefixtures("folder")
def test_eight_files_may_run_each_other_and_nine_may_not():
    write("f0.yaml", SHORT.format("inertia"))
    for level in range(1, 9):
        text = f"laws: 1\nscreen: inertia\nsteps:\n  - run: f{level - 1}.yaml\n"
        write(f"f{level}.yaml", text)
    assert load("f7.yaml").steps
    assert [code for _, _, code in codes("f8.yaml")] == ["too-deep"]


@pytest.mark.usefixtures("folder")
def test_the_deepest_nesting_in_the_deepest_run_is_read():
    steps = "[{wait: 1s}]"
    for _ in range(9):
        steps = f"[{{repeat: {{times: 1, steps: {steps}}}}}]"
    write("f0.yaml", f"laws: 1\nscreen: inertia\nsteps: {steps}\n")
    for level in range(1, 8):
        inner = steps.replace("wait: 1s", f"run: f{level - 1}.yaml")
        write(f"f{level}.yaml", f"laws: 1\nscreen: inertia\nsteps: {inner}\n")
    assert load("f7.yaml").steps


def test_outputs_start_from_the_working_folder_and_stay_in_it_or_beside_the_file(folder):
    (folder / "work").mkdir()
    text = SHORT.format("inertia") + "output: [{}]\n"
    path = write("files/a.yaml", text.format(f"out/a.gif, {folder}/files/b.gif, ../files/c.gif"))
    assert load(path, working=folder / "work").outputs[0] == "out/a.gif"
    path = write("files/b.yaml", text.format("../d.gif"))
    with pytest.raises(ScenarioMistakes) as caught:
        load(path, working=folder / "work")
    assert [m.code for m in caught.value.mistakes] == ["outside-folder"]


def test_a_symbolic_link_leads_where_it_leads(folder):
    outside = folder / "outside"
    outside.mkdir()
    work = folder / "work"
    work.mkdir()
    (work / "link").symlink_to(outside)
    path = write("work/a.yaml", SHORT.format("inertia") + "output: link/a.gif\n")
    with pytest.raises(ScenarioMistakes) as caught:
        load(path, working=work)
    assert [m.code for m in caught.value.mistakes] == ["outside-folder"]


@pytest.mark.usefixtures("folder")
def test_a_file_may_go_to_another_screen_and_ask_for_its_numbers_then():
    text = (
        "laws: 1\nscreen: inertia\nsteps:\n"
        "  - tap: {}\n  - expect: {{probe: cart.a.x, above: -9}}\n"
    )
    assert load(write("a.yaml", text.format("nav.forces"))).steps
    assert codes(write("b.yaml", text.format("force.toggle"))) == [("b.yaml", 5, "unknown-probe")]


def test_every_shipped_scenario_is_without_mistakes(monkeypatch):
    root = Path(__file__).parents[3]
    monkeypatch.chdir(root)
    paths = sorted((root / "assets" / "scenarios").glob("*.yaml"))
    assert paths
    for path in paths:
        scenario = load(str(path))
        assert scenario.title
        assert scenario.alt


LINES = [
    *WHOLE.splitlines(),
    "",
    "- ",
    "x: [",
    "steps:",
    "  - tilt: {to: [1, 2]}",
    "  - run: a.yaml",
]
WORDS = [
    "laws",
    "inertia",
    "forces",
    ".nan",
    "-1",
    "1e999",
    "[",
    "]",
    "{",
    "}",
    ": ",
    "",
    "~",
    "'",
    '"',
]


@given(st.data())
@settings(
    max_examples=150,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@pytest.mark.usefixtures("folder")
def test_a_file_with_any_changes_is_read_or_refused(data):
    lines = data.draw(st.lists(st.sampled_from(LINES), max_size=20))
    text = "\n".join(lines if data.draw(st.booleans()) else WHOLE.splitlines())
    for _ in range(data.draw(st.integers(0, 3))):
        start = data.draw(st.integers(0, len(text)))
        word = data.draw(st.sampled_from(WORDS))
        text = text[:start] + word + text[start + data.draw(st.integers(0, 8)) :]
    try:
        load(write("a.yaml", text))
    except ScenarioMistakes as refused:
        sentences = [mistake.sentence for mistake in refused.mistakes]
    else:
        sentences = ["none"]
    assert all(sentences)


def test_white_space_around_a_caption_does_not_count(folder):
    """A block of YAML ends in a line break, which would take a line of the picture."""
    path = write("a.yaml", SHORT.format("inertia") + "  - caption: |\n      One.\n      Two.\n\n")
    assert load(path).steps[-1].text == "One.\nTwo."
