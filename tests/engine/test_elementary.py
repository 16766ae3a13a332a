"""Elementary functions by sums and products: those of the library, to the same bits everywhere."""

import ast
import math
import os
import struct
import subprocess
import sys
from hashlib import sha256
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import engine
from engine import Vector
from engine.kernels.elementary import MANY_TURNS, cos_sin, exponential, turned

ROOT = Path(engine.__file__).parent.parent

BY_LIBRARIES = {
    *("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh"),
    *("exp", "exp2", "expm1", "log", "log2", "log10", "log1p", "pow", "cbrt"),
}
"""Functions whose last bit differs between C libraries, or between processors."""


@given(st.floats(-MANY_TURNS, MANY_TURNS))
def test_sine_and_cosine_are_those_of_the_library(angle: float) -> None:
    cos, sin = turned(angle)
    assert abs(cos - math.cos(angle)) <= 2.0 * math.ulp(math.cos(angle))
    assert abs(sin - math.sin(angle)) <= 2.0 * math.ulp(math.sin(angle))


@given(st.floats(-1e15, 1e15))
def test_of_many_turns_they_err_less_than_the_angle(angle: float) -> None:
    cos, sin = cos_sin(angle)
    error = math.ulp(angle) + 5e-16
    assert cos == pytest.approx(math.cos(angle), abs=error)
    assert sin == pytest.approx(math.sin(angle), abs=error)
    assert cos_sin(-angle) == (cos, -sin)


def test_no_turn_and_quarter_turns_are_as_exact_as_the_angle() -> None:
    assert turned(0.0) == (1.0, 0.0)
    for angle in (math.pi / 2, math.pi, -math.pi / 2, 2 * math.pi):
        assert turned(angle) == (math.cos(angle), math.sin(angle))


@given(st.floats(-800.0, 0.0))
def test_the_exponential_is_that_of_the_library(x: float) -> None:
    assert abs(exponential(x) - math.exp(x)) <= 2.0 * math.ulp(math.exp(x))


def test_what_is_too_small_for_a_number_is_zero() -> None:
    assert exponential(-1e300) == 0.0


@given(st.floats(-10.0, 10.0), st.floats(-10.0, 10.0))
def test_the_angle_of_a_vector_is_its_arctangent(x: float, y: float) -> None:
    angle = math.atan2(y + 0.0, x + 0.0)  # no sign of zero
    assert abs(Vector(x, y).angle - angle) <= 6.0 * math.ulp(angle)


@given(st.floats(0.1, 10.0), st.floats(-3.1, 3.1))
def test_a_vector_has_the_length_and_the_angle_it_was_made_with(
    length: float, angle: float
) -> None:
    vector = Vector.polar(length, angle)
    assert math.hypot(*vector) == pytest.approx(length, rel=1e-15)
    assert vector.angle == pytest.approx(angle, rel=2e-15, abs=1e-300)


def test_they_have_the_same_bits_on_every_machine() -> None:
    bits = sha256()
    for i in range(20_000):
        angle = (i * 7919 % 20_011 - 10_000) * (0.37 if i % 2 else 1.3e-4)
        vector = Vector(angle, (i * 104_729 % 10_007 - 5_000) / 64.0)
        bits.update(struct.pack("<4d", *cos_sin(angle), exponential(-abs(angle)), vector.angle))
    assert bits.hexdigest()[:16] == "c0f2fc2f84e89fc6"


def test_the_engine_asks_no_library_for_them() -> None:
    called = {
        node.attr
        for path in (ROOT / "engine").rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Attribute)
        and isinstance(node.value, ast.Name)
        and node.value.id == "math"
    }
    assert not called & BY_LIBRARIES


TUMBLING = """
from engine import Box, Pin, Polygon, Wall, World
world = World(gravity=(0, -9.81), kernels="interpreted")
world.add(Wall((-9, 0), (9, 0)), friction=0.5)
for i in range(4):
    world.add(Polygon.regular(3 + i, 0.4), position=(i, 1), angle=i, spin=i - 1, friction=0.5)
world.join(None, world.add(Box(1, 0.2), position=(-2, 3), angle=0.3), Pin(at=(-2.4, 3.2)))
world.run(90)
print(world.digest())
"""


def test_a_world_has_the_same_bits_where_the_library_may_not_use_all_of_the_processor() -> None:
    """Without fused instructions glibc's own sines differ in the last bit."""
    digests = [
        subprocess.run(
            [sys.executable, "-c", TUMBLING],
            env=os.environ | {"GLIBC_TUNABLES": tunables, "PYTHONPATH": str(ROOT)},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for tunables in ("", "glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2")
    ]
    assert digests[0] == digests[1] != ""
