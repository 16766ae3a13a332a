"""Which kinds of outputs there are, by the suffixes of their paths."""

import os

SUFFIXES = {
    ".mp4": "mp4",
    ".webm": "webm",
    ".gif": "gif",
    ".apng": "apng",
    ".webp": "webp",
    ".csv": "csv",
    ".json": "json",
}
"""Kind of an output by its suffix; a path that ends in "/" is of kind "png", a folder of frames."""

DATA = ("csv", "json")
"""Kinds that hold no pictures."""


def kind_of(path: str | os.PathLike[str]) -> str | None:
    """The kind of output a path asks for, or None if its suffix is none of `SUFFIXES`."""
    text = os.fspath(path)
    if text.endswith(("/", os.sep)):
        return "png"
    return SUFFIXES.get(os.path.splitext(text)[1].lower())
