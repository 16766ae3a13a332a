import json
import signal
import time

import pytest
from command_line import PUSH, files, laws, start

LONG = PUSH.replace("fps: 10", "fps: 60").replace("  - wait: 0.5s\n", "  - wait: 600s\n", 1)
"""Ten minutes of film: long enough to be stopped in the middle."""
STOPPED = [(signal.SIGHUP, 129), (signal.SIGINT, 130), (signal.SIGTERM, 143)]


@pytest.fixture
def push(tmp_path):
    path = tmp_path / "push.yaml"
    path.write_text(PUSH, encoding="utf-8")
    return path


def test_all_outputs_from_one_pass(push, tmp_path):
    names = ["a.mp4", "a.webm", "a.gif", "a.apng", "a.webp", "a.csv", "a.json"]
    options = [part for name in [*names, "frames/"] for part in ("-o", name)]
    code, out, err = laws("render", push, *options, folder=tmp_path)
    assert (code, err) == (0, "")
    assert sorted(out.split()) == sorted([*names, "frames/"])
    made = [f"frames/frame-{n:05d}.png" for n in range(1, 12)]
    assert files(tmp_path) == sorted([*names, *made, "push.yaml"])
    report = json.loads((tmp_path / "a.json").read_text(encoding="utf-8"))
    assert report["frames"] == 11
    assert len(report["outputs"]) == 7
    assert report["expects"][0]["passed"] is True


def test_without_an_output_the_film_gets_the_files_name(push, tmp_path):
    code, out, _ = laws("render", push, folder=tmp_path)
    assert (code, out) == (0, "out/push.mp4\n")
    assert (tmp_path / "out/push.mp4").stat().st_size > 1000


def test_options_replace_what_the_file_says(push, tmp_path):
    options = ("--seed", "9", "--size", "90x160", "--fps", "30", "--set", "body.mass=4")
    code, _, err = laws("render", push, "-o", "a.json", *options, folder=tmp_path)
    report = json.loads((tmp_path / "a.json").read_text(encoding="utf-8"))
    assert (report["seed"], report["size"], report["fps"]) == (9, [90, 160], 30)
    assert report["set"]["body.mass"] == 4
    # Twice the mass, half the speed: the expectation fails, and the report is there all the same.
    assert code == 1
    assert "push.yaml:14:5: error[expect-failed]: body.speed should be near 0.75" in err
    assert "it is 0.375" in err
    assert "the outputs were written all the same" in err
    assert report["expects"][0]["passed"] is False
    assert report["expects"][0]["actual"] == pytest.approx(0.375, rel=1e-9)


def test_json_lines_tell_what_happens(push, tmp_path):
    code, out, _ = laws("render", push, "-o", "a.gif", "--json", folder=tmp_path)
    told = [json.loads(line) for line in out.splitlines()]
    assert code == 0
    assert [line["event"] for line in told] == [
        "start", "caption", "expect", "progress", "output", "end",
    ]  # fmt: skip
    assert told[0]["frames"] == 11
    assert told[-2]["path"] == "a.gif"
    assert told[-1]["code"] == 0


def test_an_until_that_never_holds_leaves_what_was_there(push, tmp_path):
    push.write_text(PUSH + "  - until: {probe: body.speed, above: 9, within: 1s}\n")
    (tmp_path / "a.gif").write_bytes(b"the old one")
    code, out, err = laws("render", push, "-o", "a.gif", "-o", "a.csv", folder=tmp_path)
    assert (code, out) == (1, "")
    assert "push.yaml:16:5: error[until-failed]: body.speed did not come above 9 within 1 s" in err
    assert "it is 0.75 now" in err
    assert (tmp_path / "a.gif").read_bytes() == b"the old one"
    assert files(tmp_path) == ["a.gif", "push.yaml"]


def test_nothing_is_drawn_if_one_of_the_files_is_wrong(push, tmp_path):
    (tmp_path / "wrong.yaml").write_text(PUSH.replace("inertia", "inertai"))
    code, out, err = laws("render", push, "wrong.yaml", folder=tmp_path)
    assert (code, out) == (2, "")
    assert "did you mean 'inertia'?" in err
    assert files(tmp_path) == ["push.yaml", "wrong.yaml"]


def test_a_run_that_fails_does_not_stop_the_others(push, tmp_path):
    never = "  - until: {probe: body.x, above: 99, within: 0.1s}\n"
    (tmp_path / "never.yaml").write_text(PUSH + never)
    code, out, err = laws("render", "never.yaml", push, folder=tmp_path)
    assert (code, out) == (1, "out/push.mp4\n")
    assert "until-failed" in err
    assert files(tmp_path) == ["never.yaml", "out/push.mp4", "push.yaml"]


def test_two_files_may_not_write_the_same(push, tmp_path):
    other = tmp_path / "other.yaml"
    other.write_text(PUSH + "output: out/push.mp4\n")
    code, _, err = laws("render", push, other, folder=tmp_path)
    assert code == 2
    assert f"'out/push.mp4' would be written by {push} and by {other}" in err
    assert laws("render", push, other, "-o", "a.gif", folder=tmp_path)[0] == 2


def test_every_clash_of_several_files_is_told(push, tmp_path):
    push.write_text(PUSH + "  - screenshot: shot.png\n")
    code, out, err = laws("render", push, push, folder=tmp_path)
    assert (code, out) == (2, "")
    assert "'out/push.mp4' would be written by" in err
    assert "'shot.png' would be written by" in err
    assert files(tmp_path) == ["push.yaml"]


def test_no_output_replaces_a_scenario(tmp_path):
    """YAML can be written as JSON, and reports end in .json too."""
    mine = tmp_path / "mine.json"
    mine.write_text("{laws: 1, screen: inertia, output: mine.json, steps: [{wait: 1s}]}")
    words = mine.read_text()
    code, _, err = laws("render", "mine.json", folder=tmp_path)
    assert (code, err) == (2, "laws: 'mine.json' would be written over a scenario\n")
    assert mine.read_text() == words


def test_a_failed_until_does_not_hide_what_failed_before(push, tmp_path):
    push.write_text(
        PUSH.replace("near: 0.75", "near: 3")
        + "  - until: {probe: body.speed, above: 9, within: 0.1s}\n"
    )
    code, _, err = laws("render", push, "-o", "a.csv", folder=tmp_path)
    assert code == 1
    assert "push.yaml:14:5: error[expect-failed]: body.speed should be near 3" in err
    assert "push.yaml:16:5: error[until-failed]" in err
    assert "2 mistakes in 1 file" in err


def test_a_place_that_cannot_be_written_to_is_found_before_the_first_frame(push, tmp_path):
    (tmp_path / "file").write_text("")
    begun = time.monotonic()
    push.write_text(LONG)
    code, out, err = laws("render", push, "-o", "a.csv", "-o", "file/a.gif", folder=tmp_path)
    assert (code, out) == (1, "")
    assert err.startswith("laws: cannot write file/a.gif: ")
    assert time.monotonic() - begun < 60
    assert files(tmp_path) == ["file", "push.yaml"]


def test_a_film_without_a_frame_is_refused(push, tmp_path):
    push.write_text(PUSH.replace("  - caption: A push.", "  - hide"))
    code, _, err = laws("render", push, "-o", "a.gif", folder=tmp_path)
    assert code == 1
    assert "no frames" in err
    assert files(tmp_path) == ["push.yaml"]


@pytest.mark.parametrize(("number", "code"), STOPPED)
def test_stopping_leaves_no_file(number, code, push, tmp_path):
    push.write_text(LONG)
    (tmp_path / "a.gif").write_bytes(b"the old one")
    outputs = ("a.gif", "a.mp4", "a.apng", "a.csv", "a.json", "frames/")
    options = [part for name in outputs for part in ("-o", name)]
    run = start("render", push, *options, "--json", folder=tmp_path)
    for line in run.stdout:
        if b'"progress"' in line:
            break
    assert len(files(tmp_path)) > 2
    run.send_signal(number)
    begun = time.monotonic()
    _, err = run.communicate(timeout=30)
    assert run.returncode == code
    assert time.monotonic() - begun < 10
    assert files(tmp_path) == ["a.gif", "push.yaml"]
    assert (tmp_path / "a.gif").read_bytes() == b"the old one"
    assert b"Traceback" not in err


def test_the_film_is_made_though_nobody_reads_stdout(push, tmp_path):
    run = start("render", push, "-o", "a.gif", "--json", folder=tmp_path)
    with run.stderr as errors:
        run.stdout.close()
        err = errors.read()
    assert (run.wait(timeout=60), err) == (0, b"")
    assert files(tmp_path) == ["a.gif", "push.yaml"]


def test_works_without_home_without_assertions_and_in_any_locale(push, tmp_path):
    code, out, err = laws(
        "render", push, "-o", "a.gif", folder=tmp_path, interpreter=("-O",),
        HOME=None, LC_ALL="C", PYTHONUTF8="0", PYTHONIOENCODING=None,
    )  # fmt: skip
    assert (code, out, err) == (0, "a.gif\n", "")


def test_works_from_a_folder_that_cannot_be_written_to(push, tmp_path):
    locked = tmp_path / "locked"
    locked.mkdir(mode=0o500)
    code, _, err = laws("render", push, "-o", tmp_path / "a.gif", folder=locked)
    assert (code, err) == (0, "")


def test_a_failed_until_leaves_no_screenshot_either(push, tmp_path):
    push.write_text(
        PUSH
        + """\
  - screenshot: old.png
  - screenshot: new.png
  - until: {probe: body.speed, above: 100, within: 0.1s}
"""
    )
    (tmp_path / "old.png").write_bytes(b"the old one")
    code, out, err = laws("render", push, "-o", "a.gif", folder=tmp_path)
    assert (code, out) == (1, "")
    assert "error[until-failed]" in err
    assert files(tmp_path) == ["old.png", "push.yaml"]
    assert (tmp_path / "old.png").read_bytes() == b"the old one"


def test_a_path_through_a_folder_that_is_not_there_is_simplified(push, tmp_path):
    code, out, err = laws("render", push, "-o", "new/../a.csv", folder=tmp_path)
    assert (code, out, err) == (0, "new/../a.csv\n", "")
    assert files(tmp_path) == ["a.csv", "push.yaml"]
