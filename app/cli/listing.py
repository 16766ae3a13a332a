"""`laws list`: everything a scenario can name."""

import math
from typing import Annotated, Any

import typer

from app.cli import streams
from app.cli.debugging import Debug


def list_names(
    json: Annotated[bool, typer.Option("--json", help="As one JSON document.")] = False,
    debug: Debug = False,
) -> None:
    """List screens, their widgets, probes and settings, the steps, and the shipped scenarios.

    \b
    Examples:
      laws list
      laws list --json
    """  # noqa: D301
    from app.json_text import dumps

    everything = {"screens": _screens(), "steps": _steps(), "scenarios": _scenarios()}
    streams.result(dumps(everything) if json else _as_text(everything))


def _screens() -> list[dict[str, Any]]:
    from app.scenario.catalogue import SCREENS, of_screen

    return [
        {
            "id": screen,
            "widgets": list(of_screen(screen).widgets),
            "fields": list(of_screen(screen).fields),
            "probes": list(of_screen(screen).probes),
            "settings": [
                {
                    "name": name,
                    "low": setting.low,
                    "high": setting.high,
                    "default": setting.default,
                    "unit": setting.unit,
                    "whole": setting.whole,
                    "about": setting.about,
                }
                for name, setting in of_screen(screen).settings.items()
            ],
        }
        for screen in SCREENS
    ]


def _steps() -> list[dict[str, str]]:
    from app.scenario.schema import schema

    definitions: dict[str, dict[str, str]] = schema()["definitions"]
    return [
        {"name": name.removesuffix("-step"), "about": definition["description"]}
        for name, definition in definitions.items()
        if name.endswith("-step")
    ]


def _scenarios() -> list[dict[str, Any]]:
    from app.cli.loading import shipped
    from app.scenario.load import load

    scenarios = [load(str(path)) for path in shipped()]
    return [
        {
            "name": path.stem,
            "path": str(path),
            "screen": scenario.screen,
            "title": scenario.title,
            "alt": scenario.alt,
        }
        for path, scenario in zip(shipped(), scenarios, strict=True)
    ]


def _as_text(everything: dict[str, Any]) -> str:
    rows: list[str] = []
    for screen in everything["screens"]:
        rows += [f"screen {screen['id']}", "  widgets to tap or drag"]
        rows += _wrapped(screen["widgets"])
        if screen["fields"]:
            rows.append("  fields to fill")
            rows += _wrapped(screen["fields"])
        rows.append("  probes for expect and until")
        rows += _wrapped(screen["probes"])
        rows.append("  settings for set: and --set")
        rows += [f"    {_setting(setting)}" for setting in screen["settings"]]
        rows.append("")
    rows.append("steps")
    rows += [f"  {step['name']:<11} {step['about']}" for step in everything["steps"]]
    rows += ["", "shipped scenarios"]
    rows += [
        f"  {scenario['path']}\n      {scenario['title']}" for scenario in everything["scenarios"]
    ]
    return "\n".join(rows)


def _wrapped(names: list[str], width: int = 96) -> list[str]:
    rows = ["   "]
    for name in names:
        if len(rows[-1]) + 1 + len(name) > width:
            rows.append("   ")
        rows[-1] += f" {name}"
    return rows


def _setting(setting: dict[str, Any]) -> str:
    low, high = (_number(setting[end]) for end in ("low", "high"))
    unit = f" {setting['unit']}" if setting["unit"] else ""
    default = "from the seed" if setting["default"] is None else _number(setting["default"])
    allowed = f"{low} to {high}{unit}"
    return f"{setting['name']:<22} {allowed:<18} default {default:<14} {setting['about']}"


def _number(value: float) -> str:
    return "any" if math.isinf(value) else f"{value:g}"
