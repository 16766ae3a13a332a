"""The one place that knows of numba: it compiles the kernels, which are plain functions without it.

Compiled and interpreted kernels give the same bits, so a world may change from one to the other
between any two ticks. Machine code is kept in numba's cache; its key holds a hash of all kernel
sources, because numba itself notices only edits of the outermost function's file.
"""

import hashlib
import importlib
import importlib.util
import inspect
import os
from collections.abc import Callable
from functools import cache, partial
from pathlib import Path
from typing import NamedTuple

from engine import tick
from engine.settings import Laws
from engine.tables import Tables

MODES = ("auto", "interpreted", "compiled")

VARIABLE = "LAWS_KERNELS"
"""Environment variable that decides for worlds that are made with kernels="auto"."""

SOURCES = (
    "accelerate",
    "broadphase",
    "contacts",
    "fields",
    "following",
    "impacts",
    "manifolds.any_pair",
    "manifolds.hull_hull",
    "manifolds.round_hull",
    "manifolds.round_round",
    "meeting",
    "neighbours",
    "pairing",
    "pose",
    "resting",
    "spring",
    "travel",
    "tick",
)
"""Modules whose functions are kernels."""


Run = Callable[[float, int], int]
"""Takes a length of tick (s) and a number of ticks, and works on the tables that it is bound to;
see `tick.run` for what it returns."""


class Kernels(NamedTuple):
    """What a world runs on."""

    compiled: bool
    bind: Callable[[Tables, Laws], Run]
    """Makes `tick.run` ready to work on these tables under these laws."""


def bind_interpreted(tables: Tables, laws: Laws) -> Run:
    """Let Python run the kernels."""
    return partial(tick.run, tables, laws)


INTERPRETED = Kernels(False, bind_interpreted)


def choose(mode: str) -> Kernels:
    """Return the kernels for a world that was made with `mode`.

    Raises:
        ValueError: if the mode, or the one that the environment names, is not known.
        ImportError: if compiled kernels are asked for and numba is not installed.
    """
    origin = "kernels"
    if mode == "auto":
        mode, origin = os.environ.get(VARIABLE, "auto") or "auto", VARIABLE
    if mode not in MODES:
        raise ValueError(f"{origin} must be one of {', '.join(MODES)}, not {mode!r}")
    return compiled() if mode == "compiled" else INTERPRETED


def available() -> bool:
    """Whether numba is installed."""
    return importlib.util.find_spec("numba") is not None


@cache
def compiled() -> Kernels:
    """Compile the kernels, or load them from numba's cache.

    Raises:
        ImportError: if numba is not installed.
    """
    if not available():
        raise ImportError("compiled kernels need numba: pip install 'laws-of-motion[fast]'")
    pointers = importlib.import_module("engine.pointers")
    digest = hashlib.sha256()
    for name in (*SOURCES, "jit", "pointers", "settings", "tables"):
        digest.update(Path(inspect.getfile(importlib.import_module(f"engine.{name}"))).read_bytes())
    for name in SOURCES:
        module = importlib.import_module(f"engine.{name}")
        for function in vars(module).values():
            if inspect.isfunction(function) and function.__module__ == module.__name__:
                pointers.let_kernels_call(function)
    return Kernels(True, pointers.binder(digest.hexdigest()))
