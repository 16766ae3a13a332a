"""Prints the tables of docs/scenario.md that are made from the lessons.

Run `python tests/app/scenario/reference.py` and paste what it prints.
"""

import sys

from app.scenario.catalogue import SCREENS, of_screen
from screens.lesson import Setting


def tables() -> str:
    """A part for each screen: its widgets, probes and settings."""
    shared = [name for name in of_screen(SCREENS[0]).probes if is_shared(name)]
    parts = [f"All screens have the probes {listed(shared)}."]
    for screen in SCREENS:
        names = of_screen(screen)
        own = [name for name in names.probes if name not in shared]
        parts += [
            f"### `{screen}`",
            f"Widgets: {listed(names.widgets)}.",
            f"Probes: {listed(own)}.",
            "| setting | range | if not given | what |\n| --- | --- | --- | --- |\n"
            + "\n".join(row(name, setting) for name, setting in names.settings.items()),
        ]
        if names.fields:
            parts.insert(-1, f"Fields for `fill`: {listed(names.fields)}.")
    return "\n\n".join(parts)


def is_shared(probe: str) -> bool:
    return all(probe in of_screen(screen).probes for screen in SCREENS)


def listed(names) -> str:
    return " ".join(f"`{name}`" for name in names)


def row(name: str, setting: Setting) -> str:
    unit = f" {setting.unit}" if setting.unit else ""
    whole = ", whole" if setting.whole else ""
    default = "from the seed" if setting.default is None else f"{setting.default:g}{unit}"
    span = f"{setting.low:g} to {setting.high:g}{unit}{whole}"
    return f"| `{name}` | {span} | {default} | {setting.about} |"


if __name__ == "__main__":
    sys.stdout.write(tables() + "\n")
