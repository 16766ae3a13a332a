"""Which kernels a world runs on: as Python reads them, or compiled by numba (see `jit`).

Compiled and interpreted ones give the same bits, so a world may change from one to the other
between any two ticks.
"""

import os
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

from engine.settings import Laws
from engine.tables import Tables
from engine.validate import shown

MODES = ("auto", "interpreted", "compiled")

VARIABLE = "LAWS_KERNELS"
"""Environment variable that decides for worlds that are made with kernels="auto"."""

Run = Callable[[float, int], int]
"""Takes a length of tick (s) and a number of ticks, and works on the tables that it is bound to;
see `tick.run` for what it returns."""


class Kernels(NamedTuple):
    """What a world runs on."""

    compiled: bool
    bind: Callable[[Tables, Laws], Run]
    """Makes `tick.run` ready to work on these tables under these laws."""


def bind_interpreted(tables: Tables, laws: Laws) -> Run:
    """Let Python run the kernels, which are loaded when the first world moves."""
    from engine.kernels import tick

    return partial(tick.run, tables, laws)


INTERPRETED = Kernels(False, bind_interpreted)


def resolve(mode: str) -> str:
    """Say what a world that was made with `mode` runs on: one of `MODES`.

    Raises:
        ValueError: if the mode, or the one that the environment names, is not known.
    """
    origin = "kernels"
    if isinstance(mode, str) and mode == "auto":
        mode, origin = os.environ.get(VARIABLE, "auto") or "auto", VARIABLE
    if not isinstance(mode, str) or mode not in MODES:
        raise ValueError(f"{origin} must be one of {', '.join(MODES)}, not {shown(mode)}")
    return mode
