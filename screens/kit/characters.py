"""Which characters the shipped fonts have. Needs no pygame."""

from functools import cache

from assets import FONTS


@cache
def drawable() -> frozenset[str]:
    """All of them, from `assets/fonts/characters.txt`: numbers and ranges of Unicode."""
    characters: set[str] = set()
    for part in (FONTS / "characters.txt").read_text(encoding="utf-8").split():
        first, _, last = part.partition("-")
        characters.update(map(chr, range(int(first, 16), int(last or first, 16) + 1)))
    return frozenset(characters)
