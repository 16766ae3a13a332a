"""The program `laws` and its commands."""

from typing import Annotated

import typer

from app.cli.check import check
from app.cli.demo import demo
from app.cli.doctor import doctor
from app.cli.listing import list_names
from app.cli.new import new
from app.cli.render import render
from app.cli.schema import schema
from app.cli.warm import warm

laws = typer.Typer(
    name="laws",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
)

laws.command("demo", short_help="Three films, one for each of Newton's laws.")(demo)
laws.command("render", short_help="Films, pictures and data from scenario files.")(render)
laws.command("check", short_help="Every mistake in scenario files, at once.")(check)
laws.command("new", short_help="A commented scenario to start from.")(new)
laws.command("list", short_help="All names: screens, widgets, probes, settings.")(list_names)
laws.command("schema", short_help="The JSON Schema of scenario files.")(schema)
laws.command("warm", short_help="Compile the physics ahead.")(warm)
laws.command("doctor", short_help="Is everything installed, and what if not?")(doctor)


def _show_version(wanted: bool) -> None:
    if wanted:
        from app.cli import streams
        from app.installation import own_version

        streams.result(f"laws {own_version()}")
        raise typer.Exit


@laws.callback()
def options(
    version: Annotated[
        bool,
        typer.Option("--version", callback=_show_version, is_eager=True, help="Show the version."),
    ] = False,
    debug: Annotated[bool, typer.Option("--debug", help="Show tracebacks.")] = False,
) -> None:
    """Recorded, reproducible demonstrations of Newton's laws.

    A short text file in; a film, pictures and the numbers behind them out.

    \b
    Start here:
      laws demo                     three films, one for each law, into ./out
      laws new inertia -o my.yaml   a commented scenario of your own
      laws check my.yaml            every mistake in it at once
      laws render my.yaml           its films, pictures and data

    Exit codes: 0 done; 1 an expectation failed or an output could not be written; 2 bad usage, a
    bad scenario or a broken installation; 130 stopped by Ctrl-C.
    """  # noqa: D301
