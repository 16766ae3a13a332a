"""Puts what was measured where docs/performance.md has the table for it."""

from collections.abc import Iterable
from pathlib import Path

PAGE = Path(__file__).parents[2] / "docs" / "performance.md"

Row = tuple[str, ...]
"""The cells of a row, as Markdown."""


def line(cells: Iterable[str]) -> str:
    """A row of a table in Markdown."""
    return "| " + " | ".join(cells) + " |"


def put(header: Row, rows: Iterable[Row], names: int) -> None:
    """Write rows into the table of the page that has this header.

    A row replaces the one whose first `names` cells are the same; if there is none, it is the last.

    Raises:
        ValueError: if no table has this header.
    """
    before = PAGE.read_text(encoding="utf-8").split("\n")
    first = before.index(line(header)) + 2
    last = first
    while before[last].startswith("|"):
        last += 1
    table = {each[:names]: each for each in map(cells, before[first:last])}
    table |= {row[:names]: row for row in rows}
    lines = [*before[:first], *map(line, table.values()), *before[last:]]
    PAGE.write_text("\n".join(lines), encoding="utf-8")


def cells(row: str) -> Row:
    """The cells of a line of a table."""
    return tuple(cell.strip() for cell in row.strip("|").split("|"))
