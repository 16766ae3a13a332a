import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from command_line import PUSH, files, laws

from app.cli.program import COMMANDS

SCREENS = ("inertia", "forces", "reactions")


@pytest.fixture
def push(tmp_path):
    path = tmp_path / "push.yaml"
    path.write_text(PUSH, encoding="utf-8")
    return path


def test_help_names_every_command(tmp_path):
    code, out, _ = laws("--help", folder=tmp_path)
    assert code == 0
    for command in ("demo", "render", "check", "new", "list", "schema", "warm", "doctor"):
        assert f"\n  {command} " in out


def test_every_command_has_help_with_examples(tmp_path):
    for command in ("demo", "render", "check", "new", "list", "schema"):
        code, out, _ = laws(command, "--help", folder=tmp_path)
        assert code == 0
        assert f"Examples:\n    laws {command}" in out


@pytest.mark.parametrize("command", sorted(COMMANDS))
def test_every_command_can_be_asked_for_tracebacks(command, tmp_path):
    code, out, _ = laws(command, "--debug", "--help", folder=tmp_path)
    assert (code, "--debug" in out) == (0, True)


def test_a_wrong_command_is_refused(tmp_path):
    code, out, err = laws("rendre", folder=tmp_path)
    assert (code, out) == (2, "")
    assert "Did you mean 'render'?" in err


def test_check_says_how_many_are_well(push, tmp_path):
    assert laws("check", push, push, folder=tmp_path) == (0, "2 files checked, no mistakes\n", "")


def test_check_shows_the_mistakes_of_all_files(push, tmp_path):
    wrong = tmp_path / "wrong.yaml"
    wrong.write_text(PUSH.replace("caption", "captoin").replace("body.speed", "body.sped"))
    untapped = tmp_path / "untapped.yaml"
    untapped.write_text(PUSH.replace("  - wait: 0.5s", "  - tap: dialog.accept", 1))
    code, out, err = laws("check", push, "wrong.yaml", "untapped.yaml", folder=tmp_path)
    assert (code, out) == (2, "")
    assert "wrong.yaml:10:5: error[unknown-step]: unknown step 'captoin'" in err
    assert "did you mean 'caption'?" in err
    assert "error[unknown-probe]" in err
    assert "untapped.yaml:12:10: error[" in err
    assert err.endswith("3 mistakes in 2 files\n")
    assert "Traceback" not in err


@pytest.mark.parametrize("screen", SCREENS)
def test_new_writes_a_scenario_that_is_well(screen, tmp_path):
    code, out, _ = laws("new", screen, folder=tmp_path)
    assert (code, out) == (0, f"{screen}.yaml\n")
    assert laws("check", f"{screen}.yaml", folder=tmp_path)[0] == 0


def test_new_overwrites_nothing(push, tmp_path):
    code, _, err = laws("new", "inertia", "-o", push, folder=tmp_path)
    assert code == 2
    assert "is there already" in err
    assert push.read_text(encoding="utf-8") == PUSH


def test_new_makes_the_folders_of_its_example(tmp_path):
    code, out, _ = laws("new", "reactions", "-o", "lessons/hits.yaml", folder=tmp_path)
    assert (code, out) == (0, "lessons/hits.yaml\n")
    assert files(tmp_path) == ["lessons/hits.yaml"]
    code, _, err = laws("new", "inertia", "-o", "lessons/hits.yaml/a.yaml", folder=tmp_path)
    assert (code, err.startswith("laws new: cannot write lessons/hits.yaml/a.yaml: ")) == (1, True)


@pytest.mark.skipif(os.name == "nt", reason="there, a folder that is used cannot be removed")
def test_a_working_folder_that_is_gone_is_no_riddle(tmp_path):
    program = (
        "import os, shutil, sys; shutil.rmtree(os.getcwd()); sys.argv = ['laws', 'list']\n"
        "from app.cli import main; main()"
    )
    gone = tmp_path / "gone"
    gone.mkdir()
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=gone, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "laws: the working folder is gone; change into another\n"


def test_new_knows_the_nearest_screen(tmp_path):
    code, _, err = laws("new", "reaction", folder=tmp_path)
    assert code == 2
    assert "did you mean 'reactions'?" in err
    assert files(tmp_path) == []


def test_list_names_what_a_scenario_can_use(tmp_path):
    code, out, _ = laws("list", folder=tmp_path)
    assert code == 0
    for name in ("force.toggle", "cart.a.finish_time", "particle.N.x", "body.restitution"):
        assert name in out
    for heading in ("steps\n  tap ", "  fields to fill\n    mass acceleration\n"):
        assert heading in out


def test_list_as_json(tmp_path):
    everything = json.loads(laws("list", "--json", folder=tmp_path)[1])
    assert [screen["id"] for screen in everything["screens"]] == list(SCREENS)
    settings = {row["name"]: row for row in everything["screens"][0]["settings"]}
    assert settings["body.mass"]["unit"] == "kg"
    assert {row["screen"] for row in everything["scenarios"]} == set(SCREENS)
    assert {"tap", "wait", "repeat"} <= {row["name"] for row in everything["steps"]}


def test_schema_is_json_schema(tmp_path):
    schema = json.loads(laws("schema", folder=tmp_path)[1])
    assert schema["$schema"] == "http://json-schema.org/draft-07/schema#"


def test_doctor_finds_this_installation_well(tmp_path):
    code, out, err = laws("doctor", folder=tmp_path)
    assert (code, err) == (0, "")
    assert "ok    pygame-ce" in out
    assert "bad" not in out


def test_doctor_tells_that_pygame_hides_pygame_ce(tmp_path):
    twin = tmp_path / "site" / "pygame-2.6.1.dist-info"
    twin.mkdir(parents=True)
    (twin / "METADATA").write_text("Metadata-Version: 2.1\nName: pygame\nVersion: 2.6.1\n")
    path = str(tmp_path / "site")
    code, out, _ = laws("doctor", folder=tmp_path, PYTHONPATH=path)
    assert code == 2
    assert "python -m pip uninstall -y pygame pygame-ce" in out
    code, _, err = laws("demo", folder=tmp_path, PYTHONPATH=path)
    assert code == 2
    assert "python -m pip uninstall -y pygame pygame-ce" in err


BROKEN = """
import sys

class Gone:
    def find_spec(self, name, path=None, target=None):
        if name == "numpy":
            raise ModuleNotFoundError("No module named 'numpy'", name=name)

sys.meta_path.insert(0, Gone())
from app.cli import main
main()
"""
"""Runs `laws` as if the files of numpy were gone."""


@pytest.mark.parametrize("command", ["list", "doctor"])
def test_a_broken_installation_is_told_in_a_sentence(command, tmp_path):
    done = subprocess.run(
        [sys.executable, "-c", BROKEN, command],
        cwd=tmp_path, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 2
    said = (
        "laws: the installation is broken: No module named 'numpy'; 'laws doctor' says what to do"
        if command == "list"
        else "bad   numpy "
    )
    assert said in done.stdout + done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("command", [("--help",), ("check", "push.yaml"), ("list",)])
def test_nothing_heavy_is_imported_before_it_is_used(command, push, tmp_path):
    _, _, err = laws(*command, folder=tmp_path, interpreter=("-X", "importtime"))
    imported = {
        line.split("|")[2].strip().split(".")[0] for line in err.splitlines() if "|" in line
    }
    assert "typer" in imported
    assert imported.isdisjoint({"pygame", "av", "numba", "PIL", "rich"})


def test_checking_loads_only_what_the_file_needs(push, tmp_path):
    _, _, err = laws("check", "push.yaml", folder=tmp_path, interpreter=("-X", "importtime"))
    imported = {line.split("|")[2].strip() for line in err.splitlines() if "|" in line}
    assert {"engine.world", "screens.inertia"} <= imported
    unneeded = {
        "app.examination",
        "app.outputs",
        "app.render",
        "engine.bulk",
        "engine.kernels.tick",
        "engine.linkage",
        "engine.manifolds",
        "engine.plain",
        "engine.portable",
        "engine.saving",
        "engine.queries",
        "engine.shapes.division",
        "engine.shapes.seams",
        "hashlib",
        "screens.forces",
        "screens.kit.surface",
        "screens.reactions",
    }
    assert imported & unneeded == set()


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a disk that is always full")
@pytest.mark.parametrize("arguments", [("list",), ("list", "--json"), ("schema",)])
def test_a_result_that_cannot_be_written_is_no_riddle(arguments, tmp_path):
    with open("/dev/full", "w") as full:
        code, _, err = laws(*arguments, folder=tmp_path, stdout=full)
    assert (code, err) == (
        1,
        "laws: cannot write the result to standard output: the disk is full\n",
    )
