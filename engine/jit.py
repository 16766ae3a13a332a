"""Compiles the kernels by numba, or loads what was compiled before.

Kernels are plain functions. This module and `pointers`, which is imported only to compile, are all
that knows of numba. It keeps machine code in its cache; the key holds a hash of all kernel sources,
because numba itself notices only edits of the outermost function's file. Worlds that run
interpreted do not import it (see `modes`).
"""

import hashlib
import importlib
import importlib.util
import inspect
import platform
import sys
from functools import cache
from pathlib import Path
from typing import Any

from engine import machine_code
from engine.modes import Kernels

LAYOUT = (
    "jit",
    "pointers",
    "settings",
    "tables.columns",
    "tables.bodies",
    "tables.pairs",
    "tables.lanes",
    "tables.limbs",
    "tables.linkage",
    "tables.world",
)
"""Modules that machine code depends on besides: what tables and laws look like."""

SOURCES = (
    "kernels.accelerate",
    "kernels.aftermath",
    "kernels.agenda",
    "kernels.bearing",
    "kernels.books",
    "kernels.broadphase",
    "kernels.circles",
    "kernels.complementarity",
    "kernels.contacts",
    "kernels.crowds",
    "kernels.curves",
    "kernels.elementary",
    "kernels.escaping",
    "kernels.exchange",
    "kernels.fields",
    "kernels.following",
    "kernels.footprint",
    "kernels.gaining",
    "kernels.gathering",
    "kernels.halting",
    "kernels.handing",
    "kernels.impacts",
    "kernels.impulses",
    "kernels.joined_impacts",
    "kernels.islands",
    "kernels.lever_arms",
    "linkage.acting",
    "linkage.answers",
    "linkage.closing",
    "linkage.geometry",
    "linkage.impulses",
    "linkage.jolts",
    "linkage.limb_groups",
    "linkage.limb_guesses",
    "linkage.limb_impacts",
    "linkage.limb_impulses",
    "linkage.limb_gaps",
    "linkage.limb_motion",
    "linkage.limb_sweeps",
    "linkage.limb_velocities",
    "linkage.limbs",
    "linkage.delassus",
    "linkage.loaded",
    "linkage.modes",
    "linkage.moments",
    "linkage.pace",
    "linkage.throwing",
    "linkage.positions",
    "linkage.seeking",
    "linkage.skyline",
    "linkage.springs",
    "linkage.stalling",
    "linkage.tally",
    "linkage.velocities",
    "manifolds.any_pair",
    "manifolds.hull_hull",
    "manifolds.link",
    "manifolds.pressed",
    "manifolds.round_hull",
    "manifolds.round_round",
    "manifolds.seam",
    "kernels.searching",
    "kernels.meeting",
    "kernels.moments",
    "kernels.neighbours",
    "kernels.owing",
    "kernels.packing",
    "kernels.pairing",
    "kernels.parting",
    "kernels.pose",
    "kernels.resting",
    "kernels.rousing",
    "kernels.rubbing",
    "kernels.sensing",
    "kernels.simultaneous",
    "kernels.sleeping",
    "kernels.spring",
    "kernels.standing",
    "kernels.riding",
    "kernels.steady",
    "kernels.struck",
    "kernels.sticking",
    "kernels.sweeps",
    "kernels.swinging",
    "kernels.touches",
    "kernels.travel",
    "kernels.tick",
)
"""Modules whose functions are kernels."""


def available() -> bool:
    """Whether numba is installed."""
    return importlib.util.find_spec("numba") is not None


@cache
def key() -> str:
    """Tells apart machine code of other sources, versions and machines."""
    digest = hashlib.sha256()
    for name in (*SOURCES, *LAYOUT):
        source = importlib.util.find_spec(f"engine.{name}")
        if source is not None and source.origin is not None:
            digest.update(Path(source.origin).read_bytes())
    metadata = importlib.import_module("importlib.metadata")  # worlds that start need none of it
    versions = [metadata.version(name) for name in ("numba", "numpy")]
    for part in (*versions, sys.version, platform.machine(), platform.node()):
        digest.update(part.encode())
    return digest.hexdigest()


def is_ready() -> bool:
    """Whether machine code stands beside the sources; false where it is kept elsewhere."""
    return available() and machine_code.is_marked(machine_code.BESIDE, key())


def folder() -> Path | None:
    """Where machine code is kept; None if there is no folder that can be written.

    Raises:
        ImportError: if numba is not installed, or broken.
    """
    return _outermost()[1]


def is_kept() -> bool:
    """Whether machine code can be loaded from where it is kept.

    Raises:
        ImportError: if numba is not installed, or broken.
    """
    kept_in = folder()
    return kept_in is not None and machine_code.is_marked(kept_in, key())


@cache
def compiled() -> Kernels:
    """Compile the kernels, or load them from numba's cache.

    Where no folder can be written they are compiled for this process alone.

    Raises:
        ImportError: if numba is not installed, or broken.
    """
    kernel, kept_in = _outermost()
    if kept_in is None:
        return Kernels(True, _pointers().compile_now(kernel))
    with machine_code.alone(kept_in):
        bind = _pointers().compile_now(kernel)
        machine_code.mark(kept_in, key())
    return Kernels(True, bind)


@cache
def _outermost() -> tuple[Any, Path | None]:
    """The function that will be compiled, and where its code is kept."""
    pointers = _pointers()
    for name in SOURCES:
        module = importlib.import_module(f"engine.{name}")
        for function in vars(module).values():
            if inspect.isfunction(function) and function.__module__ == module.__name__:
                pointers.let_kernels_call(function)
    kernel, folder = pointers.outermost(key())
    return kernel, None if folder is None else Path(folder)


def _pointers() -> Any:
    if not available():
        raise ImportError("compiled kernels need numba: pip install 'laws-of-motion[fast]'")
    importlib.import_module("engine.kernels.tick")  # what fails here is no fault of numba's
    try:
        return importlib.import_module("engine.pointers")
    except Exception as error:
        raise ImportError(
            f"numba is installed but does not work ({error}): pip install --force-reinstall numba"
        ) from error
