"""Films of large pictures never ended: the encoder held all that it could be lent.

Of pictures of more than 16 MB each (2160x3840, say) an encoder was lent three at most. Video, which
converts ahead, holds up to three until it is given the next, so each side waited for the other.
"""

import signal
from collections.abc import Iterator
from pathlib import Path
from types import FrameType

import pytest

from app.frames import Film, Frame, Pixels
from app.outputs import open_sink, remote, shared

LONGEST = 60
"""How long a film of a few small pictures may take at most (s)."""

pytestmark = [
    pytest.mark.usefixtures("no_idle_workers"),
    pytest.mark.skipif(not shared.AVAILABLE, reason="encoders work in this process"),
]


@pytest.fixture(autouse=True)
def _ends() -> Iterator[None]:
    """What waits for ever fails."""

    def fail(signum: int, frame: FrameType | None) -> None:
        raise TimeoutError(f"the film has not ended after {LONGEST} s")

    before = signal.signal(signal.SIGALRM, fail)
    signal.alarm(LONGEST)
    yield
    signal.alarm(0)
    signal.signal(signal.SIGALRM, before)


@pytest.mark.parametrize("most", [1, 2, 3, 4])
@pytest.mark.parametrize("name", ["film.mp4", "film.webm", "film.gif"])
def test_an_encoder_that_holds_all_it_was_lent_is_given_the_next(
    tmp_path: Path,
    film: Film,
    pictures: list[Pixels],
    name: str,
    most: int,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    if name != "film.gif":
        pytest.importorskip("av")
    monkeypatch.setattr(remote, "most_waiting", lambda film: most)
    sink = open_sink(tmp_path / name, film, remote=True)
    try:
        for number, pixels in enumerate(pictures * 3):
            sink.frame(Frame(number, pixels))
        sink.close()
    except BaseException:
        sink.abort()
        raise
    assert (tmp_path / name).stat().st_size > 0
