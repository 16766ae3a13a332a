"""How much longer a whole MP4 export takes than libx264 alone.

    python tests/benchmarks/mp4.py [SECONDS]

Alone: the same frames, converted to yuv420p beforehand, through the same encoder with the same
settings. Whole: draw each frame, convert, encode, write. Rounds alternate; the best of each counts.
"""

import sys
import tempfile
from pathlib import Path
from time import perf_counter

import av
import numpy as np
from scene import SIZE, frames

from app.frames import Film, Frame, Pixels
from app.outputs import open_sink
from app.outputs.background import Background
from app.outputs.video import Mp4, converted

FPS = 30
ROUNDS = 3


def alone(pictures: list[av.VideoFrame], target: Path) -> None:
    encoder = Mp4(target, Film(*SIZE, FPS, "Benchmark"))
    for index, picture in enumerate(pictures):
        encoder.encode(picture, index)
    encoder.finish()


def whole(target: Path, seconds: float) -> None:
    sink = Background(open_sink(target, Film(*SIZE, FPS, "Benchmark")))
    for index, pixels in enumerate(frames(SIZE, FPS, seconds)):
        sink.frame(Frame(index, pixels))
    sink.close()


def main() -> None:
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 4.0
    pictures: list[Pixels] = list(frames(SIZE, FPS, seconds))
    ready = [converted(pixels) for pixels in pictures]
    best = {"draw": np.inf, "alone": np.inf, "whole": np.inf}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(ROUNDS):
            start = perf_counter()
            for _pixels in frames(SIZE, FPS, seconds):
                pass
            best["draw"] = min(best["draw"], perf_counter() - start)
            start = perf_counter()
            alone(ready, Path(folder) / "alone.mp4")
            best["alone"] = min(best["alone"], perf_counter() - start)
            start = perf_counter()
            whole(Path(folder) / "whole.mp4", seconds)
            best["whole"] = min(best["whole"], perf_counter() - start)
        same = (Path(folder) / "alone.mp4").read_bytes() == (
            Path(folder) / "whole.mp4"
        ).read_bytes()
    for name, spent in best.items():
        print(f"MP4 {name}: {1000 * spent / len(pictures):.1f} ms a frame")
    print(f"MP4: whole export takes {best['whole'] / best['alone']:.2f} times libx264 alone")
    print(f"MP4: the two files are {'equal' if same else 'DIFFERENT'}")


if __name__ == "__main__":
    main()
