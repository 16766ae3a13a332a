"""What the documents show works: their examples run as written."""

import doctest
import importlib
import re
from pathlib import Path

import pytest

import engine

ROOT = Path(__file__).parent.parent
DOCS = ("docs/engine.md",)


@pytest.mark.parametrize("name", DOCS)
def test_examples_print_what_the_page_says(name: str) -> None:
    found = doctest.testfile(str(ROOT / name), module_relative=False, encoding="utf-8")
    assert found.attempted > 20
    assert found.failed == 0


def test_the_guide_names_all_that_is_public_and_tests_that_are_there() -> None:
    guide = (ROOT / "docs" / "engine.md").read_text(encoding="utf-8")
    words = set(re.findall(r"`(\w+)`", guide))
    assert set(engine.__all__) - words == set()
    there = {file.stem for file in (ROOT / "tests").rglob("test_*.py")}
    named = set(re.findall(r"\btest_\w+(?=`|\.py)", guide))
    assert len(named) > 20
    assert named - there == set()


def test_the_engine_of_the_readme_runs() -> None:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    (example,) = re.findall(r"```python\n(from engine import .*?)```", text, re.DOTALL)
    names: dict[str, object] = {}
    exec(compile(example, "README.md", "exec"), names)
    assert names["world"].time == pytest.approx(2.0)


def test_what_was_measured_stands_where_benchmarks_write_it(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """A row that a benchmark writes replaces the one for the same scene, and there is no other."""
    monkeypatch.syspath_prepend(str(ROOT / "tests" / "benchmarks"))
    page, peers, steps = map(importlib.import_module, ("page", "engine_peers", "engine_steps"))
    before = page.PAGE.read_text(encoding="utf-8")
    monkeypatch.setattr(page, "PAGE", tmp_path / "performance.md")
    page.PAGE.write_text(before, encoding="utf-8")
    scenes = [*peers.SHORT, *peers.LONG]
    wide, narrow = len(peers.HEADER) - 2, len(steps.HEADER) - 1
    rows = [(scene.name, peers.named(each)) for scene in scenes for each in scene.phases]
    page.put(peers.HEADER, [(*row, *["1"] * wide) for row in rows], names=2)
    page.put(steps.HEADER, [(name, *["1"] * narrow) for name in steps.SCENES], names=1)
    after = page.PAGE.read_text(encoding="utf-8").splitlines()
    assert len(after) == len(before.splitlines())
    assert sum(set(page.cells(line)[2:]) == {"1"} for line in after) == len(rows) + len(
        steps.SCENES
    )
    with pytest.raises(ValueError, match="is not in list"):
        page.put(("no", "table"), [], names=1)
