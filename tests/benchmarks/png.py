"""How fast a folder of PNG frames is written, beside pygame.image.save.

    python tests/benchmarks/png.py

Both get each fourth frame of the shipped Reactions scenario at 720x1280; the files are read back
and compared pixel by pixel. Rounds alternate; the best of each counts.
"""

import tempfile
from pathlib import Path
from time import perf_counter

import numpy as np
import pygame
from PIL import Image
from scene import FPS, SIZE, frames

from app.frames import Film, Frame, Pixels
from app.outputs import open_sink

ROUNDS = 2
EVERY = 4  # of the frames, to keep it short; it makes neighbours less alike


def with_pygame(pictures: list[Pixels], folder: Path) -> None:
    folder.mkdir(exist_ok=True)
    for index, pixels in enumerate(pictures):
        surface = pygame.image.frombuffer(pixels, SIZE, "BGRA")
        pygame.image.save(surface, str(folder / f"frame-{index + 1:05d}.png"))


def ours(pictures: list[Pixels], folder: Path) -> None:
    sink = open_sink(f"{folder}/", Film(*SIZE, FPS, "Benchmark"))
    for index, pixels in enumerate(pictures):
        sink.frame(Frame(index, pixels))
    sink.close()


def main() -> None:
    pictures = frames()[::EVERY]
    best = {"pygame": np.inf, "laws": np.inf}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(ROUNDS):
            for name, make in (("pygame", with_pygame), ("laws", ours)):
                start = perf_counter()
                make(pictures, Path(folder) / name)
                best[name] = min(best[name], perf_counter() - start)
        sizes = {
            name: sum(path.stat().st_size for path in (Path(folder) / name).iterdir())
            for name in best
        }
        equal = all(
            Image.open(file).convert("RGB").tobytes()
            == Image.open(Path(folder) / "laws" / file.name).tobytes()
            for file in sorted((Path(folder) / "pygame").iterdir())
        )
    for name, spent in best.items():
        print(f"PNG {name}: {1000 * spent / len(pictures):.1f} ms a frame")
    print(f"PNG folder: {best['pygame'] / best['laws']:.1f} times as fast as pygame.image.save")
    print(f"PNG size: {sizes['laws'] / sizes['pygame']:.2f} of pygame's")
    print(f"PNG: pixels {'identical' if equal else 'DIFFERENT'}")


if __name__ == "__main__":
    main()
