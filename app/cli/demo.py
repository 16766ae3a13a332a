"""`laws demo`: one film for each of the three laws, with the numbers behind them."""

from typing import Annotated

import typer

from app.cli import streams
from app.cli.debugging import Debug

CHOSEN = (
    "inertia-rest-push-coast",
    "forces-same-force-two-masses",
    "reactions-head-on-swap",
)
"""One shipped scenario for each lesson."""


def demo(
    output: Annotated[
        str, typer.Option("-o", "--output", metavar="FOLDER", help="Where the files go.")
    ] = "out",
    quiet: Annotated[bool, typer.Option("-q", "--quiet", help="No progress bar.")] = False,
    debug: Debug = False,
) -> None:
    """Make three films that teach Newton's three laws, and the numbers behind them.

    For each law a film (.mp4, or .gif without the extra "video"), the tracks of all bodies (.csv)
    and a report with collisions and checks (.json). Needs no display, network or other program.

    \b
    Examples:
      laws demo
      laws demo -o films
    """  # noqa: D301
    from app.cli.production import DONE, attempt, ready
    from app.cli.progress import watching
    from app.installation import extra_command, installed
    from app.scenario.load import load
    from assets import SCENARIOS

    film = "mp4" if installed("av") is not None else "gif"
    code = DONE
    with watching(quiet=quiet, json=False) as watcher:
        if not ready(watcher):
            raise typer.Exit(2)
        for name in CHOSEN:
            scenario = load(str(SCENARIOS / f"{name}.yaml"))
            paths = tuple(f"{output}/{name}.{suffix}" for suffix in (film, "csv", "json"))
            result, made = attempt(scenario._replace(outputs=paths), watcher)
            code = max(code, result)
            if made is not None:
                streams.result(f"{scenario.title}\n    {scenario.alt}")
                for path in paths:
                    streams.result(f"    {path}")
    if film == "gif":
        streams.say(f"for .mp4 films: {extra_command('video')}")
    if code:
        raise typer.Exit(code)
