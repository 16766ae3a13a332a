"""How fast a GIF is made, and how large it is, beside the loop that every tutorial shows.

    python tests/benchmarks/gif.py [SECONDS]

That loop: copy each frame of a pygame surface to a Pillow image, then save(save_all=True). Both get
the same frames of 720x1280 at 30 fps; "whole" counts the drawing of the frames too, which here
overlaps with the encoding. Rounds alternate; the best of each counts.
"""

import sys
import tempfile
from collections.abc import Iterable
from pathlib import Path
from time import perf_counter

import pygame
from PIL import Image
from scene import SIZE, frames

from app.frames import Film, Frame, Pixels
from app.outputs import open_sink
from app.outputs.background import Background

FPS = 30
ROUNDS = 3


def tutorial(pictures: Iterable[Pixels], target: Path) -> None:
    images = []
    for pixels in pictures:
        surface = pygame.image.frombuffer(pixels, SIZE, "BGRA")
        images.append(Image.frombytes("RGB", SIZE, pygame.image.tobytes(surface, "RGB")))
    images[0].save(
        target, save_all=True, append_images=images[1:], duration=round(1000 / FPS), loop=0
    )


def ours(pictures: Iterable[Pixels], target: Path) -> None:
    sink = Background(open_sink(target, Film(*SIZE, FPS, "Benchmark")))
    for index, pixels in enumerate(pictures):
        sink.frame(Frame(index, pixels))
    sink.close()


def main() -> None:
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 4.0
    drawn = list(frames(SIZE, FPS, seconds))
    count = len(drawn)
    best: dict[str, float] = {}
    sizes: dict[str, int] = {}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(ROUNDS):
            for name, make in (("tutorial", tutorial), ("laws", ours)):
                for kind, pictures in (("encode", drawn), ("whole", None)):
                    target = Path(folder) / f"{name}.gif"
                    start = perf_counter()
                    make(frames(SIZE, FPS, seconds) if pictures is None else pictures, target)
                    spent = perf_counter() - start
                    best[name + kind] = min(spent, best.get(name + kind, spent))
                    sizes[name] = target.stat().st_size
    for kind in ("encode", "whole"):
        slow, fast = best["tutorial" + kind], best["laws" + kind]
        print(
            f"GIF {kind}: {1000 * slow / count:.1f} and {1000 * fast / count:.1f} ms a frame, "
            f"{slow / fast:.1f} times as fast"
        )
    print(f"GIF size: {sizes['laws'] / sizes['tutorial']:.2f} of the tutorial's")


if __name__ == "__main__":
    main()
