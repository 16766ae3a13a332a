import json
import math

from app.json_text import document, dumps


def test_numbers_are_finite_and_never_minus_zero():
    assert dumps([0.1, -0.0, math.nan, math.inf, 1]) == "[0.1, 0.0, null, null, 1]"
    assert "-0" not in dumps({"a": [-0.0, (-0.0,)]})


def test_keys_are_sorted_whatever_their_order():
    assert dumps({"b": 1, "a": {"d": 1, "c": 2}}) == dumps({"a": {"c": 2, "d": 1}, "b": 1})


def test_words_stay_readable():
    assert dumps("Newton’s √2") == '"Newton’s √2"'


def test_a_document_streams_its_lists():
    parts = {"rows": ({"n": n} for n in range(3)), "none": iter(()), "title": "t", "size": (1, 2)}
    pieces = list(document(parts))
    assert json.loads("".join(pieces)) == {
        "none": [],
        "rows": [{"n": 0}, {"n": 1}, {"n": 2}],
        "size": [1, 2],
        "title": "t",
    }
    assert max(len(piece) for piece in pieces) < 40
