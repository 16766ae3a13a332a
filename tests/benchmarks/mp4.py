"""How much longer a whole MP4 export takes than libx264 alone.

    python tests/benchmarks/mp4.py

Alone: the same frames, converted to yuv420p beforehand, through the same encoder with the same
settings. Whole: simulate, draw, convert, encode and write the shipped Reactions scenario at
720x1280 and 30 fps. They take turns, as machines change their speed by the minute: each whole
export is compared with libx264 just before and just after it, and the middle of these ratios
counts. On a busy machine our share looks worse: the whole export needs a second core for what
libx264 does not do. So the time of processors is told as well, all processes together, on average;
of two cores each gives a half. And how much of it the host of a virtual machine kept for others:
with more than a few per cent no ratio counts.
"""

import os
import resource
import tempfile
from collections.abc import Callable
from pathlib import Path
from statistics import median
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
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    kept, since = stolen(), perf_counter()
    spent: dict[str, list[float]] = {"alone": [], "whole": []}
    worked = dict.fromkeys(spent, 0.0)
    with tempfile.TemporaryDirectory() as folder:
        one, two = Path(folder) / "alone.mp4", Path(folder) / "whole.mp4"
        runs: dict[str, Callable[[], object]] = {
            "alone": lambda: alone(ready, one),
            "whole": lambda: export(two),
        }
        for name in (*ROUNDS * ("alone", "whole"), "alone"):
            start, work = perf_counter(), process_time()
            runs[name]()
            spent[name].append(perf_counter() - start)
            worked[name] += process_time() - work
        kept, since = stolen() - kept, perf_counter() - since
        same = one.read_bytes() == two.read_bytes()
    dismiss_workers()
    workers = resource.getrusage(resource.RUSAGE_CHILDREN)
    worked["whole"] += workers.ru_utime + workers.ru_stime - children.ru_utime - children.ru_stime
    for name, times in spent.items():
        passed = 1000 * median(times) / len(ready)
        work = 1000 * worked[name] / len(times) / len(ready)
        print(f"MP4 {name}: {passed:.1f} ms a frame, {work:.1f} of processors")
    around = zip(spent["alone"], spent["whole"], spent["alone"][1:], strict=False)
    ratios = sorted(2 * whole / (before + after) for before, whole, after in around)
    print(
        f"MP4: whole export takes {median(ratios):.2f} times libx264 alone"
        f" ({ratios[0]:.2f} to {ratios[-1]:.2f})"
    )
    print(f"MP4: the host kept {kept / since:.0%} of a processor for others meanwhile")
    print(f"MP4: the two files are {'equal' if same else 'DIFFERENT'}")


if __name__ == "__main__":
    main()
