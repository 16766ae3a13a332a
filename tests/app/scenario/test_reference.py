"""docs/scenario.md cannot say what the program does not do."""

import re
import sys
from pathlib import Path

import pytest

from app.outputs import SUFFIXES
from app.scenario.catalogue import SCREENS, of_all, of_screen
from app.scenario.format import Context, StepsKind, file_fields
from app.scenario.load import load
from app.scenario.paths import Folders
from app.scenario.rehearse import rehearse
from app.stage import set_stage

sys.path.insert(0, str(Path(__file__).parent))
from reference import tables

DOCS = (Path(__file__).parents[3] / "docs" / "scenario.md").read_text(encoding="utf-8")
CONTEXT = Context(of_all(), Folders(Path(), Path()), lambda path, place: ())


def test_the_tables_are_those_of_the_lessons():
    assert tables() in DOCS


def test_every_key_and_every_step_is_explained():
    for key in file_fields(CONTEXT):
        assert f"\n| `{key}` | " in DOCS, key
    for step in StepsKind(CONTEXT).kinds:
        assert f"\n| `{step}` | `{step}" in DOCS, step


def test_every_suffix_is_explained():
    for suffix in SUFFIXES:
        assert f"`{suffix}`" in DOCS.split("## Paths")[1].split("## Limits")[0], suffix


@pytest.mark.parametrize("screen", SCREENS)
def test_every_probe_has_its_meaning_and_unit(screen):
    rows = re.findall(r"^\| (`.*?) \| (.+?) \| ?.*\|$", DOCS.split("### Probes")[1], re.MULTILINE)
    explained = {name for names, _ in rows for name in re.findall(r"`(.*?)`", names)}
    for probe in of_screen(screen).probes:
        last = "…." + probe.rsplit(".", 1)[-1]
        assert explained & {probe, last}, probe


def test_every_example_of_a_step_is_right(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    examples = re.findall(r"^\| (?:`\w+`)? \| `(\w+(?:: .+?)?)` \| ", DOCS, re.MULTILINE)
    assert len(examples) >= 15
    (tmp_path / "part").mkdir()
    opening = "laws: 1\nscreen: inertia\nsteps:\n  - wait: 1s\n"
    (tmp_path / "part" / "opening.yaml").write_text(opening, encoding="utf-8")
    screens = {"fill": "forces", "tilt": "reactions", "repeat": "reactions"}
    for number, example in enumerate(examples):
        screen = screens.get(example.split(":")[0], "inertia")
        path = tmp_path / f"{number}.yaml"
        path.write_text(f"laws: 1\nscreen: {screen}\nsteps:\n  - {example}\n", encoding="utf-8")
        assert load(path.name).steps, example


def test_the_example_of_a_whole_file_is_right(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    example = re.search(r"```yaml\n(laws.*?)```", DOCS, re.DOTALL)
    (tmp_path / "a.yaml").write_text(example[1], encoding="utf-8")
    scenario = load("a.yaml")
    assert rehearse(scenario, set_stage(scenario)) == []
