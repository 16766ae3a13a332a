"""The same scenario gives the same bytes: twice in a process, and in processes that differ."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from app.render import render
from app.scenario.load import Overrides, load

SCENARIO = """\
laws: 1
screen: reactions
title: Two balls
seed: 5
size: 180x320
fps: 20
steps:
  - caption: Two balls.
  - tap: [140, 300]
  - tap: [220, 310]
  - tilt: {to: [30, -10], over: 0.2s}
  - screenshot: shot.png
  - wait: 1s
"""

NAMES = ("a.mp4", "a.webm", "a.gif", "a.apng", "a.webp", "a.csv", "a.json", "frames/")


def contents(folder):
    """The bytes of every file in a folder, by name."""
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in sorted(Path(folder).rglob("*"))
        if path.is_file()
    }


@pytest.fixture
def source(tmp_path):
    path = tmp_path / "source" / "balls.yaml"
    path.parent.mkdir()
    path.write_text(SCENARIO, encoding="utf-8")
    return path


def test_twice_in_one_process(source, tmp_path, monkeypatch):
    made = []
    for name in ("first", "second"):
        folder = tmp_path / name
        folder.mkdir()
        monkeypatch.chdir(folder)
        render(load(str(source), Overrides(outputs=NAMES)))
        made.append(contents(folder))
    assert len(made[0]) == 8 + 25
    assert made[0] == made[1]


def test_in_processes_that_differ(source, tmp_path):
    made = []
    for name, seed, locale, zone in (
        ("first", "1", "C", "UTC"),
        ("second/deeper", "2", "de_DE.UTF-8", "Asia/Tokyo"),
    ):
        folder = tmp_path / name
        folder.mkdir(parents=True)
        options = [part for output in NAMES for part in ("-o", output)]
        subprocess.run(
            [sys.executable, "-m", "app.cli", "render", str(source), *options],
            cwd=folder,
            env=os.environ | {"PYTHONHASHSEED": seed, "LC_ALL": locale, "TZ": zone},
            check=True,
            timeout=120,
            stdout=subprocess.DEVNULL,
        )
        made.append(contents(folder))
    assert made[0] == made[1]
