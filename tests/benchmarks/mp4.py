"""How much longer a whole MP4 export takes than libx264 alone.

    python tests/benchmarks/mp4.py

Alone: the same frames, converted to yuv420p beforehand, through the same encoder with the same
settings. Whole: simulate, draw, convert, encode and write the shipped Reactions scenario at
720x1280 and 30 fps. Rounds alternate; the best of each counts. On a busy machine our share looks
worse: the whole export needs a second core for what libx264 does not do. So the time of processors
is told as well, all processes together, on average; of two cores each gives a half. And how much
of it the host of a virtual machine kept for others: with more than a few per cent no ratio counts.
"""

import os
import resource
import tempfile
from collections.abc import Callable
from pathlib import Path
from time import perf_counter, process_time

import av
from av.video.reformatter import VideoReformatter
from scene import export, film, frames

from app.outputs.conversion import converted
from app.outputs.remote import dismiss_workers
from app.outputs.video import Mp4

ROUNDS = 9


def alone(pictures: list[av.VideoFrame], target: Path) -> None:
    encoder = Mp4(target, film())
    for index, picture in enumerate(pictures):
        encoder.encode(picture, index)
    encoder.finish()


def stolen() -> float:
    """Seconds of processors that this machine wanted and its host gave to others, as Linux tells.

    See proc(5), /proc/stat, "steal".
    """
    file = Path("/proc/stat")
    if not file.exists():
        return 0.0
    return int(file.read_text().split()[8]) / os.sysconf("SC_CLK_TCK")


def main() -> None:
    converter = VideoReformatter()
    ready = [converted(pixels, converter) for pixels in frames()]
    dismiss_workers()
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    kept, since = stolen(), perf_counter()
    best: dict[str, float] = {}
    worked = dict.fromkeys(("alone", "whole"), 0.0)
    with tempfile.TemporaryDirectory() as folder:
        one, two = Path(folder) / "alone.mp4", Path(folder) / "whole.mp4"
        runs: dict[str, Callable[[], object]] = {
            "alone": lambda: alone(ready, one),
            "whole": lambda: export(two),
        }
        for _ in range(ROUNDS):
            for name, run in runs.items():
                start, work = perf_counter(), process_time()
                run()
                spent = perf_counter() - start
                worked[name] += process_time() - work
                best[name] = min(best.get(name, spent), spent)
        kept, since = stolen() - kept, perf_counter() - since
        same = one.read_bytes() == two.read_bytes()
    dismiss_workers()
    workers = resource.getrusage(resource.RUSAGE_CHILDREN)
    worked["whole"] += workers.ru_utime + workers.ru_stime - before.ru_utime - before.ru_stime
    for name, spent in best.items():
        work = 1000 * worked[name] / ROUNDS / len(ready)
        spent = 1000 * spent / len(ready)
        print(f"MP4 {name}: {spent:.1f} ms a frame, {work:.1f} of processors")
    print(f"MP4: whole export takes {best['whole'] / best['alone']:.2f} times libx264 alone")
    print(f"MP4: the host kept {kept / since:.0%} of a processor for others meanwhile")
    print(f"MP4: the two files are {'equal' if same else 'DIFFERENT'}")


if __name__ == "__main__":
    main()
