"""`laws warm`: compile the physics ahead, so that no world has to wait for it."""

import typer

from app.cli import streams
from app.cli.debugging import Debug


def warm(debug: Debug = False) -> None:
    """Compile the physics into machine code and keep it for all later runs.

    Worlds that are large or run for long do so by themselves, in the background; this does it now.
    It takes about a minute, and no time if it was done before. The results of a run are the
    same with machine code and without.

    \b
    Examples:
      laws warm
    """  # noqa: D301
    from app.installation import extra_command, installed
    from engine import jit

    if not jit.available():
        streams.say(f"laws warm: numba is not installed: {extra_command('fast')}")
        raise typer.Exit(2)
    try:
        folder = jit.folder()
    except ImportError as error:
        streams.say(f"laws warm: {error}")
        raise typer.Exit(2) from error
    if folder is None:
        streams.say(
            "laws warm: there is no folder to keep machine code in: set NUMBA_CACHE_DIR to one "
            "that can be written"
        )
        raise typer.Exit(2)
    if not jit.is_kept():
        streams.say("compiling the physics, which takes about a minute ...")
    jit.compiled()
    streams.result(f"machine code is ready in {folder} (numba {installed('numba')})")
