"""Inputs: the calls by which people act on a world between two ticks: recorded, and booked."""

from collections.abc import Callable, Iterator
from functools import wraps
from typing import Any, Protocol, TypeVar, cast

Method = TypeVar("Method", bound=Callable[..., Any])


class Recorder(Protocol):
    """Who takes note of inputs."""

    busy: bool
    """Whether an input is being carried out: what it calls itself is no input."""

    def note(self, target: Any, call: str, args: tuple[Any, ...], given: dict[str, Any]) -> None:
        """Take note that something was called, or set, on a world or one of its handles."""
        ...


def noted(method: Method) -> Method:
    """Make a method or setter of a world, or of a handle (which has a `_world`), an input.

    What raises has changed nothing and is not noted.
    """
    return _as_input(method, moves=True)


def noted_only(method: Method) -> Method:
    """The same for what changes no motion by itself: there is nothing to be booked."""
    return _as_input(method, moves=False)


def _as_input(method: Method, moves: bool) -> Method:
    @wraps(method)
    def call(target: Any, /, *args: Any, **given: Any) -> Any:
        world = getattr(target, "_world", target)
        world.store.distrust()
        if moves:
            world.store.open_books()
        recorder: Recorder | None = world.recorder
        if recorder is None or recorder.busy:
            return method(target, *args, **given)
        args = tuple(_kept(each) for each in args)
        given = {name: _kept(each) for name, each in given.items()}
        recorder.busy = True
        try:
            result = method(target, *args, **given)
        finally:
            recorder.busy = False
        recorder.note(target, method.__name__, args, given)
        return result

    call.is_input = True  # type: ignore[attr-defined]
    return cast(Method, call)


def is_input(method: Any) -> bool:
    """Whether a function was made an input."""
    return getattr(method, "is_input", False) is True


def _kept(value: Any) -> Any:
    """What can be read twice."""
    return list(value) if isinstance(value, Iterator) else value
