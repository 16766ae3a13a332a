"""Peak memory of a long film beside that of a short one, for every format.

    python tests/benchmarks/memory.py [LONG_SECONDS [WIDTH HEIGHT]]

Each film is made in a process of its own; by default 10 minutes against 10 seconds at
180x320 and 10 fps: memory must not depend on the number of frames, whatever their size.
"""

import resource
import subprocess
import sys
import tempfile
from pathlib import Path

FPS = 10
SHORT = 10.0
KINDS = ("film.mp4", "film.webm", "film.gif", "film.apng", "film.webp", "frames/", "film.csv")


def film(target: str, seconds: float, size: tuple[int, int]) -> None:
    """Make one film and print the peaks of this process and of the one that encodes (MB)."""
    from balls import frames

    from app.frames import Film, Frame, Moment
    from app.outputs import open_sink
    from app.outputs.remote import dismiss_workers
    from engine import Particle
    from screens.kit.bodies import new_world

    world = new_world()
    for number in range(12):
        world.add(Particle(0.1), position=(number, 0), velocity=(1, 2))
    sink = open_sink(target, Film(*size, FPS, "Benchmark"), remote=True)
    sink.moment(Moment(world.time, world, []))
    for index, pixels in enumerate(frames(size, FPS, seconds)):
        sink.frame(Frame(index, pixels))
        for _ in range(60 // FPS):
            sink.moment(Moment(world.time, world, world.step()))
    sink.close()
    dismiss_workers()
    for whose in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN):
        print(resource.getrusage(whose).ru_maxrss / 1024)


def peak(target: str, seconds: float, size: tuple[int, int]) -> float:
    command = [sys.executable, __file__, "film", target, str(seconds), *map(str, size)]
    printed = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return sum(map(float, printed.split()))


def main() -> None:
    if sys.argv[1:2] == ["film"]:
        film(sys.argv[2], float(sys.argv[3]), (int(sys.argv[4]), int(sys.argv[5])))
        return
    long = float(sys.argv[1]) if len(sys.argv) > 1 else 600.0
    size = (int(sys.argv[2]), int(sys.argv[3])) if len(sys.argv) > 3 else (180, 320)
    with tempfile.TemporaryDirectory() as folder:
        for kind in KINDS:
            short, whole = (peak(f"{folder}/{kind}", time, size) for time in (SHORT, long))
            print(
                f"Memory {Path(kind).suffix or kind}: {short:.0f} MB for {SHORT:.0f} s, "
                f"{whole:.0f} MB for {long:.0f} s, {whole - short:+.1f} MB"
            )


if __name__ == "__main__":
    main()
