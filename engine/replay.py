"""A recording played again, and compared with what was recorded."""

from typing import TYPE_CHECKING, Any

import numpy as np

from engine import validate
from engine.body import Body
from engine.force_laws import law_of
from engine.forces import Push
from engine.inputs import is_input
from engine.recording import Recording, marks_of
from engine.validate import shown
from engine.world import World

if TYPE_CHECKING:
    from engine.plain import Decoder, Functions

OTHERWISE = "what bodies remember of their contacts and pushes is not what was recorded"


class Divergence(RuntimeError):
    """A replay is not what was recorded; the sentence names the first tick and the first body."""

    def __init__(self, tick: int, body: Body | None, sentence: str) -> None:
        """Say where it was found."""
        super().__init__(sentence)
        self.tick = tick
        """The first tick that ended otherwise; the first tick of a world is 1."""
        self.body = body
        """Of the replayed world, the first in the order of ids; None if bodies are not what
        differs."""


def replay(
    recording: Recording, functions: "Functions | None" = None, kernels: str = "auto"
) -> World:
    """Make the world anew, do to it what was done, and compare; return it as it is at the end.

    Functions that bodies call back are not called: what they did to the world is on record.

    Args:
        recording: what `World.record` returned.
        functions: the Python functions in it, by name; see `World.from_dict`.
        kernels: as for a new world.

    Raises:
        Divergence: at the first tick that does not end as it was recorded.
        TypeError, ValueError, LookupError: for a start that is no saved world.
    """
    from engine.plain import Decoder  # see `store`
    from engine.saving import KINDS, by_name

    if not isinstance(recording, Recording):
        raise TypeError(f"only a Recording can be replayed, not {shown(recording)}")
    world = World.from_dict(recording.start, functions, kernels)
    decode = Decoder(KINDS, by_name(functions), lambda kind, id: _handle(world, kind, id))
    digests = {each["tick"]: each["digest"] for each in recording.digests}
    lengths = (dt for dt, ticks in recording.spans for _ in range(int(ticks)))
    waiting = list(reversed(recording.inputs))
    for tick, (dt, marks) in enumerate(zip(lengths, recording.marks, strict=True)):
        while waiting and waiting[-1]["tick"] <= tick:
            _do(world, waiting.pop(), decode, functions or {})
        world.step(dt)
        _compare(world, marks)
        if tick + 1 in digests and digests[tick + 1] != world.digest():
            raise Divergence(world.tick, None, f"{OTHERWISE} by tick {world.tick}")
    while waiting:
        _do(world, waiting.pop(), decode, functions or {})
    if recording.end is not None and recording.end != world.digest():
        raise Divergence(world.tick, None, f"{OTHERWISE} at the end")
    return world


def _do(world: World, entry: dict[str, Any], decode: "Decoder", functions: "Functions") -> None:
    """Carry out an input."""
    what = "the arguments of an input"
    args, given = validate.listed(entry["args"], what), entry["given"]
    if not isinstance(given, dict):
        raise TypeError(f"what an input was given must be a dictionary, not {shown(given)}")
    if entry["call"] == "restore":
        from engine.saving import refill

        refill(world, validate.listed(args, what, 1)[0], functions)
        return
    target = world if entry["on"] is None else decode(entry["on"])
    call = getattr(type(target), str(entry["call"]), None)
    setter = call.fset if isinstance(call, property) else None
    if not is_input(setter or call):
        raise ValueError(f"no input is called {shown(entry['call'])}")
    values = decode(args)
    named = {name: decode(value) for name, value in given.items()}
    if setter is not None:
        setattr(target, entry["call"], validate.listed(list(values), what, 1)[0])
    else:
        getattr(target, entry["call"])(*values, **named)


def _handle(world: World, kind: str, id: int) -> Any:
    """The body, push, joint or law that an input names."""
    if kind == "Body":
        return world.body(id)
    if kind == "Push":
        return Push(world, id)
    if kind == "Joint":
        return world.joint(id)
    if kind == "ActingLaw":
        return law_of(world, id)
    raise ValueError(f"no input acts on a {shown(kind)} of id {id}")


def _compare(world: World, recorded: bytes) -> None:
    """Refuse a tick that ended otherwise."""
    marks, known = marks_of(world), np.frombuffer(recorded, "<u4")
    both = min(len(marks), len(known))
    for row in np.flatnonzero(marks[:both] != known[:both]):
        body = list(world)[row]
        raise Divergence(world.tick, body, f"{body.name} ended tick {world.tick} otherwise")
    if len(marks) != len(known):
        sentence = f"after tick {world.tick} there are {len(marks)} bodies, not {len(known)}"
        raise Divergence(world.tick, None, sentence)
