"""All outputs of one run: begun together before the first frame, and each whole or not there."""

import hashlib
import os
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from types import TracebackType

from app.frames import Film, Pixels, Sink
from app.json_text import document
from app.outputs import DATA, OutputError, Promise, explained, kind_of, open_sink
from app.outputs.png import png_bytes
from app.outputs.promise import check_place
from app.player import Check
from app.report import Output, Report
from app.watcher import Watcher

REPORT = "json"


class NotBegun(Exception):
    """An output cannot be begun, so nothing was drawn; the sentence says which and why."""


class Deliverables:
    """The outputs of one run; a context that puts away whatever was not finished."""

    def __init__(self, paths: Sequence[str], pictures: Sequence[str], film: Film) -> None:
        """Begin all of them; raises NotBegun, with nothing left behind, if one cannot be.

        `pictures` are the paths of screenshots that will be taken.
        """
        self._film = film
        self._begun = ExitStack()
        """Puts away whatever is not finished, the last that was begun first."""
        self._sinks: dict[str, Sink] = {}
        self._reports: dict[str, Promise] = {}
        self._pictures: dict[str, Promise] = {}
        try:
            for path in paths:
                self._begin(path)
            for path in pictures:
                check_place(path)
        except OutputError as error:
            self._begun.close()
            raise NotBegun(str(error)) from error
        except BaseException:  # stopped while encoders are loaded
            self._begun.close()
            raise

    @property
    def films(self) -> Sequence[Sink]:
        """Where frames go."""
        return tuple(sink for path, sink in self._sinks.items() if kind_of(path) not in DATA)

    @property
    def tracks(self) -> Sequence[Sink]:
        """Where moments go."""
        return tuple(sink for path, sink in self._sinks.items() if kind_of(path) in DATA)

    def __enter__(self) -> "Deliverables":
        """Nothing is done yet."""
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Leave nothing that is not finished."""
        self._begun.close()

    def picture(self, path: str, pixels: Pixels) -> None:
        """Write a screenshot, which gets its name once the run is done; raises OutputError."""
        promise = self._pictures[path] = self._promised(path)
        with explained(path):
            promise.part.write_bytes(png_bytes(pixels))

    def finish(self, report: Report, checks: Sequence[Check], watcher: Watcher) -> list[Output]:
        """Finish all of them, the reports last; raises OutputError if one cannot be finished."""
        outputs = []
        for path, promise in self._pictures.items():
            promise.keep()
            shot = Path(os.path.realpath(path))
            outputs.append(Output(path, "png", shot.stat().st_size, _hash(shot)))
            watcher.wrote(outputs[-1])
        for path, sink in self._sinks.items():
            watcher.finishing(path)
            sink.close()
            outputs.append(described(path, report.frames, self._film.fps))
            watcher.wrote(outputs[-1])
        films = tuple(outputs)
        for path, promise in self._reports.items():
            rows = [replace(film, path=_seen_from(path, film.path)) for film in films]
            with explained(path), promise.part.open("w", encoding="utf-8", newline="\n") as file:
                file.writelines(document(report.document(checks, rows)))
            promise.keep()
            outputs.append(described(path, report.frames, self._film.fps))
            watcher.wrote(outputs[-1])
        return outputs

    def _begin(self, path: str) -> None:
        if kind_of(path) == REPORT:
            self._reports[path] = self._promised(path)
        else:
            sink = self._sinks[path] = open_sink(path, self._film, remote=True)
            self._begun.callback(sink.abort)

    def _promised(self, path: str) -> Promise:
        promise = Promise(path)
        self._begun.callback(promise.drop)
        return promise


def described(path: str, frames: int, fps: int) -> Output:
    """What an output turned out to be, read back from where it stands."""
    kind = kind_of(path) or ""
    # As when it was promised: "new/../film.gif" is a place though there is no folder "new".
    target = Path(os.path.realpath(path))
    files = sorted(target.iterdir()) if target.is_dir() else [target]
    hashes = [_hash(file) for file in files]
    lines = "".join(f"{f.name} {h}\n" for f, h in zip(files, hashes, strict=True))
    folder = hashlib.sha256(lines.encode()).hexdigest()
    return Output(
        path=path,
        kind=kind,
        size=sum(file.stat().st_size for file in files),
        sha256=folder if target.is_dir() else hashes[0],
        frames=None if kind in DATA else frames,
        fps=fps,
    )


def _hash(file: Path) -> str:
    """SHA-256 of a file, without holding it in memory."""
    with file.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def _seen_from(report: str, path: str) -> str:
    """A path as the report names it: from the report's own folder, so it holds wherever both go."""
    folder = os.path.dirname(os.path.realpath(report))
    seen = os.path.relpath(os.path.realpath(path), folder).replace(os.sep, "/")
    return seen + "/" * path.endswith("/")
