"""Vectors are added, multiplied and turned; they were joined end to end, as tuples are."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from engine import Circle, Vector, World


def test_vectors_are_added_and_multiplied() -> None:
    v, pair, listed = Vector(3.0, 4.0), (1, 2), [1, 2]
    assert v + pair == pair + v == listed + v == v + Vector(1, 2) == Vector(4, 6)  # type: ignore
    assert v - pair == -(pair - v) == Vector(2, 2)
    assert 2 * v == v * np.float64(2.0) == v / 0.5 == Vector(6, 8)
    assert v + np.array([1.0, 2.0]) == (4, 6)
    assert sum([v, v], Vector(0, 0)) == (6, 8)
    assert all(isinstance(each, Vector) for each in (v + pair, 2 * v, -v, v / 2, v - v))


def test_the_geometry_of_vectors() -> None:
    v = Vector(3.0, 4.0)
    assert (v.length, v.dot((1, 2)), v.cross((1, 2))) == (5.0, 11.0, 2.0)
    assert v.normalized() == (0.6, 0.8)
    assert Vector(0.0, 0.0).normalized() == (0, 0)
    assert v.rotated(math.pi / 2) == pytest.approx((-4, 3))


def test_places_are_moved_by_vectors() -> None:
    body = World().add(Circle(1), position=(1, 2), velocity=(4, 0))
    body.position += (1, 1)
    body.velocity *= 0.5
    assert (body.position, body.velocity) == ((2, 3), (2, 0))


THREE = (1, 2, 3)


@pytest.mark.parametrize(
    "call",
    [
        lambda v: v + 1, lambda v: v + THREE, lambda v: THREE[:1] + v, lambda v: v - "ab",
        lambda v: v * v, lambda v: "a" * v, lambda v: v * True, lambda v: v / None,
        lambda v: v.dot(3), lambda v: v.cross(None), lambda v: 2 - v,
    ],
)  # fmt: skip
def test_what_goes_with_no_vector_is_refused(call: Callable[[Vector], Any]) -> None:
    with pytest.raises(TypeError, match=r"a Vector (goes with|is multiplied)"):
        call(Vector(1, 2))
