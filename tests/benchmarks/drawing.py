"""How long the Reactions lesson takes to draw a frame: 12 balls, impulse arrows, labels, readouts.

    python tests/benchmarks/drawing.py [SECONDS]

The lesson runs; drawing it on memory of its own, a plain copy of the picture, and painting the
static layer anew are timed in turn, by processor time. The static layer is what would be drawn
again without `Surface.static`.
"""

import statistics
import sys
from time import process_time

from screens.kit.events import Tap, Tick, Tilt
from screens.kit.geometry import Point
from screens.kit.scale import dp_size
from screens.kit.surface import Surface
from screens.kit.words import load_words
from screens.reactions import Reactions

SIZE = (720, 1280)
BALLS = 12
LIMIT = 2.5
"""What a frame may take (ms)."""


def lesson() -> Reactions:
    """Twelve balls of two masses, pushed about by a tilt."""
    dice = iter([0.9, 0.8, 0.95, 0.7] * BALLS)
    reactions = Reactions(dp_size(*SIZE), lambda: next(dice), {}, load_words("en"))
    canvas = reactions.view.frame
    tries = [
        Point(canvas.x + canvas.width * (i + 0.5) / 7, canvas.y + canvas.height * (k + 0.5) / 7)
        for k in range(7)
        for i in range(7)
    ]
    for at in tries[::2]:
        if len(reactions.balls) < BALLS:
            reactions.update(Tap(at))
    reactions.update(Tilt(20, -10))
    return reactions


def main() -> None:
    """Time the lesson and print the figures."""
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 10.0
    reactions, surface = lesson(), Surface(*SIZE)
    draws, copies, pages = [], [], []
    for tick in range(round(60 * seconds)):
        if tick % 60 == 0:
            reactions.update(Tilt(20 - 40 * (tick // 60 % 2), 10 * (tick // 60 % 3) - 10))
        reactions.update(Tick())
        start = process_time()
        reactions.draw(surface)  # which begins with a copy of the static layer
        pixels = surface.pixels()
        drawn = process_time()
        pixels.copy()
        draws.append((drawn - start) * 1000)
        copies.append((process_time() - drawn) * 1000)
        if tick % 30 == 0:
            layer = Surface(*SIZE)
            start = process_time()
            reactions.draw(layer)
            pages.append((process_time() - start) * 1000)
    draw, copy, page = (statistics.median(times) for times in (draws, copies, pages))
    print(f"{len(reactions.balls)} balls, {reactions.collision_count} collisions, {SIZE}")
    print(f"draw a frame        {draw:6.2f} ms median, {min(draws):.2f} ms best (at most {LIMIT})")
    print(f"a plain copy of it  {copy:6.2f} ms: drawing takes {draw / copy:.1f} copies")
    print(f"with nothing kept   {page:6.2f} ms: {page / draw:.1f} times as long")


if __name__ == "__main__":
    main()
