import sys
import threading
from pathlib import Path

import numpy as np
import pytest

from app.frames import Film, Frame, Moment
from app.outputs import OutputError, open_sink
from app.outputs.background import Background, brief_turns

PIXELS = np.zeros((2, 2), np.uint32)


class Recorder:
    """A sink that notes what it is asked, and in which thread; it waits for `go` at each frame."""

    def __init__(self, fail_at: int | None = None) -> None:
        self.calls: list[object] = []
        self.threads: set[str] = set()
        self.go = threading.Event()
        self.go.set()
        self.fail_at = fail_at

    def frame(self, frame: Frame) -> None:
        assert self.go.wait(10)
        self.threads.add(threading.current_thread().name)
        if frame.index == self.fail_at:
            raise OutputError("film.gif", "the disk is full")
        self.calls.append(frame.index)

    def moment(self, moment: Moment) -> None:
        self.calls.append(threading.current_thread().name)

    def close(self) -> None:
        self.calls.append("close")

    def abort(self) -> None:
        self.calls.append("abort")


def test_frames_arrive_in_order_in_one_other_thread() -> None:
    inner = Recorder()
    sink = Background(inner)
    for index in range(50):
        sink.frame(Frame(index, PIXELS))
    sink.close()
    assert inner.calls == [*range(50), "close"]
    assert len(inner.threads) == 1
    assert threading.current_thread().name not in inner.threads


def test_the_queue_is_bounded() -> None:
    inner = Recorder()
    inner.go.clear()
    sink = Background(inner, depth=3)
    passed = []

    def feed() -> None:
        for index in range(10):
            sink.frame(Frame(index, PIXELS))
            passed.append(index)

    feeder = threading.Thread(target=feed)
    feeder.start()
    feeder.join(0.2)
    assert len(passed) == 3
    inner.go.set()
    feeder.join(10)
    sink.close()
    assert inner.calls == [*range(10), "close"]


def test_moments_pass_at_once_in_the_callers_thread() -> None:
    inner = Recorder()
    inner.go.clear()
    sink = Background(inner)
    sink.frame(Frame(0, PIXELS))
    sink.moment(None)  # type: ignore[arg-type]
    assert inner.calls == [threading.current_thread().name]
    inner.go.set()
    sink.close()


def test_an_error_comes_out_of_a_later_call() -> None:
    inner = Recorder(fail_at=2)
    sink = Background(inner)

    def feed() -> None:
        for index in range(20):
            sink.frame(Frame(index, PIXELS))

    with pytest.raises(OutputError, match="the disk is full"):
        feed()
    sink.abort()
    assert inner.calls[-1] == "abort"


def test_an_error_in_the_last_frame_comes_out_of_close() -> None:
    inner = Recorder(fail_at=1)
    sink = Background(inner)
    sink.frame(Frame(0, PIXELS))
    sink.frame(Frame(1, PIXELS))
    with pytest.raises(OutputError, match="the disk is full"):
        sink.close()
    assert inner.calls == [0, "abort"]


def test_abort_forgets_what_waits() -> None:
    inner = Recorder()
    inner.go.clear()
    sink = Background(inner)
    for index in range(4):
        sink.frame(Frame(index, PIXELS))
    threading.Timer(0.1, inner.go.set).start()
    sink.abort()
    assert inner.calls == [0, "abort"]


def test_a_real_film(tmp_path: Path, film: Film, pictures: list[np.ndarray]) -> None:
    direct = open_sink(tmp_path / "direct.gif", film)
    behind = Background(open_sink(tmp_path / "behind.gif", film))
    for index, pixels in enumerate(pictures):
        direct.frame(Frame(index, pixels))
        behind.frame(Frame(index, pixels))
    direct.close()
    behind.close()
    assert (tmp_path / "direct.gif").read_bytes() == (tmp_path / "behind.gif").read_bytes()


def test_threads_take_brief_turns_only_meanwhile() -> None:
    before = sys.getswitchinterval()
    with brief_turns():
        assert sys.getswitchinterval() < before
    assert sys.getswitchinterval() == before
