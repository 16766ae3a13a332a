"""How fast a GIF is made, and how large it is, beside the loop that every tutorial shows.

    python tests/benchmarks/gif.py

That loop: draw a frame with pygame, copy it to a Pillow image, at the end save(save_all=True). It
gets the frames of the shipped Reactions scenario at 720x1280 and 30 fps, drawn as we draw them. It
is measured twice: all of it, and without simulating and drawing, from frames that are there.
Rounds alternate; the best of each counts. On a busy machine our share looks worse: it wants two
cores, the tutorial one.
"""

import tempfile
from collections.abc import Callable
from pathlib import Path
from time import perf_counter

import pygame
from PIL import Image
from scene import FPS, SIZE, export, frames, play

from app.frames import Film, Frame, Moment, Pixels
from app.outputs import open_sink

ROUNDS = 2


class Collected:
    """What the tutorial does with a frame."""

    def __init__(self) -> None:
        self.images: list[Image.Image] = []

    def frame(self, frame: Frame) -> None:
        surface = pygame.image.frombuffer(frame.pixels, SIZE, "BGRA")
        self.images.append(Image.frombytes("RGB", SIZE, pygame.image.tobytes(surface, "RGB")))

    def moment(self, moment: Moment) -> None:
        pass

    def close(self) -> None:
        pass

    def abort(self) -> None:
        pass

    def save(self, target: Path) -> None:
        first, *others = self.images
        lasts = round(1000 / FPS)
        first.save(target, save_all=True, append_images=others, duration=lasts, loop=0)


def tutorial(target: Path) -> None:
    collected = Collected()
    play(collected)
    collected.save(target)


def tutorial_encoding(pictures: list[Pixels], target: Path) -> None:
    collected = Collected()
    for index, pixels in enumerate(pictures):
        collected.frame(Frame(index, pixels))
    collected.save(target)


def encode(pictures: list[Pixels], target: Path) -> None:
    sink = open_sink(target, Film(*SIZE, FPS, "Benchmark"))
    for index, pixels in enumerate(pictures):
        sink.frame(Frame(index, pixels))
    sink.close()


def main() -> None:
    pictures = frames()
    best: dict[str, float] = {}
    sizes: dict[str, int] = {}
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder) / "film.gif"
        runs: dict[str, Callable[[], object]] = {
            "tutorial": lambda: tutorial(target),
            "tutorial, encoding alone": lambda: tutorial_encoding(pictures, target),
            "laws, encoding alone": lambda: encode(pictures, target),
            "laws, whole export": lambda: export(target),
        }
        for _ in range(ROUNDS):
            for name, run in runs.items():
                start = perf_counter()
                run()
                spent = perf_counter() - start
                best[name] = min(spent, best.get(name, spent))
                sizes[name] = target.stat().st_size
    for name, spent in best.items():
        print(f"GIF {name}: {1000 * spent / len(pictures):.1f} ms a frame")
    for ours, theirs in (
        ("laws, whole export", "tutorial"),
        ("laws, whole export", "tutorial, encoding alone"),
        ("laws, encoding alone", "tutorial, encoding alone"),
    ):
        print(f"GIF {ours}: {best[theirs] / best[ours]:.1f} times as fast as {theirs}")
    size, other = sizes["laws, whole export"], sizes["tutorial"]
    print(f"GIF size: {size / 1e6:.2f} MB, {size / other:.2f} of the tutorial's")


if __name__ == "__main__":
    main()
