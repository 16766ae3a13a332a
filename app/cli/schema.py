"""`laws schema`: the JSON Schema of scenario files."""

import json

from app.cli import streams
from app.cli.debugging import Debug


def schema(debug: Debug = False) -> None:
    """Print the JSON Schema of scenario files, for editors that complete and explain.

    \b
    Examples:
      laws schema > laws.schema.json
      # in VS Code, put this into the first line of a scenario:
      # yaml-language-server: $schema=laws.schema.json
    """  # noqa: D301
    from app.scenario.schema import schema as build

    streams.result(json.dumps(build(), indent=2, ensure_ascii=False))
