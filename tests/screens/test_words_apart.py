"""No words of a page or a dialog lie over others, or leave the screen, whatever the numbers are."""

from itertools import combinations

import pytest
from hand import fill, lesson, tap, wait

from screens.kit.events import Tilt
from screens.kit.geometry import Rect, Size
from screens.kit.scale import dp_size
from screens.kit.surface import Surface
from screens.lesson import Lesson

SHAPES = [(9, 16), (16, 9), (3, 4), (4, 3), (1, 1), (64, 27), (27, 64), (4, 1)]
SIZES = [dp_size(120 * wide, 120 * high) for wide, high in SHAPES]
INK = 3.0
"""What a line is higher than its letters, above and below, at least (dp)."""


@pytest.fixture
def words(monkeypatch: pytest.MonkeyPatch) -> dict[Rect, str]:
    """Where words are drawn; those below a dialog do not count."""
    drawn: dict[Rect, str] = {}
    text, scrim = Surface.text, Surface.scrim

    def draw(self, words, *args, **options):
        room = text(self, words, *args, **options)
        drawn[room] = words
        return room

    def darken(self, alpha):
        drawn.clear()
        scrim(self, alpha)

    monkeypatch.setattr(Surface, "text", draw)
    monkeypatch.setattr(Surface, "scrim", darken)
    return drawn


def check(shown: Lesson, words: dict[Rect, str]) -> None:
    words.clear()
    screen = Rect(0, 0, *shown.size)
    shown.draw(Surface(int(2 * screen.width), int(2 * screen.height)))
    ink = {
        Rect(room.x, room.y + INK, room.width, room.height - 2 * INK): said
        for room, said in words.items()
    }
    assert len(ink) > 5
    for (room, said), (other, again) in combinations(ink.items(), 2):
        assert not room.overlaps(other), (said, again)
    for room, said in ink.items():
        assert room.x >= 0, said
        assert room.right <= screen.width, said


@pytest.mark.parametrize("size", SIZES)
def test_inertia(size: Size, words: dict[Rect, str]) -> None:
    settings = {"body.mass": 0.1, "force.x": -4.2, "force.y": 4.2, "body.restitution": 1.0}
    inertia = lesson("inertia", settings, size)
    tap(inertia, "force.toggle")
    wait(inertia, 600)
    check(inertia, words)
    tap(inertia, "force.change")
    check(inertia, words)


@pytest.mark.parametrize("size", SIZES)
def test_forces(size: Size, words: dict[Rect, str]) -> None:
    settings = {
        "cart.a.mass": 9.999,
        "cart.a.acceleration": 4.999,
        "cart.b.mass": 0.501,
        "cart.b.acceleration": 0.00123,
    }
    forces = lesson("forces", settings, size)
    check(forces, words)
    tap(forces, "forces.apply")
    wait(forces, 6000)
    check(forces, words)
    tap(forces, "cart.a")
    check(forces, words)
    fill(forces, "mass", "999")
    fill(forces, "acceleration", "-1")
    check(forces, words)


@pytest.mark.parametrize("size", SIZES)
def test_reactions(size: Size, words: dict[Rect, str]) -> None:
    heavy = {"particle.mass": 50.0, "tilt.force": 50.0, "particle.restitution": 1.0}
    reactions = lesson("reactions", heavy, size)
    check(reactions, words)
    for _ in range(4):
        tap(reactions, "ball.heavier")
    tap(reactions, "canvas")
    reactions.update(Tilt(-90.0, -90.0))
    wait(reactions, 600)
    check(reactions, words)
