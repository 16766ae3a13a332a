"""Every shipped scenario is carried out: what it expects holds, and its world is the pinned one.

A digest changes only when the physics of a film changes. If that is meant, write the new ones with
`python tests/test_scenarios.py`.
"""

import json
import tempfile
from pathlib import Path

import pytest

from app.render import render
from app.scenario.load import Overrides, load
from assets import SCENARIOS

PINNED = Path(__file__).parent / "scenario_digests.json"
SHIPPED = sorted(SCENARIOS.glob("*.yaml"))


def carry_out(path: Path, folder: Path) -> dict[str, object]:
    """Render small and read the report; the physics does not depend on the size of the picture."""
    report = folder / f"{path.stem}.json"
    wide = load(str(path), Overrides()).size
    small = "180x320" if wide[1] >= wide[0] else "320x180"
    done = render(load(str(path), Overrides(outputs=(str(report),), size=small, fps="10")))
    assert not done.failures, [str(failure) for failure in done.failures]
    return json.loads(report.read_text(encoding="utf-8"))


def pinned(report: dict[str, object]) -> dict[str, object]:
    """What is held fast of a report."""
    return {"digest": report["digest"], "collisions": len(report["collisions"])}


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_a_shipped_scenario_does_what_it_says(path: Path, tmp_path: Path) -> None:
    report = carry_out(path, tmp_path)
    assert report["expects"], "a lesson worth showing states at least one number"
    assert all(expect["passed"] for expect in report["expects"])
    assert report["title"]
    assert report["alt"]
    assert report["captions"]
    known = json.loads(PINNED.read_text(encoding="utf-8"))
    assert pinned(report) == known[path.stem]


def test_there_are_three_for_each_lesson() -> None:
    screens = [load(str(path), Overrides()).screen for path in SHIPPED]
    assert min(screens.count(lesson) for lesson in ("inertia", "forces", "reactions")) >= 3


def test_nothing_is_pinned_that_is_not_shipped() -> None:
    assert set(json.loads(PINNED.read_text(encoding="utf-8"))) == {path.stem for path in SHIPPED}


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        rows = {path.stem: pinned(carry_out(path, Path(folder))) for path in SHIPPED}
    PINNED.write_text(json.dumps(rows, indent=2) + "\n", encoding="utf-8")
