"""The JSON Schema (draft 7) of a scenario file, from which editors complete and explain."""

from pathlib import Path
from typing import Any

from app.scenario.catalogue import SCREENS, of_all, of_screen
from app.scenario.format import Context, StepsKind, file_fields
from app.scenario.header import SettingsKind
from app.scenario.kinds import Schema
from app.scenario.mistakes import Place
from app.scenario.model import Step
from app.scenario.paths import Folders


def schema() -> dict[str, Any]:
    """The schema of a whole file."""
    context = Context(of_all(), Folders(Path(), Path()), _nothing)
    fields = file_fields(context)
    return {
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "Laws of Motion: scenario",
        "description": "A recorded, reproducible demonstration of Newton's laws.",
        "type": "object",
        "properties": {name: field.schema() for name, field in fields.items()},
        "required": [name for name, field in fields.items() if field.required],
        "additionalProperties": False,
        "allOf": [_settings(screen) for screen in SCREENS],
        "definitions": _steps(StepsKind(context)),
    }


def _settings(screen: str) -> Schema:
    """A file of this screen has only this screen's settings."""
    return {
        "if": {"properties": {"screen": {"const": screen}}, "required": ["screen"]},
        "then": {"properties": {"set": SettingsKind(of_screen(screen)).schema()}},
    }


def _steps(steps: StepsKind) -> Schema:
    """A definition for each step, and one for any of them."""
    definitions: Schema = {
        f"{name}-step": {
            "type": "object",
            "description": kind.about,
            "properties": {name: kind.kind.schema() | {"description": kind.about}},
            "required": [name],
            "additionalProperties": False,
        }
        for name, kind in steps.kinds.items()
    }
    bare: Schema = {"enum": [name for name, kind in steps.kinds.items() if kind.bare]}
    references = [{"$ref": f"#/definitions/{name}"} for name in definitions]
    return definitions | {"step": {"anyOf": [*references, bare]}}


def _nothing(path: str, place: Place) -> tuple[Step, ...]:
    """Reads no other file: a schema sees none."""
    return ()
