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
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from engine import tick
from engine.broadphase import fit_boxes, sort, sweep

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
    "pose",
    "resting",
    "spring",
    "travel",
    "tick",
)
"""Modules whose functions are kernels."""


class Kernels(NamedTuple):
    """What a world calls; the signatures are those of the plain functions."""

    compiled: bool
    start: Callable[..., tuple[int, bool]]
    go: Callable[..., tuple[int, float]]
    finish: Callable[..., int]
    fit_boxes: Callable[..., None]
    sort: Callable[..., None]
    sweep: Callable[..., int]


INTERPRETED = Kernels(False, tick.start, tick.go, tick.finish, fit_boxes, sort, sweep)


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
    numba = importlib.import_module("numba")
    extending = importlib.import_module("numba.extending")
    digest = hashlib.sha256()
    for name in SOURCES:
        module = importlib.import_module(f"engine.{name}")
        digest.update(Path(inspect.getfile(module)).read_bytes())
        for function in vars(module).values():
            if inspect.isfunction(function) and function.__module__ == module.__name__:
                extending.register_jitable(error_model="numpy")(function)
    try:
        return _entries(
            numba.njit(cache=True, error_model="numpy", nogil=True, _nrt=False), digest.digest()
        )
    except RuntimeError:  # numba found no folder for its cache: compile for this process alone
        return _entries(numba.njit(error_model="numpy", nogil=True), digest.digest())


def _entries(compile_: Callable[[Any], Any], sources: bytes) -> Kernels:
    """Make the outermost compiled functions; `sources` is part of the key of their cache."""
    version = sources

    @compile_
    def start(t: Any, count: Any, pushes: Any, pushing: Any, laws: Any, dt: Any) -> Any:
        _ = version
        return tick.start(t, count, pushes, pushing, laws, dt)

    @compile_
    def go(t: Any, count: Any, pairs: Any, now: Any, dt: Any, substep: Any, limit: Any) -> Any:
        _ = version
        return tick.go(t, count, pairs, now, dt, substep, limit)

    @compile_
    def finish(t: Any, count: Any, pairs: Any, laws: Any, dt: Any) -> Any:
        _ = version
        return tick.finish(t, count, pairs, laws, dt)

    @compile_
    def boxes(t: Any, count: Any, dt: Any) -> Any:
        _ = version
        fit_boxes(t, count, dt)

    @compile_
    def order(pieces: Any, count: Any) -> Any:
        _ = version
        sort(pieces, count)

    @compile_
    def pairs(bodies: Any, pieces: Any, count: Any, a: Any, b: Any) -> Any:
        _ = version
        return sweep(bodies, pieces, count, a, b)

    return Kernels(True, start, go, finish, boxes, order, pairs)
