"""`laws doctor`: whether this installation works, and what to do if not."""

import typer

from app.cli import streams
from app.cli.debugging import Debug


def doctor(debug: Debug = False) -> None:
    """Look at this installation and say what is missing and which command mends it.

    Exits with 2 if something needed is broken. No ffmpeg, display or sound card is needed.
    """
    from app.examination import findings

    found = findings()
    for finding in found:
        streams.result(f"{finding.state:<5} {finding.what}")
    broken = [finding for finding in found if finding.state == "bad"]
    if broken:
        streams.say(f"laws doctor: {len(broken)} to mend")
        raise typer.Exit(2)
