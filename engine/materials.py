"""Materials by their names, and what two of them are to each other."""

from typing import Any

from engine import validate
from engine.settings import AS_FRICTION
from engine.validate import shown

NOT_GIVEN = -1.0
"""A coefficient that two materials do not have of their own."""

LONGEST = 100
"""Characters of a name."""


def material_name(value: Any) -> str:
    """Check the name of a material."""
    if not isinstance(value, str):
        raise TypeError(f"material must be a name, not {shown(value)}")
    if not 0 < len(value) <= LONGEST:
        raise ValueError(f"material must have 1 to {LONGEST} characters, not {len(value)}")
    return value


def number_of(name: str) -> int:
    """The number that stands for a name in the tables: the same in all worlds, never 0."""
    import hashlib  # it loads OpenSSL, which takes a moment

    return 1 + int.from_bytes(hashlib.sha256(name.encode()).digest()[:7])


def number_or_none(name: Any) -> int:
    """The same for a name that may be None: 0."""
    return 0 if name is None else number_of(material_name(name))


def pair_row(
    a: str,
    b: str,
    restitution: float | None,
    friction: float | None,
    static_friction: float | None,
    rolling_resistance: float | None,
) -> tuple[float, ...]:
    """Check what two materials are to each other; return it as a row of `Materials`."""
    low, high = sorted((number_of(material_name(a)), number_of(material_name(b))))
    bounce = None if restitution is None else validate.fraction(restitution, "restitution")
    slides = None if friction is None else validate.not_negative(friction, "friction")
    rests = grip(static_friction, 0.0 if slides is None else slides)
    rolls = None
    if rolling_resistance is not None:
        rolls = validate.not_negative(rolling_resistance, "rolling_resistance")
    return (
        low,
        high,
        *(NOT_GIVEN if each is None else each for each in (bounce, slides, rests, rolls)),
    )


def grip(static_friction: Any, friction: float) -> float | None:
    """Check a static friction: None, or at least as large as that of what slides."""
    if static_friction is None:
        return None
    value = validate.not_negative(static_friction, "static_friction")
    if value < friction:
        raise ValueError(
            f"static_friction must be at least friction, which is {friction}, not {value}"
        )
    return value


def resistance(static_friction: Any, friction: float) -> float:
    """The same as a column of `Bodies`."""
    value = grip(static_friction, friction)
    return AS_FRICTION if value is None else value
