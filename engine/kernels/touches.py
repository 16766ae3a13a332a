"""Who touches whom in a tick, and what they give each other: notes for `World.contacts`.

A pair touches in a tick if an impact or a resting contact acts on it, or if one of the two is a
sensor and they overlap. Ticks are numbered from 2, so that 0 is long ago. Idle pairs cost nothing:
a pair says in which tick it touched last, and in which it touched before.

The impulse of a resting contact stands in `Contacts` until the next part begins; only then is it
added to that of the tick. What acts in the last part is added by who reads it (see `touching`).
"""

from engine.tables import RESTING, Tables

OVERLAP = 1e-3
"""Overlap that has to be pushed apart whatever the motion, in the same unit; points of a resting
pair whose gap is no wider touch, if they approach."""


def number_of_tick(t: Tables) -> int:
    """Number of the present tick."""
    return t.state.tick[0] + 2


def touch(t: Tables, pair: int) -> None:
    """Note that a pair touches in this tick."""
    pairs = t.pairs
    now = number_of_tick(t)
    if pairs.touched[pair] != now:
        resting = pairs.state[pair] == RESTING
        pairs.touched_before[pair] = now - 1 if resting else pairs.touched[pair]
        pairs.touched[pair] = now
        pairs.given_x[pair] = 0.0
        pairs.given_y[pair] = 0.0


def leave(t: Tables, pair: int) -> None:
    """Note that a resting pair let go, before anything acted on it in this tick."""
    now = number_of_tick(t)
    if t.pairs.touched[pair] < now - 1:
        t.pairs.touched[pair] = now - 1


def note_impact(t: Tables, pair: int, x: float, y: float, jx: float, jy: float) -> None:
    """Note an impact at (x, y) (m) that gave b an impulse (N s)."""
    pairs = t.pairs
    touch(t, pair)
    pairs.given_x[pair] += jx
    pairs.given_y[pair] += jy
    pairs.hit_x[pair] = x
    pairs.hit_y[pair] = y
    if pairs.state[pair] != RESTING and pairs.acting[pair] == 0:
        pairs.normal_x[pair] = t.touch.normal_x[0]
        pairs.normal_y[pair] = t.touch.normal_y[0]


def impulses_of(t: Tables, pair: int) -> tuple[float, float]:
    """The impulse that stands in `Contacts` for a pair, along its normal and tangent (N s)."""
    return impulses_at(t, pair, t.pairs.points[pair])


def impulses_at(t: Tables, pair: int, points: int) -> tuple[float, float]:
    """The impulse of so many points of a pair, along its normal and tangent (N s)."""
    push = 0.0
    rub = 0.0
    for row in range(2 * pair, 2 * pair + points):
        push += t.contacts.normal_impulse[row]
        rub += t.contacts.tangent_impulse[row]
    return push, rub


def collect(t: Tables, pair: int, share: float) -> None:
    """Add a share of the impulse that stands in `Contacts` to that of the tick."""
    collect_of(t, pair, t.pairs.points[pair], share)


def collect_of(t: Tables, pair: int, points: int, share: float) -> None:
    """The same of so many points."""
    pairs = t.pairs
    push, rub = impulses_at(t, pair, points)
    pairs.given_x[pair] += share * (push * pairs.normal_x[pair] - rub * pairs.normal_y[pair])
    pairs.given_y[pair] += share * (push * pairs.normal_y[pair] + rub * pairs.normal_x[pair])


def collect_last_part(t: Tables, pair: int) -> None:
    """Add what a resting pair was given in the part before, if that was in this tick."""
    if t.pairs.touched[pair] == number_of_tick(t):
        collect(t, pair, 1.0)


def take_back_all(t: Tables, held: int, share: float) -> None:
    """Take back a share of the impulses of pairs that rest, as their part was cut short: of all
    points that act, whatever impacts made of the pair since.
    """
    for k in range(held):
        pair = t.pairs.resting[k]
        touch(t, pair)
        collect_of(t, pair, t.pairs.acting[pair], -share)


def part_with(t: Tables, pair: int) -> None:
    """Keep what is known of a pair that is no longer listed, if it touched a moment ago."""
    pairs = t.pairs
    now = number_of_tick(t)
    if pairs.state[pair] == RESTING:
        leave(t, pair)
    row = t.counts.parted[0]
    if pairs.touched[pair] >= now - 1 and row < t.progress.room[0]:
        parted = t.parted
        parted.a[row] = t.bodies.id[pairs.a[pair]]
        parted.b[row] = t.bodies.id[pairs.b[pair]]
        parted.touched[row] = pairs.touched[pair]
        parted.touched_before[row] = pairs.touched_before[pair]
        parted.given_x[row] = pairs.given_x[pair]
        parted.given_y[row] = pairs.given_y[pair]
        parted.hit_x[row] = pairs.hit_x[pair]
        parted.hit_y[row] = pairs.hit_y[pair]
        parted.normal_x[row] = pairs.normal_x[pair]
        parted.normal_y[row] = pairs.normal_y[pair]
        t.counts.parted[0] = row + 1
