"""`laws render`: films, pictures and data from scenario files."""

from typing import Annotated

import typer

from app.cli import streams
from app.cli.debugging import Debug


def render(
    files: Annotated[list[str], typer.Argument(metavar="FILE...", help="Scenario files.")],
    output: Annotated[
        list[str] | None,
        typer.Option(
            "-o",
            "--output",
            metavar="PATH",
            help="Write this instead of the file's own outputs; may be given several times.",
        ),
    ] = None,
    seed: Annotated[str | None, typer.Option(metavar="N", help="Instead of the file's.")] = None,
    size: Annotated[str | None, typer.Option(metavar="WxH", help="In pixels.")] = None,
    fps: Annotated[str | None, typer.Option(metavar="N", help="60 30 20 15 12 or 10.")] = None,
    set: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="NAME=VALUE", help="A setting; may be given several times."),
    ] = None,
    json: Annotated[
        bool, typer.Option("--json", help="Tell what happens as JSON lines on stdout.")
    ] = False,
    quiet: Annotated[bool, typer.Option("-q", "--quiet", help="No progress bar.")] = False,
    debug: Debug = False,
) -> None:
    """Make the films, pictures and data that scenario files ask for.

    What is made goes by the suffix: .mp4 .webm .gif .apng .webp, a folder of PNG frames for a path
    that ends in /, .csv for tracks, .json for the report. A file that asks for nothing becomes
    out/NAME.mp4. Nothing is drawn if any of the files has a mistake; every output is whole, or not
    there. stdout gets the path of each output.

    \b
    Examples:
      laws render push.yaml
      laws render push.yaml -o push.gif -o push.csv --fps 30 --size 720x1280
      laws render push.yaml --set body.mass=4 --seed 3 -o heavy.mp4
      laws render lessons/*.yaml --json
    """  # noqa: D301
    from app.cli.production import produce
    from app.scenario.load import Overrides

    if output and len(files) > 1:
        streams.say("laws render: -o is for one file; the outputs of several would collide")
        raise typer.Exit(2)
    overrides = Overrides(seed, size, fps, tuple(output or ()), tuple(set or ()))
    code = produce(files, overrides, quiet=quiet, json=json)
    if code:
        raise typer.Exit(code)
