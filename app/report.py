"""The report of a run: what was filmed, what collided, what was expected, and digests of it all.

It is the same on every machine, and small while it grows: collisions are kept as plain columns.
"""

import math
from array import array
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import PurePath
from typing import Any

from app.frames import Moment
from app.installation import own_version
from app.player import Check
from app.scenario.model import Caption, Expect, Marker, Scenario, Screenshot
from app.session import Cue
from engine import Collision

FORMAT = 1
"""Version of the report's own format."""


@dataclass(frozen=True, slots=True)
class Output:
    """A file, or a folder of frames, that a run wrote."""

    path: str
    """As it was asked for."""
    kind: str
    """Its suffix without the dot; `png` for a folder of frames."""
    size: int
    """In bytes."""
    sha256: str
    """Of the file; of a folder, of its lines `name sha256`, sorted by name."""
    frames: int | None = None
    """Of a film; None for data."""
    fps: int = 60

    def described(self) -> dict[str, Any]:
        """As reports and JSON lines show it."""
        row: dict[str, Any] = {
            "path": self.path,
            "kind": self.kind,
            "bytes": self.size,
            "sha256": self.sha256,
        }
        if self.frames is not None:
            row |= {"frames": self.frames, "duration": self.frames / self.fps}
        return row


class Collisions:
    """Every collision of a run, as columns of numbers: about a hundred bytes each."""

    _FIELDS = 9

    def __init__(self) -> None:
        """None yet."""
        self._numbers = array("d")
        self._bodies = array("l")
        self._names: dict[str, int] = {}

    def __len__(self) -> int:
        """How many there were."""
        return len(self._numbers) // self._FIELDS

    def add(self, hit: Collision) -> None:
        """Remember one."""
        self._bodies.extend((self._number(hit.a.name), self._number(hit.b.name)))
        self._numbers.extend(
            (hit.time, *hit.point, *hit.normal, *hit.impulse, hit.speed, hit.restitution)
        )

    def __iter__(self) -> Iterator[dict[str, Any]]:
        """Each as the report shows it, in the order they happened."""
        names = list(self._names)
        for row in range(len(self)):
            a, b = self._bodies[2 * row : 2 * row + 2]
            t, px, py, nx, ny, jx, jy, speed, restitution = self._numbers[
                self._FIELDS * row : self._FIELDS * (row + 1)
            ]
            yield {
                "t": t,
                "a": names[a],
                "b": names[b],
                "point": [px, py],
                "normal": [nx, ny],
                "impulse": [jx, jy],
                "speed": speed,
                "restitution": restitution,
            }

    def _number(self, name: str) -> int:
        return self._names.setdefault(name, len(self._names))


class Report:
    """Listens to a run, and tells about it at the end."""

    def __init__(self, scenario: Scenario) -> None:
        """For one run of `scenario`."""
        self._scenario = scenario
        self.frames = 0
        """Of the film; whoever films it says how many."""
        self._collisions = Collisions()
        self._digests: list[dict[str, Any]] = []
        self._last: Moment | None = None
        self._cues: dict[str, list[dict[str, Any]]] = {
            "captions": [],
            "markers": [],
            "screenshots": [],
        }

    def moment(self, moment: Moment) -> None:
        """Keep its collisions, and once a second a digest of its world."""
        for hit in moment.collisions:
            self._collisions.add(hit)
        if moment.world.tick % 60 == 0:
            self._digests.append({"t": moment.time, "digest": moment.world.digest()})
        self._last = moment

    def heed(self, cue: Cue, film: float, time: float) -> None:
        """Note a cue, at film time `film` and at time `time` of the world (both s)."""
        when = {"film": film, "t": time}
        match cue:
            case Caption(text=text):
                self._cues["captions"].append(when | {"text": text})
            case Marker(name=name):
                self._cues["markers"].append(when | {"name": name})
            case Screenshot(path=path):
                self._cues["screenshots"].append(when | {"path": path})
            case _:
                pass

    def document(self, checks: Sequence[Check], outputs: Sequence[Output]) -> Mapping[str, Any]:
        """Everything, ready for `app.json_text.document`.

        `fps` belongs to the film; `t` is the time of the lesson's world, `film` that of the film.
        """
        scenario = self._scenario
        duration = self.frames / scenario.fps
        expects = [check for check in checks if isinstance(check.step, Expect)]
        return self._cues | {
            "title": scenario.title,
            "alt": scenario.alt,
            "screen": scenario.screen,
            "versions": {
                "laws": own_version(),
                "report": FORMAT,
                "scenario": scenario.laws,
            },
            "seed": scenario.seed,
            "lang": scenario.lang,
            "set": dict(scenario.settings),
            "size": scenario.size,
            "fps": scenario.fps,
            "frames": self.frames,
            "duration": duration,
            "digests": self._digests,
            "digest": "" if self._last is None else self._last.world.digest(),
            "collisions": self._collisions,
            "expects": [described(check) for check in expects],
            "untils": [described(check) for check in checks if check not in expects],
            "outputs": [output.described() for output in outputs],
        }


def described(check: Check) -> dict[str, Any]:
    """A decided `expect` or `until` as the report shows it."""
    comparison = check.step.comparison
    wanted = {
        name: value
        for name in ("equals", "near", "above", "below")
        if (value := getattr(comparison, name)) is not None
    }
    if comparison.near is not None:
        wanted["tol"] = comparison.tol
    return {
        "probe": check.step.probe,
        "wanted": wanted,
        "actual": check.value if check.value is None or math.isfinite(check.value) else None,
        "passed": check.passed,
        "t": check.time,
        "file": PurePath(check.step.place.path).name,
        "line": check.step.place.line,
    }
