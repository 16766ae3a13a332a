"""A recording: how a world began, all that people did to it, and marks to check a replay by.

Kept are the inputs between ticks with their tick, the lengths of the ticks, a digest of the world
each second and, to name the tick and the body where a replay goes astray, four bytes of a hash for
each body and tick.
"""

from base64 import b64decode, b64encode
from typing import TYPE_CHECKING, Any

import numpy as np

from engine import validate
from engine.snapshot import STATE
from engine.validate import shown

if TYPE_CHECKING:
    from engine.world import World

FORMAT = 1
"""Version of the data of a recording; other versions are refused."""

KEYS = ("format", "start", "inputs", "spans", "digests", "marks", "end")
INPUT_KEYS = ("tick", "on", "call", "args", "given")

SPREAD = 0x9E3779B97F4A7C15
"""Odd number near 2^64 divided by the golden ratio: multiplying by it spreads bits (Knuth,
"The Art of Computer Programming", vol. 3, 6.4)."""


class Recording:
    """What `World.record` notes, until `stop` or to the end of a `with` block."""

    def __init__(self, start: dict[str, Any]) -> None:
        """Begin with a world as `World.to_dict` says it."""
        self.start = start
        self.inputs: list[dict[str, Any]] = []
        """What was done between ticks, in order: `tick` (how many were recorded before), `on` (a
        handle, or None: the world), `call`, `args` and `given`, all as plain data."""
        self.spans: list[list[float]] = []
        """Lengths of ticks (s), each with how many followed each other."""
        self.digests: list[dict[str, Any]] = []
        """`tick` and `digest`, once a second."""
        self.end: str | None = None
        """Digest when it was stopped."""
        self.marks: list[bytes] = []
        """For each tick, four bytes a body in the order of ids."""
        self.busy = False
        self._world: World | None = None

    def __repr__(self) -> str:
        """Say how much is on record."""
        return f"<Recording: {self.ticks} ticks, {len(self.inputs)} inputs>"

    @classmethod
    def of(cls, world: "World") -> "Recording":
        """Begin to record a world; see `World.record`."""
        if world.recorder is not None:
            raise ValueError("the world is being recorded already")
        recording = cls(world.to_dict())
        recording._world = world
        world.recorder = recording
        return recording

    def __enter__(self) -> "Recording":
        """Record until the end of the block."""
        return self

    def __exit__(self, *problem: object) -> None:
        """Stop."""
        self.stop()

    def stop(self) -> None:
        """End the recording; to stop it twice does nothing."""
        world, self._world = self._world, None
        if world is not None:
            world.recorder = None
            self.end = world.digest()

    @property
    def ticks(self) -> int:
        """How many have been recorded."""
        return len(self.marks)

    def note(self, target: Any, call: str, args: tuple[Any, ...], given: dict[str, Any]) -> None:
        """Take note of an input, just after it was carried out.

        Functions that a body calls back are left out; of what was restored, all is kept.
        """
        from engine.plain import encode  # see `store`

        if self._world is not None:
            restored = call == "restore"
            entry = {
                "tick": self.ticks,
                "on": None if target is self._world else encode(target),
                "call": call,
                "args": [self._world.to_dict() if restored else encode(a) for a in args],
                "given": {k: encode(v) for k, v in given.items() if not k.startswith("on_")},
            }
            self.inputs.append(entry)

    def end_tick(self, world: "World", dt: float) -> None:
        """Take note of a tick that is over (s)."""
        if self.spans and self.spans[-1][0] == dt:
            self.spans[-1][1] += 1
        else:
            self.spans.append([dt, 1])
        self.marks.append(marks_of(world).tobytes())
        if int(world.time + dt / 2.0) > int(world.time - dt / 2.0):
            self.digests.append({"tick": self.ticks, "digest": world.digest()})

    def to_dict(self) -> dict[str, Any]:
        """Say it as plain data that JSON can hold."""
        return {
            "format": FORMAT,
            "start": self.start,
            "inputs": [dict(each) for each in self.inputs],
            "spans": [list(each) for each in self.spans],
            "digests": [dict(each) for each in self.digests],
            "marks": [b64encode(each).decode("ascii") for each in self.marks],
            "end": self.end,
        }

    @classmethod
    def from_dict(cls, data: dict[str, Any]) -> "Recording":
        """Take what `to_dict` said; the start and the inputs are checked when they are replayed.

        Raises:
            TypeError, ValueError: in one sentence, for data of another version or damaged data.
        """
        validate.keys(data, KEYS, "a recording")
        validate.version(data["format"], FORMAT, "a recording")
        recording = cls(data["start"])
        for each in validate.listed(data["inputs"], "the inputs of a recording"):
            validate.keys(each, INPUT_KEYS, "an input of a recording")
            validate.whole(each["tick"], "the tick of an input", 0)
            recording.inputs.append(dict(each))
        for span in validate.listed(data["spans"], "the spans of a recording"):
            dt, ticks = validate.listed(span, "a span of a recording", 2)
            dt = validate.tick(dt, "the tick of a span")
            recording.spans.append([dt, validate.whole(ticks, "the ticks of a span", 1)])
        for each in validate.listed(data["digests"], "the digests of a recording"):
            validate.keys(each, ("tick", "digest"), "a digest of a recording")
            recording.digests.append(dict(each))
        for mark in validate.listed(data["marks"], "the marks of a recording"):
            recording.marks.append(_bytes(mark))
        recording.end = data["end"]
        if len(recording.marks) != sum(ticks for _, ticks in recording.spans):
            raise ValueError(f"a recording cannot have {len(recording.marks)} marks for its ticks")
        return recording


def marks_of(world: "World") -> Any:
    """Four bytes of a hash for each body, in the order of ids, as an array of numbers."""
    count = len(world)
    mixed = np.zeros(count, np.uint64)
    for name in STATE:
        mixed ^= np.asarray(getattr(world.bodies, name))[:count].view(np.uint64)
        mixed *= np.uint64(SPREAD)
        mixed ^= mixed >> np.uint64(29)
    return (mixed >> np.uint64(32)).astype("<u4")


def _bytes(mark: Any) -> bytes:
    """Four bytes a body, from base64."""
    if not isinstance(mark, str):
        raise TypeError(f"a mark of a recording must be a string, not {shown(mark)}")
    try:
        raw = b64decode(mark.encode("ascii"), validate=True)
    except ValueError:
        raise ValueError(f"a mark of a recording must be base64, not {shown(mark)}") from None
    if len(raw) % 4:
        raise ValueError(f"a mark of a recording must have four bytes a body, not {len(raw)} bytes")
    return raw
