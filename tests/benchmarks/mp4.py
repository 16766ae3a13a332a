"""How much longer a whole MP4 export takes than libx264 alone.

    python tests/benchmarks/mp4.py [SECONDS]

Alone: the same frames, converted to yuv420p beforehand, through the same encoder with the same
settings. Whole: draw each frame, convert, encode, write. Rounds alternate; the best of each counts.
"""

import sys
import tempfile
from collections import deque
from collections.abc import Callable
from pathlib import Path
from time import perf_counter, process_time

import av
import numpy as np
from av.video.reformatter import VideoReformatter
from scene import SIZE, frames

from app.frames import Film, Frame
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
    pictures = list(frames(SIZE, FPS, seconds))
    converter = VideoReformatter()
    ready = [converted(pixels, converter) for pixels in pictures]
    best = dict.fromkeys(("draw", "alone", "whole"), (np.inf, np.inf))
    with tempfile.TemporaryDirectory() as folder:
        parts: dict[str, Callable[[], object]] = {
            "draw": lambda: deque(frames(SIZE, FPS, seconds), maxlen=0),
            "alone": lambda: alone(ready, Path(folder) / "alone.mp4"),
            "whole": lambda: whole(Path(folder) / "whole.mp4", seconds),
        }
        for _ in range(ROUNDS):
            for name, run in parts.items():
                wall, busy = perf_counter(), process_time()
                run()
                spent = (perf_counter() - wall, process_time() - busy)
                best[name] = (min(best[name][0], spent[0]), min(best[name][1], spent[1]))
        same = (Path(folder) / "alone.mp4").read_bytes() == (
            Path(folder) / "whole.mp4"
        ).read_bytes()
    for name, (wall, busy) in best.items():
        print(
            f"MP4 {name}: {1000 * wall / len(ready):.1f} ms a frame, "
            f"{1000 * busy / len(ready):.1f} ms of processor time"
        )
    print(f"MP4: whole export takes {best['whole'][0] / best['alone'][0]:.2f} times libx264 alone")
    print(f"MP4: the two files are {'equal' if same else 'DIFFERENT'}")


if __name__ == "__main__":
    main()
