"""Who may import whom: the contracts of pyproject.toml, run with the tests."""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parent.parent


def test_import_contracts_hold() -> None:
    code = (
        "from importlinter.cli import lint_imports; raise SystemExit(lint_imports(no_cache=True))"
    )
    run = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stdout + run.stderr
    assert "0 broken" in run.stdout


def test_the_top_level_holds_nothing_else() -> None:
    listed = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    if listed.returncode:
        return  # an unpacked archive has no list of its files
    top = {line.split("/")[0] for line in listed.stdout.splitlines()}
    known = {"engine", "screens", "app", "assets", "tests", "docs", "pyproject.toml"}
    known |= {"README.md", "LICENSE", "CHANGELOG.md", "constraints.txt"}
    assert {name for name in top if not name.startswith(".")} <= known


def test_the_page_names_every_file_and_no_other() -> None:
    page = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    named = set(re.findall(r"(\w+\.py)`", page))
    folders = ("engine", "engine/kernels", "app")
    files = {file.name for folder in folders for file in (ROOT / folder).glob("*.py")}
    assert files - {"__init__.py"} - named == set()
    tree = [
        file for top in ("engine", "screens", "app", "tests") for file in (ROOT / top).rglob("*.py")
    ]
    there = {file.name for file in tree}
    assert named - there == set()
