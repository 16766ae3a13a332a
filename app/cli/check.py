"""`laws check`: every mistake in scenario files, without drawing anything."""

from typing import Annotated

import typer

from app.cli import streams
from app.cli.debugging import Debug


def check(
    files: Annotated[list[str], typer.Argument(metavar="FILE...", help="Scenario files.")],
    debug: Debug = False,
) -> None:
    """Find every mistake in scenario files, without drawing anything.

    Reads each file, then rehearses its taps on the real screens: a tap on a button that is not
    there is found before a minute of film is drawn.

    \b
    Examples:
      laws check my.yaml
      laws check scenarios/*.yaml
    """  # noqa: D301
    from app.cli.loading import count, load_all, show

    _, mistakes = load_all(files)
    if mistakes:
        show(mistakes)
        raise typer.Exit(2)
    streams.result(f"{count(len(files), 'file')} checked, no mistakes")
