"""Whether this installation works, and what to do if not: what `laws doctor` looks at."""

import importlib
import os
import platform
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from tempfile import TemporaryFile
from typing import NamedTuple

from app.installation import DISTRIBUTION, extra_command, installed, own_version, pygame_trouble
from screens.kit.words import languages

NEEDED = {
    "numpy": "numpy",
    "pillow": "PIL.Image",
    "ruamel.yaml": "ruamel.yaml",
    "typer": "typer",
    "rich": "rich.progress",
}
"""Packages without which nothing works, besides pygame-ce; of each a module that is used."""


class Finding(NamedTuple):
    """One thing that was looked at."""

    state: str
    """`ok`; `note` if something optional is missing; `bad` if the program cannot work."""
    what: str
    """What was found, and what to do if it is not well."""


def findings() -> list[Finding]:
    """Look at everything, in the order in which it is told."""
    return [finding for look in LOOKS for finding in _told(look)]


def _told(look: Callable[[], Iterator[Finding]]) -> Iterator[Finding]:
    """What a look finds; if it needs a package that is not there, that."""
    try:
        yield from look()
    except ImportError as error:
        yield Finding("bad", f"{error}: install this package anew")


def _python() -> Iterator[Finding]:
    state = "ok" if sys.version_info >= (3, 11) else "bad"
    yield Finding(state, f"Python {platform.python_version()} on {platform.system()}, 3.11 needed")
    yield Finding("ok", f"{DISTRIBUTION} {own_version()} in {Path(__file__).parents[1]}")


def _packages() -> Iterator[Finding]:
    for name, module in NEEDED.items():
        version = installed(name)
        if version is None:
            yield Finding("bad", f"{name} is not installed: python -m pip install {name}")
            continue
        try:
            importlib.import_module(module)
        except ImportError as error:
            mend = f"python -m pip install --force-reinstall {name}"
            yield Finding("bad", f"{name} {version} does not work: {error}: {mend}")
        else:
            yield Finding("ok", f"{name} {version}")
    trouble = pygame_trouble()
    yield (
        Finding("ok", f"pygame-ce {installed('pygame-ce')}")
        if trouble is None
        else Finding("bad", trouble)
    )


def _extras() -> Iterator[Finding]:
    for extra, name, use in (
        ("video", "av", ".mp4 and .webm films"),
        ("fast", "numba", "compiled physics for large worlds"),
    ):
        version = installed(name)
        if version is None:
            yield Finding("note", f"{name} is not installed; for {use}: {extra_command(extra)}")
        else:
            yield Finding("ok", f"{name} {version}, for {use}")


def _kernels() -> Iterator[Finding]:
    """Say what worlds run on, and whether machine code is ready."""
    from engine import jit, modes

    try:
        mode = modes.resolve("auto")
    except ValueError as error:
        yield Finding("bad", f"{error}: unset it")
        return
    told = f", as {modes.VARIABLE} says" if os.environ.get(modes.VARIABLE) else ""
    yield Finding("ok", f"worlds run with kernels={mode!r}{told}")
    if not jit.available():
        return
    try:
        folder, ready = jit.folder(), jit.is_kept()
    except ImportError as error:
        yield Finding("bad" if mode == "compiled" else "note", str(error))
        return
    if folder is None:
        yield Finding("note", "no folder can keep machine code: set NUMBA_CACHE_DIR to one")
    elif ready:
        yield Finding("ok", f"machine code is ready in {folder}")
    else:
        yield Finding("note", f"machine code is not ready in {folder}: laws warm")


def _drawing() -> Iterator[Finding]:
    """Draw a word, which needs pygame and the fonts."""
    if pygame_trouble() is not None:
        return
    try:
        from screens.kit import theme
        from screens.kit.surface import Surface

        surface = Surface(360, 640)
        surface.text("F = m a", surface.size and (16, 16), theme.TITLE, theme.TEXT)
    except (ImportError, OSError, RuntimeError) as error:
        yield Finding(
            "bad", f"drawing does not work: {error}; reinstall pygame-ce and this package"
        )
    else:
        yield Finding("ok", "draws words with its own fonts, without a display")


def _words() -> Iterator[Finding]:
    yield Finding("ok", f"languages: {', '.join(languages())}")


def _folder() -> Iterator[Finding]:
    try:
        with TemporaryFile(dir=os.curdir):
            yield Finding("ok", f"can write here, in {Path.cwd()}")
    except OSError as error:
        reason = error.strerror or str(error)
        yield Finding("note", f"cannot write in this folder ({reason}): name outputs elsewhere")


LOOKS: tuple[Callable[[], Iterator[Finding]], ...] = (
    _python,
    _packages,
    _extras,
    _kernels,
    _drawing,
    _words,
    _folder,
)
