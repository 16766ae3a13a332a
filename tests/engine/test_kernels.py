"""Kernels are written so that compiled and interpreted ones give the same bits on every machine."""

import ast
import importlib
import inspect
from collections.abc import Iterator

import pytest

from engine import World
from engine.jit import SOURCES, available

BANNED_CALLS = {"hypot", "min", "max", "pow", "fsum", "sum"} | {"sin", "cos", "tan", "atan2", "exp"}
"""Their rounding or their choice between equal floats may differ, or they hide an allocation; for
the others see `elementary`."""


def offences(source: str) -> Iterator[str]:
    """Name what a kernel must not do."""
    for function in ast.walk(ast.parse(source)):
        if not isinstance(function, ast.FunctionDef):
            continue
        for node in ast.walk(function):
            if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
                yield f"{function.name}: line {node.lineno}: **"
            if isinstance(node, ast.Raise | ast.Try):
                yield f"{function.name}: line {node.lineno}: an exception"
            if isinstance(node, ast.Call):
                name = getattr(node.func, "attr", getattr(node.func, "id", ""))
                if name in BANNED_CALLS:
                    yield f"{function.name}: line {node.lineno}: {name}"


@pytest.mark.parametrize("name", SOURCES)
def test_a_kernel_does_nothing_that_machines_do_differently(name: str) -> None:
    source = inspect.getsource(importlib.import_module(f"engine.{name}"))
    assert list(offences(source)) == []


def test_the_search_finds_what_it_looks_for() -> None:
    bad = "def f(x):\n  try:\n    return max(x ** 2, hypot(x, 1))\n  finally:\n    pass\n"
    assert len(list(offences(bad))) == 4


def test_interpreted_kernels_need_no_numba() -> None:
    assert World(kernels="interpreted").kernels == "interpreted"
    with pytest.raises(ValueError, match="kernels must be one of auto, interpreted, compiled"):
        World(kernels="fast")
    assert isinstance(available(), bool)
