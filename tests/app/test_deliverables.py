import json

import numpy as np
import pytest

from app.deliverables import Deliverables, NotBegun, described
from app.frames import Film, Frame
from app.outputs import OutputError
from app.report import Report
from app.scenario.model import Scenario
from app.watcher import Watcher

FILM = Film(4, 2, 10, "Test")


def report(frames):
    made = Report(Scenario("p.yaml", 1, "inertia", "", "", 7, "en", (4, 2), 10, (), {}, ()))
    made.frames = frames
    return made


def picture(number):
    return np.full((2, 4), number, np.uint32)


def everything_in(folder):
    return sorted(path.name for path in folder.iterdir())


def test_whatever_cannot_be_begun_leaves_nothing_of_the_others(tmp_path):
    (tmp_path / "file").write_text("")
    paths = [str(tmp_path / name) for name in ("a.csv", "a.json", "a.gif", "file/b.gif")]
    with pytest.raises(NotBegun, match=r"cannot write .*file/b\.gif"):
        Deliverables(paths, [], FILM)
    assert everything_in(tmp_path) == ["file"]


def test_a_screenshot_that_has_no_place_is_found_at_the_start(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(NotBegun, match=r"file/shot\.png"):
        Deliverables([str(tmp_path / "a.gif")], [str(tmp_path / "file/shot.png")], FILM)
    assert everything_in(tmp_path) == ["file"]


def test_what_is_not_finished_is_put_away(tmp_path):
    with Deliverables([str(tmp_path / "a.gif")], [], FILM) as made:
        made.films[0].frame(Frame(0, picture(1)))
        assert len(everything_in(tmp_path)) == 1
    assert everything_in(tmp_path) == []


@pytest.mark.parametrize("names", [("a.gif", "a.csv", "a.json"), ("a.json", "a.csv", "a.gif")])
def test_folders_that_were_made_for_them_are_put_away_too(names, tmp_path):
    with Deliverables([str(tmp_path / "new/deep" / name) for name in names], [], FILM) as made:
        made.picture(str(tmp_path / "new/shot.png"), picture(1))
    assert everything_in(tmp_path) == []


def test_a_report_names_the_files_beside_it_wherever_they_are(tmp_path):
    texts = []
    for name in ("here", "there"):
        folder = tmp_path / name
        paths = [f"{folder}/{part}" for part in ("a.json", "films/a.gif", "films/frames/")]
        with Deliverables(paths, [], FILM) as made:
            for film in made.films:
                film.frame(Frame(0, picture(1)))
                film.frame(Frame(1, picture(2)))
            outputs = made.finish(report(2), [], Watcher())
        texts.append((folder / "a.json").read_text(encoding="utf-8"))
        assert [output.path for output in outputs] == [*paths[1:], paths[0]]
    assert texts[0] == texts[1]
    rows = json.loads(texts[0])["outputs"]
    assert [row["path"] for row in rows] == ["films/a.gif", "films/frames/"]
    assert [row["frames"] for row in rows] == [2, 2]


def test_an_output_is_described_by_its_bytes(tmp_path):
    path = tmp_path / "a.csv"
    path.write_bytes(b"abc")
    # The digest of "abc" is the first example of FIPS 180-2, appendix B.
    known = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
    output = described(str(path), 5, 10)
    assert (output.kind, output.size, output.sha256, output.frames) == ("csv", 3, known, None)


def test_the_films_before_a_failure_are_whole(tmp_path, monkeypatch):
    paths = [str(tmp_path / "a.gif"), str(tmp_path / "b.gif")]

    def fail():
        raise OutputError(paths[1], "the disk is full")

    with Deliverables(paths, [], FILM) as made:
        for film in made.films:
            film.frame(Frame(0, picture(1)))
        monkeypatch.setattr(made.films[1], "close", fail)
        with pytest.raises(OutputError):
            made.finish(report(1), [], Watcher())
    assert everything_in(tmp_path) == ["a.gif"]
