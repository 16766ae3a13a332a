"""`laws new`: a commented scenario to start from."""

from pathlib import Path
from typing import Annotated

import typer

from app.cli import streams
from app.cli.debugging import Debug


def new(
    screen: Annotated[str, typer.Argument(help="inertia, forces or reactions.")],
    output: Annotated[
        str | None,
        typer.Option("-o", "--output", metavar="FILE", help="Where to; SCREEN.yaml if not given."),
    ] = None,
    debug: Debug = False,
) -> None:
    """Write a commented scenario that works, to change as you like.

    A file that is there already is left as it is.

    \b
    Examples:
      laws new inertia
      laws new reactions -o lessons/collisions.yaml
    """  # noqa: D301
    from app.outputs.promise import OutputError, promised
    from app.scenario.mistakes import suggest
    from assets import TEMPLATES

    known = tuple(sorted(path.stem for path in TEMPLATES.glob("*.yaml")))
    if screen not in known:
        streams.say(f"laws new: there is no screen '{screen}'; {suggest(screen, known)}")
        raise typer.Exit(2)
    target = Path(output or f"{screen}.yaml")
    words = (TEMPLATES / f"{screen}.yaml").read_text(encoding="utf-8")
    if target.exists():
        streams.say(f"laws new: '{target}' is there already; choose another name with -o")
        raise typer.Exit(2)
    try:
        with promised(target) as part:
            part.write_text(words, encoding="utf-8", newline="\n")
    except OutputError as error:
        streams.say(f"laws new: {error}")
        raise typer.Exit(1) from None
    streams.result(str(target))
    streams.say(f"next: laws render {target}")
