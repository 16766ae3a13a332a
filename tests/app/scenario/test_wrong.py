"""Every file in wrong/ is refused with exactly the words beside it.

After a deliberate change, `python tests/app/scenario/test_wrong.py` writes the words anew: read
what changed before you commit it.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from app.scenario.load import load
from app.scenario.mistakes import ScenarioMistakes
from app.scenario.rehearse import rehearse
from app.stage import set_stage

HERE = Path(__file__).parent
WRONG = HERE / "wrong"
FILES = sorted(path.name for path in WRONG.glob("*.yaml"))
DOCS = HERE.parents[2] / "docs" / "scenario.md"


def said(name: str) -> str:
    """What is said about a file in wrong/, seen from there."""
    try:
        scenario = load(name)
    except ScenarioMistakes as refused:
        return f"{refused}\n"
    return f"{ScenarioMistakes(rehearse(scenario, set_stage(scenario)))}\n"


@pytest.fixture(autouse=True)
def _in_the_folder(monkeypatch):
    monkeypatch.chdir(WRONG)


@pytest.mark.parametrize("name", FILES)
def test_the_mistakes_are_told_as_expected(name):
    assert said(name) == (WRONG / name).with_suffix(".txt").read_text(encoding="utf-8")


def test_no_file_is_without_words_and_no_words_without_a_file():
    assert sorted(path.with_suffix(".yaml").name for path in WRONG.glob("*.txt")) == FILES
    assert len(FILES) > 60


def test_the_same_is_said_without_assertions():
    """Under `python -O`, in another process, with another hash seed."""
    program = (
        "import sys; sys.path.insert(0, sys.argv[1])\n"
        "from test_wrong import FILES, said\n"
        "sys.stdout.buffer.write(''.join(map(said, FILES)).encode())\n"
    )
    done = subprocess.run(
        [sys.executable, "-O", "-c", program, str(HERE)],
        capture_output=True,
        check=True,
        cwd=WRONG,
        env=os.environ | {"PYTHONHASHSEED": "7", "LC_ALL": "C"},
    )
    expected = "".join((WRONG / n).with_suffix(".txt").read_text(encoding="utf-8") for n in FILES)
    assert done.stdout.decode() == expected


def test_the_reference_explains_every_code_and_each_of_them_occurs_here():
    told = set()
    for name in FILES:
        words = (WRONG / name).with_suffix(".txt").read_text(encoding="utf-8")
        told |= set(re.findall(r"^\S.*: error\[([a-z0-9-]+)\]: ", words, re.MULTILINE))
    rows = re.findall(
        r"^\| (`.*?) \| ", DOCS.read_text(encoding="utf-8").split("| code |")[1], re.M
    )
    explained = {code for row in rows for code in re.findall(r"`([a-z0-9-]+)`", row)}
    elsewhere = {"too-large"}  # a file of 256 KiB would be needed: test_reading.py
    assert told | elsewhere == explained | {"no-file"}


if __name__ == "__main__":
    os.chdir(WRONG)
    for file in FILES:
        Path(file).with_suffix(".txt").write_text(said(file), encoding="utf-8")
