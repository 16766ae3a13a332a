"""How fast a GIF is made, and how large it is, beside the loop that every tutorial shows.

    python tests/benchmarks/gif.py

That loop: copy each frame of a pygame surface to a Pillow image, then save(save_all=True). Both get
the frames of the shipped Reactions scenario at 720x1280 and 30 fps. "Whole" is our export, with
simulating and drawing, against the tutorial's encoding alone. Rounds alternate; the best of each
counts. On a busy machine our share looks worse: it wants two cores, the tutorial one.
"""

import tempfile
from collections.abc import Callable
from pathlib import Path
from time import perf_counter

import pygame
from PIL import Image
from scene import FPS, SIZE, export, frames

from app.frames import Film, Frame, Pixels
from app.outputs import open_sink

ROUNDS = 2


def tutorial(pictures: list[Pixels], target: Path) -> None:
    images = []
    for pixels in pictures:
        surface = pygame.image.frombuffer(pixels, SIZE, "BGRA")
        images.append(Image.frombytes("RGB", SIZE, pygame.image.tobytes(surface, "RGB")))
    images[0].save(
        target, save_all=True, append_images=images[1:], duration=round(1000 / FPS), loop=0
    )


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
            "tutorial, encoding": lambda: tutorial(pictures, target),
            "laws, encoding": lambda: encode(pictures, target),
            "laws, whole": lambda: export(target),
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
    encoding = best["tutorial, encoding"]
    print(f"GIF encoding: {encoding / best['laws, encoding']:.1f} times as fast as the tutorial")
    print(f"GIF whole export: {encoding / best['laws, whole']:.1f} times as fast as the tutorial")
    size, other = sizes["laws, whole"], sizes["tutorial, encoding"]
    print(f"GIF size: {size / 1e6:.2f} MB, {size / other:.2f} of the tutorial's")


if __name__ == "__main__":
    main()
