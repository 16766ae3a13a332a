"""The shipped fonts show every character that the app uses, with figures of one width."""

import tomllib
from importlib import resources
from pathlib import Path

import numpy as np
import pytest
from fontTools.ttLib import TTFont

from screens.kit import theme
from screens.kit.characters import drawable
from screens.kit.sdl import pygame
from screens.kit.text import CAP_HEIGHT, FILES, Type
from screens.kit.theme import MEDIUM, REGULAR, SEMIBOLD

ASSETS = Path(str(resources.files("assets")))
ALWAYS = "0123456789+\u2212-.,:;/°%²³·\u2009∞–… →←↔⇄⟵⟶×±≈≤≥≠ΔΣαβωμνλπθφ₀₁₂éñüßøÅЖдьğſẠữ€"


def texts(data: object) -> str:
    if isinstance(data, dict):
        return "".join(texts(value) for value in data.values())
    if isinstance(data, list):
        return "".join(texts(value) for value in data)
    return str(data)


@pytest.mark.parametrize("weight", sorted(FILES))
def test_every_character_of_the_app_is_in_the_font(weight):
    shown = set(TTFont(ASSETS / "fonts" / FILES[weight]).getBestCmap())
    used = ALWAYS
    for file in sorted((ASSETS / "text").glob("*.toml")):
        used += texts(tomllib.loads(file.read_text("utf-8")))
    lacking = sorted({c for c in used if c.isprintable() and ord(c) not in shown})
    assert lacking == []


@pytest.mark.parametrize("weight", sorted(FILES))
def test_the_list_of_characters_is_that_of_the_fonts(weight):
    shown = TTFont(ASSETS / "fonts" / FILES[weight]).getBestCmap()
    assert drawable() == {chr(number) for number in shown}


@pytest.mark.parametrize("weight", [REGULAR, MEDIUM, SEMIBOLD])
def test_figures_have_one_width(weight):
    font = Type(2).font(weight, 30)
    assert len({font.size(c * 20)[0] for c in "0123456789"}) == 1


def test_the_cap_height_is_that_of_the_font():
    table = TTFont(ASSETS / "fonts" / FILES[REGULAR])
    assert table["OS/2"].sCapHeight / table["head"].unitsPerEm == CAP_HEIGHT


def test_the_thin_space_is_a_fifth_of_the_em():
    metrics = TTFont(ASSETS / "fonts" / FILES[REGULAR])
    glyph = metrics.getBestCmap()[0x2009]
    assert metrics["hmtx"][glyph][0] / metrics["head"].unitsPerEm == pytest.approx(0.2, abs=0.001)


def test_only_the_shipped_fonts_are_opened(monkeypatch):
    def refuse(*_: object) -> None:
        raise AssertionError("a system font was asked for")

    monkeypatch.setattr(pygame.font, "SysFont", refuse)
    assert Type(1).font(REGULAR, 12).name == "Inter"


@pytest.mark.parametrize("scale", [1.0, 2.0, 3.0, 6.0])
@pytest.mark.parametrize(
    "words", ["12° / −5°", "A on wall 0.52 N s", "t = 3.50\u2009s", "½ (3) 4×5"]
)
def test_a_line_put_together_from_parts_is_as_if_set_as_a_whole(scale, words):
    for style in (theme.VALUE, theme.SMALL, theme.TITLE):
        face = Type(scale).face(style)
        line, whole = face.line(words).coverage, face.mask(words).coverage
        assert line.shape == whole.shape
        assert np.abs(line.astype(int) - whole).max() <= 4


def test_a_changed_number_is_not_set_anew(monkeypatch):
    face = Type(2).face(theme.VALUE)
    for i in range(0, 100, 11):
        face.line(f"{i:02} N s")
    monkeypatch.setattr(face, "_cover", lambda *_: pytest.fail("the font was asked again"))
    assert face.line("47 N s").coverage.any()
