"""The program `laws` and its commands; the one that is asked for is loaded alone."""

import importlib
from collections.abc import Sequence
from typing import Annotated

import typer

from app.cli import streams
from app.cli.debugging import Debug

laws = typer.Typer(
    name="laws",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
)

COMMANDS = {
    "demo": ("app.cli.demo", "demo", "Three films, one for each of Newton's laws."),
    "render": ("app.cli.render", "render", "Films, pictures and data from scenario files."),
    "check": ("app.cli.check", "check", "Every mistake in scenario files, at once."),
    "new": ("app.cli.new", "new", "A commented scenario to start from."),
    "list": (
        "app.cli.listing",
        "list_names",
        "All names: widgets, probes, settings, steps and more.",
    ),
    "schema": ("app.cli.schema", "schema", "The JSON Schema of scenario files."),
    "warm": ("app.cli.warm", "warm", "Compile the physics ahead."),
    "doctor": ("app.cli.doctor", "doctor", "Is everything installed, and what if not?"),
}
"""Module, function and a few words for each command, in the order of the help."""


def with_commands_for(arguments: Sequence[str]) -> typer.Typer:
    """The program with the command that the arguments begin with; with all if it is none."""
    names = arguments[:1] if arguments and arguments[0] in COMMANDS else COMMANDS
    for name in names:
        module, function, words = COMMANDS[name]
        laws.command(name, short_help=words)(getattr(importlib.import_module(module), function))
    return laws


def _show_version(wanted: bool) -> None:
    if wanted:
        from app.installation import own_version

        streams.result(f"laws {own_version()}")
        raise typer.Exit


@laws.callback()
def options(
    version: Annotated[
        bool,
        typer.Option("--version", callback=_show_version, is_eager=True, help="Show the version."),
    ] = False,
    debug: Debug = False,
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
