import pytest

from app.scenario.mistakes import Mistake, Place, ScenarioMistakes, nearest, quote, render, suggest


def test_the_format_is_that_of_compilers():
    place = Place("examples/push.yaml", 5, 5, 3, "  - tpa: [120, 300]")
    mistake = Mistake(place, "unknown-step", "unknown step 'tpa'", "did you mean 'tap'?")
    assert render(mistake) == (
        "examples/push.yaml:5:5: error[unknown-step]: unknown step 'tpa'\n"
        "    5 |   - tpa: [120, 300]\n"
        "      |     ^^^\n"
        "      = help: did you mean 'tap'?"
    )


def test_a_mistake_outside_files_has_no_line():
    mistake = Mistake(Place("--seed"), "out-of-range", "'seed' must be a whole number, not x")
    assert render(mistake) == "--seed: error[out-of-range]: 'seed' must be a whole number, not x"


@pytest.mark.parametrize(
    ("source", "column", "length", "lead", "carets"),
    [
        ("a: 力", 4, 1, "   ", "^^"),
        ("力: x", 4, 1, "    ", "^"),
        ("e\u0301: x", 5, 1, "   ", "^"),
        ("a:\tx", 4, 1, "  \t", "^"),
        ("a: x", 5, 1, "    ", "^"),
        ("a: x", 4, 99, "   ", "^"),
    ],
)
def test_the_caret_stands_below_what_it_shows(source, column, length, lead, carets):
    text = render(Mistake(Place("f", 1, column, length, source), "c", "s"))
    assert text.splitlines()[2] == f"      | {lead}{carets}"


def test_of_a_long_line_the_part_around_the_caret_is_shown():
    source = "x" * 500 + "HERE" + "y" * 500
    rows = render(Mistake(Place("f", 1, 501, 4, source), "c", "s")).splitlines()
    assert len(rows[1]) == 8 + 100
    assert rows[1][rows[2].index("^") :].startswith("HERE")
    assert rows[2].count("^") == 4


def test_nothing_that_a_terminal_obeys_is_printed():
    text = render(Mistake(Place("f", 1, 1, 1, "\x1b[31m\x9b"), "c", f"{quote(chr(27) + 'x')}"))
    assert "\x1b" not in text
    assert "\x9b" not in text


def test_mistakes_are_sorted_by_place_those_of_the_named_file_first_and_told_once():
    def at(path, line, column):
        return Mistake(Place(path, line, column), "c", "s")

    told = ScenarioMistakes(
        [at("a", 1, 1), at("m", 9, 1), at("m", 2, 8), at("m", 2, 3), at("a", 1, 1)], first="m"
    )
    places = [(m.place.path, m.place.line, m.place.column) for m in told.mistakes]
    assert places == [("m", 2, 3), ("m", 2, 8), ("m", 9, 1), ("a", 1, 1)]


def test_of_very_many_mistakes_the_first_hundred_are_printed():
    told = ScenarioMistakes([Mistake(Place("f", line, 1), "c", "s") for line in range(1, 1001)])
    assert len(told.mistakes) == 1000
    assert str(told).count("error[") == 100
    assert str(told).endswith("... and 900 more mistakes")


def test_the_nearest_word():
    steps = ("tap", "drag", "fill", "wait", "until", "expect")
    assert nearest("tpa", steps) == "tap"
    assert nearest("Wait", steps) == "wait"
    assert nearest("sleep", steps) == "wait"
    assert nearest("xyzzy", steps) is None
    assert suggest("xyzzy", steps) == "known here: tap, drag, fill, wait, until, expect"
    assert suggest("q", [f"word{i}" for i in range(50)]) == "'laws list' shows all that there are"
