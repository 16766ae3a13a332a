import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.scenario.mistakes import Refused
from app.scenario.nodes import ListNode, MapNode, ScalarNode
from app.scenario.reading import LARGEST, read


def mistakes(content: bytes):
    try:
        _, told = read(content, "f.yaml")
    except Refused as refused:
        told = refused.mistakes
    return [(m.place.line, m.place.column, m.code) for m in told]


def test_every_node_knows_its_place():
    root = read(b"laws: 1\nsteps:\n  - tap: [1, 22]\n", "f.yaml")[0]
    assert isinstance(root, MapNode)
    (laws, one), (_, steps) = root.entries
    assert (laws.place.line, laws.place.column, laws.place.length) == (1, 1, 4)
    assert (one.place.line, one.place.column, one.place.length) == (1, 7, 1)
    assert isinstance(steps, ListNode)
    ((_, point),) = steps.items[0].entries
    assert (point.place.line, point.place.column) == (3, 10)
    second = point.items[1]
    assert (second.place.line, second.place.column, second.place.length) == (3, 14, 2)
    assert second.place.source == "  - tap: [1, 22]"


def test_a_byte_order_mark_is_no_part_of_the_text():
    root = read(b"\xef\xbb\xbflaws: 1\n", "f.yaml")[0]
    assert root.entries[0][0].text == "laws"
    assert root.entries[0][0].place.column == 1


def test_line_ends_of_all_systems_count_as_one_line():
    for end in ("\n", "\r\n", "\r"):
        root = read(f"a: 1{end}b: 2{end}".encode(), "f.yaml")[0]
        assert [key.place.line for key, _ in root.entries] == [1, 2]
        assert [key.place.source for key, _ in root.entries] == ["a: 1", "b: 2"]


# YAML 1.2.2, section 10.3.2 (core schema): which plain scalars are numbers, and which are words.
@pytest.mark.parametrize("text", ["0", "-12", "+3", "1.5", ".5", "1e-9", "-2E+3", ".inf", "-.INF"])
def test_numbers(text):
    assert ScalarNode(None, text, plain=True).is_number
    assert not ScalarNode(None, text, plain=False).is_number


@pytest.mark.parametrize("text", ["yes", "on", "no", "1_000", "0x10", "1:30", "1s", "e3", ".", "-"])
def test_words_that_other_versions_of_yaml_take_for_something_else(text):
    assert ScalarNode(None, text, plain=True).is_text


@pytest.mark.parametrize("text", ["", "~", "null"])
def test_nothing(text):
    assert ScalarNode(None, text, plain=True).is_nothing
    assert ScalarNode(None, text, plain=False).is_text


def test_the_first_byte_that_is_not_utf8_is_named_with_its_place():
    assert mistakes("a: é\nü: ".encode() + b"\xc3(") == [(2, 4, "not-utf8")]
    assert mistakes(b"\xff\xfea\0") == [(1, 1, "not-utf8")]


def test_a_large_file_is_refused_unread():
    assert mistakes(b"[" * (LARGEST + 1)) == [(1, 1, "too-large")]
    assert isinstance(read(b"a: " + b"x" * (LARGEST - 3), "f.yaml")[0], MapNode)


def test_32_levels_are_allowed_and_33_are_not():
    read(b"[" * 32 + b"]" * 32, "f.yaml")
    assert mistakes(b"[" * 33 + b"]" * 33) == [(1, 33, "too-deep")]
    assert mistakes(b"- " * 33 + b"x") == [(1, 65, "too-deep")]


def test_anchors_aliases_and_tags_are_told_together():
    content = b"a: &x 1\nb: *x\nc: *x\nd: !!str 2\ne: 1\ne: 2\n"
    assert mistakes(content) == [
        (1, 4, "anchor"),
        (2, 4, "alias"),
        (4, 4, "tag"),
        (6, 1, "duplicate-key"),
    ]


def test_tabs_in_the_indentation_are_all_told():
    assert isinstance(read(b'a: "x\ty"\n\nb: 2 # a\tnote\n', "f.yaml")[0], MapNode)
    assert mistakes(b"a: 1\t# note\n") == [(1, 5, "tab")]
    assert mistakes(b"a:\n\t- 1\n  \t- 2\n") == [(2, 1, "tab"), (3, 3, "tab")]


def test_what_stands_beside_them_is_read_all_the_same():
    root, told = read(b"%YAML 1.1\n---\na: &x 1\nb:\n\t- !!int 2\n", "f.yaml")
    assert [m.code for m in told] == ["directive", "tab", "anchor", "tag"]
    assert root.get("a").text == "1"
    assert root.get("b").items[0].text == "2"


def test_keys_taken_from_elsewhere_leave_nothing_to_examine():
    with pytest.raises(Refused):
        read(b"a: &x {b: 1}\nc: {<<: *x}\n", "f.yaml")


def test_directives_are_refused():
    assert mistakes(b"%YAML 1.1\n---\na: yes\n") == [(1, 1, "directive")]


@pytest.mark.parametrize(
    "content", [b"", b"\n\n", b"# only words\n", b"---\n", b"~", b"\xef\xbb\xbf"]
)
def test_empty(content):
    assert [code for _, _, code in mistakes(content)] == ["empty-file"]


def test_an_escape_for_no_character_has_a_place():
    assert mistakes(b'a: "x\\U00110000"\n') == [(1, 6, "syntax")]


SCRAPS = [
    *("- ", "a: ", "b", "\n", "  ", "[", "]", "{", "}", ",", ": ", "? ", '"', "'", "|", ">", "#"),
    *(" ", "&a ", "*a", "!", "!!str", "%YAML 1.2", "---", "...", "\\", "\t", "1", "é", "-", "<<"),
    *(
        "~",
        "\r",
        "\u2028",
        "@",
        "`",
        "\ufeff",
        "%",
        "!<x>",
        ">9",
        "|2",
        "\\U00110000",
        "\x85",
        "\0",
    ),
]


@given(st.lists(st.sampled_from(SCRAPS), max_size=30))
def test_scraps_of_yaml_are_read_or_refused(scraps):
    check("".join(scraps).encode())


@given(st.binary(max_size=60))
def test_any_bytes_are_read_or_refused(content):
    check(content)


def check(content: bytes):
    try:
        read(content, "f.yaml")
    except Refused as refused:
        lines = content.decode("utf-8", errors="replace").splitlines() or [""]
        for mistake in refused.mistakes:
            assert str(mistake).isprintable() or "\n" in str(mistake)
            assert 1 <= mistake.place.line <= len(lines) + 1


def test_random_bytes_of_a_fixed_seed_are_read_or_refused():
    dice = random.Random(7)
    for _ in range(300):
        check("".join(dice.choice(SCRAPS) for _ in range(dice.randrange(40))).encode())
