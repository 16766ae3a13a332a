import json
from pathlib import Path

import pytest
from jsonschema import Draft7Validator
from ruamel.yaml import YAML
from ruamel.yaml.error import YAMLError

from app.scenario.load import load
from app.scenario.mistakes import ScenarioMistakes
from app.scenario.schema import schema

ROOT = Path(__file__).parents[3]
SHIPPED = sorted((ROOT / "assets" / "scenarios").glob("*.yaml"))
WRONG = sorted((Path(__file__).parent / "wrong").glob("*.yaml"))

UNSEEN = {
    # of the tree, not of its values
    *(
        "several-documents",
        "anchor",
        "alias",
        "tag",
        "duplicate-key",
        "too-deep",
        "directive",
        "tab",
    ),
    *("syntax", "not-utf8", "empty-file", "control-character", "too-large", "no-glyph"),
    # of several values together, of other files, of the screen at that moment
    *("bad-size", "bad-time", "missing-key", "double-output", "outside-folder", "include-loop"),
    *("other-screen", "no-file", "too-many-steps", "too-long", "no-target", "no-effect"),
    *("unknown-probe", "unknown-widget", "unknown-setting", "too-many-keys", "out-of-range"),
}
"""Codes of mistakes that a JSON Schema cannot see, or not always."""


@pytest.fixture(scope="module")
def validator():
    Draft7Validator.check_schema(schema())
    return Draft7Validator(schema())


def values(path):
    return YAML(typ="safe", pure=True).load(path.read_text(encoding="utf-8"))


def test_the_committed_schema_is_the_one_that_the_format_gives():
    committed = ROOT / "assets" / "scenarios" / "laws.schema.json"
    assert json.loads(committed.read_text(encoding="utf-8")) == json.loads(json.dumps(schema()))


def test_there_is_nothing_in_it_that_draft_7_has_not():
    text = json.dumps(schema())
    for later in ("$defs", "unevaluatedProperties", "prefixItems", "dependentRequired", "Infinity"):
        assert later not in text


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_every_shipped_scenario_satisfies_it(validator, path):
    assert [error.message for error in validator.iter_errors(values(path))] == []


@pytest.mark.parametrize("path", WRONG, ids=lambda path: path.stem)
def test_it_refuses_what_a_schema_can_refuse(validator, path, monkeypatch):
    monkeypatch.chdir(path.parent)
    try:
        load(path.name)
    except ScenarioMistakes as refused:
        codes = {m.code for m in refused.mistakes if m.place.path == path.name}
    else:
        return  # only the rehearsal finds it
    try:
        document = values(path)
    except (YAMLError, UnicodeDecodeError):
        return  # no tree, no schema
    if codes - UNSEEN:
        assert list(validator.iter_errors(document)) != []


def test_every_key_and_step_has_words_for_the_hover():
    whole = schema()
    for name, part in whole["properties"].items():
        assert part["description"], name
    for name, part in whole["definitions"].items():
        if name != "step":
            (key,) = part["properties"]
            assert part["properties"][key]["description"], name
